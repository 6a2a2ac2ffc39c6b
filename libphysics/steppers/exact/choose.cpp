// SPDX-License-Identifier: MIT
// Which motion the lasting contacts make: model.md 8.1 and 14.
#include "base/error.h"
#include "contact/held.h"
#include "exact/exact_step.h"

#include <algorithm>
#include <cmath>

namespace phys {

namespace {

/// Whether b points along a line that a has, either way, but for rounding.
bool isCollinear(const Vec3 &a, const Vec3 &b) {
    const auto isRounding = [](const Vec3 &across, double squares) {
        return glm::dot(across, across) <= 16.0 * kRounding * kRounding * squares;
    };
    const double squares = glm::dot(a, a) * glm::dot(b, b);
    if (squares > 1e-100 && squares < 1e100) return isRounding(glm::cross(a, b), squares);
    return isRounding(glm::cross(hat(a), hat(b)), 1.0);
}

/// s: longer than any step. What moves so slowly that its squares underflow has no time of its own.
constexpr double kLongestUnit = 0x1p100;

} // namespace

phys_status ExactStep::respondNow() {
    m_response = respond(m_ball.moment(), m_touching.held(), m_ball.work);
    if (const phys_status status = m_ball.checkWork()) return status;
    return m_response.isFound ? PHYS_OK : jam();
}

/// No modes fit: friction drives the reactions beyond all bounds, an impact without a collision. Slips end, within
/// Coulomb's cones if modes fit then.
phys_status ExactStep::jam() {
    Moment jammed = m_ball.moment();
    if (endSlips(jammed, m_touching.held(), m_ball.work)) takeJammed(jammed);
    if (!m_response.isFound) {
        stopSlips(jammed, m_touching.held(), m_ball.work);
        takeJammed(jammed);
    }
    if (m_response.isFound) return PHYS_OK;
    if (const phys_status status = m_ball.checkWork()) return status;
    return fail(m_ball.error, PHYS_ERROR_STUCK, "the ball at (%.9g, %.9g, %.9g) is jammed by friction",
                m_ball.position.x, m_ball.position.y, m_ball.position.z);
}

void ExactStep::takeJammed(const Moment &jammed) {
    const double R = m_ball.radius();
    const auto energy = [R](const Vec3 &v, const Vec3 &spin) {
        return 0.5 * glm::dot(v, v) + 0.2 * R * R * glm::dot(spin, spin);
    };
    m_ball.report.lostSlip(energy(m_ball.motion.velocity, m_ball.motion.spin) - energy(jammed.velocity, jammed.spin));
    m_ball.motion = {jammed.velocity, jammed.spin};
    m_response = respond(m_ball.moment(), m_touching.held(), m_ball.work);
}

uint32_t ExactStep::closedBits() const {
    uint32_t bits = 0;
    for (uint32_t i = 0; i < m_touching.count(); ++i) {
        if (isClosed(i)) bits |= 1U << m_touching.numberOf(i);
    }
    return bits;
}

bool ExactStep::restsNow() const {
    if (m_ball.motion.velocity != Vec3(0.0)) return false;
    if (glm::length(m_response.acceleration) > m_response.noise) return false;
    if (glm::length(m_response.spinAcceleration) * m_ball.radius() > m_response.noise) return false;
    for (uint32_t i = 0; i < m_touching.count(); ++i) {
        const Mode mode = m_response.reactions[i].mode;
        if (mode == Mode::slipping || mode == Mode::starting) return false;
    }
    return true;
}

/// Whether all accelerations stay as they are: only faces press, or smooth contacts that let the ball move along an
/// axis alone, and slips and resistance keep their directions.
bool ExactStep::isUniform(const Vec3 &free) const {
    const bool isTurningOnly = m_ball.motion.velocity == Vec3(0.0) && m_response.acceleration == Vec3(0.0);
    if (isTurningOnly && m_response.spinAcceleration == Vec3(0.0)) return true;
    for (uint32_t i = 0; i < m_touching.count(); ++i) {
        const Reaction &reaction = m_response.reactions[i];
        if (reaction.mode == Mode::open) continue;
        if (m_touching.contactOf(i).isFace() && reaction.pressure == 0.0)
            continue; // amid two walls that are a ball apart
        if (!m_touching.contactOf(i).isFace() && (reaction.mode != Mode::smooth || free == Vec3(1.0))) return false;
        if (reaction.mode == Mode::slipping) {
            const Vec3 rate = m_response.acceleration -
                              m_ball.radius() * glm::cross(m_response.spinAcceleration, m_touching.held(i).normal);
            if (!isCollinear(reaction.slip, rate)) return false;
        }
        if (reaction.mode == Mode::sticking && m_touching.held(i).resistance > 0.0 && m_response.rolling != Vec3(0.0)) {
            Vec3 turning = m_response.spinAcceleration;
            turning -= glm::dot(turning, m_touching.held(i).normal) * m_touching.held(i).normal;
            const double across = glm::length(glm::cross(m_response.rolling, turning));
            if (across * m_ball.radius() > m_response.noise && !isCollinear(m_response.rolling, turning)) return false;
        }
    }
    return true;
}

/// Whether a single face presses, and which contact that is.
bool ExactStep::isAlone(uint32_t &closed) const {
    closed = kMostHeld;
    for (uint32_t i = 0; i < m_touching.count(); ++i) {
        if (!isClosed(i)) continue;
        if (closed != kMostHeld || !m_touching.contactOf(i).isFace()) return false;
        closed = i;
    }
    return closed != kMostHeld;
}

/// Whether the ball slips on one face, leans on a smooth one across it, surely, and touches nothing else.
bool ExactStep::slides(Slide::Faces &faces) const {
    faces.rough = faces.smooth = kMostHeld;
    for (uint32_t i = 0; i < m_touching.count(); ++i) {
        if (!isClosed(i)) continue;
        const Mode mode = m_response.reactions[i].mode;
        uint32_t &place = mode == Mode::slipping ? faces.rough : faces.smooth;
        if (place != kMostHeld || !m_touching.contactOf(i).isFace()) return false;
        if (mode != Mode::slipping && mode != Mode::smooth) return false;
        place = i;
    }
    if (faces.rough == kMostHeld || faces.smooth == kMostHeld) return false;
    faces.roughAxis = axisOf(m_touching.contactOf(faces.rough));
    faces.smoothAxis = axisOf(m_touching.contactOf(faces.smooth));
    const double friction = m_touching.held(faces.rough).friction * m_response.reactions[faces.rough].pressure;
    const double least = 0.01 * friction + 1e-9 * accelerationScale(m_ball.moment());
    return faces.roughAxis != faces.smoothAxis && m_response.reactions[faces.smooth].pressure > least;
}

/// A ball that stays where it is turns about the normals of what it sticks to, if at all.
void ExactStep::keepFixed() {
    if (m_ball.motion.velocity != Vec3(0.0) || m_response.acceleration != Vec3(0.0)) return;
    Vec3 &turning = m_response.spinAcceleration;
    for (uint32_t i = 0; i < m_touching.count(); ++i) {
        const Vec3 &n = m_touching.held(i).normal;
        if (m_response.reactions[i].mode == Mode::sticking) turning = glm::dot(turning, n) * n;
    }
}

/// Nothing is left of the velocity of a ball that resistance holds: it was rounding, model.md 14.1.
void ExactStep::stopHeld() {
    if (m_response.rolling != Vec3(0.0) || m_ball.isStill()) return;
    for (uint32_t i = 0; i < m_touching.count(); ++i) {
        if (m_response.reactions[i].mode != Mode::sticking || m_touching.held(i).resistance == 0.0) continue;
        if (!isNoSlip(m_ball.moment(), m_ball.motion.velocity)) return;
        const Vec3 &n = m_touching.held(i).normal;
        const Vec3 pivoting = glm::dot(m_ball.motion.spin, n) * n;
        if (!isNoSlip(m_ball.moment(), m_ball.radius() * (m_ball.motion.spin - pivoting))) continue;
        const bool pivots = countSticking() == 1 || !isNoSlip(m_ball.moment(), m_ball.radius() * pivoting);
        m_ball.motion = {Vec3(0.0), pivots ? pivoting : Vec3(0.0)};
    }
}

/// Most phases of most scenes: a ball rolls along a curve over one floor, and nothing else is touched. False if it
/// isn't that plain.
bool ExactStep::rollsOn(Phase &phase) {
    const double R = m_ball.radius(), pressure = -m_ball.params().gravity.z,
                 resistance = m_ball.params().rolling_friction * pressure;
    const bool isOnFloor =
        m_touching.count() == 1 && m_touching.contactOf(0).isTop && m_touching.contactOf(0).isFace() && pressure > 0.0;
    if (!isOnFloor || m_ball.motion.velocity.z != 0.0 || !(resistance > 0.0)) return false;
    const Vec3 level(m_ball.params().gravity.x, m_ball.params().gravity.y, 0.0), up(0.0, 0.0, 1.0);
    if (!turnsAgainst(level, resistance)) return false;
    if (m_ball.setting.isRigid()) {
        if (2.0 / 7.0 * glm::length(level) > m_ball.params().sliding_friction * pressure) return false;
        if (!isNoSlip(m_ball.moment(), slipAt(m_ball.moment(), up))) return false;
    }
    if (isNoSlip(m_ball.moment(), R * Vec3(m_ball.motion.spin.x, m_ball.motion.spin.y, 0.0))) return false;
    phase = Resisted::rolling(2, m_ball.motion.velocity, 5.0 / 7.0 * level, 5.0 / 7.0 * resistance, R,
                              m_ball.motion.spin, up);
    m_response.count = 1;
    m_response.reactions[0] = {Mode::sticking, pressure, Vec3(0.0), Vec3(0.0), Vec3(0.0)};
    m_response.acceleration = level;
    return true;
}

/// Whether the way of a rolling ball surely bends: its velocity has a direction of its own beside the drive.
bool ExactStep::turnsAgainst(const Vec3 &drive, double resistance) const {
    constexpr double kLeast = 1e-10; // sine of the angle between the velocity and how it changes
    const Vec3 &v = m_ball.motion.velocity;
    const double across = v.x * drive.y - v.y * drive.x, most = kLeast * (glm::length(drive) + resistance);
    return across * across > most * most * glm::dot(v, v);
}

phys_status ExactStep::choose(Phase &phase) {
    if (rollsOn(phase)) {
        m_isAnswered = true;
        noteContacts();
        return PHYS_OK;
    }
    if (const phys_status status = respondNow()) return status;
    m_isAnswered = true;
    const Vec3 free = freeAxes(m_ball.moment(), m_touching.held(), m_response);
    m_response.acceleration *= free;
    keepFixed();
    stopHeld();
    const Vec3 g = m_ball.setting.gravity();
    uint32_t closed = kMostHeld;
    if (!m_ball.setting.isRigid() && restsNow()) {
        m_ball.report.lostSlip(0.2 * m_ball.radius() * m_ball.radius() *
                               glm::dot(m_ball.motion.spin, m_ball.motion.spin));
        m_ball.motion.spin = Vec3(0.0);
    }
    if (restsNow()) {
        phase = Uniform{Vec3(0.0), Vec3(0.0), m_ball.motion.spin, Vec3(0.0)};
    } else if (isUniform(free)) {
        const Vec3 &a = m_response.acceleration, &v = m_ball.motion.velocity;
        phase = Uniform{v, a, m_ball.motion.spin, m_response.spinAcceleration};
    } else if (isAlone(closed)) {
        const Held &face = m_touching.held(closed);
        const Reaction &reaction = m_response.reactions[closed];
        const int axis = face.normal.x != 0.0 ? 0 : face.normal.y != 0.0 ? 1 : 2;
        Vec3 along = g;
        along[axis] = 0.0;
        if (reaction.mode == Mode::slipping) {
            phase =
                Resisted::slipping(axis, m_ball.motion.velocity, reaction.slip, along,
                                   face.friction * reaction.pressure, m_ball.radius(), m_ball.motion.spin, face.normal);
        } else {
            phase = Resisted::rolling(axis, m_ball.motion.velocity, 5.0 / 7.0 * along,
                                      5.0 / 7.0 * (face.resistance * reaction.pressure), m_ball.radius(),
                                      m_ball.motion.spin, face.normal);
        }
    } else if (Slide::Faces faces; slides(faces)) {
        const Held &rough = m_touching.held(faces.rough);
        phase.emplace<Slide>(m_ball.moment(), faces, rough.normal, m_response.reactions[faces.rough], rough.friction,
                             m_response.reactions[faces.smooth]);
    } else {
        buildSeries(phase.emplace<Series>());
    }
    noteContacts();
    return PHYS_OK;
}

/// Series in the unit of time that suits them, with the modes that hold in the moments to come.
void ExactStep::buildSeries(Series &series) {
    const double R = m_ball.radius();
    const double scale = glm::length(m_ball.setting.gravity()) + glm::length(m_response.acceleration) +
                         glm::dot(m_ball.motion.velocity, m_ball.motion.velocity) / R;
    double unit = std::min(std::sqrt(R / scale), kLongestUnit);
    for (uint32_t i = 0; i < m_touching.count(); ++i) {
        if (m_response.reactions[i].mode != Mode::slipping) continue;
        unit = std::min(unit, 3.0 * glm::length(m_response.reactions[i].slip) / scale);
    }
    const double turning = std::abs(glm::dot(m_ball.motion.spin, m_response.rolling));
    if (turning > 0.0) unit = std::min(unit, turning / glm::length(m_response.spinAcceleration));
    const double longest = std::max(unit, m_ball.left);
    Excluded excluded;
    uint32_t spent = 0, kept = 0, together = 0;
    std::array<Vec3, kMostHeld> slips{}; // directions of those that are spent
    for (int change = 0; change < 8; ++change) {
        bool hasShrunk = false;
        for (int guess = 0; guess < 40; ++guess) {
            Response response = m_response;
            for (uint32_t i = 0; i < m_touching.count(); ++i) {
                if (!(spent >> i & 1U)) continue;
                response.reactions[i].mode = Mode::spent;
                response.reactions[i].direction = slips[i];
            }
            series.build(m_ball.moment(), m_touching.held(), response, unit, kept);
            m_ball.work.add(Work::kSeries * (1 + series.unknowns()));
            const bool isLong = series.horizon() > 3.0 * unit && unit < longest && !hasShrunk;
            if (series.horizon() >= 0.1 * unit && !isLong) break;
            hasShrunk = !isLong;
            unit = isLong ? std::min(4.0 * unit, longest) : std::max(series.suitableUnit(), 0x1p-8 * unit);
        }
        if (together && series.slipsBack(together)) {
            spent &= ~together;
            kept |= together;
            together = 0;
            continue;
        }
        const uint32_t opening = series.opening() & ~excluded.closed;
        const uint32_t slipping = series.spent(slips) & ~(spent | kept);
        if (!opening && !slipping) return;
        if (!opening && countSticking() == 1 && excluded.sticking == 0) {
            spent |= slipping;
            withoutResistance(slipping);
            continue;
        }
        // Of contacts that stick together one starts in the direction that another leaves it, or else two at once.
        excluded.closed |= opening;
        excluded.sticking |= opening ? 0 : slipping;
        const Response changed = respond(m_ball.moment(), m_touching.held(), m_ball.work, excluded);
        if (changed.isFound && (opening || countSticking() != 2 || startsBeside(changed))) {
            m_response = changed;
            continue;
        }
        excluded.sticking &= ~slipping;
        excluded.closed &= ~opening;
        if (opening) return;
        auto pressed = m_response.reactions;
        together = series.spentTogether(pressed, slips);
        if (together) m_response.reactions = pressed;
        spent |= together;
        kept |= together ? 0 : slipping;
    }
}

/// Whether one contact starts to slip while another one sticks.
bool ExactStep::startsBeside(const Response &response) const {
    bool starts = false, sticks = false;
    for (const Reaction &reaction : response.list()) {
        starts = starts || reaction.mode == Mode::starting;
        sticks = sticks || reaction.mode == Mode::sticking;
    }
    return starts && sticks;
}

/// A ball that begins to slip rolls no longer, so that nothing resists its rolling.
void ExactStep::withoutResistance(uint32_t slipping) {
    bool resists = false;
    for (uint32_t i = 0; i < m_touching.count(); ++i) {
        if (!(slipping >> i & 1U) || m_touching.held(i).resistance == 0.0) continue;
        m_touching.held(i).resistance = 0.0;
        resists = true;
    }
    if (!resists) return;
    const Response free = respond(m_ball.moment(), m_touching.held(), m_ball.work);
    if (free.isFound) m_response = free;
}

uint32_t ExactStep::countSticking() const {
    uint32_t count = 0;
    for (uint32_t i = 0; i < m_touching.count(); ++i) count += m_response.reactions[i].mode == Mode::sticking ? 1 : 0;
    return count;
}

/// Reports which contacts begin to last, and which end without an impact.
void ExactStep::noteContacts() {
    if (!m_ball.report.wanted()) return;
    bool supported = false;
    uint32_t wall = PHYS_NO_BOX, place = 0;
    for (uint32_t i = 0; i < m_touching.count(); ++i) {
        if (!isClosed(i)) continue;
        if (m_touching.contactOf(i).isTop) {
            supported = true;
        } else {
            wall = m_touching.contactOf(i).box;
            place = i;
        }
    }
    const double speed = glm::length(m_ball.motion.velocity);
    if (m_ball.elapsed > 0.0) {
        if (m_supported && !supported) m_ball.event(PHYS_EVENT_TAKEOFF, speed, speed);
        if (wall != PHYS_NO_BOX && m_wall == PHYS_NO_BOX) {
            const Contact &contact = m_touching.contactOf(place);
            m_ball.event(PHYS_EVENT_CONTACT, contact, speed, speed);
        }
        if (wall == PHYS_NO_BOX && m_wall != PHYS_NO_BOX) {
            const Nearest left = nearest(m_ball.scene().boxes[m_wall], m_ball.position);
            m_ball.report.event(PHYS_EVENT_RELEASE, m_ball.elapsed, left.point, left.normal, speed, speed,
                                m_ball.scene().givenBox(m_wall, left.point));
        }
    }
    m_supported = supported;
    m_wall = wall;
}

} // namespace phys
