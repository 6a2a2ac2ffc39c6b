// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/program/options.h"

#include <algorithm>

namespace inspector {

bool setParameters(const Options &options, Parameters &parameters, QString *error) {
    phys_stepper_info info;
    if (phys_registry_find(options.registry.get(), options.stepper.constData(), &info, nullptr) == PHYS_OK)
        parameters.setStepper(info);
    return parameters.set(options.settings, error);
}

std::optional<Inputs> ghostsInputs(const Options &options, QString *error) {
    Parameters parameters;
    phys_stepper_info info;
    phys_error failure;
    const char *id = options.comparison->stepper.constData();
    if (phys_registry_find(options.registry.get(), id, &info, &failure) != PHYS_OK) {
        tell(error, failure);
        return std::nullopt;
    }
    parameters.setStepper(info);
    std::vector<Setting> settings;
    std::copy_if(options.settings.begin(), options.settings.end(), std::back_inserter(settings),
                 [&](const Setting &setting) { return parameters.indexOf(setting.id) >= 0; });
    settings.insert(settings.end(), options.comparisonSettings.begin(), options.comparisonSettings.end());
    if (!parameters.set(settings, error)) return std::nullopt;
    return parameters.inputs();
}

} // namespace inspector
