// SPDX-License-Identifier: MIT
// Runs the tests of one extension: PROGRAM [--platform egl|glx] [--require EXTENSION] [GoogleTest's own
// options].
//
// Exit status: 0 all that ran passed, 1 something failed, 2 bad use, 77 every test was skipped. --require
// says that the extension must be there: then a machine that does not advertise it fails instead of being
// skipped.
#include <gtest/gtest.h>

#include <cstdio>
#include <string>

#include "harness/gl_test.h"

namespace {

constexpr int kExitBadUse = 2;
constexpr int kExitSkipped = 77;  // what ctest and Automake take for a skip

bool advertises(const std::string& extension) {
    const conformance::Surface surface;
    const conformance::Context context;
    const bool found =
        surface && context && context.make_current(surface) && conformance::has_extension(extension);
    conformance::Context::release_current();
    return found;
}

int run_tests() {
    if (RUN_ALL_TESTS() != 0) return 1;
    const auto& tests = *::testing::UnitTest::GetInstance();
    return tests.successful_test_count() == 0 ? kExitSkipped : 0;
}

}  // namespace

int main(int argc, char** argv) {
    ::testing::InitGoogleTest(&argc, argv);
    std::string platform_name = "egl";
    std::string required;
    for (int i = 1; i < argc; i += 2) {
        const std::string option = argv[i];
        if ((option != "--platform" && option != "--require") || i + 1 == argc) {
            std::fprintf(stderr, "%s: expected --platform egl|glx or --require EXTENSION, not %s\n", argv[0],
                         argv[i]);
            return kExitBadUse;
        }
        (option == "--platform" ? platform_name : required) = argv[i + 1];
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
