// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/parts/file_chooser.h"

#include "ui/parts/settings_keys.h"

#include <QFileDialog>
#include <QSettings>

namespace inspector::ui {

void chooseFile(QWidget &window, QSettings &settings, const FileQuestion &question,
                const std::function<void(const QString &path)> &use) {
    auto *dialog = new QFileDialog(&window, question.title, settings.value(settings_keys::kFolder).toString());
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setNameFilters(question.filter.split(QStringLiteral(";;")));
    dialog->setFileMode(question.use == FileUse::Read ? QFileDialog::ExistingFile : QFileDialog::AnyFile);
    dialog->setAcceptMode(question.use == FileUse::Read ? QFileDialog::AcceptOpen : QFileDialog::AcceptSave);
    if (!question.name.isEmpty()) dialog->selectFile(question.name);
    // A name without a suffix gets that of the selected kind of file.
    const auto followFilter = [dialog](const QString &filter) {
        dialog->setDefaultSuffix(filter.section(QStringLiteral("*."), 1).section(QLatin1Char(')'), 0, 0));
    };
    followFilter(dialog->selectedNameFilter());
    QObject::connect(dialog, &QFileDialog::filterSelected, dialog, followFilter);
    QObject::connect(dialog, &QFileDialog::fileSelected, &window, [&settings, use](const QString &path) {
        settings.setValue(settings_keys::kFolder, QFileInfo(path).absolutePath());
        use(path);
    });
    dialog->open();
}

} // namespace inspector::ui
