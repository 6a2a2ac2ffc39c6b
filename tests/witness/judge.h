// SPDX-License-Identifier: MIT
// Judges one case under one stepper: every check, or the one that the case names.
#pragma once

#include "converge.h"
#include "examine.h"

namespace witness {

/// Like examine; with check "law" if the motion doesn't converge to that of the brute force. truth: of this case.
Verdict judgeLaw(const phys_registry *registry, const std::string &stepper, const Case &scene, const Truth &truth);

/// The checks of `scene.check`: "law", or every invariant.
Verdict judge(const phys_registry *registry, const std::string &stepper, const Case &scene);

/// The smallest case found by the search that fails the same check, with a note on what happens.
Case shrink(const phys_registry *registry, const std::string &stepper, const Case &scene, const Verdict &verdict);

} // namespace witness
