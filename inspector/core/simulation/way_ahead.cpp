// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/way_ahead.h"

#include "core/events/bounce.h"

#include <array>
#include <chrono>
#include <cmath>
#include <span>
#include <utility>

namespace inspector {

namespace {

constexpr uint32_t kEvents = 32;
constexpr double kBounceSpeed = 1e-3; ///< m/s: slower bounces aren't marked
/// In scenes where the exact stepper is slow, the path is shorter and there are fewer alternative boards.
constexpr std::chrono::milliseconds kBudget{20};
const auto kCount = uint64_t(std::lround(WayFinder::kReach / WayFinder::kInterval));
constexpr uint64_t kEnd = PHYS_OUT | PHYS_AT_REST;

using Clock = std::chrono::steady_clock;

std::optional<phys_event> firstBounce(const phys_report &report) {
    for (const phys_event &event : std::span(report.events, report.event_count))
        if (isBounce(event) && -event.speed_before > kBounceSpeed) return event;
    return std::nullopt;
}

/// A ball whose offset would put it into a wall has no path.
Way wayOn(const OtherBoard &board, const Stepper &stepper, phys_state state, std::vector<phys_state> &path) {
    state.position.x += board.offset.x;
    state.position.y += board.offset.y;
    state.position.z += board.offset.z;
    Way way{state.position};
    uint64_t done = 0;
    phys_batch batch;
    phys_batch_init(&batch, sizeof batch);
    batch.stop_flags = uint32_t(kEnd);
    batch.ball_count = 1;
    batch.step_count = path.size();
    batch.dt = WayFinder::kInterval;
    batch.params = &board.params;
    batch.states = &state;
    batch.states_stride = sizeof state;
    batch.path = path.data();
    batch.path_ball_stride = path.size() * sizeof state;
    batch.path_every = 1;
    batch.steps_done = &done;
    phys_batch_run(stepper.get(), &batch, 0, 1, nullptr);
    for (uint64_t i = 0; i < done; ++i) way.push_back(path[i].position);
    return way;
}

} // namespace

WayAhead wayAhead(const Stepper &stepper, const phys_state &state, const phys_params &params,
                  const std::vector<OtherBoard> &others) {
    const auto end = Clock::now() + kBudget;
    std::array<phys_event, kEvents> events{};
    phys_report report;
    phys_report_init(&report, sizeof report);
    report.events = events.data();
    report.event_capacity = kEvents;
    WayAhead way{{state.position}, {}, {}};
    phys_state now = state;
    for (uint64_t i = 0; i < kCount && Clock::now() < end; ++i) {
        if (phys_step(stepper.get(), &params, WayFinder::kInterval, &now, &now, &report, nullptr) != PHYS_OK) break;
        way.points.push_back(now.position);
        if (!way.bounce) way.bounce = firstBounce(report);
        if (now.flags & kEnd) break;
    }
    const auto endOfOthers = Clock::now() + kBudget;
    std::vector<phys_state> path(others.empty() ? 0 : kCount);
    for (const OtherBoard &other : others) {
        if (Clock::now() >= endOfOthers) break;
        way.others.push_back(wayOn(other, stepper, state, path));
    }
    return way;
}

WayFinder::WayFinder(Registry registry)
    : m_registry(std::move(registry))
    , m_thread([this](const std::stop_token &stop) { work(stop); }) {}

WayFinder::~WayFinder() {
    m_thread.request_stop();
    m_thread.join();
}

void WayFinder::ask(const Scene &scene, const phys_state &state, const phys_params &params,
                    const std::vector<OtherBoard> &others) {
    {
        const std::lock_guard lock(m_mutex);
        m_question = Question{scene, state, params, others};
    }
    m_wake.notify_one();
}

WayAhead WayFinder::latest() const {
    const std::lock_guard lock(m_mutex);
    return m_answer;
}

uint64_t WayFinder::answers() const {
    const std::lock_guard lock(m_mutex);
    return m_answers;
}

void WayFinder::work(const std::stop_token &stop) {
    Scene scene;
    Stepper stepper;
    while (!stop.stop_requested()) {
        std::optional<Question> question;
        {
            std::unique_lock lock(m_mutex);
            m_wake.wait(lock, stop, [this] { return m_question.has_value(); });
            question = std::exchange(m_question, std::nullopt);
        }
        if (!question) continue;
        if (question->scene != scene) {
            scene = question->scene;
            stepper = makeStepper(m_registry, "exact", scene, nullptr);
        }
        WayAhead answer = stepper ? wayAhead(stepper, question->state, question->params, question->others) : WayAhead{};
        const std::lock_guard lock(m_mutex);
        m_answer = std::move(answer);
        ++m_answers;
    }
}

} // namespace inspector
