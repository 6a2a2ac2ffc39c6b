// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/parameters/parameter_row.h"

#include "ui/parameters/fine_slider.h"
#include "ui/parameters/slider_scale.h"
#include "ui/parts/described.h"
#include "ui/parts/number_box.h"
#include "ui/parts/path_icon.h"
#include "ui/parts/theme.h"

#include <QCheckBox>
#include <QComboBox>
#include <QGridLayout>
#include <QGuiApplication>
#include <QLabel>
#include <QSignalBlocker>
#include <QToolButton>

#include <utility>

namespace inspector::ui {

namespace {

enum GridColumn { kLabel, kEditor, kNumber, kReset };

} // namespace

ParameterRow::ParameterRow(const phys_param_row &row, Place place, QGridLayout &grid, int line, QObject *parent)
    : QObject(parent)
    , m_row(row)
    , m_place(place)
    , m_reset(new QToolButton) {
    if (row.flags & PHYS_ROW_SWITCH) {
        addSwitch(grid, line);
    } else if (row.flags & PHYS_ROW_CHOICE) {
        addLabel(grid, line);
        addChoice(grid, line);
    } else {
        addLabel(grid, line);
        addNumber(grid, line);
    }
    m_reset->setIcon(glyphIcon(Glyph::Reset));
    m_reset->setAutoRaise(true);
    m_reset->setFocusPolicy(Qt::TabFocus);
    adopt(m_reset, "_reset");
    grid.addWidget(m_reset, line, kReset);
    connect(m_reset, &QToolButton::clicked, this, [this] {
        emit gestureBegun();
        emit edited(m_row.initial);
    });
    setLocked({});
    takeColours();
}

/// Screen readers list the two balls' parameters side by side.
QString ParameterRow::name() const {
    const QString label = QString::fromUtf8(m_row.label);
    return m_place.owner == Owner::Ghost ? tr("%1, the ghost's").arg(label) : label;
}

void ParameterRow::setVisible(bool isVisible) {
    for (QWidget *widget : m_widgets) widget->setVisible(isVisible);
}

void ParameterRow::setPalette(const QPalette &palette) {
    for (QWidget *widget : m_widgets) widget->setPalette(palette);
}

void ParameterRow::takeColours() {
    if (!m_label) return;
    QPalette palette;
    const QColor colour = accentsFor(QGuiApplication::palette()).ghost;
    for (const auto group : {QPalette::Active, QPalette::Inactive})
        palette.setColor(group, QPalette::WindowText, colour);
    m_label->setPalette(palette);
}

void ParameterRow::adopt(QWidget *widget, const char *suffix) {
    const QString id = QString::fromLatin1(m_row.id) + QLatin1String(suffix);
    widget->setObjectName(m_place.owner == Owner::Ghost ? QStringLiteral("ghost_") + id : id);
    widget->setAccessibleName(name());
    widget->setAccessibleDescription(help());
    m_widgets.push_back(widget);
}

void ParameterRow::addLabel(QGridLayout &grid, int line) {
    const bool isGhosts = m_place.owner == Owner::Ghost;
    auto *label = new QLabel(isGhosts && m_place.isBelowTheBalls ? tr("Ghost") : name());
    if (isGhosts) label->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    if (isGhosts) m_label = label;
    adopt(label, "_label");
    grid.addWidget(label, line, kLabel);
}

void ParameterRow::addNumber(QGridLayout &grid, int line) {
    const SliderScale scale(m_row);
    auto *slider = new FineSlider(scale.last(), SliderScale::kFine);
    adopt(slider, "_slider");
    m_slider = slider;
    m_box = new NumberBox;
    NumberBox::Kind kind = numberKind({m_row.min, m_row.max, QString::fromUtf8(m_row.unit)}, m_row.step);
    kind.widest = kind.show(12.34);
    m_box->setKind(std::move(kind));
    m_box->setSizePolicy(QSizePolicy::MinimumExpanding, QSizePolicy::Fixed);
    adopt(m_box, "_box");

    connect(slider, &QSlider::sliderPressed, this, &ParameterRow::gestureBegun);
    connect(slider, &QSlider::valueChanged, this, [this, scale](int place) { emit edited(scale.valueAt(place)); });
    connect(m_box, &QLineEdit::textEdited, this, &ParameterRow::gestureBegun);
    connect(m_box, &QLineEdit::editingFinished, this, &ParameterRow::gestureBegun);
    connect(m_box, &NumberBox::entered, this, &ParameterRow::edited);
    m_show = [this, slider, scale](double value) {
        const QSignalBlocker silent(slider);
        slider->setValue(scale.placeOf(value));
        m_box->setValue(value);
    };
    grid.addWidget(slider, line, kEditor);
    grid.addWidget(m_box, line, kNumber);
}

void ParameterRow::addChoice(QGridLayout &grid, int line) {
    auto *choice = new QComboBox;
    choice->addItems(QString::fromUtf8(m_row.choices).split(QLatin1Char('\n')));
    choice->setFocusPolicy(Qt::TabFocus);
    adopt(choice, "_choice");
    connect(choice, &QComboBox::activated, this, [this](int index) {
        emit gestureBegun();
        emit edited(m_row.min + index);
    });
    m_show = [choice, first = m_row.min](double value) { choice->setCurrentIndex(int(value - first)); };
    grid.addWidget(choice, line, kEditor, 1, 2);
}

void ParameterRow::addSwitch(QGridLayout &grid, int line) {
    auto *box = new QCheckBox(name());
    if (m_place.owner == Owner::Ghost) m_label = box;
    box->setFocusPolicy(Qt::TabFocus);
    adopt(box, "_switch");
    connect(box, &QCheckBox::clicked, this, [this](bool isOn) {
        emit gestureBegun();
        emit edited(isOn ? 1.0 : 0.0);
    });
    m_show = [box](double value) { box->setChecked(value != 0.0); };
    grid.addWidget(box, line, kLabel, 1, 3);
}

void ParameterRow::showValue(double value) {
    m_show(value);
    m_isInitial = value == m_row.initial;
    m_reset->setEnabled(!m_isInitial && !m_isLocked);
}

void ParameterRow::takeBack() {
    if (m_box && m_box->isRefused()) m_box->takeBack();
}

bool ParameterRow::refuse(const QString &reason) {
    if (!m_box || !m_box->hasFocus()) return false;
    m_box->refuse(reason);
    return true;
}

void ParameterRow::setLocked(const QString &reason) {
    m_isLocked = !reason.isEmpty();
    if (m_isLocked) takeBack();
    const QString tip = wrapped(m_isLocked ? help() + QStringLiteral("\n\n") + reason : help());
    const NumberRange reach{m_row.low, m_row.high, QString::fromUtf8(m_row.unit)};
    for (QWidget *widget : m_widgets) {
        widget->setEnabled(!m_isLocked);
        if (widget != m_box || !m_box->isRefused()) widget->setToolTip(tip);
    }
    if (m_slider) m_slider->setToolTip(tip + QLatin1Char('\n') + numberKind(reach, m_row.step).range);
    m_reset->setEnabled(!m_isInitial && !m_isLocked);
    m_reset->setToolTip(tr("Back to %1").arg(m_row.initial));
    m_reset->setAccessibleName(tr("%1: back to %2").arg(name()).arg(m_row.initial));
}

QString ParameterRow::help() const { return QString::fromUtf8(m_row.help); }

} // namespace inspector::ui
