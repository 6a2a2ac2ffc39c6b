// SPDX-License-Identifier: MIT
// Scenes and runs that several suites of the inspector's core use.
#pragma once

#include "core/engine/engine.h"

#include <QDir>
#include <QTest>

#include <memory>
#include <vector>

namespace inspector {

inline Scene sceneOf(const std::vector<phys_box> &boxes) {
    phys_scene_desc description;
    phys_scene_desc_init(&description, sizeof description);
    description.boxes = boxes.data();
    description.box_count = uint32_t(boxes.size());
    QString error;
    Scene scene = makeScene(description, &error);
    if (!scene) qFatal("%s", qPrintable(error));
    return scene;
}

// A square floor of 2 m with the ball in its middle and no walls: the ball can roll for a while.
inline Scene openFloor() { return sceneOf({{{-1.0, -1.0, -0.01}, {1.0, 1.0, 0.0}}}); }

inline int levelCount() { return int(QDir(LEVELS_FOLDER).entryList({"*.txt"}, QDir::Files).size()); }

inline Scene levelScene(int number) {
    QString error;
    const QString path = QStringLiteral(LEVELS_FOLDER "/%1.txt").arg(number, 2, 10, QLatin1Char('0'));
    Scene scene = loadScene(path, &error);
    if (!scene) qFatal("%s", qPrintable(error));
    return scene;
}

inline Stepper defaultStepper(const Scene &scene) {
    QString error;
    Stepper stepper = makeStepper(makeRegistry(&error), PHYS_STEPPER_DEFAULT, scene, &error);
    if (!stepper) qFatal("%s", qPrintable(error));
    return stepper;
}

inline std::unique_ptr<Engine> engineOn(const Scene &scene) {
    return std::make_unique<Engine>(scene, defaultStepper(scene));
}

// The library's defaults on a board tilted by this many degrees.
inline Inputs tilted(double x, double y) {
    Inputs inputs = initialInputs();
    tiltBoard(inputs, {radians(x), radians(y)});
    return inputs;
}

} // namespace inspector
