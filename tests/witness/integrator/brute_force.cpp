// SPDX-License-Identifier: MIT
#include "brute_force.h"

#include <algorithm>
#include <array>
#include <limits>

namespace witness {

namespace {

constexpr uint64_t kMostSteps = 50'000;
constexpr uint64_t kMostUpdates = 10'000'000; ///< of a contact in the sweeps
constexpr uint64_t kMostImpacts = 5'000;
constexpr Real kShortestStep = 1e-9L; // s; at a change of mode the error of such a step is its square
constexpr int kMostSweeps = 300;
constexpr int kMostLooks = 30;
constexpr Real kUlp = 1e-18L; // a few units in the last place
constexpr Real kSameNormal = 1e-9L;

bool isSame(const Vector &a, const Vector &b) { return length(a - b) < kSameNormal; }

/// Whether it rolls on a floor without slip.
Vector rollingSpin(const Vector &velocity, Real radius) { return {-velocity.y / radius, velocity.x / radius, 0}; }

/// The minimum of a convex function on [0, 1].
template<class Function>
Real deepestOn(const Function &gap) {
    Real low = 0;
    Real high = 1;
    for (int i = 0; i < 80 && high - low > 1e-10L; ++i) {
        const Real left = low + (high - low) / 3;
        const Real right = high - (high - low) / 3;
        if (gap(left) < gap(right)) {
            high = right;
        } else {
            low = left;
        }
    }
    const Real middle = (low + high) / 2;
    return gap(1) < gap(middle) ? 1 : middle;
}

Motion combined(const Motion &a, Real factor, const Motion &b) {
    return {a.place + factor * b.place, a.velocity + factor * b.velocity, a.spin + factor * b.spin};
}

} // namespace

BruteForce::BruteForce(std::span<const phys_box> boxes, Real radius, Real tolerance)
    : m_boxes(boxes)
    , m_radius(radius)
    , m_tolerance(tolerance) {
    Real largest = radius;
    for (const phys_box &box : boxes) {
        for (const phys_vec3 &p : {box.min, box.max}) {
            largest = std::max<Real>({largest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
        }
    }
    m_givenTolerance = 4 * 2.2e-16L * largest;
    m_touchTolerance = 64 * std::numeric_limits<Real>::epsilon() * largest;
}

/// Contacts with the same normal count once: the one with the fewest codes is kept, a top face first.
std::vector<Touch> BruteForce::touching(const Motion &motion) const {
    std::vector<Touch> all;
    for (const phys_box &box : m_boxes) {
        const Touch touch = touchOf(box, motion.place, m_radius);
        if (touch.gap > m_touchTolerance) continue;
        const auto same = std::find_if(all.begin(), all.end(),
                                       [&](const Touch &other) { return isSame(touch.normal, other.normal); });
        if (same == all.end()) {
            all.push_back(touch);
        } else if (touch.codes < same->codes || (touch.codes == same->codes && touch.isTop)) {
            *same = touch;
        }
    }
    return all;
}

/// Contacts that don't recede, or so slowly that gravity brings the ball back almost immediately.
std::vector<BruteForce::Contact> BruteForce::lasting(const Law &law, const Motion &motion) const {
    const Real noSpeed = 1e-13L * (length(motion.velocity) + m_radius * length(motion.spin)) +
                         1e-14L * std::sqrt(length(law.gravity) * m_radius);
    std::vector<Contact> contacts;
    for (size_t i = 0; i < m_boxes.size(); ++i) {
        const Touch touch = touchOf(m_boxes[i], motion.place, m_radius);
        const Real limit = std::max(noSpeed, closingSpeed(law, touch, m_touchTolerance));
        if (touch.gap > m_touchTolerance || dot(touch.normal, motion.velocity) > limit) continue;
        contacts.push_back({i, touch, 0, {}, {}, false, false});
    }
    return contacts;
}

/// Features and normals at the end of the step; impulses keep acting along the step's own normals.
void BruteForce::lookWhereTheyEnd(const Law &, const Vector &place, std::vector<Contact> &contacts) const {
    for (Contact &contact : contacts) {
        contact.touch = touchOf(m_boxes[contact.box], place, m_radius);
        contact.friction = across(contact.friction, contact.touch.normal);
        contact.resistance = across(contact.resistance, contact.touch.normal);
        contact.isMerged = false;
    }
    for (size_t i = 0; i < contacts.size(); ++i) {
        for (size_t j = 0; j < contacts.size(); ++j) {
            if (i == j || contacts[j].isMerged || !isSame(contacts[i].touch.normal, contacts[j].touch.normal)) continue;
            const Touch &mine = contacts[i].touch;
            const Touch &other = contacts[j].touch;
            const bool isWorse = mine.codes != other.codes   ? mine.codes > other.codes
                                 : mine.isTop != other.isTop ? other.isTop
                                                             : i > j;
            if (isWorse) contacts[i].isMerged = true;
        }
        if (contacts[i].isMerged) contacts[i].pressure = 0, contacts[i].friction = {}, contacts[i].resistance = {};
    }
}

/// Friction of one contact for its present pressure: it removes as much of the slip as Coulomb's law allows.
Vector BruteForce::rub(const Law &law, Contact &c, Motion &end) const {
    const Vector &n = c.touch.normal;
    const bool isGlued = !law.isRigid && c.touch.isTop;
    Vector friction = c.friction - (2.0L / 7) * slipAt(end, n, m_radius);
    if (!isGlued) friction = clipped(friction, law.friction(c.touch) * c.pressure);
    if (isGlued && c.pressure == 0) friction = {};
    const Vector more = friction - c.friction;
    end.velocity += more;
    end.spin -= 5 / (2 * m_radius) * cross(n, more);
    c.friction = friction;
    return more;
}

/// A rolling contact with resistance: friction and the torque together. Without both the ball would have the velocities
/// v0 and w0 = R om0 x n across the normal; sticking and the torque M = R m x n lead to v = w = (5 v0 + 2 w0 + 2 M)/7,
/// M against it and at most 5/2 mu_r N.
Vector BruteForce::rollOn(const Law &law, Contact &c, Motion &end) const {
    const Vector &n = c.touch.normal;
    const Real arm = 5 / (2 * m_radius);
    const Motion before = end;
    end.velocity -= c.friction;
    end.spin += arm * cross(n, c.friction);
    end.spin -= c.resistance;
    const Vector v = across(end.velocity, n);
    const Vector w = m_radius * cross(end.spin, n);
    const Vector torque = clipped((-1.0L / 2) * (5 * v + 2 * w), 2.5L * law.rollingFriction * c.pressure);
    c.friction = (2.0L / 7) * (w - v + torque);
    c.resistance = (1 / m_radius) * cross(n, torque);
    end.velocity += c.friction;
    end.spin += c.resistance - arm * cross(n, c.friction);
    return end.velocity - before.velocity;
}

/// Between two parallel faces as far apart as the ball is wide, sweeps may squeeze it: a pressure that moves nothing,
/// but that friction depends on. The law takes the least. Returns whether there was any.
bool BruteForce::releaseOpposite(std::vector<Contact> &contacts) const {
    bool isReleased = false;
    for (size_t i = 0; i < contacts.size(); ++i) {
        for (size_t j = i + 1; j < contacts.size(); ++j) {
            const Real squeeze = std::min(contacts[i].pressure, contacts[j].pressure);
            if (squeeze <= 0 || !isSame(contacts[i].touch.normal, -contacts[j].touch.normal)) continue;
            contacts[i].pressure -= squeeze;
            contacts[j].pressure -= squeeze;
            isReleased = true;
        }
    }
    return isReleased;
}

/// Whether the normals of some contacts are linearly dependent, those of opposite ones aside.
bool BruteForce::areDependent(const std::vector<Contact> &contacts, const std::vector<size_t> &some) const {
    constexpr Real kFlat = 1e3L * kUlp;
    for (size_t i = 0; i < some.size(); ++i) {
        for (size_t j = i + 1; j < some.size(); ++j) {
            const Vector line = cross(contacts[some[i]].touch.normal, contacts[some[j]].touch.normal);
            for (size_t k = j + 1; k < some.size(); ++k) {
                if (some.size() > 3 || std::abs(dot(line, contacts[some[k]].touch.normal)) <= kFlat) return true;
            }
        }
    }
    return false;
}

/// Takes back what a contact does to the ball; it is left out from then on.
void BruteForce::release(Contact &c, Motion &end) const {
    end.velocity -= c.pressure * c.touch.normal + c.friction;
    end.spin += (5 / (2 * m_radius)) * cross(c.touch.normal, c.friction) - c.resistance;
    c.pressure = 0;
    c.friction = c.resistance = {};
    c.isMerged = true;
}

/// Coulomb's law for all contacts together: one after the other until nothing changes.
void BruteForce::sweep(const Law &law, Real scale, bool withResistance, std::vector<Contact> &contacts,
                       Motion &end) const {
    for (int sweep = 0; sweep < kMostSweeps; ++sweep) {
        Real change = 0;
        m_updates += contacts.size();
        for (Contact &c : contacts) {
            if (c.isMerged) continue;
            const Vector &n = c.touch.normal;
            const Real pressure = std::max<Real>(0, c.pressure - dot(n, end.velocity));
            end.velocity += (pressure - c.pressure) * n;
            change = std::max(change, std::abs(pressure - c.pressure));
            c.pressure = pressure;
            change = std::max(change, length(withResistance && c.isRolling ? rollOn(law, c, end) : rub(law, c, end)));
        }
        if (!releaseOpposite(contacts) && change <= kUlp * scale) return;
    }
}

/// The same. Normals that depend on one another, as of a slot's bottom and both of its edges, leave it open which
/// contacts carry the ball, and friction depends on that. The law takes those with the smallest sum of pressures.
void BruteForce::press(const Law &law, Real scale, bool withResistance, std::vector<Contact> &contacts,
                       Motion &end) const {
    sweep(law, scale, withResistance, contacts, end);
    const Real none = 1e3L * kUlp * scale;
    std::vector<size_t> closed;
    for (size_t i = 0; i < contacts.size(); ++i) {
        const Contact &c = contacts[i];
        if (!c.isMerged && std::abs(dot(c.touch.normal, end.velocity)) <= none) closed.push_back(i);
    }
    if (!areDependent(contacts, closed)) return;
    const std::vector<Contact> all = contacts;
    const Motion pressed = end;
    Real least = std::numeric_limits<Real>::infinity();
    for (unsigned open = 1; open + 1 < 1U << closed.size(); ++open) {
        std::vector<size_t> left;
        for (size_t i = 0; i < closed.size(); ++i) {
            if (!(open >> i & 1U)) left.push_back(closed[i]);
        }
        if (areDependent(contacts, left)) continue;
        std::vector<Contact> some = all;
        Motion motion = pressed;
        for (size_t i = 0; i < closed.size(); ++i) {
            if (open >> i & 1U) release(some[closed[i]], motion);
        }
        sweep(law, scale, withResistance, some, motion);
        Real sum = 0;
        bool isAdmissible = true;
        for (size_t i = 0; i < some.size(); ++i) {
            sum += some[i].pressure;
            isAdmissible = isAdmissible && (all[i].isMerged || dot(some[i].touch.normal, motion.velocity) >= -none);
            some[i].isMerged = all[i].isMerged;
        }
        if (!isAdmissible || sum >= least) continue;
        least = sum;
        contacts = some;
        end = motion;
    }
}

/// Two sticking contacts can press on each other along the line between them, which moves nothing but determines how
/// much each carries and hence the rolling resistance. The law takes the least friction. The sweeps may end with
/// friction at the limit of a cone without a slip: that sticks, too; and at a contact that rolls on resistance with
/// more than all of it.
void BruteForce::relax(const Law &law, Real scale, const Motion &end, std::vector<Contact> &contacts) const {
    const auto mayStick = [&](const Contact &c) {
        return !c.isMerged && c.pressure > 0 && length(slipAt(end, c.touch.normal, m_radius)) <= 1e3L * kUlp * scale;
    };
    const auto sticks = [&](const Contact &c) {
        return mayStick(c) && length(c.friction) <= law.friction(c.touch) * c.pressure * (1 + 1e-12L);
    };
    for (size_t i = 0; i < contacts.size(); ++i) {
        for (size_t j = i + 1; j < contacts.size(); ++j) {
            Contact &a = contacts[i];
            Contact &b = contacts[j];
            if (!mayStick(a) || !mayStick(b)) continue;
            const Vector line = a.touch.normal - b.touch.normal;
            const Vector alongA = across(line, a.touch.normal);
            const Vector alongB = across(line, b.touch.normal);
            const Real size = dot(alongA, alongA) + dot(alongB, alongB);
            if (size < 1e-12L) continue;
            const Real part = -(dot(a.friction, alongA) - dot(b.friction, alongB)) / size;
            const Contact before[] = {a, b};
            const Real squeeze = part * dot(line, a.touch.normal);
            a.pressure += squeeze;
            b.pressure += squeeze;
            a.friction += part * alongA;
            b.friction -= part * alongB;
            if (sticks(a) && sticks(b)) continue;
            a = before[0];
            b = before[1];
        }
    }
}

Motion BruteForce::implicitEuler(const Law &law, const Motion &start, Real h, std::vector<Contact> &contacts) const {
    const Real scale = length(start.velocity) + m_radius * length(start.spin) + h * length(law.gravity);
    for (Contact &c : contacts) c.pressure = 0, c.friction = {}, c.resistance = {}, c.isRolling = false;
    Motion end = start;
    end.velocity += h * law.gravity;
    const bool canResist = law.rollingFriction > 0;
    for (const bool withResistance : {false, true}) {
        if (contacts.empty() || (withResistance && !canResist)) break;
        for (int look = 0; look < kMostLooks; ++look) {
            const Motion before = end;
            lookWhereTheyEnd(law, start.place + h * end.velocity, contacts);
            end.velocity = start.velocity + h * law.gravity;
            // A ball that comes onto a top face keeps its velocity, and its spin follows the velocity.
            const bool isOnTop = !law.isRigid && std::any_of(contacts.begin(), contacts.end(), [](const Contact &c) {
                return c.touch.isTop && !c.isMerged;
            });
            end.spin = isOnTop ? rollingSpin(start.velocity, m_radius) : start.spin;
            for (const Contact &c : contacts) {
                end.velocity += c.pressure * c.touch.normal + c.friction;
                end.spin += c.resistance - (5 / (2 * m_radius)) * cross(c.touch.normal, c.friction);
            }
            press(law, scale, withResistance, contacts, end);
            if (canResist && contacts.size() > 1 && law.isRigid) relax(law, scale, end, contacts);
            if (length(end.velocity - before.velocity) + m_radius * length(end.spin - before.spin) <= 8 * kUlp * scale)
                break;
        }
        for (Contact &c : contacts) {
            const bool sticks = !law.isRigid || length(c.friction) < law.friction(c.touch) * c.pressure * (1 - 1e-15L);
            c.isRolling = c.touch.isTop && c.pressure > 0 && sticks;
        }
    }
    end.place = start.place + h * end.velocity;
    return end;
}

/// One step by extrapolation of 1, 2, 3 and 4 substeps (Aitken and Neville).
BruteForce::Trial BruteForce::attempt(const Law &law, const Motion &start, Real h,
                                      const std::vector<Contact> &contacts) const {
    constexpr int kRows = 4;
    Trial trial{start, 0, contacts};
    Motion table[kRows][kRows];
    for (int row = 0; row < kRows; ++row) {
        Motion motion = start;
        for (int i = 0; i <= row; ++i) motion = implicitEuler(law, motion, h / (row + 1), trial.contacts);
        table[row][0] = motion;
        for (int k = 1; k <= row; ++k) {
            const Real factor = 1 / (Real(row + 1) / Real(row + 1 - k) - 1);
            const Motion difference = combined(table[row][k - 1], -1, table[row - 1][k - 1]);
            table[row][k] = combined(table[row][k - 1], factor, difference);
        }
        if (contacts.empty()) { // a parabola needs no extrapolation
            trial.end = combined(motion, 0, motion);
            trial.end.place = start.place + h * start.velocity + (h * h / 2) * law.gravity;
            return trial;
        }
    }
    trial.end = table[kRows - 1][kRows - 1];
    const Motion difference = combined(trial.end, -1, table[kRows - 1][kRows - 2]);
    const Real speed =
        length(start.velocity) + m_radius * length(start.spin) + std::sqrt(length(law.gravity) * m_radius);
    trial.error = std::max({length(difference.place) / m_radius, length(difference.velocity) / speed,
                            m_radius * length(difference.spin) / speed});
    return trial;
}

/// When the path, a cubic through both ends, first enters a box that isn't a lasting contact, as a share of the step; 2
/// if never.
Real BruteForce::firstOverlap(const Motion &start, const Motion &end, Real h,
                              const std::vector<Contact> &contacts) const {
    const auto at = [&](Real s) {
        const Real r = 1 - s;
        return r * r * (1 + 2 * s) * start.place + s * s * (1 + 2 * r) * end.place + (h * s * r * r) * start.velocity -
               (h * s * s * r) * end.velocity;
    };
    const Real way = h * std::max(length(start.velocity), length(end.velocity)) + length(end.place - start.place);
    Real first = 2;
    for (size_t i = 0; i < m_boxes.size(); ++i) {
        if (std::any_of(contacts.begin(), contacts.end(), [&](const Contact &c) { return c.box == i; })) continue;
        if (touchOf(m_boxes[i], start.place, m_radius).gap > way) continue;
        const auto overlaps = [&](Real s) { return touchOf(m_boxes[i], at(s), m_radius).gap < -m_touchTolerance / 8; };
        Real high = deepestOn([&](Real s) { return touchOf(m_boxes[i], at(s), m_radius).gap; });
        if (!overlaps(high)) continue;
        Real low = 0;
        for (int k = 0; k < 70 && high - low > 1e-20L * high; ++k) {
            const Real middle = (low + high) / 2;
            (overlaps(middle) ? high : low) = middle;
        }
        first = std::min(first, high);
    }
    return first;
}

/// Whether a contact moves over to another feature of its box; on the border it belongs to the feature it moves
/// towards.
bool BruteForce::changesFeature(const Motion &start, const Motion &end, const std::vector<Contact> &contacts) const {
    constexpr Real kAhead = 1e-15L; // s
    const Vector place = start.place + kAhead * start.velocity;
    return std::any_of(contacts.begin(), contacts.end(), [&](const Contact &contact) {
        const phys_box &box = m_boxes[contact.box];
        return touchOf(box, place, m_radius).codes != touchOf(box, end.place, m_radius).codes;
    });
}

/// Whether a slip passes through zero, or a roll with resistance comes to a stop: implicit Euler only sees the end of
/// the step, and would let the ball move backwards from the beginning.
bool BruteForce::reverses(const Law &law, const Motion &start, const Trial &trial) const {
    const Motion &end = trial.end;
    const Real none =
        1e-15L * (length(start.velocity) + m_radius * length(start.spin) + std::sqrt(length(law.gravity) * m_radius));
    return std::any_of(trial.contacts.begin(), trial.contacts.end(), [&](const Contact &contact) {
        const Vector &n = contact.touch.normal;
        if (contact.pressure <= 0 || contact.isMerged) return false;
        const Vector roll = m_radius * across(start.spin, n);
        const Vector rollAtEnd = m_radius * across(end.spin, n);
        const bool resists = contact.touch.isTop && law.rollingFriction > 0;
        if (resists && length(roll) > none && (length(rollAtEnd) <= none || dot(roll, rollAtEnd) < 0)) return true;
        const Vector slip = slipAt(start, n, m_radius);
        const Vector slipAtEnd = slipAt(end, n, m_radius);
        return length(slip) > none && length(slipAtEnd) > none && dot(slip, slipAtEnd) < 0;
    });
}

/// The fastest slip that ends somewhere in the step, 0 if none does.
Real BruteForce::endingSlip(const Law &law, const Motion &start, const Trial &trial) const {
    const Real none =
        1e-14L * (length(start.velocity) + m_radius * length(start.spin) + std::sqrt(length(law.gravity) * m_radius));
    Real fastest = 0;
    for (const Contact &contact : trial.contacts) {
        const Vector &n = contact.touch.normal;
        if (contact.pressure <= 0 || contact.isMerged || law.friction(contact.touch) == 0) continue;
        const Real slip = length(slipAt(start, n, m_radius));
        if (slip > none && length(slipAt(trial.end, n, m_radius)) <= none) fastest = std::max(fastest, slip);
    }
    return fastest;
}

bool BruteForce::endsEarly(const Law &law, const Motion &start, const Trial &trial, Real h) const {
    return changesFeature(start, trial.end, trial.contacts) || reverses(law, start, trial) ||
           firstOverlap(start, trial.end, h, trial.contacts) <= 1;
}

/// Finds the shortest step that meets another box or feature; `trial` becomes that step.
Real BruteForce::bracket(const Law &law, const Motion &start, Real h, const std::vector<Contact> &contacts,
                         Trial &trial) const {
    Real low = 0;
    Real high = h;
    if (contacts.empty()) { // the cubic is the parabola
        high = h * firstOverlap(start, trial.end, h, contacts);
        trial = attempt(law, start, high, contacts);
        return high;
    }
    for (int i = 0; i < 80 && high - low > 1e-20L + 1e-19L * high; ++i) {
        const Real middle = (low + high) / 2;
        Trial shorter = attempt(law, start, middle, contacts);
        const bool isEarly = endsEarly(law, start, shorter, middle);
        (isEarly ? high : low) = middle;
        if (isEarly) trial = shorter;
    }
    return high;
}

/// Contacts that press are kept without drift, in position and in velocity.
void BruteForce::project(const std::vector<Contact> &contacts, Motion &motion) const {
    for (int pass = 0; pass < 60; ++pass) {
        Real change = 0;
        for (const Contact &contact : contacts) {
            const Touch touch = touchOf(m_boxes[contact.box], motion.place, m_radius);
            const bool presses = contact.pressure > 0 && !contact.isMerged;
            if (!presses && touch.gap >= 0) continue;
            if (std::abs(touch.gap) > 1e-3L * m_radius) continue; // not a drift
            motion.place -= touch.gap * touch.normal;
            const Real speed = dot(touch.normal, motion.velocity);
            if (presses) motion.velocity -= speed * touch.normal;
            change = std::max(change, std::abs(touch.gap));
        }
        if (change <= m_touchTolerance / 2048) return;
    }
}

void BruteForce::pushOut(Motion &motion) const {
    for (int pass = 0; pass < 60; ++pass) {
        Real deepest = 0;
        for (const phys_box &box : m_boxes) {
            const Touch touch = touchOf(box, motion.place, m_radius);
            if (touch.gap < 0) motion.place -= touch.gap * touch.normal;
            deepest = std::min(deepest, touch.gap);
        }
        if (deepest >= -m_touchTolerance / 2048) return;
    }
}

/// Rolling model: on a floor the spin follows from the velocity; elsewhere it is constant.
void BruteForce::slaveSpin(const Law &law, const Motion &before, const std::vector<Contact> &contacts,
                           Motion &motion) const {
    if (law.isRigid) return;
    const bool isSupported = std::any_of(contacts.begin(), contacts.end(), [](const Contact &c) {
        return c.touch.isTop && c.pressure > 0 && !c.isMerged;
    });
    motion.spin = isSupported ? rollingSpin(motion.velocity, m_radius) : before.spin;
}

Real BruteForce::longestStep(const Law &law, const Motion &motion) const {
    const Real gravity = length(law.gravity);
    const Real bySpeed = m_radius / (8 * length(motion.velocity) + 1e-30L);
    const Real byGravity = gravity > 0 ? std::sqrt(m_radius / gravity) / 8 : bySpeed;
    return std::min(bySpeed, byGravity);
}

/// Inputs given in doubles touch exactly, or not at all.
void BruteForce::settle(Motion &motion) const {
    for (int pass = 0; pass < 60; ++pass) {
        for (const phys_box &box : m_boxes) {
            const Touch touch = touchOf(box, motion.place, m_radius);
            if (std::abs(touch.gap) <= m_givenTolerance) motion.place -= touch.gap * touch.normal;
        }
    }
}

bool BruteForce::run(const Law &law, Real duration, Motion &motion) {
    settle(motion);
    Real left = duration;
    while (true) {
        const std::vector<Touch> touches = touching(motion);
        if (collide(law, touches, m_touchTolerance, motion) && ++m_impacts > kMostImpacts) return false;
        if (left <= 0) {
            if (!law.isRigid && isAtRest(law, motion)) motion.spin = {}; // the law's convention
            return true;
        }

        std::vector<Contact> contacts = lasting(law, motion);
        Motion start = motion;
        const bool isOnTop =
            std::any_of(contacts.begin(), contacts.end(), [](const Contact &c) { return c.touch.isTop; });
        if (!law.isRigid && isOnTop) start.spin = rollingSpin(start.velocity, m_radius);

        Real h = std::min({m_suggested, longestStep(law, motion), left});
        Trial trial = attempt(law, start, h, contacts);
        bool isHit = false;
        while (true) {
            if (++m_steps > kMostSteps || m_updates > kMostUpdates) return false;
            isHit = endsEarly(law, start, trial, h);
            if (isHit) h = bracket(law, start, h, contacts, trial);
            // If a slip ends, all numbers of substeps lead to the same speeds, so the error estimate doesn't see that
            // they let the slip end at the beginning.
            const bool sticksTooSoon = endingSlip(law, start, trial) * h > m_tolerance * m_radius;
            if (sticksTooSoon) trial.error = std::max(trial.error, 2 * m_tolerance);
            if (trial.error <= m_tolerance || h <= kShortestStep) break;
            h = std::max(kShortestStep,
                         h * std::clamp<Real>(0.8L * std::pow(m_tolerance / trial.error, 0.25L), 0.1L, 0.5L));
            trial = attempt(law, start, h, contacts);
        }
        const Real growth = trial.error > 0 ? 0.8L * std::pow(m_tolerance / trial.error, 0.25L) : 4;
        if (!isHit || h * growth > m_suggested) m_suggested = h * std::clamp<Real>(growth, 0.1L, 4);
        m_suggested = std::max(m_suggested, kShortestStep);
        m_events += isHit || endingSlip(law, start, trial) > 0;
        slaveSpin(law, motion, trial.contacts, trial.end);
        motion = trial.end;
        project(trial.contacts, motion);
        if (isHit) pushOut(motion);
        m_way.push_back(motion.place);
        left = h == left ? 0 : left - h;
    }
}

bool BruteForce::isAtRest(const Law &law, const Motion &motion) const {
    const Real slow = 1e-12L * std::sqrt(length(law.gravity) * m_radius);
    if (length(motion.velocity) > slow || (law.isRigid && m_radius * length(motion.spin) > slow)) return false;
    std::vector<Contact> contacts = lasting(law, motion);
    return !contacts.empty() && length(implicitEuler(law, motion, 1e-3L, contacts).velocity) <= slow;
}

} // namespace witness
