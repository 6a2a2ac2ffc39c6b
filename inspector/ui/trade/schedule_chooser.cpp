// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/trade/schedule_chooser.h"

#include "ui/files/file_box.h"
#include "ui/files/file_chooser.h"
#include "ui/parts/described.h"
#include "ui/parts/number_box.h"

#include <QComboBox>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>

#include <limits>

namespace inspector::ui {

ScheduleChooser::ScheduleChooser(QSettings &settings, QWidget *parent)
    : QWidget(parent)
    , m_settings(settings)
    , m_kind(new QComboBox)
    , m_random(new QWidget)
    , m_seed(new NumberBox)
    , m_file(new FileBox) {
    m_kind->setObjectName(QStringLiteral("trade_schedule"));
    m_kind->addItems({tr("Quiet and busy"), tr("Autopilot (quiet)"), tr("Busy"), tr("Random tilts"),
                      tr("Tilts from a file")}); // in the order of Kind
    describe(m_kind, tr("Tilts"), tr("How the board tilts while all steppers are measured"));
    m_kind->setFocusPolicy(Qt::TabFocus); // a click doesn't take the keyboard from the game
    m_seed->setObjectName(QStringLiteral("trade_seed"));
    m_seed->setKind(wholeNumberKind(0, std::numeric_limits<int>::max()));
    m_seed->setValue(1);
    m_seed->setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
    connect(m_seed, &NumberBox::entered, m_seed, &NumberBox::setValue);
    describe(m_seed, tr("Seed of the random tilts"), tr("The same seed gives the same tilts, everywhere"));
    auto *random = new QHBoxLayout(m_random);
    random->setContentsMargins(0, 0, 0, 0);
    random->addWidget(new QLabel(tr("seed")));
    random->addWidget(m_seed);
    addFile();
    auto *layout = new QHBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    for (QWidget *widget : {static_cast<QWidget *>(m_kind), m_random, static_cast<QWidget *>(m_file)})
        layout->addWidget(widget);
    connect(m_kind, &QComboBox::currentIndexChanged, this, &ScheduleChooser::showKind);
    showKind();
}

void ScheduleChooser::addFile() {
    m_file->setObjectName(QStringLiteral("trade_file"));
    m_file->setPlaceholderText(tr("File with rows of time, tilt x, tilt y"));
    describe(m_file, tr("File of tilts"),
             tr("Rows of time [s], tilt x and tilt y [°]; or a table of a run, as --csv writes it"));
    m_file->setMinimumWidth(fontMetrics().averageCharWidth() * 26);
    connect(m_file, &FileBox::chooseWanted, this, &ScheduleChooser::openFile);
    connect(m_file, &FileBox::textChanged, this, &ScheduleChooser::changed);
    connect(m_file, &FileBox::editingFinished, this, &ScheduleChooser::changed);
}

QString ScheduleChooser::words() const {
    switch (Kind(m_kind->currentIndex())) {
    case Both:
        return QStringLiteral("both");
    case Busy:
        return QStringLiteral("busy");
    case Autopilot:
        return QStringLiteral("autopilot");
    case Random:
        return QStringLiteral("random:%1").arg(m_seed->exactText());
    case File:
        break;
    }
    return m_file->isOfFile() ? QFileInfo(m_file->path()).absoluteFilePath() // so that it isn't one of the words
                              : QString();
}

QString ScheduleChooser::problem() const { return m_kind->currentIndex() == File ? m_file->problem() : QString(); }

void ScheduleChooser::showKind() {
    m_random->setVisible(m_kind->currentIndex() == Random);
    m_file->setVisible(m_kind->currentIndex() == File);
    emit changed();
}

void ScheduleChooser::openFile() {
    chooseFile(*this, m_settings,
               {tr("Tilts from a file"), tr("Tables of tilts (*.csv *.txt);;All files (*)"), {}, FileUse::Read},
               [this](const QString &path) { m_file->setText(path); });
}

} // namespace inspector::ui
