/* SPDX-License-Identifier: MIT
 *
 * The binary layout of ABI 1, member by member. It compiles only while every line holds. Frozen structs keep every
 * line; appendable ones keep theirs and gain lines and size at their end. Two things differ between systems: the size P
 * of a pointer, and what 8-byte numbers are aligned to inside a struct, which is 4 on x86 of 32 bits and 8 elsewhere.
 */
#include <physics/plugin.h>

#define P sizeof(void *)
struct aligned_number {
    char before;
    double number;
};
#define NUMBER_AT(offset)                                                                                              \
    (((offset) + offsetof(struct aligned_number, number) - 1) & ~(offsetof(struct aligned_number, number) - 1))

#define SIZE(type, bytes) _Static_assert(sizeof(type) == (bytes), "size of " #type)
#define MEMBER(type, member, offset, bytes)                                                                            \
    _Static_assert(offsetof(type, member) == (offset) && sizeof(((type *)0)->member) == (bytes), #type "." #member)

/* frozen */
SIZE(phys_error, 256);
MEMBER(phys_error, status, 0, 4);
MEMBER(phys_error, reserved, 4, 4);
MEMBER(phys_error, text, 8, 248);

/* frozen */
SIZE(phys_vec3, 24);
MEMBER(phys_vec3, x, 0, 8);
MEMBER(phys_vec3, y, 8, 8);
MEMBER(phys_vec3, z, 16, 8);

/* frozen */
SIZE(phys_box, 48);
MEMBER(phys_box, min, 0, 24);
MEMBER(phys_box, max, 24, 24);

/* appendable */
SIZE(phys_scene_desc, NUMBER_AT(8 + P) + 32);
MEMBER(phys_scene_desc, struct_size, 0, 4);
MEMBER(phys_scene_desc, box_count, 4, 4);
MEMBER(phys_scene_desc, boxes, 8, P);
MEMBER(phys_scene_desc, radius, NUMBER_AT(8 + P), 8);
MEMBER(phys_scene_desc, start, NUMBER_AT(8 + P) + 8, 24);

/* frozen */
SIZE(phys_contact, 64);
MEMBER(phys_contact, point, 0, 24);
MEMBER(phys_contact, normal, 24, 24);
MEMBER(phys_contact, gap, 48, 8);
MEMBER(phys_contact, box, 56, 4);
MEMBER(phys_contact, feature, 60, 4);

/* frozen */
SIZE(phys_state, 128);
MEMBER(phys_state, time, 0, 8);
MEMBER(phys_state, step, 8, 8);
MEMBER(phys_state, position, 16, 24);
MEMBER(phys_state, velocity, 40, 24);
MEMBER(phys_state, spin, 64, 24);
MEMBER(phys_state, orientation, 88, 32);
MEMBER(phys_state, flags, 120, 8);

/* appendable */
SIZE(phys_params, 144);
MEMBER(phys_params, struct_size, 0, 4);
MEMBER(phys_params, model, 4, 4);
MEMBER(phys_params, gravity, 8, 24);
MEMBER(phys_params, restitution_wall, 32, 8);
MEMBER(phys_params, restitution_floor, 40, 8);
MEMBER(phys_params, rolling_friction, 48, 8);
MEMBER(phys_params, sliding_friction, 56, 8);
MEMBER(phys_params, wall_friction, 64, 8);
MEMBER(phys_params, options, 72, 4);
MEMBER(phys_params, reserved, 76, 4);
MEMBER(phys_params, stepper, 80, 64);

/* frozen */
SIZE(phys_param_row, NUMBER_AT(5 * P) + 56);
MEMBER(phys_param_row, id, 0, P);
MEMBER(phys_param_row, label, P, P);
MEMBER(phys_param_row, unit, 2 * P, P);
MEMBER(phys_param_row, help, 3 * P, P);
MEMBER(phys_param_row, choices, 4 * P, P);
MEMBER(phys_param_row, min, NUMBER_AT(5 * P), 8);
MEMBER(phys_param_row, max, NUMBER_AT(5 * P) + 8, 8);
MEMBER(phys_param_row, low, NUMBER_AT(5 * P) + 16, 8);
MEMBER(phys_param_row, high, NUMBER_AT(5 * P) + 24, 8);
MEMBER(phys_param_row, initial, NUMBER_AT(5 * P) + 32, 8);
MEMBER(phys_param_row, step, NUMBER_AT(5 * P) + 40, 8);
MEMBER(phys_param_row, offset, NUMBER_AT(5 * P) + 48, 4);
MEMBER(phys_param_row, flags, NUMBER_AT(5 * P) + 52, 4);

/* frozen */
SIZE(phys_event, 80);
MEMBER(phys_event, time, 0, 8);
MEMBER(phys_event, point, 8, 24);
MEMBER(phys_event, normal, 32, 24);
MEMBER(phys_event, speed_before, 56, 8);
MEMBER(phys_event, speed_after, 64, 8);
MEMBER(phys_event, kind, 72, 4);
MEMBER(phys_event, box, 76, 4);

/* appendable */
SIZE(phys_report, NUMBER_AT(32 + P) + 56);
MEMBER(phys_report, struct_size, 0, 4);
MEMBER(phys_report, event_capacity, 4, 4);
MEMBER(phys_report, events, 8, P);
MEMBER(phys_report, event_count, 8 + P, 4);
MEMBER(phys_report, events_lost, 12 + P, 4);
MEMBER(phys_report, substeps, 16 + P, 4);
MEMBER(phys_report, substep_cap, 20 + P, 4);
MEMBER(phys_report, passes, 24 + P, 4);
MEMBER(phys_report, pass_cap, 28 + P, 4);
MEMBER(phys_report, penetration, NUMBER_AT(32 + P), 8);
MEMBER(phys_report, energy_before, NUMBER_AT(32 + P) + 8, 8);
MEMBER(phys_report, energy_after, NUMBER_AT(32 + P) + 16, 8);
MEMBER(phys_report, lost_impact, NUMBER_AT(32 + P) + 24, 8);
MEMBER(phys_report, lost_rolling, NUMBER_AT(32 + P) + 32, 8);
MEMBER(phys_report, lost_slip, NUMBER_AT(32 + P) + 40, 8);
MEMBER(phys_report, energy_scheme, NUMBER_AT(32 + P) + 48, 8);

/* frozen */
SIZE(phys_stepper_info, 6 * P + 8);
MEMBER(phys_stepper_info, id, 0, P);
MEMBER(phys_stepper_info, name, P, P);
MEMBER(phys_stepper_info, version, 2 * P, P);
MEMBER(phys_stepper_info, summary, 3 * P, P);
MEMBER(phys_stepper_info, file, 4 * P, P);
MEMBER(phys_stepper_info, rows, 5 * P, P);
MEMBER(phys_stepper_info, row_count, 6 * P, 4);
MEMBER(phys_stepper_info, flags, 6 * P + 4, 4);

/* appendable */
SIZE(phys_batch, NUMBER_AT(NUMBER_AT(32 + 9 * P) + 8 + 2 * P) + 2 * P);
MEMBER(phys_batch, struct_size, 0, 4);
MEMBER(phys_batch, stop_flags, 4, 4);
MEMBER(phys_batch, ball_count, 8, 8);
MEMBER(phys_batch, step_count, 16, 8);
MEMBER(phys_batch, dt, 24, 8);
MEMBER(phys_batch, params, 32, P);
MEMBER(phys_batch, params_stride, 32 + P, P);
MEMBER(phys_batch, gravity, 32 + 2 * P, P);
MEMBER(phys_batch, gravity_ball_stride, 32 + 3 * P, P);
MEMBER(phys_batch, gravity_step_stride, 32 + 4 * P, P);
MEMBER(phys_batch, states, 32 + 5 * P, P);
MEMBER(phys_batch, states_stride, 32 + 6 * P, P);
MEMBER(phys_batch, path, 32 + 7 * P, P);
MEMBER(phys_batch, path_ball_stride, 32 + 8 * P, P);
MEMBER(phys_batch, path_every, NUMBER_AT(32 + 9 * P), 8);
MEMBER(phys_batch, steps_done, NUMBER_AT(32 + 9 * P) + 8, P);
MEMBER(phys_batch, statuses, NUMBER_AT(32 + 9 * P) + 8 + P, P);
MEMBER(phys_batch, impacts, NUMBER_AT(32 + 9 * P) + 8 + 2 * P, P);
MEMBER(phys_batch, energy_lost, NUMBER_AT(32 + 9 * P) + 8 + 3 * P, P);

/* frozen */
SIZE(phys_requirements, 728);
MEMBER(phys_requirements, stages, 0, 4);
MEMBER(phys_requirements, substeps, 4, 4);
MEMBER(phys_requirements, reasons, 8, 720);

/* appendable */
SIZE(phys_scene_view, NUMBER_AT(NUMBER_AT(8 + P) + 16 + 3 * P));
MEMBER(phys_scene_view, struct_size, 0, 4);
MEMBER(phys_scene_view, box_count, 4, 4);
MEMBER(phys_scene_view, boxes, 8, P);
MEMBER(phys_scene_view, radius, NUMBER_AT(8 + P), 8);
MEMBER(phys_scene_view, floor_top, NUMBER_AT(8 + P) + 8, 8);
MEMBER(phys_scene_view, scene, NUMBER_AT(8 + P) + 16, P);
MEMBER(phys_scene_view, query, NUMBER_AT(8 + P) + 16 + P, P);
MEMBER(phys_scene_view, contacts, NUMBER_AT(8 + P) + 16 + 2 * P, P);

/* appendable */
SIZE(phys_stepper_api, 16 + 10 * P);
MEMBER(phys_stepper_api, struct_size, 0, 4);
MEMBER(phys_stepper_api, flags, 4, 4);
MEMBER(phys_stepper_api, id, 8, P);
MEMBER(phys_stepper_api, name, 8 + P, P);
MEMBER(phys_stepper_api, version, 8 + 2 * P, P);
MEMBER(phys_stepper_api, summary, 8 + 3 * P, P);
MEMBER(phys_stepper_api, rows, 8 + 4 * P, P);
MEMBER(phys_stepper_api, row_count, 8 + 5 * P, 4);
MEMBER(phys_stepper_api, reserved, 12 + 5 * P, 4);
MEMBER(phys_stepper_api, create, 16 + 5 * P, P);
MEMBER(phys_stepper_api, destroy, 16 + 6 * P, P);
MEMBER(phys_stepper_api, step, 16 + 7 * P, P);
MEMBER(phys_stepper_api, requirements, 16 + 8 * P, P);
MEMBER(phys_stepper_api, extension, 16 + 9 * P, P);

/* appendable */
SIZE(phys_plugin, 16 + P);
MEMBER(phys_plugin, abi_version, 0, 4);
MEMBER(phys_plugin, struct_size, 4, 4);
MEMBER(phys_plugin, stepper_count, 8, 4);
MEMBER(phys_plugin, reserved, 12, 4);
MEMBER(phys_plugin, steppers, 16, P);

#define VALUE(name, value) _Static_assert((name) == (value), #name)

VALUE(PHYS_FEATURE_FACE, 1);
VALUE(PHYS_FEATURE_EDGE, 2);
VALUE(PHYS_FEATURE_CORNER, 3);
VALUE(PHYS_FEATURE_INSIDE, 4);
VALUE(PHYS_AT_REST, 1);
VALUE(PHYS_AIRBORNE, 2);
VALUE(PHYS_OUT, 4);
VALUE(PHYS_SLIPPING, 8);
VALUE(PHYS_STATE_FLAGS, 15);
VALUE(PHYS_MODEL_ROLLING, 0);
VALUE(PHYS_MODEL_RIGID, 1);
VALUE(PHYS_OPTION_ORIENTATION, 1);
VALUE(PHYS_OPTION_ALL_STAGES, 2);
VALUE(PHYS_OPTIONS, 3);
VALUE(PHYS_ROW_CHOICE, 1);
VALUE(PHYS_ROW_INPUT, 2);
VALUE(PHYS_ROW_RIGID, 4);
VALUE(PHYS_ROW_SWITCH, 8);
VALUE(PHYS_EVENT_IMPACT, 1);
VALUE(PHYS_EVENT_LANDING, 2);
VALUE(PHYS_EVENT_TAKEOFF, 3);
VALUE(PHYS_EVENT_STOP, 4);
VALUE(PHYS_EVENT_ROLL, 5);
VALUE(PHYS_EVENT_CONTACT, 6);
VALUE(PHYS_EVENT_RELEASE, 7);
VALUE(PHYS_STEPPER_EXACT_IN_DT, 1);
VALUE(PHYS_STEPPER_BITS_EVERYWHERE, 2);
VALUE(PHYS_STEPPER_PLUGIN, 4);
VALUE(PHYS_OK, 0);
VALUE(PHYS_ERROR_ARGUMENT, -1);
VALUE(PHYS_ERROR_RANGE, -2);
VALUE(PHYS_ERROR_STATE, -3);
VALUE(PHYS_ERROR_MEMORY, -4);
VALUE(PHYS_ERROR_FILE, -5);
VALUE(PHYS_ERROR_SYNTAX, -6);
VALUE(PHYS_ERROR_SCENE, -7);
VALUE(PHYS_ERROR_UNKNOWN_STEPPER, -8);
VALUE(PHYS_ERROR_UNSUPPORTED, -9);
VALUE(PHYS_ERROR_STUCK, -10);
VALUE(PHYS_ERROR_SUBSTEP_CAP, -11);
VALUE(PHYS_ERROR_EVENT_CAP, -12);
VALUE(PHYS_ERROR_PLUGIN_REFUSED, -13);
VALUE(PHYS_ERROR_PLUGIN_RESULT, -14);
VALUE(PHYS_ERROR_INTERNAL, -15);
VALUE(PHYS_STAGE_VERTICAL, 1);
VALUE(PHYS_STAGE_SUBSTEPS, 2);
VALUE(PHYS_STAGE_RESISTANCE, 4);
VALUE(PHYS_STAGE_SLIP, 8);
VALUE(PHYS_STAGE_GRID, 16);
VALUE(PHYS_STAGE_ORIENTATION, 32);
VALUE(PHYS_ABI_VERSION, 1);
VALUE(PHYS_STEPPER_VALUES, 8);
VALUE(PHYS_NO_BOX, 0xffffffffu);
