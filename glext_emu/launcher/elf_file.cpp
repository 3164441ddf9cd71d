// SPDX-License-Identifier: MIT
#include "launcher/elf_file.h"

#include <elf.h>

#include <cstring>
#include <fstream>
#include <optional>

namespace glext_emu::launcher {
namespace {

// Reads from an untrusted file: nothing outside it, nothing that is not there.
class File {
  public:
    explicit File(const std::string& path) : stream_(path, std::ios::binary) {}

    template <class T>
    std::optional<T> at(std::uint64_t offset) {
        T value;
        stream_.clear();
        if (!stream_.seekg(static_cast<std::streamoff>(offset)) ||
            !stream_.read(reinterpret_cast<char*>(&value), sizeof value)) {
            return std::nullopt;
        }
        return value;
    }

    std::string string_at(std::uint64_t offset) {
        std::string text;
        stream_.clear();
        stream_.seekg(static_cast<std::streamoff>(offset));
        for (char c = 0; text.size() < 4096 && stream_.get(c) && c != '\0';) text += c;
        return text;
    }

  private:
    std::ifstream stream_;
};

constexpr std::uint64_t kMostEntries = 1 << 16;

}  // namespace

ElfFile read_elf(const std::string& path) {
    ElfFile result;
    File file(path);
    const auto header = file.at<Elf64_Ehdr>(0);
    if (!header || std::memcmp(header->e_ident, ELFMAG, SELFMAG) != 0) return result;
    result.is_elf = true;
    result.is_64_bit = header->e_ident[EI_CLASS] == ELFCLASS64;
    if (!result.is_64_bit) return result;

    // The dynamic section speaks in addresses; the loaded segments say where those lie in the file.
    std::vector<Elf64_Phdr> loads;
    std::optional<Elf64_Phdr> dynamic;
    for (std::uint64_t i = 0; i < header->e_phnum; ++i) {
        const auto segment = file.at<Elf64_Phdr>(header->e_phoff + i * sizeof(Elf64_Phdr));
        if (!segment) return result;
        if (segment->p_type == PT_INTERP) result.has_interpreter = true;
        if (segment->p_type == PT_LOAD) loads.push_back(*segment);
        if (segment->p_type == PT_DYNAMIC) dynamic = segment;
    }
    if (!dynamic) return result;

    std::uint64_t strings_address = 0;
    std::vector<std::uint64_t> needed;
    for (std::uint64_t i = 0; i < kMostEntries; ++i) {
        const auto entry = file.at<Elf64_Dyn>(dynamic->p_offset + i * sizeof(Elf64_Dyn));
        if (!entry || entry->d_tag == DT_NULL) break;
        if (entry->d_tag == DT_STRTAB) strings_address = entry->d_un.d_ptr;
        if (entry->d_tag == DT_NEEDED) needed.push_back(entry->d_un.d_val);
    }
    for (const Elf64_Phdr& load : loads) {
        if (strings_address < load.p_vaddr || strings_address - load.p_vaddr >= load.p_filesz) continue;
        const std::uint64_t strings = strings_address - load.p_vaddr + load.p_offset;
        for (const std::uint64_t offset : needed) result.needed.push_back(file.string_at(strings + offset));
        break;
    }
    return result;
}

}  // namespace glext_emu::launcher
