// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/track/ball_model.h"

#include "core/setup/ball_place.h"

#include <algorithm>
#include <array>

namespace inspector {

namespace {

/// One run: its state and the reports of its steps.
class RollingRun {
public:
    RollingRun(phys_stepper *stepper, const BoardParameters &board, const phys_state &state,
               std::vector<TrackBounce> *bounces)
        : m_stepper(stepper)
        , m_board(board)
        , m_params(board.params)
        , m_state(state)
        , m_bounces(bounces) {
        m_params.options &= ~uint32_t(PHYS_OPTION_ORIENTATION);
        phys_report_init(&m_report, sizeof m_report);
        m_report.events = m_events.data();
        m_report.event_capacity = uint32_t(m_events.size());
    }

    const phys_vec3 &position() const { return m_state.position; }

    void tilt(const Tilt &tilt) {
        m_isRefused |= phys_gravity_from_tilt(tilt.x + m_board.tiltOffset.x, tilt.y + m_board.tiltOffset.y,
                                              m_board.gravity, &m_params.gravity) != PHYS_OK;
    }

    bool step(double dt, double end) {
        if (m_isRefused) return false;
        phys_report *const report = m_bounces ? &m_report : nullptr;
        m_isRefused = phys_step(m_stepper, &m_params, dt, &m_state, &m_state, report, nullptr) != PHYS_OK;
        if (!m_isRefused && report) keepBounces(end);
        return !m_isRefused;
    }

private:
    /// end: time at the end of the step, s; the state's own time starts at the beginning of the segment.
    void keepBounces(double end) {
        for (uint32_t i = 0; i < m_report.event_count; ++i) {
            const phys_event &event = m_events[i];
            if (isBounce(event))
                m_bounces->push_back({end + (event.time - m_state.time), -event.speed_before, surfaceOf(event)});
        }
    }

    phys_stepper *m_stepper;
    const BoardParameters &m_board;
    phys_params m_params;
    phys_state m_state;
    std::vector<TrackBounce> *m_bounces;
    std::array<phys_event, 64> m_events;
    phys_report m_report{};
    bool m_isRefused = false;
};

} // namespace

phys_state rollingState(const phys_scene *scene, const BallStart &start) {
    phys_state state;
    phys_scene_start(scene, &state);
    state.position = freePlace(scene, {start.x, start.y, state.position.z});
    state.velocity = {start.vx, start.vy, 0.0};
    state.spin = rollingSpin(state.velocity, phys_scene_radius(scene));
    state.flags = 0;
    return state;
}

BallModel::BallModel(const Registry &registry, const Scene &scene, const Track &track, QString *error)
    : m_track(track)
    , m_scene(scene)
    , m_stepper(makeStepper(registry, "exact", scene, error))
    , m_tilts(track.tilts) {
    if (m_tilts.empty()) m_tilts.push_back({track.begin(), {}});
}

bool BallModel::run(const BoardParameters &board, const BallStart &start, size_t first, size_t last,
                    std::vector<TrackPoint> &measured, std::vector<TrackBounce> *bounces) const {
    RollingRun run(m_stepper.get(), board, rollingState(m_scene.get(), start), bounces);
    double time = m_track.points[first].time;
    // The last change that has taken effect; the first change's tilt also applies before it.
    size_t change = size_t(std::upper_bound(m_tilts.begin(), m_tilts.end(), time - board.delay,
                                            [](double now, const TiltChange &one) { return now < one.time; }) -
                           m_tilts.begin());
    if (change > 0) --change;
    run.tilt(m_tilts[change].tilt);
    measured.clear();
    bool isWhole = true;
    for (size_t i = first; i <= last; ++i) {
        const double end = m_track.points[i].time;
        for (; change + 1 < m_tilts.size() && m_tilts[change + 1].time + board.delay < end; ++change) {
            const double now = m_tilts[change + 1].time + board.delay;
            if (now > time) isWhole &= run.step(now - time, now);
            time = std::max(time, now);
            run.tilt(m_tilts[change + 1].tilt);
        }
        if (end > time) isWhole &= run.step(end - time, end);
        time = end;
        TrackPoint point{end, 0.0, 0.0};
        board.frame.toTrack(run.position().x, run.position().y, point.x, point.y);
        measured.push_back(point);
    }
    return isWhole;
}

} // namespace inspector
