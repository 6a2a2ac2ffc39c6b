// SPDX-License-Identifier: MIT
#include "converge.h"

#include "integrator/touch.h"

#include "support/handles.h"
#include "support/orders.h"

#include <algorithm>
#include <cfloat>
#include <cstdio>
#include <set>

namespace witness {

namespace {

constexpr int kStepCounts[kSizes] = {400, 800, 1600};
constexpr int kFiner = 16; ///< factor on the number of steps, where the usual ones are too few to show the order
constexpr Real kShareOfOrder = 0.5L; ///< share of the decrease that the order predicts
constexpr Real kAmplified = 4;       ///< limit, in units of the effect of a shift of the start in the same direction
constexpr Real kUsual = 6; ///< errors must be below this times the effect of a disturbance of the stepper's order

Motion motionOf(const phys_state &state) {
    return {vectorOf(state.position), vectorOf(state.velocity), vectorOf(state.spin)};
}

Law lawAt(const Case &scene) {
    phys_params params = scene.params;
    params.gravity = scene.legs.front().gravity;
    return lawOf(params, scene.radius);
}

/// The law doesn't cover a ball inside a box, or a box without volume.
bool isLawful(const Case &scene) {
    return std::all_of(scene.boxes.begin(), scene.boxes.end(), [&](const phys_box &box) {
        const bool isSolid = box.min.x < box.max.x && box.min.y < box.max.y && box.min.z < box.max.z;
        return isSolid && touchOf(box, vectorOf(scene.start.position), scene.radius).gap > -1e-12L * scene.radius;
    });
}

/// The time in which a ball falls half its radius: the shortest time scale that every scene has.
Real timeScale(const Case &scene) {
    return std::sqrt(scene.radius / (length(vectorOf(scene.legs.front().gravity)) + 1e-30L));
}

struct Path {
    std::vector<Motion> motions;
    phys_status status = PHYS_OK;
    std::string text;
};

Path pathOf(const phys_registry *registry, const std::string &id, const Case &scene, int steps) {
    const phys_scene_desc desc = descOf(scene.boxes, scene.radius, scene.start.position);
    phys_scene *created = nullptr;
    phys_stepper *made = nullptr;
    phys_error error{};
    Path path;
    path.status = phys_scene_create(&desc, &created, &error);
    const support::ScenePtr owner(created);
    if (!path.status) path.status = phys_stepper_create(registry, id.c_str(), created, &made, &error);
    const support::StepperPtr stepper(made);
    phys_params params = scene.params;
    params.gravity = scene.legs.front().gravity;
    phys_stepper_info info;
    if (!phys_registry_find(registry, id.c_str(), &info, nullptr)) phys_stepper_info_init_params(&info, &params);
    phys_state state = scene.start;
    const double dt = scene.duration() / steps;
    for (int i = 1; i <= steps && !path.status; ++i) {
        path.status = phys_step(made, &params, dt, &state, &state, nullptr, &error);
        if (i % (steps / kCheckpoints) == 0) path.motions.push_back(motionOf(state));
    }
    if (path.status) path.text = error.text;
    return path;
}

} // namespace

bool hasUndecidedGap(const Case &scene, const phys_vec3 &centre) {
    // At an edge the ball is still in the mouth of a gap.
    const auto touchesFace = [&](const phys_box &box, int axis) {
        const auto isBetweenEnds = [&](int other) {
            return (&box.min.x)[other] < (&centre.x)[other] && (&centre.x)[other] < (&box.max.x)[other];
        };
        return isBetweenEnds((axis + 1) % 3) && isBetweenEnds((axis + 2) % 3) &&
               touchOf(box, vectorOf(centre), scene.radius).gap <= 1e-9L * scene.radius;
    };
    const auto overlap = [](const phys_box &a, const phys_box &b, int axis) {
        return (&a.min.x)[axis] < (&b.max.x)[axis] && (&b.min.x)[axis] < (&a.max.x)[axis];
    };
    for (const phys_box &below : scene.boxes) {
        for (const phys_box &above : scene.boxes) {
            for (int axis = 0; axis < 3; ++axis) {
                const double gap = (&above.min.x)[axis] - (&below.max.x)[axis];
                if (std::abs(gap - 2 * scene.radius) > 1e-9 * scene.radius) continue;
                const bool isGap = overlap(below, above, (axis + 1) % 3) && overlap(below, above, (axis + 2) % 3);
                if (isGap && !(touchesFace(below, axis) && touchesFace(above, axis))) return true;
            }
        }
    }
    return false;
}

namespace {

/// Whether forces along three normals in one plane can balance.
bool balance(const Vector &a, const Vector &b, const Vector &c) {
    constexpr Real kFlat = 1e-9L;
    const Vector axis = cross(a, b);
    if (length(axis) < kFlat || std::abs(dot(axis, c)) > kFlat) return false;
    return dot(cross(b, c), axis) > 0 && dot(cross(c, a), axis) > 0;
}

/// Numbers of the boxes between which the ball is held across a line.
std::set<size_t> throatAt(const Case &scene, const phys_vec3 &centre) {
    std::vector<size_t> touched;
    std::vector<Vector> normals;
    for (size_t i = 0; i < scene.boxes.size(); ++i) {
        const Touch touch = touchOf(scene.boxes[i], vectorOf(centre), scene.radius);
        if (std::abs(touch.gap) > 1e-9L * scene.radius) continue;
        touched.push_back(i);
        normals.push_back(touch.normal);
    }
    std::set<size_t> held;
    for (size_t i = 0; i < touched.size(); ++i) {
        for (size_t j = i + 1; j < touched.size(); ++j) {
            for (size_t k = j + 1; k < touched.size(); ++k) {
                if (balance(normals[i], normals[j], normals[k])) held.insert({touched[i], touched[j], touched[k]});
            }
        }
    }
    return held;
}

} // namespace

bool passesThroat(const Case &scene, const std::vector<phys_vec3> &places) {
    return std::any_of(places.begin(), places.end(), [&](const phys_vec3 &place) {
        return throatAt(scene, place) != throatAt(scene, places.front());
    });
}

std::vector<Motion> Truth::run(const Law &law, Motion motion, Real tolerance) const {
    return run(m_scene.boxes, law, motion, tolerance);
}

std::vector<Motion> Truth::run(const std::vector<phys_box> &boxes, const Law &law, Motion motion,
                               Real tolerance) const {
    BruteForce force(boxes, m_scene.radius, tolerance);
    std::vector<Motion> motions;
    for (int i = 0; i < kCheckpoints; ++i) {
        if (!force.run(law, Real(m_scene.duration()) / kCheckpoints, motion)) return {};
        motions.push_back(motion);
    }
    return motions;
}

/// A start that overlaps one box, with the centre outside, is pushed out to the nearest place at no cost. Out of
/// several boxes, or from inside one, the law determines no unique way.
Case pushedOut(Case scene) {
    const Vector start = vectorOf(scene.start.position);
    std::optional<Touch> overlap;
    for (const phys_box &box : scene.boxes) {
        const Touch touch = touchOf(box, start, scene.radius);
        if (touch.gap > -1e-12L * scene.radius) continue;
        if (overlap || touch.gap <= -scene.radius) return scene;
        overlap = touch;
    }
    if (overlap) scene.start.position = rounded(start - overlap->gap * overlap->normal);
    return scene;
}

std::optional<Truth> Truth::of(const Case &given) {
    const Case scene = pushedOut(given);
    const bool isPushedOut = length(vectorOf(scene.start.position) - vectorOf(given.start.position)) > 0;
    if (!isLawful(scene) || hasUndecidedGap(scene, scene.start.position)) return std::nullopt;
    Truth truth(scene);
    const Law law = lawAt(scene);
    Motion motion = motionOf(scene.start);
    BruteForce force(scene.boxes, scene.radius);
    for (int i = 0; i < kCheckpoints; ++i) {
        if (!force.run(law, Real(scene.duration()) / kCheckpoints, motion)) return std::nullopt;
        truth.m_motions.push_back(motion);
    }
    std::vector<phys_vec3> places = {scene.start.position};
    for (const Vector &place : force.way()) places.push_back(rounded(place));
    const auto isUndecided = [&](const phys_vec3 &centre) { return hasUndecidedGap(scene, centre); };
    if (std::any_of(places.begin(), places.end(), isUndecided) || passesThroat(scene, places)) return std::nullopt;
    truth.m_hasEvents = force.events() > 0 || isPushedOut;
    const std::vector<Motion> coarser = truth.run(law, motionOf(scene.start), 1e-11L);
    if (coarser.empty()) return std::nullopt;
    for (int i = 0; i < kCheckpoints; ++i) {
        truth.m_ownError = std::max(truth.m_ownError, length(coarser[i].place - truth.m_motions[i].place));
    }
    truth.m_fastest = length(law.gravity) * scene.duration() + length(vectorOf(scene.start.velocity)) +
                      scene.radius * length(vectorOf(scene.start.spin));
    return truth;
}

const Truth &Truth::refined() const {
    if (m_refined) return *m_refined;
    m_refined = std::make_shared<Truth>(*this);
    std::vector<Motion> finer = run(lawAt(m_scene), motionOf(m_scene.start), 1e-15L);
    if (finer.empty()) return *m_refined;
    m_refined->m_ownError = 0;
    for (int i = 0; i < kCheckpoints; ++i) { // the error falls with the tolerance to the power of about 3/4
        m_refined->m_ownError = std::max(m_refined->m_ownError, length(finer[i].place - m_motions[i].place) / 30);
    }
    m_refined->m_motions = finer;
    return *m_refined;
}

/// Where the ball reaches several boxes at once, the rounding of their coordinates determines which it hits first.
const std::vector<Motion> &Truth::withSmaller(size_t box) const {
    constexpr Real kTolerance = 1e-13L;
    const auto [found, isNew] = m_withSmaller->try_emplace(box);
    if (!isNew) return found->second;
    double largest = m_scene.radius;
    for (const phys_box &one : m_scene.boxes) {
        for (int axis = 0; axis < 3; ++axis)
            largest = std::max({largest, std::abs((&one.min.x)[axis]), std::abs((&one.max.x)[axis])});
    }
    const double least = 4 * DBL_EPSILON * largest; // lengths that differ by less count as equal
    std::vector<phys_box> boxes = m_scene.boxes;
    for (int axis = 0; axis < 3; ++axis) {
        (&boxes[box].min.x)[axis] += least;
        (&boxes[box].max.x)[axis] -= least;
    }
    found->second = run(boxes, lawAt(m_scene), motionOf(m_scene.start), kTolerance);
    return found->second;
}

const std::vector<Motion> &Truth::disturbed(Real disturbance, Real shift, int way) const {
    const auto [found, isNew] = m_disturbed->try_emplace({disturbance, shift, way});
    if (isNew) found->second = disturb(disturbance, shift, way);
    return found->second;
}

/// The start moved in this direction, but no farther than until the ball touches something.
phys_state moved(const Case &scene, const Vector &way) {
    Case other = scene;
    Real free = 0;
    Real taken = 1;
    for (Real part = 1; taken - free > 1e-12L; part = (free + taken) / 2) {
        other.start.position = rounded(vectorOf(scene.start.position) + part * way);
        (isLawful(other) ? free : taken) = part;
        if (free == 1) return other.start;
    }
    other.start.position = rounded(vectorOf(scene.start.position) + free * way);
    return other.start;
}

std::vector<Motion> Truth::disturb(Real disturbance, Real shift, int way) const {
    constexpr Real kTolerance = 1e-12L;
    const Vector axes[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    const Real sign = way < kWays / 2 ? -1 : 1;
    const Real off = sign * disturbance;
    const int kind = way % (kWays / 2);
    Law law = lawAt(m_scene);
    Motion motion = motionOf(m_scene.start);
    if (kind < 3) {
        law.gravity += off * length(law.gravity) * axes[kind];
    } else if (kind == 3) {
        motion.velocity += off * motion.velocity;
        motion.spin += off * motion.spin;
    } else if (kind < 6) { // which of two walls is hit first depends on the position
        motion = motionOf(moved(m_scene, sign * shift * axes[kind - 4]));
    } else {
        motion.velocity += off * Vector{-motion.velocity.y, motion.velocity.x, 0};
        motion.spin += off * Vector{-motion.spin.y, motion.spin.x, 0};
    }
    return run(law, motion, kTolerance);
}

namespace {

std::vector<Real> errorsOf(const Path &path, const Truth &truth) {
    std::vector<Real> errors;
    errors.reserve(kCheckpoints);
    for (int i = 0; i < kCheckpoints; ++i) errors.push_back(length(path.motions[i].place - truth.motions()[i].place));
    return errors;
}
Real largest(const std::vector<Real> &values) { return *std::max_element(values.begin(), values.end()); }

/// With this multiple of the usual number of steps.
Convergence compare(const phys_registry *registry, const std::string &stepper, const Case &scene, const Truth &truth,
                    int order, int finer) {
    Convergence result{};
    Path judged; // the one with the smallest steps; for steppers without a step-size error the worst
    Real worst = 0;
    for (int size = 0; size < kSizes; ++size) {
        const int steps = order == 0 ? kCheckpoints << size : finer * kStepCounts[size];
        const Path path = pathOf(registry, stepper, scene, steps);
        result.stepSizes[size] = scene.duration() / steps;
        result.status = path.status;
        result.statusText = path.text;
        if (path.status) return result;
        result.errors[size] = largest(errorsOf(path, truth));
        if (order == 0 && result.errors[size] < worst) continue;
        worst = result.errors[size];
        judged = path;
    }
    const Real h = result.stepSizes[kSizes - 1];
    const Real part = h / timeScale(scene);
    const Real base = order == 0 ? 0 : kUsual / 8 * truth.fastest() * h * std::pow(part, Real(order - 1));
    const Real floor = (order == 0 ? 2e-7L : 1e-8L) * scene.radius; // exact: 1e-9 m for a ball of 5 mm
    if (worst <= floor + base) return result;

    const Truth &best = order == 0 ? truth.refined() : truth;
    const std::vector<Real> errors = errorsOf(judged, best);
    const Real disturbance = order == 0 ? 1e-11L : std::max<Real>(std::pow(part, Real(order)), 1e-11L);
    const Real shift = truth.fastest() * h * (order == 0 ? 0 : std::pow(part, Real(order - 1)));
    std::vector<Real> spread(kCheckpoints, 0);
    const auto isAllowed = [&](int i) { return errors[i] <= floor + base + 10 * best.ownError() + kUsual * spread[i]; };
    const auto widens = [&](const std::vector<Motion> &motions, Real factor) {
        bool isEnough = true;
        for (int i = 0; i < kCheckpoints; ++i) {
            const auto at = static_cast<size_t>(i);
            const Real off = at < motions.size() ? length(motions[at].place - best.motions()[at].place) : 0;
            const bool tookAnotherWay = off > 0.1L * scene.radius + kAmplified * factor * shift;
            spread[at] = std::max(spread[at], tookAnotherWay ? off : off / factor);
            isEnough = isEnough && isAllowed(i);
        }
        return isEnough; // others could only allow more
    };
    // Larger disturbances, too: ties and grazes are sensitive within a window that a small disturbance may not leave.
    for (const Real factor : {1, 2, 4, 8}) {
        for (int way = 0; way < kWays; ++way) {
            if (widens(best.disturbed(factor * disturbance, factor * shift, way), factor)) return result;
        }
    }
    for (size_t box = 0; box < scene.boxes.size(); ++box) {
        if (widens(best.withSmaller(box), 1)) return result;
    }
    for (int i = 0; i < kCheckpoints && !result.isWrong; ++i) {
        if (isAllowed(i)) continue;
        result.isWrong = true;
        char text[300];
        std::snprintf(
            text, sizeof text,
            "after %d/%d of %.3g s %.3g m off; disturbances of its order make %.3g m; errors %.2g, %.2g, %.2g m "
            "with steps of %.3g, %.3g, %.3g s",
            i + 1, kCheckpoints, scene.duration(), static_cast<double>(errors[i]), static_cast<double>(spread[i]),
            static_cast<double>(result.errors[0]), static_cast<double>(result.errors[1]),
            static_cast<double>(result.errors[2]), result.stepSizes[0], result.stepSizes[1], result.stepSizes[2]);
        result.what = text;
    }
    return result;
}

} // namespace

Convergence converge(const phys_registry *registry, const std::string &stepper, const Case &scene, const Truth &truth) {
    const support::Orders orders = support::ordersOf(stepper);
    const int order = truth.hasEvents() ? orders.impacts : orders.lasting;
    Convergence first = compare(registry, stepper, scene, truth, order, 1);
    if (!first.isWrong || order == 0) return first;
    const Truth &best = truth.refined();
    Convergence usual = compare(registry, stepper, scene, best, order, 1);
    if (!usual.isWrong) return usual;
    // A slip or a roll that almost ends turns within a few steps; there the order shows only with smaller steps.
    Convergence finer = compare(registry, stepper, scene, best, order, kFiner);
    if (!finer.isWrong && !finer.status) return finer;
    constexpr Real kFallsNot = 0.8L; // a smaller decrease is another law's error
    if (finer.status || finer.errors[kSizes - 1] > kFallsNot * usual.errors[kSizes - 1]) return usual;
    // Bounces lower than a few steps cause a large error, which nevertheless falls at the order.
    Convergence finest = compare(registry, stepper, scene, best, order, kFiner * kFiner);
    if (finest.status) return usual;
    const Real falls = finer.errors[kSizes - 1] / finest.errors[kSizes - 1];
    finest.isWrong = falls < kShareOfOrder * std::pow(Real(kFiner), Real(order));
    return finest.isWrong ? usual : finest;
}

} // namespace witness
