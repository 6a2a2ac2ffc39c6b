// SPDX-License-Identifier: MIT
#include "sweep.h"

#include <algorithm>
#include <cmath>

namespace phys {

namespace {

/// Way of the ball in the first window of a search, in radii; it doubles while the windows are empty.
constexpr double kFirstWindow = 6.0;

/// Steps of the advancement for one touch; a transversal one takes about 7.
constexpr int kMostPasses = 64;

/// Halvings of a motion's duration in search of a time shortly before a touch.
constexpr int kMostHalvings = 12;

/// model.md 5.2, the corner of a wall end that the ball has just left. While the corner is its nearest point, half the
/// second derivative of their squared distance is F - B (v.d)/|v| with F = |v|^2 + A.d, and F' = 3 A.v - 2 B |v|
/// changes its sign at most once, from - to +. So a ball that moves away (v.d >= 0) with F >= 0 and F' >= 0 never comes
/// back to the corner. Otherwise the returned time is safe by a Taylor polynomial with its remainder.
double awayFromCorner(const Motion &motion, const Nearest &close, const Motion::Point &now, double radius) {
    const Vec2 d = inPlane(now.position - close.point);
    const Vec2 v = inPlane(now.velocity), A = inPlane(motion.acceleration());
    const double speed = length(v), a = length(A), B = motion.resistance();
    const double away = std::max(0.0, glm::dot(v, d));
    const double F = speed * speed + glm::dot(A, d);
    if (F >= 0.0 && 3.0 * glm::dot(A, v) - 2.0 * B * speed >= 0.0) return kNever;

    const double gap = std::max(0.0, close.distance - radius);
    const double D = gap * (2.0 * radius + gap);
    double h = 0.5 * speed / (a + B);
    for (int halving = 0; halving < 60; ++halving, h *= 0.5) {
        const double most = speed + (a + B) * h, least = speed - (a + B) * h;
        const double slope = (3.0 * a + 2.0 * B) * most; // bounds |F'|
        const double drag = B / least * (away + (std::abs(F) + slope * h) * h);
        if (D + h * (2.0 * away + h * (F - drag - slope / 3.0 * h)) >= 0.0) return h;
    }
    return 0.0;
}

/// How long the corner stays the nearest point of its box at least.
double withinCorner(const Motion &motion, const Nearest &close, const Motion::Point &now) {
    const Vec3 d = now.position - close.point;
    double time = kNever;
    for (int axis = 0; axis < 2; ++axis) {
        Vec3 n(0.0);
        n[axis] = d[axis] < 0.0 ? -1.0 : 1.0;
        const double rate = n[axis] * now.velocity[axis];
        time = std::min(time, firstFall(std::abs(d[axis]), rate, motion.leastAcceleration(n, rate)));
    }
    return time;
}

/// Time for which the ball surely doesn't hit the box. The box is convex and lies behind the plane through its nearest
/// point across the normal: no way leads into it that doesn't fall through that plane first.
double safeTime(const Board &board, const Motion &motion, const Nearest &close, const Motion::Point &now) {
    const double gap = std::max(0.0, close.distance - board.radius());
    const double rate = glm::dot(now.velocity, close.normal);
    const double least = motion.leastAcceleration(close.normal, rate);
    double time = firstFall(gap, rate, least);
    const bool byCorner = close.feature == PHYS_FEATURE_EDGE && close.normal.z == 0.0;
    if (byCorner && rate >= 0.0 && gap < 0.1 * board.radius() && !motion.slips()) {
        const double away = awayFromCorner(motion, close, now, board.radius());
        time = std::max(time, std::min(away, withinCorner(motion, close, now)));
    }
    // Just released, or grazing: a step that falls within the tolerance gets the search going. What it falls too far is
    // less than a bounce that model.md 6.4 lets live.
    const bool hardlyRises = rate <= 0.0 || rate * rate < -least * board.tolerance();
    if (gap > board.tolerance() || !hardlyRises) return time;
    return std::max(time, firstFall(0.25 * board.tolerance(), rate, least));
}

/// Rate (v.n) that counts as zero. Going round an edge with v the ball gets no deeper than v.n^2 R / (2 v^2), which is
/// within two tolerances then: it grazes, model.md 5.4. What it does along the edge changes nothing in that.
double zeroRate(const Board &board, const Vec3 &normal, uint32_t feature, const Vec3 &v) {
    if (feature == PHYS_FEATURE_FACE) return 4.0 * kRounding * glm::length(v);
    return board.grazing() * glm::length(velocityRound(normal, feature, v));
}

double timeToCover(double distance, const Motion &motion, const Motion::Point &now) {
    return firstFall(distance, -glm::length(now.velocity), -motion.mostAcceleration());
}

} // namespace

Vec3 velocityRound(const Vec3 &normal, uint32_t feature, const Vec3 &v) {
    if (feature == PHYS_FEATURE_FACE) return Vec3(0.0);
    const Vec3 &n = normal;
    Vec3 round = v - glm::dot(v, n) * n;
    for (int axis = 0; axis < 3; ++axis) { // two zeros: the end of a face, whose edge isn't known
        if (n[axis] == 0.0 && n[(axis + 1) % 3] != 0.0 && n[(axis + 2) % 3] != 0.0) round[axis] = 0.0;
    }
    return round;
}

bool approaches(const Board &board, const Vec3 &normal, uint32_t feature, const Vec3 &v) {
    return glm::dot(v, normal) < -zeroRate(board, normal, feature, v);
}

Sweep::Sweep(const Board &board)
    : m_board(board) {
    m_candidates.reserve(board.scene().solids.size());
}

double Sweep::firstTouch(const Motion &motion, double until, const Plane *plane) {
    Motion::Point now = motion.at(0.0);
    double from = 0.0;
    double reach = kFirstWindow * m_board.radius();
    while (true) {
        double windowEnd = std::min(until, from + timeToCover(reach, motion, now));
        if (windowEnd == from) windowEnd = std::nextafter(from, kNever);
        collect(motion, now, from, windowEnd, plane);
        const double hit = firstHit(motion, windowEnd, until);
        if (hit <= windowEnd) return hit;
        if (++m_looks > kMostLooks || !(windowEnd < until)) return kNever; // a NaN must end the search, too
        if (m_candidates.empty()) reach *= 2.0;
        from = windowEnd;
        now = motion.at(from);
    }
}

/// 0, or for a motion that starts beside its box, behind the plane that it will touch: a time before t from which it is
/// in front of it. One that doesn't depend on the last bits of t.
double Sweep::startInFront(const Motion &motion, const Nearest &close, double reach, double t, double until) const {
    if (close.feature != PHYS_FEATURE_FACE) return 0.0;
    double time = 0.0, step = until;
    for (int halving = 0; halving < kMostHalvings; ++halving, step *= 0.5) {
        const double gap = glm::dot(motion.at(time).position - close.point, close.normal) - reach;
        if (gap >= -m_board.tolerance()) return time;
        time = step * std::floor(t / step);
    }
    return 0.0;
}

/// The same touch found from the start of the motion, against the face's plane or the edge alone: so its last bit
/// depends neither on the search's windows nor on how walls are cut into boxes.
double Sweep::settled(const Motion &motion, const Nearest &close, double reach, const Vec3 &velocity, double t,
                      double until) const {
    if (close.feature != PHYS_FEATURE_FACE && close.normal.z != 0.0) return t;
    double time = startInFront(motion, close, reach, t, until);
    const Vec3 start = motion.at(0.0).position - close.point;
    // A bounce returns to the face that it starts on, whatever the difference of the coordinates rounds to.
    const bool returns = time == 0.0 && close.feature == PHYS_FEATURE_FACE &&
                         std::abs(glm::dot(start, close.normal) - reach) <= m_board.tolerance();
    bool polished = false;
    for (int pass = 0; pass < kMostPasses; ++pass) {
        const Motion::Point now = motion.since(time);
        Vec3 normal = close.normal;
        Vec3 away = start + now.position;
        if (close.feature != PHYS_FEATURE_FACE) {
            away.z = 0.0;
            normal = away / glm::length(away);
        }
        const double gap = returns ? glm::dot(now.position, normal) : glm::dot(away, normal) - reach;
        const double rate = glm::dot(now.velocity, normal);
        const bool isAt = gap <= m_board.tolerance() && rate <= 0.0;
        if (gap < -m_board.tolerance() || (pass == 0 && isAt)) return t;
        time += firstFall(std::max(0.0, gap), rate, motion.leastAcceleration(normal, rate));
        if (polished) break;
        polished = isAt;
    }
    const double rate = std::abs(glm::dot(velocity, close.normal));
    return std::abs(time - t) * rate <= 4.0 * m_board.tolerance() ? time : t;
}

void Sweep::collect(const Motion &motion, const Motion::Point &now, double from, double until, const Plane *plane) {
    m_candidates.clear();
    const double duration = until - from;
    const double way = duration * (glm::length(now.velocity) + 0.5 * motion.mostAcceleration() * duration);
    const double reach = m_board.radius() * (1.0 + 1e-9) + way + m_board.tolerance();
    for (const uint32_t solid : withinReach(motion, now, until, duration, way)) {
        const phys_box &box = m_board.scene().solids[solid];
        if (squaredDistance(box, now.position) > reach * reach) continue;
        if (plane && m_board.isBehind(*plane, solid)) continue;
        const Nearest close = nearest(box, now.position);
        const bool touches = close.distance - m_board.radius() <= m_board.tolerance();
        const bool hits = touches && approaches(m_board, close.normal, close.feature, now.velocity);
        const double safe = hits ? from : from + safeTime(m_board, motion, close, now);
        if (safe <= until) m_candidates.push_back({safe, solid, false});
    }
}

/// Solids that the ball can touch until then. One cell of the grid knows those near a short way.
std::span<const uint32_t> Sweep::withinReach(const Motion &motion, const Motion::Point &now, double until,
                                             double duration, double way) const {
    const Scene &scene = m_board.scene();
    const Vec2 begin = inPlane(now.position);
    if (way < (kCandidateReach - 1.01) * m_board.radius()) return scene.solidsNear(begin.x, begin.y, scene.needsGrid);
    const Vec2 end = inPlane(motion.at(until).position);
    // A way with |p''| <= a strays from its chord by a T^2/8 at most.
    const Vec2 bulge(0.125 * motion.mostAcceleration() * duration * duration + m_board.tolerance());
    return m_board.near(glm::min(begin, end) - bulge, glm::max(begin, end) + bulge);
}

double Sweep::firstHit(const Motion &motion, double windowEnd, double until) {
    const auto earlier = [](const Candidate &a, const Candidate &b) { return a.safe < b.safe; };
    while (!m_candidates.empty()) {
        Candidate &next = *std::min_element(m_candidates.begin(), m_candidates.end(), earlier);
        const double t = next.safe;
        if (!(t <= windowEnd) || ++m_looks > kMostLooks) break;
        const Motion::Point now = motion.at(t);
        const Nearest close = nearest(m_board.scene().solids[next.solid], now.position);
        const double h = safeTime(m_board, motion, close, now);
        const bool touches = close.distance - m_board.radius() <= m_board.tolerance();
        if (touches && approaches(m_board, close.normal, close.feature, now.velocity)) {
            if (next.polished) return settled(motion, close, m_board.radius(), now.velocity, t, until);
            const double gap = std::max(0.0, close.distance - m_board.radius());
            const double rate = glm::dot(now.velocity, close.normal);
            next = {t + firstFall(gap, rate, motion.leastAcceleration(close.normal, rate)), next.solid, true};
            continue;
        }
        if (t + h > t) {
            next = {t + h, next.solid, false};
        } else {
            next.safe = std::nextafter(t, kNever);
        }
    }
    return kNever;
}

namespace {

/// Depth behind a border of the floor along its inner normal, and that normal.
struct Border {
    double depth;
    Vec3 normal;
};

std::array<Border, 4> bordersAt(const phys_box &floor, const Vec3 &p) {
    return {{{p.x - floor.min.x, {1.0, 0.0, 0.0}},
             {floor.max.x - p.x, {-1.0, 0.0, 0.0}},
             {p.y - floor.min.y, {0.0, 1.0, 0.0}},
             {floor.max.y - p.y, {0.0, -1.0, 0.0}}}};
}

} // namespace

double firstExit(const phys_box &floor, const Motion &motion, double from, double until, double tolerance) {
    Motion::Point now = motion.at(from);
    const std::array<Border, 4> borders = bordersAt(floor, now.position);
    const double nearest = std::min({borders[0].depth, borders[1].depth, borders[2].depth, borders[3].depth});
    const double duration = until - from;
    const double way = duration * (glm::length(now.velocity) + 0.5 * motion.mostAcceleration() * duration);
    if (nearest > way) return kNever;
    bool polished = false;
    for (double t = from; t <= until; now = motion.at(t)) {
        double step = kNever;
        bool leaves = false;
        for (const Border &border : bordersAt(floor, now.position)) {
            const double rate = glm::dot(now.velocity, border.normal);
            const double least = motion.leastAcceleration(border.normal, rate);
            const bool isAt = border.depth <= tolerance;
            leaves = leaves || (isAt && rate < 0.0);
            const double safe = firstFall(std::max(0.0, border.depth), rate, least);
            // Starting from rest on the border: a step within the tolerance gets the search going.
            step = std::min(step, isAt && rate >= 0.0 ? std::max(safe, firstFall(tolerance, rate, least)) : safe);
        }
        if (leaves && (polished || t + step == t)) return t;
        polished = leaves;
        t = std::max(t + step, std::nextafter(t, kNever));
    }
    return kNever;
}

double Sweep::firstExit(const Motion &motion, double until, uint32_t &floor) const {
    const std::vector<phys_box> &floors = m_board.scene().floors;
    double t = 0.0;
    // A way crosses each border twice at most.
    for (size_t crossing = 0; crossing <= 8 * floors.size(); ++crossing) {
        t = phys::firstExit(floors[floor], motion, t, until, m_board.tolerance());
        if (t > until) return kNever;
        const Motion::Point out = motion.at(t);
        Vec3 place = out.position;
        snapToBorder(floors[floor], m_board.tolerance(), out.velocity, place);
        const std::optional<uint32_t> next = m_board.floorUnder(place, inPlane(out.velocity));
        if (!next) return settledExit(floors[floor], motion, {place, out.velocity}, t, until);
        floor = *next;
    }
    return t;
}

/// The same exit found from the start of the motion, against the border alone: as settled().
double Sweep::settledExit(const phys_box &floor, const Motion &motion, const Motion::Point &out, double t,
                          double until) const {
    for (const Border &border : bordersAt(floor, out.position)) {
        if (border.depth > m_board.tolerance() || glm::dot(out.velocity, border.normal) >= 0.0) continue;
        const Nearest line{out.position, border.normal, 0.0, PHYS_FEATURE_FACE};
        return std::min(until, settled(motion, line, 0.0, out.velocity, t, until));
    }
    return t;
}

void snapToBorder(const phys_box &floor, double tolerance, const Vec3 &velocity, Vec3 &p) {
    // The way of the ball was stopped within rounding of the border, but the slower it crosses the further along it.
    const double reach = 4.0 * tolerance;
    if (velocity.x < 0.0 && p.x - floor.min.x <= reach) p.x = floor.min.x;
    if (velocity.x > 0.0 && floor.max.x - p.x <= reach) p.x = floor.max.x;
    if (velocity.y < 0.0 && p.y - floor.min.y <= reach) p.y = floor.min.y;
    if (velocity.y > 0.0 && floor.max.y - p.y <= reach) p.y = floor.max.y;
}

} // namespace phys
