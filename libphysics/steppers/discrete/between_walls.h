// SPDX-License-Identifier: MIT
// A ball that rolls on one floor among upright smooth walls: its motion is planar, and the law of contact needs no more
// than a projection of the drive.
#pragma once

#include "contact_step.h"

#include <optional>

namespace phys {

/// The walls of such a ball.
class UprightWalls {
public:
    /// Nothing if the contacts are any others than a top face that the ball lies on and smooth upright features.
    static std::optional<UprightWalls> find(const StepContext &context, const Contacts &contacts, const Ball &ball);

    /// Order 1: a ball at walls gets no speed into them within h. Nothing if the walls leave no such drive.
    std::optional<Vec2> limitDrive(const Vec2 &drive, double h, double tolerance, const Ball &ball);
    /// And it comes at most as far as each wall: from `before` to `ball`. taken: what limitDrive took of the drive.
    /// False if the walls leave no such motion.
    bool limitVelocity(const Vec2 &taken, double h, double tolerance, const Ball &before, Ball &ball);
    /// Whether the ball follows an edge, whose normal turns.
    bool turns(const Ball &ball) const;
    /// Whether the ball comes slowly to a face that it doesn't touch yet.
    bool arrives(double tolerance, const Ball &ball) const;
    /// Order 2: the ball stays at the faces it touches; those it leaves are none. Nothing if they leave no such drive.
    std::optional<Vec2> keepDrive(const Vec2 &drive, double tolerance, Ball &ball);

    /// After the motion: onto the faces that limited the drive.
    void arrive(const Scene &scene, Ball &ball) const;

private:
    struct Wall {
        const Contact *contact;
        Vec2 normal;
        double least;  ///< part along the normal that a drive or velocity must have
        bool isActive; ///< limits it
    };

    std::optional<Vec2> project(const Vec2 &vector);
    bool allows(const Vec2 &vector, double size) const;

    std::array<Wall, Contacts::kMost> m_walls;
    uint32_t m_count = 0;
};

} // namespace phys
