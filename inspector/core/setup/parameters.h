// SPDX-License-Identifier: GPL-3.0-or-later
// The user's values, as a model over parameter rows. Sliders, reset, settings keys, command-line options and columns
// are all generated from the rows; nothing else knows a range, a unit or a default.
#pragma once

#include "core/setup/inputs.h"

#include <QObject>
#include <QString>

#include <vector>

namespace inspector {

/// The board's own rows, in the library's form: tilt_x, tilt_y (deg) and gravity (m/s^2).
const std::vector<phys_param_row> &boardRows();

/// Whether the row is one of the two tilts.
bool isTilt(const phys_param_row &row);

/// A value for the row with this id.
struct Setting {
    QString id;
    double value = 0.0;
    bool operator==(const Setting &) const = default;
};

class Parameters : public QObject {
    Q_OBJECT

public:
    explicit Parameters(QObject *parent = nullptr);

    /// Rows in display order: the board's, the library's, the current stepper's own.
    int count() const { return int(m_rows.size()); }
    const phys_param_row &row(int index) const { return *m_rows[size_t(index)]; }
    bool isOfStepper(int index) const { return index >= m_commonCount; } ///< the row is the stepper's own
    std::vector<Setting> initialOfStepper() const;                       ///< of the stepper's own rows
    /// Index of the row with this id, -1 if there is none. '-' equals '_', so that command-line spelling works, too.
    int indexOf(const QString &id) const;

    /// In the row's unit. NaN for an invalid index.
    double value(int index) const;
    /// Sets a value if the library accepts it, alone and together with the others; otherwise nothing changes and
    /// `error` (may be nullptr) gets the library's message.
    bool set(int index, double value, QString *error = nullptr);
    /// The same for several at once: all or none. They are checked together, so that their order doesn't matter.
    bool set(const std::vector<Setting> &settings, QString *error = nullptr);
    bool isInitial(int index) const;

    /// Replaces the stepper's own rows, at their initial values. The texts in `info` must live as long as the registry.
    void setStepper(const phys_stepper_info &info);

    /// The inputs of the next step. Orientation is on: this program draws the ball.
    Inputs inputs() const;

signals:
    /// Sent after each change of a value; inputs() is up to date.
    void changed(int index, double value);
    /// The list of rows has changed.
    void rowsChanged();

private:
    /// The board's rows address the `stepper` values of a phys_params of their own, so that the library reads, writes
    /// and checks them like any other row.
    struct Values {
        phys_params board;
        phys_params params;
    };

    phys_params &owner(Values &values, int index) const;
    bool accept(const Values &values, QString *error);

    std::vector<const phys_param_row *> m_rows;
    int m_commonCount = 0; ///< rows before the stepper's own
    Values m_values;
};

/// All values of the parameters.
std::vector<Setting> settingsOf(const Parameters &parameters);
/// What a ball rolls on, whatever its model and stepper: without the tilt, the rows that are choices, and the
/// stepper's.
std::vector<Setting> boardSettings(const Parameters &parameters);
/// Those of the settings whose values aren't set any more.
std::vector<Setting> differingFrom(const Parameters &parameters, const std::vector<Setting> &settings);
/// The values of the rows that both have, except the tilt, for one ball to take over from another.
std::vector<Setting> sharedValues(const Parameters &from, const Parameters &to);

} // namespace inspector
