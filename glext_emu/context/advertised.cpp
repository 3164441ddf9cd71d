// SPDX-License-Identifier: MIT
#include "context/advertised.h"

#include <algorithm>
#include <deque>
#include <mutex>

#include "context/context.h"

namespace glext_emu {
namespace {

std::string_view string_or_empty(const GLubyte* text) {
    return text == nullptr ? "" : reinterpret_cast<const char*>(text);
}

std::vector<std::string> words_of(std::string_view text) {
    std::vector<std::string> words;
    while (!text.empty()) {
        const std::string_view word = text.substr(0, text.find(' '));
        if (!word.empty()) words.emplace_back(word);
        text.remove_prefix(std::min(text.size(), word.size() + 1));
    }
    return words;
}

std::vector<std::string> indexed_extensions(Context& ctx) {
    std::vector<std::string> names;
    GLint count = 0;
    ctx.real->glGetIntegerv(GL_NUM_EXTENSIONS, &count);
    for (GLint i = 0; i < count; ++i) {
        names.emplace_back(string_or_empty(ctx.real->glGetStringi(GL_EXTENSIONS, static_cast<GLuint>(i))));
    }
    return names;
}

// Of every desktop context under the device's clock.
constexpr const char* kDeviceTime = "GL_EMU_device_time";

// Takes out what the device hides, adds what it supplies; true where that changed anything.
bool edit(std::vector<std::string>& names, const Device& device) {
    bool has_changed = std::erase_if(names, [&](const std::string& name) { return device.hides(name); }) != 0;
    for (const std::string& name : device.emulate) {
        if (std::ranges::find(names, name) != names.end()) continue;
        names.push_back(name);
        has_changed = true;
    }
    return has_changed;
}

// "4.5 (Compatibility Profile) Mesa 22.3.6" -> "1.5 Mesa 22.3.6": profiles came with 3.2.
std::string version_string(std::string_view driver, GlVersion version) {
    constexpr std::string_view kProfile = "(Compatibility Profile) ";
    std::string rest(driver.substr(std::min(driver.size(), driver.find(' '))));
    const auto profile = rest.find(kProfile);
    if (version < GlVersion{3, 2} && profile != std::string::npos) rest.erase(profile, kProfile.size());
    return std::to_string(version.major) + "." + std::to_string(version.minor) + rest;
}

// The GLSL version that came with a GL version; below 2.0 the one of ARB_shading_language_100.
const char* shading_language(GlVersion version) {
    struct Row {
        GlVersion gl;
        const char* glsl;
    };
    static constexpr Row kRows[] = {{{4, 6}, "4.60"}, {{4, 5}, "4.50"}, {{4, 4}, "4.40"}, {{4, 3}, "4.30"},
                                    {{4, 2}, "4.20"}, {{4, 1}, "4.10"}, {{4, 0}, "4.00"}, {{3, 3}, "3.30"},
                                    {{3, 2}, "1.50"}, {{3, 1}, "1.40"}, {{3, 0}, "1.30"}, {{2, 1}, "1.20"},
                                    {{2, 0}, "1.10"}};
    for (const Row& row : kRows) {
        if (version >= row.gl) return row.glsl;
    }
    return "1.00";
}

}  // namespace

bool Advertised::has(std::string_view extension) const {
    return std::ranges::find(extensions, extension) != extensions.end();
}

const Advertised* advertise(Context& ctx, const Device& device) {
    Advertised made;
    const std::string_view driver_version = string_or_empty(ctx.real->glGetString(GL_VERSION));
    made.version = ctx.kind.version;
    made.version_string = driver_version;
    // The string and the indexed list need not have the same order: old programs look at the string's first
    // part only.
    std::vector<std::string> words;
    if (!ctx.kind.is_core_profile) words = words_of(string_or_empty(ctx.real->glGetString(GL_EXTENSIONS)));
    made.extensions = ctx.kind.version >= GlVersion{3, 0} ? indexed_extensions(ctx) : words;
    // A device speaks of compatibility contexts; core-profile and ES contexts are as the driver makes them,
    // but for what is proposed for every profile.
    if (ctx.kind.is_compatibility()) {
        if (device.gl_version && *device.gl_version < ctx.kind.version) {
            made.version_differs = true;
            made.version = *device.gl_version;
            made.version_string = version_string(driver_version, made.version);
            made.shading_language = shading_language(made.version);
        }
        made.extensions_differ = edit(made.extensions, device);
        edit(words, device);
        if (ctx.time != nullptr) words.emplace_back(kDeviceTime);
    } else if (ctx.emulates_regions || ctx.emulates_unit) {
        if (ctx.emulates_regions) made.extensions.emplace_back("GL_EMU_depth_region_query");
        if (ctx.emulates_unit) made.extensions.emplace_back("GL_EMU_occlusion_unit");
        made.extensions_differ = true;
    }
    if (ctx.time != nullptr && !ctx.kind.is_es) {
        made.extensions.emplace_back(kDeviceTime);
        made.extensions_differ = true;
    }
    for (const std::string& word : words) {
        if (!made.extension_string.empty()) made.extension_string += ' ';
        made.extension_string += word;
    }

    static std::mutex mutex;
    static auto* const all = new std::deque<Advertised>;
    const std::lock_guard lock(mutex);
    const auto same = std::ranges::find_if(*all, [&](const Advertised& other) {
        return other.version_string == made.version_string && other.extensions == made.extensions &&
               other.extension_string == made.extension_string &&
               other.extensions_differ == made.extensions_differ;
    });
    return same != all->end() ? &*same : &all->emplace_back(std::move(made));
}

}  // namespace glext_emu
