/* SPDX-License-Identifier: MIT
 *
 * Every function that takes an appendable struct, called with structs as long as the header that this is compiled with
 * has them; behind each lie bytes that are not the library's. Prints what a step of each stepper gives.
 * Usage: growth LEVEL PLUGIN */
#include <physics/physics.h>

#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define GUARD 0x5a

/* A struct and what lies behind it. */
#define GUARDED(type)                                                                                                  \
    struct {                                                                                                           \
        type it;                                                                                                       \
        unsigned char behind[64];                                                                                      \
    }

static void check(phys_status status, const char *what, const phys_error *error) {
    if (status == PHYS_OK) return;
    fprintf(stderr, "%s: %s %s\n", what, phys_status_name(status), error->text);
    exit(1);
}

static void check_untouched(const unsigned char *behind, const char *what) {
    for (int i = 0; i < 64; ++i) {
        if (behind[i] == GUARD) continue;
        fprintf(stderr, "byte %d behind %s was written\n", i, what);
        exit(1);
    }
}

static void check_init(phys_status status, const char *what) {
    if (status == PHYS_OK) return;
    fprintf(stderr, "%s init refused\n", what);
    exit(1);
}

static void roll(const phys_registry *registry, const char *id, const phys_scene *scene) {
    GUARDED(phys_params) params;
    GUARDED(phys_report) report;
    phys_requirements requirements;
    phys_stepper_info info;
    phys_stepper *stepper = NULL;
    phys_error error;
    phys_state state;
    double energy = 0.0;
    memset(&params, GUARD, sizeof params);
    memset(&report, GUARD, sizeof report);
    check_init(phys_params_init(&params.it, sizeof params.it), "params");
    check_init(phys_report_init(&report.it, sizeof report.it), "report");
    check(phys_registry_find(registry, id, &info, &error), "find", &error);
    check(phys_stepper_info_init_params(&info, &params.it), "init_params", &error);
    const double model = info.flags & PHYS_STEPPER_PLUGIN ? PHYS_MODEL_ROLLING : PHYS_MODEL_RIGID;
    check(phys_param_set(&params.it, phys_param_rows(NULL), model, &error), "set", &error);
    check(phys_params_check(&params.it, &error), "params_check", &error);
    check(phys_gravity_from_tilt(0.1, -0.05, 9.81, &params.it.gravity), "tilt", &error);
    check(phys_stepper_create(registry, id, scene, &stepper, &error), id, &error);
    phys_scene_start(scene, &state);
    for (int i = 0; i < 200; ++i) {
        check(phys_step(stepper, &params.it, 0.01, &state, &state, &report.it, &error), "step", &error);
    }
    check(phys_energy(scene, &params.it, &state, &energy), "energy", &error);
    if (phys_stepper_requirements(stepper, &params.it, 0.01, &state, &requirements, &error)) requirements.stages = 99;
    printf("%s %016" PRIx64 " energy %.17g lost %.17g scheme %.17g stages %u\n", id, phys_state_hash(&state), energy,
           report.it.lost_rolling, report.it.energy_scheme, requirements.stages);
    /* Shorter than any version. */
    params.it.struct_size = offsetof(phys_params, stepper);
    printf("%s\n", phys_status_name(phys_step(stepper, &params.it, 0.01, &state, &state, NULL, NULL)));
    phys_stepper_destroy(stepper);
    check_untouched(params.behind, "params");
    check_untouched(report.behind, "report");
}

/* Two balls through a batch: the states that single steps give. */
static void run_batch(const phys_registry *registry, const char *id, const phys_scene *scene) {
    GUARDED(phys_batch) batch;
    phys_params params;
    phys_stepper_info info;
    phys_stepper *stepper = NULL;
    phys_state states[2];
    phys_status statuses[2];
    phys_error error;
    memset(&batch, GUARD, sizeof batch);
    check_init(phys_batch_init(&batch.it, sizeof batch.it), "batch");
    check_init(phys_params_init(&params, sizeof params), "params");
    check(phys_registry_find(registry, id, &info, &error), "find", &error);
    check(phys_stepper_info_init_params(&info, &params), "init_params", &error);
    check(phys_stepper_create(registry, id, scene, &stepper, &error), id, &error);
    phys_scene_start(scene, &states[0]);
    phys_scene_start(scene, &states[1]);
    batch.it.ball_count = 2;
    batch.it.step_count = 100;
    batch.it.dt = 0.01;
    batch.it.params = &params;
    batch.it.states = states;
    batch.it.states_stride = sizeof states[0];
    batch.it.statuses = statuses;
    check(phys_batch_run(stepper, &batch.it, 0, 2, &error), "batch_run", &error);
    printf("%s batch %016" PRIx64 " %016" PRIx64 " %d %d\n", id, phys_state_hash(&states[0]),
           phys_state_hash(&states[1]), statuses[0], statuses[1]);
    phys_stepper_destroy(stepper);
    check_untouched(batch.behind, "batch");
}

int main(int argc, char **argv) {
    GUARDED(phys_scene_desc) desc;
    phys_scene *scene = NULL;
    phys_scene *level = NULL;
    phys_registry *registry = NULL;
    phys_stepper_info info;
    phys_error error;
    if (argc != 3) return 2;
    memset(&desc, GUARD, sizeof desc);
    check_init(phys_scene_desc_init(&desc.it, sizeof desc.it), "desc");
    check(phys_scene_load(argv[1], &level, &error), "load", &error);
    desc.it.boxes = phys_scene_boxes(level);
    desc.it.box_count = phys_scene_box_count(level);
    desc.it.radius = phys_scene_radius(level);
    phys_state start;
    phys_scene_start(level, &start);
    desc.it.start = start.position;
    check(phys_scene_create(&desc.it, &scene, &error), "create", &error);
    check(phys_registry_create(&registry, &error), "registry", &error);
    check(phys_registry_load_file(registry, argv[2], &error), "plugin", &error);
    for (uint32_t i = 0; phys_registry_info(registry, i, &info) == PHYS_OK; ++i) {
        roll(registry, info.id, scene);
        run_batch(registry, info.id, scene);
    }
    phys_registry_destroy(registry);
    phys_scene_destroy(scene);
    phys_scene_destroy(level);
    check_untouched(desc.behind, "desc");
    return 0;
}
