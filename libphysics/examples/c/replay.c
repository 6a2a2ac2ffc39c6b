/* SPDX-License-Identifier: MIT
 *
 * Makes the steps of a recording of the inspector again, by the C interface alone, and says whether each state has the
 * recorded bits: "same: 812 steps" (status 0), or the first step that differs (1). Runs where the inspector doesn't.
 * Usage: replay RECORDING LEVEL...     the levels that it was made on; a stepper of a plugin is found if the plugin
 *                                      lies in a folder of PHYS_PLUGIN_PATH
 */
#include <physics/physics.h>

#include <inttypes.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { SAME = 0, DIFFERS = 1, UNREADABLE = 2, LONGEST_LINE = 65536, MOST_NUMBERS = 16 };

/* What the lines so far have said. */
typedef struct Replay {
    char **levels; /* file names */
    int level_count;
    phys_registry *registry;
    phys_scene *scene;
    phys_stepper *stepper; /* NULL: to be made for scene and stepper id */
    phys_stepper_info info;
    phys_params params;
    phys_state state;
    double dt; /* s */
    uint64_t steps;
    bool has_state; /* a level doesn't say where the ball is */
    bool is_whole;
    phys_error error;
} Replay;

/* ---- files ---- */

/* All bytes, to be freed; NULL if they can't be read. */
static char *read_all(const char *path, size_t *size) {
    FILE *file = fopen(path, "rb");
    char *bytes = NULL;
    size_t room = 0;
    *size = 0;
    while (file && !ferror(file) && !feof(file)) {
        char *more = realloc(bytes, room += 1 << 20);
        if (!more) break;
        bytes = more;
        *size += fread(bytes + *size, 1, room - *size, file);
    }
    if (file) fclose(file);
    return bytes;
}

/* FNV-1a, as phys_state_hash. */
static uint64_t hash_of(const char *bytes, size_t size) {
    uint64_t hash = UINT64_C(0xcbf29ce484222325);
    for (size_t i = 0; i < size; ++i) hash = (hash ^ (unsigned char)bytes[i]) * UINT64_C(0x100000001b3);
    return hash;
}

/* ---- lines ---- */

static int refuse(Replay *replay, const char *reason) {
    snprintf(replay->error.text, sizeof replay->error.text, "%s", reason);
    return UNREADABLE;
}

static int taken(phys_status status) { return status ? UNREADABLE : SAME; }

/* As many as there are, up to MOST_NUMBERS. This program never leaves the C locale: a decimal point is a point. */
static int numbers_in(const char *text, double *numbers) {
    int count = 0;
    for (char *end; count < MOST_NUMBERS; text = end, ++count) {
        numbers[count] = strtod(text, &end);
        if (end == text) break;
    }
    return count;
}

static bool has_one_number(const char *text, double *number) {
    double numbers[MOST_NUMBERS];
    const int count = numbers_in(text, numbers);
    if (count == 1) *number = numbers[0];
    return count == 1;
}

static int take_level(Replay *replay, const char *rest) {
    const uint64_t wanted = strtoull(rest, NULL, 16);
    replay->has_state = false;
    for (int i = 0; i < replay->level_count; ++i) {
        size_t size = 0;
        char *text = read_all(replay->levels[i], &size);
        const bool is_it = text && hash_of(text, size) == wanted;
        phys_status status = PHYS_OK;
        if (is_it) {
            phys_stepper_destroy(replay->stepper);
            phys_scene_destroy(replay->scene);
            replay->stepper = NULL;
            replay->scene = NULL;
            status = phys_scene_parse(text, size, replay->levels[i], &replay->scene, &replay->error);
        }
        free(text);
        if (is_it) return taken(status);
    }
    return refuse(replay, "none of the levels given has the hash in this line");
}

static int take_stepper(Replay *replay, const char *rest) {
    char id[64];
    if (sscanf(rest, "%63s", id) != 1) return refuse(replay, "expected 'stepper ID VERSION'");
    phys_stepper_destroy(replay->stepper);
    replay->stepper = NULL;
    phys_status status = phys_registry_find(replay->registry, id, &replay->info, &replay->error);
    return taken(status ? status : phys_stepper_info_init_params(&replay->info, &replay->params));
}

static int take_parameter(Replay *replay, const char *rest) {
    char id[64];
    int length = 0;
    double value;
    if (sscanf(rest, "%63s%n", id, &length) != 1 || !has_one_number(rest + length, &value))
        return refuse(replay, "expected 'set PARAMETER VALUE'");
    uint32_t count = 0;
    const phys_param_row *rows = phys_param_rows(&count);
    const phys_param_row *row = NULL;
    for (uint32_t i = 0; i < count; ++i)
        if (!strcmp(rows[i].id, id)) row = &rows[i];
    for (uint32_t i = 0; i < replay->info.row_count; ++i)
        if (!strcmp(replay->info.rows[i]->id, id)) row = replay->info.rows[i];
    if (!row) return refuse(replay, "no such parameter");
    return taken(phys_param_set(&replay->params, row, value, &replay->error));
}

/* The vector counts, not the tilts: with them another library may come to another one. */
static int take_board(Replay *replay, const char *rest) {
    double n[MOST_NUMBERS];
    if (numbers_in(rest, n) != 6) return refuse(replay, "expected 'board' and 6 numbers");
    replay->params.gravity = (phys_vec3){n[3], n[4], n[5]};
    return SAME;
}

static int take_state(Replay *replay, const char *rest) {
    double n[MOST_NUMBERS];
    phys_state *state = &replay->state;
    if (numbers_in(rest, n) != 16) return refuse(replay, "expected 'state' and 16 numbers");
    sscanf(rest, "%*s %" SCNu64, &state->step); /* a double doesn't hold every whole number */
    state->time = n[0];
    state->position = (phys_vec3){n[2], n[3], n[4]};
    state->velocity = (phys_vec3){n[5], n[6], n[7]};
    state->spin = (phys_vec3){n[8], n[9], n[10]};
    memcpy(state->orientation, n + 11, sizeof state->orientation);
    state->flags = (uint64_t)n[15];
    replay->has_state = true;
    return SAME;
}

/* ---- steps ---- */

/* The next state, if the step under all that was said doesn't fail; UNREADABLE if not all was said. */
static int make_step(Replay *replay, phys_state *next, phys_status *status) {
    if (!replay->scene || !replay->info.id || !replay->has_state || !(replay->dt > 0.0))
        return refuse(replay, "a step before level, stepper, dt and state");
    if (!replay->stepper &&
        phys_stepper_create(replay->registry, replay->info.id, replay->scene, &replay->stepper, &replay->error))
        return UNREADABLE;
    *status = phys_step(replay->stepper, &replay->params, replay->dt, &replay->state, next, NULL, &replay->error);
    return SAME;
}

static int tell_difference(const Replay *replay, const char *expected, const char *found) {
    printf("differs: step %" PRIu64 " of the recording, step %" PRIu64 " since the start, from %.9g s on: expected %s, "
           "found %s\n",
           replay->steps + 1, replay->state.step + 1, replay->state.time, expected, found);
    return DIFFERS;
}

static int take_hash(Replay *replay, const char *line) {
    phys_state next;
    phys_status status;
    char found[17];
    if (make_step(replay, &next, &status)) return UNREADABLE;
    if (status) return tell_difference(replay, line, replay->error.text);
    snprintf(found, sizeof found, "%016" PRIx64, phys_state_hash(&next));
    if (strcmp(found, line)) return tell_difference(replay, line, found);
    replay->state = next;
    ++replay->steps;
    return SAME;
}

/* A step that failed left the state as it was. */
static int take_failure(Replay *replay, const char *rest) {
    phys_state next;
    phys_status status;
    if (make_step(replay, &next, &status)) return UNREADABLE;
    if (!status) return tell_difference(replay, rest, "a step");
    return strcmp(replay->error.text, rest) ? tell_difference(replay, rest, replay->error.text) : SAME;
}

/* ---- the recording ---- */

static int take_line(Replay *replay, char *line) {
    char *rest = strchr(line, ' ');
    if (!*line || *line == '#') return SAME;
    if (!rest && strlen(line) == 16) return take_hash(replay, line);
    if (rest) *rest++ = '\0';
    if (!strcmp(line, "end")) return replay->is_whole = true, SAME;
    if (!rest) return refuse(replay, "expected the hash of a step or a word as 'set'");
    if (!strcmp(line, "program") || !strcmp(line, "library")) return SAME;
    if (!strcmp(line, "level")) return take_level(replay, rest);
    if (!strcmp(line, "stepper")) return take_stepper(replay, rest);
    if (!strcmp(line, "set")) return take_parameter(replay, rest);
    if (!strcmp(line, "board")) return take_board(replay, rest);
    if (!strcmp(line, "state")) return take_state(replay, rest);
    if (!strcmp(line, "failed")) return take_failure(replay, rest);
    if (!strcmp(line, "options")) return replay->params.options = (uint32_t)strtoul(rest, NULL, 10), SAME;
    if (!strcmp(line, "dt") && has_one_number(rest, &replay->dt)) return SAME;
    return refuse(replay, "expected the hash of a step or a word as 'set'");
}

/* What an interrupted program left of its last line is left out. */
static int run(Replay *replay, FILE *file, int *number) {
    static char line[LONGEST_LINE];
    for (*number = 1; fgets(line, sizeof line, file); ++*number) {
        char *end = line + strcspn(line, "\r\n");
        if (!strchr(end, '\n')) return feof(file) ? SAME : refuse(replay, "the line is too long");
        *end = '\0';
        if (*number == 1 && strcmp(line, "physics-recording 1"))
            return refuse(replay, "expected 'physics-recording 1'");
        const int outcome = *number == 1 ? SAME : take_line(replay, line);
        if (outcome) return outcome;
    }
    return *number > 1 ? SAME : refuse(replay, "expected 'physics-recording 1'");
}

int main(int argc, char **argv) {
    if (argc < 3) {
        fprintf(stderr, "usage: %s RECORDING LEVEL...\n", argv[0]);
        return UNREADABLE;
    }
    FILE *file = fopen(argv[1], "rb");
    if (!file) {
        perror(argv[1]);
        return UNREADABLE;
    }
    Replay replay = {.levels = argv + 2, .level_count = argc - 2};
    int number = 1;
    phys_params_init(&replay.params, sizeof replay.params);
    phys_status status = phys_registry_create(&replay.registry, &replay.error);
    if (!status) status = phys_registry_scan(replay.registry, NULL, NULL, NULL, &replay.error);
    int outcome = status ? UNREADABLE : run(&replay, file, &number);
    if (outcome == UNREADABLE) fprintf(stderr, "%s:%d: %s\n", argv[1], number, replay.error.text);
    if (outcome == SAME)
        printf("same: %" PRIu64 " steps%s\n", replay.steps,
               replay.is_whole ? "" : " (the recording is cut off after them)");
    if (fclose(stdout)) outcome = UNREADABLE;
    fclose(file);
    phys_stepper_destroy(replay.stepper);
    phys_scene_destroy(replay.scene);
    phys_registry_destroy(replay.registry);
    return outcome;
}
