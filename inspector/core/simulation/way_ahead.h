// SPDX-License-Identifier: GPL-3.0-or-later
// Predicts the ball's path over the next seconds if nothing changes, by the exact stepper, on a thread of its own.
#pragma once

#include "core/setup/handles.h"

#include <condition_variable>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

namespace inspector {

using Way = std::vector<phys_vec3>; ///< m, at equal times, the current position first; ends where the ball leaves the
                                    ///< maze or comes to rest

struct WayAhead {
    Way points;
    std::optional<phys_event> bounce; ///< the next one
    std::vector<Way> others;          ///< on other boards
};

/// A possible board and ball position, within the bounds of what is unknown.
struct OtherBoard {
    phys_params params;
    phys_vec3 offset; ///< m, of the ball
};

class WayFinder {
public:
    static constexpr double kReach = 2.0;           ///< s
    static constexpr double kInterval = 1.0 / 60.0; ///< s, from one point to the next

    explicit WayFinder(Registry registry);
    ~WayFinder(); ///< ends the thread

    /// The latest request replaces earlier ones; returns immediately. The path ends where the exact stepper fails.
    void ask(const Scene &scene, const phys_state &state, const phys_params &params,
             const std::vector<OtherBoard> &others = {});
    /// The answer to the newest request that has been answered.
    WayAhead latest() const;
    uint64_t answers() const;

private:
    struct Question {
        Scene scene;
        phys_state state;
        phys_params params;
        std::vector<OtherBoard> others;
    };
    void work(const std::stop_token &stop);

    Registry m_registry;
    mutable std::mutex m_mutex; ///< guards the next three; never held while stepping
    std::condition_variable_any m_wake;
    std::optional<Question> m_question;
    WayAhead m_answer;
    uint64_t m_answers = 0;
    std::jthread m_thread; ///< last member: it is joined before the others are destroyed
};

/// The same on the calling thread. stepper: `exact`, made for the scene. What can't be computed within a few hundredths
/// of a second is omitted.
WayAhead wayAhead(const Stepper &stepper, const phys_state &state, const phys_params &params,
                  const std::vector<OtherBoard> &others = {});

} // namespace inspector
