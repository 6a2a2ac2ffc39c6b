// SPDX-License-Identifier: MIT
// Checks whether a file is complete enough to be loaded: the system's loader maps missing parts of a truncated file,
// and the process ends when they are accessed.
#pragma once

#include <physics/physics.h>

#include <string>

namespace phys {

/// Checks that `path` is a regular file and, where shared objects are ELF files, that it contains all parts that its
/// headers list.
phys_status checkSharedObjectFile(const std::string &path, phys_error *err);

/// Whether the code or data at `address` comes from a file that has been deleted or replaced since it was loaded: the
/// system's loader knows shared objects by their names, and gives the old one for a new file.
bool isOfDeletedFile(const void *address);

} // namespace phys
