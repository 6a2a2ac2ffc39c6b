// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/run_values.h"

#include "core/recording/recording.h"
#include "core/setup/parameters.h"

#include <algorithm>

namespace inspector {

std::vector<RunValue> changedValues(const KeptRun &run, const Registry &registry) {
    std::vector<RunValue> values;
    const auto add = [&values](const phys_param_row *row, double first, double last) {
        if (first != row->initial || last != row->initial) values.push_back({row, first, last});
    };
    for (const phys_param_row &row : boardRows())
        if (!isTilt(row)) add(&row, run.first.gravity, run.last.gravity);
    phys_stepper_info info;
    const QByteArray &stepper = run.pace.back().first;
    if (phys_registry_find(registry.get(), stepper.constData(), &info, nullptr) != PHYS_OK) return values;
    const std::vector<const phys_param_row *> rows = recordedRows(info);
    const bool isSameStepper = run.pace.front().first == stepper;
    for (const phys_param_row *row : rows) {
        const bool isOwn = std::find(info.rows, info.rows + info.row_count, row) != info.rows + info.row_count;
        const double last = phys_param_get(&run.last.params, row);
        add(row, isOwn && !isSameStepper ? last : phys_param_get(&run.first.params, row), last);
    }
    return values;
}

} // namespace inspector
