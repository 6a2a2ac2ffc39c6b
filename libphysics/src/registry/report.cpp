// SPDX-License-Identifier: MIT
#include "registry/report.h"

#include "base/appendable.h"
#include "registry/clock.h"

namespace phys {

void Reporter::event(uint32_t kind, double after, const Vec3 &point, const Vec3 &normal, double speedBefore,
                     double speedAfter, uint32_t box) {
    if (!m_report) return;
    if (m_report->event_count == m_report->event_capacity) {
        ++m_report->events_lost;
        return;
    }
    const double time = std::min(m_start->time + after, nextTime(*m_start, m_dt));
    m_report->events[m_report->event_count++] = {time, fromVec(point), fromVec(normal), speedBefore, speedAfter, kind,
                                                 box};
}

// Copied member by member, as a processor stalls if it loads together what was just stored separately.
void handOver(const phys_report &fresh, phys_report &out) {
    out.event_capacity = fresh.event_capacity;
    out.event_count = fresh.event_count;
    out.events_lost = fresh.events_lost;
    out.substeps = fresh.substeps;
    out.substep_cap = fresh.substep_cap;
    out.passes = fresh.passes;
    out.pass_cap = fresh.pass_cap;
    out.penetration = fresh.penetration;
    out.energy_before = fresh.energy_before;
    out.energy_after = fresh.energy_after;
    out.lost_impact = fresh.lost_impact;
    out.lost_rolling = fresh.lost_rolling;
    out.lost_slip = fresh.lost_slip;
    out.energy_scheme = fresh.energy_scheme;
}

} // namespace phys

phys_status phys_report_init(phys_report *report, size_t size) {
    if (!report || !phys::isKnownSize<phys_report>(size)) return PHYS_ERROR_ARGUMENT;
    phys::store(phys_report{}, size, report);
    return PHYS_OK;
}
