// SPDX-License-Identifier: MIT
// The C functions on scenes.
#include "base/appendable.h"
#include "base/error.h"
#include "base/float_environment.h"
#include "base/numbers.h"
#include "scene/lowest.h"
#include "scene/maze_file.h"
#include "scene/nearest.h"
#include "scene/scene.h"

#include <cmath>
#include <new>

namespace phys {

namespace {

/// Makes a scene with `fill` and returns it; nothing leaks and nothing throws.
template<class Fill>
phys_status createScene(phys_scene **out, phys_error *err, Fill fill) try {
    const FloatEnvironment environment;
    auto *scene = new phys_scene;
    phys_status status = PHYS_ERROR_MEMORY;
    try {
        status = fill(*scene);
    } catch (...) {
        delete scene;
        throw;
    }
    if (status) {
        delete scene;
        return status;
    }
    *out = scene;
    return PHYS_OK;
} catch (const std::bad_alloc &) {
    return fail(err, PHYS_ERROR_MEMORY, "out of memory for a scene");
}

struct ByBox {
    bool operator()(const phys_contact &a, const phys_contact &b) const { return a.box < b.box; }
};

phys_contact describe(const Nearest &nearest, double radius, uint32_t box) {
    return {fromVec(nearest.point), fromVec(nearest.normal), nearest.distance - radius, box, nearest.feature};
}

} // namespace

} // namespace phys

phys_status phys_scene_desc_init(phys_scene_desc *desc, size_t size) {
    if (!desc || !phys::isKnownSize<phys_scene_desc>(size)) return PHYS_ERROR_ARGUMENT;
    phys::store(phys_scene_desc{0, 0, nullptr, 0.006, {0.0, 0.0, 0.006}}, size, desc);
    return PHYS_OK;
}

phys_status phys_scene_create(const phys_scene_desc *desc, phys_scene **out, phys_error *err) {
    if (!desc || !out) return phys::fail(err, PHYS_ERROR_ARGUMENT, "%s is NULL", desc ? "out" : "desc");
    if (phys::isOlder(*desc)) {
        const phys_scene_desc whole = phys::completed(*desc, phys_scene_desc_init);
        return phys_scene_create(&whole, out, err);
    }
    if (desc->struct_size != sizeof *desc) {
        return phys::fail(err, PHYS_ERROR_ARGUMENT,
                          "desc.struct_size is %u; expected %zu: call phys_scene_desc_init first", desc->struct_size,
                          sizeof *desc);
    }
    return phys::createScene(out, err, [&](phys_scene &scene) { return phys::makeScene(*desc, scene, err); });
}

phys_status phys_scene_load(const char *path, phys_scene **out, phys_error *err) {
    if (!path || !out) return phys::fail(err, PHYS_ERROR_ARGUMENT, "%s is NULL", path ? "out" : "path");
    return phys::createScene(out, err, [&](phys_scene &scene) { return phys::loadScene(path, scene, err); });
}

phys_status phys_scene_parse(const char *text, size_t size, const char *name, phys_scene **out, phys_error *err) {
    if ((!text && size > 0) || !out) return phys::fail(err, PHYS_ERROR_ARGUMENT, "%s is NULL", out ? "text" : "out");
    const std::string_view view = text ? std::string_view(text, size) : std::string_view();
    return phys::createScene(
        out, err, [&](phys_scene &scene) { return phys::parseScene(view, name && *name ? name : "text", scene, err); });
}

void phys_scene_destroy(phys_scene *scene) { delete scene; }

double phys_scene_radius(const phys_scene *scene) { return scene ? scene->radius : 0.0; }

uint32_t phys_scene_box_count(const phys_scene *scene) {
    return scene ? static_cast<uint32_t>(scene->given.size()) : 0;
}

const phys_box *phys_scene_boxes(const phys_scene *scene) {
    return scene && !scene->given.empty() ? scene->given.data() : nullptr;
}

phys_status phys_scene_bounds(const phys_scene *scene, phys_box *out) {
    if (!scene || !out) return PHYS_ERROR_ARGUMENT;
    *out = scene->bounds;
    return PHYS_OK;
}

phys_status phys_scene_check_planar(const phys_scene *scene, phys_error *err) {
    if (!scene) return phys::fail(err, PHYS_ERROR_ARGUMENT, "scene is NULL");
    if (scene->nonPlanarReason.empty()) return PHYS_OK;
    return phys::fail(err, PHYS_ERROR_UNSUPPORTED, "%s", scene->nonPlanarReason.c_str());
}

phys_status phys_scene_contacts(const phys_scene *scene, const phys_vec3 *centre, double reach, phys_contact *out,
                                uint32_t capacity, uint32_t *count) {
    const phys::FloatEnvironment environment;
    const bool valid = scene && centre && count && (out || capacity == 0) && reach >= 0.0 && std::isfinite(reach);
    if (!valid || !phys::isModerate(*centre)) return PHYS_ERROR_ARGUMENT;
    const phys::Vec3 p = phys::toVec(*centre);
    const double distance = scene->radius + reach;
    phys::Lowest<phys_contact, phys::ByBox> found({out, capacity});
    scene->visitBoxes(p - distance, p + distance, [&](uint32_t box) {
        if (phys::squaredDistance(scene->boxes[box], p) > distance * distance) return;
        const phys::Nearest nearest = phys::nearest(scene->boxes[box], p);
        found.add(phys::describe(nearest, scene->radius, scene->givenBox(box, nearest.point)));
    });
    found.sort();
    *count = found.count();
    return PHYS_OK;
}

phys_status phys_scene_start(const phys_scene *scene, phys_state *out) {
    if (!scene || !out) return PHYS_ERROR_ARGUMENT;
    *out = phys_state{};
    out->position = phys::fromVec(scene->start);
    out->orientation[3] = 1.0;
    return PHYS_OK;
}
