// SPDX-License-Identifier: MIT
// The device's time in one context, under --clock device: the program's commands go to a timeline. What they
// cost may not be known when they come by, since the driver counts fragments for us and has not drawn yet; so
// commands are kept, and worked off when somebody asks for a time: a poll, a read, a swap. A context is a
// machine of its own, so that what other threads do does not change its time.
#pragma once

#include <GL/gl.h>
#include <GL/glext.h>

#include <array>
#include <cstdint>
#include <deque>
#include <memory>
#include <unordered_map>
#include <vector>

#include "context/draw_windows.h"
#include "occlusion_unit/result_times.h"
#include "occlusion_unit/timeline.h"

namespace glext_emu {

struct Context;

// Under --dry nothing is rasterised: a program that asks for what was, by <command>, is told so in a sentence
// and ends with status 2, since no answer would be true.
void need_pixels(const char* command);

class DeviceTime final : public occlusion_unit::ResultTimes {
  public:
    using Tick = occlusion_unit::Tick;

    explicit DeviceTime(Context& ctx);
    // Once the driver can be asked what it has.
    void initialise(bool has_statistics);

    // What the program does.
    void begin_query();
    void draw(std::uint64_t triangles, bool is_known, VertexSource source);
    // A draw of a query that the layer makes several times: it counts between count() and stop_counting().
    void draw_apart(std::uint64_t triangles, bool is_known, VertexSource source);
    void count() { windows_.count(); }
    void stop_counting() { windows_.stop_counting(); }
    void clear(std::uint64_t pixels, std::uint32_t samples);
    void read_back(std::uint64_t pixels);
    void copy_to_buffer(std::uint64_t pixels);
    // The query that ends next asks about <count> shapes, or about regions of <pixels> pixels.
    void ask_about_shapes(std::uint64_t count);
    void ask_about_regions(std::uint64_t count, std::uint64_t pixels);
    // Draws that follow depend on a result, for which the GPU waits.
    void wait_on_gpu(Tick ticket);
    // True where the result of <ticket> is there when the GPU comes to what follows.
    bool poll_on_gpu(Tick ticket);
    void work(std::uint64_t nanoseconds);
    void finish();
    void swap(std::uint64_t pixels);
    // The GPU's time when all before it is done: a ticket, and what it stands for once it has come.
    Tick stamp();
    std::uint64_t stamped_ns(Tick ticket);
    // The same where nobody will ask for the time, only whether it has come.
    Tick mark();
    void forget_stamp(Tick ticket) { stamps_.erase(ticket); }
    // The CPU's time.
    std::uint64_t now_ns();

    Tick end_query() override;
    Tick last_ticket() const override { return last_ticket_; }
    bool poll(Tick ticket) override;
    bool has_come(Tick ticket) override;
    void wait_for(Tick ticket) override;
    bool wait_for(Tick ticket, std::uint64_t most_ns) override;

    // Ends the driver's counting for now; the next draw begins it again.
    void pause();
    // Works off everything that is kept; the context is current.
    void settle();
    // The program begins, or has ended, a query of its own on <target>.
    void leave_to_program(GLenum target, bool is_programs);

    WorkCounters& counters() { return windows_.counters(); }
    // The context is at its end, in the midst of a frame.
    void end_unfinished_frame() { last_frame_ = timeline_.frame_sums(); }
    // Of the last frame that ended; of everything.
    const occlusion_unit::TimeSums& last_frame() const { return last_frame_; }
    occlusion_unit::TimeSums totals() const { return timeline_.total_sums(); }

  private:
    enum class Kind : std::uint8_t {
        kDraws,
        kQuery,
        kUnfinishedQuery,
        kRegions,
        kClear,
        kCopy,
        kCondition,
        kWork,
        kStamp,
    };
    struct Command {
        Kind kind = Kind::kDraws;
        std::uint64_t count = 0;   // shapes, regions, samples
        std::uint64_t amount = 0;  // pixels, nanoseconds, a ticket
        std::vector<WorkWindow> windows = {};
    };

    void keep(Command command);
    void keep_draws(WorkWindow window);
    // Before a time that is asked for in the midst of a query: what it has drawn so far.
    void keep_unfinished_query();
    void execute(Command& command);
    void execute_draws(const WorkWindow& window);
    occlusion_unit::Fragments execute_windows(std::vector<WorkWindow>& windows, std::uint64_t shapes);
    void execute_unfinished_query(std::vector<WorkWindow>& windows);
    void execute_query(std::vector<WorkWindow>& windows, std::uint64_t shapes);
    occlusion_unit::ResultTime time_of(Tick ticket) const;
    void drop_seen();

    Context& ctx_;
    const occlusion_unit::Profile& profile_;
    std::unique_ptr<occlusion_unit::TimelineListener> file_;  // null: no timeline is written
    occlusion_unit::Timeline timeline_;
    DrawWindows windows_;
    std::vector<WorkWindow> query_windows_;  // of the query that is active
    std::uint64_t shapes_ = 1;
    std::uint64_t regions_ = 0;
    std::uint64_t region_pixels_ = 0;
    std::vector<Command> kept_;

    Tick last_ticket_ = 0;
    Tick first_result_ = 1;  // the ticket of results_.front()
    std::deque<occlusion_unit::ResultTime> results_;
    std::unordered_map<Tick, occlusion_unit::Picoseconds> stamps_;
    occlusion_unit::TimeSums last_frame_;
};

}  // namespace glext_emu
