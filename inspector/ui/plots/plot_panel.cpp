// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plots/plot_panel.h"

#include "ui/plots/time_view.h"

#include <QHBoxLayout>
#include <QToolButton>

#include <algorithm>
#include <vector>

namespace inspector::ui {

/// Buttons below each other, in as many columns as the height needs.
class ButtonColumns : public QWidget {
public:
    void add(QToolButton *button) {
        button->setParent(this);
        m_buttons.push_back(button);
        arrange();
    }
    QSize sizeHint() const override { return {width(), int(m_buttons.size()) * pitch()}; }
    QSize minimumSizeHint() const override { return {width(), kFewestRows * pitch()}; }

protected:
    void resizeEvent(QResizeEvent *) override { arrange(); }

private:
    static constexpr int kGap = 2; ///< pixels
    static constexpr int kFewestRows = 2;

    int pitch() const { return m_buttons.front()->sizeHint().height() + kGap; }

    void arrange() {
        const int count = int(m_buttons.size());
        const int rows = std::clamp(height() / pitch(), kFewestRows, std::max(kFewestRows, count));
        const int across = m_buttons.front()->sizeHint().width() + kGap;
        for (int i = 0; i < count; ++i)
            m_buttons[size_t(i)]->setGeometry({{i / rows * across, i % rows * pitch()}, m_buttons.front()->sizeHint()});
        setFixedWidth((count + rows - 1) / rows * across);
    }

    std::vector<QToolButton *> m_buttons;
};

PlotPanel::PlotPanel(QWidget *content, TimeView &time, const QString &prefix, QWidget *parent)
    : QWidget(parent)
    , m_buttons(new ButtonColumns) {
    QToolButton *follow = addButton(Glyph::Follow, prefix + QLatin1String("_follow"), tr("Follow the newest values"));
    QToolButton *pause =
        addButton(Glyph::Pause, prefix + QLatin1String("_pause"), tr("Hold the plots; the simulation goes on"));
    QToolButton *clear = addButton(Glyph::Clear, prefix + QLatin1String("_clear"), tr("Forget what was up to now"));
    QToolButton *save = addButton(Glyph::Save, prefix + QLatin1String("_save"), tr("Save as PNG, PDF or CSV…"));
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
    layout->setSpacing(0);
    layout->addWidget(m_buttons);
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
    m_buttons->add(button);
    return button;
}

} // namespace inspector::ui
