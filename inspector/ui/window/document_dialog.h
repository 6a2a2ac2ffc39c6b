// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>

class QLineEdit;
class QTextBrowser;

namespace inspector::ui {

// Where the pages are: the share folder of an installation, else the source tree. Empty if nowhere.
QString documentFolder();

// The pages of documentation, as a book of its own: links between them work, a text is looked for with Ctrl+F.
class DocumentDialog : public QDialog {
    Q_OBJECT

public:
    explicit DocumentDialog(QWidget *parent);

    // page: relative to documentFolder(). section: the number that a heading begins with, or empty. False if the page
    // isn't there.
    bool showPage(const QString &page, const QString &section = {});

private:
    void find();
    void goTo(const QString &section);
    void follow(const QUrl &link);

    QTextBrowser *m_text;
    QLineEdit *m_sought;
};

} // namespace inspector::ui
