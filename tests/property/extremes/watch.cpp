// SPDX-License-Identifier: MIT
#include "watch.h"

#include "support/compare.h"
#include "support/tolerance.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace extremes {

namespace {

bool isFinite(const phys_state &state) {
    const double *const first = &state.position.x;
    return std::isfinite(state.time) &&
           std::all_of(first, first + 13, [](double value) { return std::isfinite(value); });
}

double largest(const phys_vec3 &v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

} // namespace

double roundingDepth(const phys_scene *scene, const phys_state &state) {
    phys_box bounds;
    phys_scene_bounds(scene, &bounds);
    const double size = std::max({largest(bounds.min), largest(bounds.max), largest(state.position)});
    return support::rounding(32.0, size);
}

double depthOf(const phys_scene *scene, const phys_state &state) {
    std::vector<phys_contact> contacts(64);
    uint32_t count = 0;
    phys_scene_contacts(scene, &state.position, 0.0, contacts.data(), static_cast<uint32_t>(contacts.size()), &count);
    double depth = 0.0;
    for (uint32_t i = 0; i < std::min<uint32_t>(count, 64); ++i) {
        const bool isFloor = phys_scene_boxes(scene)[contacts[i].box].max.z <= 0.0;
        if (!isFloor) depth = std::max(depth, -contacts[i].gap);
    }
    return depth;
}

void Watch::inspect() {
    if (!isFinite(m_ball.state)) {
        m_problem = "a number isn't finite";
        return;
    }
    const double depth = depthOf(m_ball.scene(), m_ball.state);
    if (depth > roundingDepth(m_ball.scene(), m_ball.state))
        m_problem = "in a box, " + support::digits(depth) + " m deep";
}

bool Watch::step(uint64_t count, double dt) {
    for (uint64_t i = 0; i < count; ++i) {
        const phys_state before = m_ball.state;
        if (!m_ball.isReady() || !m_ball.step(dt)) {
            m_refusal = phys_status_name(m_ball.status());
            if (!support::sameBits(before, m_ball.state)) m_problem = "a refused step changed the state";
            return false;
        }
        inspect();
        if (!m_problem.isEmpty()) return false;
    }
    return true;
}

} // namespace extremes
