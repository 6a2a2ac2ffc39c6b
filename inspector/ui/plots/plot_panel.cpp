// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plots/plot_panel.h"

#include "ui/parts/path_icon.h"
#include "ui/plots/time_plot.h"

#include <QHBoxLayout>
#include <QToolButton>

namespace inspector::ui {

namespace {

QToolButton *addButton(QBoxLayout &layout, Glyph glyph, const QString &name, const QString &tip) {
    auto *button = new QToolButton;
    button->setObjectName(name);
    button->setIcon(glyphIcon(glyph));
    button->setToolTip(tip);
    button->setAutoRaise(true);
    button->setFocusPolicy(Qt::TabFocus);
    layout.addWidget(button);
    return button;
}

} // namespace

PlotPanel::PlotPanel(TimePlot *plot, const QString &prefix, QWidget *parent)
    : QWidget(parent)
    , m_plot(plot) {
    auto *buttons = new QVBoxLayout;
    buttons->setSpacing(2);
    QToolButton *follow =
        addButton(*buttons, Glyph::Follow, prefix + QLatin1String("_follow"), tr("Follow the newest values"));
    QToolButton *pause = addButton(*buttons, Glyph::Pause, prefix + QLatin1String("_pause"),
                                   tr("Hold the plot; the simulation goes on"));
    QToolButton *clear =
        addButton(*buttons, Glyph::Clear, prefix + QLatin1String("_clear"), tr("Forget what was up to now"));
    QToolButton *save =
        addButton(*buttons, Glyph::Save, prefix + QLatin1String("_save"), tr("Save as CSV, PNG or PDF…"));
    buttons->addStretch();
    follow->setCheckable(true);
    follow->setChecked(m_plot->isFollowing());
    pause->setCheckable(true);
    connect(follow, &QToolButton::clicked, m_plot, &TimePlot::setFollowing);
    connect(m_plot, &TimePlot::followingChanged, follow, &QToolButton::setChecked);
    connect(pause, &QToolButton::clicked, m_plot, &TimePlot::setPaused);
    connect(m_plot, &TimePlot::pausedChanged, pause, &QToolButton::setChecked);
    connect(clear, &QToolButton::clicked, m_plot, &TimePlot::clear);
    connect(save, &QToolButton::clicked, this, &PlotPanel::saveWanted);

    auto *layout = new QHBoxLayout(this);
    layout->setContentsMargins(4, 0, 0, 0);
    layout->setSpacing(2);
    layout->addLayout(buttons);
    layout->addWidget(m_plot, 1);
}

} // namespace inspector::ui
