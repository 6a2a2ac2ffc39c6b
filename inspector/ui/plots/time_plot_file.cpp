// SPDX-License-Identifier: GPL-3.0-or-later
// Saving a plot to a file.
#include "core/program/csv_writer.h"
#include "ui/plots/plot_file.h"
#include "ui/plots/time_plot.h"

namespace inspector::ui {

bool TimePlot::save(const QString &path, QString *error) {
    refresh();
    if (path.endsWith(QLatin1String(".csv"), Qt::CaseInsensitive))
        return saveSamples(path, m_samples, m_time->clearedAt(), columns(), error);
    const QSize picture = size().expandedTo(kLeastPlotSize);
    dressForPicture(picture.height());
    const bool isSaved = savePlot(*this, picture, path, error);
    dressForWindow();
    return isSaved;
}

} // namespace inspector::ui
