// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/setup/parameters.h"

#include <QString>

namespace inspector::ui {

/// Gravity of 1.62 m/s², Restitution, walls of 0.5
QString settingsText(const Parameters &parameters, const std::vector<Setting> &settings);

} // namespace inspector::ui
