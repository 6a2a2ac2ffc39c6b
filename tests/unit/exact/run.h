// SPDX-License-Identifier: MIT
// A scene with a ball under stepper "exact", through the C API. Failures are thrown as text.
#pragma once

#include "support/vector_input.h"

#include <physics/physics.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

namespace exact {

inline constexpr double kU = 2.220446049250313e-16; // a rounding step at 1

inline phys_box floorOver(double x0, double y0, double x1, double y1) { return {{x0, y0, -1.0}, {x1, y1, 0.0}}; }
inline phys_box wall(double x0, double y0, double x1, double y1) { return {{x0, y0, 0.0}, {x1, y1, 16.0}}; }
inline const phys_box kFloor = floorOver(-2, -2, 2, 2);

inline bool equal(const phys_vec3 &a, const phys_vec3 &b) { return a.x == b.x && a.y == b.y && a.z == b.z; }

using Turn = std::function<phys_vec3(const phys_vec3 &)>; ///< by right angles, or a reflection

inline phys_box turned(const phys_box &box, const Turn &turn) {
    const phys_vec3 a = turn(box.min), b = turn(box.max);
    return {{std::min(a.x, b.x), std::min(a.y, b.y), a.z}, {std::max(a.x, b.x), std::max(a.y, b.y), b.z}};
}

/// A ball in a scene whose floor lies at z = 0.
class Run {
public:
    phys_params params{};
    phys_state state{};
    std::vector<phys_event> events; ///< of the last step

    Run(const std::vector<phys_box> &boxes, double radius, phys_vec3 position, phys_vec3 velocity = {},
        const char *stepper = "exact")
        : m_buffer(4096) {
        phys_scene_desc desc;
        phys_scene_desc_init(&desc, sizeof desc);
        desc.boxes = boxes.data();
        desc.box_count = static_cast<uint32_t>(boxes.size());
        desc.radius = radius;
        desc.start = {position.x, position.y, radius};
        phys_error error{};
        check(phys_scene_create(&desc, &m_scene, &error), error);
        check(phys_stepper_create(nullptr, stepper, m_scene, &m_stepper, &error), error);
        phys_scene_start(m_scene, &state);
        state.position = position;
        state.velocity = velocity;
        phys_params_init(&params, sizeof params);
        params.rolling_friction = 0.0;
    }
    ~Run() {
        phys_stepper_destroy(m_stepper);
        phys_scene_destroy(m_scene);
    }
    Run(const Run &) = delete;
    Run &operator=(const Run &) = delete;

    /// Sets gravity and rolling friction so that the law v' = A - B hat(v) has these constants.
    void setLaw(double Ax, double Ay, double B, double normal = 9.8) {
        params.gravity = {Ax * 7.0 / 5.0, Ay * 7.0 / 5.0, -normal};
        params.rolling_friction = B * 7.0 / 5.0 / normal;
    }

    phys_status tryStep(double dt, phys_error *error = nullptr) {
        phys_report_init(&report, sizeof report);
        report.events = m_buffer.data();
        report.event_capacity = static_cast<uint32_t>(m_buffer.size());
        const phys_status status = phys_step(m_stepper, &params, dt, &state, &state, &report, error);
        events.assign(m_buffer.begin(), m_buffer.begin() + report.event_count);
        return status;
    }

    void step(double dt) {
        phys_error error{};
        check(tryStep(dt, &error), error);
    }

    phys_report report{};

    std::vector<phys_event> eventsOf(uint32_t kind) const {
        std::vector<phys_event> found;
        for (const phys_event &event : events) {
            if (event.kind == kind) found.push_back(event);
        }
        return found;
    }

private:
    phys_scene *m_scene = nullptr;
    phys_stepper *m_stepper = nullptr;
    std::vector<phys_event> m_buffer;

    static void check(phys_status status, const phys_error &error) {
        if (status) throw std::runtime_error(std::string(phys_status_name(status)) + ": " + error.text);
    }
};

/// Largest difference of the planar position and velocity from the expected ones.
inline double difference(const phys_state &state, double x, double y, double vx, double vy) {
    return std::max({std::abs(state.position.x - x), std::abs(state.position.y - y), std::abs(state.velocity.x - vx),
                     std::abs(state.velocity.y - vy)});
}

} // namespace exact
