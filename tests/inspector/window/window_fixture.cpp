// SPDX-License-Identifier: MIT
#include "window_fixture.h"

#include "core/setup/settings_file.h"
#include "gl/surface_format.h"
#include "gl/view/maze_view.h"
#include "ui/parts/theme.h"

#include <QApplication>
#include <QDropEvent>
#include <QFileDialog>
#include <QLineEdit>
#include <QMimeData>
#include <QPointer>
#include <QSurfaceFormat>
#include <QWheelEvent>

#include <algorithm>

#include <qcustomplot.h>

namespace window_test {

namespace {

constexpr QSize kSize(1200, 800);

inspector::Options optionsOf(int level, const QString &levels) {
    inspector::Options options;
    options.registry = inspector::makeRegistry(nullptr);
    options.levels = inspector::levelsIn(levels);
    options.level = options.levels.at(size_t(level) - 1);
    return options;
}

QWidget *keyboardOwner(QWidget &window) {
    QWidget *popup = QApplication::activePopupWidget();
    QWidget *focus = popup ? popup->focusWidget() : QApplication::focusWidget();
    if (focus) return focus;
    return popup ? popup : &window;
}

bool isEnter(Qt::Key key) { return key == Qt::Key_Return || key == Qt::Key_Enter; }

bool isAccepted(const QWidget *editor) { return !editor || !inspector::ui::AlarmText::isOn(*editor); }

} // namespace

QString readOutOf(const QCustomPlot *plot) {
    const auto *text = plot->findChild<QCPTextElement *>("read_out");
    if (!text) qFatal("no read-out");
    return text->text().startsWith("Wheel: zoom") ? QString() : text->text(); // that is the hint
}

bool isReadOutWhole(const QCustomPlot *plot) {
    const auto *text = plot->findChild<QCPTextElement *>("read_out");
    const QRect room = text->rect();
    const QRect needed = QFontMetrics(text->font()).boundingRect(room, text->textFlags(), text->text());
    return needed.width() <= room.width() && needed.height() <= room.height() &&
           plot->rect().contains(text->outerRect());
}

void prepare() { QSurfaceFormat::setDefaultFormat(inspector::gl::surfaceFormat()); }

inspector::gl::Drawing solidIn(std::initializer_list<const char *> facts) {
    const bool isSolid = std::any_of(facts.begin(), facts.end(),
                                     [](const char *fact) { return qstrcmp(fact, QTest::currentTestFunction()) == 0; });
    return isSolid ? inspector::gl::Drawing::Solid : inspector::gl::Drawing::Flat;
}

Fixture::Fixture(int level, inspector::gl::Drawing drawing, const QString &levels)
    : m_drawing(drawing)
    , m_settings(m_folder.filePath(QStringLiteral("settings.ini")), inspector::settingsFormat()) {
    m_settings.setValue(QStringLiteral("window/show_way_ahead"), false); // it appears at an unpredictable time
    m_settings.setValue(QStringLiteral("window/quality"), 0);            // drawn by software: the lowest is the fastest
    QString error;
    m_session = inspector::Session::open(optionsOf(level, levels), m_settings, &error);
    if (!m_session) qFatal("%s", qPrintable(error));
    reopen();
}

void Fixture::reopen() {
    if (m_window) m_window->close();
    m_window = std::make_unique<inspector::ui::MainWindow>(*m_session, m_drawing);
    m_window->view().setQuality(inspector::gl::Quality::Low); // leaves the processor to the tests
    m_window->setAnimated(false);                             // a dock has its size immediately
    if (!m_settings.contains(QStringLiteral("window/geometry"))) m_window->resize(kSize);
    m_window->show();
}

bool Fixture::isReady() {
    m_window->activateWindow();
    return QTest::qWaitForWindowActive(m_window.get(), kPatience) &&
           QTest::qWaitFor([this] { return m_window->view().lastFrameMilliseconds() > 0.0; }, kPatience);
}

void Fixture::key(Qt::Key key, Qt::KeyboardModifiers modifiers) {
    const QPointer<QWidget> owner = keyboardOwner(*m_window);
    QTest::keyClick(owner, key, modifiers);
    const bool isEdit = qobject_cast<QLineEdit *>(owner) && owner->window() == m_window.get() && isAccepted(owner);
    if (!isEdit || !isEnter(key)) return;
    QTRY_VERIFY2(!owner || !owner->hasFocus(), "the edit keeps the keyboard"); // it returns it a little later
}

void Fixture::type(const QString &text) {
    for (const QChar letter : text) QTest::keyClick(keyboardOwner(*m_window), letter.toLatin1());
}

void Fixture::makeSteps(uint64_t count) {
    const uint64_t end = simulation().latest().current.step + count;
    for (uint64_t i = 0; i < count; ++i) trigger("step");
    QTRY_COMPARE(simulation().latest().current.step, end);
}

void Fixture::drop(const QString &path) {
    QMimeData data;
    data.setUrls({QUrl::fromLocalFile(path)});
    QDragEnterEvent enter(m_window->rect().center(), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(m_window.get(), &enter); // a drop without it is ignored
    QDropEvent drop(m_window->rect().center(), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(m_window.get(), &drop);
}

void Fixture::answerFile(const QString &path) {
    QTRY_VERIFY(m_window->findChild<QFileDialog *>());
    auto *dialog = m_window->findChild<QFileDialog *>();
    emit dialog->fileSelected(path); // what it says once a name is chosen
    delete dialog;
}

double Fixture::simulated(const QString &id) {
    const inspector::Inputs inputs = simulation().latest().inputs;
    if (id == QLatin1String("tilt_x")) return inspector::degrees(inputs.tilt.x);
    if (id == QLatin1String("tilt_y")) return inspector::degrees(inputs.tilt.y);
    if (id == QLatin1String("gravity")) return inputs.gravity;
    return phys_param_get(&inputs.params, &parameters().row(parameters().indexOf(id)));
}

void Fixture::reportMissing(const QString &name) const {
    QStringList names;
    for (const QObject *child : m_window->findChildren<QObject *>())
        if (!child->objectName().isEmpty() && !child->objectName().startsWith(QLatin1String("qt_")))
            names << child->objectName();
    qFatal("no child '%s'; there are: %s", qPrintable(name), qPrintable(names.join(QLatin1String(", "))));
}

void WindowSuite::init() { QVERIFY(open()); }
void WindowSuite::cleanup() { m_fixture.reset(); }

void click(QWidget *widget) { QTest::mouseClick(widget, Qt::LeftButton, {}, widget->rect().center()); }

// QTest::mouseMove carries no buttons, so the moves are sent as the platform would.
void drag(QWidget *widget, const QPoint &from, const QPoint &to, Qt::KeyboardModifiers modifiers) {
    QTest::mousePress(widget, Qt::LeftButton, modifiers, from);
    for (const QPoint &place : {(from + to) / 2, to}) {
        QMouseEvent move(QEvent::MouseMove, place, widget->mapToGlobal(place), Qt::NoButton, Qt::LeftButton, modifiers);
        QApplication::sendEvent(widget, &move);
    }
    QTest::mouseRelease(widget, Qt::LeftButton, modifiers, to);
}

void turnWheel(QWidget *widget, const QPoint &place, int notches, Qt::KeyboardModifiers modifiers) {
    QWheelEvent wheel(place, widget->mapToGlobal(place), {}, {0, 120 * notches}, Qt::NoButton, modifiers,
                      Qt::NoScrollPhase, false);
    QApplication::sendEvent(widget, &wheel);
}

void hover(QWidget *widget, const QPoint &place) {
    QMouseEvent move(QEvent::MouseMove, place, widget->mapToGlobal(place), Qt::NoButton, Qt::NoButton, {});
    QApplication::sendEvent(widget, &move);
}

} // namespace window_test
