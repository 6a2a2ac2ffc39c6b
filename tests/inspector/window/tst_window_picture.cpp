// SPDX-License-Identifier: MIT
// The window at its start, compared with a picture that a person has checked.
// After an intended change: UPDATE_GOLDEN=1 build/dev/tests/inspector/window/window_suites tst_window_picture (under
// xvfb-run), look at the new picture in tests/inspector/window/golden, and commit it with the change.
#include "gl/view/maze_view.h"
#include "window_fixture.h"

#include <QFontDatabase>
#include <QFontInfo>
#include <QImage>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QOpenGLFunctions>

using namespace window_test;

namespace {

// llvmpipe gives the same bits in every run of one version, but compiles for the processor at hand, whose instructions
// may round differently. That changes a channel by a few levels, or a whole pixel where an edge crosses its centre.
constexpr int kChannelTolerance = 8;
constexpr double kPixelTolerance = 0.001; // share of pixels that may differ by more

const QString kPicture = QStringLiteral(GOLDEN_FOLDER "/start.png");
const QString kVersions = QStringLiteral(GOLDEN_FOLDER "/start.versions");

// What else the pixels depend on.
QString versionsNow() {
    QOffscreenSurface surface;
    surface.create();
    QOpenGLContext context;
    if (!context.create() || !context.makeCurrent(&surface)) return QStringLiteral("no OpenGL");
    const auto *version = reinterpret_cast<const char *>(context.functions()->glGetString(GL_VERSION));
    const QFontInfo font(QApplication::font());
    const QString family = QStringLiteral("%1, %2 px").arg(font.family()).arg(font.pixelSize());
    const QString fixed = QFontInfo(QFontDatabase::systemFont(QFontDatabase::FixedFont)).family();
    return QStringLiteral("%1\nQt %2\n%3; %4\n").arg(QLatin1String(version), QLatin1String(qVersion()), family, fixed);
}

bool differs(QRgb a, QRgb b) {
    return std::abs(qRed(a) - qRed(b)) > kChannelTolerance || std::abs(qGreen(a) - qGreen(b)) > kChannelTolerance ||
           std::abs(qBlue(a) - qBlue(b)) > kChannelTolerance;
}

int differentPixels(const QImage &a, const QImage &b) {
    int count = 0;
    for (int y = 0; y < a.height(); ++y)
        for (int x = 0; x < a.width(); ++x) count += differs(a.pixel(x, y), b.pixel(x, y));
    return count;
}

QString readText(const QString &path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
}

bool writeText(const QString &path, const QString &text) {
    QFile file(path);
    return file.open(QIODevice::WriteOnly) && file.write(text.toUtf8()) > 0;
}

} // namespace

class TestWindowPicture : public WindowSuite {
    Q_OBJECT

private slots:
    void init() override;
    void startLooksAsItDid();
    void sameSceneGivesTheSamePixels();

private:
    QImage picture();
};

// Paused at the start, light, medium quality: nothing depends on the clock or the desktop.
void TestWindowPicture::init() {
    m_fixture = std::make_unique<Fixture>(1, inspector::gl::Drawing::Solid);
    m_fixture->trigger("theme_1");
    m_fixture->trigger("quality_2");
    QVERIFY(m_fixture->isReady());
}

QImage TestWindowPicture::picture() {
    const QString path = m_fixture->path("now.png"); // as --grab, which waits for no plot's queue
    return m_fixture->window().grabTo(path, nullptr) ? QImage(path).convertToFormat(QImage::Format_RGB32) : QImage();
}

void TestWindowPicture::startLooksAsItDid() {
    const QString versions = versionsNow();
    const QImage now = picture();
    if (qEnvironmentVariableIsSet("UPDATE_GOLDEN")) {
        QVERIFY(now.save(kPicture));
        QVERIFY(writeText(kVersions, versions));
        QSKIP("the golden picture was written, nothing was compared");
    }
    const QString recorded = readText(kVersions);
    if (recorded != versions)
        QSKIP(qPrintable(QStringLiteral("the golden picture is of %1, this is %2")
                             .arg(recorded.simplified(), versions.simplified())));
    const QImage golden = QImage(kPicture).convertToFormat(QImage::Format_RGB32);
    QCOMPARE(now.size(), golden.size());
    const int different = differentPixels(now, golden);
    const QString seen = QDir::current().filePath(QStringLiteral("start_now.png"));
    if (different > kPixelTolerance * now.width() * now.height()) now.save(seen);
    QVERIFY2(different <= kPixelTolerance * now.width() * now.height(),
             qPrintable(QStringLiteral("%1 pixels differ; see %2").arg(different).arg(seen)));
}

// The assumptions of the comparison; also tested where no golden picture applies.
void TestWindowPicture::sameSceneGivesTheSamePixels() {
    const QImage first = picture();
    m_fixture = std::make_unique<Fixture>(1, inspector::gl::Drawing::Solid);
    m_fixture->trigger("theme_1");
    m_fixture->trigger("quality_2");
    QVERIFY(m_fixture->isReady());
    QCOMPARE(differentPixels(first, picture()), 0);
}

QTEST_MAIN(TestWindowPicture)
#include "tst_window_picture.moc"
