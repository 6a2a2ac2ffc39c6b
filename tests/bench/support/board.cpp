// SPDX-License-Identifier: MIT
#include "support/board.h"

#include <stdexcept>

namespace bench {

namespace {

std::vector<phys_box> boxesOf(const Scene &scene) {
    const Wall floor = floorOf(scene);
    std::vector<phys_box> boxes{{{floor.x0, floor.y0, -kFloorThickness}, {floor.x1, floor.y1, 0}}};
    for (const Wall &wall : scene.walls) boxes.push_back({{wall.x0, wall.y0, 0}, {wall.x1, wall.y1, kWallHeight}});
    return boxes;
}

} // namespace

void check(phys_status status, const phys_error &error) {
    if (status != PHYS_OK) throw std::runtime_error(error.text);
}

ScenePointer createScene(const Scene &scene) {
    const std::vector<phys_box> boxes = boxesOf(scene);
    phys_scene_desc description;
    phys_scene_desc_init(&description, sizeof description);
    description.box_count = static_cast<uint32_t>(boxes.size());
    description.boxes = boxes.data();
    description.radius = scene.radius;
    description.start = {scene.start.position.x, scene.start.position.y, scene.radius};
    phys_error error;
    phys_scene *created = nullptr;
    check(phys_scene_create(&description, &created, &error), error);
    return ScenePointer(created);
}

ScenePointer loadScene(const std::filesystem::path &file) {
    phys_error error;
    phys_scene *loaded = nullptr;
    check(phys_scene_load(file.c_str(), &loaded, &error), error);
    return ScenePointer(loaded);
}

Scene topView(const phys_scene &scene) {
    Scene walls;
    phys_state start;
    phys_scene_start(&scene, &start);
    walls.radius = phys_scene_radius(&scene);
    walls.rolls = true;
    walls.start.position = {start.position.x, start.position.y};
    const phys_box *boxes = phys_scene_boxes(&scene);
    for (uint32_t i = 0; i < phys_scene_box_count(&scene); ++i) {
        const phys_box &box = boxes[i];
        if (box.max.z > start.position.z) walls.walls.push_back({box.min.x, box.min.y, box.max.x, box.max.y});
    }
    return walls;
}

StepperPointer createStepper(const std::string &id, const phys_scene &scene) {
    phys_error error;
    phys_stepper *created = nullptr;
    check(phys_stepper_create(nullptr, id.c_str(), &scene, &created, &error), error);
    return StepperPointer(created);
}

} // namespace bench
