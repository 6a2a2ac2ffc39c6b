// SPDX-License-Identifier: MIT
// A parameter sweep over any number of ranks and machines: `mpirun -n 4 sweep ...`, or `sweep ...` alone. The CSV has a
// line for each combination, in the order of the plan: its bytes don't depend on the number of ranks.
// Ends with 0 if every job went well, 1 if some failed, 2 if it couldn't begin or write.
#include "farm.h"

#include <chrono>
#include <cinttypes>
#include <cstdio>
#include <filesystem>
#include <stdexcept>
#include <system_error>

namespace {

namespace fs = std::filesystem;

using sweep::Outcome;
using sweep::Plan;

/// What the name leads to; none if the system doesn't say, as of a name that is too long.
fs::file_type typeOf(const fs::path &name) {
    std::error_code error;
    return fs::status(name, error).type();
}

/// The file that a link points to.
std::string targetOf(const fs::path &name) {
    std::error_code error;
    const fs::path target = fs::weakly_canonical(name, error);
    return (error ? name : target).string();
}

/// Where the CSV goes. A file gets its name when it's complete: a sweep that is cut short leaves no half of a CSV
/// behind. What it has so far is called NAME.part. Renaming would replace a device or a pipe, so these are written as
/// they are.
class Output {
public:
    explicit Output(const fs::path &name)
        : Output(name, typeOf(name)) {}
    ~Output() {
        if (m_file) std::fclose(m_file);
    }
    Output(const Output &) = delete;
    Output &operator=(const Output &) = delete;

    std::FILE *get() const { return m_file; }

    bool complete() {
        const bool isWritten = !std::ferror(m_file);
        const bool isClosed = std::fclose(m_file) == 0;
        m_file = nullptr;
        return isWritten && isClosed && (!m_isRenamed || std::rename(written().c_str(), m_name.c_str()) == 0);
    }

private:
    Output(const fs::path &name, fs::file_type type)
        : m_isRenamed(type == fs::file_type::not_found || type == fs::file_type::regular)
        , m_name(m_isRenamed ? targetOf(name) : name.string())
        , m_file(type == fs::file_type::directory ? nullptr : std::fopen(written().c_str(), "w")) {}

    std::string written() const { return m_isRenamed ? m_name + ".part" : m_name; }

    bool m_isRenamed;
    std::string m_name;
    std::FILE *m_file;
};

/// Text as a field of a CSV (RFC 4180).
std::string quoted(const std::string &text) {
    if (text.find_first_of("\",\r\n") == std::string::npos) return text;
    std::string field = "\"";
    for (const char c : text) field += c == '"' ? "\"\"" : std::string(1, c);
    return field + '"';
}

void writeCsv(const Plan &plan, const std::vector<Outcome> &outcomes, std::FILE *file) {
    std::fprintf(file, "level,stepper,rolling_friction,restitution_wall,dt,steps,x,y,z,vx,vy,vz,flags,impacts,"
                       "energy_lost,state_hash,status\n");
    for (const Outcome &outcome : outcomes) {
        const sweep::Job job = plan.job(outcome.job);
        const phys_state &s = outcome.state;
        std::fprintf(file, "%s,%s,%.17g,%.17g,%.17g,%" PRIu64, quoted(job.level).c_str(), quoted(job.stepper).c_str(),
                     job.friction, job.restitution, job.dt, s.step);
        std::fprintf(file, ",%.17g,%.17g,%.17g,%.17g,%.17g,%.17g", s.position.x, s.position.y, s.position.z,
                     s.velocity.x, s.velocity.y, s.velocity.z);
        std::fprintf(file, ",%" PRIu64 ",%" PRIu64 ",%.17g,%016" PRIx64 ",%s\n", s.flags, outcome.impacts,
                     outcome.energyLost, phys_state_hash(&s), phys_status_name(outcome.error.status));
    }
}

/// Rank 0: gathers, shows progress, names failures. Returns the exit code.
int lead(const sweep::Farm &farm, const Plan &plan) {
    Output csv(plan.file); // before the work: that it can't be written is no surprise at the end
    if (!csv.get()) {
        std::fprintf(stderr, "sweep: %s can't be written\n", plan.file.c_str());
        farm.computeAll(Plan{}, nullptr); // nothing to do: sends the other ranks home
        return 2;
    }
    const uint64_t count = plan.jobCount();
    std::vector<Outcome> outcomes(count);
    uint64_t done = 0;
    uint64_t failed = 0;
    uint64_t steps = 0;
    const auto begin = std::chrono::steady_clock::now();
    farm.computeAll(plan, [&](const Outcome &outcome, int rank) {
        outcomes[outcome.job] = outcome;
        steps += outcome.state.step;
        if (outcome.error.status) {
            ++failed;
            std::fprintf(stderr, "sweep: rank %d, job %" PRIu64 ": %s\n", rank, outcome.job, outcome.error.text);
        }
        ++done;
        const bool isTenth = done * 10 / count != (done - 1) * 10 / count;
        if (isTenth) std::fprintf(stderr, "sweep: %" PRIu64 " of %" PRIu64 " jobs\n", done, count);
    });
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    std::fprintf(stderr, "sweep: %d rank%s: %.0f balls and %.2f million steps a second\n", farm.rankCount(),
                 farm.rankCount() == 1 ? "" : "s", static_cast<double>(count) / seconds,
                 static_cast<double>(steps) / seconds * 1e-6);
    writeCsv(plan, outcomes, csv.get());
    if (!csv.complete()) {
        std::fprintf(stderr, "sweep: %s can't be written\n", plan.file.c_str());
        return 2;
    }
    if (failed) std::fprintf(stderr, "sweep: %" PRIu64 " of %" PRIu64 " jobs failed\n", failed, count);
    return failed ? 1 : 0;
}

} // namespace

int main(int argc, char **argv) {
    const sweep::Farm farm(argc, argv);
    int code = 0;
    try {
        const Plan plan = sweep::readPlan(argc, argv);
        if (farm.rank() == 0)
            code = lead(farm, plan);
        else
            farm.computeAll(plan, nullptr);
    } catch (const std::invalid_argument &problem) { // the same on all ranks
        if (farm.rank() == 0) std::fprintf(stderr, "sweep: %s\n%s", problem.what(), sweep::usage);
        code = 2;
    }
    return farm.agree(code);
}
