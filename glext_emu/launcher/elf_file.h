// SPDX-License-Identifier: MIT
// What a program's file tells about how it can be reached.
#pragma once

#include <string>
#include <vector>

namespace glext_emu::launcher {

struct ElfFile {
    bool is_elf = false;  // scripts are not
    bool is_64_bit = false;
    bool has_interpreter = false;     // false: statically linked, the preload never happens
    std::vector<std::string> needed;  // libraries it links directly
};

// Reads <path>; a file that is damaged or not ELF gives what could be read of it.
ElfFile read_elf(const std::string& path);

}  // namespace glext_emu::launcher
