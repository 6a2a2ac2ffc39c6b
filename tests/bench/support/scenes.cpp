// SPDX-License-Identifier: MIT
#include "support/scenes.h"

#include <numbers>

namespace bench {

namespace {

constexpr double kDegree = std::numbers::pi / 180;

// For scenes that tilt once: samples are taken at the end of each of these periods.
void holdTilt(Scene &scene, double tiltX, double tiltY, int periods) {
    scene.tiltPeriod = scene.duration / periods;
    scene.gravity.assign(static_cast<std::size_t>(periods), steadyTilt(tiltX, tiltY).front());
}

} // namespace

Scene inclineScene() {
    Scene scene;
    scene.name = "incline";
    scene.rolls = true;
    scene.duration = 2;
    holdTilt(scene, 5 * kDegree, 0, 4);
    return scene;
}

Scene bounceScene() {
    Scene scene;
    scene.name = "bounce";
    scene.walls = {{-1.2, -1, -1, 1}, {1, -1, 1.2, 1}};
    scene.start = {{0.1, 0}, {1.3, 0}};
    scene.restitution = 0.8;
    holdTilt(scene, 0, 0, 20);
    return scene;
}

Scene billiardScene() {
    Scene scene;
    scene.name = "billiard";
    scene.walls = {{-1.7, -1.2, -1.5, 1.2}, {1.5, -1.2, 1.7, 1.2}, {-1.5, -1.2, 1.5, -1}, {-1.5, 1, 1.5, 1.2}};
    scene.start = {{0.1, -0.2}, {1.7, 1.1}};
    scene.restitution = 1;
    holdTilt(scene, 0, 0, 20);
    return scene;
}

Scene edgeScene() {
    Scene scene;
    scene.name = "edge";
    scene.walls = {{1, -1, 2, 0}};
    scene.start = {{-0.01371, 0.6 * scene.radius}, {2, 0}}; // the impact falls on no multiple of a step
    scene.restitution = 0.8;
    scene.duration = 1.4; // touches at about 0.4 s
    holdTilt(scene, 0, 0, 2);
    return scene;
}

Scene fastScene(int phase, int phases) {
    constexpr double kSpeed = 300;    // m/s
    constexpr double kStepLength = 3; // m: in 10 ms
    Scene scene;
    scene.name = "fast";
    scene.walls = {{0, -5, 0.2, 5}};
    scene.start = {{-8 - kStepLength * (phase + 0.5) / phases, 0}, {kSpeed, 0}};
    scene.duration = 0.1;
    holdTilt(scene, 0, 0, 1);
    return scene;
}

Scene restScene() {
    Scene scene;
    scene.name = "rest";
    scene.walls = {{-0.2, -0.2, 0, 2}, {0, -0.2, 2, 0}};
    scene.start = {{scene.radius, scene.radius}, {}};
    holdTilt(scene, -3 * kDegree, -2 * kDegree, 20);
    return scene;
}

} // namespace bench
