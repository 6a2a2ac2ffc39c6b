/* SPDX-License-Identifier: MIT
 * Prints what the library writes for people, and what it reads, under the locale of the environment; check_locale
 * compares. Usage: messages LEVEL PLUGIN */
#include <physics/physics.h>

#include <locale.h>
#include <stdio.h>

int main(int argc, char **argv) {
    phys_error error = {0};
    phys_scene *scene;
    phys_registry *registry;
    phys_stepper *stepper;
    phys_state state;
    phys_params params;
    phys_requirements requirements;
    if (argc != 3 || phys_scene_load(argv[1], &scene, &error)) return 2;
    if (!setlocale(LC_ALL, "")) return 3;
    fprintf(stderr, "%.1f\n", 0.5); /* so that check_locale sees whether the locale is another one at all */

    printf("radius %.0f nm\n", 1e9 * phys_scene_radius(scene));
    phys_scene_destroy(scene);
    if (phys_scene_load(argv[1], &scene, &error)) return 2;
    printf("radius %.0f nm\n", 1e9 * phys_scene_radius(scene));
    phys_scene_load("nowhere.txt", &scene, &error);
    puts(error.text);
    phys_registry_create(&registry, &error);
    phys_registry_load_file(registry, argv[2], &error);
    puts(error.text);
    phys_stepper_create(NULL, PHYS_STEPPER_DEFAULT, scene, &stepper, NULL);
    phys_scene_start(scene, &state);
    phys_params_init(&params, sizeof params);
    phys_stepper_requirements(stepper, &params, 0.0125, &state, &requirements, NULL);
    for (int stage = 0; stage < PHYS_STAGE_COUNT; ++stage) puts(requirements.reasons[stage]);
    params.restitution_wall = 1.5;
    phys_step(stepper, &params, 0.0125, &state, &state, NULL, &error);
    puts(error.text);
    state.orientation[3] = 0.5;
    params.restitution_wall = 0.5;
    phys_step(stepper, &params, 0.0125, &state, &state, NULL, &error);
    puts(error.text);
    phys_stepper_destroy(stepper);
    phys_registry_destroy(registry);
    phys_scene_destroy(scene);
    return 0;
}
