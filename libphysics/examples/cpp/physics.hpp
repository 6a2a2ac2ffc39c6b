// SPDX-License-Identifier: MIT
// The C API for C++17 and later: owners that free what they made, and failures as exceptions. Header only; every call
// goes through <physics/physics.h>. States, params and reports stay the plain structs that they are.
#pragma once

#include <physics/physics.h>

#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace physics {

/// A call failed: the status, and the library's one line of what, which value, what was allowed.
class Error : public std::runtime_error {
public:
    Error(phys_status status, const std::string &text)
        : std::runtime_error(text)
        , m_status(status) {}
    phys_status status() const noexcept { return m_status; }

private:
    phys_status m_status;
};

namespace detail {

/// Calls function(&err) and throws if it fails.
template<class Function>
void check(Function function) {
    phys_error err{};
    const phys_status status = function(&err);
    if (status != PHYS_OK) throw Error(status, err.text);
}

/// For functions that give a code alone.
inline void checkCode(phys_status status) {
    if (status != PHYS_OK) throw Error(status, phys_status_text(status));
}

template<class T, void (*destroy)(T *)>
struct Destroy {
    void operator()(T *object) const noexcept { destroy(object); }
};
template<class T, void (*destroy)(T *)>
using Owner = std::unique_ptr<T, Destroy<T, destroy>>;

/// Makes an object by create(&object, &err) and owns it.
template<class T, void (*destroy)(T *), class Create>
Owner<T, destroy> make(Create create) {
    T *object = nullptr;
    check([&](phys_error *err) { return create(&object, err); });
    return Owner<T, destroy>(object);
}

} // namespace detail

inline phys_params defaultParams() {
    phys_params params;
    detail::checkCode(phys_params_init(&params, sizeof params));
    return params;
}

/// With the initial values of a stepper's own parameters, too.
inline phys_params defaultParams(const phys_stepper_info &info) {
    phys_params params = defaultParams();
    detail::checkCode(phys_stepper_info_init_params(&info, &params));
    return params;
}

/// No balls, no steps, no arrays.
inline phys_batch defaultBatch() {
    phys_batch batch;
    detail::checkCode(phys_batch_init(&batch, sizeof batch));
    return batch;
}

/// tiltX, tiltY: rad; strength: m/s^2.
inline phys_vec3 gravityFromTilt(double tiltX, double tiltY, double strength = 9.81) {
    phys_vec3 gravity;
    detail::checkCode(phys_gravity_from_tilt(tiltX, tiltY, strength, &gravity));
    return gravity;
}

/// For each i of tiltsX[i], tiltsY[i] (rad), with one strength (m/s^2): as phys_batch wants it.
inline std::vector<phys_vec3> gravitiesFromTilts(const std::vector<double> &tiltsX, const std::vector<double> &tiltsY,
                                                 double strength = 9.81) {
    if (tiltsX.size() != tiltsY.size()) throw Error(PHYS_ERROR_ARGUMENT, "tiltsX and tiltsY differ in size");
    const std::vector<double> strengths(tiltsX.size(), strength);
    std::vector<phys_vec3> gravities(tiltsX.size());
    detail::checkCode(
        phys_gravities_from_tilts(gravities.size(), tiltsX.data(), tiltsY.data(), strengths.data(), gravities.data()));
    return gravities;
}

class Scene {
public:
    explicit Scene(const std::string &path)
        : m_scene(detail::make<phys_scene, phys_scene_destroy>(
              [&](phys_scene **out, phys_error *err) { return phys_scene_load(path.c_str(), out, err); })) {}

    /// radius: m; start: centre of the ball, m. The boxes are copied.
    Scene(const std::vector<phys_box> &boxes, double radius, const phys_vec3 &start) {
        phys_scene_desc desc;
        detail::checkCode(phys_scene_desc_init(&desc, sizeof desc));
        desc.boxes = boxes.data();
        desc.box_count = static_cast<uint32_t>(boxes.size());
        desc.radius = radius;
        desc.start = start;
        m_scene = detail::make<phys_scene, phys_scene_destroy>(
            [&](phys_scene **out, phys_error *err) { return phys_scene_create(&desc, out, err); });
    }

    /// A maze's text in memory; messages call it by its name.
    static Scene parse(const std::string &text, const std::string &name = "text") {
        return Scene(detail::make<phys_scene, phys_scene_destroy>([&](phys_scene **out, phys_error *err) {
            return phys_scene_parse(text.data(), text.size(), name.c_str(), out, err);
        }));
    }

    phys_state start() const {
        phys_state state;
        detail::checkCode(phys_scene_start(get(), &state));
        return state;
    }
    /// J/kg
    double energy(const phys_params &params, const phys_state &state) const {
        double energy = 0.0;
        detail::checkCode(phys_energy(get(), &params, &state, &energy));
        return energy;
    }
    const phys_scene *get() const noexcept { return m_scene.get(); }

private:
    using Owner = detail::Owner<phys_scene, phys_scene_destroy>;
    explicit Scene(Owner scene)
        : m_scene(std::move(scene)) {}

    Owner m_scene;
};

/// The built-in steppers and those of plugins.
class Registry {
public:
    Registry()
        : m_registry(detail::make<phys_registry, phys_registry_destroy>(phys_registry_create)) {}

    void load(const std::string &file) {
        detail::check([&](phys_error *err) { return phys_registry_load_file(m_registry.get(), file.c_str(), err); });
    }
    std::vector<phys_stepper_info> steppers() const {
        std::vector<phys_stepper_info> infos(phys_registry_count(get()));
        for (uint32_t i = 0; i < infos.size(); ++i) detail::checkCode(phys_registry_info(get(), i, &infos[i]));
        return infos;
    }
    phys_stepper_info find(const std::string &id) const {
        phys_stepper_info info;
        detail::check([&](phys_error *err) { return phys_registry_find(get(), id.c_str(), &info, err); });
        return info;
    }
    const phys_registry *get() const noexcept { return m_registry.get(); }

private:
    detail::Owner<phys_registry, phys_registry_destroy> m_registry;
};

/// Both registry and scene must outlive it.
class Stepper {
public:
    Stepper(const Registry &registry, const std::string &id, const Scene &scene)
        : m_stepper(detail::make<phys_stepper, phys_stepper_destroy>([&](phys_stepper **out, phys_error *err) {
            return phys_stepper_create(registry.get(), id.c_str(), scene.get(), out, err);
        })) {}
    Stepper(const Registry &&, const std::string &, const Scene &) = delete; // they would be gone
    Stepper(const Registry &, const std::string &, const Scene &&) = delete;

    /// The state dt seconds later. report: or nullptr.
    phys_state step(const phys_params &params, double dt, const phys_state &state, phys_report *report = nullptr) {
        phys_state next;
        detail::check(
            [&](phys_error *err) { return phys_step(m_stepper.get(), &params, dt, &state, &next, report, err); });
        return next;
    }

    /// Runs the balls first .. first + count - 1 of a batch. Threads with a stepper each may run disjoint ranges.
    void run(const phys_batch &batch, uint64_t first, uint64_t count) {
        detail::check([&](phys_error *err) { return phys_batch_run(m_stepper.get(), &batch, first, count, err); });
    }
    void run(const phys_batch &batch) { run(batch, 0, batch.ball_count); }

private:
    detail::Owner<phys_stepper, phys_stepper_destroy> m_stepper;
};

} // namespace physics
