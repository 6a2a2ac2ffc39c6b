// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <physics/physics.h>

#include <QObject>
#include <QString>

#include <functional>
#include <vector>

class QGridLayout;
class QToolButton;
class QWidget;

namespace inspector::ui {

class NumberBox;

/// Which ball the parameter belongs to.
enum class Owner { Ball, Ghost };

/// The widgets of one parameter in one line of a grid, generated from its row: label, slider and number (or a list of
/// choices, or a check box), reset. They display values passed in and report edits; they don't store the value.
class ParameterRow : public QObject {
    Q_OBJECT

public:
    /// Object names for styles and tests: the row's id + _slider, _box, _choice, _switch, _reset; the ghost's have the
    /// prefix ghost_. The ghost's label has the ghost's colour, and is shortened to "ghost" where the line above is the
    /// ball's row.
    struct Place {
        Owner owner;
        bool isBelowTheBalls;
    };
    ParameterRow(const phys_param_row &row, Place place, QGridLayout &grid, int line, QObject *parent);

    void setVisible(bool isVisible);
    void setPalette(const QPalette &palette);
    /// Applies the theme's colours.
    void takeColours();
    void showValue(double value);
    /// Shows the value instead of invalid input.
    void takeBack();
    /// Shows that the value just typed is invalid. False if nothing was typed.
    bool refuse(const QString &reason);
    /// reason: why it can't be edited at the moment; empty if it can.
    void setLocked(const QString &reason);

signals:
    void edited(double value);
    /// A new gesture begins: later edits aren't merged with earlier ones.
    void gestureBegun();

private:
    void addLabel(QGridLayout &grid, int line);
    void addNumber(QGridLayout &grid, int line);
    void addChoice(QGridLayout &grid, int line);
    void addSwitch(QGridLayout &grid, int line);
    void adopt(QWidget *widget, const char *suffix);
    QString help() const;
    QString name() const;

    phys_param_row m_row;
    Place m_place;
    std::vector<QWidget *> m_widgets;
    QWidget *m_slider = nullptr; ///< null for a choice or a switch, as the next one
    NumberBox *m_box = nullptr;
    QToolButton *m_reset;
    QWidget *m_label = nullptr; ///< names the ghost
    std::function<void(double)> m_show;
    bool m_isInitial = true;
    bool m_isLocked = false;
};

} // namespace inspector::ui
