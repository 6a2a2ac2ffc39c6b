// SPDX-License-Identifier: GPL-3.0-or-later
// A camera that orbits a target. World frame: the board frame of a level board, z up, m. Pixels are logical, y down.
#pragma once

#include "mesh/mesh.h"

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace inspector::gl {

struct Ray {
    glm::dvec3 origin{0.0};
    glm::dvec3 direction{0.0, 0.0, -1.0}; ///< unit length
};

class OrbitCamera {
public:
    static constexpr double kFieldOfView = 0.55; ///< rad, vertical
    static constexpr double kMinElevation = 0.09;
    static constexpr double kMaxElevation = 1.5707963267948966;  ///< straight from above
    static constexpr double kStartAzimuth = -1.5707963267948966; ///< from -y, so that x points right
    static constexpr double kStartElevation = 0.96;

    /// Size of the picture in logical pixels, clamped to at least 1.
    void setViewport(const glm::dvec2 &size);
    /// The bounds that reset() shows and that limit distance and target. largestTilt: rad in [0, pi/2), up to which the
    /// board may be tilted about its pivot in x and in y and still be shown whole.
    void setBounds(const Bounds &bounds, double largestTilt);

    /// Turns the scene with a drag, in pixels.
    void orbit(const glm::dvec2 &drag);
    /// Pans so that the point of the target's plane under the cursor stays under it.
    void pan(const glm::dvec2 &drag);
    /// steps > 0 zooms in. The point of the target's plane under the cursor stays under it.
    void zoom(double steps, const glm::dvec2 &cursor);
    /// Returns to the start direction with all of the bounds in the picture.
    void reset();
    /// Moves to the smallest distance that shows all of the bounds, tilted or not, from the current direction, with a
    /// margin.
    void fit();

    /// Sets the target; direction and distance are kept.
    void lookAt(const glm::dvec3 &world);
    /// Multiplies the distance by `share`.
    void approach(double share);

    glm::dmat4 view() const;
    glm::dmat4 projection() const;
    glm::dvec3 eye() const;
    glm::dvec3 target() const { return m_target; }
    double distance() const { return m_distance; }
    double azimuth() const { return m_azimuth; }

    /// The pixel of a world point; meaningless for points behind the eye.
    glm::dvec2 project(const glm::dvec3 &world) const;
    /// The ray through a pixel, in world coordinates and in those of a tilted board.
    Ray ray(const glm::dvec2 &pixel) const;
    Ray pickRay(const glm::dvec2 &pixel, const glm::dmat4 &worldFromBoard) const;

private:
    struct Axes {
        glm::dvec3 right, up, back;
    };
    Axes axes() const;
    double metresPerPixel() const; ///< in the plane of the target
    double radius() const;
    void keepWithinLimits();

    glm::dvec2 m_viewport{1.0};
    Bounds m_bounds{{-0.1, -0.1, 0.0}, {0.1, 0.1, 0.02}};
    double m_largestTilt = 0.0;
    glm::dvec3 m_target{0.0};
    double m_distance = 1.0;
    double m_azimuth = kStartAzimuth;
    double m_elevation = kStartElevation;
};

} // namespace inspector::gl
