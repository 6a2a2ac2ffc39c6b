// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/parts/path_icon.h"

#include <QWidget>

class QToolButton;

namespace inspector::ui {

class ButtonColumns;
class TimeView;

/// Plots over time with their buttons: follow, pause, clear, save.
class PlotPanel : public QWidget {
    Q_OBJECT

public:
    /// content: the plots, which the panel takes over. time: their time view. prefix: of the buttons' object names.
    PlotPanel(QWidget *content, TimeView &time, const QString &prefix, QWidget *parent = nullptr);

    QToolButton *addButton(Glyph glyph, const QString &name, const QString &tip);

signals:
    void followWanted(bool isOn);
    void pauseWanted(bool isOn);
    void clearWanted();
    void saveWanted();

private:
    ButtonColumns *m_buttons;
};

} // namespace inspector::ui
