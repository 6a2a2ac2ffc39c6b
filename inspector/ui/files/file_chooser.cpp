// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/files/file_chooser.h"

#include "core/recording/recording.h"
#include "core/setup/lines.h"
#include "ui/parts/settings_keys.h"

#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QMessageBox>
#include <QRegularExpression>
#include <QSettings>
#include <QTemporaryFile>

#include <algorithm>

namespace inspector::ui {

namespace {

/// Whether a file of this name can be written beside others: not a device, and not where the system keeps its own.
bool isInUsualFolder(const QString &path) {
    const QFileInfo target(path);
    if (target.exists() && !target.isFile() && !target.isDir()) return false;
    return QTemporaryFile(target.absolutePath() + QStringLiteral("/XXXXXX")).open();
}

/// A recording can't be made again from anything else, so that only another recording replaces it.
bool replacesARecording(const FileQuestion &question, const QString &path) {
    const QString suffix = QStringLiteral(".rec");
    const bool isRecording = question.filter.contains(suffix) && path.endsWith(suffix, Qt::CaseInsensitive);
    return !isRecording && isRecordingFile(path);
}

/// The endings of the kinds that are offered; none: any.
QStringList endingsOf(const QString &filter) {
    QStringList endings;
    static const QRegularExpression pattern(QStringLiteral("\\*(\\.\\w+)"));
    for (const QRegularExpressionMatch &match : pattern.globalMatch(filter)) endings += match.captured(1);
    return endings;
}

bool hasEnding(const QString &path, const QStringList &endings) {
    return endings.isEmpty() || std::ranges::any_of(endings, [&](const QString &ending) {
               return path.endsWith(ending, Qt::CaseInsensitive);
           });
}

/// Why nothing is saved under this name; empty if it is.
QString reasonAgainst(const FileQuestion &question, const QString &path) {
    if (question.use != FileUse::Write) return {};
    const QStringList endings = endingsOf(question.filter);
    if (!hasEnding(path, endings))
        return QFileDialog::tr("expected a name that ends in %1, found %2")
            .arg(endings.join(QStringLiteral(" or ")), quoted(QFileInfo(path).fileName()));
    if (replacesARecording(question, path))
        return QFileDialog::tr("%1 is a recording, which only another one replaces").arg(quoted(path));
    return {};
}

void sayNothingIsSaved(QWidget &window, const QString &title, const QString &reason) {
    auto *refusal = new QMessageBox(QMessageBox::Warning, title, QFileDialog::tr("%1; nothing was saved").arg(reason),
                                    QMessageBox::Ok, &window);
    refusal->setObjectName(QStringLiteral("nothing_saved"));
    refusal->setAttribute(Qt::WA_DeleteOnClose);
    refusal->open();
}

} // namespace

void chooseFile(QWidget &window, QSettings &settings, const FileQuestion &question,
                const std::function<void(const QString &path)> &use) {
    auto *dialog = new QFileDialog(&window, question.title,
                                   settings.value(settings_keys::kFolder, QDir::currentPath()).toString());
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setNameFilters(question.filter.split(QStringLiteral(";;")));
    dialog->setFileMode(question.use == FileUse::Read ? QFileDialog::ExistingFile : QFileDialog::AnyFile);
    dialog->setAcceptMode(question.use == FileUse::Read ? QFileDialog::AcceptOpen : QFileDialog::AcceptSave);
    if (!question.name.isEmpty()) dialog->selectFile(question.name);
    // A new file's name without a suffix gets that of the selected kind.
    const auto followFilter = [dialog](const QString &filter) {
        dialog->setDefaultSuffix(filter.section(QStringLiteral("*."), 1).section(QLatin1Char(')'), 0, 0));
    };
    if (question.use == FileUse::Write) {
        followFilter(dialog->selectedNameFilter());
        QObject::connect(dialog, &QFileDialog::filterSelected, dialog, followFilter);
    }
    QObject::connect(dialog, &QFileDialog::fileSelected, &window, [=, &window, &settings](const QString &path) {
        const QString reason = reasonAgainst(question, path);
        if (!reason.isEmpty()) return sayNothingIsSaved(window, question.title, reason);
        if (question.use == FileUse::Read || isInUsualFolder(path))
            settings.setValue(settings_keys::kFolder, QFileInfo(path).absolutePath());
        use(path);
    });
    dialog->open();
}

} // namespace inspector::ui
