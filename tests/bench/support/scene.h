// SPDX-License-Identifier: MIT
// The input of every engine: walls, a ball, and how the board tilts. Seen from above; walls are as high as needed.
#pragma once

#include <physics/physics.h>

#include <string>
#include <vector>

namespace bench {

struct Vec2 {
    double x = 0; // m or m/s
    double y = 0;
};

double distance(const Vec2 &a, const Vec2 &b);

struct Wall {
    double x0, y0, x1, y1; // m
};

struct Ball {
    Vec2 position; // of the centre, m
    Vec2 velocity; // m/s
};

inline constexpr double kStrength = 9.81;      // of gravity, m/s^2
inline constexpr double kWallHeight = 0.5;     // m
inline constexpr double kFloorThickness = 0.2; // m

struct Scene {
    std::string name;
    double radius = 0.25; // m
    std::vector<Wall> walls;
    Ball start;
    double restitution = 0.5;       // at the walls
    bool rolls = false;             // rolls without slipping (5/7 of the tilt); otherwise everything is frictionless
    double duration = 10;           // s
    double tiltPeriod = 0.5;        // s, during which gravity stays the same
    std::vector<phys_vec3> gravity; // of each period, m/s^2, board frame
};

// The rectangle of floor under everything that the scene's ball can reach.
Wall floorOf(const Scene &scene);

// The tilt of the scene's first period: enough for scenes that tilt once.
std::vector<phys_vec3> steadyTilt(double tiltX, double tiltY);

// A new tilt within +-5 degrees along each axis for each of `periods`; the same seed gives the same tilts everywhere.
std::vector<phys_vec3> randomTilts(unsigned seed, int periods);

} // namespace bench
