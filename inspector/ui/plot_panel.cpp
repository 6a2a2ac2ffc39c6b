// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot_panel.h"

#include "ui/path_icon.h"
#include "ui/velocity_plot.h"

#include <QHBoxLayout>
#include <QToolButton>

namespace inspector::ui {

namespace {

QToolButton *addButton(QBoxLayout &layout, Glyph glyph, const char *name, const QString &tip) {
    auto *button = new QToolButton;
    button->setObjectName(QLatin1String(name));
    button->setIcon(glyphIcon(glyph));
    button->setToolTip(tip);
    button->setAutoRaise(true);
    button->setFocusPolicy(Qt::TabFocus);
    layout.addWidget(button);
    return button;
}

} // namespace

PlotPanel::PlotPanel(const SampleRing &samples, QWidget *parent)
    : QWidget(parent)
    , m_plot(new VelocityPlot(samples)) {
    auto *buttons = new QVBoxLayout;
    buttons->setSpacing(2);
    QToolButton *follow = addButton(*buttons, Glyph::Follow, "plot_follow", tr("Follow the newest values"));
    QToolButton *pause = addButton(*buttons, Glyph::Pause, "plot_pause", tr("Hold the plot; the simulation goes on"));
    QToolButton *clear = addButton(*buttons, Glyph::Clear, "plot_clear", tr("Forget what was up to now"));
    QToolButton *save = addButton(*buttons, Glyph::Save, "plot_save", tr("Save as CSV, PNG or PDF…"));
    buttons->addStretch();
    follow->setCheckable(true);
    follow->setChecked(m_plot->isFollowing());
    pause->setCheckable(true);
    connect(follow, &QToolButton::clicked, m_plot, &VelocityPlot::setFollowing);
    connect(m_plot, &VelocityPlot::followingChanged, follow, &QToolButton::setChecked);
    connect(pause, &QToolButton::clicked, m_plot, &VelocityPlot::setPaused);
    connect(m_plot, &VelocityPlot::pausedChanged, pause, &QToolButton::setChecked);
    connect(clear, &QToolButton::clicked, m_plot, &VelocityPlot::clear);
    connect(save, &QToolButton::clicked, this, &PlotPanel::saveWanted);

    auto *layout = new QHBoxLayout(this);
    layout->setContentsMargins(4, 0, 0, 0);
    layout->setSpacing(2);
    layout->addLayout(buttons);
    layout->addWidget(m_plot, 1);
}

} // namespace inspector::ui
