// SPDX-License-Identifier: MIT
// The table of parameter rows, and the check of parameters in every step.
#pragma once

#include "base/pair.h"

#include <physics/physics.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <iterator>
#include <span>
#include <utility>

namespace phys {

#define PHYS_OFFSET(member) static_cast<uint32_t>(offsetof(phys_params, member))

/// The only definition of labels, units, ranges and defaults.
inline constexpr phys_param_row kRows[] = {
    {"model", "Model", "",
     "Rolling: the ball always rolls, the cheap model. Rigid: it can slip and keeps its spin through impacts. "
     "Default: Rolling.",
     "Rolling\nRigid", 0, 1, 0, 1, PHYS_MODEL_ROLLING, 1, PHYS_OFFSET(model), PHYS_ROW_CHOICE},
    {"restitution_wall", "Restitution, walls", "",
     "Share of the normal speed that a wall gives back: 0 sticks, 1 loses nothing. Steel on wood: about 0.5. "
     "Default: 0.5.",
     "", 0, 1, 0, 1, 0.5, 0.01, PHYS_OFFSET(restitution_wall), 0},
    {"restitution_floor", "Restitution, floor", "",
     "Share of the vertical speed that the floor gives back when the ball lands. Default: 0.3.", "", 0, 1, 0, 1, 0.3,
     0.01, PHYS_OFFSET(restitution_floor), 0},
    {"rolling_friction", "Rolling friction", "",
     "Resistance to rolling as a share of the normal force: the ball rests up to a slope of atan of it. Steel on wood: "
     "0.001 to 0.01. Rigid model: at most the sliding friction. Default: 0.002.",
     "", 0, 1e6, 0, 0.05, 0.002, 0.0005, PHYS_OFFSET(rolling_friction), 0},
    {"sliding_friction", "Sliding friction", "",
     "Coulomb friction between ball and floor: how fast slip ends; the ball rolls up to a slope of atan of 7/2 of it. "
     "Steel on wood: about 0.3. Default: 0.3.",
     "", 0, 1e6, 0, 1, 0.3, 0.01, PHYS_OFFSET(sliding_friction), PHYS_ROW_RIGID},
    {"wall_friction", "Wall friction", "",
     "Coulomb friction between ball and wall: turns a rolling ball's spin at an impact and lifts it off the floor. "
     "0 is smooth. Default: 0.",
     "", 0, 1e6, 0, 1, 0.0, 0.01, PHYS_OFFSET(wall_friction), PHYS_ROW_RIGID},
    {"gravity_x", "Gravity along x", "m/s^2", "Component of gravity along the board's x. Default: 0.", "", -1e6, 1e6,
     -9.81, 9.81, 0.0, 0.01, PHYS_OFFSET(gravity.x), PHYS_ROW_INPUT},
    {"gravity_y", "Gravity along y", "m/s^2", "Component of gravity along the board's y. Default: 0.", "", -1e6, 1e6,
     -9.81, 9.81, 0.0, 0.01, PHYS_OFFSET(gravity.y), PHYS_ROW_INPUT},
    {"gravity_z", "Gravity along z", "m/s^2",
     "Component of gravity along the board's z, negative while a floor supports the ball. Default: -9.81.", "", -1e6,
     1e6, -19.62, 0, -9.81, 0.01, PHYS_OFFSET(gravity.z), PHYS_ROW_INPUT},
};

inline constexpr size_t kRowCount = std::size(kRows);

/// The largest component of gravity along the board that its row allows, m/s^2.
inline constexpr double kMostGravity = std::find_if(std::begin(kRows), std::end(kRows), [](const phys_param_row &row) {
                                           return row.offset == PHYS_OFFSET(gravity.x);
                                       })->max;
#undef PHYS_OFFSET

/// Size in bytes of phys_params up to the end of the row's value.
constexpr size_t endOf(const phys_param_row &row) {
    return row.offset + (row.flags & PHYS_ROW_CHOICE ? sizeof(uint32_t) : sizeof(double));
}
static_assert(std::all_of(std::begin(kRows), std::end(kRows),
                          [](const phys_param_row &row) { return endOf(row) <= sizeof(phys_params); }));

/// Whether an element of phys_params.stepper begins there.
constexpr bool isOwnPlace(uint32_t offset) {
    constexpr size_t kFirst = offsetof(phys_params, stepper), kEnd = kFirst + sizeof(phys_params::stepper);
    return offset >= kFirst && offset < kEnd && (offset - kFirst) % sizeof(double) == 0;
}

inline double readRow(const phys_params &params, const phys_param_row &row) {
    const char *place = reinterpret_cast<const char *>(&params) + row.offset;
    if (row.flags & PHYS_ROW_CHOICE) {
        uint32_t value = 0;
        std::memcpy(&value, place, sizeof value);
        return value;
    }
    double value = 0.0;
    std::memcpy(&value, place, sizeof value);
    return value;
}

inline bool isWithin(double value, const phys_param_row &row) {
    return value >= row.min && value <= row.max;
} // false for NaN

constexpr bool mustBeWhole(const phys_param_row &row) { return row.flags & (PHYS_ROW_CHOICE | PHYS_ROW_SWITCH); }

inline bool isAllowed(double value, const phys_param_row &row) {
    // The ranges of integer rows are small, so the conversion can't overflow.
    return isWithin(value, row) && (!mustBeWhole(row) || value == static_cast<double>(static_cast<int32_t>(value)));
}

inline bool rigidFrictionsAgree(const phys_params &params) {
    return params.model != PHYS_MODEL_RIGID || params.rolling_friction <= params.sliding_friction;
}

/// The numbers of most rows are adjacent in phys_params.
inline constexpr size_t kFirstNumber = offsetof(phys_params, gravity);
inline constexpr size_t kNumberCount = (offsetof(phys_params, options) - kFirstNumber) / sizeof(double);

constexpr bool isAmongNumbers(const phys_param_row &row) {
    return !mustBeWhole(row) && row.offset >= kFirstNumber && row.offset < kFirstNumber + kNumberCount * sizeof(double);
}

/// Their limits, in the same layout.
struct NumberLimits {
    double min[kNumberCount], max[kNumberCount];

    constexpr NumberLimits()
        : min{}
        , max{} {
        for (const phys_param_row &row : kRows) {
            if (!isAmongNumbers(row)) continue;
            const size_t number = (row.offset - kFirstNumber) / sizeof(double);
            min[number] = row.min;
            max[number] = row.max;
        }
    }
};
inline constexpr NumberLimits kNumberLimits;
static_assert(std::count_if(std::begin(kRows), std::end(kRows), isAmongNumbers) == kNumberCount &&
              kNumberCount % kWidth<Pair> == 0);

inline MaskOf<Pair> areWithinLimits(const double *numbers, size_t i) {
    const Pair number = load<Pair>(numbers + i);
    return all(load<Pair>(kNumberLimits.min + i) <= number, number <= load<Pair>(kNumberLimits.max + i));
}

inline bool numbersAreValid(const phys_params &params) {
    const double *numbers = &params.gravity.x;
    MaskOf<Pair> areFine = areWithinLimits(numbers, 0);
    for (size_t i = kWidth<Pair>; i < kNumberCount; i += kWidth<Pair>)
        areFine = all(areFine, areWithinLimits(numbers, i));
    return areAll(areFine);
}

/// A row of the library.
template<size_t Index>
inline bool rowIsValid(const phys_params &params) {
    constexpr const phys_param_row &row = kRows[Index];
    const double value = readRow(params, row);
    if constexpr (mustBeWhole(row)) return isAllowed(value, row);
    return isWithin(value, row);
}

/// Whether the values of the library's rows are allowed, wherever in phys_params they are. Unrolled manually so that
/// offsets and limits become constants.
template<size_t... Index>
inline bool rowsAreValid(const phys_params &params, std::index_sequence<Index...>) {
    return numbersAreValid(params) && ((isAmongNumbers(kRows[Index]) || rowIsValid<Index>(params)) && ...);
}

template<size_t... Index>
inline bool inputsAreValid(const phys_params &params, std::index_sequence<Index...>) {
    return ((!(kRows[Index].flags & PHYS_ROW_INPUT) || rowIsValid<Index>(params)) && ...);
}

/// The part of paramsAreValid that depends on the gravity of a step.
inline bool gravityIsValid(const phys_params &params) {
    return inputsAreValid(params, std::make_index_sequence<kRowCount>{});
}

/// Whether all values are within their rows' ranges and consistent with each other.
inline bool paramsAreValid(const phys_params &params) {
    return params.struct_size == sizeof params && (params.options & ~static_cast<uint32_t>(PHYS_OPTIONS)) == 0 &&
           rowsAreValid(params, std::make_index_sequence<kRowCount>{}) && rigidFrictionsAgree(params);
}

/// Explains why they are invalid; PHYS_OK if they are valid.
phys_status explainParams(const phys_params &params, phys_error *err);

/// Explains why the value isn't allowed; PHYS_OK if it is.
phys_status checkValue(double value, const phys_param_row &row, phys_error *err);

/// Like explainParams for the values of a stepper's own rows; PHYS_OK if they are valid.
phys_status explainOwnRows(const phys_params &params, std::span<const phys_param_row *const> rows, phys_error *err);

inline phys_status checkOwnRows(const phys_params &params, std::span<const phys_param_row *const> rows,
                                phys_error *err) {
    for (const phys_param_row *row : rows) {
        if (readRow(params, *row) != row->initial) return explainOwnRows(params, rows, err);
    }
    return PHYS_OK; // the usual case
}

} // namespace phys
