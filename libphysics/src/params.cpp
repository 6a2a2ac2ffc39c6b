// SPDX-License-Identifier: MIT
#include "params.h"

#include "error.h"

#include <cmath>
#include <cstring>
#include <limits>
#include <utility>

namespace phys {

namespace {

#define PHYS_OFFSET(member) static_cast<uint32_t>(offsetof(phys_params, member))

/// The only place that knows labels, units, ranges and defaults.
constexpr phys_param_row kRows[] = {
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
constexpr size_t kRowCount = std::size(kRows);

double read(const phys_params &params, const phys_param_row &row) {
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

void write(phys_params &params, const phys_param_row &row, double value) {
    char *place = reinterpret_cast<char *>(&params) + row.offset;
    if (row.flags & PHYS_ROW_CHOICE) {
        const auto choice = static_cast<uint32_t>(value);
        std::memcpy(place, &choice, sizeof choice);
        return;
    }
    std::memcpy(place, &value, sizeof value);
}

bool isWithin(double value, const phys_param_row &row) { return value >= row.min && value <= row.max; } // NaN: false

phys_status checkValue(double value, const phys_param_row &row, phys_error *err) {
    const bool whole = !(row.flags & (PHYS_ROW_CHOICE | PHYS_ROW_SWITCH)) || value == std::floor(value);
    if (isWithin(value, row) && whole) return PHYS_OK;
    const char *unit = row.unit[0] ? " " : "";
    return fail(err, PHYS_ERROR_RANGE, "%s is %.9g%s%s; allowed is %s%.9g .. %.9g%s%s", row.id, value, unit, row.unit,
                whole ? "" : "a whole number, ", row.min, row.max, unit, row.unit);
}

/// Unrolled by the compiler: each row becomes two comparisons with constants.
template<size_t... Index>
bool allRowsWithin(const phys_params &params, std::index_sequence<Index...>) {
    return (isWithin(read(params, kRows[Index]), kRows[Index]) & ...);
}

bool rigidFrictionsAgree(const phys_params &params) {
    return params.model != PHYS_MODEL_RIGID || params.rolling_friction <= params.sliding_friction;
}

} // namespace

bool paramsAreValid(const phys_params &params) {
    return params.struct_size == sizeof params && (params.options & ~static_cast<uint32_t>(PHYS_OPTIONS)) == 0 &&
           allRowsWithin(params, std::make_index_sequence<kRowCount>{}) && rigidFrictionsAgree(params);
}

phys_status explainParams(const phys_params &params, phys_error *err) {
    if (params.struct_size != sizeof params) {
        return fail(err, PHYS_ERROR_ARGUMENT, "params.struct_size is %u; expected %zu: call phys_params_init first",
                    params.struct_size, sizeof params);
    }
    if (params.options & ~static_cast<uint32_t>(PHYS_OPTIONS)) {
        return fail(err, PHYS_ERROR_RANGE, "params.options is 0x%x; allowed bits are 0x%x", params.options,
                    PHYS_OPTIONS);
    }
    for (const phys_param_row &row : kRows) {
        if (const phys_status status = checkValue(read(params, row), row, err)) return status;
    }
    if (!rigidFrictionsAgree(params)) {
        return fail(err, PHYS_ERROR_RANGE,
                    "rolling_friction is %.9g; in the rigid model it must not exceed sliding_friction, which is %.9g",
                    params.rolling_friction, params.sliding_friction);
    }
    return PHYS_OK;
}

phys_status checkOwnRows(const phys_params &params, std::span<const phys_param_row *const> rows, phys_error *err) {
    for (const phys_param_row *row : rows) {
        if (const phys_status status = checkValue(read(params, *row), *row, err)) return status;
    }
    return PHYS_OK;
}

} // namespace phys

phys_status phys_params_init(phys_params *params, size_t size) {
    if (!params || size != sizeof *params) return PHYS_ERROR_ARGUMENT;
    *params = phys_params{};
    params->struct_size = sizeof *params;
    for (const phys_param_row &row : phys::kRows) phys::write(*params, row, row.initial);
    return PHYS_OK;
}

const phys_param_row *phys_param_rows(uint32_t *count) {
    if (count) *count = phys::kRowCount;
    return phys::kRows;
}

double phys_param_get(const phys_params *params, const phys_param_row *row) {
    if (!params || !row) return std::numeric_limits<double>::quiet_NaN();
    return phys::read(*params, *row);
}

phys_status phys_param_set(phys_params *params, const phys_param_row *row, double value, phys_error *err) {
    if (!params || !row) return phys::fail(err, PHYS_ERROR_ARGUMENT, "%s is NULL", params ? "row" : "params");
    if (const phys_status status = phys::checkValue(value, *row, err)) return status;
    phys::write(*params, *row, value);
    return PHYS_OK;
}

phys_status phys_params_check(const phys_params *params, phys_error *err) {
    if (!params) return phys::fail(err, PHYS_ERROR_ARGUMENT, "params is NULL");
    return phys::explainParams(*params, err);
}

phys_status phys_gravity_from_tilt(double tilt_x, double tilt_y, double strength, phys_vec3 *out) {
    constexpr double kQuarterTurn = 1.5707963267948966;
    const bool valid = out && std::abs(tilt_x) < kQuarterTurn && std::abs(tilt_y) < kQuarterTurn && strength >= 0.0 &&
                       std::isfinite(strength);
    if (!valid) return PHYS_ERROR_ARGUMENT;
    const double slopeX = std::tan(tilt_x);
    const double slopeY = std::tan(tilt_y);
    const double scale = strength / std::sqrt((slopeX * slopeX + slopeY * slopeY) + 1.0);
    *out = {scale * slopeX, scale * slopeY, -scale};
    return PHYS_OK;
}
