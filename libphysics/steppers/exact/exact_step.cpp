// SPDX-License-Identifier: MIT
#include "exact/exact_step.h"

#include "contact/push_out.h"
#include "exact/bounces.h"
#include "exact/choose.h"
#include "exact/contact_events.h"
#include "exact/first_event.h"
#include "exact/follow.h"
#include "exact/ground.h"
#include "exact/last_bounce.h"
#include "exact/region_run.h"
#include "exact/resolve.h"

#include <cmath>

namespace phys {

namespace {

/// Pushes the ball out of boxes that it overlaps in the given state: model.md 5.7.
phys_status leaveBoxes(Ground &ground, MovingBall &ball) {
    if (ground.keeps(ball, glm::length(ball.setting.gravity())) || ground.lookAround(ball)) return PHYS_OK;
    if (ball.elapsed > 0.0) return PHYS_OK; // it has just met one
    const PushOut pushed = pushOut(ball.scene(), ball.position, ball.work);
    ball.report.penetration(pushed.depth);
    if (pushed.isFree) return PHYS_OK; // a smaller step wouldn't help if the work limit is exceeded
    return fail(ball.error, PHYS_ERROR_STUCK, "the ball at (%.9g, %.9g, %.9g) is wedged where it doesn't fit",
                ball.position.x, ball.position.y, ball.position.z);
}

/// Whether the ball slips on a floor.
bool slipsAt(const Vec3 &normal, const MovingBall &ball) {
    return ball.setting.isRigid() && !isNoSlip(ball.moment(), slipAt(ball.moment(), normal));
}

/// response: of the present contacts, or nullptr if the law hasn't been evaluated.
uint32_t flagsOf(const Touching &touching, const Response *response, MovingBall &ball) {
    bool isCarried = false, slips = false;
    for (uint32_t i = 0; i < touching.count(); ++i) {
        const Contact &contact = touching.contactOf(i);
        const bool presses = response ? isClosed(*response, i) : ball.params().gravity.z <= 0.0;
        if (!contact.isTop || !presses) continue;
        isCarried = true;
        slips = slipsAt(contact.normal, ball);
    }
    const uint32_t flags = (isCarried ? 0 : PHYS_AIRBORNE) | (slips ? PHYS_SLIPPING : 0);
    if (!ball.isStill()) return flags;
    Response asked;
    if (!response && respondNow(touching, ball, asked)) return flags;
    return flags | (rests(ball, response ? *response : asked) ? PHYS_AT_REST : 0);
}

phys_status leave(const MovingBall &ball, uint32_t flags, phys_state &out) {
    const Vec3 sum = ball.position + ball.motion.velocity + ball.motion.spin;
    if (!std::isfinite(sum.x + sum.y + sum.z)) {
        return fail(ball.error, PHYS_ERROR_INTERNAL, "the step's result isn't a number");
    }
    if (const phys_status status = checkHops(ball)) return status;
    out.position = fromVec(ball.position);
    out.velocity = fromVec(ball.motion.velocity);
    out.spin = fromVec(ball.motion.spin);
    std::copy(std::begin(ball.orientation), std::end(ball.orientation), out.orientation);
    out.flags = (ball.scene().isOut(out.position) ? PHYS_OUT : 0) | flags;
    return PHYS_OK;
}

/// The rest of the step, or the next phases, if they are of the most frequent kinds. False if the loop must continue.
bool finishInRegion(FloorRegions &regions, MovingBall &ball, ContactEvents &events, uint32_t &flags) {
    if (!runInRegion(regions, ball, events)) return false;
    flags = slipsAt({0.0, 0.0, 1.0}, ball) ? PHYS_SLIPPING : 0;
    return true;
}

/// The same from a moment that is resolved; resolves the moment at which that stops.
bool goOnInRegion(FloorRegions &regions, const Ground &ground, MovingBall &ball, Touching &touching,
                  ContactEvents &events, uint32_t &flags) {
    const double left = ball.left;
    if (finishInRegion(regions, ball, events, flags)) return true;
    if (ball.left == left) return false;
    resolve(ground, ball, touching);
    skipBounces(ground, ball, touching);
    return false;
}

/// The event loop of model.md 8.1, from any moment of a step on.
phys_status followEvents(FloorRegions &regions, MovingBall &ball, ContactEvents &events, uint32_t &flags) {
    Ground ground(ball, regions);
    if (const phys_status status = leaveBoxes(ground, ball)) return status;
    Touching touching;
    Choice choice;
    const Vec3 given = ball.motion.velocity;
    resolve(ground, ball, touching);
    skipBounces(ground, ball, touching);
    const Response *response = nullptr;               // of the present contacts
    const bool isNew = ball.motion.velocity != given; // not the motion for which the region had no answer
    if (isNew && goOnInRegion(regions, ground, ball, touching, events, flags)) return ball.checkWork();
    while (ball.left > 0.0) {
        ball.work.add(Work::kEvent);
        if (const phys_status status = ball.checkWork()) return status;
        if (const phys_status status = choose(ball, touching, choice)) return status;
        response = &choice.response;
        events.add(touching, choice.response, ball);
        if (ball.isStill() && rests(ball, choice.response)) break;
        Event event = firstEvent(ground, touching, choice, ball);
        if (std::holds_alternative<SlipEnd>(choice.phase) && event.end.cause != Cause::grip) {
            if (const phys_status status = choose(ball, touching, choice, Slips::areFollowed)) return status;
            event = firstEvent(ground, touching, choice, ball);
        }
        follow(choice, event, ball, touching);
        // A contact that begins at the very end of the step is resolved in this step.
        if (ball.left == 0.0 && event.end.cause == Cause::time) break;
        response = nullptr;
        resolve(ground, ball, touching);
        skipBounces(ground, ball, touching);
        if (ball.left > 0.0 && goOnInRegion(regions, ground, ball, touching, events, flags)) return ball.checkWork();
    }
    if (const phys_status status = ball.checkWork()) return status;
    flags = flagsOf(touching, response, ball);
    return PHYS_OK;
}

} // namespace

phys_status stepExactly(const Scene &scene, FloorRegions &regions, const phys_params &params, double dt,
                        const phys_state &in, phys_state &out, phys_report *report, phys_error *err) {
    if (params.options & PHYS_OPTION_ALL_STAGES) { // refuses what is refused without it, whatever it costs itself
        phys_params usual = params;
        usual.options &= ~static_cast<uint32_t>(PHYS_OPTION_ALL_STAGES);
        phys_state unused = in;
        if (const phys_status status = stepExactly(scene, regions, usual, dt, in, unused, nullptr, err)) return status;
    }
    MovingBall ball(scene, params, dt, in, report, err);
    ball.report.substeps(1, 0);
    ContactEvents events;
    uint32_t flags = 0;
    if (finishInRegion(regions, ball, events, flags)) return leave(ball, flags, out);
    if (const phys_status status = followEvents(regions, ball, events, flags)) return status;
    return leave(ball, flags, out);
}

} // namespace phys
