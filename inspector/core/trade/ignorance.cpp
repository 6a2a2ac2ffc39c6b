// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trade/ignorance.h"

#include "core/trade/quantile.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace inspector {

namespace {

constexpr uint64_t kSeed = 1;
constexpr double kLow = 0.05;
constexpr double kHigh = 0.95;

struct Ball {
    Draw draw;
    phys_state state;
    double farthest = 0.0; // from the computed ball so far, m
    bool isRefused = false;
};

// Not into a wall: no board that was looked at starts there.
bool isFree(const phys_scene *scene, const phys_vec3 &centre) {
    std::array<phys_contact, 16> contacts;
    uint32_t count = 0;
    phys_scene_contacts(scene, &centre, 0.0, contacts.data(), uint32_t(contacts.size()), &count);
    const auto isInside = [](const phys_contact &contact) { return contact.gap < 0.0 && contact.normal.z < 0.5; };
    return std::none_of(contacts.begin(), contacts.begin() + std::min<uint32_t>(count, 16), isInside);
}

std::vector<Ball> makeBalls(const BandPlan &plan) {
    phys_state start;
    phys_scene_start(plan.scene.get(), &start);
    std::vector<Ball> balls;
    for (const Draw &draw : drawBoards(plan.unknowns, plan.inputs, plan.balls, kSeed)) {
        Ball ball{draw, start};
        ball.state.position.x += draw.startOffset.x;
        ball.state.position.y += draw.startOffset.y;
        if (!isFree(plan.scene.get(), ball.state.position)) ball.state.position = start.position;
        balls.push_back(ball);
    }
    return balls;
}

// One leg of the reference with every ball on its own board. A ball that is out stays where it left the maze.
void stepBalls(phys_stepper *stepper, const Segment &segment, const Leg &leg, std::vector<Ball> &balls) {
    for (Ball &ball : balls) {
        const Tilt &offset = ball.draw.tiltOffset;
        ball.isRefused |= phys_gravity_from_tilt(segment.tilt.x + offset.x, segment.tilt.y + offset.y,
                                                 ball.draw.gravity, &ball.draw.params.gravity) != PHYS_OK;
    }
    std::vector<phys_status> statuses(balls.size());
    phys_batch batch;
    phys_batch_init(&batch, sizeof batch);
    batch.stop_flags = PHYS_OUT;
    batch.ball_count = balls.size();
    batch.step_count = leg.steps;
    batch.dt = leg.dt;
    batch.params = &balls.front().draw.params;
    batch.params_stride = sizeof(Ball);
    batch.states = &balls.front().state;
    batch.states_stride = sizeof(Ball);
    batch.statuses = statuses.data();
    const bool hasRun = phys_batch_run(stepper, &batch, 0, balls.size(), nullptr) == PHYS_OK;
    for (size_t i = 0; i < balls.size(); ++i) balls[i].isRefused |= !hasRun || statuses[i] != PHYS_OK;
}

void append(Band &band, double time, std::vector<double> distances) {
    if (distances.empty()) return;
    std::sort(distances.begin(), distances.end());
    band.times.push_back(time);
    band.low.push_back(quantile(distances, kLow));
    band.middle.push_back(quantile(distances, 0.5));
    band.high.push_back(quantile(distances, kHigh));
}

std::vector<double> farthestOf(std::vector<Ball> &balls, const phys_state &computed, double radius) {
    std::vector<double> distances;
    for (Ball &ball : balls) {
        if (ball.isRefused) continue;
        ball.farthest = std::max(ball.farthest, distance(ball.state.position, computed.position));
        distances.push_back(ball.farthest / radius);
    }
    return distances;
}

} // namespace

double Band::middleAt(double time) const {
    if (times.empty()) return 0.0;
    const auto after = std::upper_bound(times.begin(), times.end(), time);
    if (after == times.end()) return middle.back();
    if (after == times.begin()) return middle.front();
    const auto i = size_t(after - times.begin());
    const double share = (time - times[i - 1]) / (times[i] - times[i - 1]);
    return middle[i - 1] + share * (middle[i] - middle[i - 1]);
}

std::optional<double> Band::timeUntil(double radii) const {
    const auto reached = std::find_if(middle.begin(), middle.end(), [&](double value) { return value >= radii; });
    if (reached == middle.end()) return std::nullopt;
    return times[size_t(reached - middle.begin())];
}

Band ignoranceBand(const BandPlan &plan, const TradeReference &reference, const std::stop_token &stop) {
    Band band;
    const Stepper stepper = makeStepper(plan.registry, "exact", plan.scene, nullptr);
    if (!stepper || plan.unknowns.empty() || plan.balls < 1) return band;
    const double radius = phys_scene_radius(plan.scene.get());
    std::vector<Ball> balls = makeBalls(plan);
    append(band, 0.0, farthestOf(balls, reference.states().front(), radius));
    for (size_t i = 0; i < reference.legs().size() && !stop.stop_requested(); ++i) {
        const Leg &leg = reference.legs()[i];
        stepBalls(stepper.get(), reference.segments()[leg.segment], leg, balls);
        append(band, leg.end, farthestOf(balls, reference.states()[i + 1], radius));
        if (leg.end >= plan.until) break;
    }
    band.refused = int(std::count_if(balls.begin(), balls.end(), [](const Ball &ball) { return ball.isRefused; }));
    band.balls = int(balls.size()) - band.refused;
    return band;
}

} // namespace inspector
