// SPDX-License-Identifier: GPL-3.0-or-later
// Parameters that belong together under a name, some measured by others, and their text:
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
    QString about; // where its values are from; not in its text
    std::vector<Setting> values;
};

// Of materials, from published figures.
const std::vector<ParameterSet> &knownSets();

// Values of all rows but the tilt.
ParameterSet presentSet(const QString &name, const Parameters &parameters);
// Those of its values whose rows are there: a stepper's own may not be.
std::vector<Setting> valuesFor(const Parameters &parameters, const ParameterSet &set);

QByteArray setText(const ParameterSet &set);
// Nothing, and one line in `error` (or nullptr) that begins with the file and the line, if it is no such text.
std::optional<ParameterSet> readSet(const QByteArray &text, const QString &file, QString *error);

} // namespace inspector
