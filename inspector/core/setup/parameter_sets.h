// SPDX-License-Identifier: GPL-3.0-or-later
// Named sets of parameters, some from published measurements, and their text format:
//
//   physics-parameters 1
//   name Steel on wood
//   set rolling_friction 0.002            as in a recording; a line each
//   # ...                                 a comment
#pragma once

#include "core/setup/parameters.h"

#include <QByteArray>

#include <optional>

namespace inspector {

struct ParameterSet {
    QString name;
    QString about; ///< source of the values; not in its text
    std::vector<Setting> values;
};

/// Sets for materials, from published figures.
const std::vector<ParameterSet> &knownSets();

/// The current values of all rows except the tilt.
ParameterSet presentSet(const QString &name, const Parameters &parameters);
/// The set's values whose rows exist: a stepper's own rows may not.
std::vector<Setting> valuesFor(const Parameters &parameters, const ParameterSet &set);

QByteArray setText(const ParameterSet &set);
/// Returns nothing, with one line in `error` (may be nullptr) that begins with file and line, if the text isn't a set.
std::optional<ParameterSet> readSet(const QByteArray &text, const QString &file, QString *error);

} // namespace inspector
