// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/parameters/parameter_row.h"

#include "ui/parts/number_box.h"
#include "ui/parts/path_icon.h"
#include "ui/parts/printed_unit.h"

#include <QCheckBox>
#include <QComboBox>
#include <QEvent>
#include <QGridLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QSlider>
#include <QToolButton>

#include <algorithm>
#include <cmath>

namespace inspector::ui {

namespace {

enum GridColumn { kLabel, kEditor, kNumber, kReset };

// A slider counts in whole notches.
struct Notches {
    double low, high;
    int count;

    explicit Notches(const phys_param_row &row)
        : low(row.low)
        , high(row.high)
        , count(int(std::clamp(std::round((row.high - row.low) / row.step), 1.0, 10000.0))) {}

    int at(double value) const { return int(std::lround((std::clamp(value, low, high) - low) / (high - low) * count)); }
    double value(int notch) const {
        const double raw = low + (high - low) * notch / count;
        return std::round(raw * 1e9) / 1e9; // 0.3, not 0.30000000000000004
    }
};

} // namespace

ParameterRow::ParameterRow(const phys_param_row &row, QGridLayout &grid, int line, QObject *parent)
    : QObject(parent)
    , m_row(row)
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
}

void ParameterRow::adopt(QWidget *widget, const char *suffix) {
    widget->setObjectName(QString::fromLatin1(m_row.id) + QLatin1String(suffix));
    m_widgets.push_back(widget);
}

void ParameterRow::addLabel(QGridLayout &grid, int line) {
    auto *label = new QLabel(QString::fromUtf8(m_row.label));
    adopt(label, "_label");
    grid.addWidget(label, line, kLabel);
}

void ParameterRow::addNumber(QGridLayout &grid, int line) {
    const Notches notches(m_row);
    auto *slider = new QSlider(Qt::Horizontal);
    slider->setRange(0, notches.count);
    slider->setPageStep(std::max(1, notches.count / 20));
    slider->setMinimumWidth(70);
    adopt(slider, "_slider");
    auto *box = new NumberBox;
    box->setRow(m_row.min, m_row.max, m_row.step);
    box->setSuffix(m_row.unit[0] ? QLatin1Char(' ') + printedUnit(QString::fromUtf8(m_row.unit)) : QString());
    adopt(box, "_spin");

    for (QWidget *widget : {static_cast<QWidget *>(slider), static_cast<QWidget *>(box)}) {
        widget->setFocusPolicy(Qt::StrongFocus);
        widget->installEventFilter(this);
    }
    connect(slider, &QSlider::sliderPressed, this, &ParameterRow::gestureBegun);
    connect(slider, &QSlider::valueChanged, this, [this, notches](int notch) { emit edited(notches.value(notch)); });
    connect(box, &QAbstractSpinBox::editingFinished, this, &ParameterRow::gestureBegun);
    connect(box, &QDoubleSpinBox::valueChanged, this, &ParameterRow::edited);
    m_show = [slider, box, notches](double value) {
        const QSignalBlocker silentSlider(slider);
        const QSignalBlocker silentBox(box);
        slider->setValue(notches.at(value));
        box->setValue(value);
    };
    grid.addWidget(slider, line, kEditor);
    grid.addWidget(box, line, kNumber);
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
    auto *box = new QCheckBox(QString::fromUtf8(m_row.label));
    box->setFocusPolicy(Qt::TabFocus);
    adopt(box, "_switch");
    connect(box, &QCheckBox::clicked, this, [this](bool isOn) {
        emit gestureBegun();
        emit edited(isOn ? 1.0 : 0.0);
    });
    m_show = [box](double value) { box->setChecked(value != 0.0); };
    grid.addWidget(box, line, kLabel, 1, 3);
}

// Scrolling the panel must not turn what happens to be under the cursor.
bool ParameterRow::eventFilter(QObject *object, QEvent *event) {
    const auto *widget = qobject_cast<const QWidget *>(object);
    if (event->type() != QEvent::Wheel || !widget || widget->hasFocus()) return false;
    event->ignore();
    return true;
}

void ParameterRow::showValue(double value) {
    m_show(value);
    m_isInitial = value == m_row.initial;
    m_reset->setEnabled(!m_isInitial && !m_isLocked);
}

void ParameterRow::setLocked(const QString &reason) {
    m_isLocked = !reason.isEmpty();
    const QString tip = m_isLocked ? QStringLiteral("<p>%1</p><p><i>%2</i></p>").arg(help(), reason.toHtmlEscaped())
                                   : QStringLiteral("<p>%1</p>").arg(help());
    for (QWidget *widget : m_widgets) {
        widget->setEnabled(!m_isLocked);
        widget->setToolTip(tip);
    }
    m_reset->setEnabled(!m_isInitial && !m_isLocked);
    m_reset->setToolTip(tr("Back to %1").arg(m_row.initial));
}

QString ParameterRow::help() const { return QString::fromUtf8(m_row.help).toHtmlEscaped(); }

} // namespace inspector::ui
