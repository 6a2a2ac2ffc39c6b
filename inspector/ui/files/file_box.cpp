// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/files/file_box.h"

#include "core/setup/lines.h"
#include "ui/parts/path_icon.h"

#include <QAction>
#include <QFileInfo>

namespace inspector::ui {

FileBox::FileBox(QWidget *parent)
    : TextBox({}, parent) {
    QAction *open = addAction(glyphIcon(Glyph::Open), QLineEdit::TrailingPosition);
    open->setToolTip(tr("Choose a file…"));
    connect(open, &QAction::triggered, this, &FileBox::chooseWanted);
    connect(this, &QLineEdit::textChanged, this, [this] { mark(false); });
    connect(this, &QLineEdit::editingFinished, this, [this] { mark(true); });
}

bool FileBox::isOfFile() const { return QFileInfo(path()).isFile(); }

QString FileBox::problem() const {
    const bool isWrong = m_isEntered && !path().isEmpty() && !isOfFile();
    return isWrong ? tr("%1: there is no such file").arg(quoted(path())) : QString();
}

void FileBox::mark(bool isEntered) {
    m_isEntered = isEntered;
    const QString problem = this->problem();
    setRefused(!problem.isEmpty());
    setToolTip(problem.isEmpty() ? accessibleDescription() : problem);
}

} // namespace inspector::ui
