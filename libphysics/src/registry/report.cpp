// SPDX-License-Identifier: MIT
#include "registry/report.h"

#include "base/appendable.h"

namespace phys {

void Reporter::event(uint32_t kind, double after, const Vec3 &point, const Vec3 &normal, double speedBefore,
                     double speedAfter, uint32_t box) {
    if (!m_report) return;
    if (m_report->event_count == m_report->event_capacity) {
        ++m_report->events_lost;
        return;
    }
    m_report->events[m_report->event_count++] = {
        m_startTime + after, fromVec(point), fromVec(normal), speedBefore, speedAfter, kind, box};
}

} // namespace phys

phys_status phys_report_init(phys_report *report, size_t size) {
    if (!report || !phys::isKnownSize<phys_report>(size)) return PHYS_ERROR_ARGUMENT;
    phys::store(phys_report{}, size, report);
    return PHYS_OK;
}
