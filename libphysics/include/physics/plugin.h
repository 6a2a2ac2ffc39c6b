/* SPDX-License-Identifier: MIT */
/** @file
 *  Interface of plugins. A plugin is a shared object that exports one constant table of steppers, the same table that
 *  the built-in steppers fill. It doesn't link to libphysics. It defines
 *
 *     const phys_plugin phys_plugin_entry = { PHYS_ABI_VERSION, sizeof(phys_plugin), 1, 0, steppers };
 *
 *  The table is checked before any of its functions is called, and read where it lies from then on: it must not change.
 *  The result of each step is checked before the caller gets it.
 *  But constructors, which run when a shared object is loaded, have run by then: load only files that you trust.
 */
#ifndef PHYS_PLUGIN_H
#define PHYS_PLUGIN_H

#include <physics/physics.h>

#ifdef __cplusplus
extern "C" {
#endif

/** A scene as a stepper sees it: appendable. It outlives the steppers made from it. All members may be read by any
 *  thread at any time. */
typedef struct phys_scene_view {
    uint32_t struct_size;  /**< sizeof(phys_scene_view) */
    uint32_t box_count;    /**< boxes as given to phys_scene_create */
    const phys_box *boxes; /**< box_count of them, m; NULL if there are none */
    double radius;         /**< of the ball, m */
    double floor_top;      /**< height of the floor's top, m; NaN if the start isn't over a floor */
    const void *scene;     /**< first argument of the two functions below */

    /** Numbers of the boxes that overlap or touch region, in ascending order: writes the lowest, at most capacity of
     *  them, to out (or NULL if capacity is 0) and returns how many there are; 0 for a region that isn't a box. */
    uint32_t (*query)(const void *scene, const phys_box *region, uint32_t *out, uint32_t capacity);

    /** As phys_scene_contacts, flush boxes as one: within reach (m) of a ball at centre. Returns how many. */
    uint32_t (*contacts)(const void *scene, const phys_vec3 *centre, double reach, phys_contact *out,
                         uint32_t capacity);
} phys_scene_view;

/** Ids that a stepper's own rows may not have, nor those of phys_param_rows: programs have options, settings and
 *  columns of these names, and the Python package's parameters have such attributes. */
#define PHYS_RESERVED_ROW_IDS                                                                                          \
    "all_levels", "all_stages", "autopilot", "box", "check", "compare", "compare_set", "compare_substeps", "copy",     \
        "csv", "csv_every", "dt", "duration", "energy", "event", "fit", "fit_for", "flags", "for", "force", "grab",    \
        "gravity", "headless", "help", "kind", "level", "list_parameters", "list_steppers", "maze", "names", "normal", \
        "orientation", "parameters", "plot", "plugin", "point", "position", "record", "replay", "report", "rows",      \
        "scene", "schedule", "seed", "shaders", "shape", "share", "speed", "spin", "start", "state", "step",           \
        "stepper", "steps", "theme", "tilt", "tilt_x", "tilt_y", "time", "track", "track_frame", "track_units",        \
        "trade", "under", "unknown", "velocity", "version", "view", "with_orientation", "within", "x", "y", "z"

/** One stepper: appendable. Texts are static, each one line of UTF-8. All functions are called by one thread at a time
 *  for one self; none may throw, exit or keep a pointer that it is given, except create the view. Required unless
 *  marked optional. */
typedef struct phys_stepper_api {
    uint32_t struct_size;              /**< sizeof(phys_stepper_api) */
    uint32_t flags;                    /**< PHYS_STEPPER_* without PHYS_STEPPER_PLUGIN */
    const char *id;                    /**< never changes, unique: lower case letters, digits, '-', 1 .. 63 bytes */
    const char *name;                  /**< for people, 1 .. 127 bytes */
    const char *version;               /**< changes when trajectories change, 1 .. 31 bytes */
    const char *summary;               /**< its purpose in one sentence, 0 .. 255 bytes */
    const phys_param_row *const *rows; /**< its own; offsets point into phys_params.stepper; NULL if there are none */
    uint32_t row_count;                /**< 0 .. PHYS_STEPPER_VALUES */
    uint32_t reserved;                 /**< 0 */

    /** Creates the stepper's own data for this scene and stores it in *self, which may stay NULL. */
    phys_status (*create)(const phys_scene_view *scene, void **self, phys_error *err);

    /** Frees what create has created. */
    void (*destroy)(void *self);

    /** As phys_step, with arguments already checked: pointers valid, dt > 0, in valid, params within their rows.
     *  in and out never overlap. err is never NULL, report may be. The host has copied *in to *out and advanced step
     *  and time: leave those two as they are. It computes the report's energies before and after itself. A result that
     *  isn't as physics.h says fails with PHYS_ERROR_PLUGIN_RESULT: numbers beyond 2^100 (energies 2^300); an
     *  orientation whose square is off 1 by more than 1e-6, or that has turned without PHYS_OPTION_ORIENTATION; a
     *  velocity or spin with PHYS_AT_REST; lost_impact, lost_rolling or penetration below 0, if only by rounding; an
     *  impact or landing without a box; a takeoff, stop or roll with one. */
    phys_status (*step)(void *self, const phys_params *params, double dt, const phys_state *in, phys_state *out,
                        phys_report *report, phys_error *err);

    /** Optional. As phys_stepper_requirements, with arguments already checked. */
    phys_status (*requirements)(void *self, const phys_params *params, double dt, const phys_state *state,
                                phys_requirements *out, phys_error *err);

    /** Optional. Extensions that later versions may ask for by name; NULL for those it doesn't have. */
    const void *(*extension)(void *self, const char *extension_id);
} phys_stepper_api;

/** A plugin's table: appendable. */
typedef struct phys_plugin {
    uint32_t abi_version;                    /**< PHYS_ABI_VERSION it was compiled with */
    uint32_t struct_size;                    /**< sizeof(phys_plugin) */
    uint32_t stepper_count;                  /**< 1 or more */
    uint32_t reserved;                       /**< 0 */
    const phys_stepper_api *const *steppers; /**< stepper_count pointers */
} phys_plugin;

/** Exports the table even where PHYS_API exports nothing, as in a host that links libphysics statically. */
#if defined(_WIN32)
#define PHYS_PLUGIN_API __declspec(dllexport)
#elif defined(__GNUC__)
#define PHYS_PLUGIN_API __attribute__((visibility("default")))
#else
#define PHYS_PLUGIN_API
#endif

/** The only symbol that a plugin exports. */
extern PHYS_PLUGIN_API const phys_plugin phys_plugin_entry;

/** Whether *pointer is long enough to have the optional function `slot`, and has it. */
#define PHYS_HAS_SLOT(type, pointer, slot)                                                                             \
    ((pointer)->struct_size >= offsetof(type, slot) + sizeof((pointer)->slot) && (pointer)->slot)

#ifdef __cplusplus
}
#endif

#endif
