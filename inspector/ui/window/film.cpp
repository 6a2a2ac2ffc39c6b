// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/film.h"

#include "core/session/session.h"
#include "core/setup/files.h"
#include "core/setup/lines.h"
#include "gl/view/maze_view.h"
#include "ui/files/picture_file.h"
#include "ui/parts/described.h"
#include "ui/parts/number_box.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QFile>
#include <QFormLayout>
#include <QProcess>
#include <QProgressDialog>
#include <QStandardPaths>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

namespace inspector::ui {

namespace {

constexpr std::chrono::milliseconds kLookPeriod{5};
constexpr double kLongest = 1200.0; ///< s
constexpr int kMostPerSecond = 100;
constexpr double kFrameRounding = 1e-6;      ///< share of a picture
constexpr int kDigits = 5;                   ///< of a picture's number
const char *const kAllPictures = "%05d.png"; ///< ffmpeg's pattern

/// The encoder; without it only pictures can be written.
QString joiningTool() { return QStandardPaths::findExecutable(QStringLiteral("ffmpeg")); }

QString suffixOf(FilmKind kind) { return kind == FilmKind::Gif ? QStringLiteral("gif") : QStringLiteral("webm"); }

/// ffmpeg's encoding arguments.
QStringList encodingOf(FilmKind kind) {
    // One palette of 256 colours for all pictures.
    if (kind == FilmKind::Gif)
        return {"-vf", "split[all][for_palette];[for_palette]palettegen[palette];[all][palette]paletteuse"};
    return {"-c:v", "libvpx-vp9", "-pix_fmt", "yuv420p", "-crf", "30", "-b:v", "0", "-row-mt", "1"};
}

} // namespace

void askForFilm(QWidget &window, const FilmPlan &usual, const std::function<void(const FilmPlan &plan)> &use) {
    auto *dialog = new QDialog(&window);
    dialog->setObjectName(QStringLiteral("film_dialog"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setWindowTitle(Film::tr("Save film"));
    auto *seconds = new NumberBox;
    seconds->setObjectName(QStringLiteral("film_seconds"));
    seconds->setKind(numberKind({0.01, kLongest, QStringLiteral("s")}, 1.0));
    seconds->setValue(usual.seconds);
    describe(seconds, Film::tr("Last seconds"), Film::tr("Simulated time up to the moment shown, in s"));
    auto *rate = new NumberBox;
    rate->setObjectName(QStringLiteral("film_rate"));
    rate->setKind(wholeNumberKind(1, kMostPerSecond));
    rate->setValue(usual.perSecond);
    describe(rate, Film::tr("Pictures per second"), Film::tr("Pictures for each simulated second"));
    for (NumberBox *box : {seconds, rate}) QObject::connect(box, &NumberBox::entered, box, &NumberBox::setValue);
    auto *kind = new QComboBox;
    kind->setObjectName(QStringLiteral("film_kind"));
    describe(kind, Film::tr("Saved as"), Film::tr("Pictures, or where ffmpeg is installed one file of them"));
    kind->addItem(Film::tr("Pictures in a folder (PNG)"));
    if (!joiningTool().isEmpty()) kind->addItems({Film::tr("Film (WebM)"), Film::tr("Moving picture (GIF)")});
    auto *buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
    auto *form = new QFormLayout(dialog);
    form->addRow(seconds->accessibleName(), seconds);
    form->addRow(rate->accessibleName(), rate);
    form->addRow(kind->accessibleName(), kind);
    form->addRow(buttons);
    QObject::connect(buttons, &QDialogButtonBox::rejected, dialog, &QDialog::reject);
    QObject::connect(buttons, &QDialogButtonBox::accepted, dialog, [=] {
        if (seconds->isRefused() || rate->isRefused()) return;
        dialog->accept();
        use({seconds->value(), int(rate->value()), FilmKind(kind->currentIndex())});
    });
    seconds->selectAll(); // what is typed first takes its place
    dialog->open();
}

Film::Film(Session &session, gl::MazeView &view, const FilmPlan &plan, int scale, QWidget &window)
    : QObject(&window)
    , m_session(session)
    , m_view(view)
    , m_scale(scale)
    , m_plan(plan)
    , m_last(session.simulation().latest().current.time)
    , m_period(1.0 / plan.perSecond)
    , m_wasPresent(!session.isInPast() && !session.isReplaying())
    , m_progress(new QProgressDialog(&window)) {
    m_first = std::max(0.0, m_last - plan.seconds);
    m_count = int(std::floor((m_last - m_first) / m_period + kFrameRounding)) + 1; // both ends included
    m_progress->setObjectName(QStringLiteral("film_progress"));
    m_progress->setWindowTitle(tr("Save film"));
    m_progress->setRange(0, m_count);
    m_progress->setMinimumDuration(0);
    m_progress->setWindowModality(Qt::WindowModal);
    m_progress->setAutoClose(false);
    m_progress->setAutoReset(false);
    m_look.setInterval(kLookPeriod);
    connect(&m_look, &QTimer::timeout, this, &Film::goOn);
}

Film::~Film() { removeUnfinished(); }

bool Film::begin(const QString &path, QString *error) {
    m_path = path;
    if (!makeFolder(path, error)) {
        m_progress->deleteLater();
        deleteLater();
        return false;
    }
    m_isUnfinished = true;
    m_session.simulation().pause();
    m_session.lookAtTime(m_first);
    m_look.start();
    return true;
}

bool Film::makeFolder(const QString &path, QString *error) {
    if (m_plan.kind != FilmKind::Pictures) {
        m_scratch = std::make_unique<QTemporaryDir>();
        m_folder.setPath(m_scratch->path());
        *error = m_scratch->errorString();
        return m_scratch->isValid();
    }
    m_folder.setPath(path);
    const bool isUsable = !m_folder.exists() || m_folder.isEmpty();
    if (isUsable && QDir().mkpath(path)) return true;
    *error = isUsable ? tr("%1: the folder can't be made").arg(quoted(path))
                      : tr("%1: expected a new or an empty folder, found one that holds something").arg(quoted(path));
    return false;
}

/// Takes a picture when its moment is shown, then requests the next moment.
void Film::goOn() {
    if (m_progress->wasCanceled()) return end({});
    if (!m_session.showsWhatIsSought()) return;
    QString error;
    if (!takePicture(&error)) return end(error);
    m_progress->setLabelText(tr("Picture %1 of %2").arg(m_taken).arg(m_count));
    m_progress->setValue(m_taken);
    if (m_taken == m_count) return joinPictures();
    m_session.lookAtTime(m_first + m_taken * m_period);
}

QString Film::fileOf(int picture) const {
    return m_folder.filePath(QStringLiteral("%1.png").arg(picture, kDigits, 10, QLatin1Char('0')));
}

bool Film::takePicture(QString *error) {
    m_view.grabFramebuffer(); // draws the frame of this moment
    const std::unique_ptr<OutputFile> file = OutputFile::open(fileOf(++m_taken), Existing::Replace, {}, error);
    if (!file) return false;
    const QByteArray png = pngOf(m_view.picture(m_scale));
    const bool isWritten = !png.isEmpty() && file->write(png) == png.size();
    if (file->finish() && isWritten) return true;
    *error = file->problem();
    return false;
}

void Film::joinPictures() {
    m_look.stop();
    if (m_plan.kind == FilmKind::Pictures) return finish();
    m_progress->setLabelText(tr("ffmpeg makes one file of the pictures"));
    m_progress->setRange(0, 0);
    m_tool = new QProcess(this);
    m_tool->setWorkingDirectory(m_folder.path());
    connect(m_progress, &QProgressDialog::canceled, m_tool, &QProcess::kill);
    connect(m_tool, &QProcess::finished, this, &Film::useJoined);
    connect(m_tool, &QProcess::errorOccurred, this, [this](QProcess::ProcessError problem) {
        if (problem == QProcess::FailedToStart) end(tr("%1: %2").arg(m_tool->program(), m_tool->errorString()));
    });
    m_tool->start(joiningTool(),
                  QStringList{"-v", "error", "-framerate", QString::number(m_plan.perSecond), "-i", kAllPictures} +
                      encodingOf(m_plan.kind) + QStringList{"film." + suffixOf(m_plan.kind)});
}

void Film::useJoined() {
    if (m_progress->wasCanceled()) return end({});
    const bool isMade = m_tool->exitStatus() == QProcess::NormalExit && m_tool->exitCode() == 0;
    const QString said =
        QString::fromLocal8Bit(m_tool->readAllStandardError()).trimmed().section(QLatin1Char('\n'), -1);
    if (!isMade) return end(tr("ffmpeg: %1").arg(said.isEmpty() ? tr("ended without a file") : oneLine(said)));
    QFile film(m_folder.filePath("film." + suffixOf(m_plan.kind)));
    QString error;
    if (film.open(QIODevice::ReadOnly))
        replaceFile(m_path, film.readAll(), &error);
    else
        error = tr("%1: %2").arg(film.fileName(), film.errorString());
    error.isEmpty() ? finish() : end(error);
}

void Film::finish() {
    m_isUnfinished = false;
    end({});
    emit saved(m_path);
}

/// The result is kept only if it is complete.
void Film::removeUnfinished() {
    if (!std::exchange(m_isUnfinished, false)) return;
    for (int picture = 1; picture <= m_taken; ++picture) QFile::remove(fileOf(picture));
    QDir().rmdir(m_folder.path());
}

void Film::end(const QString &error) {
    m_look.stop();
    removeUnfinished();
    m_progress->deleteLater();
    m_wasPresent ? m_session.returnToPresent() : m_session.lookAtTime(m_last);
    emit finished(error);
    deleteLater();
}

} // namespace inspector::ui
