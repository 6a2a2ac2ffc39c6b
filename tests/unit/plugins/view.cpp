// SPDX-License-Identifier: MIT
// A stepper that passes its view of the scene to the test that loads it.
#include <physics/plugin.h>

namespace {

phys_status create(const phys_scene_view *scene, void **self, phys_error *) {
    *self = const_cast<phys_scene_view *>(scene);
    return PHYS_OK;
}

void destroy(void *) {}

/// The address of the view is stored where events would be.
phys_status step(void *self, const phys_params *, double, const phys_state *, phys_state *, phys_report *report,
                 phys_error *) {
    *reinterpret_cast<void **>(report->events) = self;
    return PHYS_OK;
}

constexpr phys_stepper_api kView = {
    sizeof(phys_stepper_api), 0, "view", "View", "1", "", nullptr, 0, 0, create, destroy, step, nullptr, nullptr};
constexpr const phys_stepper_api *kSteppers[] = {&kView};

} // namespace

constinit const phys_plugin phys_plugin_entry = {PHYS_ABI_VERSION, sizeof(phys_plugin), 1, 0, kSteppers};
