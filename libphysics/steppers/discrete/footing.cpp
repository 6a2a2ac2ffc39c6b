// SPDX-License-Identifier: MIT
#include "footing.h"

namespace phys {

Footing Footing::of(const Contacts &contacts, double tolerance) {
    Footing footing;
    bool isEasy = true;
    for (const Contact &contact : contacts) {
        const bool isUpright = contact.isFace() && contact.sides[2] == 0;
        isEasy = isEasy && contact.gap >= -tolerance && (contact.isTop || isUpright);
        footing.m_hasFloor = footing.m_hasFloor || contact.isTop;
        if (!isUpright) continue;
        footing.m_hasWalls = true;
        const int axis = contact.sides[0] ? 0 : 1;
        footing.m_isFree[2 * axis + (contact.sides[axis] < 0 ? 1 : 0)] = false;
    }
    footing.m_hasFloor = footing.m_hasFloor && isEasy;
    return footing;
}

} // namespace phys
