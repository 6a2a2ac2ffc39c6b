// SPDX-License-Identifier: GPL-3.0-or-later
// Loads plugins after probing each in a separate process: a damaged file can crash the system's loader before anything
// in it can be checked, and a constructor may crash or never return.
#pragma once

#include "core/setup/handles.h"

#include <QStringList>

namespace inspector {

/// Like loadPlugin(), but first another process loads the file, makes a step with each of its steppers and exits. That
/// process is this program with kProbeOption; it is killed after 10 s.
bool loadProbedPlugin(const Registry &registry, const QString &path, QString *error);

/// The only argument of that process, not listed by --help. The file's name comes by standard input.
inline constexpr char kProbeOption[] = "--probe-plugin";
/// The main function of that process: returns its exit status. Needs no application.
int probePlugin();

/// A registry with the steppers of these files and of those in the library's search path. Null, with one line in
/// `error`, if one of the files is refused. leftOut: gets a line for each refused file of the search path.
Registry registryWith(const QStringList &plugins, PluginLoader load, QStringList *leftOut, QString *error);

} // namespace inspector
