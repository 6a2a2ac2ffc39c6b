/* SPDX-License-Identifier: MIT
 *
 * A stepper as a plugin: rolling with air drag, k |v| v per mass, which none of the built-in steppers knows. It chooses
 * its substeps itself: an embedded Runge-Kutta pair of orders 3 and 2 (Bogacki and Shampine) keeps the error of each
 * substep below a tolerance, and a substep that ends inside a box is halved until it ends at the box's surface.
 *
 * C11 against the installed headers alone; nothing is linked but the C library's mathematics.
 */
#include <physics/plugin.h>

#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>

enum { MOST_CONTACTS = 8, MOST_SUBSTEPS = 100000 };

/* ---------------------------------------------------------------------------------------------- rows of our own -- */

static const phys_param_row air_drag_row = {
    .id = "air_drag",
    .label = "Air drag",
    .unit = "1/m",
    .help =
        "Deceleration is this times the speed squared: rho C A / (2 m). A table tennis ball: about 0.14. Default: 0.1.",
    .choices = "",
    .min = 0.0,
    .max = 1e6,
    .low = 0.0,
    .high = 1.0,
    .initial = 0.1,
    .step = 0.01,
    .offset = offsetof(phys_params, stepper),
};
static const phys_param_row tolerance_row = {
    .id = "substep_tolerance",
    .label = "Tolerance of a substep",
    .unit = "m",
    .help = "How far a substep may be off in place, or end inside a box. Smaller costs more substeps. Default: 1e-7.",
    .choices = "",
    .min = 1e-12,
    .max = 1e-3,
    .low = 1e-9,
    .high = 1e-4,
    .initial = 1e-7,
    .step = 1e-7,
    .offset = offsetof(phys_params, stepper) + sizeof(double),
};
static const phys_param_row *const rows[] = {&air_drag_row, &tolerance_row};

/* ------------------------------------------------------------------------------------------------------ vectors -- */

static phys_vec3 plus(phys_vec3 a, double factor, phys_vec3 b) {
    return (phys_vec3){a.x + factor * b.x, a.y + factor * b.y, a.z + factor * b.z};
}
static double dot(phys_vec3 a, phys_vec3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
static double length(phys_vec3 a) { return sqrt(dot(a, a)); }

/* -------------------------------------------------------------------------------------------------------- ball -- */

typedef struct Ball {
    phys_vec3 position, velocity, spin;
    double lost; /* to resistance and drag so far, J/kg */
} Ball;

/* What holds during one substep. */
typedef struct Phase {
    const phys_params *params;
    phys_vec3 held[MOST_CONTACTS]; /* normals of the boxes that the ball leans on */
    uint32_t held_count;
    bool supported; /* one of them points up: the ball rolls */
} Phase;

static double drag_of(const phys_params *params) { return params->stepper[0]; }
static double tolerance_of(const phys_params *params) { return params->stepper[1]; }
static bool is_floor(phys_vec3 normal) { return normal.z > 0.99; }

/* What is left of a vector when the boxes that the ball leans on take what points into them. */
static phys_vec3 along_boxes(const Phase *phase, phys_vec3 vector) {
    for (int pass = 0; pass < 2; ++pass) { /* twice: in a corner each takes a part of what the other leaves */
        for (uint32_t i = 0; i < phase->held_count; ++i) {
            const double into = dot(vector, phase->held[i]);
            if (into < 0.0) vector = plus(vector, -into, phase->held[i]);
        }
    }
    return vector;
}

/* The resistance that is left when the ball stands: the floor's. */
static double resistance(const Phase *phase) {
    return phase->supported ? phase->params->rolling_friction * -phase->params->gravity.z : 0.0;
}

/* Derivatives of place, velocity and loss. 5/7: two sevenths of each force turn a rolling ball. */
static Ball derivative(const Phase *phase, const Ball *at) {
    const double inertia = phase->supported ? 5.0 / 7.0 : 1.0;
    const double speed = length(at->velocity);
    const double against = drag_of(phase->params) * speed + (speed > 0.0 ? resistance(phase) / speed : 0.0);
    const phys_vec3 force = plus(along_boxes(phase, phase->params->gravity), -against, at->velocity);
    const phys_vec3 zero = {0.0, 0.0, 0.0};
    return (Ball){at->velocity, plus(zero, inertia, force), zero, against * speed * speed};
}

static Ball advanced(const Ball *from, double h, const Ball *rate) {
    Ball to = *from;
    to.position = plus(to.position, h, rate->position);
    to.velocity = plus(to.velocity, h, rate->velocity);
    to.lost += h * rate->lost;
    return to;
}

/* One substep by the pair; *error: how far its two answers lie apart, m. */
static Ball runge_kutta(const Phase *phase, const Ball *from, double h, double *error) {
    const Ball k1 = derivative(phase, from);
    const Ball at2 = advanced(from, h / 2.0, &k1);
    const Ball k2 = derivative(phase, &at2);
    const Ball at3 = advanced(from, h * 3.0 / 4.0, &k2);
    const Ball k3 = derivative(phase, &at3);
    Ball to = advanced(from, h * 2.0 / 9.0, &k1);
    to = advanced(&to, h / 3.0, &k2);
    to = advanced(&to, h * 4.0 / 9.0, &k3);
    const Ball k4 = derivative(phase, &to);
    Ball apart = {.lost = 0.0};
    apart = advanced(&apart, h * -5.0 / 72.0, &k1);
    apart = advanced(&apart, h / 12.0, &k2);
    apart = advanced(&apart, h / 9.0, &k3);
    apart = advanced(&apart, h / -8.0, &k4);
    *error = length(apart.position) + h * length(apart.velocity);
    return to;
}

/* ------------------------------------------------------------------------------------------------------ stepper -- */

typedef struct Stepper {
    const phys_scene_view *scene;
    phys_box bounds;
} Stepper;

/* Everything of one call to step. */
typedef struct Job {
    const Stepper *self;
    const phys_params *params;
    phys_report *report; /* or NULL */
    double time;         /* s since the start */
    Ball ball;
} Job;

static double kinetic(const Job *job) {
    const double r = job->self->scene->radius;
    return 0.5 * dot(job->ball.velocity, job->ball.velocity) + 0.2 * r * r * dot(job->ball.spin, job->ball.spin);
}

/* A rolling ball's spin follows from its velocity; what it turns about the vertical has no say. */
static void roll(Job *job) {
    const double r = job->self->scene->radius;
    job->ball.spin = (phys_vec3){-job->ball.velocity.y / r, job->ball.velocity.x / r, 0.0};
}

static void tell(const Job *job, uint32_t kind, const phys_contact *contact, double before, double after) {
    phys_report *report = job->report;
    if (!report) return;
    if (report->event_count == report->event_capacity) {
        ++report->events_lost;
        return;
    }
    const phys_vec3 zero = {0.0, 0.0, 0.0};
    report->events[report->event_count++] = (phys_event){
        job->time, contact ? contact->point : job->ball.position, contact ? contact->normal : zero, before, after,
        kind,      contact ? contact->box : PHYS_NO_BOX};
}

static uint32_t contacts_of(const Job *job, double reach, phys_contact *out) {
    const phys_scene_view *scene = job->self->scene;
    const uint32_t count = scene->contacts(scene->scene, &job->ball.position, reach, out, MOST_CONTACTS);
    return count < MOST_CONTACTS ? count : MOST_CONTACTS;
}

/* Takes the ball's speed into a box away or turns it round. A bounce that would be lower than the tolerance is none. */
static void meet(Job *job, Phase *phase, const phys_contact *contact) {
    const double into = dot(job->ball.velocity, contact->normal);
    if (into > 0.0) return;
    const bool floor = is_floor(contact->normal);
    const double restitution = floor ? job->params->restitution_floor : job->params->restitution_wall;
    const double back = -restitution * into;
    const double pull = -dot(job->params->gravity, contact->normal);
    const bool bounces = back * back > 2.0 * fmax(pull, 0.0) * tolerance_of(job->params) && back > 0.0;
    const double before = kinetic(job);
    job->ball.velocity = plus(job->ball.velocity, (bounces ? back : 0.0) - into, contact->normal);
    if (!bounces) phase->held[phase->held_count++] = contact->normal;
    if (!bounces && floor) phase->supported = true;
    if (phase->supported && !floor) roll(job);
    const double met = kinetic(job);
    if (phase->supported && floor) roll(job); /* a given spin that isn't that of rolling is slip */
    if (job->report) {
        job->report->lost_impact += fmax(before - met, 0.0); /* never below 0, not even by rounding */
        job->report->lost_slip += met - kinetic(job);
    }
    if (bounces) tell(job, floor ? PHYS_EVENT_LANDING : PHYS_EVENT_IMPACT, contact, into, back);
}

/* Settles the ball with all boxes it touches; what it leans on from here on is the new phase. Floors come first:
 * whether the ball rolls decides what an impact with a wall costs. */
static Phase settle(Job *job) {
    Phase phase = {.params = job->params};
    phys_contact contacts[MOST_CONTACTS];
    const uint32_t count = contacts_of(job, 2.0 * tolerance_of(job->params), contacts);
    for (uint32_t i = 0; i < count; ++i) {
        if (is_floor(contacts[i].normal)) meet(job, &phase, &contacts[i]);
    }
    for (uint32_t i = 0; i < count; ++i) {
        if (!is_floor(contacts[i].normal)) meet(job, &phase, &contacts[i]);
    }
    return phase;
}

/* How deep the ball is in a box that it moves into; boxes that it leans on don't count. */
static double overlap(const Job *job, const Phase *phase) {
    phys_contact contacts[MOST_CONTACTS];
    const uint32_t count = contacts_of(job, 0.0, contacts);
    double deepest = 0.0;
    for (uint32_t i = 0; i < count; ++i) {
        bool held = false;
        for (uint32_t k = 0; k < phase->held_count; ++k) held |= dot(phase->held[k], contacts[i].normal) > 0.99;
        if (!held && dot(job->ball.velocity, contacts[i].normal) < 0.0) deepest = fmax(deepest, -contacts[i].gap);
    }
    return deepest;
}

/* Whether resistance brings the Ball to rest within h, or keeps it there. */
static bool stops(const Job *job, const Phase *phase, double h) {
    const double inertia = 5.0 / 7.0;
    const phys_vec3 driven = plus(job->ball.velocity, inertia * h, along_boxes(phase, job->params->gravity));
    return phase->supported && length(driven) <= inertia * h * resistance(phase);
}

/* A standing ball loses what it still had. */
static void stop(Job *job) {
    const double before = kinetic(job);
    job->ball.velocity = (phys_vec3){0.0, 0.0, 0.0};
    roll(job);
    job->ball.lost += before - kinetic(job);
    if (before > 0.0) tell(job, PHYS_EVENT_STOP, NULL, sqrt(before / 0.7), 0.0);
}

/* Tries a substep of h; false if it is too long to be good enough. *error: of the motion, m. */
static bool try_substep(Job *job, const Phase *phase, double h, double *error) {
    const Ball before = job->ball;
    const double tolerance = tolerance_of(job->params);
    job->ball = runge_kutta(phase, &before, h, error);
    if (phase->supported) roll(job);
    const double moved = length(plus(job->ball.position, -1.0, before.position));
    const double depth = overlap(job, phase);
    const bool good = moved <= 0.5 * job->self->scene->radius && *error <= tolerance && depth <= tolerance;
    const bool shortest = moved <= 1e-3 * tolerance; /* halving it would change nothing any more */
    if (good || shortest) {
        if (job->report) job->report->penetration = fmax(job->report->penetration, depth);
        return true;
    }
    job->ball = before;
    return false;
}

/* Moves the ball over all of dt; false if that would take too many substeps. */
static bool run(Job *job, double dt, Phase *phase) {
    const double start = job->time;
    const double end = start + dt;
    double h = dt;
    for (uint32_t count = 1; count <= MOST_SUBSTEPS; ++count) {
        *phase = settle(job);
        h = fmin(h, end - job->time);
        if (stops(job, phase, h)) {
            stop(job);
            job->time += h;
        } else {
            double error = 0.0;
            while (!try_substep(job, phase, h, &error)) h /= 2.0;
            job->time += h;
            const bool easy = error <= tolerance_of(job->params) / 16.0;
            if (easy) h *= 2.0;
        }
        if (job->report) job->report->substeps = count;
        if (job->time >= end) return true;
    }
    return false;
}

static uint64_t flags_of(const Job *job, const Phase *phase) {
    const phys_vec3 p = job->ball.position;
    const phys_box *b = &job->self->bounds;
    uint64_t flags = 0;
    if (length(job->ball.velocity) == 0.0 && phase->supported) flags |= PHYS_AT_REST;
    if (!phase->supported) flags |= PHYS_AIRBORNE;
    if (p.x < b->min.x || p.x > b->max.x || p.y < b->min.y || p.y > b->max.y) flags |= PHYS_OUT;
    return flags;
}

/* Turns the orientation by the mean spin of the step: q + dt/2 (spin, 0) q, made unit again. */
static void turn(const phys_state *in, double dt, phys_state *out) {
    const double x = 0.25 * dt * (in->spin.x + out->spin.x);
    const double y = 0.25 * dt * (in->spin.y + out->spin.y);
    const double z = 0.25 * dt * (in->spin.z + out->spin.z);
    const double *q = in->orientation;
    const double turned[4] = {q[0] + (x * q[3] + y * q[2] - z * q[1]), q[1] + (y * q[3] + z * q[0] - x * q[2]),
                              q[2] + (z * q[3] + x * q[1] - y * q[0]), q[3] - (x * q[0] + y * q[1] + z * q[2])};
    double square = 0.0;
    for (int i = 0; i < 4; ++i) square += turned[i] * turned[i];
    for (int i = 0; i < 4; ++i) out->orientation[i] = turned[i] / sqrt(square);
}

/* ------------------------------------------------------------------------------------------------- the table's -- */

static phys_status create(const phys_scene_view *scene, void **self, phys_error *err) {
    Stepper *made = malloc(sizeof *made);
    if (!made) {
        snprintf(err->text, sizeof err->text, "out of memory for stepper 'adaptive-drag'");
        return PHYS_ERROR_MEMORY;
    }
    made->scene = scene;
    made->bounds = (phys_box){{0.0, 0.0, 0.0}, {0.0, 0.0, 0.0}};
    for (uint32_t i = 0; i < scene->box_count; ++i) {
        const phys_box *box = &scene->boxes[i];
        if (i == 0) made->bounds = *box;
        made->bounds.min.x = fmin(made->bounds.min.x, box->min.x);
        made->bounds.min.y = fmin(made->bounds.min.y, box->min.y);
        made->bounds.max.x = fmax(made->bounds.max.x, box->max.x);
        made->bounds.max.y = fmax(made->bounds.max.y, box->max.y);
    }
    *self = made;
    return PHYS_OK;
}

static void destroy(void *self) { free(self); }

static phys_status step(void *self, const phys_params *params, double dt, const phys_state *in, phys_state *out,
                        phys_report *report, phys_error *err) {
    if (params->model != PHYS_MODEL_ROLLING) {
        snprintf(err->text, sizeof err->text, "stepper 'adaptive-drag' knows the rolling model only; model is %u",
                 params->model);
        return PHYS_ERROR_UNSUPPORTED;
    }
    Job job = {self, params, report, in->time, {in->position, in->velocity, in->spin, 0.0}};
    if (report) report->substep_cap = MOST_SUBSTEPS;
    Phase phase;
    if (!run(&job, dt, &phase)) {
        snprintf(err->text, sizeof err->text, "over %d substeps; take a smaller dt or a larger substep_tolerance",
                 MOST_SUBSTEPS);
        return PHYS_ERROR_SUBSTEP_CAP;
    }
    if (report) report->lost_rolling = job.ball.lost;
    out->position = job.ball.position;
    out->velocity = job.ball.velocity;
    out->spin = job.ball.spin;
    out->flags = flags_of(&job, &phase);
    if (params->options & PHYS_OPTION_ORIENTATION) turn(in, dt, out);
    return PHYS_OK;
}

static const phys_stepper_api adaptive_drag = {
    .struct_size = sizeof(phys_stepper_api),
    .flags = PHYS_STEPPER_BITS_EVERYWHERE,
    .id = "adaptive-drag",
    .name = "Adaptive, with air drag",
    .version = "1",
    .summary = "Rolls through air: Runge-Kutta 3(2) with substeps of its own choice, each below a tolerance.",
    .rows = rows,
    .row_count = sizeof rows / sizeof rows[0],
    .create = create,
    .destroy = destroy,
    .step = step,
};
static const phys_stepper_api *const steppers[] = {&adaptive_drag};

const phys_plugin phys_plugin_entry = {PHYS_ABI_VERSION, sizeof(phys_plugin), 1, 0, steppers};
