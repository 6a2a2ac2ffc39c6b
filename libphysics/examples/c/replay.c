/* SPDX-License-Identifier: MIT
 *
 * Makes the steps of a recording of the inspector again, by the C interface alone, and says whether each state has the
 * recorded bits: "same: 812 steps" (status 0), or the first step that differs (1). A file that isn't as
 * docs/recording_format.md says is refused with its line (2). Runs where the inspector doesn't.
 * Usage: replay RECORDING LEVEL...     the levels that it was made on; a stepper of a plugin is found if the plugin
 *                                      lies in a folder of PHYS_PLUGIN_PATH
 */
#include <physics/physics.h>

#include <errno.h>
#include <float.h>
#include <inttypes.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { SAME = 0, DIFFERS = 1, UNREADABLE = 2, MOST_FIELDS = 16 };

static const double SMALLEST_DT = 1e-6, LARGEST_DT = 10.0; /* s */

/* What the lines so far have said. */
typedef struct Replay {
    char **levels; /* file names */
    int level_count;
    bool makes_steps; /* false while the lines are only checked */
    phys_registry *registry;
    phys_scene *scene;
    phys_stepper *stepper; /* NULL: to be made for scene and stepper id */
    phys_stepper_info info;
    phys_params params;
    phys_state state;
    double dt; /* s; 0: not said yet */
    bool has_level, has_options, has_board;
    bool has_state; /* a level doesn't say where the ball is */
    bool is_open;   /* the last line was a step, so that the parameters are those of a step */
    bool is_whole;
    uint64_t steps;
    phys_error error;
} Replay;

/* ---- files ---- */

/* All bytes, to be freed, with room for one more; NULL if they can't be read. */
static char *read_all(const char *path, size_t *size) {
    FILE *file = fopen(path, "rb");
    char *bytes = NULL;
    size_t room = 0;
    *size = 0;
    while (file && !ferror(file) && !feof(file)) {
        char *more = realloc(bytes, room += 1 << 20);
        if (!more) break;
        bytes = more;
        *size += fread(bytes + *size, 1, room - 1 - *size, file);
    }
    const bool failed = !file || !feof(file);
    if (file) fclose(file);
    if (!failed) return bytes;
    free(bytes);
    return NULL;
}

/* FNV-1a, as phys_state_hash. */
static uint64_t hash_of(const char *bytes, size_t size) {
    uint64_t hash = UINT64_C(0xcbf29ce484222325);
    for (size_t i = 0; i < size; ++i) hash = (hash ^ (unsigned char)bytes[i]) * UINT64_C(0x100000001b3);
    return hash;
}

/* ---- fields ---- */

static int refuse(Replay *replay, const char *reason) {
    snprintf(replay->error.text, sizeof replay->error.text, "%s", reason);
    return UNREADABLE;
}

static int taken(phys_status status) { return status ? UNREADABLE : SAME; }

/* Cuts a text at its blanks. False unless that gives this many fields, none of them empty. */
static bool cut(char *text, char **fields, int count) {
    for (int i = 0; i < count; ++i) {
        char *end = strchr(text, ' ');
        if (!*text || end == text || (end == NULL) != (i == count - 1)) return false;
        fields[i] = text;
        if (!end) break;
        *end = '\0';
        text = end + 1;
    }
    return true;
}

/* This program never leaves the C locale: a decimal point is a point. */
static bool finite_number(const char *text, double *number) {
    char *end;
    if (*text == '+' || text[strspn(text, "+-.0123456789eE")]) return false; /* as 0x1p3, inf, nan */
    errno = 0;
    *number = strtod(text, &end);
    const bool is_lost = errno == ERANGE && (*number == 0.0 || *number > DBL_MAX || *number < -DBL_MAX);
    return end != text && !*end && !is_lost;
}

static bool finite_numbers(char **fields, int count, double *numbers) {
    for (int i = 0; i < count; ++i)
        if (!finite_number(fields[i], &numbers[i])) return false;
    return true;
}

static bool whole_number(const char *text, int base, uint64_t *number) {
    if (!*text || text[strspn(text, base == 16 ? "0123456789abcdefABCDEF" : "0123456789")]) return false;
    errno = 0;
    *number = strtoull(text, NULL, base);
    return errno != ERANGE;
}

static bool hash_number(const char *text, uint64_t *hash) { return strlen(text) == 16 && whole_number(text, 16, hash); }

/* ---- lines ---- */

static int take_nothing(Replay *replay, char **fields) {
    (void)replay, (void)fields;
    return SAME;
}

static int load_level(Replay *replay, uint64_t wanted) {
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

static int take_level(Replay *replay, char **fields) {
    uint64_t wanted;
    char *name = strchr(fields[0], ' ');
    if (!name || !name[1]) return refuse(replay, "expected 'level HASH FILE'");
    *name = '\0';
    if (!hash_number(fields[0], &wanted)) return refuse(replay, "expected a hash of 16 hexadecimal digits");
    replay->has_level = true;
    replay->has_state = false;
    return replay->makes_steps ? load_level(replay, wanted) : SAME;
}

static int take_stepper(Replay *replay, char **fields) {
    char *version = strchr(fields[0], ' ');
    if (!version || !version[1]) return refuse(replay, "expected 'stepper ID VERSION'");
    *version = '\0';
    phys_stepper_destroy(replay->stepper);
    replay->stepper = NULL;
    phys_status status = phys_registry_find(replay->registry, fields[0], &replay->info, &replay->error);
    return taken(status ? status : phys_stepper_info_init_params(&replay->info, &replay->params));
}

static int take_dt(Replay *replay, char **fields) {
    double dt;
    if (!finite_number(fields[0], &dt) || dt < SMALLEST_DT || dt > LARGEST_DT)
        return refuse(replay, "expected dt from 1e-06 to 10 s");
    replay->dt = dt;
    return SAME;
}

static int take_parameter(Replay *replay, char **fields) {
    double value;
    if (!replay->info.id) return refuse(replay, "expected 'stepper' before its parameters");
    if (!finite_number(fields[1], &value)) return refuse(replay, "expected a finite number");
    uint32_t count = 0;
    const phys_param_row *rows = phys_param_rows(&count);
    const phys_param_row *row = NULL;
    for (uint32_t i = 0; i < count; ++i)
        if (!(rows[i].flags & PHYS_ROW_INPUT) && !strcmp(rows[i].id, fields[0])) row = &rows[i];
    for (uint32_t i = 0; i < replay->info.row_count; ++i)
        if (!strcmp(replay->info.rows[i]->id, fields[0])) row = replay->info.rows[i];
    if (!row) return refuse(replay, "expected a parameter of the stepper");
    return taken(phys_param_set(&replay->params, row, value, &replay->error));
}

static int take_options(Replay *replay, char **fields) {
    uint64_t options;
    if (!whole_number(fields[0], 10, &options) || options > PHYS_OPTIONS)
        return refuse(replay, "expected options from 0 to 3");
    replay->params.options = (uint32_t)options;
    replay->has_options = true;
    return SAME;
}

/* The vector counts, not the tilts: with them another library may come to another one. */
static int take_board(Replay *replay, char **fields) {
    double n[6];
    phys_vec3 ignored;
    if (!finite_numbers(fields, 6, n)) return refuse(replay, "expected finite numbers");
    if (phys_gravity_from_tilt(n[0], n[1], n[2], &ignored))
        return refuse(replay, "expected two tilts within pi/2 and a strength >= 0");
    replay->params.gravity = (phys_vec3){n[3], n[4], n[5]};
    replay->has_board = true;
    return SAME;
}

/* Whether a ball can have this state: a step of dt 0 on an empty floor tells. */
static phys_status check_state(const phys_state *state, phys_error *error) {
    phys_scene_desc nothing;
    phys_params params;
    phys_scene *scene = NULL;
    phys_stepper *stepper = NULL;
    phys_state same;
    phys_scene_desc_init(&nothing, sizeof nothing);
    phys_params_init(&params, sizeof params);
    phys_status status = phys_scene_create(&nothing, &scene, error);
    if (!status) status = phys_stepper_create(NULL, PHYS_STEPPER_DEFAULT, scene, &stepper, error);
    if (!status) status = phys_step(stepper, &params, 0.0, state, &same, NULL, error);
    phys_stepper_destroy(stepper);
    phys_scene_destroy(scene);
    return status;
}

static int take_state(Replay *replay, char **fields) {
    double n[13];
    phys_state *state = &replay->state;
    if (!finite_number(fields[0], &state->time) || !finite_numbers(fields + 2, 13, n))
        return refuse(replay, "expected finite numbers");
    if (!whole_number(fields[1], 10, &state->step) || !whole_number(fields[15], 10, &state->flags))
        return refuse(replay, "expected step and flags as whole numbers");
    state->position = (phys_vec3){n[0], n[1], n[2]};
    state->velocity = (phys_vec3){n[3], n[4], n[5]};
    state->spin = (phys_vec3){n[6], n[7], n[8]};
    memcpy(state->orientation, n + 9, sizeof state->orientation);
    replay->has_state = true;
    return taken(check_state(state, &replay->error));
}

static int take_end(Replay *replay, char **fields) {
    (void)fields;
    replay->is_whole = true;
    return SAME;
}

/* ---- steps ---- */

/* Whether all is said that a step needs. */
static int check_conditions(Replay *replay) {
    const char *missing = !replay->has_level     ? "level"
                          : !replay->info.id     ? "stepper"
                          : !(replay->dt > 0.0)  ? "dt"
                          : !replay->has_options ? "options"
                          : !replay->has_board   ? "board"
                          : !replay->has_state   ? "state"
                                                 : NULL;
    if (missing) {
        snprintf(replay->error.text, sizeof replay->error.text, "expected '%s' before the first step", missing);
        return UNREADABLE;
    }
    return taken(phys_params_check(&replay->params, &replay->error));
}

/* The next state, if the step under all that was said doesn't fail. */
static int make_step(Replay *replay, phys_state *next, phys_status *status) {
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
    uint64_t wanted;
    phys_state next;
    phys_status status;
    char expected[17], found[17];
    if (!hash_number(line, &wanted)) return refuse(replay, "expected a hash of 16 hexadecimal digits");
    if (!replay->is_open && check_conditions(replay)) return UNREADABLE;
    replay->is_open = true;
    if (!replay->makes_steps) return SAME;
    if (make_step(replay, &next, &status)) return UNREADABLE;
    snprintf(expected, sizeof expected, "%016" PRIx64, wanted);
    if (status) return tell_difference(replay, expected, replay->error.text);
    snprintf(found, sizeof found, "%016" PRIx64, phys_state_hash(&next));
    if (strcmp(found, expected)) return tell_difference(replay, expected, found);
    replay->state = next;
    ++replay->steps;
    return SAME;
}

/* A step that failed left the state as it was. */
static int take_failure(Replay *replay, char **fields) {
    phys_state next;
    phys_status status;
    if (check_conditions(replay)) return UNREADABLE;
    if (!replay->makes_steps) return SAME;
    if (make_step(replay, &next, &status)) return UNREADABLE;
    if (!status) return tell_difference(replay, fields[0], "a step");
    return strcmp(replay->error.text, fields[0]) ? tell_difference(replay, fields[0], replay->error.text) : SAME;
}

/* ---- the recording ---- */

static const struct Rule {
    const char *word;
    int count; /* of fields after the word; -1: the rest of the line is one */
    const char *expected;
    int (*take)(Replay *replay, char **fields);
} rules[] = {
    {"program", -1, "expected 'program NAME VERSION'", take_nothing},
    {"library", 1, "expected 'library VERSION'", take_nothing},
    {"level", -1, "expected 'level HASH FILE'", take_level},
    {"stepper", -1, "expected 'stepper ID VERSION'", take_stepper},
    {"dt", 1, "expected 'dt SECONDS'", take_dt},
    {"set", 2, "expected 'set PARAMETER VALUE'", take_parameter},
    {"options", 1, "expected 'options BITS'", take_options},
    {"board", 6, "expected 'board' and 6 numbers", take_board},
    {"state", 16, "expected 'state' and 16 numbers", take_state},
    {"failed", -1, "expected 'failed REASON'", take_failure},
    {"end", 0, "expected 'end'", take_end},
};

static int take_word(Replay *replay, char *line) {
    char *fields[MOST_FIELDS];
    char *rest = strchr(line, ' ');
    if (rest) *rest++ = '\0';
    for (size_t i = 0; i < sizeof rules / sizeof *rules; ++i) {
        const struct Rule *rule = &rules[i];
        if (strcmp(line, rule->word)) continue;
        fields[0] = rest;
        const bool is_right = rule->count < 0    ? rest && *rest
                              : rule->count == 0 ? !rest
                                                 : rest && cut(rest, fields, rule->count);
        replay->is_open = false;
        return is_right ? rule->take(replay, fields) : refuse(replay, rule->expected);
    }
    return refuse(replay, "expected the hash of a step or a word as 'set'");
}

static int take_line(Replay *replay, char *line) {
    if (!*line || *line == '#') return SAME;
    if (replay->is_whole) return refuse(replay, "expected nothing after 'end'");
    return strlen(line) == 16 && !strchr(line, ' ') ? take_hash(replay, line) : take_word(replay, line);
}

/* What an interrupted program left of its last line is left out. */
static int take_lines(Replay *replay, char *text, size_t size, int *number) {
    char *line = text;
    for (*number = 1;; ++*number) {
        char *end = memchr(line, '\n', size - (size_t)(line - text));
        const bool is_last = !end;
        if (is_last && *number > 1) return SAME;
        if (is_last) end = text + size;
        *end = '\0';
        if (strlen(line) != (size_t)(end - line)) return refuse(replay, "expected text, found a NUL");
        for (char *last = end; last > line && last[-1] == '\r';) *--last = '\0';
        if (*number == 1 && strcmp(line, "physics-recording 1"))
            return refuse(replay, "expected 'physics-recording 1'");
        const int outcome = *number == 1 ? SAME : take_line(replay, line);
        if (outcome || is_last) return outcome;
        line = end + 1;
    }
}

/* makes_steps: otherwise the lines are only checked. */
static int run(const char *file, const Replay *given, bool makes_steps) {
    size_t size = 0;
    int number = 1;
    Replay replay = *given;
    replay.makes_steps = makes_steps;
    char *text = read_all(file, &size); /* anew, as the lines are cut where they lie */
    if (!text) return perror(file), UNREADABLE;
    const int outcome = take_lines(&replay, text, size, &number);
    if (outcome == UNREADABLE) fprintf(stderr, "%s:%d: %s\n", file, number, replay.error.text);
    if (outcome == SAME && makes_steps)
        printf("same: %" PRIu64 " steps%s\n", replay.steps,
               replay.is_whole ? "" : " (the recording is cut off after them)");
    free(text);
    phys_stepper_destroy(replay.stepper);
    phys_scene_destroy(replay.scene);
    return outcome;
}

int main(int argc, char **argv) {
    if (argc < 3) {
        fprintf(stderr, "usage: %s RECORDING LEVEL...\n", argv[0]);
        return UNREADABLE;
    }
    Replay replay = {.levels = argv + 2, .level_count = argc - 2};
    phys_params_init(&replay.params, sizeof replay.params);
    phys_status status = phys_registry_create(&replay.registry, &replay.error);
    if (!status) status = phys_registry_scan(replay.registry, NULL, NULL, NULL, &replay.error);
    if (status) fprintf(stderr, "%s\n", replay.error.text);
    int outcome = status ? UNREADABLE : run(argv[1], &replay, false);
    if (outcome == SAME) outcome = run(argv[1], &replay, true);
    if (fclose(stdout)) {
        perror("standard output");
        outcome = UNREADABLE;
    }
    phys_registry_destroy(replay.registry);
    return outcome;
}
