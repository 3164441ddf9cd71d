// SPDX-License-Identifier: MIT
// Runs the tests of one extension: PROGRAM [--platform egl|glx|osmesa] [--require EXTENSION] [GoogleTest's
// own options].
//
// Exit status: 0 all that ran passed, 1 something failed, 2 bad use, 77 every test was skipped, or there is
// no OSMesa. --require says that the extension must be there: then a machine that does not advertise it, in a
// context of whatever API, fails instead of being skipped.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <string>

#include "harness/gl_test.h"

namespace {

constexpr int kExitBadUse = 2;
constexpr int kExitSkipped = 77;  // what ctest and Automake take for a skip
constexpr std::array kPlatforms = {"egl", "glx", "osmesa"};

bool advertises(const std::string& extension) {
    using conformance::Api;
    const conformance::Surface surface;
    bool found = false;
    for (const Api api : {Api::kCompatibility, Api::kEs2}) {
        const conformance::Context context({.api = api});
        if (!surface || !context || !context.make_current(surface)) continue;
        found = found || conformance::has_extension(extension);
        conformance::Context::release_current();
    }
    return found;
}

// GoogleTest's JSON tells that a test was skipped, but not why.
class SkipReasons final : public ::testing::EmptyTestEventListener {
    void OnTestPartResult(const ::testing::TestPartResult& part) override {
        if (part.skipped()) ::testing::Test::RecordProperty("skipped", part.message());
    }
};

int run_tests() {
    ::testing::UnitTest::GetInstance()->listeners().Append(new SkipReasons);
    if (RUN_ALL_TESTS() != 0) return 1;
    const auto& tests = *::testing::UnitTest::GetInstance();
    return tests.successful_test_count() == 0 ? kExitSkipped : 0;
}

int bad_use(const char* program, const std::string& option) {
    std::fprintf(stderr, "%s: expected --platform egl|glx|osmesa or --require EXTENSION, not %s\n", program,
                 option.c_str());
    return kExitBadUse;
}

}  // namespace

int main(int argc, char** argv) {
    // GoogleTest takes its options out of argv; a process that is started anew needs them all.
    const std::vector<char*> arguments(argv, argv + argc + 1);
    ::testing::InitGoogleTest(&argc, argv);
    std::string platform_name = "egl";
    std::string required;
    for (int i = 1; i < argc; i += 2) {
        const std::string option = argv[i];
        if ((option != "--platform" && option != "--require") || i + 1 == argc)
            return bad_use(argv[0], option);
        (option == "--platform" ? platform_name : required) = argv[i + 1];
    }
    if (std::find(kPlatforms.begin(), kPlatforms.end(), platform_name) == kPlatforms.end()) {
        return bad_use(argv[0], platform_name);
    }
    if (platform_name == "osmesa" && !conformance::preload_osmesa(arguments.data())) {
        std::fprintf(stderr, "%s: no libOSMesa on this machine\n", argv[0]);
        return kExitSkipped;
    }
    if (!conformance::open_platform(platform_name)) {
        std::fprintf(stderr, "%s: no display for platform %s\n", argv[0], platform_name.c_str());
        return required.empty() ? kExitSkipped : 1;
    }
    if (!required.empty() && !advertises(required)) {
        std::fprintf(stderr, "%s: this GL does not advertise %s\n", argv[0], required.c_str());
        return 1;
    }
    const int status = run_tests();
    conformance::close_platform();
    return status;
}
