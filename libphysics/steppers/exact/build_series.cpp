// SPDX-License-Identifier: MIT
#include "exact/build_series.h"

#include "exact/response.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace phys {

namespace {

/// s: longer than any step; for a motion so slow that its squares underflow, which has no time scale of its own
constexpr double kLongestUnit = 0x1p100;

/// Whether a contact starts to slip while another one sticks.
bool startsBeside(const Response &response) {
    bool starts = false, sticks = false;
    for (const Reaction &reaction : response.list()) {
        starts = starts || reaction.mode == Mode::starting;
        sticks = sticks || reaction.mode == Mode::sticking;
    }
    return starts && sticks;
}

/// A ball that begins to slip no longer rolls, so no resistance acts. False if none did.
bool withoutResistance(uint32_t slipping, MovingBall &ball, Touching &touching, Response &response) {
    bool resists = false;
    for (uint32_t i = 0; i < touching.count(); ++i) {
        if (!(slipping >> i & 1U) || touching.held(i).resistance == 0.0) continue;
        touching.held(i).resistance = 0.0;
        resists = true;
    }
    if (!resists) return false;
    const Response free = respond(ball.moment(), touching.held(), ball.work);
    if (free.isFound) response = free;
    return true;
}

/// s: the initial estimate of the unit.
double firstUnit(const MovingBall &ball, const Response &response) {
    const double R = ball.radius();
    const double scale = glm::length(ball.setting.gravity()) + glm::length(response.acceleration) +
                         glm::dot(ball.motion.velocity, ball.motion.velocity) / R;
    double unit = std::min(std::sqrt(R / scale), kLongestUnit);
    for (const Reaction &reaction : response.list()) {
        if (reaction.mode == Mode::slipping) unit = std::min(unit, 3.0 * glm::length(reaction.slip) / scale);
    }
    const double turning = std::abs(glm::dot(ball.motion.spin, response.rolling));
    return turning > 0.0 ? std::min(unit, turning / glm::length(response.spinAcceleration)) : unit;
}

/// The response with the friction of some contacts spent. spent: bits; slips: the directions in which they begin to
/// slip.
Response withSpent(const Response &response, uint32_t spent, std::span<const Vec3> slips) {
    Response result = response;
    for (uint32_t i = 0; i < result.count; ++i) {
        if (!(spent >> i & 1U)) continue;
        result.reactions[i].mode = Mode::spent;
        result.reactions[i].direction = slips[i];
    }
    return result;
}

/// Builds the series, starting from the given unit (s), until the unit suits them. None is longer than `longest`.
void fitUnit(const Response &response, uint32_t kept, const Touching &touching, double longest, MovingBall &ball,
             Series &series, double &unit) {
    bool hasShrunk = false;
    for (int guess = 0; guess < 40; ++guess) {
        series.build(ball.moment(), touching.held(), response, unit, kept, ball.left);
        ball.work.add(Work::kSeries * (1 + series.size()));
        const bool isLong = series.length() > 3.0 && unit < longest && !hasShrunk;
        if (series.length() >= 0.1 && !isLong) return;
        hasShrunk = !isLong;
        unit = isLong ? std::min(4.0 * unit, longest) : unit * std::max(2.0 * series.length(), 0x1p-8);
    }
}

/// Takes a slaved series, model.md 14.2, if that is valid for longer. build: which; unit: the initial one (s).
void extend(bool (Series::*build)(const Moment &, std::span<const Held>, const Response &, double, Work &), double unit,
            const Response &response, const Touching &touching, MovingBall &ball, Series &series) {
    constexpr int kMostGuesses = 12;
    Series slaved;
    for (int guess = 0; guess < kMostGuesses; ++guess) {
        if (!(slaved.*build)(ball.moment(), touching.held(), response, unit, ball.work)) return;
        if (slaved.length() >= 0.1) break;
        unit *= std::max(2.0 * slaved.length(), 0x1p-4);
    }
    if (slaved.horizon() > series.horizon()) series = slaved;
}

/// Series in which what friction changes fast follows the motion, if those of all of it are short: model.md 14.2.
void slave(const Response &response, const Touching &touching, MovingBall &ball, Series &series) {
    constexpr double kShort = 0x1p-8, kShortTurn = 0x1p-6; // relative to the time scale of the motion
    const double unit = firstUnit(ball, response), timeOfSlips = series.timeOfSlips();
    if (series.horizon() < kShort * unit) {
        extend(&Series::buildSlaved, unit, response, touching, ball, series);
    } else if (series.horizon() < kShortTurn * timeOfSlips) {
        extend(&Series::buildTurning, timeOfSlips, response, touching, ball, series);
    }
}

} // namespace

bool buildSeries(MovingBall &ball, Touching &touching, Response &response, Series &series) {
    double unit = firstUnit(ball, response);
    const double longest = std::max(unit, ball.left);
    Excluded excluded;
    uint32_t spent = 0, kept = 0, together = 0;
    std::array<Vec3, kMostHeld> slips{}; // directions for those that are spent
    std::optional<Touching> rolled;      // if resistance ended as two began to slip
    for (int change = 0; change < 8; ++change) {
        fitUnit(withSpent(response, spent, slips), kept, touching, longest, ball, series, unit);
        if (together && series.slipsBack(together)) {
            spent &= ~together;
            kept |= together;
            together = 0;
            if (rolled) touching = *rolled;
            if (rolled) response = respond(ball.moment(), touching.held(), ball.work);
            continue;
        }
        const uint32_t opening = series.opening() & ~excluded.closed;
        const uint32_t slipping = series.spent(slips) & ~(spent | kept);
        if (!opening && !slipping) {
            if (spent == 0 && kept == 0) slave(response, touching, ball, series);
            return true;
        }
        if (!opening && countSticking(response) == 1 && excluded.sticking == 0) {
            spent |= slipping;
            withoutResistance(slipping, ball, touching, response);
            continue;
        }
        // Of contacts that stick together, one starts in the direction that another leaves free, or two start together.
        excluded.closed |= opening;
        excluded.sticking |= opening ? 0 : slipping;
        const Response changed = respond(ball.moment(), touching.held(), ball.work, excluded);
        if (changed.isFound && (opening || countSticking(response) != 2 || startsBeside(changed))) {
            response = changed;
            continue;
        }
        excluded.sticking &= ~slipping;
        excluded.closed &= ~opening;
        if (opening) return false;
        Touching freed = touching;
        Response pressed = response;
        const bool resists = withoutResistance(~0U, ball, freed, pressed);
        if (resists) fitUnit(pressed, kept, freed, longest, ball, series, unit);
        together = series.spentTogether(pressed.reactions, slips);
        if (together && resists) rolled = std::exchange(touching, freed);
        if (together) response = pressed;
        spent |= together;
        kept |= together ? 0 : slipping;
    }
    return true;
}

} // namespace phys
