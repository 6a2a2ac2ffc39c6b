// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plots/plot_panel.h"

#include "ui/plots/time_view.h"

#include <QHBoxLayout>
#include <QToolButton>

namespace inspector::ui {

PlotPanel::PlotPanel(QWidget *content, TimeView &time, const QString &prefix, QWidget *parent)
    : QWidget(parent)
    , m_buttons(new QVBoxLayout) {
    auto *side = new QVBoxLayout;
    m_buttons->setSpacing(2);
    side->addLayout(m_buttons);
    side->addStretch();
    QToolButton *follow = addButton(Glyph::Follow, prefix + QLatin1String("_follow"), tr("Follow the newest values"));
    QToolButton *pause =
        addButton(Glyph::Pause, prefix + QLatin1String("_pause"), tr("Hold the plots; the simulation goes on"));
    QToolButton *clear = addButton(Glyph::Clear, prefix + QLatin1String("_clear"), tr("Forget what was up to now"));
    QToolButton *save = addButton(Glyph::Save, prefix + QLatin1String("_save"), tr("Save as CSV, PNG or PDF…"));
    follow->setCheckable(true);
    follow->setChecked(time.isFollowing());
    pause->setCheckable(true);
    connect(follow, &QToolButton::clicked, this, &PlotPanel::followWanted);
    connect(&time, &TimeView::followingChanged, follow, &QToolButton::setChecked);
    connect(pause, &QToolButton::clicked, this, &PlotPanel::pauseWanted);
    connect(&time, &TimeView::pausedChanged, pause, &QToolButton::setChecked);
    connect(clear, &QToolButton::clicked, this, &PlotPanel::clearWanted);
    connect(save, &QToolButton::clicked, this, &PlotPanel::saveWanted);

    auto *layout = new QHBoxLayout(this);
    layout->setContentsMargins(4, 0, 0, 0);
    layout->setSpacing(2);
    layout->addLayout(side);
    layout->addWidget(content, 1);
}

/// A button that doesn't take the keyboard from the game when clicked.
QToolButton *PlotPanel::addButton(Glyph glyph, const QString &name, const QString &tip) {
    auto *button = new QToolButton;
    button->setObjectName(name);
    button->setIcon(glyphIcon(glyph));
    button->setToolTip(tip);
    button->setAccessibleName(tip);
    button->setAutoRaise(true);
    button->setFocusPolicy(Qt::TabFocus);
    m_buttons->addWidget(button);
    return button;
}

} // namespace inspector::ui
