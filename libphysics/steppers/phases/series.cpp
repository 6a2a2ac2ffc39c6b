// SPDX-License-Identifier: MIT
#include "phases/series.h"

#include "contact/held.h"

#include <algorithm>
#include <cmath>

namespace phys {

namespace {

constexpr double kNoForce = 1e-12; // relative to the accelerations
constexpr double kDirectionNoise = 4.0 * 0x1p-52;
constexpr double kKeptFor = 0.25; // of the unit: contacts that stick only by prestress are re-examined often

} // namespace

Vec3 freeAxes(const Moment &moment, std::span<const Held> held, const Response &response) {
    const double parallel = moment.rounding; // largest sine of the angle between normals that counts as parallel
    if (std::all_of(held.begin(), held.end(), isFace)) return Vec3(1.0);
    Vec3 first(0.0), line(0.0), free(1.0); // line: the direction that two of the normals leave free
    bool isFixed = false, isFlat = true;
    for (uint32_t i = 0; i < held.size(); ++i) {
        if (response.reactions[i].mode == Mode::open) continue;
        const Vec3 &n = held[i].normal;
        isFlat = isFlat && isFace(held[i]);
        isFixed = isFixed || std::abs(glm::dot(line, n)) > parallel;
        if (line == Vec3(0.0) && glm::length(glm::cross(first, n)) > parallel) line = hat(glm::cross(first, n));
        if (first == Vec3(0.0)) first = n;
        free *= Vec3(1.0) - held[i].across;
    }
    if (isFixed) free = Vec3(0.0);
    const bool isHeld = isFixed || (line != Vec3(0.0) && free != Vec3(0.0));
    return isHeld && !isFlat && free * moment.velocity == moment.velocity ? free : Vec3(1.0);
}

void Series::build(const Moment &moment, std::span<const Held> held, const Response &response, double unit,
                   uint32_t kept, double wanted) {
    take(moment, held, response, unit, kept);
    m_last = 1;
    for (; m_last < kOrder && !suffices(wanted / unit); ++m_last) {
        forces(m_last);
        move(m_last);
    }
    finish();
}

/// The contacts, and the terms of the motion that the response determines.
void Series::take(const Moment &moment, std::span<const Held> held, const Response &response, double unit,
                  uint32_t kept) {
    m_mirror = Mirror(moment, held);
    m_moment = m_mirror.seen(moment);
    m_reach.unit = unit;
    m_free = glm::abs(m_mirror.seen(freeAxes(moment, held, response)));
    const Sorted sorted(m_mirror, held);
    m_count = m_unknowns = m_turningNormals = 0;
    m_knownReserves = 0;
    m_rolls = m_slaved = kMostHeld;
    m_isSlaved = false;
    for (uint32_t i = 0; i < sorted.count; ++i) {
        const Reaction &reaction = response.reactions[sorted.index[i]];
        if (reaction.mode == Mode::open) continue;
        Contact &contact = m_contacts[m_count];
        m_index[m_count] = sorted.index[i];
        contact.held = sorted.held[i];
        contact.mode = reaction.mode;
        contact.isTurned = false;
        contact.isKept = kept >> sorted.index[i] & 1U;
        contact.n[0] = contact.held.normal;
        contact.isFlat = isFace(contact.held);
        contact.u[0] = reaction.mode == Mode::slipping ? m_mirror.seen(reaction.slip) : Vec3(0.0);
        contact.r[0] = m_mirror.seen(reaction.force);
        contact.N[0] = reaction.pressure;
        contact.d[0] = m_mirror.seen(reaction.direction);
        if (reaction.mode == Mode::sticking && contact.held.resistance > 0.0) m_rolls = m_count;
        m_turningNormals += contact.isFlat ? 0 : 1;
        ++m_count;
    }
    findPartners();
    for (Contact &contact : contacts()) {
        contact.column = m_unknowns;
        const bool isVector = contact.mode == Mode::sticking || contact.mode == Mode::spent;
        m_unknowns += isVector ? 3 : contact.mode == Mode::starting ? 4 : 1;
    }
    begin(response);
    findPrestressed(response);
    findShared();
}

/// After the last term: terms that aren't computed are zero.
void Series::finish() {
    for (int k = m_last; k <= kOrder; ++k) {
        m_a[k] = m_al[k] = m_rolling[k] = Vec3(0.0);
        for (Contact &contact : contacts()) {
            contact.r[k] = Vec3(0.0);
            contact.N[k] = 0.0;
            if (contact.mode != Mode::slipping) contact.d[k] = Vec3(0.0);
        }
        if (k == m_last) continue;
        m_p[k] = m_v[k] = m_om[k] = m_turning[k] = Vec3(0.0);
        m_turningSpeed[k] = 0.0;
        for (Contact &contact : contacts()) contact.n[k] = Vec3(0.0);
    }
    if (m_last == kOrder) m_valid = validSoFar(); // fewer terms have been found to suffice
    m_reach.measure(m_valid);
    m_most = m_a.most(m_reach.length);
    m_turns = Vec3(0.0);
    for (int k = kOrder; k >= 1; --k) m_turns = m_reach.length * m_turns + double(k) * glm::abs(m_a[k]);
    // The direction of a slip with few digits has few digits itself, and so have the forces.
    m_noForce = kNoForce * accelerationScale(m_moment);
    for (const Contact &contact : contacts()) {
        if (contact.mode != Mode::slipping || contact.partner < m_count) continue;
        m_noForce +=
            contact.held.friction * contact.N[0] * kDirectionNoise * speedScale(m_moment) / glm::length(contact.u[0]);
    }
}

/// Slips that start while one other contact sticks: the ball turns about the line through both.
void Series::findPartners() {
    uint32_t sticking = 0, partner = kMostHeld;
    for (uint32_t i = 0; i < m_count; ++i) {
        m_contacts[i].partner = kMostHeld;
        if (m_contacts[i].mode != Mode::sticking) continue;
        ++sticking;
        partner = i;
    }
    if (sticking != 1) return;
    for (Contact &contact : contacts()) {
        if (contact.mode != Mode::starting) continue;
        const Vec3 free = glm::cross(contact.n[0], m_contacts[partner].n[0]);
        if (free == Vec3(0.0)) continue;
        contact.partner = partner;
        contact.mode = Mode::slipping;
    }
}

void Series::begin(const Response &response) {
    m_p[0] = Vec3(0.0);
    m_v[0] = m_moment.velocity;
    m_om[0] = m_moment.spin;
    m_a[0] = m_free * m_mirror.seen(response.acceleration);
    m_al[0] = m_mirror.seenSpin(response.spinAcceleration);
    m_rolling[0] = m_mirror.seenSpin(response.rolling);
    m_rollStarts = false;
    if (m_rolls < m_count) {
        const Vec3 n = m_contacts[m_rolls].held.normal;
        if (m_rolling[0] == Vec3(0.0))
            m_rolls = kMostHeld;
        else if (isNoSlip(m_moment, m_moment.radius * tangential(m_om[0], n)))
            m_rollStarts = true;
        else
            rollingDirection(0);
    }
    for (Contact &contact : contacts()) {
        if (contact.mode == Mode::slipping) directions(contact, 0);
        contact.rateKnown = m_a[0] - m_moment.radius * glm::cross(m_al[0], contact.n[0]) -
                            glm::cross(m_om[0], contact.held.across * m_v[0]);
    }
    weighSlips();
    move(0);
}

/// From the accelerations of order k to the motion of order k + 1, and the directions that follow from it.
void Series::move(int k) {
    const double step = unit() / (k + 1);
    if (m_countsSlips) findPace(k);
    const auto paced = [&](const VecJet &rate) { return !m_countsSlips ? rate[k] : termOf(m_pace, rate, k); };
    m_p[k + 1] = step * paced(m_v);
    m_v[k + 1] = step * paced(m_a);
    m_om[k + 1] = step * paced(m_al);
    for (Contact &contact : contacts()) {
        contact.n[k + 1] = contact.isFlat ? Vec3(0.0) : contact.held.across * m_p[k + 1] / m_moment.radius;
    }
    for (Contact &contact : contacts()) {
        contact.u[k + 1] = Vec3(0.0);
        if (contact.mode == Mode::slipping) {
            contact.u[k + 1] = m_v[k + 1] + m_moment.radius * contact.crossNormal(m_om, k + 1);
            directions(contact, k + 1);
        } else if (contact.mode == Mode::starting || contact.mode == Mode::spent) {
            if (k > 0 || contact.mode == Mode::starting) contact.u[k + 1] = step * contact.rateKnown;
            directions(contact, k);
        }
    }
    if (m_rolls < m_count) rollingDirection(m_rollStarts ? k : k + 1);
}

/// How fast the slips change, or would by friction alone. Nothing is counted if a slip or rolling starts, which has
/// singular series of its own.
void Series::weighSlips() {
    m_countsSlips = false;
    m_known.fill({0.0, 0.0});
    for (Contact &contact : contacts()) {
        contact.weight = 0.0;
        if (contact.mode != Mode::slipping || contact.N[0] <= kNoForce * accelerationScale(m_moment)) continue;
        const double byFriction = kSlipPerFriction * contact.held.friction * contact.N[0];
        contact.weight = std::max(byFriction, glm::length(contact.rateKnown)) / glm::length(contact.u[0]);
        m_countsSlips = true;
    }
    for (const Contact &contact : contacts()) {
        if (startsToSlip(contact) || m_rollStarts) m_countsSlips = false;
    }
}

/// Terms of dt/dsigma = w: 1/w is the weighted mean of 1 and of u_0/u of each slip.
void Series::findPace(int k) {
    double all = std::sqrt(accelerationScale(m_moment) / m_moment.radius), sum = k == 0 ? all : 0.0;
    for (Contact &contact : contacts()) {
        if (contact.weight == 0.0) continue;
        contact.slowness[k] = reciprocalTerm(contact.speed, contact.slowness, k);
        all += contact.weight;
        sum += contact.weight * contact.speed[0] * contact.slowness[k];
    }
    m_inversePace[k] = sum / all;
    m_pace[k] = reciprocalTerm(m_inversePace, m_pace, k);
    m_pace[k + 1] = m_time[0] = 0.0;
    m_time[k + 1] = unit() / (k + 1) * m_pace[k];
}

double Series::timeAt(double s) const { return !m_countsSlips || s == kNever ? unit() * s : m_time.at(s); }

/// The inverse of timeAt.
double Series::placeOf(double t) const {
    if (!m_countsSlips) return t / unit();
    if (m_known[0].time != t) std::swap(m_known[0], m_known[1]);
    if (m_known[0].time != t) m_known[0] = {t, phys::placeOf(m_time, m_pace, unit(), t, m_reach.length)};
    return m_known[0].place;
}

/// Integral over the time until s, in units.
double Series::integral(const Jet &rate, double s) const {
    if (!m_countsSlips) return unit() * rate.integralAt(s);
    return unit() * product(m_pace, rate).integralAt(s);
}

/// Term k of hat(om_t); for a ball that starts from rest, of om_t divided by the time.
void Series::rollingDirection(int k) {
    const int shift = m_rollStarts ? 1 : 0;
    m_turning[k + shift] = tangential(m_om[k + shift], m_contacts[m_rolls].held.normal);
    addDirectionTerm(&m_turning[shift], k, m_turningSpeed, m_rolling);
}

/// For a ball that starts to roll: the spin acceleration contributes to the resistance, which turns with it.
Vec3 Series::steadied(const Vec3 &al, int k) const {
    if (!m_rollStarts) return al;
    const Contact &contact = m_contacts[m_rolls];
    const double growth =
        kInertia * contact.held.resistance / m_moment.radius * contact.N[0] * unit() / (m_turningSpeed[0] * (k + 1));
    const Vec3 &n = contact.held.normal;
    const Vec3 across = al - glm::dot(al, n) * n - glm::dot(al, m_rolling[0]) * m_rolling[0];
    return al - growth / (1.0 + growth) * across;
}

/// Term k of a direction, from its turn.
void Series::turn(Contact &contact, int k) {
    if (k == 0) return;
    const Vec3 n0 = contact.n[0], d0 = contact.d[0];
    double alongD = 0.0, alongN = -glm::dot(d0, contact.n[k]);
    for (int j = 1; j < k; ++j) {
        alongD -= 0.5 * glm::dot(contact.d[j], contact.d[k - j]);
        alongN -= glm::dot(contact.d[k - j], contact.n[j]);
    }
    contact.d[k] = alongD * d0 + contact.turn[k] * glm::cross(n0, d0) + alongN * n0;
}

/// Direction of the slip, term k.
void Series::directions(Contact &contact, int k) {
    if (contact.isTurned) return turn(contact, k);
    if (contact.mode == Mode::spent) {
        if (k == 0) return;
        const Vec3 e = glm::cross(contact.n[0], contact.d[0]);
        double alongE = 0.0;
        Vec3 friction = contact.r[k];
        for (int j = 0; j <= k; ++j) friction -= contact.N[k - j] * contact.n[j];
        for (int j = 1; j < k; ++j) alongE -= contact.N[k - j] * glm::dot(contact.d[j], e);
        contact.turn[k] = (alongE - glm::dot(friction, e) / contact.held.friction) / contact.N[0];
        return turn(contact, k);
    }
    if (contact.partner < m_count) {
        const VecJet &other = m_contacts[contact.partner].n;
        const double sense = glm::dot(contact.d[0], glm::cross(contact.n[0], other[0])) > 0.0 ? 1.0 : -1.0;
        contact.free[k] = sense * contact.crossNormal(other, k);
        addDirectionTerm(&contact.free[0], k, contact.speed, contact.d);
        return;
    }
    // The slip itself, or its quotient by the time if it starts.
    addDirectionTerm(&contact.u[contact.mode == Mode::starting ? 1 : 0], k, contact.speed, contact.d);
}

void Series::forces(int k) {
    for (Contact &contact : contacts()) knownForces(contact, k);
    knownAccelerations(k);
    solveOrder(k);
}

/// The contribution of lower-order terms to term k of a contact's force.
void Series::knownForces(Contact &contact, int k) {
    Vec3 force(0.0);
    contact.N[k] = 0.0;
    const double mu = contact.held.friction;
    switch (contact.mode) {
    case Mode::slipping:
        for (int j = 1; j <= k; ++j) force -= contact.N[k - j] * contact.d[j];
        force *= mu;
        [[fallthrough]];
    case Mode::smooth:
        for (int j = 1; j <= contact.lastNormal(k); ++j) force += contact.N[k - j] * contact.n[j];
        break;
    case Mode::starting: {
        contact.u[k + 1] = Vec3(0.0);
        directions(contact, k);
        contact.directionKnown = Vec3(0.0);
        for (int j = 1; j <= k; ++j) contact.directionKnown += contact.N[k - j] * (contact.n[j] - mu * contact.d[j]);
        break;
    }
    default:
        for (int j = 1; j <= contact.lastNormal(k); ++j) contact.N[k] += glm::dot(contact.r[k - j], contact.n[j]);
    }
    contact.r[k] = force;
}

/// The accelerations of order k and the slips' rates without the contribution of the unknowns.
void Series::knownAccelerations(int k) {
    const double R = m_moment.radius;
    m_a[k] = k == 0 ? m_moment.gravity : Vec3(0.0);
    m_al[k] = Vec3(0.0);
    for (const Contact &contact : contacts()) {
        m_a[k] += contact.r[k];
        if (contact.mode != Mode::smooth) m_al[k] -= kInertia / R * contact.crossNormal(contact.r, k);
    }
    if (m_rolls < m_count) {
        const Contact &contact = m_contacts[m_rolls];
        if (m_rollStarts) {
            m_om[k + 1] = Vec3(0.0);
            rollingDirection(k);
        }
        m_al[k] -= kInertia * contact.held.resistance / R * termOf(contact.N, m_rolling, k);
        m_al[k] = steadied(m_al[k], k);
    }
    for (Contact &contact : contacts()) {
        if (!contact.needsRate()) continue;
        contact.rateKnown = m_a[k] + R * contact.crossNormal(m_al, k);
        for (int j = 0; j <= k && !contact.isFlat; ++j)
            contact.rateKnown -= glm::cross(m_om[j], contact.held.across * m_v[k - j]);
    }
}

/// How long the equations, in units, can't tell which of two edges presses whose normals are nearly the same and turn
/// apart: as the ball leaves a corner of a floor round both. model.md 14.1.
double Series::blindUntil() const {
    constexpr double kApart = 4e-6; // rad: the equations see the square of the angle
    double until = kNever;
    for (uint32_t i = 1; i < m_count; ++i) {
        for (uint32_t j = 0; j < i; ++j) {
            const Contact &a = m_contacts[i], &b = m_contacts[j];
            if (a.held.across == b.held.across || squared(a.n[0] - b.n[0]) > kApart * kApart) continue;
            until = std::min(until, kApart / glm::length(a.n[1] - b.n[1]));
        }
    }
    return until;
}

/// How far the terms so far are valid, in units.
double Series::validSoFar() const {
    VecJet turning;
    bool slips = false;
    for (const int k : {0, 1, 2, m_last - 1, m_last}) turning[k] = m_moment.radius * m_om[k];
    const double noise = kNoise * speedScale(m_moment);
    Validity motion(m_last), forces(m_last - 1);
    motion.add(m_v, noise).add(turning, noise);
    if (m_countsSlips) motion.add(m_time, 0.0);
    for (const Contact &contact : contacts()) slips = slips || contact.mode != Mode::sticking;
    for (const Contact &contact : contacts()) {
        if (!slips) forces.add(contact.r, 0.0);
    }
    double s = std::min({motion.until(), forces.until(), blindUntil()});
    for (const Contact &contact : contacts()) s = contact.isKept ? std::min(s, kKeptFor / 0.8) : s;
    return s;
}

/// Whether the terms so far are enough for a time, in units. Directions of slips need all.
bool Series::suffices(double s) {
    constexpr int kFirst = 8, kEach = 4;
    if (m_last < kFirst || m_last % kEach != 0 || m_rollStarts) return false;
    const bool slips = std::any_of(contacts().begin(), contacts().end(), [](const Contact &contact) {
        return contact.mode != Mode::smooth && contact.mode != Mode::sticking;
    });
    if (slips) return false;
    m_valid = validSoFar();
    return 0.8 * m_valid >= std::max(s, 0.125);
}

Way Series::at(double t) const {
    const double s = placeOf(t);
    return {m_mirror.back(m_p.at(s)), m_mirror.back(m_v.at(s))};
}

Vec3 Series::spinAt(double t) const { return m_mirror.backSpin(m_om.at(placeOf(t))); }

double Series::least(const Vec3 &n, double, double t, double until) const {
    const Vec3 seen = m_mirror.seen(n);
    const double s = placeOf(t);
    return glm::dot(seen, m_a.at(s)) - glm::dot(glm::abs(seen), m_turns) * (placeOf(until) - s);
}

std::array<double, kMostHeld> Series::pressures(double t) const {
    const double s = placeOf(t);
    std::array<double, kMostHeld> pressures{};
    for (uint32_t i = 0; i < m_count; ++i) pressures[given(i)] = m_contacts[i].N.at(s);
    return pressures;
}

Jet Series::slipSpeed(const Contact &contact) const {
    if (contact.mode == Mode::slipping && contact.partner == kMostHeld) return contact.speed;
    return dot(contact.u, contact.d);
}

bool Series::startsToSlip(const Contact &contact) const {
    return contact.mode == Mode::starting || contact.mode == Mode::spent || contact.partner < m_count;
}

/// Speed of a slip that starts, divided by the power of the time that it starts with: it may come back to zero. How far
/// it is accurate, in units.
std::pair<Jet, double> Series::startOfSlip(const Contact &contact) const {
    const Jet speed = slipSpeed(contact);
    const bool isAccelerated = contact.mode != Mode::spent && std::abs(speed[1]) > m_noForce * unit();
    const int power = isAccelerated ? 1 : 2;
    Jet left;
    for (int k = 0; k <= kOrder; ++k) left[k] = k + power < kOrder ? speed[k + power] : 0.0;
    return {left, 0.8 * Validity(kOrder - 1 - power).add(left, speedScale(m_moment)).until()};
}

/// Whether the pressure of a contact is rounding until s. Its friction then moves nothing, and the series of its slip's
/// direction needn't be valid.
bool Series::isIdle(const Contact &contact, double s) const { return contact.N.most(s) <= m_noForce; }

/// Share of the spin that resistance opposes: less than all where another sticking contact, nearly opposite, leaves the
/// ball a line to turn about.
double Series::shareOfRolling() const {
    const double whole = glm::length(m_om[0]);
    return otherSticking(m_contacts[m_rolls]) && whole > 0.0 ? m_turningSpeed[0] / whole : 1.0;
}

End Series::end(double until, Work &work) const {
    End end{length(), Cause::time, 0}; // in units, until the end
    const double s = until < horizon() ? placeOf(until) : length();
    const double speed = speedScale(m_moment);
    end.cut({endOfPrestress(s, work), Cause::spent, 0});
    for (uint32_t i = 0; i < m_count; ++i) {
        const Contact &contact = m_contacts[i];
        Jet force = contact.N;
        if (force[0] <= m_noForce) force[0] += m_noForce;
        if (!isPrestressed(contact)) end.cut({firstFall(force, s, work), Cause::release, given(i)});
        if (isIdle(contact, s)) continue;
        if (startsToSlip(contact)) {
            const auto [left, good] = startOfSlip(contact);
            end.cut({firstFall(left, std::min(s, good), work), Cause::grip, given(i)});
            end.cut({good, Cause::time, 0});
        } else if (contact.mode == Mode::slipping) {
            end.cut(endOfSlip(contact.speed, s, m_reach, kSlipEnds * speed, speed, given(i), work));
        } else if (contact.mode == Mode::sticking && !contact.held.isGlued && !contact.isKept &&
                   !holdsUntil(contact, s)) {
            auto [left, none] = reserveOf(contact);
            if (left[0] <= none) left[0] += none + m_noForce * m_noForce;
            end.cut({firstFall(left, s, work), Cause::spent, given(i)});
        }
    }
    if (m_rolls < m_count && !m_rollStarts) {
        const Jet left = sum(0.0, m_moment.radius, m_turningSpeed);
        end.cut(zeroOfSpeed(left, s, m_reach, kSlipEnds * shareOfRolling() * speed, Cause::stop, given(m_rolls), work));
    }
    end.after = timeAt(end.after);
    return end;
}

Losses Series::losses(double t) const {
    const double s = placeOf(t);
    Losses lost;
    for (const Contact &contact : contacts()) {
        if (contact.mode == Mode::sticking || contact.mode == Mode::smooth || isIdle(contact, s)) continue;
        const Jet power = product(contact.N, slipSpeed(contact));
        lost.slip += integral(sum(0.0, contact.held.friction, power), s);
    }
    if (m_rolls < m_count) {
        const Contact &contact = m_contacts[m_rolls];
        const Jet power = product(contact.N, dot(m_om, m_rolling));
        lost.rolling += integral(sum(0.0, contact.held.resistance * m_moment.radius, power), s);
    }
    return lost;
}

} // namespace phys
