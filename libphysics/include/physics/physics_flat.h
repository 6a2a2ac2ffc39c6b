/* SPDX-License-Identifier: MIT
 *
 * The declarations of <physics/physics.h> without directives, for generators of bindings that have no preprocessor.
 * Made by libphysics/abi/flatten; documentation: physics.h. A program in C or C++ includes physics.h instead. */
/* clang-format off */
enum {
    PHYS_ABI_VERSION = 1,
    PHYS_VERSION_MAJOR = 1,
    PHYS_VERSION_MINOR = 1,
    PHYS_VERSION_PATCH = 0,
    PHYS_STEPPER_VALUES = 8
};
const char *phys_version(void);
typedef int32_t phys_status;
enum { PHYS_OK = 0, PHYS_ERROR_ARGUMENT = -1, PHYS_ERROR_RANGE = -2, PHYS_ERROR_STATE = -3, PHYS_ERROR_MEMORY = -4, PHYS_ERROR_FILE = -5, PHYS_ERROR_SYNTAX = -6, PHYS_ERROR_SCENE = -7, PHYS_ERROR_UNKNOWN_STEPPER = -8, PHYS_ERROR_UNSUPPORTED = -9, PHYS_ERROR_STUCK = -10, PHYS_ERROR_SUBSTEP_CAP = -11, PHYS_ERROR_EVENT_CAP = -12, PHYS_ERROR_PLUGIN_REFUSED = -13, PHYS_ERROR_PLUGIN_RESULT = -14, PHYS_ERROR_INTERNAL = -15 };
const char *phys_status_text(phys_status status);
const char *phys_status_name(phys_status status);
typedef struct phys_error {
    phys_status status;
    int32_t reserved;
    char text[248];
} phys_error;
typedef struct phys_vec3 {
    double x;
    double y;
    double z;
} phys_vec3;
typedef struct phys_box {
    phys_vec3 min;
    phys_vec3 max;
} phys_box;
phys_status phys_gravity_from_tilt(double tilt_x, double tilt_y, double strength, phys_vec3 *out);
phys_status phys_gravities_from_tilts(uint64_t count, const double *tilts_x, const double *tilts_y,
                                               const double *strengths, phys_vec3 *out);
typedef struct phys_scene phys_scene;
typedef struct phys_scene_desc {
    uint32_t struct_size;
    uint32_t box_count;
    const phys_box *boxes;
    double radius;
    phys_vec3 start;
} phys_scene_desc;
phys_status phys_scene_desc_init(phys_scene_desc *desc, size_t size);
phys_status phys_scene_create(const phys_scene_desc *desc, phys_scene **out, phys_error *err);
phys_status phys_scene_load(const char *path, phys_scene **out, phys_error *err);
phys_status phys_scene_parse(const char *text, size_t size, const char *name, phys_scene **out,
                                      phys_error *err);
void phys_scene_destroy(phys_scene *scene);
double phys_scene_radius(const phys_scene *scene);
uint32_t phys_scene_box_count(const phys_scene *scene);
const phys_box *phys_scene_boxes(const phys_scene *scene);
phys_status phys_scene_bounds(const phys_scene *scene, phys_box *out);
phys_status phys_scene_check_planar(const phys_scene *scene, phys_error *err);
enum { PHYS_FEATURE_FACE = 1, PHYS_FEATURE_EDGE = 2, PHYS_FEATURE_CORNER = 3, PHYS_FEATURE_INSIDE = 4 };
typedef struct phys_contact {
    phys_vec3 point;
    phys_vec3 normal;
    double gap;
    uint32_t box;
    uint32_t feature;
} phys_contact;
phys_status phys_scene_contacts(const phys_scene *scene, const phys_vec3 *centre, double reach,
                                         phys_contact *out, uint32_t capacity, uint32_t *count);
enum {
    PHYS_AT_REST = 1,
    PHYS_AIRBORNE = 2,
    PHYS_OUT = 4,
    PHYS_SLIPPING = 8,
    PHYS_STATE_FLAGS = 15
};
typedef struct phys_state {
    double time;
    uint64_t step;
    phys_vec3 position;
    phys_vec3 velocity;
    phys_vec3 spin;
    double orientation[4];
    uint64_t flags;
} phys_state;
phys_status phys_scene_start(const phys_scene *scene, phys_state *out);
uint64_t phys_state_hash(const phys_state *state);
enum {
    PHYS_MODEL_ROLLING = 0,
    PHYS_MODEL_RIGID = 1
};
enum {
    PHYS_OPTION_ORIENTATION = 1,
    PHYS_OPTION_ALL_STAGES = 2,
    PHYS_OPTIONS = 3
};
typedef struct phys_params {
    uint32_t struct_size;
    uint32_t model;
    phys_vec3 gravity;
    double restitution_wall;
    double restitution_floor;
    double rolling_friction;
    double sliding_friction;
    double wall_friction;
    uint32_t options;
    uint32_t reserved;
    double stepper[8];
} phys_params;
phys_status phys_params_init(phys_params *params, size_t size);
enum {
    PHYS_ROW_CHOICE = 1,
    PHYS_ROW_INPUT = 2,
    PHYS_ROW_RIGID = 4,
    PHYS_ROW_SWITCH = 8
};
typedef struct phys_param_row {
    const char *id;
    const char *label;
    const char *unit;
    const char *help;
    const char *choices;
    double min;
    double max;
    double low;
    double high;
    double initial;
    double step;
    uint32_t offset;
    uint32_t flags;
} phys_param_row;
const phys_param_row *phys_param_rows(uint32_t *count);
double phys_param_get(const phys_params *params, const phys_param_row *row);
phys_status phys_param_set(phys_params *params, const phys_param_row *row, double value, phys_error *err);
phys_status phys_params_check(const phys_params *params, phys_error *err);
enum {
    PHYS_EVENT_IMPACT = 1,
    PHYS_EVENT_LANDING = 2,
    PHYS_EVENT_TAKEOFF = 3,
    PHYS_EVENT_STOP = 4,
    PHYS_EVENT_ROLL = 5,
    PHYS_EVENT_CONTACT = 6,
    PHYS_EVENT_RELEASE = 7
};
typedef struct phys_event {
    double time;
    phys_vec3 point;
    phys_vec3 normal;
    double speed_before;
    double speed_after;
    uint32_t kind;
    uint32_t box;
} phys_event;
typedef struct phys_report {
    uint32_t struct_size;
    uint32_t event_capacity;
    phys_event *events;
    uint32_t event_count;
    uint32_t events_lost;
    uint32_t substeps;
    uint32_t substep_cap;
    uint32_t passes;
    uint32_t pass_cap;
    double penetration;
    double energy_before;
    double energy_after;
    double lost_impact;
    double lost_rolling;
    double lost_slip;
    double energy_scheme;
} phys_report;
phys_status phys_report_init(phys_report *report, size_t size);
phys_status phys_energy(const phys_scene *scene, const phys_params *params, const phys_state *state,
                                 double *out);
typedef struct phys_registry phys_registry;
enum {
    PHYS_STEPPER_EXACT_IN_DT = 1,
    PHYS_STEPPER_BITS_EVERYWHERE = 2,
    PHYS_STEPPER_PLUGIN = 4
};
typedef struct phys_stepper_info {
    const char *id;
    const char *name;
    const char *version;
    const char *summary;
    const char *file;
    const phys_param_row *const *rows;
    uint32_t row_count;
    uint32_t flags;
} phys_stepper_info;
phys_status phys_registry_create(phys_registry **out, phys_error *err);
void phys_registry_destroy(phys_registry *registry);
phys_status phys_registry_load_file(phys_registry *registry, const char *path, phys_error *err);
typedef void (*phys_scan_function)(void *context, const char *path, phys_status status, const char *text);
phys_status phys_registry_scan(phys_registry *registry, const char *folder, phys_scan_function report,
                                        void *context, phys_error *err);
uint32_t phys_registry_count(const phys_registry *registry);
phys_status phys_registry_info(const phys_registry *registry, uint32_t index, phys_stepper_info *out);
phys_status phys_registry_find(const phys_registry *registry, const char *id, phys_stepper_info *out,
                                        phys_error *err);
phys_status phys_stepper_info_init_params(const phys_stepper_info *info, phys_params *params);
typedef struct phys_stepper phys_stepper;
phys_status phys_stepper_create(const phys_registry *registry, const char *id, const phys_scene *scene,
                                         phys_stepper **out, phys_error *err);
void phys_stepper_destroy(phys_stepper *stepper);
phys_status phys_step(phys_stepper *stepper, const phys_params *params, double dt, const phys_state *in,
                               phys_state *out, phys_report *report, phys_error *err);
typedef struct phys_batch {
    uint32_t struct_size;
    uint32_t stop_flags;
    uint64_t ball_count;
    uint64_t step_count;
    double dt;
    const phys_params *params;
    size_t params_stride;
    const phys_vec3 *gravity;
    size_t gravity_ball_stride;
    size_t gravity_step_stride;
    phys_state *states;
    size_t states_stride;
    phys_state *path;
    size_t path_ball_stride;
    uint64_t path_every;
    uint64_t *steps_done;
    phys_status *statuses;
    uint64_t *impacts;
    double *energy_lost;
} phys_batch;
phys_status phys_batch_init(phys_batch *batch, size_t size);
phys_status phys_batch_run(phys_stepper *stepper, const phys_batch *batch, uint64_t first, uint64_t count,
                                    phys_error *err);
enum { PHYS_STAGE_VERTICAL = 1 << 0, PHYS_STAGE_SUBSTEPS = 1 << 1, PHYS_STAGE_RESISTANCE = 1 << 2, PHYS_STAGE_SLIP = 1 << 3, PHYS_STAGE_GRID = 1 << 4, PHYS_STAGE_ORIENTATION = 1 << 5, PHYS_STAGE_COUNT = 6 };
typedef struct phys_requirements {
    uint32_t stages;
    uint32_t substeps;
    char reasons[PHYS_STAGE_COUNT][120];
} phys_requirements;
phys_status phys_stepper_requirements(const phys_stepper *stepper, const phys_params *params, double dt,
                                               const phys_state *state, phys_requirements *out, phys_error *err);
