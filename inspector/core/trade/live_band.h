// SPDX-License-Identifier: GPL-3.0-or-later
// The uncertainty band of a run that is being played: boards are sampled, and on each of them "exact" moves a ball
// under the run's tilts, on a thread of its own.
#pragma once

#include "core/trade/uncertainty_band.h"

#include <condition_variable>
#include <memory>
#include <mutex>
#include <thread>

namespace inspector {

class LiveBand {
public:
    static constexpr int kBalls = 64;         ///< gives the middle of a band to within a sixth
    static constexpr double kReach = 120.0;   ///< s after its start, where a band ends
    static constexpr double kInterval = 0.02; ///< s, minimum distance of its times
    static constexpr double kRest = 3.0;      ///< idle time per computing time: at most a quarter of a processor

    /// Where a band begins.
    struct Start {
        Scene scene;
        phys_state state; ///< of all balls, before their offsets
        Unknowns unknowns;
    };
    /// A stretch of the run under constant inputs.
    struct Segment {
        Inputs inputs;
        double length; ///< s, > 0
    };

    explicit LiveBand(Registry registry);
    ~LiveBand(); ///< ends the thread

    /// Both return immediately. begin() drops an earlier band.
    void begin(Start start);
    void goOn(const std::vector<Segment> &segments);
    void end(); ///< drops the band
    /// Waits until everything passed in is computed, without idling.
    void finish();

    /// The band computed so far: distances over time, s of the run, from the ball of the nominal board. Every update
    /// has a new pointer. Null if there is none.
    std::shared_ptr<const Band> latest() const;

private:
    struct Work;
    void work(const std::stop_token &stop);
    void compute(Work &work, const std::stop_token &stop);
    void publish(uint64_t number, const Band &band);

    Registry m_registry;
    mutable std::mutex m_mutex; ///< guards everything below; never held while stepping
    std::condition_variable_any m_wake;
    std::condition_variable m_idle;
    std::optional<Start> m_start;
    uint64_t m_number = 0; ///< of the band requested
    std::vector<Segment> m_segments;
    std::shared_ptr<const Band> m_band;
    bool m_isBusy = false;
    bool m_hurries = false;
    std::jthread m_thread; ///< last member: it is joined before the others are destroyed
};

} // namespace inspector
