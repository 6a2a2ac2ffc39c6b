// SPDX-License-Identifier: MIT
// A ball that rolls on one floor among vertical smooth walls: its motion is planar, and the law of contact reduces to a
// projection of the drive.
#pragma once

#include "contact_step.h"

#include <optional>

namespace phys {

/// The walls of such a ball.
class UprightWalls {
public:
    /// Nothing if there are other contacts than a top face on which the ball lies and smooth vertical features.
    static std::optional<UprightWalls> find(const StepContext &context, const Contacts &contacts, const Ball &ball);

    /// Order 1: a ball at walls gains no speed into them within h. Nothing if the walls allow no such drive.
    std::optional<Vec2> limitDrive(const Vec2 &drive, double h, double tolerance, const Ball &ball);
    /// In addition, the ball moves at most up to each wall: from `before` to `ball`. taken: what limitDrive removed
    /// from the drive. False if the walls allow no such motion.
    bool limitVelocity(const Vec2 &taken, double h, double tolerance, const Ball &before, Ball &ball);
    /// Whether the ball moves round an edge, whose normal turns.
    bool turns(const Ball &ball) const;
    /// Whether the ball slowly approaches a face that it doesn't touch yet.
    bool arrives(double tolerance, const Ball &ball) const;
    /// Order 2: the ball stays at the faces it touches; faces that it leaves are ignored. Nothing if they allow no such
    /// drive.
    std::optional<Vec2> keepDrive(const Vec2 &drive, double tolerance, Ball &ball);

    /// After the motion: puts the ball onto the faces that limited the drive.
    void arrive(const Scene &scene, Ball &ball) const;

private:
    struct Wall {
        const Contact *contact;
        Vec2 normal;
        double least;  ///< least component along the normal of a drive or velocity
        bool isActive; ///< limits it
    };

    std::optional<Vec2> project(const Vec2 &vector);
    bool allows(const Vec2 &vector, double size) const;

    std::array<Wall, Contacts::kMost> m_walls;
    uint32_t m_count = 0;
};

} // namespace phys
