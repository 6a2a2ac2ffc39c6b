// SPDX-License-Identifier: GPL-3.0-or-later
// Plugins, each tried in a process of its own first: one whose headers are damaged ends the process inside of the
// system's loader, before anything of it can be looked at, and a constructor may crash or never return.
#pragma once

#include "core/setup/handles.h"

#include <QStringList>

namespace inspector {

// As loadPlugin(), after another process has loaded the file, made a step by each of its steppers, and come to its end.
// It is this program with kProbeOption; one that doesn't come to its end within 10 s is stopped.
bool loadProbedPlugin(const Registry &registry, const QString &path, QString *error);

// The one argument of that process; --help doesn't list it. The file's name comes by standard input.
inline constexpr char kProbeOption[] = "--probe-plugin";
// What that process does: the status to end with. Needs no application.
int probePlugin();

// With the steppers of these files, and of those in the folders that the library looks through. Null, and one line in
// `error`, if one of the files is refused. leftOut: a line for each file of the folders that is.
Registry registryWith(const QStringList &plugins, PluginLoader load, QStringList *leftOut, QString *error);

} // namespace inspector
