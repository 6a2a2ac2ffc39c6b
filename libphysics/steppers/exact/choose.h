// SPDX-License-Identifier: MIT
// Chooses the motion that follows from the lasting contacts: model.md 8.1 and 14.
#pragma once

#include "exact/response.h"
#include "phases/pendulum.h"
#include "phases/resisted.h"
#include "phases/series.h"
#include "phases/slide.h"
#include "phases/slip_end.h"
#include "phases/uniform.h"

#include <variant>

namespace phys {

using Phase = std::variant<Uniform, Resisted, SlipEnd, Slide, Pendulum, Series>;

/// The phase that follows.
struct Choice {
    Response response;
    Phase phase;
};

/// Whether a slip may close, which leaves its own way out.
enum class Slips : uint8_t { mayClose, areFollowed };

/// Removes rounding errors from the ball's motion as the response shows them, and resistance from contacts that begin
/// to slip. Independent of the previous choice, which it replaces.
phys_status choose(MovingBall &ball, Touching &touching, Choice &choice, Slips slips = Slips::mayClose);

/// Whether b is parallel to a, in either direction, up to rounding.
bool isCollinear(const Vec3 &a, const Vec3 &b);

} // namespace phys
