// SPDX-License-Identifier: MIT
#include "registry/energy.h"

#include "base/appendable.h"
#include "base/float_environment.h"
#include "base/numbers.h"
#include "base/vec.h"

namespace phys {

double energyOf(const Scene &scene, const phys_params &params, const phys_state &state) {
    const Vec3 velocity = toVec(state.velocity);
    const Vec3 spin = toVec(state.spin);
    return 0.5 * glm::dot(velocity, velocity) + 0.2 * scene.radius * scene.radius * glm::dot(spin, spin) -
           glm::dot(toVec(params.gravity), toVec(state.position));
}

} // namespace phys

phys_status phys_energy(const phys_scene *scene, const phys_params *params, const phys_state *state, double *out) {
    const phys::FloatEnvironment environment;
    if (!scene || !params || !state || !out) return PHYS_ERROR_ARGUMENT;
    if (!phys::isKnownSize<phys_params>(params->struct_size)) return PHYS_ERROR_ARGUMENT;
    const bool isValid = phys::isModerate(state->position) && phys::isModerate(state->velocity) &&
                         phys::isModerate(state->spin) && phys::isModerate(params->gravity);
    if (!isValid) return PHYS_ERROR_ARGUMENT;
    *out = phys::energyOf(*scene, *params, *state);
    return PHYS_OK;
}
