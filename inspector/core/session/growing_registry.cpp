// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/growing_registry.h"

#include "core/setup/files.h"

#include <QStringList>

#include <utility>

namespace inspector {

GrowingRegistry::GrowingRegistry(const Registry &registry, PluginLoader loader)
    : m_loader(loader)
    , m_now(registry) {}

/// Other threads are reading the registry, which must not change then: they continue with the old one.
bool GrowingRegistry::load(const QString &file, QString *error) {
    const Registry registry = makeRegistry(error);
    if (!registry) return false;
    QStringList files;
    phys_stepper_info info;
    for (uint32_t i = 0; phys_registry_info(m_now.get(), i, &info) == PHYS_OK; ++i) {
        const QString before = decodePath(info.file);
        if (!before.isEmpty() && !files.contains(before)) files += before;
    }
    for (const QString &before : files)
        if (!loadPlugin(registry, before, error)) return false;
    if (!m_loader(registry, file, error)) return false;
    m_before.push_back(std::exchange(m_now, registry));
    return true;
}

} // namespace inspector
