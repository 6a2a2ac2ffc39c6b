// SPDX-License-Identifier: MIT
#include "peers/report.h"

#include <fstream>

namespace bench {

void writeCsv(const std::vector<Trial> &trials, const std::filesystem::path &folder) {
    std::ofstream out(folder / "peers.csv");
    out.precision(9);
    out << "group,scene,engine,step_s,cpu_ns_per_step,cpu_us_per_simulated_s,spread,error_final_radii,error_largest_"
           "radii,"
           "x_m,y_m,failure\n";
    for (const Trial &trial : trials)
        for (std::size_t scene = 0; scene < trial.errors.size(); ++scene) {
            const SceneError &error = trial.errors[scene];
            out << trial.group << "," << scene << "," << trial.engine << "," << trial.dt << ","
                << trial.secondsPerStep * 1e9 << "," << trial.secondsPerSimulated * 1e6 << "," << trial.spread << ","
                << error.final << "," << error.largest << "," << error.last.position.x << "," << error.last.position.y
                << ",\"" << error.failure << "\"\n";
        }
}

} // namespace bench
