// SPDX-License-Identifier: MIT
// Steppers that break one invariant each, in ways that the library can't detect from the states that they return.
#include <physics/plugin.h>

#include <cstring>
#include <iterator>

namespace {

/// The data of one stepper: the scene, and a count of steps that no stepper should keep.
struct Self {
    const phys_scene_view *scene;
    uint64_t steps;
};

phys_status create(const phys_scene_view *scene, void **self, phys_error *) {
    *self = new Self{scene, 0};
    return PHYS_OK;
}
void destroy(void *self) { delete static_cast<Self *>(self); }

using StepFunction = phys_status(Self &, const phys_params &, double dt, phys_state &, phys_error &);

/// Rolls as if there were no walls.
phys_status sink(Self &, const phys_params &params, double dt, phys_state &state, phys_error &) {
    state.velocity.x += 5.0 / 7.0 * params.gravity.x * dt;
    state.velocity.y += 5.0 / 7.0 * params.gravity.y * dt;
    state.position.x += state.velocity.x * dt;
    state.position.y += state.velocity.y * dt;
    return PHYS_OK;
}

/// Moves from one side of the walls around to the other in one step.
phys_status tunnel(Self &self, const phys_params &, double, phys_state &state, phys_error &) {
    phys_contact contacts[8];
    const double reach = 4.0 * self.scene->radius;
    const uint32_t count = self.scene->contacts(self.scene->scene, &state.position, reach, contacts, 8);
    for (uint32_t i = 0; i < count && i < 8; ++i) {
        const phys_contact &contact = contacts[i];
        const phys_box &box = self.scene->boxes[contact.box];
        const double radius = self.scene->radius;
        if (contact.normal.x == 1.0) state.position.x = box.min.x - radius;
        if (contact.normal.x == -1.0) state.position.x = box.max.x + radius;
        if (contact.normal.y == 1.0) state.position.y = box.min.y - radius;
        if (contact.normal.y == -1.0) state.position.y = box.max.y + radius;
    }
    return PHYS_OK;
}

/// Speeds up without moving, whatever the slope.
phys_status gain(Self &, const phys_params &, double, phys_state &state, phys_error &) {
    state.velocity.x += 0.125;
    return PHYS_OK;
}

/// The ball's path depends on the number of calls of this stepper.
phys_status remember(Self &self, const phys_params &, double, phys_state &state, phys_error &) {
    if (++self.steps % 3 == 0) state.spin.z = 1e-9 * static_cast<double>(self.steps);
    return PHYS_OK;
}

phys_status giveUp(Self &, const phys_params &, double, phys_state &, phys_error &error) {
    std::strcpy(error.text, "lost its way");
    return PHYS_ERROR_STUCK;
}

phys_status decline(Self &, const phys_params &, double, phys_state &, phys_error &error) {
    std::strcpy(error.text, "too steep");
    return PHYS_ERROR_UNSUPPORTED;
}

template<StepFunction *function>
phys_status step(void *self, const phys_params *params, double dt, const phys_state *, phys_state *out, phys_report *,
                 phys_error *err) {
    return function(*static_cast<Self *>(self), *params, dt, *out, *err);
}

template<StepFunction *function>
constexpr phys_stepper_api doing(const char *id) {
    return {sizeof(phys_stepper_api), 0,       id,     id, "1", "", nullptr, 0, 0, create, destroy,
            step<function>,           nullptr, nullptr};
}

constexpr phys_stepper_api kTables[] = {
    doing<sink>("sinks"),         doing<tunnel>("tunnels"),  doing<gain>("gains"),
    doing<remember>("remembers"), doing<giveUp>("gives-up"), doing<decline>("declines"),
};
constexpr const phys_stepper_api *kPointers[] = {&kTables[0], &kTables[1], &kTables[2],
                                                 &kTables[3], &kTables[4], &kTables[5]};

} // namespace

constinit const phys_plugin phys_plugin_entry = {PHYS_ABI_VERSION, sizeof(phys_plugin), std::size(kTables), 0,
                                                 kPointers};
