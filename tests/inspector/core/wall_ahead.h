// SPDX-License-Identifier: MIT
// The scene of a bounce: a floor of 2 m, and a wall to the right of the ball at its start.
#pragma once

#include "core/setup/handles.h"

namespace inspector {

// face: x of the wall's near side, m.
inline Scene wallAhead(double face) {
    const phys_box boxes[] = {{{-1.0, -1.0, -0.01}, {1.0, 1.0, 0.0}}, {{face, -1.0, 0.0}, {face + 0.1, 1.0, 0.05}}};
    phys_scene_desc description;
    phys_scene_desc_init(&description, sizeof description);
    description.boxes = boxes;
    description.box_count = 2;
    QString error;
    Scene scene = makeScene(description, &error);
    if (!scene) qFatal("%s", qPrintable(error));
    return scene;
}

} // namespace inspector
