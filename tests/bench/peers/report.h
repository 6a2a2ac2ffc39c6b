// SPDX-License-Identifier: MIT
// The comparison as files: peers.csv, peers.md and the charts.
#pragma once

#include "peers/trial.h"

#include <filesystem>

namespace bench {

void writeCsv(const std::vector<Trial> &trials, const std::filesystem::path &folder);

void writeMarkdown(const std::vector<SceneGroup> &groups, const std::vector<EngineKind> &engines,
                   const std::vector<Trial> &trials, const std::filesystem::path &folder);

// Returns false if only the gnuplot programs could be written.
bool writeCharts(const std::vector<SceneGroup> &groups, const std::vector<Trial> &trials,
                 const std::filesystem::path &folder);

} // namespace bench
