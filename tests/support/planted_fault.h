// SPDX-License-Identifier: MIT
// Building blocks of plugins with planted faults: a correct stepper, and a function around each of its steps.
#pragma once

#include <physics/plugin.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <iterator>
#include <vector>

namespace support {

inline constexpr char kSound[] = "swept";

struct Self {
    phys_scene *scene = nullptr;
    phys_stepper *sound = nullptr;
    std::vector<phys_box> boxes;
    double radius = 0.0;
    uint64_t calls = 0;
};

/// The arguments of a step.
struct Step {
    Self &self;
    phys_params params;
    double dt;
    const phys_state &in;
    phys_state &out;
    phys_report *report;
    phys_error *err;
};

inline phys_status soundStep(Step &step) {
    return phys_step(step.self.sound, &step.params, step.dt, &step.in, &step.out, step.report, step.err);
}

inline void add(phys_vec3 &v, double factor, const phys_vec3 &w) {
    v = {v.x + factor * w.x, v.y + factor * w.y, v.z + factor * w.z};
}
inline double dot(const phys_vec3 &a, const phys_vec3 &b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

inline std::vector<phys_contact> contactsAt(const Self &self, const phys_vec3 &place, double reach) {
    std::array<phys_contact, 16> found{};
    uint32_t count = 0;
    phys_scene_contacts(self.scene, &place, reach, found.data(), found.size(), &count);
    return {found.begin(), found.begin() + std::min<uint32_t>(count, found.size())};
}

using StepFunction = phys_status(Step &);
using KeepFunction = bool(const phys_box &, double floorTop);

inline bool keepAll(const phys_box &, double) { return true; }

inline void destroy(void *pointer) {
    Self *self = static_cast<Self *>(pointer);
    phys_stepper_destroy(self->sound);
    phys_scene_destroy(self->scene);
    delete self;
}

template<KeepFunction *keep>
phys_status create(const phys_scene_view *view, void **out, phys_error *err) {
    Self *self = new Self;
    self->radius = view->radius;
    phys_scene_desc desc;
    phys_scene_desc_init(&desc, sizeof desc);
    desc.start = {0, 0, 1e3 * view->radius};
    for (uint32_t i = 0; i < view->box_count; ++i) {
        const phys_box &box = view->boxes[i];
        if (keep(box, view->floor_top)) self->boxes.push_back(box);
        if (box.max.z != view->floor_top) continue;
        desc.start = {(box.min.x + box.max.x) / 2, (box.min.y + box.max.y) / 2, box.max.z + view->radius};
    }
    desc.boxes = self->boxes.data();
    desc.box_count = static_cast<uint32_t>(self->boxes.size());
    desc.radius = view->radius;
    phys_status status = phys_scene_create(&desc, &self->scene, err);
    if (!status) status = phys_stepper_create(nullptr, kSound, self->scene, &self->sound, err);
    if (status) {
        destroy(self);
        return status;
    }
    *out = self;
    return PHYS_OK;
}

template<StepFunction *function>
phys_status step(void *self, const phys_params *params, double dt, const phys_state *in, phys_state *out,
                 phys_report *report, phys_error *err) {
    Step all{*static_cast<Self *>(self), *params, dt, *in, *out, report, err};
    return function(all);
}

/// A stepper that makes its steps by `function`, and sees only the boxes that `keep` accepts.
template<StepFunction *function, KeepFunction *keep = keepAll>
constexpr phys_stepper_api doing(const char *id) {
    return {sizeof(phys_stepper_api), 0,       id,     id, "1", "", nullptr, 0, 0, create<keep>, destroy,
            step<function>,           nullptr, nullptr};
}

/// Pointers to the tables of a plugin.
template<size_t count>
struct PlantedTables {
    constexpr explicit PlantedTables(const phys_stepper_api (&tables)[count]) {
        for (size_t i = 0; i < count; ++i) list[i] = &tables[i];
    }
    const phys_stepper_api *list[count]{};
};

} // namespace support
