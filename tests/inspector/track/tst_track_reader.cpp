// SPDX-License-Identifier: MIT
// Tracks as trackers write them: columns, units, and the messages for unusable rows.
#include "core/track/track_reader.h"
#include "support/compare.h"

#include <QBuffer>
#include <QTemporaryDir>
#include <QTest>

#include <numeric>

using namespace inspector;

class TestTrackReader : public QObject {
    Q_OBJECT

private slots:
    void columnsAreFoundByNameAndUnit_data();
    void columnsAreFoundByNameAndUnit();
    void gravityTellsTheTilt();
    void tiltHoldsFromItsRow();
    void tiltOfOwnTableIsThatOfTheStepBefore();
    void rowsThatCantBeUsedAreLeftOutAndTold_data();
    void rowsThatCantBeUsedAreLeftOutAndTold();
    void tiltThatCantBeUsedIsTold();
    void lostPositionsAndGapsAreTold();
    void unusableFilesAreOneLine_data();
    void unusableFilesAreOneLine();
    void tablesAreKnownByNameOrHeader();
    void wrongUnitsAreOneLine_data();
    void wrongUnitsAreOneLine();
    void unitNamedTwiceIsRefused();
    void frameThereAndBackIsTheSame();
    void noiseIsFoundBesideBounces();
};

namespace {

std::optional<Track> read(const QByteArray &text, const QString &units, QString *error) {
    QBuffer buffer;
    buffer.setData(text);
    buffer.open(QIODevice::ReadOnly);
    const std::optional<TrackUnits> parsed = parseTrackUnits(units, error);
    return parsed ? readTrack(buffer, "t.csv", *parsed, error) : std::nullopt;
}

Track track(const QByteArray &text, const QString &units = {}) {
    QString error;
    std::optional<Track> result = read(text, units, &error);
    if (!result) qFatal("%s", qPrintable(error));
    return std::move(*result);
}

// Rows from 0 to 11 of a pattern, in which %1 stands for the row's number.
QByteArray rows(const QString &pattern) {
    QByteArray text;
    for (int i = 0; i < 12; ++i) text += pattern.arg(i).toUtf8() + '\n';
    return text;
}

} // namespace

void TestTrackReader::columnsAreFoundByNameAndUnit_data() {
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<QString>("units");
    QTest::addColumn<double>("time"); // of the last row, s
    QTest::addColumn<double>("x");    // m
    const auto row = [](const char *name, const char *header, const char *pattern, const char *units, double time,
                        double x) {
        QTest::newRow(name) << header + QByteArray("\n") + rows(pattern) << units << time << x;
    };
    row("plain", "t,x,y", "%1,0.25,0", "", 11.0, 0.25);
    row("other order", "y,id,x,time", "0,7,0.25,%1", "", 11.0, 0.25);
    row("brackets", "time [ms],x [mm],y [mm]", "%1,250,0", "", 11 * 1e-3, 0.25);
    row("suffixes", "t_ms,x_cm,y_cm", "%1,25,0", "", 11 * 1e-3, 0.25);
    row("by option", "t,x,y", "%1,250,0", "t=ms,x=mm", 11 * 1e-3, 0.25);
    row("pixels", "t,x [px],y [px]", "%1,1000,0", "px=0.25mm", 11.0, 0.25);
    row("pictures", "frame,x,y", "%1,0.25,0", "fps=2", 5.5, 0.25);
    row("semicolons and commas", "t;x;y", "%1,0;0,25;0", "", 11.0, 0.25);
    row("tabs", "t\tx\ty", "%1\t0.25\t0", "", 11.0, 0.25);
    row("quoted", "\"t\",\"x\",\"y\"", "\"%1\",\"0.25\",\"0\"", "", 11.0, 0.25);
    row("mirrored", "t,x,y", "%1,0.25,0", "mirror=x", 11.0, -0.25);
    row("after comments", "# by a tracker\nt,x,y", "%1,0.25,0", "", 11.0, 0.25);
    row("with a byte-order mark", "\xef\xbb\xbft,x,y", "%1,0.25,0", "", 11.0, 0.25);
}

void TestTrackReader::columnsAreFoundByNameAndUnit() {
    QFETCH(QByteArray, text);
    QFETCH(QString, units);
    QFETCH(double, time);
    QFETCH(double, x);
    const Track result = track(text, units);
    QCOMPARE(result.points.size(), size_t(12));
    COMPARE_WITHIN(result.end(), time, 1e-12);
    COMPARE_WITHIN(result.points.back().x, x, 1e-12);
    QVERIFY2(result.remarks.isEmpty(), qPrintable(result.remarks.join('\n')));
}

// A board that slopes by 45 degrees along x.
void TestTrackReader::gravityTellsTheTilt() {
    const Track result = track("t,x,y,gx,gy,gz\n" + rows("%1,0,0,5,0,-5"));
    QCOMPARE(result.tilts.size(), size_t(1));
    COMPARE_WITHIN(result.tilts[0].tilt.x, radians(45.0), 1e-12);
    COMPARE_WITHIN(result.tilts[0].tilt.y, 0.0, 1e-12);
}

void TestTrackReader::tiltHoldsFromItsRow() {
    const Track result = track("t,x,y,tilt_x,tilt_y [rad]\n" + rows("%1,0,0,2,0.1") + "20,0,0,3,0.1\n");
    QCOMPARE(result.tilts.size(), size_t(2));
    COMPARE_EXACT(result.tilts[1].time, 20.0);
    COMPARE_WITHIN(result.tilts[1].tilt.x, radians(3.0), 1e-15);
    COMPARE_EXACT(result.tilts[1].tilt.y, 0.1);
}

void TestTrackReader::tiltOfOwnTableIsThatOfTheStepBefore() {
    const Track result = track("time [s],step,position_x [m],position_y [m],tilt_x [deg],tilt_y [deg]\n" +
                               rows("%1,%1,0,0,2,0") + "12,12,0,0,3,0\n");
    QCOMPARE(result.tilts.size(), size_t(2));
    COMPARE_EXACT(result.tilts[1].time, 11.0);
}

void TestTrackReader::rowsThatCantBeUsedAreLeftOutAndTold_data() {
    QTest::addColumn<QByteArray>("row");
    QTest::addColumn<QString>("remark");
    QTest::newRow("no number") << QByteArray("20,abc,0")
                               << "t.csv:14: column x: expected a number, found 'abc'; left out";
    QTest::newRow("too large") << QByteArray("20,1e400,0")
                               << "t.csv:14: column x: expected a number, found '1e400', which is beyond what a number "
                                  "can hold; left out";
    QTest::newRow("not finite") << QByteArray("20,inf,0")
                                << "t.csv:14: column x: expected a number, found 'inf', which isn't a finite number; "
                                   "left out";
    QTest::newRow("too short") << QByteArray("20,1")
                               << "t.csv:14: column y: expected a number, found nothing; left out";
    QTest::newRow("no time") << QByteArray(",1,1") << "t.csv:14: column t: expected a number, found nothing; left out";
    QTest::newRow("back in time") << QByteArray("10.5,1,1")
                                  << "t.csv:14: expected a time after 11 s, found 10.5 s; left out";
    QTest::newRow("the same time") << QByteArray("11,1,1")
                                   << "t.csv:14: expected a time after 11 s, found 11 s; left out";
}

void TestTrackReader::rowsThatCantBeUsedAreLeftOutAndTold() {
    QFETCH(QByteArray, row);
    QFETCH(QString, remark);
    const Track result = track("t,x,y\n" + rows("%1,0,0") + row + "\n");
    QCOMPARE(result.points.size(), size_t(12));
    QCOMPARE(result.remarks, QStringList{remark});
}

void TestTrackReader::tiltThatCantBeUsedIsTold() {
    const Track steep = track("t,x,y,tilt_x [deg],tilt_y [deg]\n" + rows("%1,0,0,1,2") + "20,0,0,90,2\n");
    QCOMPARE(steep.remarks, QStringList("t.csv:14: expected tilts within 89 degrees, found 90 and 2; left out"));
    const Track level = track("t,x,y,gx,gy,gz\n" + rows("%1,0,0,0,0,-9.8") + "20,0,0,9.8,0,0\n");
    QCOMPARE(level.remarks,
             QStringList("t.csv:14: expected a gravity that points into the board, found 0 across it; left out"));
}

void TestTrackReader::lostPositionsAndGapsAreTold() {
    const Track result = track("t,x,y\n" + rows("%1,0,0") + "12,,\n13,nan,nan\n14,,\n15,,\n16,0,0\n");
    QCOMPARE(result.points.size(), size_t(13));
    QCOMPARE(result.remarks, (QStringList{"4 rows without a position", "a gap of 5 s after 11 s"}));
}

void TestTrackReader::unusableFilesAreOneLine_data() {
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<QString>("line");
    QTest::newRow("nothing") << QByteArray() << "t.csv: expected a header line, found nothing";
    QTest::newRow("no header") << QByteArray("1,2,3\n")
                               << "t.csv:1: expected a column t, time or frame in the header, found '1,2,3'";
    QTest::newRow("no y") << QByteArray("t,x\n") << "t.csv:1: expected a column y in the header, found 't,x'";
    QTest::newRow("pixels")
        << QByteArray("t,x [px],y\n")
        << "t.csv:1: expected a unit of column x that is known (px=0.25mm tells pixels), not 'px' in "
           "the header, found 't,x [px],y'";
    QTest::newRow("too few") << QByteArray("t,x,y\n0,0,0\n")
                             << "t.csv: expected at least 10 rows with time and position, found 1";
}

void TestTrackReader::unusableFilesAreOneLine() {
    QFETCH(QByteArray, text);
    QFETCH(QString, line);
    QString error;
    QVERIFY(!read(text, {}, &error));
    QCOMPARE(error, line);
}

void TestTrackReader::tablesAreKnownByNameOrHeader() {
    const QTemporaryDir folder;
    const auto isTrack = [&](const char *name, const QByteArray &text) {
        QFile file(folder.filePath(name));
        if (!file.open(QIODevice::WriteOnly) || file.write(text) < 0) qFatal("can't write");
        file.close();
        return isTrackFile(file.fileName());
    };
    QVERIFY(isTrack("a.csv", "nothing of the kind\n")); // it is opened as a track, so that its header is reported
    QVERIFY(isTrack("b.txt", "# by hand\n\nframe;x_mm;y_mm\n"));
    QVERIFY(isTrack("e.txt", "\xef\xbb\xbfx,y,t\n"));
    QVERIFY(!isTrack("c.txt", "physics-maze 1\nbox x y\n"));
    QVERIFY(!isTrack("d.txt", ""));
    QVERIFY(!isTrackFile(folder.filePath("none.txt")));
}

void TestTrackReader::wrongUnitsAreOneLine_data() {
    QTest::addColumn<QString>("units");
    for (const char *units : {"x", "x=ms", "t=mm", "px=2", "px=-1mm", "fps=0", "mirror=z", "w=1"})
        QTest::newRow(units) << units;
}

void TestTrackReader::wrongUnitsAreOneLine() {
    QFETCH(QString, units);
    QString error;
    QVERIFY(!parseTrackUnits(units, &error));
    QVERIFY2(error.endsWith("found '" + units + "'"), qPrintable(error));
}

void TestTrackReader::unitNamedTwiceIsRefused() {
    QString error;
    QVERIFY(!parseTrackUnits("x=mm,t=ms,x=cm", &error));
    QCOMPARE(error, QString("'x' is named twice"));
    QVERIFY(parseTrackUnits("mirror=x,mirror=y", &error));
}

void TestTrackReader::frameThereAndBackIsTheSame() {
    const TrackFrame frame{2.0, radians(30.0), 0.1, -0.2};
    double x = 0.0;
    double y = 0.0;
    frame.toBoard(1.0, 0.0, x, y); // twice as long, turned, moved
    COMPARE_WITHIN(x, 0.1 + 2.0 * std::cos(radians(30.0)), 1e-15);
    COMPARE_WITHIN(y, -0.2 + 2.0 * std::sin(radians(30.0)), 1e-15);
    frame.toTrack(x, y, x, y);
    COMPARE_WITHIN(x, 1.0, 1e-15);
    COMPARE_WITHIN(y, 0.0, 1e-15);
}

// A ball back and forth between two walls, measured with errors of +-0.1 mm in a fixed pattern.
void TestTrackReader::noiseIsFoundBesideBounces() {
    constexpr double kNoise = 1e-4;
    Track bouncing;
    uint64_t numbers = 1;
    const auto next = [&] { // uniform, of deviation kNoise
        numbers = numbers * 6364136223846793005U + 1442695040888963407U;
        return kNoise * std::sqrt(12.0) * (double(numbers >> 11) * 0x1p-53 - 0.5);
    };
    for (int i = 0; i < 600; ++i) {
        const double way = 0.1 * i / 60.0;
        const double x = std::abs(std::fmod(way, 0.06) - 0.03); // walls every 0.3 s
        bouncing.points.push_back({i / 60.0, x + next(), next()});
    }
    COMPARE_WITHIN(noiseOf(bouncing), kNoise, 0.15 * kNoise);
}

QTEST_GUILESS_MAIN(TestTrackReader)
#include "tst_track_reader.moc"
