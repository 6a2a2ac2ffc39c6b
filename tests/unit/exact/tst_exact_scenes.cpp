// SPDX-License-Identifier: MIT
// Two whole scenes compared with an independent 50-digit event-driven integration, model.md 12.4.
#include "run.h"

#include <QtTest>

using exact::kU;
using exact::Run;

class ExactScenes : public QObject {
    Q_OBJECT
private slots:
    void rollingModelFollowsTheReference();
};

namespace {

/// All numbers are exact in binary.
Run room() {
    return Run({exact::wall(-0.125, -0.125, 1.125, 0), exact::wall(-0.125, 1, 1.125, 1.125),
                exact::wall(-0.125, 0, 0, 1), exact::wall(1, 0, 1.125, 1), exact::wall(0.375, 0.3125, 0.625, 0.375),
                exact::wall(0.625, 0.3125, 0.6875, 0.6875), exact::floorOver(-0.125, -0.125, 1.125, 1.125)},
               0.0625, {0.25, 0.1875, 0.0625}, {0.75, 0.5, 0});
}

struct Second {
    phys_vec3 gravity;
    double x, y, vx, vy;
    double growth; // growth of an initial error until then
};

const Second kSeconds[] = {
    {{0.5, -0.3125, -9.75},
     0.82070511008190482158,
     0.17417049559190762784,
     0.66981009496462048732,
     -0.37371669787389160102,
     24},
    {{0.5, -0.3125, -9.75},
     0.63192707859375322016,
     0.22464684569040922296,
     -0.19461254077715245184,
     0.13070668320595469592,
     18},
    {{-1, 0.25, -9.75},
     0.11306877243039095751,
     0.21773689058180333616,
     -0.84149386392729655397,
     0.035260304519436595303,
     13},
    {{-1, 0.25, -9.75},
     0.23641796063640121689,
     0.27233906298484150862,
     -0.36865762918018483708,
     0.0037106691194469119404,
     28},
    {{0.25, -1.25, -9.75},
     0.14928674497621510479,
     0.15259669329937111187,
     0.23567774200357903481,
     0.1631398291823209831,
     96},
    {{0.25, -1.25, -9.75},
     0.44402541676976501192,
     0.11605217448113315497,
     0.35470784444007007879,
     0.011846254556296425712,
     210},
};

struct Bounce {
    double time;
    uint32_t box;
};

const Bounce kImpacts[] = {{0.13638083110439574312, 4}, {0.40652761150769008975, 0}, {0.78542610906131126674, 5},
                           {1.1681172015804869967, 3},  {1.2792262665381641507, 0},  {2.1768856989883168953, 4},
                           {3.0587708920537869372, 2},  {3.6803271396451594472, 4},  {4.5809053004385362603, 2},
                           {4.7029836750466662401, 0},  {5.6703162687819348706, 0}};

} // namespace

void ExactScenes::rollingModelFollowsTheReference() {
    Run run = room();
    run.params.restitution_wall = 0.75;
    run.params.rolling_friction = 0.01;
    size_t impact = 0;
    for (const Second &second : kSeconds) {
        run.params.gravity = second.gravity;
        run.step(1.0);
        for (const phys_event &event : run.events) {
            QCOMPARE(event.kind, uint32_t(PHYS_EVENT_IMPACT));
            QVERIFY(impact < std::size(kImpacts));
            QCOMPARE(event.box, kImpacts[impact].box);
            QVERIFY(std::abs(event.time - kImpacts[impact].time) <= kU * (1.0 + second.growth) * double(impact + 1));
            ++impact;
        }
        const double error = exact::difference(run.state, second.x, second.y, second.vx, second.vy);
        QVERIFY2(error <= kU * (1.0 + second.growth) * double(impact + 1), qPrintable(QString::number(error)));
        QVERIFY(std::abs(run.report.energy_scheme) <= 8.0 * kU);
    }
    QCOMPARE(impact, std::size(kImpacts));
}

QTEST_GUILESS_MAIN(ExactScenes)
#include "tst_exact_scenes.moc"
