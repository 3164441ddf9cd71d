// SPDX-License-Identifier: MIT
#include "context/narrowing.h"

#include "context/context.h"
#include "context/settings.h"

namespace glext_emu {
namespace {

using occlusion_unit::Effect;

bool has(Effect effect) {
    return settings().effects[static_cast<std::size_t>(effect)];
}

}  // namespace

std::uint64_t narrowed_count(Context& ctx, std::uint64_t count, int bits) {
    const std::uint64_t most = occlusion_unit::largest_count(bits);
    ++ctx.narrowing.counts;
    if (count <= most) return count;
    ++ctx.narrowing.saturated;
    return has(Effect::kSaturation) ? most : count;
}

float narrowed_depth(Context& ctx, float depth, int bits, bool towards_one) {
    const float held = occlusion_unit::quantised(depth, bits, towards_one);
    ++ctx.narrowing.depths;
    if (held == depth) return depth;
    ++ctx.narrowing.quantised;
    return has(Effect::kDepthQuantisation) ? held : depth;
}

occlusion_unit::Record narrowed(Context& ctx, occlusion_unit::Record record, occlusion_unit::FarEnd far_end) {
    const Device& device = settings().device;
    const int bits = device.unit_counter_bits.value_or(64);
    const auto counts = [&](std::uint32_t a_register) { return (record.registers & a_register) != 0; };
    if (counts(occlusion_unit::kProjectedHits))
        record.projected_hits = narrowed_count(ctx, record.projected_hits, bits);
    if (counts(occlusion_unit::kVisibleHits))
        record.visible_hits = narrowed_count(ctx, record.visible_hits, bits);
    // Towards near: whoever tests against it stays conservative.
    if (counts(occlusion_unit::kNearestDepth) && device.unit_depth_bits) {
        record.nearest_depth = narrowed_depth(ctx, record.nearest_depth, *device.unit_depth_bits,
                                              far_end == occlusion_unit::FarEnd::kZero);
    }
    return record;
}

}  // namespace glext_emu
