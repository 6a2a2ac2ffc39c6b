// SPDX-License-Identifier: MIT
// A batch with its arrays, its results, and the same by phys_step in a loop.
#pragma once

#include "support/handles.h"
#include "support/scene_builder.h"
#include "support/stepper_rows.h"

#include <QByteArray>

#include <algorithm>
#include <cstring>
#include <functional>
#include <vector>

namespace batch_case {

/// A room with an inner wall and no wall on its right, where balls leave it.
inline support::ScenePtr openRoom() {
    return support::SceneBuilder()
        .ball(0.0625)
        .floor(0, 0, 4, 2)
        .wall(-0.25, -0.25, 4, 0)
        .wall(-0.25, 2, 4, 2.25)
        .wall(-0.25, 0, 0, 2)
        .wall(1.5, 0.75, 1.75, 1.25)
        .start(0.5, 0.5)
        .build();
}

/// A batch and the arrays that it points to, with `padding` bytes between elements.
struct Case {
    uint64_t balls, steps;
    double dt;
    uint32_t stopFlags;
    bool ownParams, hasGravity, gravityPerBall, gravityPerStep, hasPath, hasTally;
    size_t padding;
    uint64_t every;
    std::vector<phys_params> params;
    std::vector<phys_vec3> gravity; // of ball b and step s: [b * steps + s]
    std::vector<phys_state> starts;

    const phys_params &paramsOf(uint64_t ball) const { return params[ownParams ? ball : 0]; }
    const phys_vec3 &gravityOf(uint64_t ball, uint64_t step) const {
        return gravity[(gravityPerBall ? ball * steps : 0) + (gravityPerStep ? step : 0)];
    }
};

struct Results {
    std::vector<phys_state> states, path;
    std::vector<uint64_t> done;
    std::vector<phys_status> statuses;
    std::vector<uint64_t> impacts; ///< if requested
    std::vector<double> energyLost;

    bool operator==(const Results &other) const {
        const auto same = [](const std::vector<phys_state> &a, const std::vector<phys_state> &b) {
            return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof a[0]) == 0);
        };
        return same(states, other.states) && same(path, other.path) && done == other.done &&
               statuses == other.statuses && impacts == other.impacts && energyLost == other.energyLost;
    }
};

inline uint64_t pathLength(const Case &given) { return given.hasPath ? given.steps / given.every : 0; }

/// Initial values of the tallies, to which the batch adds.
inline constexpr uint64_t kImpactsBefore = 3;
inline constexpr double kEnergyBefore = 0.25; // J/kg

inline uint64_t impactsIn(const phys_report &report) {
    const auto isImpact = [](const phys_event &event) { return event.kind == PHYS_EVENT_IMPACT; };
    return report.events_lost +
           static_cast<uint64_t>(std::count_if(report.events, report.events + report.event_count, isImpact));
}

inline Results stepOneByOne(phys_stepper *stepper, const Case &given) {
    Results results;
    std::vector<phys_event> events(64);
    phys_report report;
    phys_report_init(&report, sizeof report);
    report.events = events.data();
    report.event_capacity = static_cast<uint32_t>(events.size());
    for (uint64_t ball = 0; ball < given.balls; ++ball) {
        phys_state state = given.starts[ball];
        phys_params params = given.paramsOf(ball);
        phys_status status = PHYS_OK;
        uint64_t done = 0, impacts = kImpactsBefore;
        double energyLost = kEnergyBefore;
        std::vector<phys_state> path;
        while (done < given.steps && !(state.flags & given.stopFlags)) {
            if (given.hasGravity) params.gravity = given.gravityOf(ball, done);
            status = phys_step(stepper, &params, given.dt, &state, &state, given.hasTally ? &report : nullptr, nullptr);
            if (status) break;
            ++done;
            impacts += impactsIn(report);
            energyLost += report.lost_impact + report.lost_rolling + report.lost_slip;
            if (given.hasPath && done % given.every == 0) path.push_back(state);
        }
        path.resize(pathLength(given), state);
        results.states.push_back(state);
        results.path.insert(results.path.end(), path.begin(), path.end());
        results.done.push_back(done);
        results.statuses.push_back(status);
        if (!given.hasTally) continue;
        results.impacts.push_back(impacts);
        results.energyLost.push_back(energyLost);
    }
    return results;
}

/// Elements with padding between them.
template<class T>
class Strided {
public:
    Strided(const std::vector<T> &elements, size_t padding)
        : m_count(elements.size())
        , m_stride(sizeof(T) + padding)
        , m_bytes(m_stride * elements.size() + 1) {
        for (size_t i = 0; i < m_count; ++i) std::memcpy(m_bytes.data() + i * m_stride, &elements[i], sizeof(T));
    }
    T *data() { return reinterpret_cast<T *>(m_bytes.data()); }
    size_t stride() const { return m_stride; }
    std::vector<T> elements() const {
        std::vector<T> all(m_count);
        for (size_t i = 0; i < m_count; ++i) std::memcpy(&all[i], m_bytes.data() + i * m_stride, sizeof(T));
        return all;
    }

private:
    size_t m_count, m_stride;
    std::vector<unsigned char> m_bytes;
};

/// run(batch): calls phys_batch_run as often as it likes.
inline Results runBatch(const Case &given, const std::function<phys_status(phys_batch &)> &run,
                        phys_status *returned = nullptr) {
    Results results;
    Strided<phys_state> states(given.starts, given.padding);
    Strided<phys_params> params(given.params, given.padding);
    results.path.resize(given.balls * pathLength(given));
    results.done.resize(given.balls);
    results.statuses.resize(given.balls, 77);
    if (given.hasTally) {
        results.impacts.resize(given.balls, kImpactsBefore);
        results.energyLost.resize(given.balls, kEnergyBefore);
    }
    phys_batch batch;
    phys_batch_init(&batch, sizeof batch);
    batch.stop_flags = given.stopFlags;
    batch.ball_count = given.balls;
    batch.step_count = given.steps;
    batch.dt = given.dt;
    batch.params = params.data();
    batch.params_stride = given.ownParams ? params.stride() : 0;
    batch.gravity = given.hasGravity ? given.gravity.data() : nullptr;
    batch.gravity_ball_stride = given.gravityPerBall ? given.steps * sizeof(phys_vec3) : 0;
    batch.gravity_step_stride = given.gravityPerStep ? sizeof(phys_vec3) : 0;
    batch.states = states.data();
    batch.states_stride = states.stride();
    batch.path = results.path.empty() ? nullptr : results.path.data();
    batch.path_ball_stride = pathLength(given) * sizeof(phys_state);
    batch.path_every = given.every;
    batch.steps_done = results.done.data();
    batch.statuses = results.statuses.data();
    batch.impacts = given.hasTally ? results.impacts.data() : nullptr;
    batch.energy_lost = given.hasTally ? results.energyLost.data() : nullptr;
    const phys_status status = run(batch);
    if (returned) *returned = status;
    results.states = states.elements();
    return results;
}

/// The greatest step_count.
inline constexpr uint64_t kMostSteps = uint64_t{1} << 53;

inline support::StepperPtr stepperOf(const QByteArray &id, const phys_scene *scene,
                                     const phys_registry *registry = nullptr) {
    phys_stepper *stepper = nullptr;
    phys_stepper_create(registry, id, scene, &stepper, nullptr);
    return support::StepperPtr(stepper);
}

/// Two balls that roll, with nothing wrong.
inline Case plainCase(uint64_t balls = 2, uint64_t steps = 10) {
    Case made{};
    made.balls = balls;
    made.steps = steps;
    made.dt = 0.01;
    made.every = 1;
    phys_params params;
    phys_params_init(&params, sizeof params);
    params.gravity = {1.0, 0.5, -9.75};
    made.params.assign(balls, params);
    phys_state state{};
    state.position = {0.5, 0.5, 0.0625};
    state.orientation[3] = 1.0;
    made.starts.assign(balls, state);
    return made;
}

} // namespace batch_case
