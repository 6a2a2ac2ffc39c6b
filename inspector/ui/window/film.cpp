// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/film.h"

#include "core/session/session.h"
#include "gl/maze_view.h"
#include "ui/parts/described.h"
#include "ui/parts/number_box.h"

#include <QDialogButtonBox>
#include <QFile>
#include <QFormLayout>
#include <QProgressDialog>

#include <algorithm>
#include <chrono>
#include <cmath>

namespace inspector::ui {

namespace {

constexpr std::chrono::milliseconds kLookPeriod{5};
constexpr double kLongest = 1200.0; // s
constexpr int kMostPerSecond = 100;
constexpr int kDigits = 5; // of a picture's number

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
    auto *buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
    auto *form = new QFormLayout(dialog);
    form->addRow(seconds->accessibleName(), seconds);
    form->addRow(rate->accessibleName(), rate);
    form->addRow(buttons);
    QObject::connect(buttons, &QDialogButtonBox::rejected, dialog, &QDialog::reject);
    QObject::connect(buttons, &QDialogButtonBox::accepted, dialog, [=] {
        if (seconds->isRefused() || rate->isRefused()) return;
        dialog->accept();
        use({seconds->value(), int(rate->value())});
    });
    dialog->open();
}

Film::Film(Session &session, gl::MazeView &view, const FilmPlan &plan, int scale, QWidget &window)
    : QObject(&window)
    , m_session(session)
    , m_view(view)
    , m_scale(scale)
    , m_last(session.simulation().latest().current.time)
    , m_period(1.0 / plan.perSecond)
    , m_wasInPast(session.isInPast())
    , m_progress(new QProgressDialog(&window)) {
    m_first = std::max(0.0, m_last - plan.seconds);
    m_count = int(std::floor((m_last - m_first) / m_period)) + 1;
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

bool Film::begin(const QString &folder, QString *error) {
    m_folder.setPath(folder);
    const bool isUsable = !m_folder.exists() || m_folder.isEmpty();
    if (!isUsable || !QDir().mkpath(folder)) {
        *error = isUsable ? tr("%1: the folder can't be made").arg(folder)
                          : tr("%1: expected a new or an empty folder, found one that holds something").arg(folder);
        m_progress->deleteLater();
        deleteLater();
        return false;
    }
    m_session.simulation().pause();
    m_session.lookAtTime(m_first);
    m_wanted = m_session.runPlace().place;
    m_look.start();
    return true;
}

// A picture as soon as its moment is there; then on to the next.
void Film::goOn() {
    if (m_progress->wasCanceled()) return end({});
    const Snapshot &now = m_session.simulation().latest();
    if (m_session.isInPast() && now.history.place != m_wanted) return;
    if (!takePicture()) return end(tr("%1: picture %2 can't be written").arg(m_folder.path()).arg(m_taken));
    m_progress->setLabelText(tr("Picture %1 of %2").arg(m_taken).arg(m_count));
    m_progress->setValue(m_taken);
    if (m_taken == m_count) return end({});
    m_session.lookAtTime(m_first + m_taken * m_period);
    m_wanted = m_session.runPlace().place;
}

QString Film::fileOf(int picture) const {
    return m_folder.filePath(QStringLiteral("%1.png").arg(picture, kDigits, 10, QLatin1Char('0')));
}

bool Film::takePicture() {
    m_view.grabFramebuffer(); // the frame of this moment
    return m_view.picture(m_scale).save(fileOf(++m_taken));
}

void Film::removePictures() {
    for (int picture = 1; picture <= m_taken; ++picture) QFile::remove(fileOf(picture));
    QDir().rmdir(m_folder.path());
}

// What was made is kept only if it is whole.
void Film::end(const QString &error) {
    m_look.stop();
    if (m_taken < m_count || !error.isEmpty()) removePictures();
    m_progress->deleteLater();
    m_wasInPast ? m_session.lookAtTime(m_last) : m_session.returnToPresent();
    emit finished(error);
    deleteLater();
}

} // namespace inspector::ui
