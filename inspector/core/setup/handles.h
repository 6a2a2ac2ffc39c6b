// SPDX-License-Identifier: GPL-3.0-or-later
// Shared owners of the library's objects. Each keeps alive what it was made from, so they can be released in any order.
#pragma once

#include <physics/physics.h>

#include <QByteArray>
#include <QString>

#include <memory>

namespace inspector {

using Registry = std::shared_ptr<phys_registry>;
using Scene = std::shared_ptr<const phys_scene>;
using Stepper = std::shared_ptr<phys_stepper>;

/// All return null on failure and put the library's message into `error` (may be nullptr). Any thread; a stepper then
/// belongs to one thread at a time.
Registry makeRegistry(QString *error);
Scene loadScene(const QString &path, QString *error);
Scene makeScene(const phys_scene_desc &description, QString *error);
Stepper makeStepper(const Registry &registry, const QByteArray &id, const Scene &scene, QString *error);

/// A stepper's index in the registry, and the id at an index. kNoStepper and "" for unknown ones. Any thread.
inline constexpr uint32_t kNoStepper = 0xffffffff;
uint32_t stepperIndex(const Registry &registry, const char *id);
QByteArray stepperId(const Registry &registry, uint32_t index);
/// What the window calls a stepper; command line and files call it by its id. Of an unknown one: the id. Any thread.
QString stepperName(const Registry &registry, const QByteArray &id);

/// Loads one plugin file into the registry. No other thread may use the registry meanwhile.
bool loadPlugin(const Registry &registry, const QString &path, QString *error);
using PluginLoader = bool (*)(const Registry &registry, const QString &path, QString *error);

/// Puts the library's message into `error` (may be nullptr).
void tell(QString *error, const phys_error &failure);

} // namespace inspector
