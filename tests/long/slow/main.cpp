// SPDX-License-Identifier: MIT
// Searches for the slowest call of a stepper: random scenes and the levels, steps of up to hours. The slowest ones
// found are mutated, and kept if they become slower. Usage: slow STEPPER SECONDS SEED MOST_MS LEVEL...     Exits with 1
// if a call took more than MOST_MS of CPU time.
#include "bench/support/cpu_clock.h"
#include "witness/draw.h"

#include "support/handles.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <random>

namespace {

using witness::Case;

class Random {
public:
    explicit Random(uint64_t seed)
        : m_engine(seed) {}

    uint64_t bits() { return m_engine(); }
    uint32_t below(uint32_t count) { return static_cast<uint32_t>(bits() % count); }
    double between(double low, double high) {
        return low + (high - low) * (static_cast<double>(bits() >> 11U) * 0x1p-53);
    }

private:
    std::mt19937_64 m_engine;
};

constexpr size_t kKept = 40;
constexpr double kGravity = 9.81;

struct Finding {
    Case scene;
    double seconds = 0.0; ///< of its slowest call
    phys_status status = PHYS_OK;
};

double magnitude(Random &random, double low, double high) {
    return low * std::pow(high / low, random.between(0.0, 1.0));
}

/// Runs all steps of a scene, or until one fails.
Finding timed(const char *id, const Case &scene) {
    Finding finding{scene};
    const phys_scene_desc desc = witness::descOf(scene.boxes, scene.radius, scene.start.position);
    phys_scene *made = nullptr;
    phys_scene_create(&desc, &made, nullptr);
    const support::ScenePtr kept(made);
    phys_stepper *stepper = nullptr;
    if (!made || phys_stepper_create(nullptr, id, made, &stepper, nullptr)) return finding;
    const support::StepperPtr keptStepper(stepper);
    phys_state ball = scene.start;
    phys_params params = scene.params;
    for (const witness::Leg &leg : scene.legs) {
        params.gravity = leg.gravity;
        for (uint32_t step = 0; step < leg.steps && !finding.status; ++step) {
            phys_status status = PHYS_OK;
            const double seconds =
                bench::cpuTimeOf([&] { status = phys_step(stepper, &params, leg.dt, &ball, &ball, nullptr, nullptr); });
            if (seconds > finding.seconds) finding.seconds = seconds;
            finding.status = status;
        }
    }
    return finding;
}

void sortByTime(std::vector<Finding> &findings) {
    std::sort(findings.begin(), findings.end(),
              [](const Finding &a, const Finding &b) { return a.seconds > b.seconds; });
}

/// Takes the shortest of several measurements, as other programs disturb single ones.
void timeAgain(const char *stepper, std::vector<Finding> &findings) {
    for (Finding &finding : findings) {
        for (int repetition = 0; repetition < 3; ++repetition) {
            finding.seconds = std::min(finding.seconds, timed(stepper, finding.scene).seconds);
        }
    }
    sortByTime(findings);
}

Case levelAt(const char *path, Random &random) {
    phys_scene *scene = nullptr;
    phys_error error{};
    if (phys_scene_load(path, &scene, &error)) {
        std::fprintf(stderr, "slow: %s\n", error.text);
        std::exit(2);
    }
    const support::ScenePtr kept(scene);
    Case level = witness::emptyCase();
    level.name = path;
    level.boxes.assign(phys_scene_boxes(scene), phys_scene_boxes(scene) + phys_scene_box_count(scene));
    level.radius = phys_scene_radius(scene);
    phys_scene_start(scene, &level.start);
    phys_params_init(&level.params, sizeof level.params);
    level.params.model = random.below(2);
    for (int leg = 0; leg < 5; ++leg) {
        const phys_vec3 gravity{random.between(-2.0, 2.0), random.between(-2.0, 2.0), -kGravity};
        level.legs.push_back({gravity, magnitude(random, 0.1, 10.0), 1});
    }
    return level;
}

void change(Random &random, double &number, double unit) {
    switch (random.below(4)) {
    case 0:
        number *= random.between(0.5, 2.0);
        break;
    case 1:
        number += unit * random.between(-0.1, 0.1);
        break;
    case 2:
        number += unit * magnitude(random, 1e-9, 1.0) * (random.below(2) ? 1.0 : -1.0);
        break;
    default:
        number = unit * random.between(-3.0, 3.0);
    }
}

/// Anything, or so near to 1 that bounces hardly end.
double restitution(Random &random) {
    return random.below(2) ? random.between(0.0, 1.0) : 1.0 - magnitude(random, 1e-15, 0.1);
}

/// A usual one, or one of the range's ends.
double friction(Random &random) {
    switch (random.below(4)) {
    case 0:
        return 0.0;
    case 1:
        return magnitude(random, 10.0, 1e6);
    default:
        return magnitude(random, 0.01, 10.0);
    }
}

/// Up to the largest that the library accepts, from the same side.
void changeAllGravity(Random &random, Case &scene) {
    constexpr double kLargest = 1e6;
    const double factor = magnitude(random, 0.01, 100.0);
    for (witness::Leg &leg : scene.legs) {
        for (double *g : {&leg.gravity.x, &leg.gravity.y, &leg.gravity.z}) {
            *g = std::clamp(*g * factor, -kLargest, kLargest);
        }
    }
}

double &component(Random &random, phys_vec3 &v) { return (&v.x)[random.below(3)]; }

Case changed(Random &random, Case scene) {
    const double R = scene.radius, speed = std::sqrt(kGravity * R);
    witness::Leg &leg = scene.legs[random.below(static_cast<uint32_t>(scene.legs.size()))];
    phys_params &params = scene.params;
    switch (random.below(9)) {
    case 0:
        change(random, component(random, scene.start.position), R);
        break;
    case 1:
        change(random, component(random, scene.start.velocity), speed);
        break;
    case 2:
        change(random, component(random, scene.start.spin), speed / R);
        break;
    case 3:
        change(random, component(random, leg.gravity), kGravity);
        break;
    case 4:
        leg.dt = magnitude(random, 1e-4, 1e4);
        break;
    case 5:
        (random.below(2) ? params.restitution_wall : params.restitution_floor) = restitution(random);
        break;
    case 6:
        (random.below(2) ? params.sliding_friction : params.wall_friction) = friction(random);
        break;
    case 7:
        changeAllGravity(random, scene);
        break;
    default: {
        phys_box &box = scene.boxes[random.below(static_cast<uint32_t>(scene.boxes.size()))];
        const uint32_t axis = random.below(3);
        double &low = (&box.min.x)[axis], &high = (&box.max.x)[axis];
        change(random, random.below(2) ? low : high, R);
        if (low > high) std::swap(low, high);
    }
    }
    if (params.model == PHYS_MODEL_RIGID) {
        params.rolling_friction = std::min(params.rolling_friction, params.sliding_friction);
    }
    return scene;
}

} // namespace

int main(int count, char **arguments) {
    if (count < 5) {
        std::fprintf(stderr, "usage: slow STEPPER SECONDS SEED MOST_MS LEVEL...\n");
        return 2;
    }
    const char *stepper = arguments[1];
    const std::chrono::duration<double> seconds(std::strtod(arguments[2], nullptr));
    Random random(std::strtoull(arguments[3], nullptr, 10));
    const double most = std::strtod(arguments[4], nullptr);
    const auto levels = static_cast<uint32_t>(count - 5), kinds = static_cast<uint32_t>(witness::kinds().size());
    std::vector<Finding> slowest;
    const auto end = std::chrono::steady_clock::now() + seconds;
    uint64_t runs = 0;
    for (; std::chrono::steady_clock::now() < end; ++runs) {
        const uint32_t kind = random.below(kinds + levels);
        const bool isNew = slowest.size() < kKept || random.below(2) == 0;
        const Case scene = !isNew ? changed(random, slowest[random.below(static_cast<uint32_t>(slowest.size()))].scene)
                           : kind < kinds ? witness::drawCase(kind, random.bits() >> 20U, random.below(2))
                                          : levelAt(arguments[5 + kind - kinds], random);
        slowest.push_back(timed(stepper, scene));
        sortByTime(slowest);
        if (slowest.size() > kKept) slowest.pop_back();
    }
    timeAgain(stepper, slowest);
    if (slowest.empty()) return 0;
    const Finding &worst = slowest.front();
    std::printf("%llu scenes; slowest call of %s: %.1f ms, %s, in a scene from %s\n",
                static_cast<unsigned long long>(runs), stepper, 1e3 * worst.seconds, phys_status_name(worst.status),
                worst.scene.name.c_str());
    if (1e3 * worst.seconds <= most) return 0;
    std::printf("%s", witness::textOf(worst.scene).c_str());
    return 1;
}
