// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/setup/parameters.h"

#include "core/setup/handles.h"
#include "core/setup/lines.h"

#include <cmath>
#include <limits>

namespace inspector {

namespace {

constexpr uint32_t boardOffset(size_t place) {
    return uint32_t(offsetof(phys_params, stepper) + place * sizeof(double));
}

/// The floor carries the ball: without gravity no step is possible.
constexpr double kLeastGravity = 1e-6; ///< m/s^2

constexpr size_t kTiltX = 0;
constexpr size_t kTiltY = 1;
constexpr size_t kGravity = 2;

} // namespace

const std::vector<phys_param_row> &boardRows() {
    static const std::vector<phys_param_row> rows{
        {"tilt_x", "Tilt x", "deg", "Slope of the board along x; positive makes the ball roll to the right. Default 0.",
         "", -80.0, 80.0, -kTiltLimit, kTiltLimit, 0.0, 0.1, boardOffset(kTiltX), 0},
        {"tilt_y", "Tilt y", "deg",
         "Slope of the board along y; positive makes the ball roll away from the viewer. Default 0.", "", -80.0, 80.0,
         -kTiltLimit, kTiltLimit, 0.0, 0.1, boardOffset(kTiltY), 0},
        {"gravity", "Gravity", "m/s^2", "Strength of gravity: 9.81 on Earth (default), 1.62 on the Moon.", "",
         kLeastGravity, 1000.0, 0.1, 25.0, 9.81, 0.01, boardOffset(kGravity), 0},
    };
    return rows;
}

bool isTilt(const phys_param_row &row) { return &row == &boardRows()[kTiltX] || &row == &boardRows()[kTiltY]; }

Parameters::Parameters(QObject *parent)
    : QObject(parent) {
    phys_params_init(&m_values.params, sizeof m_values.params);
    phys_params_init(&m_values.board, sizeof m_values.board);
    for (const phys_param_row &row : boardRows()) {
        phys_param_set(&m_values.board, &row, row.initial, nullptr);
        m_rows.push_back(&row);
    }
    uint32_t count = 0;
    const phys_param_row *rows = phys_param_rows(&count);
    for (const phys_param_row *row = rows; row != rows + count; ++row)
        if (!(row->flags & PHYS_ROW_INPUT)) m_rows.push_back(row);
    m_commonCount = int(m_rows.size());
}

int Parameters::indexOf(const QString &id) const {
    const QByteArray wanted = QString(id).replace(QLatin1Char('-'), QLatin1Char('_')).toUtf8();
    for (int i = 0; i < count(); ++i)
        if (wanted == row(i).id) return i;
    return -1;
}

phys_params &Parameters::owner(Values &values, int index) const {
    return size_t(index) < boardRows().size() ? values.board : values.params;
}

double Parameters::value(int index) const {
    if (index < 0 || index >= count()) return std::numeric_limits<double>::quiet_NaN();
    Values values = m_values;
    return phys_param_get(&owner(values, index), &row(index));
}

bool Parameters::set(int index, double value, QString *error) {
    Values candidate = m_values;
    phys_error failure;
    if (index < 0 || index >= count()) return false;
    if (phys_param_set(&owner(candidate, index), &row(index), value, &failure) != PHYS_OK) {
        tell(error, failure);
        return false;
    }
    return accept(candidate, error);
}

bool Parameters::set(const std::vector<Setting> &settings, QString *error) {
    Values candidate = m_values;
    for (const Setting &setting : settings) {
        const int index = indexOf(setting.id);
        if (index < 0) {
            if (error) *error = "expected the id of a parameter, found " + foundText(setting.id);
            return false;
        }
        phys_error failure;
        if (phys_param_set(&owner(candidate, index), &row(index), setting.value, &failure) != PHYS_OK) {
            tell(error, failure);
            return false;
        }
    }
    return accept(candidate, error);
}

bool Parameters::accept(const Values &values, QString *error) {
    phys_error failure;
    if (phys_params_check(&values.params, &failure) != PHYS_OK) {
        tell(error, failure);
        return false;
    }
    Values before = m_values;
    m_values = values;
    for (int i = 0; i < count(); ++i) {
        const double now = value(i);
        if (now != phys_param_get(&owner(before, i), &row(i))) emit changed(i, now);
    }
    return true;
}

std::vector<Setting> Parameters::initialOfStepper() const {
    std::vector<Setting> settings;
    for (int i = m_commonCount; i < count(); ++i) settings.push_back({QString::fromUtf8(row(i).id), row(i).initial});
    return settings;
}

bool Parameters::isInitial(int index) const { return value(index) == row(index).initial; }

void Parameters::setStepper(const phys_stepper_info &info) {
    m_rows.resize(size_t(m_commonCount));
    m_rows.insert(m_rows.end(), info.rows, info.rows + info.row_count);
    phys_stepper_info_init_params(&info, &m_values.params);
    emit rowsChanged();
}

Inputs Parameters::inputs() const {
    const double *board = m_values.board.stepper;
    Inputs inputs{};
    inputs.params = m_values.params;
    inputs.params.options |= PHYS_OPTION_ORIENTATION;
    inputs.gravity = board[kGravity];
    tiltBoard(inputs, {radians(board[kTiltX]), radians(board[kTiltY])});
    return inputs;
}

std::vector<Setting> settingsOf(const Parameters &parameters) {
    std::vector<Setting> settings;
    settings.reserve(size_t(parameters.count()));
    for (int i = 0; i < parameters.count(); ++i)
        settings.push_back({QString::fromUtf8(parameters.row(i).id), parameters.value(i)});
    return settings;
}

std::vector<Setting> boardSettings(const Parameters &parameters) {
    std::vector<Setting> settings;
    for (int i = 0; i < parameters.count(); ++i) {
        const phys_param_row &row = parameters.row(i);
        if (isTilt(row) || (row.flags & PHYS_ROW_CHOICE) || parameters.isOfStepper(i)) continue;
        settings.push_back({QString::fromUtf8(row.id), parameters.value(i)});
    }
    return settings;
}

std::vector<Setting> differingFrom(const Parameters &parameters, const std::vector<Setting> &settings) {
    std::vector<Setting> others;
    for (const Setting &setting : settings)
        if (parameters.value(parameters.indexOf(setting.id)) != setting.value) others.push_back(setting);
    return others;
}

std::vector<Setting> sharedValues(const Parameters &from, const Parameters &to) {
    std::vector<Setting> shared;
    for (int i = 0; i < from.count(); ++i) {
        const QString id = QString::fromUtf8(from.row(i).id);
        if (!isTilt(from.row(i)) && to.indexOf(id) >= 0) shared.push_back({id, from.value(i)});
    }
    return shared;
}

} // namespace inspector
