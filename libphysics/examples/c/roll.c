/* SPDX-License-Identifier: MIT
 *
 * Rolls the ball of a level down a tilted board and prints where it is, ten times a second.
 * Usage: roll LEVEL [STEPPER]      a stepper of a plugin is found if the plugin lies in a folder of PHYS_PLUGIN_PATH
 */
#include <physics/physics.h>

#include <stdio.h>
#include <stdlib.h>

/* What a run is made of; NULL until it is made. */
typedef struct Run {
    phys_registry *registry;
    phys_scene *scene;
    phys_stepper *stepper;
} Run;

static phys_status make(Run *run, const char *level, const char *id, phys_error *err) {
    phys_status status = phys_registry_create(&run->registry, err);
    if (!status) status = phys_registry_scan(run->registry, NULL, NULL, NULL, err);
    if (!status) status = phys_scene_load(level, &run->scene, err);
    if (!status) status = phys_stepper_create(run->registry, id, run->scene, &run->stepper, err);
    return status;
}

static void destroy(Run *run) {
    phys_stepper_destroy(run->stepper);
    phys_scene_destroy(run->scene);
    phys_registry_destroy(run->registry);
}

static phys_status roll(const Run *run, const char *id, phys_error *err) {
    phys_state state;
    phys_params params;
    phys_stepper_info info;
    phys_scene_start(run->scene, &state);
    phys_params_init(&params, sizeof params);
    phys_gravity_from_tilt(0.10, 0.05, 9.81, &params.gravity); /* rad, rad, m/s^2 */
    phys_status status = phys_registry_find(run->registry, id, &info, err);
    /* The stepper's own parameters, if any. It can't fail for a stepper of a registry. */
    if (!status) phys_stepper_info_init_params(&info, &params);

    printf("   t/s      x/m      y/m vx/(m/s) vy/(m/s)\n");
    while (!status && state.time < 2.0 && !(state.flags & PHYS_OUT)) {
        status = phys_step(run->stepper, &params, 0.01, &state, &state, NULL, err);
        if (!status && state.step % 10 == 0) {
            printf("%6.2f %8.4f %8.4f %8.4f %8.4f\n", state.time, state.position.x, state.position.y, state.velocity.x,
                   state.velocity.y);
        }
    }
    return status;
}

int main(int argc, char **argv) {
    if (argc < 2 || argc > 3) {
        fprintf(stderr, "usage: %s LEVEL [STEPPER]\n", argv[0]);
        return 2;
    }
    const char *id = argc > 2 ? argv[2] : PHYS_STEPPER_DEFAULT;
    Run run = {NULL, NULL, NULL};
    phys_error error;
    phys_status status = make(&run, argv[1], id, &error);
    if (!status) status = roll(&run, id, &error);
    if (status) fprintf(stderr, "roll: %s\n", error.text);
    destroy(&run);
    if (fclose(stdout)) { /* as on a full disk */
        perror("roll: the output can't be written");
        return EXIT_FAILURE;
    }
    return status ? EXIT_FAILURE : EXIT_SUCCESS;
}
