// SPDX-License-Identifier: MIT
// What keeps a ball that touches solids without moving towards them on its way: model.md 6.
#pragma once

#include "board.h"

namespace phys {

/// The acceleration that acts on a ball between events, and the resistance against its motion.
struct Drive {
    Vec3 A{0.0};
    double B = 0.0;
};

/// The constraint that a ball moves under.
struct Hold {
    enum class Kind {
        none,   ///< moves freely
        face,   ///< along a face: `plane`, until the face ends
        edge,   ///< round the vertical edge `corner`
        wedged, ///< the solids take away all of A: rests, or falls between them
        beyond  ///< presses on something that 6.5 leaves out: not vertical, or in too many places
    };
    Kind kind = Kind::none;
    Touch touch{};       ///< what holds it
    Plane plane{};       ///< face
    Vec2 corner{0.0};    ///< edge
    Vec3 direction{0.0}; ///< unit: of the motion, or in which it starts; zero if there is none
    double start = 0.0;  ///< v = 0: size of the acceleration A_c left by the solids, model.md 6.3
};

/// For a ball with v != 0 whose contacts are all resolved. If two solids leave no way, v becomes zero but for a fall
/// beside upright ones.
Hold holdMoving(const Board &board, const Touches &touches, const Vec3 &p, Vec3 &v, const Drive &drive);

/// For a ball with v = 0.
Hold holdResting(const Board &board, const Touches &touches, const Vec3 &p, const Drive &drive);

/// That contact, as seen by a ball that goes neither way.
Hold holdAt(const Board &board, const Touch &touch, const Vec3 &p);

/// Normal acceleration with which a ball of velocity v is driven back to what it touches, curvature included; <= 0 if
/// it isn't. For the rule that ends infinitely many bounces, model.md 6.4.
double pressing(const Board &board, const Touch &touch, const Vec3 &v, const Drive &drive);

} // namespace phys
