// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QString>

class QMenu;

namespace inspector::ui {

/// Gives each entry of every menu that is opened a letter of its text, underlined, by which it is chosen. An entry
/// keeps its letter, also one that its text came with.
class MenuLetters : public QObject {
    Q_OBJECT

public:
    explicit MenuLetters(QWidget &window);

protected:
    bool eventFilter(QObject *object, QEvent *event) override;
};

/// An entry's text, without the mark of its letter.
QString plainText(QString text);

} // namespace inspector::ui
