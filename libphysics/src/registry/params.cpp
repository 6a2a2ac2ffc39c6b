// SPDX-License-Identifier: MIT
#include "registry/params.h"

#include "base/appendable.h"
#include "base/elementary.h"
#include "base/error.h"
#include "base/float_environment.h"
#include "base/numbers.h"

#include <cmath>
#include <cstring>
#include <limits>

namespace phys {

namespace {

void write(phys_params &params, const phys_param_row &row, double value) {
    char *place = reinterpret_cast<char *>(&params) + row.offset;
    if (row.flags & PHYS_ROW_CHOICE) {
        const auto choice = static_cast<uint32_t>(value);
        std::memcpy(place, &choice, sizeof choice);
        return;
    }
    std::memcpy(place, &value, sizeof value);
}

/// Whether the caller's struct is long enough to contain the row's value.
bool hasRow(const phys_params &params, const phys_param_row &row) { return endOf(row) <= params.struct_size; }

/// Whether the row's value is one of the library's or of a stepper's: rows may be copied and changed.
bool hasPlace(const phys_param_row &row) {
    const auto isSame = [&row](const phys_param_row &own) {
        return own.offset == row.offset && ((own.flags ^ row.flags) & PHYS_ROW_CHOICE) == 0;
    };
    return isOwnPlace(row.offset) || std::any_of(std::begin(kRows), std::end(kRows), isSame);
}

phys_status refuseSize(const phys_params &params, phys_error *err) {
    return fail(err, PHYS_ERROR_ARGUMENT, "params.struct_size is %u; expected %zu: call phys_params_init first",
                params.struct_size, sizeof params);
}

bool isTilt(double tiltX, double tiltY, double strength) {
    constexpr double kQuarterTurn = 1.5707963267948966;
    return std::abs(tiltX) < kQuarterTurn && std::abs(tiltY) < kQuarterTurn && strength >= 0.0 &&
           strength <= kLargestNumber;
}

phys_vec3 gravityOf(double tiltX, double tiltY, double strength) {
    // (tan tiltX, tan tiltY, -1) times both cosines: nothing diverges near a quarter turn.
    const double cosineX = elementary::cos(tiltX), cosineY = elementary::cos(tiltY);
    const double x = elementary::sin(tiltX) * cosineY, y = elementary::sin(tiltY) * cosineX;
    const double z = cosineX * cosineY;
    const double scale = strength / std::sqrt((x * x + y * y) + z * z);
    return {scale * x, scale * y, -scale * z};
}

} // namespace

phys_status checkValue(double value, const phys_param_row &row, phys_error *err) {
    if (isAllowed(value, row)) return PHYS_OK;
    const char *unit = row.unit[0] ? " " : "";
    return fail(err, PHYS_ERROR_RANGE, "%s is %.17g%s%s; allowed is %s%.17g .. %.17g%s%s", row.id, value, unit,
                row.unit, mustBeWhole(row) ? "a whole number, " : "", row.min, row.max, unit, row.unit);
}

phys_status explainParams(const phys_params &params, phys_error *err) {
    if (params.struct_size != sizeof params) return refuseSize(params, err);
    if (params.options & ~static_cast<uint32_t>(PHYS_OPTIONS)) {
        return fail(err, PHYS_ERROR_RANGE, "params.options is 0x%x; allowed bits are 0x%x", params.options,
                    PHYS_OPTIONS);
    }
    for (const phys_param_row &row : kRows) {
        if (const phys_status status = checkValue(readRow(params, row), row, err)) return status;
    }
    if (!rigidFrictionsAgree(params)) {
        return fail(err, PHYS_ERROR_RANGE,
                    "rolling_friction is %.17g; in the rigid model it must not exceed sliding_friction, which is %.17g",
                    params.rolling_friction, params.sliding_friction);
    }
    return PHYS_OK;
}

phys_status explainOwnRows(const phys_params &params, std::span<const phys_param_row *const> rows, phys_error *err) {
    for (const phys_param_row *row : rows) {
        if (const phys_status status = checkValue(readRow(params, *row), *row, err)) return status;
    }
    return PHYS_OK;
}

} // namespace phys

phys_status phys_params_init(phys_params *params, size_t size) {
    if (!params || !phys::isKnownSize<phys_params>(size)) return PHYS_ERROR_ARGUMENT;
    phys_params whole{};
    for (const phys_param_row &row : phys::kRows) phys::write(whole, row, row.initial);
    phys::store(whole, size, params);
    return PHYS_OK;
}

const phys_param_row *phys_param_rows(uint32_t *count) {
    if (count) *count = phys::kRowCount;
    return phys::kRows;
}

double phys_param_get(const phys_params *params, const phys_param_row *row) {
    if (!params || !row) return std::numeric_limits<double>::quiet_NaN();
    if (!phys::hasRow(*params, *row)) return row->initial;
    return phys::readRow(*params, *row);
}

phys_status phys_param_set(phys_params *params, const phys_param_row *row, double value, phys_error *err) {
    if (!params || !row) return phys::fail(err, PHYS_ERROR_ARGUMENT, "%s is NULL", params ? "row" : "params");
    if (!phys::isKnownSize<phys_params>(params->struct_size)) return phys::refuseSize(*params, err);
    if (!phys::hasRow(*params, *row)) {
        return phys::fail(err, PHYS_ERROR_ARGUMENT, "params.struct_size is %u; %s needs %zu", params->struct_size,
                          row->id, phys::endOf(*row));
    }
    if (!phys::hasPlace(*row)) {
        return phys::fail(err, PHYS_ERROR_ARGUMENT, "the row %s has the offset %u; expected that of a parameter",
                          row->id, row->offset);
    }
    if (const phys_status status = phys::checkValue(value, *row, err)) return status;
    phys::write(*params, *row, value);
    return PHYS_OK;
}

phys_status phys_params_check(const phys_params *params, phys_error *err) {
    if (!params) return phys::fail(err, PHYS_ERROR_ARGUMENT, "params is NULL");
    if (phys::isOlder(*params)) return phys::explainParams(phys::completed(*params, phys_params_init), err);
    return phys::explainParams(*params, err);
}

phys_status phys_gravity_from_tilt(double tilt_x, double tilt_y, double strength, phys_vec3 *out) {
    return phys_gravities_from_tilts(1, &tilt_x, &tilt_y, &strength, out);
}

phys_status phys_gravities_from_tilts(uint64_t count, const double *tilts_x, const double *tilts_y,
                                      const double *strengths, phys_vec3 *out) {
    const phys::FloatEnvironment environment;
    if (count > 0 && !(tilts_x && tilts_y && strengths && out)) return PHYS_ERROR_ARGUMENT;
    for (uint64_t i = 0; i < count; ++i) {
        if (!phys::isTilt(tilts_x[i], tilts_y[i], strengths[i])) return PHYS_ERROR_ARGUMENT;
    }
    for (uint64_t i = 0; i < count; ++i) out[i] = phys::gravityOf(tilts_x[i], tilts_y[i], strengths[i]);
    return PHYS_OK;
}
