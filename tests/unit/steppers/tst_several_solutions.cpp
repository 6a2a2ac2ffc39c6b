// SPDX-License-Identifier: MIT
// Coulomb's law of several contacts may have more than one solution: all steppers take the one with the least pressure
// that no prestress feeds, model.md 13.5 and 14.1. Accelerations are those of a first step, too short to change them.
#include "support/experiment.h"
#include "support/stepper_rows.h"

#include <QTest>

#include <array>
#include <cmath>
#include <random>
#include <vector>

using namespace support;

namespace {

struct Start {
    double radius = 0.01;
    std::vector<phys_box> boxes;
    phys_vec3 place{0.0, 0.0, 0.0}, velocity{0.0, 0.0, 0.0}, spin{0.0, 0.0, 0.0};
    phys_vec3 gravity{0.0, 0.0, 0.0};
    double floor = 0.0, wall = 0.0, rolling = 0.0; ///< friction
    uint32_t model = PHYS_MODEL_RIGID;
};

/// Accelerations of the centre and, times the radius, of the spin, m/s^2; huge in a jam.
using Accelerations = std::array<double, 6>;

constexpr double kShort = 1e-6; // of sqrt(R/g)

double sizeOf(const phys_vec3 &v) { return std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z); }

Experiment ballOf(const QByteArray &stepper, const Start &start) {
    SceneBuilder scene;
    scene.ball(start.radius).start({0.0, 0.0, -1000.0 * start.radius});
    for (const phys_box &box : start.boxes) scene.box(box);
    Experiment ball(scene, stepper, start.model);
    ball.params.gravity = start.gravity;
    ball.params.restitution_wall = ball.params.restitution_floor = 0.0;
    ball.params.sliding_friction = start.floor;
    ball.params.wall_friction = start.wall;
    ball.params.rolling_friction = start.rolling;
    ball.state.position = start.place;
    ball.state.velocity = start.velocity;
    ball.state.spin = start.spin;
    return ball;
}

Accelerations accelerationsOf(const QByteArray &stepper, const Start &start) {
    Experiment ball = ballOf(stepper, start);
    const double dt = kShort * std::sqrt(start.radius / sizeOf(start.gravity)), perSpin = start.radius / dt;
    if (!ball.step(dt)) qFatal("%s: %s", stepper.constData(), ball.error());
    const phys_vec3 &v = ball.state.velocity, &om = ball.state.spin;
    return {(v.x - start.velocity.x) / dt,   (v.y - start.velocity.y) / dt,   (v.z - start.velocity.z) / dt,
            perSpin * (om.x - start.spin.x), perSpin * (om.y - start.spin.y), perSpin * (om.z - start.spin.z)};
}

double distance(const Accelerations &a, const Accelerations &b) {
    double sum = 0.0;
    for (size_t i = 0; i < a.size(); ++i) sum += (a[i] - b[i]) * (a[i] - b[i]);
    return std::sqrt(sum);
}

Start onFloorBeside(const phys_box &other) {
    Start start;
    start.boxes = {{{-0.1, -0.1, -0.01}, {0.1, 0.1, 0.0}}, other};
    start.place = {0.0, 0.0, 0.01};
    return start;
}

const phys_box kLowKerb{{-0.1, -0.1, -0.01}, {-0.0028, 0.1, 0.0004}};

Start besideALowKerbHeldByResistance() {
    Start start = onFloorBeside(kLowKerb);
    start.model = PHYS_MODEL_ROLLING;
    start.gravity = {-1.0, -1.5, -9.8};
    start.floor = 0.5;
    start.rolling = 0.19;
    return start;
}

Start spinningAtAWallHeldByResistance() {
    Start start = onFloorBeside({{-0.1, -0.1, -0.01}, {-0.01, 0.1, 0.05}});
    start.spin = {0.0, 0.0, 40.0};
    start.gravity = {-3.0, -6.0, -8.0};
    start.floor = 1.5;
    start.wall = 1.3;
    start.rolling = 0.3;
    return start;
}

Start spinningAtARoughKerbOnASmoothFloor() {
    Start start = onFloorBeside(kLowKerb);
    start.spin = {0.0, -30.0, 0.0};
    start.gravity = {0.0, 0.0, -9.8};
    start.wall = 1.2;
    return start;
}

Start turningUnderARoofHeldByResistance() {
    Start start = onFloorBeside({{0.006, -0.1, 0.018}, {0.1, 0.1, 0.03}});
    start.spin = {0.0, 0.0, -2.0};
    start.gravity = {2.4, -3.6, -8.8};
    start.floor = 0.95;
    start.wall = 0.4;
    start.rolling = 0.12;
    return start;
}

Start slippingAtThreeInOnePlane() {
    Start start;
    start.radius = 0.006;
    start.boxes = {{{-0.027, -0.021, 0.006}, {0.029, 0.022, 0.04}},
                   {{-0.027, 0.0014762890050154826, -0.033}, {0.031, 0.031, -0.0058155456127237451}},
                   {{-0.031, -0.029, -0.029}, {0.03, -0.0043220464838460522, -0.0041617201000877001}}};
    start.velocity = {0.013265847105347641, 0.0, 0.0};
    start.spin = {51.74148663046703, 31.231083062158866, -91.355152888658054};
    start.gravity = {0.0, 0.0, -10.0};
    start.wall = 2.0;
    return start;
}

Start heldByTwoOfThreeInOnePlane() {
    Start start;
    start.radius = 0.006;
    start.boxes = {{{-0.0085831845232854156, -0.014, 0.006305085070734062}, {-0.005992238571653769, 0.038, 0.021}},
                   {{0.0034669306952204975, -0.0075, -0.018}, {0.02, 0.0095, 0.0011030222019557901}},
                   {{0.006, -0.038, -0.039}, {0.008, 0.036, 0.055}}};
    start.place.z = 0.006;
    start.gravity = {-5.6044647036766229, 2.5304802762504384, -7.8237458677287446};
    start.wall = 0.98348446082265639;
    return start;
}

Start spinningAmongFour() {
    Start start;
    start.boxes = {{{-0.044, -0.05, 0.01}, {0.035, 0.047, 0.068}},
                   {{0.0069351815941926338, -0.041, -0.054}, {0.061, -0.0072043914562974522, 0.046}},
                   {{-0.057, -0.037, -0.039}, {-0.0096847143044668359, -0.0011665793054398514, -0.0022012272860781378}},
                   {{-0.059, 0.01, -0.059}, {0.048, 0.062, 0.053}}};
    start.spin = {65.364796544467481, 52.917775666908682, 32.717583456426304};
    start.gravity = {0.0, 0.0, 3.0};
    start.wall = 2.0;
    return start;
}

Start amongFiveHeldByResistance() {
    Start start;
    start.radius = 0.006;
    start.boxes = {
        {{-0.24, -0.24, -0.24}, {0.24, 0.24, 0.0}},
        {{-0.024, 0.0018758098572326228, -0.017}, {-0.0013589822991895014, 0.003, 0.00046515542313982014}},
        {{0.0052056978432616667, -0.015, 0.008579888724551489}, {0.023, -0.0014982937407574425, 0.018}},
        {{-0.0038, -0.015, -0.0082}, {-0.0013100689587766368, 0.039, 0.0001447699171381921}},
        {{0.0013100689587766368, -0.015, -0.0082}, {0.0038, 0.039, 0.0001447699171381921}},
    };
    start.place.z = 0.006;
    start.gravity = {9.6896717267229615, -6.4915595842269616, -7.0576412410431839};
    start.floor = 0.63448716008606154;
    start.rolling = 2.8732785123575275;
    start.model = PHYS_MODEL_ROLLING;
    return start;
}

Start drivenAlongABeam() {
    Start start = onFloorBeside({{0.006, -0.1, 0.018}, {0.1, 0.1, 0.03}});
    start.model = PHYS_MODEL_ROLLING;
    start.gravity = {0.0, 7.0, 0.0};
    return start;
}

Start rollingRoundAPost() {
    Start start = onFloorBeside({{0.008, 0.006, -0.01}, {0.1, 0.1, 0.03}});
    start.model = PHYS_MODEL_ROLLING;
    start.velocity = {0.006, -0.008, 0.0};
    start.spin = {0.8, 0.6, 0.0};
    start.gravity = {10.0, 0.0, 0.0};
    return start;
}

Start amongFourThatCouldHoldIt() {
    Start start;
    start.radius = 0.21817811865780662;
    start.boxes = {{{-0.36, -0.63, 0.37245334586726486}, {-0.15427522720945827, 0.63, 0.58}},
                   {{0.12596519553837077, 0.12596519553837077, -0.22}, {0.44, 0.44, 0.09221292311943584}},
                   {{-0.69, -0.69, -0.23}, {0.69, 0.69, 0.0}},
                   {{0.15427522720945827, 0.15427522720945827, -0.64}, {0.44, 0.44, 1.07}}};
    start.place.z = start.radius;
    start.gravity = {1.0, 0.0, -4.0};
    start.floor = start.wall = 1.0;
    return start;
}

/// Random numbers that are the same everywhere.
class Draw {
public:
    explicit Draw(uint64_t seed)
        : m_bits(seed) {}
    double between(double low, double high) { return low + (high - low) * std::ldexp(double(m_bits() >> 11), -53); }
    bool chance(double share) { return between(0.0, 1.0) < share; }
    uint32_t below(uint32_t count) { return static_cast<uint32_t>(m_bits() % count); }
    phys_vec3 vector(double size) { return {between(-size, size), between(-size, size), between(-size, size)}; }

private:
    std::mt19937_64 m_bits;
};

/// A box that a ball around the origin touches with a face, edge or corner.
phys_box touching(double radius, Draw &draw, bool isFloor) {
    std::array<double, 3> normal{0.0, 0.0, 1.0};
    if (!isFloor) {
        const uint32_t axes = 1 + draw.below(3), first = draw.below(3);
        normal = {0.0, 0.0, 0.0};
        for (uint32_t i = 0; i < axes; ++i)
            normal[(first + i) % 3] = (draw.chance(0.5) ? 1 : -1) * draw.between(0.1, 1);
    }
    const double size = std::hypot(normal[0], normal[1], normal[2]);
    std::array<double, 3> low{}, high{};
    for (size_t i = 0; i < 3; ++i) {
        const double at = -radius * (normal[i] / size), far = radius * draw.between(3.0, 6.0);
        low[i] = normal[i] > 0.0 ? at - far : normal[i] < 0.0 ? at : -far;
        high[i] = normal[i] > 0.0 ? at : normal[i] < 0.0 ? at + far : far;
    }
    return {{low[0], low[1], low[2]}, {high[0], high[1], high[2]}};
}

/// At rest, but for a spin, at two to four contacts, for some seeds at up to six.
Start drawn(uint64_t seed) {
    Draw draw(seed);
    Start start;
    start.gravity = draw.vector(10.0);
    const uint32_t count = (seed % 16 == 0 ? 4 : 2) + draw.below(3);
    const bool hasFloor = draw.chance(0.6);
    for (uint32_t i = 0; i < count; ++i) start.boxes.push_back(touching(start.radius, draw, hasFloor && i == 0));
    start.floor = draw.between(0.0, 2.0);
    start.wall = draw.between(0.0, 2.0);
    start.rolling = draw.chance(0.5) ? draw.between(0.0, 0.3) * std::min(1.0, start.floor) : 0.0;
    if (draw.chance(0.7)) start.spin = draw.vector(60.0);
    return start;
}

/// Whether a stepper's accelerations differ from those of `exact`; not in a jam, where both depend on the step.
bool differs(const QByteArray &stepper, const Start &start) {
    constexpr double kJam = 1e4, kSame = 1e-3;
    const Accelerations wanted = accelerationsOf("exact", start);
    const double spin = sizeOf(start.spin), scale = sizeOf(start.gravity) + start.radius * spin * spin;
    if (distance(wanted, {}) > kJam * scale) return false;
    return distance(accelerationsOf(stepper, start), wanted) > kSame * (scale + distance(wanted, {}));
}

/// The boxes without which the difference vanishes.
Start shrunk(const QByteArray &stepper, Start start) {
    for (size_t i = 0; i < start.boxes.size();) {
        Start less = start;
        less.boxes.erase(less.boxes.begin() + static_cast<std::ptrdiff_t>(i));
        if (differs(stepper, less))
            start = less;
        else
            ++i;
    }
    return start;
}

} // namespace

class TestSeveralSolutions : public QObject {
    Q_OBJECT

private slots:
    void theLeastPressureIsTaken_data();
    void theLeastPressureIsTaken();
    void aSpeedOfRoundingSizeLeavesNoContact_data() { addStepperRows(); }
    void aSpeedOfRoundingSizeLeavesNoContact();
    void aSpinThatUnderflowsIsNone_data() { addStepperRows(); }
    void aSpinThatUnderflowsIsNone();
    void theIdleWallOfTwoBrakesNothing_data() { addStepperRows(); }
    void theIdleWallOfTwoBrakesNothing();
    void aSpeedOfRoundingSizeOffAFloorIsNoFlight_data() { addStepperRows(); }
    void aSpeedOfRoundingSizeOffAFloorIsNoFlight();
    void aSlipThatPressesIntoAWedgeEndsWithoutAJam_data() { addStepperRows(); }
    void aSlipThatPressesIntoAWedgeEndsWithoutAJam();
    void aRoughEdgeThatTheBallLeavesTakesNoSpeed_data() { addStepperRows(); }
    void aRoughEdgeThatTheBallLeavesTakesNoSpeed();
    void aFloorThatTheBallLeavesSlowlyHoldsItNoMore_data() { addStepperRows(); }
    void aFloorThatTheBallLeavesSlowlyHoldsItNoMore();
    void aBallRollsOffWhereFourContactsCouldHoldIt_data() { addStepperRows(); }
    void aBallRollsOffWhereFourContactsCouldHoldIt();
    void aCornerThatRubsLeavesTheFloorItsResistance_data();
    void aCornerThatRubsLeavesTheFloorItsResistance();
    void randomStartsAccelerateAsInExact_data() { addStepperRows(); }
    void randomStartsAccelerateAsInExact();
};

Start rollingRoundALowCorner() {
    Start start;
    start.radius = 0.006;
    start.boxes = {{{-0.24, -0.24, -0.24}, {0.24, 0.24, 0.0}},
                   {{-0.0135, 0.0029724006607011778, -0.02}, {-0.0018845295702642386, 0.022, 0.0011406396911668622}}};
    start.place.z = 0.006;
    start.velocity = {0.033399601347374318, 0.021175656837364686, 0.0};
    start.spin = {-start.velocity.y / start.radius, start.velocity.x / start.radius, 0.0};
    start.gravity = {2.6524219699386169, 4.9133260633235123, -3.0662735314700016};
    start.rolling = 0.18110900719159287;
    start.model = PHYS_MODEL_ROLLING;
    return start;
}

Start underTwoRoofsBesideAWall() {
    Start start;
    start.radius = 0.006;
    start.boxes = {{{-0.24, -0.24, -0.24}, {0.24, 0.24, 0.0}},
                   {{-0.029695321260225494, -0.014777887045642781, -0.022024711203226431},
                    {0.049284410037976747, -0.006, 0.024392327831587887}},
                   {{-0.018348335756488702, -0.049375612928633704, 0.011551476628865503},
                    {-0.0022762045688294588, 0.019771293022721428, 0.023644510327346158}},
                   {{0.0022762045688294588, -0.049375612928633704, 0.011551476628865503},
                    {0.018348335756488702, 0.019771293022721428, 0.023644510327346158}}};
    start.place.z = 0.006;
    start.gravity = {7.6119810634931753, 1.1950538561383137, 2.6150935332858367};
    start.floor = 0.2352214460412716;
    start.wall = 1.145399027273565;
    start.rolling = 0.020646944205576886;
    return start;
}

Start inASlotHeldByResistance() {
    Start start;
    start.radius = 0.006;
    start.boxes = {
        {{-0.24, -0.24, -0.24}, {0.24, 0.24, 0.0}},
        {{-0.038, 0.006, -0.025}, {0.053, 0.015, 0.046}},
        {{-0.036, -0.013, -0.0095}, {0.019, -0.006, 0.023}},
        {{0.00068702426380486614, -0.006, -0.007}, {0.012, -0.00055316684156578343, 6.5187104353202699e-05}}};
    start.place.z = 0.006;
    start.gravity = {1.2950033705860839, 3.566147275669898, -9.4960700885430267};
    start.floor = start.wall = 1e6;
    start.rolling = 0.70767541748982976;
    return start;
}

Start underARoofEdgeThatPressesItOntoTheFloor() {
    Start start;
    start.radius = 0.006;
    start.model = PHYS_MODEL_ROLLING;
    start.boxes = {{{-0.24, -0.24, -0.24}, {0.24, 0.24, 0.0}},
                   {{-0.0084286368259205921, -0.018587631889640143, 0.011846516580631208},
                    {-0.0013484227350517297, 0.034998676316540536, 0.014417219366018301}}};
    start.place.z = 0.006;
    start.velocity.y = 0.1183266475482864;
    start.spin = {8.8752364078200987, -75.452842418094832, -65.98424547371971};
    start.gravity = {-8.539416110692013, -0.37749419983635946, 1.9593462345651549};
    start.rolling = 0.014064752524119192;
    return start;
}

/// Spin about y presses it onto the wall, whose friction lifts it against the edge of the roof.
Start slippingOnAFloorIntoAWallUnderARoofEdge() {
    Start start;
    start.radius = 0.006;
    start.boxes = {{{-0.24, -0.24, -0.054}, {0.24, 0.24, 0.0}},
                   {{-0.01876413091698535, -0.008256410471033131, 0.008565325180660967},
                    {-0.005423938303250395, 0.028695637440842945, 0.009772045471775572}},
                   {{0.006, -0.016295651432523803, 0.0017343299287672293},
                    {0.029725232745824677, 0.00451883851375011, 0.021789270594602443}}};
    start.place = {0.0, 0.0025856692799336965, 0.006};
    start.velocity.y = 0.16646998458155923;
    start.spin = {-30.432726627974635, 10.326189450143648, -30.97101436950107};
    start.gravity.z = -9.81;
    start.floor = 0.05;
    start.wall = 1e3;
    start.rolling = 0.01867153358883634;
    return start;
}

void TestSeveralSolutions::theLeastPressureIsTaken_data() {
    QTest::addColumn<QByteArray>("stepper");
    QTest::addColumn<int>("which");
    for (const QByteArray &stepper : stepperIds()) {
        const char *const names[] = {"resistance holds a ball beside a low kerb",
                                     "resistance doesn't press a ball into a wall",
                                     "a rough kerb lifts a spinning ball off a smooth floor",
                                     "two of three in one plane carry a ball",
                                     "two or three of four carry a ball",
                                     "two of three in one plane hold a ball",
                                     "a ball that rolls round a low corner stays on the floor",
                                     "resistance holds a ball in a slot beside a corner",
                                     "resistance holds a ball among five contacts",
                                     "a floor without pressure turns a ball beside a beam",
                                     "a floor without pressure turns a ball round a post"};
        for (int i = 0; i < 11; ++i) QTest::addRow("%s, %s", stepper.constData(), names[i]) << stepper << i;
    }
}

void TestSeveralSolutions::theLeastPressureIsTaken() {
    QFETCH(QByteArray, stepper);
    QFETCH(int, which);
    struct Case {
        Start start;
        Accelerations wanted;
    };
    const double N = 9.8 * 0.96, rubbing = 1.2 * N; // at the kerb's edge, with normal (0.28, 0, 0.96)
    const Case cases[] = {
        {besideALowKerbHeldByResistance(), {}},
        {spinningAtAWallHeldByResistance(), {0.0, 0.0, 0.0, 0.0, 0.0, -2.5 * 1.3 * 3.0}},
        {spinningAtARoughKerbOnASmoothFloor(),
         {0.28 * N - 0.96 * rubbing, 0.0, 0.96 * N + 0.28 * rubbing - 9.8, 0.0, 2.5 * rubbing, 0.0}},
        {slippingAtThreeInOnePlane(), {11.86, 0.0, 0.0, -18.0, -20.6, 21.4}},
        {spinningAmongFour(), {0.0, 0.0, 0.0, -9.53, -2.98, -3.16}},
        {heldByTwoOfThreeInOnePlane(), {0.0, 0.817, 0.0, -1.64, 0.0, 0.903}},
        {rollingRoundALowCorner(), {2.683, 2.227, 0.0, -2.227, 2.683, 0.0}},
        {inASlotHeldByResistance(), {}},
        {amongFiveHeldByResistance(), {}},
        {drivenAlongABeam(), {0.0, 5.0, 0.0, -5.0, 0.0, 0.0}},
        {rollingRoundAPost(), {18.0 / 7.0, -24.0 / 7.0, 0.0, 24.0 / 7.0, 18.0 / 7.0, 0.0}},
    };
    const Accelerations found = accelerationsOf(stepper, cases[which].start);
    const double off = distance(found, cases[which].wanted);
    QVERIFY2(off < 0.1, qPrintable(QStringLiteral("off by %1 m/s^2").arg(off)));
}

void TestSeveralSolutions::aSpeedOfRoundingSizeLeavesNoContact() {
    QFETCH(QByteArray, stepper);
    Start start = turningUnderARoofHeldByResistance();
    const Accelerations wanted = accelerationsOf(stepper, start);
    start.velocity.x = -1e-21; // off the roof's edge, on which gravity doesn't press the ball
    const double off = distance(accelerationsOf(stepper, start), wanted);
    QVERIFY2(off < 1e-3, qPrintable(QStringLiteral("off by %1 m/s^2").arg(off)));
}

void TestSeveralSolutions::aSpinThatUnderflowsIsNone() {
    QFETCH(QByteArray, stepper);
    Start start = underTwoRoofsBesideAWall();
    const Accelerations wanted = accelerationsOf(stepper, start);
    start.spin = {3.7e-270, 0.0, -8.9e-270};
    const double off = distance(accelerationsOf(stepper, start), wanted);
    QVERIFY2(off < 1e-3, qPrintable(QStringLiteral("off by %1 m/s^2").arg(off)));
}

/// Between walls exactly as far apart as the ball is wide, of which one presses; it rolls over an edge below.
void TestSeveralSolutions::theIdleWallOfTwoBrakesNothing() {
    QFETCH(QByteArray, stepper);
    constexpr double kStep = 0x1p-16;
    constexpr int kSteps = 400;
    const double edge = std::sqrt(1.0 / 2.0);
    const auto scene = SceneBuilder()
                           .ball(1.0)
                           .box({{-2.0, -9.0, -9.0}, {-1.0, 9.0, 9.0}})
                           .box({{1.0, -9.0, -9.0}, {2.0, 9.0, 9.0}})
                           .box({{-1.2, edge, -2.0}, {1.2, 2.0, -edge}})
                           .start({0.0, 0.0, -50.0});
    Experiment ball(scene, stepper, PHYS_MODEL_RIGID);
    ball.params.gravity = {0.875, 0.0, -0.625};
    ball.params.wall_friction = 1e3;
    ball.state.position = {0.0, 0.0, 0.0};
    QVERIFY2(ball.stepTimes(kSteps, kStep), ball.error());
    // It turns about the line through both points, at 1/sqrt(2) from its centre: the inertia is 1 + (2/5)/(1/2).
    const double off = ball.state.velocity.y + 0.625 / 2.0 / 1.8 * kSteps * kStep;
    QVERIFY2(std::abs(off) < 1e-6, qPrintable(QStringLiteral("off by %1 m/s").arg(off)));
}

void TestSeveralSolutions::aSpeedOfRoundingSizeOffAFloorIsNoFlight() {
    QFETCH(QByteArray, stepper);
    Start start = underARoofEdgeThatPressesItOntoTheFloor();
    const Accelerations wanted = accelerationsOf(stepper, start);
    start.velocity.z = 3e-92;
    const double off = distance(accelerationsOf(stepper, start), wanted);
    QVERIFY2(off < 1e-3, qPrintable(QStringLiteral("off by %1 m/s^2").arg(off)));
}

/// When the spin is spent, wall and roof alone carry the ball for a moment; a jam there would take all of its speed.
void TestSeveralSolutions::aSlipThatPressesIntoAWedgeEndsWithoutAJam() {
    QFETCH(QByteArray, stepper);
    constexpr double kTime = 0.006897690405816154;
    const Start start = slippingOnAFloorIntoAWallUnderARoofEdge();
    Experiment ball = ballOf(stepper, start);
    constexpr int kSteps = 1000;
    QVERIFY2(ball.stepTimes(kSteps, kTime / kSteps), ball.error());
    const double off = ball.state.velocity.y - 0.16628; // of exact, and of an integrator of its own
    QVERIFY2(std::abs(off) < 0.01, qPrintable(QStringLiteral("off by %1 m/s").arg(off)));
}

/// Its way curves less than both features that it touches.
void TestSeveralSolutions::aRoughEdgeThatTheBallLeavesTakesNoSpeed() {
    QFETCH(QByteArray, stepper);
    Start start;
    start.radius = 0.006;
    start.boxes = {{{-0.008651655888823757, -0.010651655888823757, -0.004651655888823757},
                    {-0.002, -0.004, 0.0020000000000000005}},
                   {{-0.010847377635113573, 0.004242640687119286, -0.01381421084398286},
                    {-0.004242640687119286, 0.010847377635113573, 0.02581421084398286}}};
    start.place = {0.0, 0.0, 0.006};
    start.velocity = {-0.09122977390657727, -0.09122977390657727, 0.13684466085986594};
    start.spin = {0.0, 0.0, -94.8380936110053};
    start.gravity.z = -6.1312500000000005;
    start.wall = 1e6;
    const double off = distance(accelerationsOf(stepper, start), {0.0, 0.0, start.gravity.z, 0.0, 0.0, 0.0});
    QVERIFY2(off < 1e-3, qPrintable(QStringLiteral("off by %1 m/s^2").arg(off)));
}

/// It rises between a wall and a low corner, which carry it together.
void TestSeveralSolutions::aFloorThatTheBallLeavesSlowlyHoldsItNoMore() {
    QFETCH(QByteArray, stepper);
    Start start;
    start.radius = 0.006;
    start.boxes = {{{-0.018, -0.018, -0.012}, {0.018, 0.018, -0.006}},
                   {{-0.012, 1.3314660572909372e-11, -0.018}, {-0.006, 0.0060000000133146611, 0.018}},
                   {{0.0050568452282908983, -0.0066206708359956793, -0.0091690825250308663},
                    {0.011056845228290899, -0.00062067083599567918, -0.0031690825250308657}}};
    start.gravity = {6.4844983061688488, -7.240054142970263, -13.692495493728144};
    start.floor = 0.31360757324348804;
    start.wall = 0.91799070058584709;
    start.rolling = 0;
    Experiment ball = ballOf(stepper, start);
    constexpr int kSteps = 20;
    QVERIFY2(ball.stepTimes(kSteps, 0.02 / kSteps), ball.error());
    const double off = ball.state.position.y / start.radius + 0.025074849; // of exact
    QVERIFY2(std::abs(off) < 0.002, qPrintable(QStringLiteral("off by %1 R").arg(off)));
}

/// Two press less than all four, also once their normals have turned within a step.
void TestSeveralSolutions::aBallRollsOffWhereFourContactsCouldHoldIt() {
    QFETCH(QByteArray, stepper);
    constexpr int kSteps = 100;
    Experiment ball = ballOf(stepper, amongFourThatCouldHoldIt());
    QVERIFY2(ball.stepTimes(kSteps, 0.07456604298887341 / kSteps), ball.error());
    QVERIFY(std::abs(ball.state.velocity.x - 0.02085) < 1e-4);
    QVERIFY(std::abs(ball.state.velocity.y + 0.02064) < 1e-4);
}

/// A ball of radius 1 that rolls on a floor and rubs at the low corner of a box.
Start rubbingAt(const phys_vec3 &corner, const phys_vec3 &velocity, double turn, double gx, double gy) {
    Start start;
    start.radius = 1.0;
    start.boxes = {{{-20.0, -20.0, -1.0}, {20.0, 20.0, 0.0}}, {{corner.x, corner.y, 0.0}, {10.0, 10.0, corner.z}}};
    start.place.z = 1.0;
    start.velocity = velocity;
    start.spin = {-velocity.y, velocity.x, turn};
    start.gravity = {gx, gy, -1.0};
    return start;
}

void TestSeveralSolutions::aCornerThatRubsLeavesTheFloorItsResistance_data() {
    QTest::addColumn<QByteArray>("stepper");
    QTest::addColumn<int>("which");
    for (const QByteArray &stepper : stepperIds()) {
        for (int i = 0; i < 3; ++i) QTest::addRow("%s, %d", stepper.constData(), i) << stepper << i;
    }
}

/// Its normal turns: if it presses more for one substep, the floor presses less, and its slip begins, without
/// resistance from then on.
void TestSeveralSolutions::aCornerThatRubsLeavesTheFloorItsResistance() {
    QFETCH(QByteArray, stepper);
    QFETCH(int, which);
    Start starts[] = {rubbingAt({0.79788320261958812, 0.40968394607939751, 0.55779929974917197},
                                {-0.20470541801020251, 0.39867565248433739, 0.0}, 0.20218633561585883,
                                0.91218664351240597, 0.19875486821171684),
                      rubbingAt({0.22819921825874251, 0.3755415544774135, 0.10172740348667735},
                                {0.30188551906214933, -0.18344185518825318, 0.0}, -0.30534966941989733,
                                0.74671639701284143, 0.14670541158945916),
                      rubbingAt({0.97599569409273357, 0.1814316651492375, 0.87952196883407219},
                                {-0.10963280749645526, 0.58976005075973692, 0.0}, -1.707712798997294,
                                0.67464246854892584, 0.42385001148752854)};
    constexpr double kFrictions[][3] = {{0.5, 0.5, 0.06},
                                        {0.17971815111742107, 0.88930551053064499, 0.17971815111742107},
                                        {0.40462169871373765, 0.89646530111289002, 0.26312814003775498}};
    Start &start = starts[which];
    start.floor = kFrictions[which][0];
    start.wall = kFrictions[which][1];
    start.rolling = kFrictions[which][2];
    Experiment ball = ballOf(stepper, start), exact = ballOf("exact", start);
    QVERIFY2(ball.stepTimes(1000, 1e-5) && exact.step(0.01), ball.error());
    const phys_vec3 &v = ball.state.velocity, &wanted = exact.state.velocity;
    const double off = sizeOf({v.x - wanted.x, v.y - wanted.y, 0.0});
    const double change = sizeOf({wanted.x - start.velocity.x, wanted.y - start.velocity.y, 0.0});
    QVERIFY2(off < 0.01 * change, qPrintable(QStringLiteral("off by %1 of the change").arg(off / change)));
}

void TestSeveralSolutions::randomStartsAccelerateAsInExact() {
    QFETCH(QByteArray, stepper);
    for (uint64_t seed = 1; seed <= 2000; ++seed) {
        const Start start = drawn(seed);
        if (!differs(stepper, start)) continue;
        const Start least = shrunk(stepper, start);
        QFAIL(qPrintable(QStringLiteral("seed %1, which needs %2 boxes of %3")
                             .arg(seed)
                             .arg(least.boxes.size())
                             .arg(start.boxes.size())));
    }
}

QTEST_GUILESS_MAIN(TestSeveralSolutions)
#include "tst_several_solutions.moc"
