// SPDX-License-Identifier: MIT
// Shaders changed on disk while running.
#include "offscreen_picture.h"
#include "support/files.h"

#include <QDir>
#include <QFile>
#include <QRegularExpression>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

using namespace inspector::gl;
using support::write;

namespace {

constexpr char kAllRed[] = "#version 330 core\nout vec4 colour;\nvoid main() { colour = vec4(1.0, 0.0, 0.0, 1.0); }\n";
constexpr char kBroken[] = "#version 330 core\nout vec4 colour;\nvoid main() { colour = nonsense; }\n";

} // namespace

class TestShaderOverride : public QObject {
    Q_OBJECT

private slots:
    void init() {
        m_folder = std::make_unique<QTemporaryDir>();
        m_picture = std::make_unique<OffscreenPicture>();
        if (!m_picture->isReady()) QSKIP(qPrintable(m_picture->problem()));
        m_frame.ball.position = {0.05, 0.0, 0.006};
    }

    void cleanup() { m_picture.reset(); }

    void fileInTheDirectoryReplacesTheEmbeddedOne() {
        write(m_folder->filePath("backdrop.frag"), kAllRed);
        shaders().setDirectory(m_folder->path());
        QCOMPARE(m_picture->draw(m_frame).pixel(2, 2), qRgb(255, 0, 0));
    }

    void otherFilesStayTheEmbeddedOnes() {
        const QPoint floor = m_picture->pixelOf({0.03, 0.0, 0.0});
        const QRgb before = m_picture->draw(m_frame).pixel(floor);
        write(m_folder->filePath("backdrop.frag"), kAllRed);
        shaders().setDirectory(m_folder->path());
        QCOMPARE(m_picture->draw(m_frame).pixel(floor), before);
    }

    void editWhileRunningIsSeen() {
        write(m_folder->filePath("backdrop.frag"), kAllRed);
        shaders().setDirectory(m_folder->path());
        m_picture->draw(m_frame);
        QSignalSpy changed(&shaders(), &ShaderLibrary::changed);
        write(m_folder->filePath("backdrop.frag"), QByteArray(kAllRed).replace("1.0, 0.0, 0.0", "0.0, 1.0, 0.0"));
        QTRY_VERIFY(!changed.isEmpty());
        QTRY_COMPARE(m_picture->draw(m_frame).pixel(2, 2), qRgb(0, 255, 0));
    }

    void brokenEditKeepsTheLastGoodPictureAndReportsTheLog() {
        const QImage good = m_picture->draw(m_frame);
        QSignalSpy failed(&shaders(), &ShaderLibrary::failed);
        write(m_folder->filePath("maze.frag"), kBroken);
        shaders().setDirectory(m_folder->path());
        QTest::ignoreMessage(QtWarningMsg, QRegularExpression("QOpenGLShader::compile"));
        QTest::ignoreMessage(QtWarningMsg, QRegularExpression("Problematic Fragment shader source"));
        QCOMPARE(m_picture->draw(m_frame), good);
        QCOMPARE(failed.size(), 1);
        const QString log = failed[0][0].toString();
        QVERIFY2(log.startsWith(m_folder->filePath("maze.frag") + ": "), qPrintable(log));
        QVERIFY2(log.contains("nonsense"), qPrintable(log));
        QVERIFY2(log.contains("0:3("), qPrintable(log)); // the line in the file, although a line was put in
    }

    void brokenFromTheStartFallsBackToTheEmbeddedOnes() {
        const QImage good = m_picture->draw(m_frame);
        m_picture.reset(); // before the next, as each leaves no context current
        m_picture = std::make_unique<OffscreenPicture>();
        write(m_folder->filePath("ball.frag"), kBroken);
        shaders().setDirectory(m_folder->path());
        QTest::ignoreMessage(QtWarningMsg, QRegularExpression("QOpenGLShader::compile"));
        QTest::ignoreMessage(QtWarningMsg, QRegularExpression("Problematic Fragment shader source"));
        QCOMPARE(m_picture->draw(m_frame), good);
    }

    void leavingTheDirectoryBringsTheEmbeddedOnesBack() {
        const QImage good = m_picture->draw(m_frame);
        write(m_folder->filePath("backdrop.frag"), kAllRed);
        shaders().setDirectory(m_folder->path());
        QVERIFY(m_picture->draw(m_frame) != good);
        shaders().setDirectory({});
        QCOMPARE(m_picture->draw(m_frame), good);
    }

    void directoryMadeAgainIsWatchedAgain() {
        const QString folder = m_folder->filePath("mine/shaders");
        QVERIFY(QDir().mkpath(folder));
        write(folder + "/backdrop.frag", kAllRed);
        shaders().setDirectory(folder);
        QCOMPARE(m_picture->draw(m_frame).pixel(2, 2), qRgb(255, 0, 0));
        QVERIFY(QDir(m_folder->filePath("mine")).removeRecursively());
        QTRY_VERIFY(m_picture->draw(m_frame).pixel(2, 2) != qRgb(255, 0, 0));
        QVERIFY(QDir().mkpath(folder));
        write(folder + "/backdrop.frag", kAllRed);
        QTRY_COMPARE(m_picture->draw(m_frame).pixel(2, 2), qRgb(255, 0, 0));
    }

    void whatIsNoFileIsReported() {
        QSignalSpy failed(&shaders(), &ShaderLibrary::failed);
        QVERIFY(QDir(m_folder->path()).mkdir("maze.frag"));
        shaders().setDirectory(m_folder->path());
        m_picture->draw(m_frame);
        QCOMPARE(failed.size(), 1);
        QVERIFY2(failed[0][0].toString().contains("expected a file, found a folder"),
                 qPrintable(failed[0][0].toString()));
    }

    void missingDirectoryIsReported() {
        QSignalSpy failed(&shaders(), &ShaderLibrary::failed);
        shaders().setDirectory("/no/such/place");
        QCOMPARE(failed.size(), 1);
        QCOMPARE(failed[0][0].toString(), QString("/no/such/place: expected a directory with shaders, found none"));
    }

private:
    ShaderLibrary &shaders() { return m_picture->renderer().shaders(); }

    std::unique_ptr<QTemporaryDir> m_folder;
    std::unique_ptr<OffscreenPicture> m_picture;
    Frame m_frame;
};

QTEST_MAIN(TestShaderOverride)
#include "tst_shader_override.moc"
