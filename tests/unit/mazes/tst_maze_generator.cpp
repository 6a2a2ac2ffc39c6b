// SPDX-License-Identifier: MIT
// The stages of the generator for many seeds, algorithms and dimensions.
#include "generator/files.h"
#include "generator/numbers.h"
#include "generator/recipe.h"
#include "generator/writers.h"

#include <QTest>

#include <algorithm>
#include <locale>
#include <set>

using namespace mazes;

namespace {

constexpr std::uint64_t kSeeds = 120;

/// The open ones of all walls between two cells.
std::size_t passagesOf(const CellMaze &cells) {
    const auto width = static_cast<std::size_t>(cells.width());
    const auto height = static_cast<std::size_t>(cells.height());
    return 2 * width * height - width - height - cells.closedInnerWalls().size();
}

Recipe recipeFor(std::uint64_t seed, Algorithm algorithm) {
    Recipe recipe;
    recipe.seed = seed;
    recipe.algorithm = algorithm;
    recipe.width = 2 + static_cast<int>(seed % 13);
    recipe.height = 2 + static_cast<int>(seed % 11);
    return recipe;
}

QByteArray described(const Recipe &recipe) { return QByteArray::fromStdString(generatorLine(recipe)); }

std::string bytesOf(const Recipe &recipe) {
    std::string bytes;
    for (const OutputFile &file : mazeFiles(recipe, makeMaze(recipe), "maze")) bytes += file.content;
    return bytes;
}

// Odd numbers of micrometres, so that halves of them occur.
Dimensions oddDimensions() {
    return {3'001 * kMicrometre, 10'007 * kMicrometre, 2'003 * kMicrometre, 7'001 * kMicrometre, 1'001 * kMicrometre};
}

bool overlap(const Box &a, const Box &b) {
    for (std::size_t axis = 0; axis < 3; ++axis)
        if (a.max[axis] <= b.min[axis] || b.max[axis] <= a.min[axis]) return false;
    return true;
}

// Whether both could be written as one box.
bool formOneBox(const Box &a, const Box &b) {
    std::size_t equal = 0;
    std::size_t touching = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        if (a.min[axis] == b.min[axis] && a.max[axis] == b.max[axis])
            ++equal;
        else if (a.max[axis] == b.min[axis] || b.max[axis] == a.min[axis])
            ++touching;
    }
    return a.material == b.material && equal == 2 && touching == 1;
}

Length areaSeenFromAbove(const Box &box) { return (box.max[0] - box.min[0]) * (box.max[1] - box.min[1]); }

// The area that the walls must cover, computed from the cells: each piece of wall between two posts, and each post with
// a wall.
Length wallArea(const Maze &maze) {
    const CellMaze &cells = maze.cells;
    std::set<std::pair<int, int>> posts;
    Length pieces = 0;
    const auto add = [&](int x0, int y0, int x1, int y1) {
        posts.insert({x0, y0});
        posts.insert({x1, y1});
        ++pieces;
    };
    for (const CellSide &wall : cells.closedInnerWalls()) {
        const Cell beyond = neighbour(wall.cell, wall.side);
        add(beyond.x, beyond.y, wall.cell.x + 1, wall.cell.y + 1);
    }
    for (int x = 0; x < cells.width(); ++x) {
        if (CellSide{{x, 0}, Side::South} != maze.exit) add(x, 0, x + 1, 0);
        if (CellSide{{x, cells.height() - 1}, Side::North} != maze.exit) add(x, cells.height(), x + 1, cells.height());
    }
    for (int y = 0; y < cells.height(); ++y) {
        if (CellSide{{0, y}, Side::West} != maze.exit) add(0, y, 0, y + 1);
        if (CellSide{{cells.width() - 1, y}, Side::East} != maze.exit) add(cells.width(), y, cells.width(), y + 1);
    }
    const Dimensions &d = maze.board.dimensions;
    return pieces * (d.pitch - d.wallThickness) * d.wallThickness +
           static_cast<Length>(posts.size()) * d.wallThickness * d.wallThickness;
}

void algorithmRows() {
    QTest::addColumn<int>("algorithm");
    for (const AlgorithmRow &row : kAlgorithms) QTest::newRow(row.name.data()) << static_cast<int>(row.algorithm);
}

// Every seed with the row's algorithm; every third with odd dimensions, every fourth with loops.
std::vector<Recipe> recipes() {
    QFETCH(int, algorithm);
    std::vector<Recipe> recipes;
    for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
        Recipe recipe = recipeFor(seed, static_cast<Algorithm>(algorithm));
        if (seed % 3 == 0) recipe.dimensions = oddDimensions();
        if (seed % 4 == 0) recipe.loopMillionths = 300'000;
        recipes.push_back(recipe);
    }
    return recipes;
}

} // namespace

class TestMazeGenerator : public QObject {
    Q_OBJECT

private slots:
    void drawsAreThoseOfSplitMix64();
    void boundedDrawsAreUniform_data();
    void boundedDrawsAreUniform();
    void mazesArePerfect_data() { algorithmRows(); }
    void mazesArePerfect();
    void loopsOpenTheirShareOfTheWalls_data() { algorithmRows(); }
    void loopsOpenTheirShareOfTheWalls();
    void allLoopsLeaveNoInnerWall();
    void exitIsTheFarthestBorderCell();
    void sameRecipeGivesSameBytes_data() { algorithmRows(); }
    void sameRecipeGivesSameBytes();
    void otherSeedsAndAlgorithmsGiveOtherMazes();
    void boxesNeitherOverlapNorAreSlivers_data() { algorithmRows(); }
    void boxesNeitherOverlapNorAreSlivers();
    void wallsInOneLineAreOneBox_data() { algorithmRows(); }
    void wallsInOneLineAreOneBox();
    void wallsCoverTheirPlacesAndNoOther_data() { algorithmRows(); }
    void wallsCoverTheirPlacesAndNoOther();
    void floorExitAndRimTileTheBoard();
    void boardIsCentred();
    void lengthsPrintAsShortestExactDecimals();
    void numbersIgnoreTheLocale();
    void decimalsAreReadExactlyOrRefused_data();
    void decimalsAreReadExactlyOrRefused();
};

void TestMazeGenerator::drawsAreThoseOfSplitMix64() {
    // The published sequence for the seed 1234567.
    mazes::Random random(1234567);
    for (const std::uint64_t expected : {6457827717110365317U, 3203168211198807973U, 9817491932198370423U,
                                         4593380528125082431U, 16408922859458223821U})
        QCOMPARE(random.next(), expected);
}

void TestMazeGenerator::boundedDrawsAreUniform_data() {
    QTest::addColumn<quint64>("unit");
    QTest::newRow("few") << quint64{1};
    QTest::newRow("so many that remainders alone would favour the lower third") << (quint64{1} << 61);
}

void TestMazeGenerator::boundedDrawsAreUniform() {
    QFETCH(quint64, unit);
    // 60,000 draws from six: the standard deviation of each count is 91; five of them are allowed.
    mazes::Random random(5);
    std::array<int, 6> counts{};
    for (int i = 0; i < 60'000; ++i) ++counts.at(random.below(counts.size() * unit) / unit);
    for (const int count : counts) QVERIFY(std::abs(count - 10'000) < 5 * 91);
}

void TestMazeGenerator::mazesArePerfect() {
    QFETCH(int, algorithm);
    for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
        const Recipe recipe = recipeFor(seed, static_cast<Algorithm>(algorithm));
        const CellMaze cells = makeMaze(recipe).cells;
        // Connected, with one passage less than cells: a tree.
        QVERIFY2(passagesOf(cells) == cells.cellCount() - 1, described(recipe));
        const std::vector<int> distances = cells.distancesFrom({0, 0});
        QVERIFY2(std::count(distances.begin(), distances.end(), -1) == 0, described(recipe));
    }
}

void TestMazeGenerator::loopsOpenTheirShareOfTheWalls() {
    QFETCH(int, algorithm);
    for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
        Recipe recipe = recipeFor(seed, static_cast<Algorithm>(algorithm));
        const std::size_t walls = makeMaze(recipe).cells.closedInnerWalls().size();
        recipe.loopMillionths = 250'000;
        const CellMaze cells = makeMaze(recipe).cells;
        QVERIFY2(passagesOf(cells) == cells.cellCount() - 1 + walls / 4, described(recipe));
        QVERIFY2(cells.closedInnerWalls().size() == walls - walls / 4, described(recipe));
    }
}

void TestMazeGenerator::allLoopsLeaveNoInnerWall() {
    Recipe recipe = recipeFor(8, Algorithm::Wilson);
    recipe.loopMillionths = 1'000'000;
    const Maze maze = makeMaze(recipe);
    QCOMPARE(maze.cells.closedInnerWalls().size(), std::size_t{0});
    // Floor, exit, and the rim: four sides of which one is cut in two, unless the opening is at its end.
    QVERIFY(maze.board.boxes.size() == 6 || maze.board.boxes.size() == 7);
}

void TestMazeGenerator::exitIsTheFarthestBorderCell() {
    for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
        const Recipe recipe = recipeFor(seed, Algorithm::Backtracker);
        const Maze maze = makeMaze(recipe);
        QVERIFY2(!maze.cells.contains(neighbour(maze.exit.cell, maze.exit.side)), described(recipe));
        const std::vector<int> distances = maze.cells.distancesFrom(maze.entrance);
        for (std::size_t index = 0; index < distances.size(); ++index) {
            const Cell cell = maze.cells.cellAt(index);
            const bool isOnBorder =
                cell.x == 0 || cell.y == 0 || cell.x == recipe.width - 1 || cell.y == recipe.height - 1;
            QVERIFY2(!isOnBorder || distances[index] <= distances[maze.cells.indexOf(maze.exit.cell)],
                     described(recipe));
        }
    }
}

void TestMazeGenerator::sameRecipeGivesSameBytes() {
    for (const Recipe &recipe : recipes()) QVERIFY2(bytesOf(recipe) == bytesOf(recipe), described(recipe));
}

void TestMazeGenerator::otherSeedsAndAlgorithmsGiveOtherMazes() {
    std::set<std::vector<std::size_t>> seen; // each maze as its list of walls, without file headers
    for (const AlgorithmRow &row : kAlgorithms) {
        for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
            mazes::Random random(seed);
            const CellMaze cells = carvePerfectMaze(8, 8, row.algorithm, random);
            std::vector<std::size_t> walls;
            for (const CellSide &wall : cells.closedInnerWalls())
                walls.push_back(2 * cells.indexOf(wall.cell) + (wall.side == Side::East ? 0 : 1));
            seen.insert(walls);
        }
    }
    QCOMPARE(seen.size(), kSeeds * kAlgorithms.size());
}

void TestMazeGenerator::boxesNeitherOverlapNorAreSlivers() {
    for (const Recipe &recipe : recipes()) {
        const std::vector<Box> boxes = makeMaze(recipe).board.boxes;
        const Dimensions &d = recipe.dimensions;
        const Length thinnest = std::min({d.wallThickness, d.wallHeight, d.floorThickness, d.pitch - d.wallThickness});
        for (std::size_t i = 0; i < boxes.size(); ++i) {
            for (std::size_t axis = 0; axis < 3; ++axis)
                QVERIFY2(boxes[i].max[axis] - boxes[i].min[axis] >= thinnest, described(recipe));
            for (std::size_t j = i + 1; j < boxes.size(); ++j)
                QVERIFY2(!overlap(boxes[i], boxes[j]), described(recipe));
        }
    }
}

void TestMazeGenerator::wallsInOneLineAreOneBox() {
    for (const Recipe &recipe : recipes()) {
        const std::vector<Box> boxes = makeMaze(recipe).board.boxes;
        for (std::size_t i = 0; i < boxes.size(); ++i)
            for (std::size_t j = i + 1; j < boxes.size(); ++j)
                QVERIFY2(!formOneBox(boxes[i], boxes[j]), described(recipe));
    }
}

void TestMazeGenerator::wallsCoverTheirPlacesAndNoOther() {
    // Without overlaps, the sum of areas is right only if every joint is filled and nothing sticks out.
    for (const Recipe &recipe : recipes()) {
        const Maze maze = makeMaze(recipe);
        Length area = 0;
        for (const Box &box : maze.board.boxes)
            if (box.max[2] > 0) area += areaSeenFromAbove(box);
        QVERIFY2(area == wallArea(maze), described(recipe));
    }
}

void TestMazeGenerator::floorExitAndRimTileTheBoard() {
    for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
        const Recipe recipe = recipeFor(seed, Algorithm::Wilson);
        const Dimensions &d = recipe.dimensions;
        Length area = 0;
        for (const Box &box : makeMaze(recipe).board.boxes)
            if (box.min[2] < 0) area += areaSeenFromAbove(box);
        const Length width = recipe.width * d.pitch + d.wallThickness;
        const Length depth = recipe.height * d.pitch + d.wallThickness;
        QVERIFY2(area == width * depth, described(recipe));
    }
}

void TestMazeGenerator::boardIsCentred() {
    Recipe recipe = recipeFor(3, Algorithm::Kruskal);
    recipe.dimensions = oddDimensions();
    Point min{};
    Point max{};
    for (const Box &box : makeMaze(recipe).board.boxes) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            min[axis] = std::min(min[axis], box.min[axis]);
            max[axis] = std::max(max[axis], box.max[axis]);
        }
    }
    QCOMPARE(min[0], -max[0]);
    QCOMPARE(min[1], -max[1]);
    QCOMPARE(min[2], -recipe.dimensions.floorThickness);
    QCOMPARE(max[2], recipe.dimensions.wallHeight);
}

void TestMazeGenerator::lengthsPrintAsShortestExactDecimals() {
    QCOMPARE(metres(0), std::string("0"));
    QCOMPARE(metres(-92'500'000), std::string("-0.0925"));
    QCOMPARE(metres(500), std::string("0.0000005"));
    QCOMPARE(metres(123'456'789'500), std::string("123.4567895"));
    QCOMPARE(micrometres(-1'500), std::string("-1.5"));
    QCOMPARE(millionths(1'000'000), std::string("1"));
}

void TestMazeGenerator::numbersIgnoreTheLocale() {
    struct CommaPoint : std::numpunct<char> {
        char do_decimal_point() const override { return ','; }
        char do_thousands_sep() const override { return '.'; }
        std::string do_grouping() const override { return "\3"; }
    };
    Recipe recipe = recipeFor(12'345, Algorithm::Wilson);
    recipe.width = 20;
    const std::string expected = bytesOf(recipe);
    const std::locale before = std::locale::global(std::locale(std::locale(), new CommaPoint));
    const std::string found = bytesOf(recipe);
    std::locale::global(before);
    QVERIFY(found == expected);
}

void TestMazeGenerator::decimalsAreReadExactlyOrRefused_data() {
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<qint64>("expected"); // millionths; -1 if refused
    const auto add = [](const char *text, qint64 expected) { QTest::newRow(text) << QByteArray(text) << expected; };
    add("0", 0);
    add("0.036", 36'000);
    add(".5", 500'000);
    add("12.", 12'000'000);
    add("0.000001", 1);
    add("999999999.999999", 999'999'999'999'999);
    for (const char *refused :
         {"", ".", "-1", "+1", "1e-3", "0,5", "0.0000001", "1000000000", " 1", "1 ", "0x1", "nan", "1.2.3"})
        add(refused, -1);
}

void TestMazeGenerator::decimalsAreReadExactlyOrRefused() {
    QFETCH(QByteArray, text);
    QFETCH(qint64, expected);
    QCOMPARE(parseMillionths(text.toStdString()).value_or(-1), expected);
}

QTEST_APPLESS_MAIN(TestMazeGenerator)
#include "tst_maze_generator.moc"
