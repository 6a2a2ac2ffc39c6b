// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/parts/file_chooser.h"

#include "core/recording/recording.h"
#include "core/setup/lines.h"
#include "ui/parts/settings_keys.h"

#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QMessageBox>
#include <QSettings>
#include <QTemporaryFile>

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
    return question.use == FileUse::Write && !isRecording && isRecordingFile(path);
}

void sayItStays(QWidget &window, const FileQuestion &question, const QString &path) {
    auto *refusal = new QMessageBox(
        QMessageBox::Warning, question.title,
        QFileDialog::tr("%1 is a recording, which only another one replaces; nothing was saved").arg(quoted(path)),
        QMessageBox::Ok, &window);
    refusal->setObjectName(QStringLiteral("recording_stays"));
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
        if (replacesARecording(question, path)) return sayItStays(window, question, path);
        if (question.use == FileUse::Read || isInUsualFolder(path))
            settings.setValue(settings_keys::kFolder, QFileInfo(path).absolutePath());
        use(path);
    });
    dialog->open();
}

} // namespace inspector::ui
