// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/trade/trade_picture.h"

#include "ui/plots/plot_file.h"
#include "ui/trade/trade_chart.h"

namespace inspector::ui {

bool writeTradePicture(const ChartDescription &description, const QString &path, QString *error) {
    constexpr int kWidth = 900;
    constexpr int kHeight = 560;
    TradeChart chart;
    chart.setPalette(QPalette(Qt::black, Qt::white));
    chart.show(description, {});
    return savePlot(chart, {kWidth, kHeight}, path, error);
}

} // namespace inspector::ui
