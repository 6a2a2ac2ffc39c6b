// SPDX-License-Identifier: MIT
// Whether a file is whole enough to be loaded: the system's loader maps what a cut-off file no longer has, and the
// process ends when that is touched.
#pragma once

#include <physics/physics.h>

#include <string>

namespace phys {

/// Checks that `path` is a regular file and, where shared objects are ELF files, that it has all that its headers say.
/// name: what messages call it.
phys_status checkSharedObjectFile(const std::string &path, const char *name, phys_error *err);

} // namespace phys
