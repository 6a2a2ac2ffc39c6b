// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/setup/handles.h"

#include "core/setup/files.h"
#include "core/setup/lines.h"

#include <cstring>

namespace inspector {

void tell(QString *error, const phys_error &failure) {
    if (error) *error = oneLine(decodePath(failure.text)); // it may quote a name of any bytes
}

Registry makeRegistry(QString *error) {
    phys_registry *registry = nullptr;
    phys_error failure;
    if (phys_registry_create(&registry, &failure) != PHYS_OK) {
        tell(error, failure);
        return {};
    }
    return {registry, phys_registry_destroy};
}

Scene loadScene(const QString &path, QString *error) {
    phys_scene *scene = nullptr;
    phys_error failure;
    // As every other file of the inspector: never blocks, and says what was found in place of a file.
    const std::optional<QByteArray> text = readFile(path, kLargestMaze, error);
    if (!text) return {};
    const QByteArray name = encodePath(path);
    if (phys_scene_parse(text->constData(), size_t(text->size()), name.constData(), &scene, &failure) != PHYS_OK) {
        tell(error, failure);
        return {};
    }
    return {scene, phys_scene_destroy};
}

Scene makeScene(const phys_scene_desc &description, QString *error) {
    phys_scene *scene = nullptr;
    phys_error failure;
    if (phys_scene_create(&description, &scene, &failure) != PHYS_OK) {
        tell(error, failure);
        return {};
    }
    return {scene, phys_scene_destroy};
}

Stepper makeStepper(const Registry &registry, const QByteArray &id, const Scene &scene, QString *error) {
    phys_stepper *stepper = nullptr;
    phys_error failure;
    if (phys_stepper_create(registry.get(), id.constData(), scene.get(), &stepper, &failure) != PHYS_OK) {
        tell(error, failure);
        return {};
    }
    // The deleter's copies keep registry and scene alive as long as the stepper.
    return {stepper, [registry, scene](phys_stepper *dead) { phys_stepper_destroy(dead); }};
}

uint32_t stepperIndex(const Registry &registry, const char *id) {
    phys_stepper_info info;
    for (uint32_t i = 0; phys_registry_info(registry.get(), i, &info) == PHYS_OK; ++i)
        if (id && std::strcmp(info.id, id) == 0) return i;
    return kNoStepper;
}

QByteArray stepperId(const Registry &registry, uint32_t index) {
    phys_stepper_info info;
    const bool isThere = phys_registry_info(registry.get(), index, &info) == PHYS_OK;
    return isThere ? QByteArray(info.id) : QByteArray();
}

QString stepperName(const Registry &registry, const QByteArray &id) {
    phys_stepper_info info;
    const bool isThere = phys_registry_find(registry.get(), id.constData(), &info, nullptr) == PHYS_OK;
    return isThere ? QString::fromUtf8(info.name) : QString::fromUtf8(id);
}

bool loadPlugin(const Registry &registry, const QString &path, QString *error) {
    phys_error failure;
    if (phys_registry_load_file(registry.get(), encodePath(path).constData(), &failure) == PHYS_OK) return true;
    tell(error, failure);
    return false;
}

} // namespace inspector
