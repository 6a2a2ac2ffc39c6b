// SPDX-License-Identifier: MIT
#include "judge.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <functional>

namespace witness {

namespace {

constexpr int kMostTrials = 250;

/// Tries simplifications of a case and keeps those for which it still fails the same check.
class Shrinker {
public:
    Shrinker(const phys_registry *registry, const std::string &stepper, const Case &scene, const Verdict &verdict)
        : m_registry(registry)
        , m_stepper(stepper)
        , m_best(scene)
        , m_verdict(verdict) {
        m_best.check = verdict.check;
        m_best.stepper = stepper;
    }

    Case run() {
        for (bool isBetter = true; isBetter && m_trials < kMostTrials;) {
            isBetter = dropLegs();
            isBetter = dropBoxes() || isBetter;
            isBetter = simplifyNumbers() || isBetter;
        }
        m_best.note = m_verdict.check + ": " + m_verdict.what;
        return m_best;
    }

private:
    /// A box without volume would be another fault's scene.
    static bool isSolid(const phys_box &box) {
        return box.min.x < box.max.x && box.min.y < box.max.y && box.min.z < box.max.z;
    }

    bool keeps(const Case &candidate) {
        if (!std::all_of(candidate.boxes.begin(), candidate.boxes.end(), isSolid)) return false;
        if (++m_trials > kMostTrials) return false;
        const Verdict verdict = judge(m_registry, m_stepper, candidate);
        if (verdict.check != m_verdict.check) return false;
        m_best = candidate;
        m_verdict = verdict;
        return true;
    }
    bool keepsChanged(const std::function<void(Case &)> &change) {
        Case candidate = m_best;
        change(candidate);
        return textOf(candidate) != textOf(m_best) && keeps(candidate);
    }

    bool dropLegs() {
        bool isBetter = false;
        for (size_t i = m_best.legs.size(); i-- > 0;) {
            if (m_best.legs.size() > 1)
                isBetter = keepsChanged([&](Case &c) { c.legs.erase(c.legs.begin() + std::ptrdiff_t(i)); }) || isBetter;
        }
        for (size_t i = 0; i < m_best.legs.size(); ++i) {
            const bool isLaw = m_best.check == "law";
            while (!isLaw && m_best.legs[i].steps > 1 && keepsChanged([&](Case &c) { c.legs[i].steps /= 2; }))
                isBetter = true;
            while (!isLaw && m_best.legs[i].steps > 1 && keepsChanged([&](Case &c) { --c.legs[i].steps; }))
                isBetter = true;
            while (isLaw && m_best.legs[i].dt > 0.01 && keepsChanged([&](Case &c) { c.legs[i].dt *= 0.7; })) {
                isBetter = true;
            }
        }
        return isBetter;
    }

    bool dropBoxes() {
        bool isBetter = false;
        for (size_t i = m_best.boxes.size(); i-- > 0;) {
            isBetter = keepsChanged([&](Case &c) { c.boxes.erase(c.boxes.begin() + std::ptrdiff_t(i)); }) || isBetter;
        }
        return isBetter;
    }

    /// Tries zero, or fewer digits.
    bool simplify(const std::function<double &(Case &)> &number) {
        const double value = number(m_best);
        if (value == 0) return false;
        if (keepsChanged([&](Case &c) { number(c) = 0; })) return true;
        for (const int digits : {1, 2, 3, 5}) {
            char text[40];
            std::snprintf(text, sizeof text, "%.*g", digits, value);
            const double shorter = std::strtod(text, nullptr);
            if (shorter == value) return false;
            if (keepsChanged([&](Case &c) { number(c) = shorter; })) return true;
        }
        return false;
    }
    bool simplify(const std::function<phys_vec3 &(Case &)> &vector) {
        bool isBetter = simplify([&](Case &c) -> double & { return vector(c).x; });
        isBetter = simplify([&](Case &c) -> double & { return vector(c).y; }) || isBetter;
        return simplify([&](Case &c) -> double & { return vector(c).z; }) || isBetter;
    }

    bool simplifyNumbers() {
        bool isBetter = false;
        for (double phys_params::*coefficient :
             {&phys_params::rolling_friction, &phys_params::sliding_friction, &phys_params::wall_friction,
              &phys_params::restitution_floor, &phys_params::restitution_wall}) {
            isBetter = simplify([&](Case &c) -> double & { return c.params.*coefficient; }) || isBetter;
        }
        isBetter = simplify([](Case &c) -> phys_vec3 & { return c.start.spin; }) || isBetter;
        isBetter = simplify([](Case &c) -> phys_vec3 & { return c.start.velocity; }) || isBetter;
        isBetter = simplify([](Case &c) -> phys_vec3 & { return c.start.position; }) || isBetter;
        for (size_t i = 0; i < m_best.legs.size(); ++i) {
            isBetter = simplify([i](Case &c) -> phys_vec3 & { return c.legs[i].gravity; }) || isBetter;
        }
        for (size_t i = 0; i < m_best.boxes.size(); ++i) {
            isBetter = simplify([i](Case &c) -> phys_vec3 & { return c.boxes[i].min; }) || isBetter;
            isBetter = simplify([i](Case &c) -> phys_vec3 & { return c.boxes[i].max; }) || isBetter;
        }
        return isBetter;
    }

    const phys_registry *m_registry;
    const std::string &m_stepper;
    Case m_best;
    Verdict m_verdict;
    int m_trials = 0;
};

} // namespace

Verdict judgeLaw(const phys_registry *registry, const std::string &stepper, const Case &scene, const Truth &truth) {
    const Convergence convergence = converge(registry, stepper, scene, truth);
    Verdict verdict;
    verdict.status = convergence.status;
    verdict.statusText = convergence.statusText;
    verdict.steps = verdict.step = 1;
    if (!convergence.isWrong) return verdict;
    verdict.check = "law";
    verdict.what = convergence.what;
    return verdict;
}

Verdict judge(const phys_registry *registry, const std::string &stepper, const Case &scene) {
    if (scene.check != "law") return examine(registry, stepper, scene);
    const std::optional<Truth> truth = Truth::of(scene);
    return truth ? judgeLaw(registry, stepper, scene, *truth) : Verdict{};
}

Case shrink(const phys_registry *registry, const std::string &stepper, const Case &scene, const Verdict &verdict) {
    return Shrinker(registry, stepper, scene, verdict).run();
}

} // namespace witness
