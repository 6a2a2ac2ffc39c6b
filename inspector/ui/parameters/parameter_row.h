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

// Whose parameter it is.
enum class Owner { Ball, Ghost };

// The widgets of one parameter in one line of a grid, made from its row: label, slider and number (or a list of
// choices, or a check box), reset. They show what they are told and say what a person did; the value is elsewhere.
class ParameterRow : public QObject {
    Q_OBJECT

public:
    // Object names for styles and tests: the row's id + _slider, _box, _choice, _switch, _reset; before it ghost_ for
    // the ghost's, whose label says so in its colour; and no more than that where the ball's is the line above.
    struct Place {
        Owner owner;
        bool isBelowTheBalls;
    };
    ParameterRow(const phys_param_row &row, Place place, QGridLayout &grid, int line, QObject *parent);

    void setVisible(bool isVisible);
    // Another theme.
    void takeColours();
    void showValue(double value);
    // The value just typed isn't allowed: said beside it. False if nothing was typed.
    bool refuse(const QString &reason);
    // reason: why it can't be edited just now; empty if it can.
    void setLocked(const QString &reason);

signals:
    void edited(double value);
    // What comes next is another edit than what was.
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
    NumberBox *m_box = nullptr; // of a row that is neither a choice nor a switch
    QToolButton *m_reset;
    QWidget *m_label = nullptr; // that names the ghost
    std::function<void(double)> m_show;
    bool m_isInitial = true;
    bool m_isLocked = false;
};

} // namespace inspector::ui
