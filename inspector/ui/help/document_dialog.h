// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>

class QLineEdit;
class QTextBrowser;

namespace inspector::ui {

/// The folder of the pages: the share folder of an installation, else the source tree. Empty if there is none.
QString documentFolder();

/// The documentation pages: links between them work, what is typed is sought.
class DocumentDialog : public QDialog {
    Q_OBJECT

public:
    explicit DocumentDialog(QWidget *parent);

    /// page: relative to documentFolder(). section: the number that begins a heading, or empty. False if there is no
    /// such page.
    bool showPage(const QString &page, const QString &section = {});

protected:
    void keyPressEvent(QKeyEvent *event) override;

private:
    void find();
    void goTo(const QString &section);
    void follow(const QUrl &link);

    QTextBrowser *m_text;
    QLineEdit *m_sought;
};

} // namespace inspector::ui
