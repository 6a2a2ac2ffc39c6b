// SPDX-License-Identifier: MIT
// Every stepper converges, at its order, to the one motion that the law of contact determines: model.md 13. The scenes
// and values of reference_scenes.txt come from an independent computation in 113-bit arithmetic.
#include "support/experiment.h"
#include "support/stepper_rows.h"
#include "support/tolerance.h"
#include "support/vector_input.h"

#include <QtTest>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>

using support::Experiment;
using support::SceneBuilder;

namespace {

struct Gravity {
    double duration;
    phys_vec3 gravity;
};

struct SceneSample {
    double time;
    phys_vec3 position;
    bool rests;
};

struct ReferenceScene {
    QByteArray name;
    uint32_t model = PHYS_MODEL_ROLLING;
    bool isSmooth = false; ///< no impact, no stop by resistance: schemes of second order keep their order
    double radius = 0.0;
    std::vector<phys_box> boxes;
    phys_vec3 position{}, velocity{}, spin{};
    double restitutionWall = 0.0, restitutionFloor = 0.0;
    double rollingFriction = 0.0, slidingFriction = 0.0, wallFriction = 0.0;
    std::vector<Gravity> schedule;
    std::vector<SceneSample> samples;
};

void readScene(std::istream &in, std::vector<ReferenceScene> &scenes) {
    std::string name, model, kind;
    in >> name >> model >> kind;
    ReferenceScene &scene = scenes.emplace_back();
    scene.name = QByteArray::fromStdString(name);
    scene.model = model == "rigid" ? PHYS_MODEL_RIGID : PHYS_MODEL_ROLLING;
    scene.isSmooth = kind == "smooth";
}

/// Reads one line; the file's head explains the words. False if the line is invalid.
bool readLine(const std::string &line, std::vector<ReferenceScene> &scenes) {
    std::istringstream in(line);
    std::string word;
    if (!(in >> word) || word == "#") return true;
    if (word == "scene") {
        readScene(in, scenes);
        return bool(in);
    }
    if (scenes.empty()) return false;
    ReferenceScene &scene = scenes.back();
    if (word == "radius") {
        in >> scene.radius;
    } else if (word == "box") {
        phys_box &box = scene.boxes.emplace_back();
        in >> box.min >> box.max;
    } else if (word == "params") {
        in >> scene.restitutionWall >> scene.restitutionFloor >> scene.rollingFriction >> scene.slidingFriction >>
            scene.wallFriction;
    } else if (word == "start") {
        in >> scene.position >> scene.velocity >> scene.spin;
    } else if (word == "gravity") {
        Gravity &gravity = scene.schedule.emplace_back();
        in >> gravity.duration >> gravity.gravity;
    } else if (word == "sample") {
        SceneSample &sample = scene.samples.emplace_back();
        std::string end;
        in >> sample.time >> sample.position >> end;
        sample.rests = end == "rests";
    } else {
        return false;
    }
    return bool(in);
}

const std::vector<ReferenceScene> &referenceScenes() {
    static const std::vector<ReferenceScene> scenes = [] {
        std::vector<ReferenceScene> read;
        std::ifstream file(REFERENCE_SCENES);
        if (!file) qFatal("%s isn't there", REFERENCE_SCENES);
        for (std::string line; std::getline(file, line);) {
            if (!readLine(line, read)) qFatal("%s: can't read '%s'", REFERENCE_SCENES, line.c_str());
        }
        return read;
    }();
    return scenes;
}

/// The bound that a stepper promises for its error at the step size h.
struct Bound {
    double order;
    double factor; ///< m/s^order
};

/// An impact detected up to h too early costs up to (1 + eps) v_n h at each bounce, at speeds of up to 0.7 m/s in these
/// scenes; an impact at its true place costs the scheme's own g h^2.
Bound boundOf(const QByteArray &stepper, const ReferenceScene &scene) {
    const support::Promise promise = support::promiseOf(stepper);
    const int order = scene.isSmooth ? promise.lasting : promise.impacts;
    constexpr double kFactors[] = {1e-9, 4.0, 20.0};
    return {static_cast<double>(order), kFactors[order]};
}

double largestDifference(const phys_vec3 &a, const phys_vec3 &b) {
    return std::max({std::abs(a.x - b.x), std::abs(a.y - b.y), std::abs(a.z - b.z)});
}

/// Runs a scene at about the step size h. Returns the largest position error at any sample, m; NaN if a step failed.
class SceneRun {
public:
    SceneRun(const ReferenceScene &scene, const QByteArray &stepper)
        : m_scene(scene)
        , m_ball(builder(scene), stepper, scene.model) {
        m_ball.params.restitution_wall = scene.restitutionWall;
        m_ball.params.restitution_floor = scene.restitutionFloor;
        m_ball.params.rolling_friction = scene.rollingFriction;
        m_ball.params.sliding_friction = scene.slidingFriction;
        m_ball.params.wall_friction = scene.wallFriction;
        m_ball.state.position = scene.position;
        m_ball.state.velocity = scene.velocity;
        m_ball.state.spin = scene.spin;
    }

    const char *problem() const { return m_ball.error(); }
    bool restsAsItShould() const { return m_restsAsItShould; }

    double error(double h) {
        double worst = 0.0;
        double segmentEnd = 0.0;
        size_t next = 0;
        for (const Gravity &segment : m_scene.schedule) {
            m_ball.params.gravity = segment.gravity;
            segmentEnd += segment.duration;
            for (; next < m_scene.samples.size() && m_scene.samples[next].time <= segmentEnd + kSameTime; ++next) {
                const SceneSample &sample = m_scene.samples[next];
                if (!stepTo(sample.time, h)) return NAN;
                worst = std::max(worst, largestDifference(m_ball.state.position, sample.position));
                const bool rests = m_ball.state.flags & PHYS_AT_REST;
                m_restsAsItShould = rests == sample.rests;
            }
            if (!stepTo(segmentEnd, h)) return NAN;
        }
        return worst;
    }

private:
    static constexpr double kSameTime = 1e-9;

    static SceneBuilder builder(const ReferenceScene &scene) {
        SceneBuilder builder;
        builder.ball(scene.radius).start(scene.position);
        for (const phys_box &box : scene.boxes) builder.box(box);
        return builder;
    }

    bool stepTo(double time, double h) {
        const double way = time - m_time;
        if (way <= kSameTime) return true;
        const auto count = static_cast<uint64_t>(std::max(1.0, std::round(way / h)));
        m_time = time;
        return m_ball.stepTimes(count, way / static_cast<double>(count));
    }

    const ReferenceScene &m_scene;
    Experiment m_ball;
    double m_time = 0.0;
    bool m_restsAsItShould = true; ///< at the last sample
};

} // namespace

class TestReferenceScenes : public QObject {
    Q_OBJECT

private slots:
    void convergesToTheLaw_data();
    void convergesToTheLaw();
    void sweptCrossesACrackInLongSteps();
};

void TestReferenceScenes::convergesToTheLaw_data() {
    QTest::addColumn<int>("number");
    QTest::addColumn<QByteArray>("stepper");
    for (const QByteArray &stepper : support::stepperIds()) {
        for (size_t i = 0; i < referenceScenes().size(); ++i) {
            QTest::addRow("%s, %s", stepper.constData(), referenceScenes()[i].name.constData())
                << static_cast<int>(i) << stepper;
        }
    }
}

void TestReferenceScenes::convergesToTheLaw() {
    QFETCH(int, number);
    QFETCH(QByteArray, stepper);
    const ReferenceScene &scene = referenceScenes()[static_cast<size_t>(number)];
    const Bound promise = boundOf(stepper, scene);
    for (const double h : {1e-3, 5e-4, 2.5e-4}) {
        SceneRun run(scene, stepper);
        const double error = run.error(h);
        QVERIFY2(!std::isnan(error), run.problem());
        const double allowed = promise.factor * std::pow(h, promise.order);
        QVERIFY2(error <= allowed, (scene.name + ": " + QByteArray::number(error) + " m at " + QByteArray::number(h) +
                                    " s, allowed " + QByteArray::number(allowed))
                                       .constData());
        QVERIFY2(run.restsAsItShould(), scene.name.constData());
    }
}

/// In such a step the second edge is approached more slowly than a bounce requires, so the ball stops there.
void TestReferenceScenes::sweptCrossesACrackInLongSteps() {
    const auto scene = std::find_if(referenceScenes().begin(), referenceScenes().end(),
                                    [](const ReferenceScene &s) { return s.name == "crack_1mm_rolling"; });
    QVERIFY(scene != referenceScenes().end());
    SceneRun run(*scene, "swept");
    const double error = run.error(0.01);
    QVERIFY2(error <= 1e-14, QByteArray::number(error).constData());
}

QTEST_GUILESS_MAIN(TestReferenceScenes)
#include "tst_reference_scenes.moc"
