// SPDX-License-Identifier: MIT
// The measurements of the report card. Each returns its result; `isWrong` if that breaks a promise.
#pragma once

#include <physics/physics.h>

#include <string>

namespace plugin_check {

struct Measure {
    bool isWrong = false;
    std::string text;
    bool isOpen = false; ///< not judged: it had no time
};

/// A stepper of a registry.
struct Subject {
    const phys_registry *registry;
    std::string id;
};

Measure smoothMotion(const Subject &subject);
Measure impacts(const Subject &subject);
Measure invariants(const Subject &subject);
Measure law(const Subject &subject);
Measure energyAtRest(const Subject &subject);
Measure energyPerBounce(const Subject &subject);
Measure tunnelling(const Subject &subject);
Measure threads(const Subject &subject);
Measure reports(const Subject &subject);
Measure memory(const Subject &subject);
Measure smallStack(const Subject &subject);
Measure extremes(const Subject &subject);
Measure misuse(const Subject &subject);
Measure cost(const Subject &subject);

} // namespace plugin_check
