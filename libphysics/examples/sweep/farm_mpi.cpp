// SPDX-License-Identifier: MIT
#include "farm.h"

#include <mpi.h>

#include <type_traits>

namespace sweep {

namespace {

constexpr uint64_t kNoMore = UINT64_MAX;
static_assert(std::is_trivially_copyable_v<Outcome>);

void send(uint64_t job, int rank) { MPI_Send(&job, 1, MPI_UINT64_T, rank, 0, MPI_COMM_WORLD); }

void work(const Plan &plan) {
    Roller roller(plan);
    for (;;) {
        uint64_t job = kNoMore;
        MPI_Recv(&job, 1, MPI_UINT64_T, 0, 0, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
        if (job == kNoMore) return;
        const Outcome outcome = roller.run(job);
        MPI_Send(&outcome, sizeof outcome, MPI_BYTE, 0, 0, MPI_COMM_WORLD);
    }
}

/// Each rank gets a new job as soon as it hands in the last one, so that slow jobs hold nobody up.
void handOut(const Plan &plan, int rankCount, const Listener &listener) {
    const uint64_t count = plan.jobCount();
    uint64_t next = 0;
    for (int rank = 1; rank < rankCount; ++rank) send(next < count ? next++ : kNoMore, rank);
    for (uint64_t done = 0; done < count; ++done) {
        Outcome outcome;
        MPI_Status status;
        MPI_Recv(&outcome, sizeof outcome, MPI_BYTE, MPI_ANY_SOURCE, 0, MPI_COMM_WORLD, &status);
        send(next < count ? next++ : kNoMore, status.MPI_SOURCE);
        listener(outcome, status.MPI_SOURCE);
    }
}

} // namespace

Farm::Farm(int &argc, char **&argv) {
    MPI_Init(&argc, &argv);
    MPI_Comm_rank(MPI_COMM_WORLD, &m_rank);
    MPI_Comm_size(MPI_COMM_WORLD, &m_rankCount);
}

Farm::~Farm() { MPI_Finalize(); }

void Farm::computeAll(const Plan &plan, const Listener &listener) const {
    if (m_rankCount == 1)
        computeAlone(plan, listener);
    else if (m_rank == 0)
        handOut(plan, m_rankCount, listener);
    else
        work(plan);
}

int Farm::agree(int code) const {
    MPI_Bcast(&code, 1, MPI_INT, 0, MPI_COMM_WORLD);
    return code;
}

} // namespace sweep
