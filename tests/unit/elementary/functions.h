// SPDX-License-Identifier: MIT
// The elementary functions by name, as functions of two numbers.
#pragma once

#include "base/elementary.h"

#include <string_view>

namespace elementary {

struct Function {
    std::string_view name;
    double (*at)(double x, double y); ///< those of one argument ignore y
};

inline constexpr Function kFunctions[] = {
    {"exp", [](double x, double) { return phys::elementary::exp(x); }},
    {"expm1", [](double x, double) { return phys::elementary::expm1(x); }},
    {"log", [](double x, double) { return phys::elementary::log(x); }},
    {"log1p", [](double x, double) { return phys::elementary::log1p(x); }},
    {"root", [](double x, double y) { return phys::elementary::root(x, static_cast<int>(y)); }},
    {"sin", [](double x, double) { return phys::elementary::sin(x); }},
    {"cos", [](double x, double) { return phys::elementary::cos(x); }},
    {"atan2", [](double x, double y) { return phys::elementary::atan2(x, y); }},
    {"hypot", [](double x, double y) { return phys::elementary::hypot(x, y); }},
};

inline const Function *find(std::string_view name) {
    for (const Function &function : kFunctions) {
        if (function.name == name) return &function;
    }
    return nullptr;
}

} // namespace elementary
