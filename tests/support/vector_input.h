// SPDX-License-Identifier: MIT
// Vectors in the files of references: three numbers.
#pragma once

#include <physics/physics.h>

#include <istream>

inline std::istream &operator>>(std::istream &in, phys_vec3 &v) { return in >> v.x >> v.y >> v.z; }
