// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/setup/inputs.h"

namespace inspector {

Inputs initialInputs() {
    Inputs inputs{};
    phys_params_init(&inputs.params, sizeof inputs.params);
    inputs.params.options |= PHYS_OPTION_ORIENTATION;
    inputs.gravity = -inputs.params.gravity.z;
    return inputs;
}

void tiltBoard(Inputs &inputs, Tilt tilt) {
    inputs.tilt = tilt;
    phys_gravity_from_tilt(tilt.x, tilt.y, inputs.gravity, &inputs.params.gravity);
}

} // namespace inspector
