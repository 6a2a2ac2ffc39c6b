// SPDX-License-Identifier: MIT
// Where no combination of modes fits: impulses without a collision, model.md 14.1.
#include "contact/combination.h"
#include "contact/mirror.h"

#include <algorithm>
#include <utility>

namespace phys {

namespace {

constexpr int kMostJamPasses = 50; // of the iteration for the directions of the remaining slips
constexpr double kMostMore = 1e-9; // relative difference of impulses that count as equal

/// Simultaneous impulses: the forces of a combination, and their effect on the motion.
struct Jam {
    Combination c;
    const Moment &before;
    Moment after;
    double zero;        ///< m/s
    Vec3 resisted{0.0}; ///< what rolling resistance adds to the spin, rad/s

    Vec3 slipBefore(uint32_t i) const {
        return before.velocity - before.radius * glm::cross(before.spin + resisted, c.held[i].normal);
    }
    Vec3 slipAfter(uint32_t i) const { return slipAt(after, c.held[i].normal); }
};

/// The impulses that end the slips of sticking contacts and keep the other contacts closed.
void push(Jam &jam) {
    Combination &c = jam.c;
    dense::Equations equations = equationsOf(c, [&jam, &c](uint32_t i, dense::Equations &rows) {
        addRows(c, i, rows, -jam.slipBefore(i), jam.before.velocity, 0.0);
    });
    const dense::Values x = equations.solve();
    jam.after = jam.before;
    jam.after.spin += jam.resisted;
    for (uint32_t i = 0; i < c.count(); ++i) {
        const Vec3 impulse = c.force(i, x);
        c.reactions[i].force = impulse;
        c.reactions[i].pressure = glm::dot(impulse, c.held[i].normal);
        jam.after.velocity += impulse;
        jam.after.spin -= kInertia / jam.before.radius * glm::cross(c.held[i].normal, impulse);
    }
}

/// Change of a slip's direction that corresponds to the rounding of the motion.
double settledWithin(const Jam &jam, const Vec3 &slip) {
    constexpr double kMost = 1e-6;
    const double rounding = 4.0 * 0x1p-52 * speedScale(jam.before);
    const double speed = glm::length(slip);
    return speed > 0.0 ? std::clamp(rounding / speed, jam.before.settled, kMost) : jam.before.settled;
}

/// Like `push`, with friction opposing the remaining slips. False if their directions don't converge.
bool settle(Jam &jam) {
    for (int pass = 0; pass < kMostJamPasses && !jam.c.work.isTooMuch(); ++pass) {
        push(jam);
        bool isSettled = true;
        for (uint32_t i = 0; i < jam.c.count(); ++i) {
            Reaction &reaction = jam.c.reactions[i];
            if (reaction.mode != Mode::slipping) continue;
            const Vec3 slip = jam.slipAfter(i), direction = hat(slip);
            isSettled = isSettled && glm::length(direction - reaction.direction) <= settledWithin(jam, slip);
            reaction.direction = direction;
        }
        if (isSettled) return true;
    }
    return false;
}

/// Whether no contact pulls, and the ball moves into none.
bool closes(const Jam &jam) {
    for (uint32_t i = 0; i < jam.c.count(); ++i) {
        const Reaction &reaction = jam.c.reactions[i];
        const double apart = glm::dot(jam.c.held[i].normal, jam.after.velocity);
        if (std::abs(apart) > jam.zero && (reaction.mode != Mode::open || apart < 0.0)) return false;
        if (reaction.pressure < -jam.zero) return false;
    }
    return true;
}

bool fits(const Jam &jam) {
    if (!closes(jam)) return false;
    for (uint32_t i = 0; i < jam.c.count(); ++i) {
        const Reaction &reaction = jam.c.reactions[i];
        if (reaction.mode != Mode::sticking || jam.c.held[i].isGlued) continue;
        if (glm::length(jam.slipAfter(i)) > jam.zero) return false;
        const Vec3 friction = tangential(reaction.force, jam.c.held[i].normal);
        if (glm::length(friction) > jam.c.held[i].friction * reaction.pressure + jam.zero) return false;
    }
    return true;
}

/// What resistance at sticking contacts adds to the spin for the present impulses: it stops the rolling, if it can.
Vec3 resistanceIn(const Jam &jam) {
    Vec3 sum(0.0);
    for (uint32_t i = 0; i < jam.c.count(); ++i) {
        const Held &held = jam.c.held[i];
        if (!jam.c.sticks(i) || held.isGlued || held.resistance == 0.0) continue;
        const double most = resistancePerPressure(jam.before, held) * jam.c.reactions[i].pressure;
        const Vec3 stops = tangential(jam.resisted, held.normal) - kSlipPerFriction * rollingSpin(jam.after, held);
        sum += glm::length(stops) > most ? most * hat(stops) : stops;
    }
    return sum;
}

/// The same modes with rolling resistance, in proportion to the impulses. False if it doesn't settle, or changes which
/// modes fit.
bool resist(Jam &jam) {
    const double rounding = 4.0 * 0x1p-52 * speedScale(jam.before);
    for (int pass = 0; pass < kMostJamPasses && !jam.c.work.isTooMuch(); ++pass) {
        const Vec3 before = std::exchange(jam.resisted, resistanceIn(jam));
        if (jam.before.radius * glm::length(jam.resisted - before) <= rounding) return closes(jam);
        if (!settle(jam)) return false;
    }
    return false;
}

/// The number-th mode of contact i; false beyond the last one.
bool setMode(Jam &jam, uint32_t i, uint32_t number) {
    const Held &held = jam.c.held[i];
    Reaction &reaction = jam.c.reactions[i];
    const bool isRough = held.isGlued || held.friction > 0.0;
    reaction.direction = Vec3(0.0);
    reaction.mode = number == 0 ? (isRough ? Mode::sticking : Mode::smooth) : Mode::open;
    if (number < 2) return true;
    const Vec3 slip = slipAt(jam.before, held.normal);
    if (number > 2 || held.isGlued || held.friction == 0.0 || isNoSlip(jam.before, slip)) return false;
    reaction.mode = Mode::slipping;
    reaction.direction = hat(slip);
    return true;
}

bool nextModes(Jam &jam, std::array<uint32_t, kMostHeld> &numbers) {
    for (uint32_t i = 0; i < jam.c.count(); ++i) {
        if (setMode(jam, i, ++numbers[i])) return true;
        numbers[i] = 0;
        setMode(jam, i, 0);
    }
    return false;
}

/// Whether any slip ends.
bool ends(const Jam &jam) {
    for (uint32_t i = 0; i < jam.c.count(); ++i) {
        if (jam.c.sticks(i) && !isNoSlip(jam.before, slipAt(jam.before, jam.c.held[i].normal))) return true;
    }
    return false;
}

/// A moment at which slips end, in a frame that is the same for all symmetric images.
class Jammed {
public:
    Jammed(const Moment &moment, std::span<const Held> held, Work &work)
        : m_mirror(moment, held)
        , m_sorted(m_mirror, held)
        , m_before(withoutGravity(m_mirror.seen(moment)))
        , m_jam{Combination{m_before, m_sorted.list(), work}, m_before, m_before, kFits * speedScale(m_before)} {
        for (uint32_t i = 0; i < m_jam.c.count(); ++i) setMode(m_jam, i, 0);
    }

    Moment stopped() {
        push(m_jam);
        return m_jam.after;
    }

    /// False if no choice of modes fits.
    bool end(Moment &best) {
        double least = INFINITY;
        std::array<uint32_t, kMostHeld> numbers{};
        do {
            const std::array<Reaction, kMostHeld> begun = m_jam.c.reactions;
            if (ends(m_jam) && settle(m_jam) && fits(m_jam) &&
                sumOfPressures(m_jam.c.list()) < least - kMostMore * speedScale(m_before)) {
                least = sumOfPressures(m_jam.c.list());
                best = m_jam.after;
                if (resist(m_jam)) best = m_jam.after;
            }
            m_jam.c.reactions = begun;
            m_jam.resisted = Vec3(0.0);
        } while (nextModes(m_jam, numbers) && !m_jam.c.work.isTooMuch());
        return least < INFINITY;
    }

    void give(const Moment &after, Moment &moment) const {
        moment.velocity = m_mirror.back(after.velocity);
        moment.spin = m_mirror.backSpin(after.spin);
    }

private:
    Mirror m_mirror;
    Sorted m_sorted;
    Moment m_before;
    Jam m_jam;

    /// It takes no part in impulses, nor in their rounding.
    static Moment withoutGravity(Moment moment) {
        moment.gravity = Vec3(0.0);
        return moment;
    }
};

} // namespace

bool endSlips(Moment &moment, std::span<const Held> held, Work &work) {
    Jammed jammed(moment, held, work);
    Moment best;
    if (!jammed.end(best)) return false;
    jammed.give(best, moment);
    return true;
}

void stopSlips(Moment &moment, std::span<const Held> held, Work &work) {
    Jammed jammed(moment, held, work);
    jammed.give(jammed.stopped(), moment);
}

} // namespace phys
