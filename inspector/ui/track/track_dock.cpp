// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/track/track_dock.h"

#include "core/track/fit_report.h"
#include "core/track/track_reader.h"
#include "ui/parameters/parameter_command.h"
#include "ui/parts/described.h"
#include "ui/parts/file_chooser.h"
#include "ui/parts/path_icon.h"
#include "ui/track/residual_plot.h"

#include <QAction>
#include <QBoxLayout>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QSplitter>
#include <QUndoStack>

namespace inspector::ui {

TrackDock::TrackDock(Session &session, QUndoStack &undo, QWidget *parent)
    : QWidget(parent)
    , m_session(session)
    , m_undo(undo)
    , m_report(new QPlainTextEdit)
    , m_residuals(new ResidualPlot) {
    setObjectName(QStringLiteral("track"));
    m_report->setObjectName(QStringLiteral("track_report"));
    m_report->setAccessibleName(tr("Result of the fit"));
    m_report->setReadOnly(true);
    m_report->setFocusPolicy(Qt::ClickFocus);
    m_report->setPlaceholderText(
        tr("A table of a measured ball, with columns t, x, y and, if measured, tilt_x, tilt_y: the fit finds the "
           "friction, the restitution, the tilt's offset and delay with which the computed ball rolls like it."));
    auto *halves = new QSplitter;
    halves->addWidget(m_report);
    halves->addWidget(m_residuals);
    halves->setSizes({550, 450}); // per mille
    halves->setChildrenCollapsible(false);
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(6, 4, 6, 6);
    layout->addWidget(makeControls());
    layout->addWidget(halves, 1);
    connect(m_fit, &QPushButton::clicked, this, &TrackDock::toggle);
    connect(m_takeOver, &QPushButton::clicked, this, &TrackDock::takeOver);
    connect(m_file, &QLineEdit::textChanged, this, &TrackDock::showRunning);
    connect(&m_worker, &FitWorker::progressed, this,
            [this](double share) { m_progress->setValue(int(share * m_progress->maximum())); });
    connect(&m_worker, &FitWorker::ended, this, &TrackDock::showOutcome);
    connect(&session, &Session::levelOpened, this, [this] { // the fit was of another maze
        m_worker.cancel();
        m_outcome.reset();
        showRunning();
    });
    showRunning();
}

QWidget *TrackDock::makeControls() {
    m_file = new QLineEdit;
    m_file->setObjectName(QStringLiteral("track_file"));
    m_file->setPlaceholderText(tr("Table with columns t, x, y"));
    describe(m_file, tr("Table of the measured ball"),
             tr("A file with columns t, x, y and, if measured, tilt_x, tilt_y"));
    QAction *open = m_file->addAction(glyphIcon(Glyph::Open), QLineEdit::TrailingPosition);
    open->setToolTip(tr("Choose a file…"));
    connect(open, &QAction::triggered, this, &TrackDock::openFile);
    m_units = new QLineEdit;
    m_units->setObjectName(QStringLiteral("track_units"));
    m_units->setPlaceholderText(tr("Units: t=ms, x=mm, px=0.25mm, fps=60, mirror=y"));
    describe(m_units, tr("Units of the table"), tr("What the names of the columns don't say"));
    m_fit = new QPushButton(tr("Fit"));
    m_fit->setObjectName(QStringLiteral("track_fit"));
    describe(m_fit, {}, tr("Find the board on which the computed ball rolls like the measured one"));
    m_takeOver = new QPushButton(tr("Take over"));
    m_takeOver->setObjectName(QStringLiteral("track_take_over"));
    describe(m_takeOver, {}, tr("Set model and coefficients to what the fit has found"));
    m_progress = new QProgressBar;
    m_progress->setRange(0, 1000);
    m_progress->setAccessibleName(tr("Progress of the fit"));
    for (QPushButton *button : {m_fit, m_takeOver}) button->setFocusPolicy(Qt::TabFocus); // keys stay the game's
    auto *controls = new QWidget;
    auto *layout = new QHBoxLayout(controls);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_file, 3);
    layout->addWidget(m_units, 2);
    layout->addWidget(m_fit);
    layout->addWidget(m_progress, 1);
    layout->addWidget(m_takeOver);
    return controls;
}

void TrackDock::openFile() {
    chooseFile(*this, m_session.settings(),
               {tr("A measured ball"), tr("Tables (*.csv *.txt *.tsv);;All files (*)"), {}, FileUse::Read},
               [this](const QString &path) { m_file->setText(path); });
}

void TrackDock::showRunning() {
    const bool runs = m_worker.isRunning();
    m_fit->setText(runs ? tr("Cancel") : tr("Fit"));
    m_fit->setEnabled(runs || !m_file->text().trimmed().isEmpty());
    m_progress->setVisible(runs);
    m_takeOver->setEnabled(!runs && !fittedSettings().empty());
}

void TrackDock::toggle() {
    m_outcome.reset();
    m_residuals->clear();
    if (m_worker.isRunning()) {
        m_worker.cancel();
        m_report->setPlainText(tr("Cancelled."));
        return showRunning();
    }
    QString error;
    const std::optional<TrackUnits> units = parseTrackUnits(m_units->text(), &error);
    std::optional<Track> track;
    if (units) track = readTrackFile(m_file->text().trimmed(), *units, &error);
    std::optional<std::vector<FitQuantity>> quantities = parseFitQuantities(usualFitQuantities(), &error);
    if (!track || !quantities) return m_report->setPlainText(error);
    const Inputs inputs = m_session.parameters().inputs();
    m_report->setPlainText(tr("Fitting %n points…", nullptr, int(track->points.size())));
    m_progress->setValue(0);
    m_worker.start({m_session.registry(),
                    m_session.scene(),
                    std::move(*track),
                    {inputs.params, inputs.gravity, {}, 0.0, {}},
                    std::move(*quantities),
                    {}});
    showRunning();
}

void TrackDock::showOutcome(const std::shared_ptr<const FitOutcome> &outcome) {
    m_outcome = outcome;
    showRunning();
    if (!outcome->fit) return m_report->setPlainText(outcome->error);
    m_report->setPlainText(fitReport(outcome->plan, *outcome->fit).join(QLatin1Char('\n')));
    m_residuals->show(outcome->fit->best(), outcome->fit->noise);
}

// The model and the coefficients that the track determines.
std::vector<Setting> TrackDock::fittedSettings() const {
    if (!m_outcome || !m_outcome->fit || m_outcome->fit->verdict == FitVerdict::Neither) return {};
    const ModelFit &fit = m_outcome->fit->best();
    std::vector<Setting> settings{{QStringLiteral("model"), double(fit.model)}};
    for (const FittedValue &value : fit.values) {
        const bool isParameter = m_session.parameters().indexOf(value.quantity.id) >= 0 &&
                                 !value.quantity.id.startsWith(QLatin1String("tilt"));
        if (value.isDetermined() && isParameter)
            settings.push_back({value.quantity.id, value.value / value.quantity.perUnit});
    }
    return settings;
}

void TrackDock::takeOver() {
    Parameters &parameters = m_session.parameters();
    const std::vector<Setting> after = fittedSettings();
    std::vector<Setting> before;
    for (const Setting &setting : after)
        before.push_back({setting.id, parameters.value(parameters.indexOf(setting.id))});
    QString error;
    if (!parameters.set(after, &error)) return m_report->appendPlainText(error);
    static int gesture = -1; // edits by hand count upwards
    m_undo.push(new ParameterCommand(parameters, before, after, gesture--, tr("values of a measured ball")));
}

} // namespace inspector::ui
