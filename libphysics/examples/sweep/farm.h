// SPDX-License-Identifier: MIT
// Who computes which job: rank 0 hands them out one by one, the others ask for more until there are none. Where there
// is no MPI there is one rank.
#pragma once

#include "roll.h"

#include <functional>

namespace sweep {

/// Called on rank 0 for each job, in the order in which they end; rank: which one computed it.
using Listener = std::function<void(const Outcome &outcome, int rank)>;

class Farm {
public:
    /// Takes the arguments that are meant for MPI.
    Farm(int &argc, char **&argv);
    ~Farm();
    Farm(const Farm &) = delete;
    Farm &operator=(const Farm &) = delete;

    int rank() const { return m_rank; }
    int rankCount() const { return m_rankCount; }
    /// Computes all jobs; called by all ranks. A single rank computes them itself.
    void computeAll(const Plan &plan, const Listener &listener) const;
    /// What rank 0 says; called by all ranks.
    int agree(int code) const;

private:
    int m_rank = 0;
    int m_rankCount = 1;
};

inline void computeAlone(const Plan &plan, const Listener &listener) {
    Roller roller(plan);
    for (uint64_t job = 0; job < plan.jobCount(); ++job) listener(roller.run(job), 0);
}

} // namespace sweep
