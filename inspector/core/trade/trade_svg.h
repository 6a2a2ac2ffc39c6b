// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/trade/trade_chart.h"

namespace inspector {

/// The chart as an SVG document, for print.
QByteArray tradeSvg(const ChartDescription &chart);

} // namespace inspector
