// SPDX-License-Identifier: MIT
#include "context/effect_tallies.h"

#include "context/context.h"
#include "context/settings.h"

namespace glext_emu {
namespace {

using occlusion_unit::Effect;
using occlusion_unit::Picoseconds;
using occlusion_unit::TimeSums;

// A time that is less than this part of the whole is not worth an effect.
constexpr Picoseconds kWorthOneIn = 100;

std::string count_of(std::uint64_t count, const char* things) {
    return std::to_string(count) + " " + things;
}

// "3.21 %", by whole numbers, since printf's decimal point is the locale's.
std::string share_of(Picoseconds part, Picoseconds whole) {
    __extension__ using Wide = __int128;
    const auto hundredths = whole == 0 ? 0 : static_cast<std::int64_t>(Wide{part} * 10'000 / whole);
    const std::string fraction = std::to_string(hundredths % 100);
    return std::to_string(hundredths / 100) + "." + (fraction.size() < 2 ? "0" : "") + fraction + " %";
}

class Judge {
  public:
    Judge(const Context& ctx, const TimeSums& sums) : ctx_(ctx), sums_(sums) {}

    EffectTally judge(Effect effect) const {
        EffectTally tally{.effect = effect,
                          .is_on = settings().effects[static_cast<std::size_t>(effect)],
                          .is_called_for = std::nullopt,
                          .reason = {},
                          .time = std::nullopt};
        fill_in(tally);
        return tally;
    }

  private:
    void fill_in(EffectTally& tally) const {
        const Narrowing& narrowing = ctx_.narrowing;
        switch (tally.effect) {
            case Effect::kLatency:
                return by_count(tally, sums_.results_asked, "results were asked for", sums_.latency);
            case Effect::kBackPressure:
                if (!tally.is_on) return was_off(tally);
                tally.is_called_for = sums_.back_pressure != 0;
                tally.time = sums_.back_pressure;
                tally.reason = *tally.is_called_for ? "the FIFO was full for " + part(sums_.back_pressure)
                                                    : "the FIFO was never full";
                return;
            case Effect::kFill:
                if (!tally.is_on) return was_off(tally);
                return by_time(tally, sums_.fill, "fragments took");
            case Effect::kDriverCopy:
                return by_count(tally, sums_.copied_triangles, "triangles lay outside video memory",
                                sums_.driver_copy);
            case Effect::kMultisampling:
                return by_count(tally, sums_.multisampled_fragments, "fragments had several samples",
                                sums_.multisampling);
            case Effect::kReadCost:
                return by_count(tally, sums_.pixels_read, "pixels were read", sums_.read_cost);
            case Effect::kStarvation:
                if (!tally.is_on) return was_off(tally);
                return by_time(tally, sums_.starvation, "the GPU had nothing to do for");
            case Effect::kSaturation:
                tally.is_called_for = narrowing.saturated != 0;
                tally.reason = count_of(narrowing.saturated, "of ") +
                               count_of(narrowing.counts, "counts did not fit their counter");
                return;
            case Effect::kDepthQuantisation:
                tally.is_called_for = narrowing.quantised != 0;
                tally.reason = count_of(narrowing.quantised, "of ") +
                               count_of(narrowing.depths, "depths did not fit their register");
                return;
        }
    }

    std::string part(Picoseconds time) const { return share_of(time, sums_.cpu) + " of the time"; }

    void was_off(EffectTally& tally) const {
        tally.reason = "it was switched off, so nothing tells what it would have taken";
    }

    void by_count(EffectTally& tally, std::uint64_t count, const char* things, Picoseconds time) const {
        tally.is_called_for = count != 0;
        tally.reason = count_of(count, things);
        if (!tally.is_on) return;
        tally.time = time;
        if (count != 0) tally.reason += ", which took " + part(time);
    }

    void by_time(EffectTally& tally, Picoseconds time, const char* what) const {
        tally.is_called_for = time > sums_.cpu / kWorthOneIn;
        tally.time = time;
        tally.reason = what + (" " + part(time));
    }

    const Context& ctx_;
    const TimeSums& sums_;
};

}  // namespace

std::vector<EffectTally> tally_effects(const Context& ctx) {
    const TimeSums sums = ctx.time->totals();
    const Judge judge(ctx, sums);
    std::vector<EffectTally> tallies;
    for (std::size_t i = 0; i < occlusion_unit::kEffectCount; ++i)
        tallies.push_back(judge.judge(static_cast<Effect>(i)));
    return tallies;
}

}  // namespace glext_emu
