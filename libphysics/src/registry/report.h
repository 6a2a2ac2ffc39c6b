// SPDX-License-Identifier: MIT
// Functions with which steppers write reports. Each does nothing if the caller wants no report.
#pragma once

#include "base/vec.h"
#include "contact/impact.h"

#include <algorithm>
#include <cstdint>

namespace phys {

class Reporter {
public:
    /// Reports nothing.
    Reporter() = default;

    /// report: or nullptr. start: the state before the step of dt (s); outlives the reporter's events.
    Reporter(phys_report *report, const phys_state &start, double dt)
        : m_report(report)
        , m_start(&start)
        , m_dt(dt) {
        if (report) report->pass_cap = kMostImpactRounds; // pushing out of overlaps needs fewer passes
    }

    bool wanted() const { return m_report != nullptr; }

    /// What was reported so far: a stepper goes back to it where it only tried a motion.
    phys_report soFar() const { return m_report ? *m_report : phys_report{}; }
    void goBackTo(const phys_report &earlier) {
        if (m_report) *m_report = earlier;
    }

    /// `after` seconds into the step, but never later than the state after it, whose time is rounded otherwise. Events
    /// without a contact have zero vectors and PHYS_NO_BOX.
    void event(uint32_t kind, double after, const Vec3 &point, const Vec3 &normal, double speedBefore,
               double speedAfter, uint32_t box);

    /// Whether there is room for another event.
    bool hasRoom() const { return m_report && m_report->event_count < m_report->event_capacity; }

    /// Adds this many events for which there is no room.
    void lostEvents(double count) {
        if (!m_report) return;
        const double all = m_report->events_lost + count;
        m_report->events_lost = static_cast<uint32_t>(std::min(all, double(UINT32_MAX)));
    }

    void lostImpact(double energy) {
        if (m_report) m_report->lost_impact += energy;
    }
    void lostRolling(double energy) {
        if (m_report) m_report->lost_rolling += energy;
    }
    void lostSlip(double energy) {
        if (m_report) m_report->lost_slip += energy;
    }
    void penetration(double depth) {
        if (m_report && depth > m_report->penetration) m_report->penetration = depth;
    }
    void passes(uint32_t count) {
        if (m_report && count > m_report->passes) m_report->passes = count;
    }
    void substeps(uint32_t count, uint32_t cap) {
        if (!m_report) return;
        m_report->substeps = count;
        m_report->substep_cap = cap;
    }

private:
    phys_report *m_report = nullptr;
    const phys_state *m_start = nullptr;
    double m_dt = 0.0;
};

/// Copies what a step wrote to a fresh report to the caller. All of it is in the first version of the struct, so there
/// is room in reports of any version.
void handOver(const phys_report &fresh, phys_report &out);

} // namespace phys
