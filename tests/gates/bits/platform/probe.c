/* SPDX-License-Identifier: MIT
 * A program in C on its platform: a level in a file with a Greek name, a plugin from a folder, a message about a file
 * that isn't there. Run where `λαβύρινθος.txt` and `plugins` are. */
#include <physics/physics.h>

#include <stdio.h>

static void tell(void *context, const char *path, phys_status status, const char *text) {
    (void)context;
    if (status) printf("%s: %s\n", path, text);
}

int main(void) {
    phys_error error = {0};
    phys_registry *registry = NULL;
    phys_scene *scene = NULL;
    phys_stepper *stepper = NULL;
    phys_state state;
    phys_params params;
    phys_stepper_info info;
    phys_status status = phys_scene_load("λαβύρινθος.txt", &scene, &error);
    if (!status) status = phys_registry_create(&registry, &error);
    if (!status) status = phys_registry_scan(registry, "plugins", tell, NULL, &error);
    if (!status) status = phys_stepper_create(registry, "adaptive-drag", scene, &stepper, &error);
    if (!status) status = phys_scene_start(scene, &state);
    if (!status) status = phys_params_init(&params, sizeof params);
    if (!status) status = phys_registry_find(registry, "adaptive-drag", &info, &error);
    if (!status) status = phys_stepper_info_init_params(&info, &params);
    if (!status) status = phys_gravity_from_tilt(0.1, 0.0, 9.81, &params.gravity);
    if (!status) status = phys_step(stepper, &params, 0.01, &state, &state, NULL, &error);
    phys_stepper_destroy(stepper);
    phys_registry_destroy(registry);
    phys_scene_destroy(scene);
    puts(status ? error.text : "rolls");
    puts(phys_scene_load("nowhere.txt", &scene, &error) ? error.text : "nowhere.txt is there");
    return status ? 1 : 0;
}
