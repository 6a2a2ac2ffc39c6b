/* SPDX-License-Identifier: MIT
 * A plugin that is right in everything, unless one member is defined otherwise when it is compiled. */
#include <physics/plugin.h>

#include <math.h>

#ifndef ENTRY
#define ENTRY phys_plugin_entry
#endif
#ifndef ABI_VERSION
#define ABI_VERSION PHYS_ABI_VERSION
#endif
#ifndef PLUGIN_SIZE
#define PLUGIN_SIZE sizeof(phys_plugin)
#endif
#ifndef PLUGIN_RESERVED
#define PLUGIN_RESERVED 0
#endif
#ifndef STEPPER_COUNT
#define STEPPER_COUNT 1
#endif
#ifndef STEPPERS
#define STEPPERS steppers
#endif
#ifndef FIRST_STEPPER
#define FIRST_STEPPER &stepper
#endif
#ifndef STEPPER_SIZE
#define STEPPER_SIZE sizeof(phys_stepper_api)
#endif
#ifndef FLAGS
#define FLAGS PHYS_STEPPER_BITS_EVERYWHERE
#endif
#ifndef ID
#define ID "good"
#endif
#ifndef NAME
#define NAME "Good"
#endif
#ifndef VERSION
#define VERSION "1"
#endif
#ifndef SUMMARY
#define SUMMARY "Leaves the ball where it is."
#endif
#ifndef ROWS
#define ROWS rows
#endif
#ifndef ROW_COUNT
#define ROW_COUNT 2
#endif
#ifndef FIRST_ROW
#define FIRST_ROW &first_row
#endif
#ifndef STEPPER_RESERVED
#define STEPPER_RESERVED 0
#endif
#ifndef CREATE
#define CREATE create
#endif
#ifndef DESTROY
#define DESTROY destroy
#endif
#ifndef STEP
#define STEP step
#endif
#ifndef ROW_ID
#define ROW_ID "air_drag"
#endif
#ifndef ROW_LABEL
#define ROW_LABEL "Air drag"
#endif
#ifndef ROW_UNIT
#define ROW_UNIT "1/m"
#endif
#ifndef ROW_HELP
#define ROW_HELP "Default: 0."
#endif
#ifndef ROW_CHOICES
#define ROW_CHOICES ""
#endif
#ifndef ROW_MIN
#define ROW_MIN 0.0
#endif
#ifndef ROW_MAX
#define ROW_MAX 10.0
#endif
#ifndef ROW_LOW
#define ROW_LOW 0.0
#endif
#ifndef ROW_HIGH
#define ROW_HIGH 1.0
#endif
#ifndef ROW_INITIAL
#define ROW_INITIAL 0.5
#endif
#ifndef ROW_STEP
#define ROW_STEP 0.1
#endif
#ifndef ROW_OFFSET
#define ROW_OFFSET offsetof(phys_params, stepper)
#endif
#ifndef ROW_FLAGS
#define ROW_FLAGS 0
#endif

#define HUNDRED_BYTES                                                                                                  \
    "0123456789012345678901234567890123456789012345678901234567890123456789012345678901234567890123456789"

static phys_status create(const phys_scene_view *scene, void **self, phys_error *err) {
    (void)scene;
    (void)self;
    (void)err;
    return PHYS_OK;
}

static void destroy(void *self) { (void)self; }

static phys_status step(void *self, const phys_params *params, double dt, const phys_state *in, phys_state *out,
                        phys_report *report, phys_error *err) {
    (void)self;
    (void)params;
    (void)dt;
    (void)in;
    (void)out;
    (void)report;
    (void)err;
    return PHYS_OK;
}

static const phys_param_row first_row = {ROW_ID,  ROW_LABEL, ROW_UNIT,    ROW_HELP, ROW_CHOICES, ROW_MIN,  ROW_MAX,
                                         ROW_LOW, ROW_HIGH,  ROW_INITIAL, ROW_STEP, ROW_OFFSET,  ROW_FLAGS};
static const phys_param_row second_row = {"order",
                                          "Order",
                                          "",
                                          "Default: second.",
                                          "First\nSecond",
                                          0.0,
                                          1.0,
                                          0.0,
                                          1.0,
                                          1.0,
                                          1.0,
                                          offsetof(phys_params, stepper) + sizeof(double),
                                          PHYS_ROW_CHOICE};
static const phys_param_row *const rows[] = {FIRST_ROW, &second_row};

static const phys_stepper_api stepper = {STEPPER_SIZE,     FLAGS,  ID,      NAME, VERSION, SUMMARY, ROWS, ROW_COUNT,
                                         STEPPER_RESERVED, CREATE, DESTROY, STEP, NULL,    NULL};
static const phys_stepper_api *const steppers[] = {FIRST_STEPPER, &stepper};

/* Some members are not used by some fixtures; the compiler must not mind. */
const void *const fixture_uses[] = {&first_row, &second_row, rows, &stepper, steppers};
void (*const fixture_functions[])(void) = {(void (*)(void))create, (void (*)(void))destroy, (void (*)(void))step};

extern PHYS_PLUGIN_API const phys_plugin ENTRY;
const phys_plugin ENTRY = {ABI_VERSION, PLUGIN_SIZE, STEPPER_COUNT, PLUGIN_RESERVED, STEPPERS};
