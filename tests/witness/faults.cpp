// SPDX-License-Identifier: MIT
// Steppers with one planted fault each, which the witness must find. The id names the fault.
#include "support/planted_fault.h"

#include <cmath>

namespace {

using namespace support;

// ------------------------------------------------------------------------------------------------ another law -- //

phys_status halveWallFriction(Step &step) {
    step.params.wall_friction /= 2;
    return soundStep(step);
}
phys_status doubleFloorFriction(Step &step) {
    step.params.sliding_friction *= 2;
    return soundStep(step);
}
phys_status swapRestitutions(Step &step) {
    std::swap(step.params.restitution_wall, step.params.restitution_floor);
    return soundStep(step);
}
phys_status forgetResistance(Step &step) {
    step.params.rolling_friction = 0;
    return soundStep(step);
}
phys_status rollWithoutInertia(Step &step) { // the sliding block's acceleration, 1 instead of 5/7
    step.params.gravity.x *= 1.4;
    step.params.gravity.y *= 1.4;
    return soundStep(step);
}
/// The velocity after a wall is that for a normal turned by a thousandth.
phys_status turnNormals(Step &step) {
    const phys_status status = soundStep(step);
    const phys_vec3 change = {step.out.velocity.x - step.in.velocity.x, step.out.velocity.y - step.in.velocity.y, 0};
    const double most = 2 * std::hypot(step.params.gravity.x, step.params.gravity.y) * step.dt;
    if (!status && std::hypot(change.x, change.y) > most) {
        step.out.velocity.x -= 1e-3 * change.y;
        step.out.velocity.y += 1e-3 * change.x;
    }
    return status;
}

// ------------------------------------------------------------------------------------------- broken invariants -- //

phys_status gainEnergy(Step &step) {
    const phys_status status = soundStep(step);
    if (!status) add(step.out.velocity, 1e-6, step.out.velocity);
    return status;
}
/// Moves the ball by a hundred thousandth of the radius into the first box that it touches.
phys_status endInside(Step &step) {
    const phys_status status = soundStep(step);
    if (status) return status;
    const std::vector<phys_contact> contacts = contactsAt(step.self, step.out.position, 1e-9 * step.self.radius);
    if (!contacts.empty()) add(step.out.position, -1e-5 * step.self.radius, contacts[0].normal);
    return status;
}
/// Not symmetric under reflection.
phys_status preferRight(Step &step) {
    const phys_status status = soundStep(step);
    if (!status && step.out.velocity.x > 0) step.out.velocity.x = std::nextafter(step.out.velocity.x, 0);
    return status;
}
phys_status preferX(Step &step) {
    const phys_status status = soundStep(step);
    if (!status) step.out.velocity.x *= 1 - 0x1p-52;
    return status;
}
/// Slower beside the first box than beside all others.
phys_status preferFirstBox(Step &step) {
    const phys_status status = soundStep(step);
    if (status) return status;
    for (const phys_contact &contact : contactsAt(step.self, step.out.position, step.self.radius)) {
        if (contact.box == 0) add(step.out.velocity, -1e-12, step.out.velocity);
    }
    return status;
}
phys_status countBoxes(Step &step) {
    const phys_status status = soundStep(step);
    if (status) return status;
    add(step.out.velocity, -1e-12 * static_cast<double>(step.self.boxes.size()), step.out.velocity);
    return status;
}
/// Stops the ball below a speed, m/s.
phys_status stopByThreshold(Step &step) {
    const phys_status status = soundStep(step);
    if (!status && dot(step.out.velocity, step.out.velocity) < 1e-3) step.out.velocity = {0, 0, 0};
    return status;
}
phys_status remember(Step &step) {
    const phys_status status = soundStep(step);
    if (!status && ++step.self.calls % 2 == 0) add(step.out.velocity, -1e-15, step.out.velocity);
    return status;
}
phys_status obeyReport(Step &step) {
    const phys_status status = soundStep(step);
    if (!status && step.report) add(step.out.velocity, -1e-15, step.out.velocity);
    return status;
}
phys_status claimLoss(Step &step) {
    const phys_status status = soundStep(step);
    if (!status && step.report) step.report->lost_slip -= 1.0;
    return status;
}
phys_status claimRest(Step &step) {
    const phys_status status = soundStep(step);
    if (status || dot(step.out.velocity, step.out.velocity) >= 1e-2) return status;
    step.out.velocity = step.out.spin = {0, 0, 0};
    step.out.flags |= PHYS_AT_REST;
    return PHYS_OK;
}
/// Continues straight on if the step is long, whatever is in the way, and ends beside it.
phys_status jump(Step &step) {
    const double way = std::sqrt(dot(step.in.velocity, step.in.velocity)) * step.dt;
    if (way < step.self.radius) return soundStep(step);
    phys_vec3 ahead = step.in.position;
    add(ahead, step.dt, step.in.velocity);
    if (!contactsAt(step.self, ahead, 0).empty()) return soundStep(step);
    step.out.position = ahead;
    return PHYS_OK;
}

bool keepWhatStandsOnTheFloor(const phys_box &box, double floorTop) {
    return !(box.min.z > floorTop); // a roof is ignored
}
/// Ignores thin boxes.
bool keepThick(const phys_box &box, double) {
    return std::min({box.max.x - box.min.x, box.max.y - box.min.y, box.max.z - box.min.z}) > 1e-5;
}

constexpr phys_stepper_api kTables[] = {
    doing<soundStep>("sound"),
    doing<halveWallFriction>("wall-friction-halved"),
    doing<doubleFloorFriction>("floor-friction-doubled"),
    doing<swapRestitutions>("restitution-of-the-other-feature"),
    doing<forgetResistance>("resistance-forgotten"),
    doing<rollWithoutInertia>("inertia-forgotten"),
    doing<turnNormals>("normal-turned-1e-3"),
    doing<soundStep, keepWhatStandsOnTheFloor>("roof-forgotten"),
    doing<soundStep, keepThick>("thin-wall-forgotten"),
    doing<gainEnergy>("energy-up-1e-6"),
    doing<endInside>("ends-inside"),
    doing<preferRight>("prefers-right"),
    doing<preferX>("prefers-x"),
    doing<preferFirstBox>("prefers-first-box"),
    doing<countBoxes>("counts-boxes"),
    doing<stopByThreshold>("stops-by-threshold"),
    doing<remember>("remembers"),
    doing<obeyReport>("obeys-report"),
    doing<claimLoss>("claims-loss"),
    doing<claimRest>("claims-rest"),
    doing<jump>("jumps"),
};
constexpr PlantedTables kAll(kTables);

} // namespace

constinit const phys_plugin phys_plugin_entry = {PHYS_ABI_VERSION, sizeof(phys_plugin), std::size(kTables), 0,
                                                 kAll.list};
