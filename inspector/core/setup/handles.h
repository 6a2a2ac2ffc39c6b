// SPDX-License-Identifier: GPL-3.0-or-later
// Owners of what the library creates. Each keeps alive what it was made from, so they may go in any order.
#pragma once

#include <physics/physics.h>

#include <QByteArray>
#include <QString>

#include <memory>

namespace inspector {

using Registry = std::shared_ptr<phys_registry>;
using Scene = std::shared_ptr<const phys_scene>;
using Stepper = std::shared_ptr<phys_stepper>;

// All return null on failure and put the library's line into `error` (or nullptr).
// Any thread; a stepper then belongs to one thread at a time.
Registry makeRegistry(QString *error);
Scene loadScene(const QString &path, QString *error);
Scene makeScene(const phys_scene_desc &description, QString *error);
Stepper makeStepper(const Registry &registry, const QByteArray &id, const Scene &scene, QString *error);

// Place of a stepper in the registry's order, and its id there. kNoStepper and "" for what isn't there. Any thread.
inline constexpr uint32_t kNoStepper = 0xffffffff;
uint32_t stepperIndex(const Registry &registry, const char *id);
QString stepperName(const Registry &registry, uint32_t index);

// Loads one plugin file into the registry. Only while no other thread uses it.
bool loadPlugin(const Registry &registry, const QString &path, QString *error);
using PluginLoader = bool (*)(const Registry &registry, const QString &path, QString *error);

// Writes the library's text into `error` (or nullptr).
void tell(QString *error, const phys_error &failure);

} // namespace inspector
