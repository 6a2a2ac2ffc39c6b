// SPDX-License-Identifier: MIT
// Without MPI: a farm of one.
#include "farm.h"

namespace sweep {

Farm::Farm(int &, char **&) {}
Farm::~Farm() = default;
void Farm::computeAll(const Plan &plan, const Listener &listener) const { computeAlone(plan, listener); }
int Farm::agree(int code) const { return code; }

} // namespace sweep
