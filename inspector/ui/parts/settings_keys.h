// SPDX-License-Identifier: GPL-3.0-or-later
// Keys of the window's settings. Best times are stored by the game.
#pragma once

#include <QString>

namespace inspector::ui::settings_keys {

inline const QString kGeometry = QStringLiteral("window/geometry");
inline const QString kLayout = QStringLiteral("window/layout");
inline const QString kDockRoom = QStringLiteral("window/dock_room"); ///< across the docks of each area
inline const QString kTheme = QStringLiteral("window/theme");        ///< number of a Theme
inline const QString kTextSize = QStringLiteral("window/text_size"); ///< number of one of kTextScales
inline const QString kQuality = QStringLiteral("window/quality"); ///< number of a gl::Quality; absent: the view chooses
inline const QString kPictureScale = QStringLiteral("window/picture_scale"); ///< 1 to 4 pixels per pixel of the view
inline const QString kPlots = QStringLiteral("window/plots");                ///< what each shows
inline const QString kPlotSizes = QStringLiteral("window/plot_sizes");       ///< their heights
inline const QString kWatched = QStringLiteral("window/watched");            ///< quantities
inline const QString kFolder = QStringLiteral("window/folder"); ///< the folder in which a file was last chosen
inline const QString kShowBounces = QStringLiteral("window/show_bounces"); ///< in the view
inline const QString kShowWayAhead = QStringLiteral("window/show_way_ahead");
inline const QString kRecent = QStringLiteral("window/recent");           ///< files, newest first
inline const QString kParameterSets = QStringLiteral("parameter_sets/");  ///< and a name: its text
inline const QString kFitQuantities = QStringLiteral("track/quantities"); ///< words of parseFitQuantities()
inline const QString kTradeColumns = QStringLiteral("trade/columns");     ///< ids of those that its table shows
inline const QString kBounces = QStringLiteral("bounces/");               ///< and the name of a box of the dock

} // namespace inspector::ui::settings_keys
