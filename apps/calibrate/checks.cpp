// SPDX-License-Identifier: MIT
// Mixes as cullers make them, that no term was fitted to: measured on GL, predicted by the model.
#include <functional>

#include "apps/calibrate/terms.h"

namespace apps {
namespace {

struct Mix {
    const char* what;
    std::function<void(Commands&)> make;
};

const Mix kMixes[] = {
    {"100 batches of 1,000 sub-pixel triangles",
     [](Commands& to) {
         for (int i = 0; i < 100; ++i) to.mesh(1000, MeshSize::kSubPixel);
     }},
    {"10 batches of 1,000 triangles of 16 pixels",
     [](Commands& to) {
         for (int i = 0; i < 10; ++i) to.mesh(1000, MeshSize::kPixels);
     }},
    {"stop and wait, 20 boxes of 24 x 24 pixels",
     [](Commands& to) {
         for (std::size_t i = 0; i < 20; ++i) {
             to.query(24);
             to.wait(i);
         }
     }},
    {"stop and wait, 20 boxes of 100 x 100 pixels, 500 triangles after each",
     [](Commands& to) {
         for (std::size_t i = 0; i < 20; ++i) {
             to.query(100);
             to.wait(i);
             to.mesh(500, MeshSize::kSubPixel);
         }
     }},
    {"20 boxes of 48 x 48 pixels asked at once, 500 triangles after each answer",
     [](Commands& to) {
         for (int i = 0; i < 20; ++i) to.query(48);
         for (std::size_t i = 0; i < 20; ++i) {
             to.wait(i);
             to.mesh(500, MeshSize::kSubPixel);
         }
     }},
    {"20 reads of 32 x 32 depths, 200 triangles before each",
     [](Commands& to) {
         for (int i = 0; i < 20; ++i) {
             to.mesh(200, MeshSize::kSubPixel);
             to.read(32);
         }
     }},
    {"a frame: a clear, 20 batches of 400 sub-pixel triangles, 4 quads of a quarter of the window",
     [](Commands& to) {
         to.clear();
         for (int i = 0; i < 20; ++i) to.mesh(400, MeshSize::kSubPixel);
         for (int i = 0; i < 4; ++i) to.quad(4);
     }},
};

}  // namespace

void check_mixes(Bench& bench) {
    Stage& stage = bench.stage;
    std::vector<Burst> bursts;
    for (const Mix& mix : kMixes)
        bursts.push_back({0, 1, [&] { mix.make(stage); }, [&] { stage.restart(); }});
    const auto measured = bench.sampler.measure(bursts);
    bench.findings.keep("mixes", measured);
    std::size_t at = 0;
    for (const Mix& mix : kMixes) {
        Model model(bench.findings.costs, double(stage.width()) * stage.height());
        mix.make(model);
        model.finish();
        bench.findings.checks.push_back({mix.what, measured[at].median_of(&Times::total),
                                         model.microseconds(), measured[at].is_disturbed()});
        ++at;
    }
}

}  // namespace apps
