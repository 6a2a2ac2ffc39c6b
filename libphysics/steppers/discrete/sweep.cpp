// SPDX-License-Identifier: MIT
#include "sweep.h"

#include <cmath>
#include <limits>

namespace phys {

namespace {

/// Speeds along a normal below this share of the speed are rounding: model.md 5.5.
constexpr double kNoSpeed = 1e-14;

/// Bounces that rise less than this share of the radius end in contact: model.md 6.4. Far below the scheme's error.
constexpr double kNoBounce = 1e-9;

/// Advancement converges quadratically, or halves the gap when grazing: model.md 5.2.
constexpr int kMostAdvances = 200;

constexpr uint32_t kMostPasses = 64;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Bound of the acceleration in any phase of this step: model.md 5.2.
double mostAcceleration(const phys_params &params, bool supported) {
    const Vec3 gravity = toVec(params.gravity);
    if (!supported) return glm::length(gravity);
    const double friction = std::max(params.rolling_friction, params.sliding_friction);
    return glm::length(inPlane(gravity)) + friction * -gravity.z;
}

/// Time for which a gap that changes at `rate` can't close: model.md 5.2.
double safeTime(double gap, double rate, double acceleration) {
    if (gap == 0.0) return acceleration > 0.0 ? 2.0 * rate / acceleration : kInfinity;
    const double divisor = -rate + std::sqrt(rate * rate + 2.0 * acceleration * gap);
    return divisor > 0.0 ? 2.0 * gap / divisor : kInfinity;
}

double size(const Vec3 &v) { return std::abs(v.x) + std::abs(v.y) + std::abs(v.z); }

} // namespace

Sweep::Sweep(const PlanInput &input, Reporter &reporter, const StepPlan &plan, const Ball &start)
    : m_context{input.scene,
                input.params,
                reporter,
                plan.bounce,
                input.params.model == PHYS_MODEL_RIGID,
                plan.runs(PHYS_STAGE_GRID),
                input.dt}
    , m_input(input)
    , m_plan(plan)
    , m_ball(start)
    , m_around(lookAround(m_context, start.position))
    , m_mostAcceleration(mostAcceleration(input.params, false)) {}

bool Sweep::leaveOverlaps() {
    const Ball before = m_ball;
    return resolveOverlaps(m_context, before, m_drive, m_done, m_ball);
}

Ball Sweep::at(double t, Reporter &reporter) const {
    DiscreteStep<VelocityVerlet> step(m_input.scene, m_input.params, reporter, m_plan, t);
    Ball ball = m_ball;
    step.move(m_around, ball);
    return ball;
}

Ball Sweep::at(double t) const {
    Reporter silent(nullptr, 0.0);
    return at(t, silent);
}

template<class Predicate>
double Sweep::firstTime(double horizon, Predicate happens) const {
    double low = 0.0;
    double high = horizon;
    for (double middle = 0.5 * high; middle > low && middle < high; middle = 0.5 * (low + high)) {
        (happens(at(middle)) ? high : low) = middle;
    }
    return high;
}

bool Sweep::toNextEvent() {
    resolveImpacts();
    const bool arrived = std::abs(m_ball.position.z - m_input.scene.supportedZ) <= m_input.scene.tolerance &&
                         m_ball.velocity.z < 0.0 && m_input.scene.overFloor(m_ball.position.x, m_ball.position.y);
    if (arrived) landNow();
    beginPhase();
    const double rest = m_input.dt - m_done;
    const double horizon = endOfFaces(endOfSupport(rest));
    bool impact = false;
    const double t = timeOfImpact(horizon, impact);

    const Ball before = m_ball;
    m_ball = at(t, m_context.report);
    m_done = t == rest ? m_input.dt : m_done + t;
    const bool lands = !m_ball.supported && before.position.z >= m_input.scene.supportedZ &&
                       m_ball.position.z < m_input.scene.supportedZ &&
                       m_input.scene.overFloor(m_ball.position.x, m_ball.position.y);
    if (lands) landNow();
    if (impact) resolveImpacts();
    return m_done >= m_input.dt;
}

void Sweep::beginPhase() {
    m_around = lookAround(m_context, m_ball.position);
    Reporter silent(nullptr, 0.0);
    DiscreteStep<VelocityVerlet> step(m_input.scene, m_input.params, silent, m_plan, m_input.dt - m_done);
    Ball ball = m_ball;
    m_drive = step.move(m_around, ball);
    m_ball.supported = ball.supported;
    m_mostAcceleration = mostAcceleration(m_input.params, m_ball.supported);

    // What is touched and neither approached nor left stays out of the advancement, which it would stop: model.md 5.2.
    // A pressing force ends a rise that nobody could see.
    m_ignored.count = 0;
    m_faces.count = 0;
    const double touching = m_input.scene.radius + 2.0 * m_input.scene.tolerance;
    const double slow = 2.0 * m_mostAcceleration * kNoBounce * m_input.scene.radius;
    for (const uint32_t solid : m_around.candidates) {
        const phys_box &box = m_input.scene.solids[solid];
        if (squaredDistance(box, m_ball.position) > touching * touching) continue;
        const Nearest contact = nearest(box, m_ball.position);
        const Vec3 &normal = contact.normal;
        const double rate = glm::dot(m_ball.velocity, normal);
        if (rate > kNoSpeed * size(m_ball.velocity) && rate * rate > slow) continue;
        m_ignored.add(solid);
        if (glm::dot(m_drive, normal) >= 0.0) continue;
        if (rate > 0.0) m_ball.velocity -= rate * normal;
        if (contact.feature == PHYS_FEATURE_FACE) m_faces.add(solid);
    }
}

std::span<const uint32_t> Sweep::candidatesWithin(double horizon) {
    const Scene &scene = m_input.scene;
    if (!m_context.useGrid) return scene.allSolids;
    const double reach = (glm::length(m_ball.velocity) + 0.5 * m_mostAcceleration * horizon) * horizon;
    const Vec2 centre = inPlane(m_ball.position);
    const uint32_t count = scene.solidGrid.overlapping(centre - reach, centre + reach, m_buffer.numbers);
    if (count > kMost) return scene.allSolids;
    return {m_buffer.numbers.data(), count};
}

/// A ball rolls until its centre has left the floor, and flies until it comes down on one: model.md 2.1 R6.
double Sweep::endOfSupport(double horizon) const {
    const Scene &scene = m_input.scene;
    const Ball end = at(horizon);
    if (m_ball.supported) {
        const auto leaves = [&](const Ball &ball) {
            return !scene.overFloor(ball.position.x, ball.position.y) &&
                   !carriedBySolid(m_context, m_around, ball.position);
        };
        return leaves(end) ? firstTime(horizon, leaves) : horizon;
    }
    const bool falls = m_ball.position.z >= scene.supportedZ && end.position.z < scene.supportedZ;
    if (!falls) return horizon;
    return firstTime(horizon, [&](const Ball &ball) { return ball.position.z < scene.supportedZ; });
}

/// A face holds the ball only as far as it goes: model.md 6.1.
double Sweep::endOfFaces(double horizon) const {
    const auto leaves = [&](const Ball &ball) {
        return std::any_of(m_faces.numbers.begin(), m_faces.numbers.begin() + m_faces.count, [&](uint32_t solid) {
            return nearest(m_input.scene.solids[solid], ball.position).feature == PHYS_FEATURE_EDGE;
        });
    };
    if (m_faces.count == 0 || !leaves(at(horizon))) return horizon;
    return firstTime(horizon, leaves);
}

double Sweep::timeOfImpact(double horizon, bool &impact) {
    const auto candidates = candidatesWithin(horizon);
    double t = 0.0;
    Ball ball = m_ball;
    for (int i = 0; i < kMostAdvances; ++i) {
        const double step = safeStep(ball, i == 0, candidates, impact);
        if (impact) return t;
        if (!(t + step < horizon)) return horizon;
        t += step;
        ball = at(t);
    }
    return t;
}

double Sweep::safeStep(const Ball &ball, bool atStart, std::span<const uint32_t> candidates, bool &touches) const {
    const Scene &scene = m_input.scene;
    double step = kInfinity;
    for (const uint32_t solid : candidates) {
        if (m_ignored.has(solid)) continue;
        const Nearest contact = nearest(scene.solids[solid], ball.position);
        const double gap = contact.distance - scene.radius;
        const bool near = gap <= scene.tolerance;
        if (near && !atStart) {
            touches = true;
            return 0.0;
        }
        const double rate = glm::dot(ball.velocity, contact.normal);
        step = std::min(step, safeTime(near ? 0.0 : gap, rate, m_mostAcceleration));
    }
    return step;
}

void Sweep::landNow() {
    const double bounced = m_input.params.restitution_floor * -m_ball.velocity.z;
    land(m_context, endsInContact(bounced, -m_input.params.gravity.z) ? 0.0 : bounced, m_done, m_ball);
}

/// Bounces that nobody could see end in contact: model.md 6.4.
bool Sweep::endsInContact(double bounced, double pressing) const {
    return pressing > 0.0 && bounced * bounced <= 2.0 * pressing * kNoBounce * m_input.scene.radius;
}

/// Most negative normal speed first, lowest number among equals: model.md 5.5.
void Sweep::resolveImpacts() {
    const Scene &scene = m_input.scene;
    const double touching = scene.radius + 2.0 * scene.tolerance;
    Pressing ended;
    m_around = lookAround(m_context, m_ball.position);
    for (uint32_t pass = 1; pass <= kMostPasses; ++pass) {
        double most = -kNoSpeed * size(m_ball.velocity);
        Nearest contact{};
        uint32_t solid = PHYS_NO_BOX;
        for (const uint32_t candidate : m_around.candidates) {
            if (squaredDistance(scene.solids[candidate], m_ball.position) > touching * touching) continue;
            const Nearest other = nearest(scene.solids[candidate], m_ball.position);
            const double speed = glm::dot(m_ball.velocity, other.normal);
            if (speed >= most) continue;
            most = speed;
            contact = other;
            solid = candidate;
        }
        if (solid == PHYS_NO_BOX) break;
        m_context.report.passes(pass);

        const double bounced = restitutionOf(m_input.params, contact.normal) * -most;
        const double pressing = -glm::dot(m_drive, contact.normal);
        const bool ends = endsInContact(bounced, pressing);
        if (ends && contact.normal.z == 0.0) ended.add(inPlane(contact.normal));
        const uint32_t box = m_context.report.wanted() ? scene.givenSolid(solid, contact.point) : 0;
        bounce(m_context, contact, box, PHYS_EVENT_IMPACT, ends ? 0.0 : bounced, m_done, m_ball);
        // A rough wall lifts the ball; a hop that nobody could see is none, or hops and impacts would follow for ever.
        const bool hops = m_ball.supported && m_ball.velocity.z > 0.0;
        if (hops && endsInContact(m_ball.velocity.z, -m_input.params.gravity.z)) m_ball.velocity.z = 0.0;
        settleSupport(m_context, m_ball);
    }
    stopBetween(ended, m_ball);
}

} // namespace phys
