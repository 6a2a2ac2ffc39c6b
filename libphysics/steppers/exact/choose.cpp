// SPDX-License-Identifier: MIT
#include "exact/choose.h"

#include "contact/held.h"
#include "exact/build_series.h"
#include "exact/last_bounce.h"
#include "exact/search.h"

#include <cmath>

namespace phys {

namespace {

/// How a normal is composed of two others. False if it isn't in their plane, or in their line and not opposite.
bool compose(const Vec3 &normal, const Vec3 &a, const Vec3 &b, std::array<double, 2> &shares) {
    constexpr double kParallel = 4.0 * kFits; // sine of an angle
    const Vec3 line = glm::cross(a, b);
    const double square = squared(line);
    shares = {-1.0, 0.0};
    if (square <= kParallel * kParallel) return squared(normal + a) <= kParallel * kParallel;
    if (std::abs(glm::dot(normal, line)) > kParallel * std::sqrt(square)) return false;
    shares = {glm::dot(glm::cross(normal, b), line) / square, glm::dot(glm::cross(a, normal), line) / square};
    return true;
}

class Choosing {
public:
    Choosing(MovingBall &ball, Touching &touching, Choice &choice)
        : m_ball(ball)
        , m_touching(touching)
        , m_response(choice.response)
        , m_phase(choice.phase) {}

    phys_status run(Slips slips) {
        if (hasManyHops(m_ball)) stopSpinAlong();
        if (const phys_status status = respondNow(m_touching, m_ball, m_response)) return status;
        openLeft();
        balance(m_ball, m_touching, m_response);
        findFree();
        keepFixed();
        stopHeld();
        if (rest() || uniform() || alongFace() || leaning(slips)) return PHYS_OK;
        if (hardlyMoves()) {
            motion() = {Vec3(0.0), Vec3(0.0)};
            return run(slips);
        }
        if (roundEdge() || buildSeries(m_ball, m_touching, m_response, m_phase.emplace<Series>())) return PHYS_OK;
        if (const phys_status status = jam(m_touching, m_ball, m_response)) return status;
        return run(slips);
    }

private:
    uint32_t count() const { return m_touching.count(); }
    const Held &held(uint32_t i) const { return m_touching.held(i); }
    Bearing bearing(uint32_t i) const { return {i, held(i), reaction(i)}; }
    bool isFaceAt(uint32_t i) const { return m_touching.contactOf(i).isFace(); }
    Reaction &reaction(uint32_t i) const { return m_response.reactions[i]; }
    Motion &motion() const { return m_ball.motion; }

    // Before the law is asked, and what rounding leaves of its answer:

    /// After many hops: a ball that moves along the line of two rough contacts with hardly any spin about it has none,
    /// so that its slips turn round in no time instead of in dozens of series. model.md 6.4.
    void stopSpinAlong() {
        constexpr double kHardly = 1e-9; // of the speeds
        if (count() != 2 || !m_ball.setting.isRigid() || held(0).friction == 0.0 || held(1).friction == 0.0) return;
        const Vec3 line = hat(glm::cross(held(0).normal, held(1).normal));
        const double turning = glm::dot(motion().spin, line), around = m_ball.radius() * turning;
        if (std::abs(around) > kHardly * speedScale(m_ball.moment()) || !isCollinear(motion().velocity, line)) return;
        motion().spin -= turning * line;
        m_ball.report.lostSlip(0.2 * around * around);
    }

    /// The direction in which the ball moves, or starts to.
    Vec3 heading() const {
        const Vec3 &v = motion().velocity, &a = m_response.acceleration;
        if (glm::length(v) > m_ball.negligibleSpeed()) return hat(v);
        return glm::length(a) > m_response.noise ? hat(a) : Vec3(0.0);
    }

    /// Whether two other closed contacts, in whose plane its normal is, lead the ball off one that doesn't press,
    /// though its gap doesn't open at once; or whether they keep the ball from pressing it where a slip starts.
    bool isLeftBeside(uint32_t idle, uint32_t one, uint32_t two, const Vec3 &way) const {
        constexpr double kLeast = 1e-9; // of the square of the way
        std::array<double, 2> shares;
        if (!compose(held(idle).normal, held(one).normal, held(two).normal, shares)) return false;
        const bool isLocked = shares[0] <= kLeast && shares[1] <= kLeast;
        if (isLocked && reaction(idle).mode == Mode::starting) return true;
        const auto bend = [&](uint32_t i) { return squared(tangential(held(i).across * way, held(i).normal)); };
        const auto presses = [&](uint32_t i) { return reaction(i).pressure > m_response.noise; };
        double opens = bend(idle);
        if (presses(one)) opens -= shares[0] * bend(one);
        if (presses(two)) opens -= shares[1] * bend(two);
        return opens > kLeast;
    }

    /// Opens contacts that don't press: where the ball leaves the narrowest place between features that leave it one
    /// line, no gap opens at once; and where a slip starts, series would leave their pressure undetermined. model.md
    /// 14.1.
    void openLeft() {
        const Vec3 way = heading();
        uint32_t opening = 0;
        for (uint32_t idle = 0; idle < count(); ++idle) {
            if (!isClosed(m_response, idle) || reaction(idle).pressure > m_response.noise) continue;
            for (uint32_t i = 0; i < count(); ++i) {
                for (uint32_t j = 0; j <= i; ++j) {
                    if (i == idle || j == idle || !isClosed(m_response, i) || !isClosed(m_response, j)) continue;
                    opening |= (isLeftBeside(idle, i, j, way) ? 1U : 0U) << idle;
                }
            }
        }
        for (uint32_t i = 0; i < count(); ++i) {
            if (opening >> i & 1U) reaction(i) = {Mode::open, 0.0, Vec3(0.0), Vec3(0.0), reaction(i).slip};
        }
    }

    /// The axes along which the ball can move. The accelerations along the normals of a hair crack's edges may be
    /// rounding though the ball's isn't: then it rolls over one edge, and the other one, which doesn't press, opens:
    /// model.md 14.1.
    void findFree() {
        const Moment moment = m_ball.moment();
        Vec3 &a = m_response.acceleration;
        m_free = freeAxes(moment, m_touching.held(), m_response);
        if (m_free == Vec3(1.0)) return;
        if (glm::length(a - m_free * a) > moment.rounding * accelerationScale(moment)) {
            for (Reaction &each : std::span(m_response.reactions.data(), count())) {
                if (each.mode == Mode::smooth && each.pressure == 0.0) each.mode = Mode::open;
            }
            m_free = freeAxes(moment, m_touching.held(), m_response);
        }
        a *= m_free;
    }

    /// A ball that stays in place can only turn about the normals of its sticking contacts.
    void keepFixed() {
        if (motion().velocity != Vec3(0.0) || m_response.acceleration != Vec3(0.0)) return;
        Vec3 &turning = m_response.spinAcceleration;
        for (uint32_t i = 0; i < count(); ++i) {
            const Vec3 &n = held(i).normal;
            if (reaction(i).mode == Mode::sticking) turning = glm::dot(turning, n) * n;
        }
    }

    /// Whether friction at several contacts holds a ball that moves by no more than rounding.
    bool isHeldByFriction() const {
        const double R = m_ball.radius();
        const Moment moment = m_ball.moment();
        return countSticking(m_response) > 1 && isNoSlip(moment, moment.velocity) &&
               isNoSlip(moment, R * moment.spin) && glm::length(m_response.acceleration) <= m_response.noise &&
               glm::length(m_response.spinAcceleration) * R <= m_response.noise;
    }

    /// The velocity of a ball that friction or resistance holds is rounding and is removed, model.md 14.1.
    void stopHeld() {
        if (m_response.rolling != Vec3(0.0) || m_ball.isStill()) return;
        if (isHeldByFriction()) motion() = {Vec3(0.0), Vec3(0.0)};
        for (uint32_t i = 0; i < count(); ++i) {
            if (reaction(i).mode != Mode::sticking || held(i).resistance == 0.0) continue;
            if (!isNoSlip(m_ball.moment(), motion().velocity)) return;
            const Vec3 &n = held(i).normal;
            const Vec3 pivoting = glm::dot(motion().spin, n) * n;
            if (!isNoSlip(m_ball.moment(), m_ball.radius() * (motion().spin - pivoting))) continue;
            const bool isRounding =
                countSticking(m_response) > 1 && isNoSlip(m_ball.moment(), m_ball.radius() * pivoting);
            motion() = {Vec3(0.0), mayPivot(i, m_touching, m_response) && !isRounding ? pivoting : Vec3(0.0)};
        }
    }

    // The phases, the simplest first. Each is false if the ball moves otherwise:

    bool rest() {
        if (!rests(m_ball, m_response)) return false;
        if (!m_ball.setting.isRigid() && count() > 0) { // in the air the spin stays
            m_ball.report.lostSlip(spinEnergy(motion().spin, m_ball.radius()));
            motion().spin = Vec3(0.0);
        }
        m_phase = Uniform{Vec3(0.0), Vec3(0.0), motion().spin, Vec3(0.0)};
        return true;
    }

    /// Whether all accelerations are constant: the ball turns in its place, only faces press, or smooth contacts that
    /// let the ball move along an axis only, and slips and resistance keep their directions.
    bool isUniform() const {
        const Vec3 &a = m_response.acceleration, &turning = m_response.spinAcceleration;
        const bool isTurningOnly = motion().velocity == Vec3(0.0) && a == Vec3(0.0);
        for (uint32_t i = 0; i < count(); ++i) {
            const auto &[mode, pressure, force, direction, slip] = reaction(i);
            const Vec3 &n = held(i).normal, &rolling = m_response.rolling;
            const bool isStraight = isFaceAt(i) || m_free != Vec3(1.0);
            if (mode == Mode::open) continue;
            if (isStraight && pressure == 0.0) continue;          // as in the middle between two walls a ball apart
            const bool isTurned = !isTurningOnly && !isFaceAt(i); // the normal, by the motion
            if (isTurned && (mode != Mode::smooth || !isStraight)) return false;
            if (mode == Mode::slipping && !isCollinear(slip, a - m_ball.radius() * glm::cross(turning, n)))
                return false;
            if (mode == Mode::sticking && held(i).resistance > 0.0 && rolling != Vec3(0.0)) {
                const Vec3 rate = tangential(turning, n);
                const double across = glm::length(glm::cross(rolling, rate));
                if (across * m_ball.radius() > m_response.noise && !isCollinear(rolling, rate)) return false;
            }
        }
        return true;
    }

    bool uniform() {
        if (!isUniform()) return false;
        const auto &[velocity, spin] = motion();
        m_phase = Uniform{velocity, m_response.acceleration, spin, m_response.spinAcceleration};
        return true;
    }

    /// Between two walls a ball apart, the one that doesn't press.
    bool isIdleFace(uint32_t i) const {
        if (reaction(i).mode == Mode::sticking || reaction(i).pressure != 0.0 || !isFaceAt(i)) return false;
        for (uint32_t j = 0; j < count(); ++j) {
            if (isClosed(m_response, j) && held(j).normal == -held(i).normal) return true;
        }
        return false;
    }

    /// The closed contact if there is exactly one, besides idle faces opposite to it, and it is a face; otherwise
    /// kMostHeld.
    uint32_t onlyFace() const {
        uint32_t closed = kMostHeld, idle = 0;
        for (uint32_t i = 0; i < count(); ++i) {
            if (!isClosed(m_response, i)) continue;
            if (isIdleFace(i)) {
                idle |= 1U << i;
                continue;
            }
            if (closed != kMostHeld || !isFaceAt(i)) return kMostHeld;
            closed = i;
        }
        if (closed == kMostHeld || idle == 0) return closed;
        const Vec3 friction = tangential(reaction(closed).force, held(closed).normal);
        for (uint32_t i = 0; i < count(); ++i) { // friction that holds the ball off a wall turns with the slip
            const double push = std::abs(glm::dot(friction, held(i).normal));
            if ((idle >> i & 1U) && push > m_response.noise) return kMostHeld;
        }
        return closed;
    }

    /// The ball rolls against resistance or slips on a face, and no other contact presses.
    bool alongFace() {
        const uint32_t i = onlyFace();
        if (i == kMostHeld) return false;
        const Resisted::Face face{i, axisOf(m_touching.contactOf(i)), held(i).normal};
        const Moment moment = m_ball.moment();
        const double pressure = reaction(i).pressure;
        m_phase = reaction(i).mode == Mode::slipping
                      ? Resisted::slipping(moment, face, reaction(i).slip, held(i).friction * pressure)
                      : Resisted::rolling(moment, face, 5.0 / 7.0 * (held(i).resistance * pressure));
        return true;
    }

    /// The ball slips on one face, certainly leans on a smooth one or a smooth edge across it, and touches nothing
    /// else.
    bool leaning(Slips slips) {
        uint32_t onRough = kMostHeld, onSmooth = kMostHeld;
        for (uint32_t i = 0; i < count(); ++i) {
            if (!isClosed(m_response, i)) continue;
            const Mode mode = reaction(i).mode;
            uint32_t &place = mode == Mode::slipping ? onRough : onSmooth;
            if (place != kMostHeld || (mode != Mode::slipping && mode != Mode::smooth)) return false;
            place = i;
        }
        if (onRough == kMostHeld || onSmooth == kMostHeld) return false;
        const Bearing rough = bearing(onRough), smooth = bearing(onSmooth);
        if (!isFace(rough.held) || glm::dot(rough.held.across, smooth.held.across) != 0.0) return false;
        const Moment moment = m_ball.moment();
        const double least = 0.01 * rough.friction() + 1e-9 * accelerationScale(moment);
        if (!(smooth.reaction.pressure > least)) return false;
        if (slips == Slips::mayClose) {
            const std::optional<SlipEnd> closing = SlipEnd::of(moment, rough, smooth);
            if (closing) m_phase = *closing;
            if (closing) return true;
        }
        if (isFace(smooth.held)) m_phase.emplace<Slide>(moment, rough, smooth);
        return isFace(smooth.held);
    }

    /// Whether the powers of a moving ball's speeds underflow: series would have no time scale, and in the longest step
    /// it gets nowhere.
    bool hardlyMoves() const {
        constexpr double kLeast = 0x1p-400; // m/s
        const auto &[velocity, spin] = motion();
        return !m_ball.isStill() && glm::length(velocity) + m_ball.radius() * glm::length(spin) < kLeast;
    }

    /// Whether a face's friction suffices for a ball that rolls on it round an edge, whatever pushes that: of gravity
    /// it takes 2/7 at most, as R w^2 is less than 5/7 of it.
    bool carriesRound(uint32_t track) const {
        constexpr double kCertain = 0.9;
        const Held &face = held(track);
        const double gravity = glm::length(tangential(m_ball.setting.gravity(), face.normal));
        const double pressure = reaction(track).pressure, resistance = 5.0 / 7.0 * face.resistance * pressure;
        return face.isGlued || 2.0 / 7.0 * gravity + resistance < kCertain * face.friction * pressure;
    }

    /// The ball goes round one smooth edge that certainly presses, free or on a face across it that is smooth or on
    /// which it certainly rolls, and touches nothing else.
    bool roundEdge() {
        const double least = 1e-9 * accelerationScale(m_ball.moment());
        uint32_t edge = kMostHeld, track = kMostHeld;
        Vec3 across(0.0); // axes along which the features bound the boxes, each at most once
        for (uint32_t i = 0; i < count(); ++i) {
            const Mode mode = reaction(i).mode;
            const Contact &contact = m_touching.contactOf(i);
            if (!(reaction(i).pressure > least)) return false;
            if (mode != Mode::smooth && (mode != Mode::sticking || !contact.isFace())) return false;
            if (mode == Mode::sticking) track = i;
            if (!contact.isFace() && (edge != kMostHeld || contact.axes() == 3)) return false;
            if (!contact.isFace()) edge = i;
            across += held(i).across;
        }
        if (edge == kMostHeld || across != glm::min(across, Vec3(1.0))) return false;
        const Moment moment = m_ball.moment();
        if (track == kMostHeld) {
            m_phase.emplace<Pendulum>(moment, bearing(edge), count() == 1, m_ball.left);
            return true;
        }
        if (!carriesRound(track) || heading() == Vec3(0.0)) return false;
        m_phase.emplace<Pendulum>(moment, bearing(edge), bearing(track), heading(), m_ball.left);
        return true;
    }

    MovingBall &m_ball;
    Touching &m_touching;
    Response &m_response;
    Phase &m_phase;
    Vec3 m_free{1.0}; ///< freeAxes
};

} // namespace

bool isCollinear(const Vec3 &a, const Vec3 &b) {
    const auto isRounding = [](const Vec3 &across, double squares) {
        return glm::dot(across, across) <= 16.0 * kRounding * kRounding * squares;
    };
    const double squares = glm::dot(a, a) * glm::dot(b, b);
    if (squares > 1e-100 && squares < 1e100) return isRounding(glm::cross(a, b), squares);
    return isRounding(glm::cross(hat(a), hat(b)), 1.0);
}

phys_status choose(MovingBall &ball, Touching &touching, Choice &choice, Slips slips) {
    return Choosing(ball, touching, choice).run(slips);
}

} // namespace phys
