// SPDX-License-Identifier: MIT
// Lasting contacts, pivots, rests, falls, tiles and infinitely many bounces compared with results of 50-digit
// arithmetic, which references/references.py writes to references.txt with an independent program.
#include "run.h"

#include <QtTest>

#include <fstream>
#include <limits>
#include <sstream>

using exact::equal;
using exact::kU;
using exact::Run;
using exact::Turn;

namespace {

struct Impact {
    uint32_t kind, box;
    double time, before, after;
};

struct Step {
    phys_vec3 gravity;
    double dt;
    std::vector<Impact> impacts; ///< without the weakest ones
    double state[6];             ///< position, velocity
    uint64_t flags;
    double sensitivity;
};

struct KnownScene {
    std::string name;
    std::vector<phys_box> boxes;
    double radius = 0.0;
    double restitutionWall = 0.0, restitutionFloor = 0.0, rollingFriction = 0.0;
    phys_vec3 position{}, velocity{};
    std::vector<Step> steps;
};

/// Weaker impacts (m/s) aren't listed, because those that end infinitely many bounces differ (model.md 6.4).
constexpr double kWeakest = 1e-5;

bool readEvent(std::istream &in, Step &step) {
    std::string kind;
    int box = 0;
    Impact impact{};
    in >> kind >> box >> impact.time >> impact.before >> impact.after;
    impact.kind = kind == "landing" ? PHYS_EVENT_LANDING : PHYS_EVENT_IMPACT;
    impact.box = static_cast<uint32_t>(box);
    if (kind == "impact" || kind == "landing") step.impacts.push_back(impact);
    return bool(in);
}

/// Reads one line of references.txt, whose head explains the words. False if the line is invalid.
bool readKnownLine(const std::string &line, std::vector<KnownScene> &scenes) {
    std::istringstream in(line);
    std::string word;
    if (!(in >> word) || word == "#") return true;
    if (word == "scene") {
        scenes.emplace_back();
        return bool(std::getline(in >> std::ws, scenes.back().name));
    }
    if (scenes.empty()) return false;
    KnownScene &scene = scenes.back();
    if (word == "radius") return bool(in >> scene.radius);
    if (word == "params") return bool(in >> scene.restitutionWall >> scene.restitutionFloor >> scene.rollingFriction);
    if (word == "ball") return bool(in >> scene.position >> scene.velocity);
    if (word == "box") {
        scene.boxes.emplace_back();
        return bool(in >> scene.boxes.back().min >> scene.boxes.back().max);
    }
    if (word == "step") {
        scene.steps.emplace_back();
        return bool(in >> scene.steps.back().gravity >> scene.steps.back().dt);
    }
    if (scene.steps.empty()) return false;
    Step &step = scene.steps.back();
    if (word == "event") return readEvent(in, step);
    for (double &value : step.state) in >> value;
    return word == "state" && in >> step.flags >> step.sensitivity;
}

const std::vector<KnownScene> &knownScenes() {
    static const std::vector<KnownScene> all = [] {
        std::vector<KnownScene> read;
        std::ifstream file(EXACT_REFERENCES);
        for (std::string line; std::getline(file, line);) {
            if (!readKnownLine(line, read)) throw std::runtime_error("references.txt: not understood: " + line);
        }
        if (read.empty()) throw std::runtime_error("can't read " EXACT_REFERENCES);
        return read;
    }();
    return all;
}

/// The ball of a scene before its first step.
struct KnownStart : Run {
    explicit KnownStart(const KnownScene &scene)
        : Run(scene.boxes, scene.radius, scene.position, scene.velocity) {
        params.restitution_wall = scene.restitutionWall;
        params.restitution_floor = scene.restitutionFloor;
        params.rolling_friction = scene.rollingFriction;
    }
};

double error(const phys_state &state, const Step &step) {
    const phys_vec3 &p = state.position, &v = state.velocity;
    const double got[] = {p.x, p.y, p.z, v.x, v.y, v.z};
    double most = 0.0;
    for (int i = 0; i < 6; ++i) most = std::max(most, std::abs(got[i] - step.state[i]));
    return most;
}

/// model.md 8: rounding of a coordinate, amplified by the motion so far. The boards are some metres large.
double bound(const Step &step, size_t events) { return 2.0 * kU * (1.0 + step.sensitivity) * double(events + 1); }

KnownScene turned(KnownScene scene, const Turn &turn) {
    for (phys_box &box : scene.boxes) box = exact::turned(box, turn);
    scene.position = turn(scene.position);
    scene.velocity = turn(scene.velocity);
    for (Step &step : scene.steps) step.gravity = turn(step.gravity);
    return scene;
}

QString told(const KnownScene &scene, size_t step, double error, double bound) {
    return QString("%1, step %2: %3, allowed %4").arg(scene.name.c_str()).arg(step).arg(error).arg(bound);
}

} // namespace

class ExactReferences : public QObject {
    Q_OBJECT
private slots:
    void followsTheReference_data() { addScenes(); }
    void followsTheReference();
    void meetsTheSameWalls_data() { addScenes(); }
    void meetsTheSameWalls();
    void isTheSameInManySteps_data() { addScenes(); }
    void isTheSameInManySteps();
    void turnedSceneTurnsTheWay_data() { addScenes(); }
    void turnedSceneTurnsTheWay();

private:
    void addScenes() {
        QTest::addColumn<int>("number");
        for (size_t i = 0; i < knownScenes().size(); ++i) QTest::newRow(knownScenes()[i].name.c_str()) << int(i);
    }
    static const KnownScene &chosen() {
        QFETCH(int, number);
        return knownScenes()[size_t(number)];
    }
};

void ExactReferences::followsTheReference() {
    const KnownScene &scene = chosen();
    KnownStart run(scene);
    size_t events = 0, number = 0;
    for (const Step &step : scene.steps) {
        run.params.gravity = step.gravity;
        run.step(step.dt);
        events += run.events.size();
        const double off = error(run.state, step), allowed = bound(step, events);
        QVERIFY2(off <= allowed, qPrintable(told(scene, ++number, off, allowed)));
        QCOMPARE(run.state.flags, step.flags);
    }
}

/// The reference takes the impacts of one moment one after the other, the stepper takes them together: for each box
/// only the first is compared, and its speed afterwards only if it is the only impact.
std::vector<Impact> firstOfEachBox(const std::vector<Impact> &impacts) {
    std::vector<Impact> first;
    for (const Impact &impact : impacts) {
        bool isKnown = false;
        for (Impact &other : first) {
            if (other.time != impact.time) continue;
            other.after = std::numeric_limits<double>::quiet_NaN();
            isKnown = isKnown || other.box == impact.box;
        }
        if (isKnown) continue;
        first.push_back(impact);
        const bool isAlone = first.size() < 2 || first[first.size() - 2].time != impact.time;
        if (!isAlone) first.back().after = std::numeric_limits<double>::quiet_NaN();
    }
    return first;
}

void ExactReferences::meetsTheSameWalls() {
    const KnownScene &scene = chosen();
    KnownStart run(scene);
    size_t events = 0;
    for (const Step &step : scene.steps) {
        run.params.gravity = step.gravity;
        run.step(step.dt);
        std::vector<phys_event> met;
        for (const phys_event &event : run.events) {
            const bool counts = event.kind == PHYS_EVENT_IMPACT || event.kind == PHYS_EVENT_LANDING;
            if (counts && std::abs(event.speed_before) >= kWeakest) met.push_back(event);
        }
        const std::vector<Impact> impacts = firstOfEachBox(step.impacts);
        QCOMPARE(met.size(), impacts.size());
        events += run.events.size();
        for (size_t i = 0; i < met.size(); ++i) {
            const Impact &impact = impacts[i];
            QCOMPARE(met[i].kind, impact.kind);
            if (impact.kind == PHYS_EVENT_IMPACT && !std::isnan(impact.after)) QCOMPARE(met[i].box, impact.box);
            // Only the position is known to rounding: the weaker an impact, the less accurate are its time and speed.
            const double weight = std::min(1.0, std::abs(impact.before)), allowed = bound(step, events);
            QVERIFY(weight * std::abs(met[i].time - impact.time) <= allowed);
            if (std::isnan(impact.after)) continue;
            QVERIFY(weight * std::abs(met[i].speed_before - impact.before) <= allowed);
            QVERIFY(weight * std::abs(met[i].speed_after - impact.after) <= allowed);
        }
    }
}

/// Each phase that is begun anew starts from a position and a velocity rounded by half a unit.
void ExactReferences::isTheSameInManySteps() {
    const KnownScene &scene = chosen();
    KnownStart run(scene);
    size_t events = 0, number = 0;
    for (const Step &step : scene.steps) {
        const int parts = std::max(1, int(std::ceil(step.dt * 256.0)));
        run.params.gravity = step.gravity;
        for (int part = 0; part < parts; ++part) {
            run.step(step.dt / parts);
            events += run.events.size();
        }
        const double off = error(run.state, step);
        // model.md 8: 4 times the 10 u (1 + sensitivity) per event that are allowed in one step.
        const double allowed = 40.0 * kU * (1.0 + step.sensitivity) * double(events + 1);
        QVERIFY2(off <= allowed, qPrintable(told(scene, ++number, off, allowed)));
        QCOMPARE(run.state.flags, step.flags);
    }
}

/// model.md 9: swapping the axes and reversing one of them changes no bit.
void ExactReferences::turnedSceneTurnsTheWay() {
    const KnownScene &scene = chosen();
    const auto swapped = [](const phys_vec3 &v) { return phys_vec3{v.y, v.x, v.z}; };
    const auto mirrored = [](const phys_vec3 &v) { return phys_vec3{-v.x, v.y, v.z}; };
    const Turn turns[] = {swapped, mirrored, [&](const phys_vec3 &v) { return mirrored(swapped(v)); }};
    for (const Turn &turn : turns) {
        KnownStart run(scene);
        const KnownScene other = turned(scene, turn);
        KnownStart otherRun(other);
        for (size_t i = 0; i < scene.steps.size(); ++i) {
            run.params.gravity = scene.steps[i].gravity;
            run.step(scene.steps[i].dt);
            otherRun.params.gravity = other.steps[i].gravity;
            otherRun.step(other.steps[i].dt);
            QVERIFY(equal(otherRun.state.position, turn(run.state.position)));
            QVERIFY(equal(otherRun.state.velocity, turn(run.state.velocity)));
            QCOMPARE(otherRun.state.flags, run.state.flags);
        }
    }
}

QTEST_GUILESS_MAIN(ExactReferences)
#include "tst_exact_references.moc"
