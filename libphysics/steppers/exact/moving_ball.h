// SPDX-License-Identifier: MIT
// The ball of a step between two phases, the step's clock, and what the step counts and reports.
#pragma once

#include "base/error.h"
#include "contact/contact.h"
#include "contact/modes.h"
#include "contact/work.h"
#include "exact/search.h"
#include "phases/jet.h"
#include "phases/turning.h"
#include "registry/report.h"

#include <algorithm>
#include <iterator>
#include <limits>

namespace phys {

struct MovingBall {
    MovingBall(const Scene &scene, const phys_params &params, double dt, const phys_state &in, phys_report *to,
               phys_error *err)
        : setting{scene, params}
        , report(to, in, dt)
        , error(err)
        , work(runsAllStages() ? std::numeric_limits<uint64_t>::max() : Work::kMost)
        , left(dt)
        , position(toVec(in.position))
        , motion{toVec(in.velocity), toVec(in.spin)} {
        setting.sameNormal = sameNormal(scene);
        std::copy(std::begin(in.orientation), std::end(in.orientation), orientation);
    }

    Setting setting;
    Reporter report;
    phys_error *error;
    Work work;
    uint32_t hops = 0;    ///< short bounces, hops and series between them, by their cost; model.md 6.4
    Vec3 lastHop{0.0};    ///< where it was at the last one that was counted
    double elapsed = 0.0; ///< s of the step that have passed
    double left;          ///< s of the step that remain
    Vec3 position;
    Motion motion;
    double orientation[4];

    const Scene &scene() const { return setting.scene; }
    const phys_params &params() const { return setting.params; }
    double radius() const { return setting.scene.radius; }
    bool runsAllStages() const { return (params().options & PHYS_OPTION_ALL_STAGES) != 0; }
    double negligibleSpeed() const { return phys::negligibleSpeed(motion, radius()); }
    bool isStill() const { return motion.velocity == Vec3(0.0) && motion.spin == Vec3(0.0); }

    Moment moment() const {
        return {motion.velocity, motion.spin, setting.gravity(), radius(),
                16.0 * kRounding + 4.0 * scene().tolerance / radius()};
    }

    /// Whether only time passes while a vanishing speed ends: meanwhile the ball's motion changes by less than that.
    bool waits(const End &end, double mostAcceleration) const {
        return end.rest > 0.0 && end.rest * mostAcceleration <= 16.0 * kSlipEnds * speedScale(moment());
    }

    /// Refuses a step whose work limit is exceeded.
    phys_status checkWork() const {
        if (!work.isTooMuch()) return PHYS_OK;
        return fail(error, PHYS_ERROR_EVENT_CAP,
                    "more to compute than %llu in one step, %.9g s of it still to go: take a smaller dt",
                    static_cast<unsigned long long>(Work::kMost), left);
    }

    /// On a floor: gives the ball the spin of rolling with its velocity, exact to the last bit.
    void roll() {
        const Vec3 rolls = rollingSpin(inPlane(motion.velocity), radius());
        motion.spin = {rolls.x, rolls.y, motion.spin.z};
    }

    void pass(double time) {
        elapsed += time;
        left -= time;
    }

    /// Rotates the ball by a phase's motion until t (s), if orientation is requested.
    template<class Phase>
    void turn(const Phase &phase, const Place &end, double t) {
        if (params().options & PHYS_OPTION_ORIENTATION) phys::turn(orientation, phase, end, t);
    }

    /// Reports an event at this time, without or with a contact.
    void event(uint32_t kind, double before, double after) {
        report.event(kind, elapsed, position, Vec3(0.0), before, after, PHYS_NO_BOX);
    }
    void event(uint32_t kind, const Contact &at, double before, double after) {
        report.event(kind, elapsed, at.point, at.normal, before, after, scene().givenBox(at.box, at.point));
    }
};

} // namespace phys
