// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/parts/text_box.h"

namespace inspector::ui {

/// The name of a file that is read, as typed, with a button that asks for one. A name of no file is marked once it is
/// entered.
class FileBox : public TextBox {
    Q_OBJECT

public:
    explicit FileBox(QWidget *parent = nullptr);

    QString path() const { return text().trimmed(); }
    bool isOfFile() const; ///< a file of this name exists
    /// Why the name that was entered is marked, one line; empty if it isn't.
    QString problem() const;

signals:
    void chooseWanted();

private:
    void mark(bool isEntered);

    bool m_isEntered = false; ///< since it was edited last
};

} // namespace inspector::ui
