// SPDX-License-Identifier: MIT
// malloc and its kin for the whole process, by glibc's own; see layer_memory.h. The layer has its C++ library
// inside itself, so its operators new and delete call from addresses of the layer's.
#include "layer_memory.h"

#include <link.h>
#include <malloc.h>

#include <atomic>
#include <cstdint>
#include <cstring>

extern "C" {
void* __libc_malloc(std::size_t size);
void* __libc_calloc(std::size_t count, std::size_t size);
void* __libc_realloc(void* block, std::size_t size);
void __libc_free(void* block);
}

namespace threads {
namespace {

std::uintptr_t first = 0;  // of the layer's addresses; the two stay once they are known
std::uintptr_t last = 0;
std::atomic<long long> bytes{0};

int note_layer(dl_phdr_info* library, std::size_t, void*) {
    if (std::strstr(library->dlpi_name, "glext_emu") == nullptr) return 0;
    for (int i = 0; i < library->dlpi_phnum; ++i) {
        const auto& segment = library->dlpi_phdr[i];
        if (segment.p_type != PT_LOAD || (segment.p_flags & PF_X) == 0) continue;
        first = library->dlpi_addr + segment.p_vaddr;
        last = first + segment.p_memsz;
    }
    return 1;
}

bool is_layers(const void* caller) {
    const auto address = reinterpret_cast<std::uintptr_t>(caller);
    return address >= first && address < last;
}

// The mark stands in the last bytes of a block, behind those that were asked for. Who gives a block back
// cannot be told by the caller's address: one function ends in a jump to the next.
constexpr std::uint64_t kMark = 0x6C61796572206F77;

char* mark_of(void* block) {
    return static_cast<char*>(block) + malloc_usable_size(block) - sizeof kMark;
}

std::uint64_t mark_for(const void* block) {
    return kMark ^ reinterpret_cast<std::uintptr_t>(block);
}

void* marked(void* block) {
    if (block == nullptr) return nullptr;
    const std::uint64_t mark = mark_for(block);
    std::memcpy(mark_of(block), &mark, sizeof mark);
    bytes += static_cast<long long>(malloc_usable_size(block));
    return block;
}

// True for a block of the layer's, which is none any more.
bool unmark(void* block) {
    if (block == nullptr) return false;
    std::uint64_t mark = 0;
    std::memcpy(&mark, mark_of(block), sizeof mark);
    if (mark != mark_for(block)) return false;
    std::memset(mark_of(block), 0, sizeof mark);
    bytes -= static_cast<long long>(malloc_usable_size(block));
    return true;
}

}  // namespace

bool watch_layer_memory() {
    if (first == 0) dl_iterate_phdr(note_layer, nullptr);
    return first != 0;
}

long long layer_bytes() {
    return bytes;
}

}  // namespace threads

extern "C" {

void* malloc(std::size_t size) {
    if (!threads::is_layers(__builtin_return_address(0))) return __libc_malloc(size);
    return threads::marked(__libc_malloc(size + sizeof threads::kMark));
}

void* calloc(std::size_t count, std::size_t size) {
    if (!threads::is_layers(__builtin_return_address(0))) return __libc_calloc(count, size);
    return threads::marked(__libc_calloc(1, count * size + sizeof threads::kMark));
}

void* realloc(void* block, std::size_t size) {
    const bool is_layers = threads::unmark(block) || threads::is_layers(__builtin_return_address(0));
    if (!is_layers) return __libc_realloc(block, size);
    return threads::marked(__libc_realloc(block, size + sizeof threads::kMark));
}

void free(void* block) {
    threads::unmark(block);
    __libc_free(block);
}

}  // extern "C"
