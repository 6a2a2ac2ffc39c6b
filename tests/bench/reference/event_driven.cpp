// SPDX-License-Identifier: MIT
#include "reference/event_driven.h"

#include "reference/outline.h"
#include "reference/polynomial.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace bench {

namespace {

template<class Real>
struct Vector {
    Real x = 0, y = 0;
    Vector operator+(const Vector &b) const { return {x + b.x, y + b.y}; }
    Vector operator-(const Vector &b) const { return {x - b.x, y - b.y}; }
    friend Vector operator*(Real s, const Vector &a) { return {s * a.x, s * a.y}; }
    Real dot(const Vector &b) const { return x * b.x + y * b.y; }
    Real length() const { return std::sqrt(dot(*this)); }
};

// A part of the outline that the ball touches.
template<class Real>
struct Touch {
    Vector<Real> normal;
    Real curvature = 0; // curvature of the path of a centre that keeps touching it: 1/R at a corner
    const Face *face = nullptr;
    const Corner *corner = nullptr;
};

template<class Real>
class Motion {
public:
    explicit Motion(const Scene &scene)
        : m_outline(outlineOf(scene.walls))
        , m_walls(scene.walls)
        , m_radius(static_cast<Real>(scene.radius))
        , m_restitution(static_cast<Real>(scene.restitution))
        , m_position{static_cast<Real>(scene.start.position.x), static_cast<Real>(scene.start.position.y)}
        , m_velocity{static_cast<Real>(scene.start.velocity.x), static_cast<Real>(scene.start.velocity.y)} {}

    void advance(Real duration, const Vector<Real> &acceleration) {
        m_acceleration = acceleration;
        Real left = duration;
        for (int event = 0; left > 0; ++event) {
            if (event > kEventCap) throw std::runtime_error("reference: too many events");
            left -= moveToNextEvent(left);
            refuseToPenetrate();
        }
        resolveImpacts();
    }

    Ball ball() const {
        return {{static_cast<double>(m_position.x), static_cast<double>(m_position.y)},
                {static_cast<double>(m_velocity.x), static_cast<double>(m_velocity.y)}};
    }
    int impacts() const { return m_impacts; }

private:
    using V = Vector<Real>;

    static constexpr int kEventCap = 100'000;
    static constexpr Real kRounding = std::numeric_limits<Real>::epsilon();
    static constexpr Real kLength = 4096 * kRounding;   // m: smaller distances count as touching
    static constexpr Real kSpeed = 100'000 * kRounding; // m/s and m/s^2: smaller values count as zero

    // ------------------------------------------------------------------------------------------------- geometry --

    static Real along(const V &vector, int axis) { return axis == 0 ? vector.x : vector.y; }
    static Real &along(V &vector, int axis) { return axis == 0 ? vector.x : vector.y; }

    Real gap(const Face &face, const V &position) const {
        return static_cast<Real>(face.sign) * (along(position, face.axis) - static_cast<Real>(face.coordinate)) -
               m_radius;
    }
    Real gap(const Corner &corner, const V &position) const { return (position - pointOf(corner)).length() - m_radius; }
    static V pointOf(const Corner &corner) { return {static_cast<Real>(corner.x), static_cast<Real>(corner.y)}; }

    static bool isBeside(const Face &face, Real tangential, Real tolerance) {
        return tangential >= static_cast<Real>(face.low) - tolerance &&
               tangential <= static_cast<Real>(face.high) + tolerance;
    }
    static bool isBefore(const Corner &corner, const V &offset, Real tolerance) {
        return corner.signX * offset.x >= -tolerance && corner.signY * offset.y >= -tolerance;
    }

    std::vector<Touch<Real>> touches() const {
        std::vector<Touch<Real>> found;
        for (const Face &face : m_outline.faces)
            if (std::abs(gap(face, m_position)) <= kLength &&
                isBeside(face, along(m_position, 1 - face.axis), kLength)) {
                V normal;
                along(normal, face.axis) = static_cast<Real>(face.sign);
                found.push_back({normal, 0, &face, nullptr});
            }
        for (const Corner &corner : m_outline.corners) {
            const V offset = m_position - pointOf(corner);
            if (isBefore(corner, offset, kLength) && std::abs(gap(corner, m_position)) <= kLength)
                found.push_back({(1 / offset.length()) * offset, 1 / m_radius, nullptr, &corner});
        }
        return found;
    }

    // Where a face ends in a corner, both touch with the same normal; the direction of motion decides which of them
    // counts.
    bool counts(const Touch<Real> &touch) const {
        const V &n = touch.normal;
        if (touch.corner) {
            const V inward = std::abs(n.x) <= std::abs(n.y) ? V{static_cast<Real>(-touch.corner->signX), 0}
                                                            : V{0, static_cast<Real>(-touch.corner->signY)};
            const bool atFace = std::min(std::abs(n.x), std::abs(n.y)) * m_radius <= kLength;
            return !atFace || heading(inward) <= 0;
        }
        const Real tangential = along(m_position, 1 - touch.face->axis);
        V inward;
        if (std::abs(tangential - static_cast<Real>(touch.face->low)) <= kLength)
            along(inward, 1 - touch.face->axis) = 1;
        else if (std::abs(tangential - static_cast<Real>(touch.face->high)) <= kLength)
            along(inward, 1 - touch.face->axis) = -1;
        else
            return true;
        return heading(inward) > 0;
    }
    Real heading(const V &direction) const {
        const Real speed = m_velocity.dot(direction);
        return std::abs(speed) > kSpeed ? speed : m_acceleration.dot(direction);
    }

    std::vector<Touch<Real>> contacts() const {
        std::vector<Touch<Real>> found = touches();
        std::erase_if(found, [this](const Touch<Real> &touch) { return !counts(touch); });
        return found;
    }

    void refuseToPenetrate() const {
        for (const Wall &wall : m_walls) {
            const V nearest{std::clamp(m_position.x, static_cast<Real>(wall.x0), static_cast<Real>(wall.x1)),
                            std::clamp(m_position.y, static_cast<Real>(wall.y0), static_cast<Real>(wall.y1))};
            if ((m_position - nearest).length() < m_radius - 16 * kLength)
                throw std::runtime_error("reference: the ball is inside a wall");
        }
    }

    // -------------------------------------------------------------------------------------------------- impacts --

    // How the gap accelerates while v.n = 0; negative: the ball is pressed on (model.md 6.3).
    Real separation(const Touch<Real> &touch) const {
        return m_acceleration.dot(touch.normal) + touch.curvature * m_velocity.dot(m_velocity);
    }

    void resolveImpacts() {
        for (int pass = 0; pass < kEventCap; ++pass) {
            const auto all = contacts();
            const auto deepest = std::min_element(all.begin(), all.end(), [this](const auto &a, const auto &b) {
                return m_velocity.dot(a.normal) < m_velocity.dot(b.normal);
            });
            if (deepest == all.end() || m_velocity.dot(deepest->normal) >= -kSpeed) break;
            bounce(*deepest);
        }
        // The remaining normal speed is rounding.
        for (const auto &contact : contacts())
            if (std::abs(m_velocity.dot(contact.normal)) <= kSpeed)
                m_velocity = m_velocity - m_velocity.dot(contact.normal) * contact.normal;
    }

    // Bounces too low to be distinguished from contact end here; otherwise infinitely many would follow (model.md 6.4).
    void bounce(const Touch<Real> &touch) {
        const Real speed = m_velocity.dot(touch.normal);
        m_velocity = m_velocity - (1 + m_restitution) * speed * touch.normal;
        ++m_impacts;
        const Real rebound = m_velocity.dot(touch.normal);
        const Real press = -separation(touch);
        if (press > 0 && rebound * rebound / (2 * press) < kLength) m_velocity = m_velocity - rebound * touch.normal;
    }

    // --------------------------------------------------------------------------------------------------- motion --

    // Returns the time it took.
    Real moveToNextEvent(Real left) {
        resolveImpacts();
        std::vector<Touch<Real>> pressing = contacts();
        std::erase_if(pressing, [this](const Touch<Real> &touch) {
            return m_velocity.dot(touch.normal) > kSpeed || separation(touch) >= -kSpeed;
        });
        if (pressing.empty()) return fly(left);
        for (const auto &support : pressing)
            if (carries(support, pressing))
                return support.face ? slide(*support.face, left) : pivot(*support.corner, left);
        m_velocity = {};
        return left; // held from two sides
    }

    // Whether the ball, pressed against one of them, doesn't run into another.
    bool carries(const Touch<Real> &support, const std::vector<Touch<Real>> &pressing) const {
        const V free = m_acceleration - m_acceleration.dot(support.normal) * support.normal;
        return std::all_of(pressing.begin(), pressing.end(), [&](const Touch<Real> &other) {
            return &other == &support || free.dot(other.normal) >= -kSpeed;
        });
    }

    Real fly(Real left) {
        const Real time = firstImpact(m_acceleration, left, nullptr);
        m_position = m_position + time * (m_velocity + (time / 2) * m_acceleration);
        m_velocity = m_velocity + time * m_acceleration;
        return time;
    }

    Real slide(const Face &face, Real left) {
        V tangential;
        along(tangential, 1 - face.axis) = along(m_acceleration, 1 - face.axis);
        along(m_velocity, face.axis) = 0;
        along(m_position, face.axis) = static_cast<Real>(face.coordinate) + static_cast<Real>(face.sign) * m_radius;
        const Real toEnd = timeToEnd(face, along(tangential, 1 - face.axis), left);
        const Real time = firstImpact(tangential, toEnd, &face);
        m_position = m_position + time * (m_velocity + (time / 2) * tangential);
        m_velocity = m_velocity + time * tangential;
        if (time == toEnd && toEnd < left) snapToEnd(face);
        return time;
    }

    Real timeToEnd(const Face &face, Real acceleration, Real left) const {
        const int axis = 1 - face.axis;
        const Real position = along(m_position, axis);
        const Real speed = along(m_velocity, axis);
        const Real toLow = descentOf({position - static_cast<Real>(face.low), speed, acceleration / 2}, left);
        const Real toHigh = descentOf({static_cast<Real>(face.high) - position, -speed, -acceleration / 2}, left);
        return std::min(toLow, toHigh);
    }
    // When the ball moves away from an end, rounding must not count as having passed the end.
    static Real descentOf(Polynomial<Real> distance, Real left) {
        if (std::abs(distance[0]) <= kLength) distance.erase(distance.begin());
        return firstDescent(distance, left);
    }
    void snapToEnd(const Face &face) {
        Real &position = along(m_position, 1 - face.axis);
        const Real low = static_cast<Real>(face.low);
        const Real high = static_cast<Real>(face.high);
        position = position - low < high - position ? low : high;
    }

    // Time until the ball, moving with this acceleration, meets a part of the outline; not the face it slides on.
    Real firstImpact(const V &acceleration, Real end, const Face *slidOn) const {
        const Real reach = end * (m_velocity.length() + end * acceleration.length() / 2) + m_radius + kLength;
        for (const Face &face : m_outline.faces)
            if (&face != slidOn && std::abs(gap(face, m_position)) <= reach &&
                isBeside(face, along(m_position, 1 - face.axis), reach))
                end = std::min(end, impactWith(face, acceleration, end));
        for (const Corner &corner : m_outline.corners)
            if (!(slidOn && endsIn(*slidOn, corner)) && (m_position - pointOf(corner)).length() <= reach)
                end = std::min(end, impactWith(corner, acceleration, end));
        return end;
    }
    static bool endsIn(const Face &face, const Corner &corner) {
        const double normal = face.axis == 0 ? corner.x : corner.y;
        const double tangential = face.axis == 0 ? corner.y : corner.x;
        return normal == face.coordinate && (tangential == face.low || tangential == face.high);
    }

    Real impactWith(const Face &face, const V &acceleration, Real end) const {
        const Real sign = static_cast<Real>(face.sign);
        const Real gapNow = gap(face, m_position);
        const Real speed = sign * along(m_velocity, face.axis);
        Polynomial<Real> distance{gapNow, speed, sign * along(acceleration, face.axis) / 2};
        if (std::abs(gapNow) <= kLength) { // touching now: the first meeting after this one
            if (speed <= kSpeed) return end;
            distance.erase(distance.begin());
        }
        const Real time = firstDescent(distance, end);
        const int axis = 1 - face.axis;
        const Real there =
            along(m_position, axis) + time * (along(m_velocity, axis) + time / 2 * along(acceleration, axis));
        return time < end && isBeside(face, there, 0) ? time : end;
    }

    Real impactWith(const Corner &corner, const V &acceleration, Real end) const {
        const V offset = m_position - pointOf(corner);
        // |offset + v t + a t^2/2|^2 - R^2 (model.md 5.3)
        Polynomial<Real> distance{(offset.length() - m_radius) * (offset.length() + m_radius),
                                  2 * m_velocity.dot(offset), m_velocity.dot(m_velocity) + acceleration.dot(offset),
                                  m_velocity.dot(acceleration), acceleration.dot(acceleration) / 4};
        if (std::abs(offset.length() - m_radius) <= kLength) {
            const bool tangential = distance[1] <= 2 * m_radius * kSpeed;
            distance.erase(distance.begin(), distance.begin() + (tangential ? 2 : 1));
        }
        const Real time = firstDescent(distance, end);
        const V there = offset + time * (m_velocity + (time / 2) * acceleration);
        return time < end && isBefore(corner, there, kLength) ? time : end;
    }

    // ---------------------------------------------------------------------------------------------------- pivot --

    struct Swing {
        Real angle, rate;
    };

    // R angle'' = the tangential part of the acceleration (model.md 6.2) has no elementary solution, so it is
    // integrated in small steps of order 4 whose error is below rounding.
    Real pivot(const Corner &corner, Real left) {
        const V offset = m_position - pointOf(corner);
        Swing swing{std::atan2(offset.y, offset.x),
                    (offset.x * m_velocity.y - offset.y * m_velocity.x) / (m_radius * m_radius)};
        const std::vector<Touch<Real>> touching = touches();
        Real time = 0;
        while (time < left) {
            const Real step = std::min(left - time, static_cast<Real>(1) / 8192);
            const Swing next = swung(swing, step);
            if (!keepsPivoting(corner, next, touching)) {
                time += lastPivotingStep(corner, swing, step, touching);
                settle(corner, swing);
                return time;
            }
            swing = next;
            time += step;
        }
        settle(corner, swing);
        return left;
    }

    // Moves `swing` to just past the event inside the step; returns the time it took.
    Real lastPivotingStep(const Corner &corner, Swing &swing, Real step,
                          const std::vector<Touch<Real>> &touching) const {
        Real low = 0;
        Real high = step;
        while (true) {
            const Real middle = (low + high) / 2;
            if (middle <= low || middle >= high) break;
            (keepsPivoting(corner, swung(swing, middle), touching) ? low : high) = middle;
        }
        swing = swung(swing, high);
        return high;
    }

    Real angularAcceleration(Real angle) const {
        return (m_acceleration.y * std::cos(angle) - m_acceleration.x * std::sin(angle)) / m_radius;
    }

    Swing swung(const Swing &s, Real h) const {
        const auto slope = [this](const Swing &at) { return Swing{at.rate, angularAcceleration(at.angle)}; };
        const auto moved = [&s](const Swing &k, Real by) {
            return Swing{s.angle + by * k.angle, s.rate + by * k.rate};
        };
        const Swing k1 = slope(s);
        const Swing k2 = slope(moved(k1, h / 2));
        const Swing k3 = slope(moved(k2, h / 2));
        const Swing k4 = slope(moved(k3, h));
        return {s.angle + h / 6 * (k1.angle + 2 * k2.angle + 2 * k3.angle + k4.angle),
                s.rate + h / 6 * (k1.rate + 2 * k2.rate + 2 * k3.rate + k4.rate)};
    }

    bool keepsPivoting(const Corner &corner, const Swing &swing, const std::vector<Touch<Real>> &touching) const {
        const V normal{std::cos(swing.angle), std::sin(swing.angle)};
        if (m_acceleration.dot(normal) + m_radius * swing.rate * swing.rate >= -kSpeed / 2) return false; // leaves
        if (corner.signX * normal.x < 0 || corner.signY * normal.y < 0) return false; // reaches a face
        return !overlapsAnother(pointOf(corner) + m_radius * normal, touching);
    }
    bool overlapsAnother(const V &position, const std::vector<Touch<Real>> &touching) const {
        const auto isKnown = [&touching](const Face *face, const Corner *corner) {
            return std::any_of(touching.begin(), touching.end(), [&](const Touch<Real> &touch) {
                return (face && touch.face == face) || (corner && touch.corner == corner);
            });
        };
        for (const Face &face : m_outline.faces)
            if (gap(face, position) < 0 && gap(face, position) > -m_radius &&
                isBeside(face, along(position, 1 - face.axis), 0) && !isKnown(&face, nullptr))
                return true;
        for (const Corner &corner : m_outline.corners)
            if (gap(corner, position) < 0 && !isKnown(nullptr, &corner)) return true;
        return false;
    }

    void settle(const Corner &corner, const Swing &swing) {
        V normal{std::cos(swing.angle), std::sin(swing.angle)};
        if (corner.signX * normal.x < kRounding) normal = {0, static_cast<Real>(corner.signY)};
        if (corner.signY * normal.y < kRounding) normal = {static_cast<Real>(corner.signX), 0};
        m_position = pointOf(corner) + m_radius * normal;
        m_velocity = m_radius * swing.rate * V{-normal.y, normal.x};
    }

    Outline m_outline;
    std::vector<Wall> m_walls;
    Real m_radius;
    Real m_restitution;
    V m_position;
    V m_velocity;
    V m_acceleration;
    int m_impacts = 0;
};

} // namespace

template<class Real>
Passage eventDriven(const Scene &scene) {
    Motion<Real> motion(scene);
    const Real share = scene.rolls ? static_cast<Real>(5) / 7 : 1; // model.md 3.1
    Passage passage;
    for (const phys_vec3 &gravity : scene.gravity) {
        motion.advance(static_cast<Real>(scene.tiltPeriod),
                       {share * static_cast<Real>(gravity.x), share * static_cast<Real>(gravity.y)});
        passage.balls.push_back(motion.ball());
    }
    passage.impacts = motion.impacts();
    return passage;
}

template Passage eventDriven<double>(const Scene &scene);
template Passage eventDriven<long double>(const Scene &scene);

std::vector<double> sensitivity(const Scene &scene) {
    constexpr double kChange = 1e-9; // m: far above rounding, and small enough to stay linear over the whole run
    Scene changed = scene;
    changed.start.position.x += kChange;
    const Passage here = eventDriven<long double>(scene);
    const Passage there = eventDriven<long double>(changed);
    std::vector<double> growth;
    for (std::size_t period = 0; period < here.balls.size(); ++period)
        growth.push_back(distance(here.balls[period].position, there.balls[period].position) / kChange);
    return growth;
}

} // namespace bench
