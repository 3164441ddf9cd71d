// SPDX-License-Identifier: MIT
// Writes the timelines of figure_one.h, for what reads such files.
//
// usage: figure_one_traces STOP_AND_WAIT.json BETTER_ORDER.json
#include "context/timeline_file.h"
#include "figure_one.h"

int main(int argc, char** argv) {
    using namespace glext_emu;
    if (argc != 3) return 2;
    const decltype(&stop_and_wait) orders[] = {stop_and_wait, better_order};
    bool is_written = true;
    for (int i = 0; i < 2; ++i) {
        SharedJsonFile file(argv[i + 1], kTimelineKind);
        {
            TimelineFile lanes(file, 1, {}, "figure 1");
            occlusion_unit::Timeline timeline(figure_one_machine(), occlusion_unit::all_effects(), &lanes);
            orders[i](timeline);
        }
        is_written = is_written && file.is_wanted();
    }
    return is_written ? 0 : 1;
}
