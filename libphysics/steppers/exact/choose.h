// SPDX-License-Identifier: MIT
// Which motion the lasting contacts make: model.md 8.1 and 14.
#pragma once

#include "exact/response.h"
#include "phases/resisted.h"
#include "phases/series.h"
#include "phases/slide.h"
#include "phases/uniform.h"

#include <variant>

namespace phys {

using Phase = std::variant<Uniform, Resisted, Slide, Series>;

/// How the ball goes on.
struct Choice {
    Response response;
    Phase phase;
};

/// Removes from the ball's motion what the response shows to be rounding, and resistance from contacts that begin to
/// slip. Reads nothing of the choice before, in whose place it puts the new one.
phys_status choose(MovingBall &ball, Touching &touching, Choice &choice);

/// Of the lasting contacts the one that is closed, if it is one alone and a face; else kMostHeld.
uint32_t onlyFace(const Touching &touching, const Response &response);

} // namespace phys
