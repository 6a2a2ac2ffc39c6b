/* SPDX-License-Identifier: MIT */
/** @file
 *  libphysics: physics steps for one ball rolling in a maze of axis-aligned boxes.
 *
 *  A step takes an immutable scene, a plain and complete state, and parameters; it returns the next state:
 *
 *      phys_scene *scene;  phys_stepper *stepper;  phys_state state;  phys_params params;
 *      phys_scene_load("mazes/levels/01.txt", &scene, NULL);
 *      phys_stepper_create(NULL, PHYS_STEPPER_DEFAULT, scene, &stepper, NULL);
 *      phys_scene_start(scene, &state);
 *      phys_params_init(&params, sizeof params);
 *      phys_gravity_from_tilt(0.05, 0.0, 9.81, &params.gravity);
 *      while (!(state.flags & PHYS_OUT) && state.time < 60.0)
 *          phys_step(stepper, &params, 0.01, &state, &state, NULL, NULL);
 *      phys_stepper_destroy(stepper);
 *      phys_scene_destroy(scene);
 *
 *  Units are SI: m, s, m/s, rad/s. Energies are per mass, J/kg = m^2/s^2, because the mass cancels everywhere.
 *  Frame: fixed to the board; x to the right, y away from the viewer, z up from the floor. The board never moves in
 *  this frame: tilting it turns gravity. Formulas are derived in docs/model.md.
 *
 *  These rules hold for every function and are not repeated below:
 *  - A function that can fail returns a phys_status: PHYS_OK or a negative code. On failure every output is untouched,
 *    but for the contents of an event buffer.
 *  - `err` may be NULL. On failure it receives one line: what is wrong, which value, what is allowed. On success it is
 *    untouched. Without `err` are *_init, *_init_params, phys_gravity_from_tilt, phys_gravities_from_tilts,
 *    phys_scene_bounds, phys_scene_contacts, phys_scene_start, phys_energy and phys_registry_info: they fail only for a
 *    NULL, or for a value that isn't in the range stated with them.
 *  - Pointers must not be NULL unless the text says "or NULL". A NULL is reported as PHYS_ERROR_ARGUMENT.
 *  - Structs marked frozen never change. Appendable structs start with their size, get new members only at their end,
 *    and are filled by their *_init function. If an older program passes a shorter struct, the missing members have
 *    the values that *_init gives them. A struct longer than the library knows is refused.
 *  - Results don't depend on the locale or on the floating-point environment (rounding mode, flushed subnormals,
 *    trapped exceptions). A stack of 128 kB suffices.
 *  - Nothing prints, exits, aborts or throws. Only *_create, *_load, *_parse, *_destroy, phys_registry_load_file and
 *    phys_registry_scan allocate and free memory.
 *  - Scenes and registries are immutable once made and may be shared between threads; a stepper is used by one thread
 *    at a time. There are no globals.
 */
#ifndef PHYS_PHYSICS_H
#define PHYS_PHYSICS_H

#include <stddef.h>
#include <stdint.h>

#if defined(PHYS_STATIC)
#define PHYS_API
#elif defined(_WIN32) && defined(PHYS_EXPORTS) /* while the library itself is compiled */
#define PHYS_API __declspec(dllexport)
#elif defined(_WIN32)
#define PHYS_API __declspec(dllimport)
#elif defined(__GNUC__)
#define PHYS_API __attribute__((visibility("default")))
#else
#define PHYS_API
#endif

#ifdef __cplusplus
extern "C" {
#endif

/* ---------------------------------------------------------------------------------------------------- versions -- */

/** Number of the binary interface; equals the library's SONAME. Changes only when an old program would break. */
#define PHYS_ABI_VERSION 1

#define PHYS_VERSION_MAJOR 1 /**< of the header a program is compiled with */
#define PHYS_VERSION_MINOR 1 /**< likewise: grows when functions or members are added */
#define PHYS_VERSION_PATCH 0 /**< likewise */

/** The running library's version, for instance "1.1.0". Static text, never NULL. Any thread. Since 1.0. */
PHYS_API const char *phys_version(void);

/* ------------------------------------------------------------------------------------------------------ errors -- */

/** PHYS_OK (0) or a negative PHYS_ERROR_*. */
typedef int32_t phys_status;

/** The one list of codes: X(name, value, what it means). */
#define PHYS_STATUS_LIST(X)                                                                                            \
    X(PHYS_OK, 0, "success")                                                                                           \
    X(PHYS_ERROR_ARGUMENT, -1, "an argument is NULL, of the wrong size or outside its allowed range")                  \
    X(PHYS_ERROR_RANGE, -2, "a parameter is not a number or outside its allowed range")                                \
    X(PHYS_ERROR_STATE, -3, "the state, before or after the step, is not one that a ball can have")                    \
    X(PHYS_ERROR_MEMORY, -4, "out of memory")                                                                          \
    X(PHYS_ERROR_FILE, -5, "a file can't be read")                                                                     \
    X(PHYS_ERROR_SYNTAX, -6, "a file doesn't follow its format")                                                       \
    X(PHYS_ERROR_SCENE, -7, "the scene description is not valid")                                                      \
    X(PHYS_ERROR_UNKNOWN_STEPPER, -8, "no stepper has this id")                                                        \
    X(PHYS_ERROR_UNSUPPORTED, -9, "this stepper can't do what the scene, the parameters or the state ask for")         \
    X(PHYS_ERROR_STUCK, -10, "the ball is wedged where it doesn't fit")                                                \
    X(PHYS_ERROR_SUBSTEP_CAP, -11, "the ball is too fast for the step: too many substeps would be needed")             \
    X(PHYS_ERROR_EVENT_CAP, -12, "too many events in one step")                                                        \
    X(PHYS_ERROR_PLUGIN_REFUSED, -13, "a plugin was refused")                                                          \
    X(PHYS_ERROR_PLUGIN_RESULT, -14, "a plugin returned a result that isn't valid")                                    \
    X(PHYS_ERROR_INTERNAL, -15, "an error inside the library")

#define PHYS_STATUS_ENUMERATOR(name, value, text) name = value,
enum { PHYS_STATUS_LIST(PHYS_STATUS_ENUMERATOR) };
#undef PHYS_STATUS_ENUMERATOR

/** What a status means, in a few words. Static text; "unknown status" for other numbers. Any thread. Since 1.0. */
PHYS_API const char *phys_status_text(phys_status status);

/** A status's name, for instance "PHYS_ERROR_RANGE". Static text; "unknown" otherwise. Any thread. Since 1.0. */
PHYS_API const char *phys_status_name(phys_status status);

/** Details of a failure: frozen. The caller owns it; it needs no initialisation. */
typedef struct phys_error {
    phys_status status; /**< as the function returned it */
    int32_t reserved;   /**< 0 */
    char text[248];     /**< one line, NUL-terminated, UTF-8, cut if longer */
} phys_error;

/* -------------------------------------------------------------------------------------------- vectors and boxes -- */

/** A point, vector or axis in the board frame; frozen. */
typedef struct phys_vec3 {
    double x; /**< along the board, in the slope of tilt_x */
    double y; /**< along the board, in the slope of tilt_y */
    double z; /**< up from the floor, in the unit of x and y */
} phys_vec3;

/** An axis-aligned box, min <= max in each component; frozen. m */
typedef struct phys_box {
    phys_vec3 min; /**< corner of the least coordinates, m */
    phys_vec3 max; /**< corner of the greatest, m */
} phys_box;

/** The gravity vector (m/s^2, board frame) of a board tilted by two angles.
 *  tilt_x, tilt_y: rad, each between the doubles nearest to -pi/2 and pi/2, without these: the slope along x and along
 *  y; positive makes the ball roll towards +x and +y. strength: m/s^2, 0 .. 2^100. The result is strength * s / |s|
 *  with s = (tan tilt_x, tan tilt_y, -1). Any thread. Errors: ARGUMENT. Since 1.0. */
PHYS_API phys_status phys_gravity_from_tilt(double tilt_x, double tilt_y, double strength, phys_vec3 *out);

/** The same for `count` boards, as a batch wants it: out[i] (m/s^2) of tilts_x[i], tilts_y[i] (rad) and strengths[i]
 *  (m/s^2). Arrays may be NULL if count is 0. `out` must overlap none of the others. Any thread.
 *  Errors: ARGUMENT, where phys_gravity_from_tilt would fail for one of them. Since 1.1. */
PHYS_API phys_status phys_gravities_from_tilts(uint64_t count, const double *tilts_x, const double *tilts_y,
                                               const double *strengths, phys_vec3 *out);

/* ------------------------------------------------------------------------------------------------------- scenes -- */

/** Boxes, ball and start; immutable. Opaque. */
typedef struct phys_scene phys_scene;

/** Description of a scene: appendable. The boxes are copied. Boxes may touch and overlap. */
typedef struct phys_scene_desc {
    uint32_t struct_size;  /**< sizeof(phys_scene_desc), set by phys_scene_desc_init */
    uint32_t box_count;    /**< 0 .. 1,000,000 */
    const phys_box *boxes; /**< box_count of them, or NULL if there are none; |coordinates| <= 1e9 m */
    double radius;         /**< of the ball, m, 1e-9 .. 1e6, and at least 1e-12 of the largest coordinate */
    phys_vec3 start;       /**< centre of the ball at the start, m */
} phys_scene_desc;

/** Fills a description: no boxes, radius 0.006 m, start (0, 0, radius). size = sizeof(phys_scene_desc). Any thread.
 *  Errors: ARGUMENT. Since 1.0. */
PHYS_API phys_status phys_scene_desc_init(phys_scene_desc *desc, size_t size);

/** Makes a scene from a description: checks it, merges flush boxes, classifies floor and walls, builds the grid.
 *  The floor is what lies under the ball at its start: all boxes whose top is in that plane. A start beside all boxes
 *  is valid, too: such a scene has no floor, and the ball falls. Any thread.
 *  While it works it needs at most 1 MB plus 400 bytes per box, and a time of order n log n for n boxes.
 *  Errors: ARGUMENT, SCENE, MEMORY. Free it with phys_scene_destroy. Since 1.0. */
PHYS_API phys_status phys_scene_create(const phys_scene_desc *desc, phys_scene **out, phys_error *err);

/** Makes a scene from a maze text file (format: docs/maze_format.md). path: UTF-8. Any thread.
 *  Errors: ARGUMENT, FILE, SYNTAX (with file and line), SCENE, MEMORY. Since 1.0. */
PHYS_API phys_status phys_scene_load(const char *path, phys_scene **out, phys_error *err);

/** Makes a scene from the text of a maze file in memory (format: docs/maze_format.md). text: `size` bytes without a
 *  final NUL, or NULL with size 0. name: UTF-8, used in messages in place of a file's path, or NULL for "text".
 *  Any thread. Errors: ARGUMENT, SYNTAX (with name and line), SCENE, MEMORY. Since 1.1. */
PHYS_API phys_status phys_scene_parse(const char *text, size_t size, const char *name, phys_scene **out,
                                      phys_error *err);

/** Frees a scene; does nothing for NULL. All its steppers must have been destroyed, and no other thread may still use
 *  it. Since 1.0. */
PHYS_API void phys_scene_destroy(phys_scene *scene);

/** The ball's radius, m; 0 for NULL. Any thread. Since 1.0. */
PHYS_API double phys_scene_radius(const phys_scene *scene);

/** Number of boxes as given (not merged); 0 for NULL. Any thread. Since 1.0. */
PHYS_API uint32_t phys_scene_box_count(const phys_scene *scene);

/** The boxes as given, phys_scene_box_count of them, valid as long as the scene; NULL for NULL or without boxes.
 *  Box numbers in events, contacts and messages are indices into this array. Any thread. Since 1.0. */
PHYS_API const phys_box *phys_scene_boxes(const phys_scene *scene);

/** The smallest box around all boxes; all zero without boxes. Any thread. Errors: ARGUMENT. Since 1.0. */
PHYS_API phys_status phys_scene_bounds(const phys_scene *scene, phys_box *out);

/** Whether each box that reaches above the floor, and begins below the top of a ball on it, spans the height of the
 *  ball's centre: then none can lift or press down a ball that the floor carries (model.md 0). Boxes count wherever
 *  they are; gaps, steps and edges of the floor don't. PHYS_OK if so. Any thread. Errors: ARGUMENT; UNSUPPORTED with
 *  the box and the reason if it isn't. Since 1.0. */
PHYS_API phys_status phys_scene_check_planar(const phys_scene *scene, phys_error *err);

/** Kinds of feature of a box that the ball touches. */
enum { PHYS_FEATURE_FACE = 1, PHYS_FEATURE_EDGE = 2, PHYS_FEATURE_CORNER = 3, PHYS_FEATURE_INSIDE = 4 };

/** A box near the ball: frozen. */
typedef struct phys_contact {
    phys_vec3 point;  /**< nearest point of the box's surface, m */
    phys_vec3 normal; /**< unit, from the box to the ball's centre */
    double gap;       /**< distance between ball and box, m; negative: penetration */
    uint32_t box;     /**< number of the box */
    uint32_t feature; /**< PHYS_FEATURE_* */
} phys_contact;

/** All boxes, floors included, whose gap to a ball centred at `centre` is at most `reach` (m, >= 0, finite), in order
 *  of their numbers. Flush and identical boxes whose union is a box are one, with the number of that one of them that
 *  is nearest to the contact's point, the lowest of several. Writes at most `capacity` of them to `out` (or NULL if
 *  capacity is 0) and the number of all to `count`. The centre's coordinates must be within +-2^100 m. Any thread.
 *  Errors: ARGUMENT. Since 1.0. */
PHYS_API phys_status phys_scene_contacts(const phys_scene *scene, const phys_vec3 *centre, double reach,
                                         phys_contact *out, uint32_t capacity, uint32_t *count);

/* -------------------------------------------------------------------------------------------------------- state -- */

/** Flags of a state. Each step sets them; steppers never read them. */
enum {
    PHYS_AT_REST = 1,  /**< no velocity, no spin, and steps under the same gravity and parameters leave it at rest (but
                            one may be refused: for its size, or as a floor now carries the ball) */
    PHYS_AIRBORNE = 2, /**< not supported by a floor */
    PHYS_OUT = 4,      /**< out of the maze: seen from above, the centre is outside the bounds of all boxes */
    PHYS_SLIPPING = 8, /**< rigid model: the floor contact slips */
    PHYS_STATE_FLAGS = 15
};

/** Complete state of the ball: frozen, 128 bytes without padding, so that memcpy, memcmp and hashing work. All numbers
 *  are within +-2^100. */
typedef struct phys_state {
    double time;           /**< s since the start. While it equals step * dt but for rounding, phys_step makes it
                                (step + 1) * dt; otherwise it adds dt (model.md 10.6) */
    uint64_t step;         /**< steps since the start, modulo 2^64; phys_step adds one (none for dt = 0) */
    phys_vec3 position;    /**< of the centre, m */
    phys_vec3 velocity;    /**< m/s */
    phys_vec3 spin;        /**< angular velocity, rad/s; rolling model on the floor: follows from the velocity */
    double orientation[4]; /**< unit quaternion x y z w (its square is 1 but for at most 1e-6), for drawing: the motion
                                doesn't depend on it */
    uint64_t flags;        /**< PHYS_AT_REST | ... */
} phys_state;

/** The state at the start: at rest, time 0, no rotation. Any thread. Errors: ARGUMENT. Since 1.0. */
PHYS_API phys_status phys_scene_start(const phys_scene *scene, phys_state *out);

/** A 64-bit hash of all 128 bytes: FNV-1a over 16 words, each in little-endian order of bytes; 0 for NULL. Any thread.
 *  Since 1.0. */
PHYS_API uint64_t phys_state_hash(const phys_state *state);

/* --------------------------------------------------------------------------------------------------- parameters -- */

enum {
    PHYS_MODEL_ROLLING = 0, /**< the ball always rolls on the floor: spin follows from velocity (model.md 2.1) */
    PHYS_MODEL_RIGID = 1    /**< slip, spin and friction's torque (model.md 2.2) */
};

/** Bits of phys_params.options. */
enum {
    PHYS_OPTION_ORIENTATION = 1, /**< also integrate state.orientation, which only drawing needs */
    PHYS_OPTION_ALL_STAGES = 2,  /**< run every stage even if not required, for tests and benchmarks; same results
                                      in every step, but no limit of its time */
    PHYS_OPTIONS = 3
};

/** Greatest number of parameters of its own that a stepper can have. */
#define PHYS_STEPPER_VALUES 8

/** Parameters of a step: appendable. The rows of phys_param_rows say which values are allowed. */
typedef struct phys_params {
    uint32_t struct_size;                /**< sizeof(phys_params), set by phys_params_init */
    uint32_t model;                      /**< PHYS_MODEL_ROLLING or PHYS_MODEL_RIGID */
    phys_vec3 gravity;                   /**< m/s^2, board frame: tilt turns it; z < 0 while a floor supports */
    double restitution_wall;             /**< 0 .. 1 */
    double restitution_floor;            /**< 0 .. 1: when landing */
    double rolling_friction;             /**< >= 0: resistance / normal force; rigid: at most sliding_friction */
    double sliding_friction;             /**< >= 0: ball on floor, rigid model */
    double wall_friction;                /**< >= 0: ball on wall, rigid model */
    uint32_t options;                    /**< PHYS_OPTION_* */
    uint32_t reserved;                   /**< 0, not checked */
    double stepper[PHYS_STEPPER_VALUES]; /**< values of the stepper's own rows; others: 0, not checked */
} phys_params;

/** Fills params with each row's initial value, gravity (0, 0, -9.81), the rolling model, no options. size =
 *  sizeof(phys_params). Any thread. Errors: ARGUMENT. Since 1.0. */
PHYS_API phys_status phys_params_init(phys_params *params, size_t size);

/** Bits of phys_param_row.flags. */
enum {
    PHYS_ROW_CHOICE = 1, /**< whole numbers from min to max, stored as uint32_t; `choices` names them */
    PHYS_ROW_INPUT = 2,  /**< driven by the board's tilt rather than set by hand: gravity */
    PHYS_ROW_RIGID = 4,  /**< has an effect in the rigid model only */
    PHYS_ROW_SWITCH = 8  /**< 0 or 1, stored as double */
};

/** Description of one parameter: frozen. Texts are static, English, one line of UTF-8, never NULL. Functions take rows
 *  as the library gives them, or copies. */
typedef struct phys_param_row {
    const char *id;      /**< never changes; for settings, options and columns: rolling_friction */
    const char *label;   /**< for people: Rolling friction */
    const char *unit;    /**< "" if it has none */
    const char *help;    /**< its effect, its default, how to choose it */
    const char *choices; /**< names separated by '\n' for PHYS_ROW_CHOICE, otherwise "" */
    double min;          /**< least allowed value */
    double max;          /**< greatest allowed value */
    double low;          /**< least value a slider should offer */
    double high;         /**< greatest value a slider should offer */
    double initial;      /**< default value */
    double step;         /**< one notch of a slider */
    uint32_t offset;     /**< of the double (or uint32_t, see flags) in phys_params, bytes */
    uint32_t flags;      /**< PHYS_ROW_* */
} phys_param_row;

/** The library's own rows in the order of display; writes their number to `count`. Static. Any thread.
 *  Since 1.0. */
PHYS_API const phys_param_row *phys_param_rows(uint32_t *count);

/** Reads a row's value: its initial one if params is too short to have it; NaN for NULL. Any thread.
 *  Since 1.0. */
PHYS_API double phys_param_get(const phys_params *params, const phys_param_row *row);

/** Writes a row's value. Errors: ARGUMENT (also if params is too short to have it, or if the row's offset isn't that of
 *  a value), RANGE. Any thread. Since 1.0. */
PHYS_API phys_status phys_param_set(phys_params *params, const phys_param_row *row, double value, phys_error *err);

/** Whether a step would accept these parameters: sizes, ranges, relations between them. Errors: ARGUMENT, RANGE.
 *  Any thread. Since 1.0. */
PHYS_API phys_status phys_params_check(const phys_params *params, phys_error *err);

/* ------------------------------------------------------------------------------------------------------- report -- */

enum {
    PHYS_EVENT_IMPACT = 1,  /**< bounced off a wall */
    PHYS_EVENT_LANDING = 2, /**< bounced off or came down on a floor */
    PHYS_EVENT_TAKEOFF = 3, /**< left the floor */
    PHYS_EVENT_STOP = 4,    /**< came to rest */
    PHYS_EVENT_ROLL = 5,    /**< slip ended: the ball rolls from now on */
    PHYS_EVENT_CONTACT = 6, /**< "exact" only: stays in contact with a wall from now on */
    PHYS_EVENT_RELEASE = 7  /**< "exact" only: left a wall it was in contact with, without an impact */
};

/** An event during a step: frozen. */
typedef struct phys_event {
    double time;         /**< s since the start, as state.time */
    phys_vec3 point;     /**< of contact, m (the centre for events without one: takeoff, stop, roll) */
    phys_vec3 normal;    /**< unit, from the box to the ball (zero for events without one) */
    double speed_before; /**< impacts, landings: along the normal, < 0 (towards the box); others: |velocity|. m/s */
    double speed_after;  /**< impacts, landings: along the normal, >= 0; others: |velocity|. m/s */
    uint32_t kind;       /**< PHYS_EVENT_* */
    uint32_t box;        /**< number of the box, PHYS_NO_BOX for events without one */
} phys_event;

/** phys_event.box of an event without one. */
#define PHYS_NO_BOX 0xffffffffu

/** Report of a step: appendable. phys_report_init fills it, the caller then sets events and event_capacity; each
 *  successful step overwrites the rest (after a failed step the contents of the event buffer are undefined). Energies
 *  are per mass, J/kg, and balance:
 *  energy_before + energy_scheme = energy_after + lost_impact + lost_rolling + lost_slip. */
typedef struct phys_report {
    uint32_t struct_size;    /**< sizeof(phys_report), set by phys_report_init */
    uint32_t event_capacity; /**< how many events fit into the buffer */
    phys_event *events;      /**< the caller's buffer, or NULL: all events count as lost */
    uint32_t event_count;    /**< written to events, in order of time */
    uint32_t events_lost;    /**< further events, which didn't fit */
    uint32_t substeps;       /**< substeps the step was cut into; 1 for exact, 0 for dt = 0 */
    uint32_t substep_cap;    /**< a step that is still moving the ball after these fails with PHYS_ERROR_SUBSTEP_CAP; 0:
                                  no cap */
    uint32_t passes;         /**< most passes that resolving contacts took at one moment */
    uint32_t pass_cap;       /**< most passes tried: after them a ball without room fails with PHYS_ERROR_STUCK, and
                                  impacts that still approach end without a bounce; 0: a plugin without a cap */
    double penetration;      /**< deepest penetration before it was resolved, m, >= 0 */
    double energy_before;    /**< phys_energy of the given state with the step's gravity */
    double energy_after;     /**< phys_energy of the new state */
    double lost_impact;      /**< to impacts with walls and floors */
    double lost_rolling;     /**< to rolling resistance */
    double lost_slip;        /**< to friction of slipping contacts; rolling model: of landings, and of a given spin that
                                  isn't that of rolling, of either sign */
    double energy_scheme;    /**< gained (> 0) or lost (< 0) by the stepper's own error: the rest of the balance */
} phys_report;

/** Fills a report: no event buffer, all zero. size = sizeof(phys_report). Any thread. Errors: ARGUMENT. Since 1.0. */
PHYS_API phys_status phys_report_init(phys_report *report, size_t size);

/** Energy per mass, J/kg: v^2/2 + (R spin)^2/5 - gravity . position (model.md 9). For a rolling ball the first two are
 *  7/10 v^2. Position, velocity, spin and gravity must be within +-2^100. Any thread. Errors: ARGUMENT. Since 1.0. */
PHYS_API phys_status phys_energy(const phys_scene *scene, const phys_params *params, const phys_state *state,
                                 double *out);

/* ---------------------------------------------------------------------------------------- registry and steppers -- */

/** The steppers that can be made: the built-in ones and those of loaded plugins. Opaque. */
typedef struct phys_registry phys_registry;

/** Id of the stepper to use unless there is a reason for another one. */
#define PHYS_STEPPER_DEFAULT "symplectic-euler"

/** Bits of phys_stepper_info.flags. */
enum {
    PHYS_STEPPER_EXACT_IN_DT = 1,     /**< one step of any dt is as good as many small ones */
    PHYS_STEPPER_BITS_EVERYWHERE = 2, /**< made of + - x / sqrt alone: same bits on every system */
    PHYS_STEPPER_PLUGIN = 4           /**< comes from a plugin */
};

/** Description of a stepper: frozen. Texts live as long as the registry and are never NULL. */
typedef struct phys_stepper_info {
    const char *id;                    /**< never changes */
    const char *name;                  /**< for people */
    const char *version;               /**< changes when trajectories change */
    const char *summary;               /**< its purpose in one sentence */
    const char *file;                  /**< of the plugin; "" for built-in ones */
    const phys_param_row *const *rows; /**< of its own, row_count pointers */
    uint32_t row_count;                /**< 0 .. PHYS_STEPPER_VALUES */
    uint32_t flags;                    /**< PHYS_STEPPER_* */
} phys_stepper_info;

/** Makes a registry with the built-in steppers. Errors: MEMORY. Free it with phys_registry_destroy. Any thread.
 *  Since 1.0. */
PHYS_API phys_status phys_registry_create(phys_registry **out, phys_error *err);

/** Frees a registry; does nothing for NULL. All steppers made from it must have been destroyed, and no other thread may
 *  still use it. Loaded plugins stay loaded. Since 1.0. */
PHYS_API void phys_registry_destroy(phys_registry *registry);

/** Loads the plugin in one file and adds its steppers. Not while another thread uses the registry.
 *  Errors: ARGUMENT, FILE, MEMORY, PLUGIN_REFUSED with file, reason, expected and found. Since 1.0. */
PHYS_API phys_status phys_registry_load_file(phys_registry *registry, const char *path, phys_error *err);

/** Called once for each plugin file that a scan loads (PHYS_OK) or refuses; text: one line. */
typedef void (*phys_scan_function)(void *context, const char *path, phys_status status, const char *text);

/** Loads every *.so (Windows: *.dll) of a folder in order of name. Paths are UTF-8. folder NULL: the folders of
 *  PHYS_PLUGIN_PATH (separated by ':', on Windows by ';'), then `physics-1` beside the library. A refused file doesn't
 *  end the scan; `report` (or NULL) is called for each file, and with PHYS_ERROR_FILE for what is no folder in
 *  PHYS_PLUGIN_PATH. registry NULL: loads nothing and calls `report` with PHYS_OK and an empty text for each name that
 *  would be tried, whatever it is. So a host can first try each in a
 *  process of its own, because a damaged file may end the process that loads it. Not while another thread uses the
 *  registry. Errors: FILE (the folder doesn't exist), MEMORY. Since 1.0. */
PHYS_API phys_status phys_registry_scan(phys_registry *registry, const char *folder, phys_scan_function report,
                                        void *context, phys_error *err);

/** Number of steppers; registry NULL: of the built-in ones. Any thread. Since 1.0. */
PHYS_API uint32_t phys_registry_count(const phys_registry *registry);

/** Describes stepper `index`; the built-in ones come first, from crude to exact. registry, or NULL for the built-in
 *  ones. Errors: ARGUMENT. Any thread. Since 1.0. */
PHYS_API phys_status phys_registry_info(const phys_registry *registry, uint32_t index, phys_stepper_info *out);

/** Describes the stepper with this id. registry or NULL. Errors: ARGUMENT, UNKNOWN_STEPPER. Any thread. Since 1.0. */
PHYS_API phys_status phys_registry_find(const phys_registry *registry, const char *id, phys_stepper_info *out,
                                        phys_error *err);

/** Sets the stepper's own values in params to their rows' initial ones and all other own values to 0. Any thread.
 *  Errors: ARGUMENT (also for rows that no stepper can have), RANGE. Since 1.0. */
PHYS_API phys_status phys_stepper_info_init_params(const phys_stepper_info *info, phys_params *params);

/** Computes steps in one scene. Opaque. No result depends on earlier steps. */
typedef struct phys_stepper phys_stepper;

/** Makes a stepper for a scene; both registry (or NULL: the built-in steppers) and scene must outlive it. Any thread.
 *  Errors: ARGUMENT, UNKNOWN_STEPPER, UNSUPPORTED (it can't handle the scene; names the box), MEMORY. Since 1.0. */
PHYS_API phys_status phys_stepper_create(const phys_registry *registry, const char *id, const phys_scene *scene,
                                         phys_stepper **out, phys_error *err);

/** Frees a stepper; does nothing for NULL. No other thread may still use it. Since 1.0. */
PHYS_API void phys_stepper_destroy(phys_stepper *stepper);

/** One step of dt seconds (0 .. 2^100; 0 changes nothing). in and out may be the same; report or NULL.
 *  Allocates nothing. One thread at a time per stepper.
 *  Errors: ARGUMENT, RANGE, STATE, UNSUPPORTED, STUCK, SUBSTEP_CAP, EVENT_CAP, PLUGIN_RESULT. Since 1.0. */
PHYS_API phys_status phys_step(phys_stepper *stepper, const phys_params *params, double dt, const phys_state *in,
                               phys_state *out, phys_report *report, phys_error *err);

/* -------------------------------------------------------------------------------------- many balls, many steps -- */

/** Balls that take steps of the same size in one scene: appendable. phys_batch_init sets it up, the caller fills it and
 *  owns all arrays. Strides are in bytes from one element to the next, multiples of 8; arrays that are only read may
 *  have a stride of 0: one element for all. */
typedef struct phys_batch {
    uint32_t struct_size;       /**< sizeof(phys_batch), set by phys_batch_init */
    uint32_t stop_flags;        /**< a ball is done once its state has one of these flags, such as PHYS_OUT; 0: never */
    uint64_t ball_count;        /**< balls in the arrays below */
    uint64_t step_count;        /**< greatest number of steps of each ball, 0 .. 2^53 */
    double dt;                  /**< of each step, s, 0 .. 2^100 */
    const phys_params *params;  /**< of each ball */
    size_t params_stride;       /**< from ball to ball */
    const phys_vec3 *gravity;   /**< of each ball and step, m/s^2, in place of that of params; or NULL */
    size_t gravity_ball_stride; /**< from ball to ball */
    size_t gravity_step_stride; /**< from step to step */
    phys_state *states;         /**< of each ball: in, its start; out, the last good state */
    size_t states_stride;       /**< from ball to ball, at least sizeof(phys_state) */
    phys_state *path;           /**< out, or NULL: each ball's state after path_every, 2 path_every, ... steps */
    size_t path_ball_stride;    /**< from ball to ball; the states of one ball lie side by side */
    uint64_t path_every;        /**< 1 or more with a path: it has step_count / path_every states a ball */
    uint64_t *steps_done;       /**< out, of each ball, side by side; or NULL */
    phys_status *statuses;      /**< out, of each ball, side by side: PHYS_OK or why it stopped early; or NULL */
    uint64_t *impacts;          /**< of each ball, side by side: the number of its impacts is added; or NULL */
    double *energy_lost;        /**< likewise, J/kg: energy lost in impacts, rolling and slip is added; or NULL */
} phys_batch;

/** Fills a batch: no balls, no steps, no arrays. size = sizeof(phys_batch). Any thread. Errors: ARGUMENT. Since 1.1. */
PHYS_API phys_status phys_batch_init(phys_batch *batch, size_t size);

/** Runs the balls first .. first + count - 1 of a batch; each gets the same bits as by phys_step in a loop. A ball that
 *  fails keeps its last good state and its status, the others go on. The rest of its path, as of that of a ball that is
 *  done, repeats its last state. impacts and energy_lost are the sums of what the reports of phys_step would say:
 *  events PHYS_EVENT_IMPACT, not landings (of a step with more than 64 events, all after the 64th count as impacts).
 *  Without them steps are faster. Steps of dt = 0 are skipped, as are those of a built-in stepper that leave a ball at
 *  rest (while the time isn't step * dt, each still takes an addition). Allocates nothing. One thread at a time per
 * stepper; threads, each with a stepper of its own, may run disjoint ranges of one batch. Errors: ARGUMENT, RANGE (of
 * parameters that all balls share), with outputs untouched; if statuses is NULL, the error of the first ball that
 * fails, after all have run: its number and step, and what phys_step says of that step. Since 1.1. */
PHYS_API phys_status phys_batch_run(phys_stepper *stepper, const phys_batch *batch, uint64_t first, uint64_t count,
                                    phys_error *err);

/* ------------------------------------------------------------------------------------------------- requirements -- */

/** Stages of a step, as bits and as indices of phys_requirements.reasons. */
#define PHYS_STAGE_LIST(X)                                                                                             \
    X(PHYS_STAGE_VERTICAL, 0, "vertical motion")                                                                       \
    X(PHYS_STAGE_SUBSTEPS, 1, "substeps or continuous detection")                                                      \
    X(PHYS_STAGE_RESISTANCE, 2, "rolling resistance")                                                                  \
    X(PHYS_STAGE_SLIP, 3, "slip and spin")                                                                             \
    X(PHYS_STAGE_GRID, 4, "grid")                                                                                      \
    X(PHYS_STAGE_ORIENTATION, 5, "orientation")

#define PHYS_STAGE_ENUMERATOR(name, bit, text) name = 1 << bit,
enum { PHYS_STAGE_LIST(PHYS_STAGE_ENUMERATOR) PHYS_STAGE_COUNT = 6 };
#undef PHYS_STAGE_ENUMERATOR

/** The stages that the next step runs, and why: frozen. For dt = 0 none, and no substeps. */
typedef struct phys_requirements {
    uint32_t stages;                     /**< PHYS_STAGE_* bits of the stages that run */
    uint32_t substeps;                   /**< of the size that the step begins with; they end early if the ball
                                              comes to rest, so that more than the cap aren't always a failure */
    char reasons[PHYS_STAGE_COUNT][120]; /**< a sentence for each stage: why it runs or why not */
} phys_requirements;

/** Says which stages the step with these arguments needs. Errors: those of phys_step's checks of its arguments, and
 *  UNSUPPORTED for a plugin without this function. One thread at a time per stepper. Since 1.0. */
PHYS_API phys_status phys_stepper_requirements(const phys_stepper *stepper, const phys_params *params, double dt,
                                               const phys_state *state, phys_requirements *out, phys_error *err);

#ifdef __cplusplus
}
#endif

#endif
