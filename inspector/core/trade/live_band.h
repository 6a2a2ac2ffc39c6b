// SPDX-License-Identifier: GPL-3.0-or-later
// What isn't known of a board beside a run that is being played: boards are drawn, and on each "exact" rolls a ball
// under the tilts that the run has had, on a thread of its own.
#pragma once

#include "core/trade/uncertainty_band.h"

#include <condition_variable>
#include <memory>
#include <mutex>
#include <thread>

namespace inspector {

class LiveBand {
public:
    static constexpr int kBalls = 64;         // a band's middle from so many is right to a sixth
    static constexpr double kReach = 120.0;   // s: no longer than that after its start
    static constexpr double kInterval = 0.02; // s: no nearer together are its times
    static constexpr double kRest = 3.0;      // of the time computed: a quarter of a processor at most

    // From where on a band is wanted.
    struct Start {
        Scene scene;
        phys_state state; // of all balls, but for what isn't known of the start
        Unknowns unknowns;
    };
    // What happened next: so long under these inputs.
    struct Segment {
        Inputs inputs;
        double length; // s, > 0
    };

    explicit LiveBand(Registry registry);
    ~LiveBand(); // ends the thread

    // Both return at once. An earlier band is forgotten.
    void begin(Start start);
    void goOn(const std::vector<Segment> &segments);
    void end(); // no band any more
    // Waits until all that happened is computed, without rests.
    void finish();

    // As far as it is computed: the distances at each time, s of the run, from the ball of the board as it is set.
    // Another pointer: another band. Null without one.
    std::shared_ptr<const Band> latest() const;

private:
    struct Work;
    void work(const std::stop_token &stop);
    void compute(Work &work, const std::stop_token &stop);
    void publish(uint64_t number, const Band &band);

    Registry m_registry;
    mutable std::mutex m_mutex; // guards all that follows; never held while stepping
    std::condition_variable_any m_wake;
    std::condition_variable m_idle;
    std::optional<Start> m_start;
    uint64_t m_number = 0; // of the band asked for
    std::vector<Segment> m_segments;
    std::shared_ptr<const Band> m_band;
    bool m_isBusy = false;
    bool m_hurries = false;
    std::jthread m_thread; // last: ends before anything above it goes
};

} // namespace inspector
