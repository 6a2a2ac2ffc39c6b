// SPDX-License-Identifier: MIT
// Level 1, won by simulated key presses of a player who sees the ball and the way out.
#include "ui/game/clock_text.h"
#include "ui/game/game_strip.h"
#include "window_fixture.h"

#include <QComboBox>

#include <algorithm>
#include <array>
#include <cmath>

using namespace window_test;
using inspector::Game;

namespace {

constexpr int kCells = 4;        // of level 1, across and up
constexpr double kPitch = 0.036; // m, from cell to cell

// The direction to take from each cell, as seen from the front: the last row is the nearest.
constexpr std::array<const char *, kCells> kWayOut{
    "v>>v", // the ball starts below on the left and leaves on the right
    ">^vv", //
    "^>v>", //
    "^<<<", //
};

struct Place {
    double x, y; // m
};

double centreOf(int cell) { return kPitch * (cell - 0.5 * (kCells - 1)); }
int cellOf(double coordinate) { return std::clamp(int(std::floor(coordinate / kPitch + 0.5 * kCells)), 0, kCells - 1); }

// The middle of the next cell on the way out.
Place nextPlace(const phys_vec3 &ball) {
    const int column = cellOf(ball.x);
    const int row = cellOf(ball.y);
    const char step = kWayOut[size_t(kCells - 1 - row)][column];
    return {centreOf(column + (step == '>') - (step == '<')), centreOf(row + (step == '^') - (step == 'v'))};
}

// The player's decision: +1 or -1 for the key that is to be held, 0 for none.
int keyTowards(double place, double position, double velocity) {
    constexpr double kForesight = 0.25; // s: where the ball will be if nothing is done
    constexpr double kNearEnough = 0.003;
    const double apart = place - (position + kForesight * velocity);
    return std::abs(apart) < kNearEnough ? 0 : (apart > 0.0 ? 1 : -1);
}

// Presses and releases arrow keys, only where something changes.
class Hands {
public:
    explicit Hands(QWidget *window)
        : m_window(window) {}

    // Each -1, 0 or 1: left, none or right; down, none or up.
    void hold(int x, int y) {
        const std::array<bool, 4> wanted{x == -1, x == 1, y == -1, y == 1};
        for (size_t i = 0; i < kKeys.size(); ++i) {
            if (wanted[i] == m_held[i]) continue;
            m_held[i] = wanted[i];
            wanted[i] ? QTest::keyPress(m_window, kKeys[i]) : QTest::keyRelease(m_window, kKeys[i]);
        }
    }

private:
    static constexpr std::array<Qt::Key, 4> kKeys{Qt::Key_Left, Qt::Key_Right, Qt::Key_Down, Qt::Key_Up};
    QWidget *m_window;
    std::array<bool, 4> m_held{};
};

inspector::ui::GameText shownText(Fixture &fixture) {
    fixture.window().refresh();
    return fixture.find<inspector::ui::GameStrip>("game_strip")->text();
}

} // namespace

class TestWindowPlayer : public QObject {
    Q_OBJECT

public:
    static void initMain() { prepare(); }

private slots:
    void arrowKeysWinLevelOne();

private:
    static void levelTwoFollows(Fixture &fixture);
};

// Whatever the ball does while the machine is busy, the keys follow from its current position. Half speed, which any
// user can choose, makes up for a slow machine, but sets no best time.
void TestWindowPlayer::arrowKeysWinLevelOne() {
    Fixture fixture(1, inspector::gl::Drawing::Solid);
    fixture.window().resize(800, 600); // every picture of a board that tilts is drawn anew, by software
    QVERIFY(fixture.isReady());
    fixture.session().setSpeed(0.5);
    const auto text = [&] { return shownText(fixture); };
    QCOMPARE(text().line, QString("Press Enter to start"));
    fixture.press(Qt::Key_Return);
    QCOMPARE(fixture.game().phase(), Game::Phase::Playing);

    Hands hands(&fixture.window());
    const auto playUntilWon = [&] {
        const phys_state &ball = fixture.simulation().latest().current;
        const Place aim = nextPlace(ball.position);
        hands.hold(keyTowards(aim.x, ball.position.x, ball.velocity.x),
                   keyTowards(aim.y, ball.position.y, ball.velocity.y));
        return fixture.game().phase() == Game::Phase::Won;
    };
    QVERIFY(QTest::qWaitFor(playUntilWon, 3 * kPatience));
    hands.hold(0, 0);

    // The banner shows the time of the clock, and why it doesn't count.
    const double time = fixture.game().time();
    QVERIFY(time > 1.0 && time <= fixture.simulation().latest().current.time);
    QCOMPARE(text().title, QString("Level 1 done"));
    QCOMPARE(text().clock, inspector::ui::clockText(time));
    QCOMPARE(text().line, "no best time: " + fixture.session().whyNoBestTime());
    QVERIFY(fixture.session().whyNoBestTime().contains("speed"));
    QVERIFY(!fixture.game().bestTime(0));
    levelTwoFollows(fixture);
}

// Its board is level, the ball at its start.
void TestWindowPlayer::levelTwoFollows(Fixture &fixture) {
    fixture.press(Qt::Key_Return);
    QCOMPARE(fixture.session().level().name, QString("02"));
    QCOMPARE(fixture.window().windowTitle(), QString("Level 2 – Physics inspector"));
    QTRY_COMPARE(shownText(fixture).title, QString("Level 2"));
    QTRY_COMPARE(fixture.simulation().latest().current.step, 0u);
    QTRY_COMPARE(fixture.simulated("tilt_x"), 0.0);
    QTRY_COMPARE(fixture.simulated("tilt_y"), 0.0);
}

QTEST_MAIN(TestWindowPlayer)
#include "tst_window_player.moc"
