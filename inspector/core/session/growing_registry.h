// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/setup/handles.h"

#include <QString>

#include <vector>

namespace inspector {

/// The steppers on offer, to which plugins can be added.
class GrowingRegistry {
public:
    GrowingRegistry(const Registry &registry, PluginLoader loader);

    const Registry &now() const { return m_now; }
    /// Adds the steppers of this file. On failure nothing changes.
    bool load(const QString &file, QString *error);

private:
    PluginLoader m_loader;
    Registry m_now;
    std::vector<Registry> m_before; ///< their rows and names are still in use
};

} // namespace inspector
