// SPDX-License-Identifier: GPL-3.0-or-later
// The log of a run's last events, each with the step in which it happened.
#pragma once

#include "core/engine/engine.h"
#include "core/engine/slot_ring.h"
#include "core/events/bounce.h"

#include <atomic>
#include <vector>

namespace inspector {

/// A kind in addition to the library's PHYS_EVENT_*: the centre has left the bounds of all boxes.
inline constexpr uint32_t kLeftMazeEvent = 0x10000;

/// The step in which something happened.
struct StepFacts {
    phys_state before{}; ///< of the step
    phys_state after{};
    phys_params params{};
    double dt = 0.0;               ///< s
    double penetration = 0.0;      ///< deepest of the step, before it was resolved, m
    double firstEvent = 0.0;       ///< time of the step's first event, s
    uint32_t stepper = kNoStepper; ///< index in the registry
    uint32_t eventCount = 0;       ///< in this step, lost ones included
};

/// A bounce is slow below kCountedImpact. Successive slow bounces on one box are folded into one entry: the first of
/// them and a count. Repeated events without a normal speed are folded as well.
struct LoggedEvent {
    uint64_t number = 0; ///< unique; counts entries from 0
    phys_event event{};
    uint64_t count = 0;   ///< events that this entry stands for
    double until = 0.0;   ///< time of the last of them, s
    double fastest = 0.0; ///< largest speed before, of all of them, m/s
    StepFacts step;       ///< of the first

    bool isBounce() const { return inspector::isBounce(event); }
    bool isSlow() const; ///< a bounce no faster than those of a ball that leans on a wall
};

StepFacts factsOf(const Engine &engine, uint32_t stepper);

/// One thread writes while any others read (see SlotRing). The newest kReach entries may still grow as events are
/// folded into them; all others are final.
class EventLog {
public:
    static constexpr size_t kDefaultCapacity = 4096;
    static constexpr uint64_t kReach = 32;
    /// Slow bounces within this time, s, or within two steps if those are longer, are folded.
    static constexpr double kFoldTime = 0.1;

    /// capacity: rounded up to a power of two, at least 2 kReach.
    explicit EventLog(size_t capacity = kDefaultCapacity);

    /// Writer only. Logs all events of the engine's last step; stepper: index in the registry, or kNoStepper.
    void note(const Engine &engine, uint32_t stepper);
    void append(const phys_event &event, const StepFacts &step);
    void noteLost(uint64_t count);
    void clear();
    /// Removes what happened after `time`, s.
    void forgetAfter(double time);
    void hold() { m_entries.hold(); }
    void release();

    /// For readers: entries [first(), last()) can be read at this moment.
    size_t capacity() const { return m_entries.capacity(); }
    uint64_t first() const { return m_entries.first(); }
    uint64_t last() const { return m_entries.last(); }
    uint64_t dropped() const { return first() - m_entries.firstOfGeneration(); } ///< overwritten entries of this run
    uint64_t lost() const {
        return m_lost.load(std::memory_order_acquire);
    } ///< events of this run that didn't fit into a step's report
    /// Changes when readers must start over.
    uint64_t generation() const { return m_entries.generation() + m_entries.truncations(); }
    /// Changes with every change of the log.
    uint64_t revision() const { return m_revision.load(std::memory_order_acquire); }
    /// Reads entry `number`. False if it was overwritten, doesn't exist yet, or is being written; in the last case a
    /// later call succeeds.
    bool read(uint64_t number, LoggedEvent &out) const { return m_entries.read(number, out); }

private:
    bool isOneMore(const LoggedEvent &entry, const phys_event &event, double dt) const;
    LoggedEvent *entryToGrow(const phys_event &event, double dt);
    void announce();
    void show();

    SlotRing<LoggedEvent> m_entries;
    std::vector<LoggedEvent> m_newest; ///< the writer's own copies of the newest kReach
    uint64_t m_lostCount = 0;          ///< the writer's own, too
    uint64_t m_changes = 0;
    std::atomic<uint64_t> m_lost{0}; ///< as readers see it
    std::atomic<uint64_t> m_revision{0};
};

} // namespace inspector
