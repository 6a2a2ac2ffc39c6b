// SPDX-License-Identifier: GPL-3.0-or-later
// Saving a plot to a file.
#include "core/setup/files.h"
#include "ui/plots/plot_file.h"
#include "ui/plots/time_plot.h"

namespace inspector::ui {

bool TimePlot::save(const QString &path, QString *error) {
    refresh();
    if (!path.endsWith(QLatin1String(".csv"), Qt::CaseInsensitive)) return savePlot(*this, size(), path, error);
    const auto write = [this](QIODevice &file) {
        writeSamples(file, m_samples, m_time->clearedAt(), columns());
        return true;
    };
    return replaceFile(path, write, error);
}

} // namespace inspector::ui
