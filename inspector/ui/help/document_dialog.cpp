// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/help/document_dialog.h"

#include "ui/parts/described.h"

#include <QBoxLayout>
#include <QCoreApplication>
#include <QDesktopServices>
#include <QDir>
#include <QFileInfo>
#include <QKeyEvent>
#include <QLineEdit>
#include <QScreen>
#include <QScrollBar>
#include <QShortcut>
#include <QTextBlock>
#include <QTextBrowser>
#include <QToolButton>

namespace inspector::ui {

namespace {

constexpr QSize kUsualSize(860, 700);
constexpr double kScreenShare = 0.9;

/// The first heading. Qt's reader of Markdown sets code in a heading, and what follows it, like other text.
QString dressHeadings(QTextDocument &page) {
    constexpr int kLargestStep = 4; // as the reader's, for the first level
    QString first;
    for (QTextBlock block = page.begin(); block.isValid(); block = block.next()) {
        const int level = block.blockFormat().headingLevel();
        if (level == 0) continue;
        if (first.isEmpty()) first = block.text();
        QTextCharFormat letters;
        letters.setFontWeight(QFont::Bold);
        letters.setProperty(QTextFormat::FontSizeAdjustment, kLargestStep - level);
        QTextCursor heading(block);
        heading.movePosition(QTextCursor::EndOfBlock, QTextCursor::KeepAnchor);
        heading.mergeCharFormat(letters);
    }
    return first;
}

} // namespace

QString documentFolder() {
    const QString installed = QCoreApplication::applicationDirPath() + QStringLiteral("/../share/physics/doc");
    for (const QString &folder : {installed, QStringLiteral(INSPECTOR_SOURCE_FOLDER)})
        if (QFileInfo::exists(folder + QStringLiteral("/inspector/README.md"))) return QDir::cleanPath(folder);
    return {};
}

DocumentDialog::DocumentDialog(QWidget *parent)
    : QDialog(parent)
    , m_text(new QTextBrowser)
    , m_sought(new QLineEdit) {
    setObjectName(QStringLiteral("document_dialog"));
    resize(kUsualSize.boundedTo(screen()->availableSize() * kScreenShare));
    m_text->setObjectName(QStringLiteral("document"));
    m_text->setAccessibleName(tr("Page"));
    m_text->setOpenLinks(false);
    m_sought->setObjectName(QStringLiteral("document_sought"));
    m_sought->setPlaceholderText(tr("Find in this page"));
    m_sought->setClearButtonEnabled(true);
    describe(m_sought, tr("Find in this page"), tr("Enter goes on to the next place"));

    auto *back = new QToolButton;
    back->setArrowType(Qt::LeftArrow);
    describe(back, tr("Back"), tr("The page before (Alt+Left)"));
    auto *bar = new QHBoxLayout;
    bar->addWidget(back);
    bar->addWidget(m_sought, 1);
    auto *layout = new QVBoxLayout(this);
    layout->addLayout(bar);
    layout->addWidget(m_text, 1);

    connect(back, &QToolButton::clicked, m_text, &QTextBrowser::backward);
    connect(m_text, &QTextBrowser::anchorClicked, this, &DocumentDialog::follow);
    connect(m_text, &QTextBrowser::sourceChanged, this, [this](const QUrl &page) {
        const QString heading = dressHeadings(*m_text->document());
        setWindowTitle(tr("%1 – Help").arg(heading.isEmpty() ? page.fileName() : heading));
    });
    connect(m_sought, &QLineEdit::returnPressed, this, &DocumentDialog::find);
    connect(m_sought, &QLineEdit::textEdited, this, [this] {
        m_text->moveCursor(QTextCursor::Start);
        find();
    });
    connect(new QShortcut(QKeySequence::Find, this), &QShortcut::activated, this, [this] {
        m_sought->setFocus();
        m_sought->selectAll();
    });
}

bool DocumentDialog::showPage(const QString &page, const QString &section) {
    const QString path = documentFolder() + QLatin1Char('/') + page;
    if (!QFileInfo::exists(path)) return false;
    m_text->setSource(QUrl::fromLocalFile(path), QTextDocument::MarkdownResource);
    show();
    goTo(section); // once shown: the page is laid out anew for the window's width
    raise();
    activateWindow();
    m_text->setFocus();
    return true;
}

void DocumentDialog::goTo(const QString &section) {
    if (section.isEmpty()) return;
    for (QTextBlock block = m_text->document()->begin(); block.isValid(); block = block.next()) {
        const bool isHeading = block.blockFormat().headingLevel() > 0;
        if (!isHeading || !(block.text() + QLatin1Char(' ')).startsWith(section + QLatin1Char(' '))) continue;
        m_text->setTextCursor(QTextCursor(block));
        m_text->verticalScrollBar()->setValue(m_text->verticalScrollBar()->value() + m_text->cursorRect().top());
        return;
    }
}

/// What is typed anywhere is sought.
void DocumentDialog::keyPressEvent(QKeyEvent *event) {
    const bool isLetter = !event->text().isEmpty() && event->text().at(0) > QLatin1Char(' ');
    if (!isLetter || event->modifiers() & (Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier))
        return QDialog::keyPressEvent(event);
    m_sought->setFocus();
    m_sought->selectAll();
    QCoreApplication::sendEvent(m_sought, event);
}

/// Searches from the cursor on, then from the top.
void DocumentDialog::find() {
    if (m_text->find(m_sought->text())) return;
    m_text->moveCursor(QTextCursor::Start);
    m_text->find(m_sought->text());
}

/// Pages are shown here; other links are opened by the desktop.
void DocumentDialog::follow(const QUrl &link) {
    const QUrl target = m_text->source().resolved(link);
    if (target.isLocalFile() && target.fileName().endsWith(QLatin1String(".md")))
        m_text->setSource(target, QTextDocument::MarkdownResource);
    else
        QDesktopServices::openUrl(target);
}

} // namespace inspector::ui
