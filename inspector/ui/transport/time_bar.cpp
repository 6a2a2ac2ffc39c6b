// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/transport/time_bar.h"

#include "ui/parts/described.h"
#include "ui/parts/elided_label.h"
#include "ui/parts/path_icon.h"
#include "ui/parts/theme.h"
#include "ui/transport/seek_slider.h"

#include <QAction>
#include <QHBoxLayout>
#include <QSignalBlocker>
#include <QToolButton>

#include <algorithm>
#include <climits>
#include <cmath>

namespace inspector::ui {

namespace {

/// Clamps to a slider's range; a recording of 2^31 steps would have 36 GB.
int notchOf(uint64_t position) { return int(std::min<uint64_t>(position, INT_MAX)); }

/// The step number of the state at the bar's left end. A run that was taken over continues its count, and the history
/// drops the first steps.
uint64_t firstStepOf(const RunPlace &run, const Snapshot &now) {
    const uint64_t made = now.history.place - std::min(run.begin, now.history.place);
    return now.current.step - std::min(made, now.current.step);
}

/// What happened to those in front of the bar's left end; empty if there were none.
QString stepsBefore(const RunPlace &run, const Snapshot &now) {
    if (run.isCut) return TimeBar::tr("Earlier steps aren't kept");
    return firstStepOf(run, now) > 0 ? TimeBar::tr("Earlier steps are in Runs") : QString();
}

constexpr int kLeastWidth = 48; ///< pixels, minimum width of a button with a text

QToolButton *buttonOf(QAction *action) {
    auto *button = new QToolButton;
    button->setObjectName(QStringLiteral("time_bar_") + action->objectName());
    button->setDefaultAction(action);
    button->setAutoRaise(!action->icon().isNull());
    if (action->icon().isNull()) button->setMinimumWidth(kLeastWidth);
    if (action->icon().isNull()) button->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
    button->setFocusPolicy(Qt::TabFocus); // a click doesn't take the keyboard from the view
    return button;
}

} // namespace

TimeBar::TimeBar(Session &session, const QList<QAction *> &playback, const QList<QAction *> &endings, QWidget *parent)
    : QFrame(parent)
    , m_session(session)
    , m_slider(new SeekSlider)
    , m_place(new ElidedLabel)
    , m_verdict(new ElidedLabel)
    , m_alarm(new AlarmText(*m_verdict, QPalette::WindowText))
    , m_recording(new ElidedLabel)
    , m_toDifference(new QToolButton) {
    setObjectName(QStringLiteral("time_bar"));
    m_slider->setAccessibleName(tr("Time"));
    m_slider->setAccessibleDescription(tr("The moment shown of the run"));
    m_slider->setObjectName(QStringLiteral("time_slider"));
    m_place->setObjectName(QStringLiteral("time_place"));
    m_verdict->setObjectName(QStringLiteral("time_verdict"));
    m_toDifference->setObjectName(QStringLiteral("time_to_difference"));
    m_toDifference->setIcon(glyphIcon(Glyph::Warning));
    describe(m_toDifference, tr("Go to the first difference"), tr("Go to the first step that differs"));
    m_toDifference->setAutoRaise(true);
    m_toDifference->setFocusPolicy(Qt::TabFocus);
    m_recording->setObjectName(QStringLiteral("time_recording"));
    m_recording->setText(tr("● recording"));
    for (ElidedLabel *label : {m_place, m_verdict, m_recording}) label->setWidest({});
    connect(m_slider, &QSlider::valueChanged, this, &TimeBar::goTo);
    connect(m_toDifference, &QToolButton::clicked, this, &TimeBar::goToDifference);

    auto *line = new QHBoxLayout;
    line->setSpacing(2);
    for (QAction *action : playback) line->addWidget(buttonOf(action));
    line->addSpacing(8);
    line->addWidget(m_place);
    line->addSpacing(8);
    line->addWidget(m_recording);
    line->addStretch();
    line->addWidget(m_toDifference);
    line->addWidget(m_verdict);
    line->addSpacing(8);
    for (QAction *action : endings) {
        QToolButton *button = buttonOf(action);
        button->setVisible(action->isEnabled());
        connect(action, &QAction::enabledChanged, button, &QWidget::setVisible);
        line->addWidget(button);
    }
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(8, 4, 8, 4);
    layout->setSpacing(2);
    layout->addWidget(m_slider);
    layout->addLayout(line);
    reset();
}

void TimeBar::goTo(int notch) {
    if (Playback *replay = m_session.replay()) return replay->seek(uint64_t(notch));
    const RunPlace run = m_session.runPlace();
    m_session.lookAt(run.begin + uint64_t(notch));
}

void TimeBar::reset() {
    m_slider->setDifference(std::nullopt);
    m_slider->setRuns({});
    m_slider->setContinuing(false);
    m_slider->setToolTip({});
    m_toDifference->hide();
    m_verdict->clear();
    m_alarm->setOn(false);
    m_place->setWidest({});
    if (!m_session.isReplaying()) return showRun(m_session.simulation().latest());
    const PlayableRecording &recording = m_session.replay()->recording();
    const QSignalBlocker silent(m_slider);
    m_slider->setRange(0, notchOf(recording.length()));
    m_slider->setValue(0);
    std::vector<int> runs;
    for (size_t i = 1; i < recording.runs().size(); ++i) runs.push_back(notchOf(recording.runs()[i]));
    m_slider->setRuns(std::move(runs));
    // Reserves the largest width, so that nothing moves while it runs.
    m_place->setWidest(tr("%1 s · step %2 of %2").arg(QStringLiteral("0000.000")).arg(recording.length()));
}

void TimeBar::refresh(const Snapshot &now) {
    m_recording->setVisible(m_session.isRecording());
    showTrack(now);
    const Playback *replay = m_session.replay();
    if (!replay) return showRun(now);
    const std::optional<ReplayPlace> place = replay->place(now);
    if (!place) return;
    showPlace(*place, now);
    showVerdict(*place, now);
}

void TimeBar::showRun(const Snapshot &now) {
    const RunPlace run = m_session.runPlace();
    const QSignalBlocker silent(m_slider);
    m_slider->setPageStep(int(std::clamp(std::round(1.0 / now.dt), 1.0, 1e6)));
    if (!m_slider->isSliderDown()) {
        m_slider->setMaximum(notchOf(run.end - run.begin));
        m_slider->setValue(notchOf(run.place - run.begin));
    }
    const bool isShown = run.begin <= now.history.place && now.history.place <= run.end;
    if (!isShown) return m_place->setText(tr("Repeating the run…")); // a long one takes a moment
    const QString time = tr("%1 s · step %2").arg(now.current.time, 0, 'f', 3).arg(now.current.step);
    const uint64_t lastStep = firstStepOf(run, now) + run.end - run.begin;
    const QString place = m_session.isInPast() ? tr("%1 of %2").arg(time).arg(lastStep) : time;
    const QString before = stepsBefore(run, now);
    const bool isAtBegin = m_session.isInPast() && run.place == run.begin;
    m_place->setText(isAtBegin && !before.isEmpty() ? QStringLiteral("%1 · %2").arg(place, before) : place);
    m_slider->setToolTip(before);
    m_slider->setContinuing(!before.isEmpty());
}

/// The run's samples, one per step, map times to steps. If a run was taken over, they may begin before the bar does.
void TimeBar::showTrack(const Snapshot &now) {
    const std::shared_ptr<const ShownTrack> &track = m_session.track();
    const SampleRing &samples = m_session.simulation().samples();
    const uint64_t end = samples.last();
    Sample last;
    const bool isShown = track && !m_session.isReplaying() && samples.read(end - 1, last);
    if (!isShown) return m_slider->setSpan(std::nullopt);
    const uint64_t firstStep = firstStepOf(m_session.runPlace(), now);
    const auto notchAt = [&](double time) {
        const uint64_t step = last.step - (end - std::min(samples.find(time), end)); // the last that ends before
        return notchOf(step - std::min(firstStep, step));
    };
    m_slider->setSpan(SeekSlider::Span{notchAt(track->begin()), notchAt(track->end())});
}

void TimeBar::showPlace(const ReplayPlace &place, const Snapshot &now) {
    m_place->setText(tr("%1 s · step %2 of %3")
                         .arg(now.current.time, 0, 'f', 3)
                         .arg(now.replay.position)
                         .arg(m_session.replay()->recording().length()));
    const QSignalBlocker silent(m_slider);
    m_slider->setPageStep(int(std::clamp(std::round(1.0 / now.dt), 1.0, 1e6)));
    if (!m_slider->isSliderDown()) m_slider->setValue(notchOf(place.position));
}

void TimeBar::showVerdict(const ReplayPlace &place, const Snapshot &now) {
    const bool isWhole = m_session.replay()->recording().recording().isWhole;
    QString text = place.isChecked ? (isWhole ? tr("same") : tr("same, cut off")) : tr("same so far");
    if (place.difference) text = tr("differs from step %1 on").arg(*place.difference);
    m_verdict->setToolTip(m_session.replay()->verdict(now));
    m_toDifference->setVisible(place.difference.has_value());
    if (m_verdict->text() == text) return;
    m_verdict->setText(text);
    if (!place.difference) return;
    m_slider->setDifference(notchOf(*place.difference));
    m_alarm->setOn(true);
}

void TimeBar::goToDifference() {
    Playback *replay = m_session.replay();
    if (!replay) return;
    const std::optional<ReplayPlace> place = replay->place(m_session.simulation().latest());
    if (!place || !place->difference) return;
    m_session.simulation().pause();
    replay->seek(*place->difference);
}

} // namespace inspector::ui
