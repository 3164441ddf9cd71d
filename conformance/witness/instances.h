// SPDX-License-Identifier: MIT
// Which seeds which machine plays: four machines share 2,000 scenes, and play 50 of their 500 in short.
//
// A machine plays its part by --gtest_filter='PART/*', and the rest of it by 'DISABLED_PARTLong/*' with
// --gtest_also_run_disabled_tests. Every seed can be played on any machine.
#pragma once

#include <gtest/gtest.h>

#include <string>

namespace conformance {

inline constexpr int kScenesOfMachine = 500;
inline constexpr int kShortScenes = 50;

inline std::string seed_name(const ::testing::TestParamInfo<int>& info) {
    return std::to_string(info.param);
}

// The parts of machine <number>: its first <few> seeds of <many>, and the rest.
#define PLAY_PART(suite, part, number, few, many)                                                         \
    INSTANTIATE_TEST_SUITE_P(part, suite, ::testing::Range((number) * (many), (number) * (many) + (few)), \
                             seed_name);                                                                  \
    INSTANTIATE_TEST_SUITE_P(DISABLED_##part##Long, suite,                                                \
                             ::testing::Range((number) * (many) + (few), ((number) + 1) * (many)),        \
                             seed_name)

#define PLAY_ON_FOUR_MACHINES(suite, few, many)     \
    PLAY_PART(suite, EglLlvmpipe, 0, few, many);    \
    PLAY_PART(suite, EglSoftpipe, 1, few, many);    \
    PLAY_PART(suite, OsmesaLlvmpipe, 2, few, many); \
    PLAY_PART(suite, OsmesaSoftpipe, 3, few, many)

}  // namespace conformance
