/* SPDX-License-Identifier: MIT
 *
 * A hundred balls of one level, each with a restitution of its own, in one call: where they are after 0.75 s.
 * Usage: batch LEVEL */
#include <physics/physics.h>

#include <stdio.h>

enum { BALLS = 100 };

static phys_status roll(const char *level, phys_params *params, phys_state *states, phys_error *err) {
    phys_scene *scene = NULL;
    phys_stepper *stepper = NULL;
    phys_batch batch;
    phys_status status = phys_scene_load(level, &scene, err);
    if (!status) status = phys_stepper_create(NULL, PHYS_STEPPER_DEFAULT, scene, &stepper, err);
    if (!status) {
        for (int i = 0; i < BALLS; ++i) {
            phys_params_init(&params[i], sizeof params[i]);
            phys_gravity_from_tilt(0.05, 0.03, 9.81, &params[i].gravity);
            params[i].restitution_wall = (double)i / (BALLS - 1);
            phys_scene_start(scene, &states[i]);
        }
        phys_batch_init(&batch, sizeof batch);
        batch.stop_flags = PHYS_OUT;
        batch.ball_count = BALLS;
        batch.step_count = 75;
        batch.dt = 0.01;
        batch.params = params;
        batch.params_stride = sizeof params[0];
        batch.states = states;
        batch.states_stride = sizeof states[0];
        status = phys_batch_run(stepper, &batch, 0, BALLS, err);
    }
    phys_stepper_destroy(stepper);
    phys_scene_destroy(scene);
    return status;
}

int main(int argc, char **argv) {
    static phys_params params[BALLS];
    static phys_state states[BALLS];
    phys_error err;
    if (argc != 2) {
        fputs("Usage: batch LEVEL\n", stderr);
        return 2;
    }
    if (roll(argv[1], params, states, &err)) {
        fprintf(stderr, "batch: %s\n", err.text);
        return 1;
    }
    for (int i = 0; i < BALLS; i += 11) {
        printf("restitution %.2f: x %.4f m, y %.4f m%s\n", params[i].restitution_wall, states[i].position.x,
               states[i].position.y, states[i].flags & PHYS_OUT ? ", out" : "");
    }
    if (fclose(stdout)) { /* as on a full disk */
        perror("batch: the output can't be written");
        return 1;
    }
    return 0;
}
