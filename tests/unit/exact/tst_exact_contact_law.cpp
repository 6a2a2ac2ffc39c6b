// SPDX-License-Identifier: MIT
// The law of contact beyond the walls of mazes: friction at several contacts, edges and corners, kerbs, notches,
// cracks, pits, tops of walls, the board's edge. 32 motions to 25 digits (tests/witness/references.cases; its README
// describes how they were computed), in whole steps, in parts, reflected, rotated, scaled and with the boxes in another
// order.
#include "run.h"

#include <QtTest>

#include <fstream>
#include <functional>
#include <sstream>

using exact::equal;
using exact::kU;
using exact::Run;

namespace {

struct LawSample {
    double time, state[9]; ///< position, velocity, spin
    bool isAtRest;
};

struct Tilting {
    double duration;
    phys_vec3 gravity;
};

struct Case {
    std::string name;
    bool isRigid = false;
    double radius = 0.0;
    phys_params params{};
    std::vector<phys_box> boxes;
    phys_vec3 position{}, velocity{}, spin{};
    std::vector<Tilting> turns;
    std::vector<LawSample> samples;
};

void readLine(const std::string &line, std::vector<Case> &cases) {
    std::istringstream in(line);
    std::string word;
    if (!(in >> word) || word[0] == '#') return;
    if (word == "case") {
        cases.emplace_back();
        phys_params_init(&cases.back().params, sizeof(phys_params));
        in >> cases.back().name;
        return;
    }
    Case &last = cases.back();
    const std::pair<const char *, double *> numbers[] = {
        {"radius", &last.radius},
        {"rolling_friction", &last.params.rolling_friction},
        {"sliding_friction", &last.params.sliding_friction},
        {"wall_friction", &last.params.wall_friction},
        {"restitution_floor", &last.params.restitution_floor},
        {"restitution_wall", &last.params.restitution_wall},
    };
    for (const auto &[name, number] : numbers) {
        if (word == name) in >> *number;
    }
    if (word == "model") last.isRigid = in >> word && word == "rigid";
    if (word == "position") in >> last.position;
    if (word == "velocity") in >> last.velocity;
    if (word == "spin") in >> last.spin;
    if (word == "box") in >> last.boxes.emplace_back().min >> last.boxes.back().max;
    if (word == "steps") {
        double count = 0.0, length = 0.0;
        in >> count >> length;
        in >> last.turns.emplace_back(Tilting{count * length, {}}).gravity;
    }
    if (word == "sample") {
        LawSample &sample = last.samples.emplace_back();
        in >> sample.time;
        for (double &value : sample.state) in >> value;
        in >> sample.isAtRest;
    }
    if (!in) throw std::runtime_error("not understood: " + line);
}

const std::vector<Case> &cases() {
    static const std::vector<Case> all = [] {
        std::vector<Case> read;
        std::ifstream file(LAW_REFERENCES);
        for (std::string line; std::getline(file, line);) readLine(line, read);
        if (read.empty()) throw std::runtime_error("can't read " LAW_REFERENCES);
        return read;
    }();
    return all;
}

struct CaseRun : Run {
    explicit CaseRun(const Case &of)
        : Run(of.boxes, of.radius, of.position, of.velocity) {
        const uint32_t model = of.isRigid ? PHYS_MODEL_RIGID : PHYS_MODEL_ROLLING;
        params = of.params;
        params.model = model;
        state.spin = of.spin;
    }
};

/// Calls arrived(sample) with the ball at each sample's time, in steps no longer than `longest`.
void follow(const Case &of, CaseRun &run, double longest, const std::function<void(const LawSample &)> &arrived) {
    size_t next = 0;
    double time = 0.0, turned = 0.0;
    for (const Tilting &turn : of.turns) {
        run.params.gravity = turn.gravity;
        const double end = turned + turn.duration;
        while (next < of.samples.size() && of.samples[next].time <= end * (1.0 + 1e-12)) {
            const LawSample &sample = of.samples[next++];
            const int parts = std::max(1, int(std::ceil((sample.time - time) / longest)));
            for (int part = 0; part < parts; ++part) run.step((sample.time - time) / parts);
            time = sample.time;
            arrived(sample);
        }
        turned = end;
    }
}

double error(const phys_state &state, const LawSample &sample, double radius) {
    const phys_vec3 &p = state.position, &v = state.velocity, &w = state.spin;
    const double got[] = {p.x, p.y, p.z, v.x, v.y, v.z, w.x, w.y, w.z};
    double most = 0.0;
    for (int i = 0; i < 9; ++i) most = std::max(most, (i < 6 ? 1.0 : radius) * std::abs(got[i] - sample.state[i]));
    return most;
}

/// Where a bounce or a slip ends, its remainder is cut off: model.md 6.4 and 8.3. Elsewhere the only error is rounding.
double allowed(const Case &of) {
    const bool isCut =
        of.name == "landing_zeno_rolling" || of.name == "edge_of_board_rough" || of.name == "corner_cone";
    return isCut ? 1e-12 : 2e-14;
}

using Image = std::function<phys_vec3(const phys_vec3 &, bool isSpin)>;

phys_vec3 mirrored(const phys_vec3 &v, bool isSpin) {
    return isSpin ? phys_vec3{v.x, -v.y, -v.z} : phys_vec3{-v.x, v.y, v.z};
}
phys_vec3 swapped(const phys_vec3 &v, bool isSpin) {
    return isSpin ? phys_vec3{-v.y, -v.x, -v.z} : phys_vec3{v.y, v.x, v.z};
}

Case imageOf(Case of, const Image &image) {
    for (phys_box &box : of.boxes) {
        const phys_vec3 a = image(box.min, false), b = image(box.max, false);
        box = {{std::min(a.x, b.x), std::min(a.y, b.y), a.z}, {std::max(a.x, b.x), std::max(a.y, b.y), b.z}};
    }
    of.position = image(of.position, false);
    of.velocity = image(of.velocity, false);
    of.spin = image(of.spin, true);
    for (Tilting &turn : of.turns) turn.gravity = image(turn.gravity, false);
    return of;
}

std::vector<phys_state> statesOf(const Case &of) {
    std::vector<phys_state> states;
    CaseRun run(of);
    follow(of, run, 1.0, [&](const LawSample &) { states.push_back(run.state); });
    return states;
}

phys_vec3 times(double factor, const phys_vec3 &v) { return {factor * v.x, factor * v.y, factor * v.z}; }

} // namespace

class ExactContactLaw : public QObject {
    Q_OBJECT
private slots:
    void followsTheReference_data() { addCases(); }
    void followsTheReference();
    void isTheSameInPieces_data() { addCases(); }
    void isTheSameInPieces();
    void imagesGiveImagesToTheBit_data() { addCases(); }
    void imagesGiveImagesToTheBit();
    void shuffledBoxesChangeNoBit_data() { addCases(); }
    void shuffledBoxesChangeNoBit();
    void fourTimesAsLargeIsTheSameToTheBit_data() { addCases(); }
    void fourTimesAsLargeIsTheSameToTheBit();

private:
    void addCases() {
        QTest::addColumn<int>("number");
        for (size_t i = 0; i < cases().size(); ++i) QTest::newRow(cases()[i].name.c_str()) << int(i);
    }
    static const Case &chosen() {
        QFETCH(int, number);
        return cases()[size_t(number)];
    }
};

void ExactContactLaw::followsTheReference() {
    const Case &of = chosen();
    CaseRun run(of);
    follow(of, run, 10.0, [&](const LawSample &sample) {
        QVERIFY2(error(run.state, sample, of.radius) <= allowed(of),
                 qPrintable(QString("off by %1 at %2 s").arg(error(run.state, sample, of.radius)).arg(sample.time)));
        QCOMPARE(bool(run.state.flags & PHYS_AT_REST), sample.isAtRest);
    });
}

void ExactContactLaw::isTheSameInPieces() {
    const Case &of = chosen();
    CaseRun run(of);
    follow(of, run, 1.0 / 256.0, [&](const LawSample &sample) {
        QVERIFY2(error(run.state, sample, of.radius) <= 4.0 * allowed(of),
                 qPrintable(QString("off by %1 at %2 s").arg(error(run.state, sample, of.radius)).arg(sample.time)));
        QCOMPARE(bool(run.state.flags & PHYS_AT_REST), sample.isAtRest);
    });
}

void ExactContactLaw::imagesGiveImagesToTheBit() {
    const Case &of = chosen();
    const std::vector<phys_state> states = statesOf(of);
    const Image turned = [](const phys_vec3 &v, bool isSpin) { return mirrored(swapped(v, isSpin), isSpin); };
    for (const Image &image : {Image(mirrored), Image(swapped), turned}) {
        const std::vector<phys_state> images = statesOf(imageOf(of, image));
        for (size_t i = 0; i < states.size(); ++i) {
            QVERIFY(equal(images[i].position, image(states[i].position, false)));
            QVERIFY(equal(images[i].velocity, image(states[i].velocity, false)));
            QVERIFY(equal(images[i].spin, image(states[i].spin, true)));
            QCOMPARE(images[i].flags, states[i].flags);
        }
    }
}

void ExactContactLaw::shuffledBoxesChangeNoBit() {
    Case other = chosen();
    std::reverse(other.boxes.begin(), other.boxes.end());
    const std::vector<phys_state> states = statesOf(chosen()), shuffled = statesOf(other);
    for (size_t i = 0; i < states.size(); ++i) {
        QVERIFY(equal(shuffled[i].position, states[i].position));
        QVERIFY(equal(shuffled[i].velocity, states[i].velocity));
        QVERIFY(equal(shuffled[i].spin, states[i].spin));
    }
}

/// model.md 9: lengths times 4, times and speeds times 2, spins by half, gravity as it is.
void ExactContactLaw::fourTimesAsLargeIsTheSameToTheBit() {
    Case large = chosen();
    large.radius *= 4.0;
    for (phys_box &box : large.boxes) box = {times(4.0, box.min), times(4.0, box.max)};
    large.position = times(4.0, large.position);
    large.velocity = times(2.0, large.velocity);
    large.spin = times(0.5, large.spin);
    for (Tilting &turn : large.turns) turn.duration *= 2.0;
    for (LawSample &sample : large.samples) sample.time *= 2.0;
    CaseRun run(chosen()), largeRun(large);
    std::vector<phys_state> states, largeStates;
    follow(chosen(), run, 10.0, [&](const LawSample &) { states.push_back(run.state); });
    follow(large, largeRun, 20.0, [&](const LawSample &) { largeStates.push_back(largeRun.state); });
    for (size_t i = 0; i < states.size(); ++i) {
        QVERIFY(equal(largeStates[i].position, times(4.0, states[i].position)));
        QVERIFY(equal(largeStates[i].velocity, times(2.0, states[i].velocity)));
        QVERIFY(equal(largeStates[i].spin, times(0.5, states[i].spin)));
    }
}

QTEST_GUILESS_MAIN(ExactContactLaw)
#include "tst_exact_contact_law.moc"
