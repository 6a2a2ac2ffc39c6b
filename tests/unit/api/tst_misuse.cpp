// SPDX-License-Identifier: MIT
// Every invalid argument is refused with its code and one line, and leaves every output unchanged.
#include "support/compare.h"
#include "support/experiment.h"
#include "support/special_values.h"
#include "support/stepper_rows.h"

#include <QTest>

#include <cstring>
#include <functional>
#include <limits>
#include <vector>

using namespace support;

namespace {

/// All outputs of all functions, filled with a pattern.
struct Outputs {
    phys_scene *scene;
    phys_stepper *stepper;
    phys_registry *registry;
    phys_scene_desc desc;
    phys_params params;
    phys_state state;
    phys_report report;
    phys_requirements requirements;
    phys_stepper_info info;
    phys_contact contact;
    phys_box box;
    phys_vec3 vector;
    double number;
    uint32_t count;
};

/// Valid arguments, to be made invalid one at a time, and the outputs to check.
struct Bench {
    Experiment ball{squareRoom(4.0), PHYS_STEPPER_DEFAULT};
    phys_box box{{0, 0, 0}, {1, 1, 1}};
    phys_scene_desc desc{};
    phys_batch batch{};
    phys_vec3 centre{1, 1, 0.0625};
    Outputs out;

    Bench() {
        std::memset(static_cast<void *>(&out), 0xa5, sizeof out);
        phys_report_init(&out.report, sizeof out.report);
        phys_params_init(&out.params, sizeof out.params);
        phys_scene_desc_init(&desc, sizeof desc);
        phys_batch_init(&batch, sizeof batch);
        desc.boxes = &box;
        desc.box_count = 1;
    }

    phys_status step(double dt, phys_error *err) {
        return phys_step(ball.stepper(), &ball.params, dt, &ball.state, &out.state, &out.report, err);
    }
    phys_status create(phys_error *err) { return phys_scene_create(&desc, &out.scene, err); }
    phys_status require(double dt, phys_error *err) {
        return phys_stepper_requirements(ball.stepper(), &ball.params, dt, &ball.state, &out.requirements, err);
    }
    phys_status contacts(double reach) {
        return phys_scene_contacts(ball.scene(), &centre, reach, &out.contact, 1, &out.count);
    }
    phys_status energy() { return phys_energy(ball.scene(), &ball.params, &ball.state, &out.number); }
};

using Call = std::function<phys_status(Bench &, phys_error *)>;

struct Misuse {
    QByteArray name;
    phys_status expected;
    Call call;
};

/// Whether the function has an `err` parameter.
enum class Explains { No, Yes };

std::vector<Misuse> nullPointers() {
    const phys_status refused = PHYS_ERROR_ARGUMENT;
    return {
        {"phys_scene_create: desc", refused,
         [](Bench &b, phys_error *e) { return phys_scene_create(nullptr, &b.out.scene, e); }},
        {"phys_scene_create: out", refused,
         [](Bench &b, phys_error *e) { return phys_scene_create(&b.desc, nullptr, e); }},
        {"phys_scene_create: boxes", refused,
         [](Bench &b, phys_error *e) {
             b.desc.boxes = nullptr;
             return b.create(e);
         }},
        {"phys_scene_load: path", refused,
         [](Bench &b, phys_error *e) { return phys_scene_load(nullptr, &b.out.scene, e); }},
        {"phys_scene_load: out", refused, [](Bench &, phys_error *e) { return phys_scene_load("x.txt", nullptr, e); }},
        {"phys_scene_parse: text", refused,
         [](Bench &b, phys_error *e) { return phys_scene_parse(nullptr, 1, "x", &b.out.scene, e); }},
        {"phys_scene_parse: out", refused,
         [](Bench &, phys_error *e) { return phys_scene_parse("", 0, "x", nullptr, e); }},
        {"phys_batch_run: stepper", refused,
         [](Bench &b, phys_error *e) { return phys_batch_run(nullptr, &b.batch, 0, 0, e); }},
        {"phys_batch_run: batch", refused,
         [](Bench &b, phys_error *e) { return phys_batch_run(b.ball.stepper(), nullptr, 0, 0, e); }},
        {"phys_scene_check_planar: scene", refused,
         [](Bench &, phys_error *e) { return phys_scene_check_planar(nullptr, e); }},
        {"phys_param_set: params", refused,
         [](Bench &, phys_error *e) { return phys_param_set(nullptr, phys_param_rows(nullptr), 0, e); }},
        {"phys_param_set: row", refused,
         [](Bench &b, phys_error *e) { return phys_param_set(&b.out.params, nullptr, 0, e); }},
        {"phys_params_check: params", refused, [](Bench &, phys_error *e) { return phys_params_check(nullptr, e); }},
        {"phys_registry_create: out", refused, [](Bench &, phys_error *e) { return phys_registry_create(nullptr, e); }},
        {"phys_registry_find: id", refused,
         [](Bench &b, phys_error *e) { return phys_registry_find(nullptr, nullptr, &b.out.info, e); }},
        {"phys_registry_find: out", refused,
         [](Bench &, phys_error *e) { return phys_registry_find(nullptr, "rk4", nullptr, e); }},
        {"phys_stepper_create: id", refused,
         [](Bench &b, phys_error *e) {
             return phys_stepper_create(nullptr, nullptr, b.ball.scene(), &b.out.stepper, e);
         }},
        {"phys_stepper_create: scene", refused,
         [](Bench &b, phys_error *e) { return phys_stepper_create(nullptr, "rk4", nullptr, &b.out.stepper, e); }},
        {"phys_stepper_create: out", refused,
         [](Bench &b, phys_error *e) { return phys_stepper_create(nullptr, "rk4", b.ball.scene(), nullptr, e); }},
        {"phys_step: stepper", refused,
         [](Bench &b, phys_error *e) {
             return phys_step(nullptr, &b.ball.params, 0.01, &b.ball.state, &b.out.state, &b.out.report, e);
         }},
        {"phys_step: params", refused,
         [](Bench &b, phys_error *e) {
             return phys_step(b.ball.stepper(), nullptr, 0.01, &b.ball.state, &b.out.state, &b.out.report, e);
         }},
        {"phys_step: in", refused,
         [](Bench &b, phys_error *e) {
             return phys_step(b.ball.stepper(), &b.ball.params, 0.01, nullptr, &b.out.state, &b.out.report, e);
         }},
        {"phys_step: out", refused,
         [](Bench &b, phys_error *e) {
             return phys_step(b.ball.stepper(), &b.ball.params, 0.01, &b.ball.state, nullptr, &b.out.report, e);
         }},
        {"phys_stepper_requirements: stepper", refused,
         [](Bench &b, phys_error *e) {
             return phys_stepper_requirements(nullptr, &b.ball.params, 0.01, &b.ball.state, &b.out.requirements, e);
         }},
        {"phys_stepper_requirements: params", refused,
         [](Bench &b, phys_error *e) {
             return phys_stepper_requirements(b.ball.stepper(), nullptr, 0.01, &b.ball.state, &b.out.requirements, e);
         }},
        {"phys_stepper_requirements: state", refused,
         [](Bench &b, phys_error *e) {
             return phys_stepper_requirements(b.ball.stepper(), &b.ball.params, 0.01, nullptr, &b.out.requirements, e);
         }},
        {"phys_stepper_requirements: out", refused,
         [](Bench &b, phys_error *e) {
             return phys_stepper_requirements(b.ball.stepper(), &b.ball.params, 0.01, &b.ball.state, nullptr, e);
         }},
    };
}

std::vector<Misuse> nullPointersOfTerseFunctions() {
    static constexpr double kOne = 1.0;
    const phys_status refused = PHYS_ERROR_ARGUMENT;
    return {
        {"phys_gravity_from_tilt: out", refused,
         [](Bench &, phys_error *) { return phys_gravity_from_tilt(0, 0, 9.81, nullptr); }},
        {"phys_gravities_from_tilts: tilts_x", refused,
         [](Bench &b, phys_error *) { return phys_gravities_from_tilts(1, nullptr, &kOne, &kOne, &b.out.vector); }},
        {"phys_gravities_from_tilts: tilts_y", refused,
         [](Bench &b, phys_error *) { return phys_gravities_from_tilts(1, &kOne, nullptr, &kOne, &b.out.vector); }},
        {"phys_gravities_from_tilts: strengths", refused,
         [](Bench &b, phys_error *) { return phys_gravities_from_tilts(1, &kOne, &kOne, nullptr, &b.out.vector); }},
        {"phys_gravities_from_tilts: out", refused,
         [](Bench &, phys_error *) { return phys_gravities_from_tilts(1, &kOne, &kOne, &kOne, nullptr); }},
        {"phys_scene_desc_init: desc", refused,
         [](Bench &, phys_error *) { return phys_scene_desc_init(nullptr, sizeof(phys_scene_desc)); }},
        {"phys_batch_init: batch", refused,
         [](Bench &, phys_error *) { return phys_batch_init(nullptr, sizeof(phys_batch)); }},
        {"phys_batch_init: size", refused,
         [](Bench &b, phys_error *) { return phys_batch_init(&b.batch, sizeof(phys_batch) + 8); }},
        {"phys_scene_bounds: scene", refused,
         [](Bench &b, phys_error *) { return phys_scene_bounds(nullptr, &b.out.box); }},
        {"phys_scene_bounds: out", refused,
         [](Bench &b, phys_error *) { return phys_scene_bounds(b.ball.scene(), nullptr); }},
        {"phys_scene_contacts: scene", refused,
         [](Bench &b, phys_error *) {
             return phys_scene_contacts(nullptr, &b.centre, 1, &b.out.contact, 1, &b.out.count);
         }},
        {"phys_scene_contacts: centre", refused,
         [](Bench &b, phys_error *) {
             return phys_scene_contacts(b.ball.scene(), nullptr, 1, &b.out.contact, 1, &b.out.count);
         }},
        {"phys_scene_contacts: out with capacity", refused,
         [](Bench &b, phys_error *) {
             return phys_scene_contacts(b.ball.scene(), &b.centre, 1, nullptr, 1, &b.out.count);
         }},
        {"phys_scene_contacts: count", refused,
         [](Bench &b, phys_error *) {
             return phys_scene_contacts(b.ball.scene(), &b.centre, 1, &b.out.contact, 1, nullptr);
         }},
        {"phys_scene_start: scene", refused,
         [](Bench &b, phys_error *) { return phys_scene_start(nullptr, &b.out.state); }},
        {"phys_scene_start: out", refused,
         [](Bench &b, phys_error *) { return phys_scene_start(b.ball.scene(), nullptr); }},
        {"phys_params_init: params", refused,
         [](Bench &, phys_error *) { return phys_params_init(nullptr, sizeof(phys_params)); }},
        {"phys_report_init: report", refused,
         [](Bench &, phys_error *) { return phys_report_init(nullptr, sizeof(phys_report)); }},
        {"phys_energy: scene", refused,
         [](Bench &b, phys_error *) { return phys_energy(nullptr, &b.ball.params, &b.ball.state, &b.out.number); }},
        {"phys_energy: params", refused,
         [](Bench &b, phys_error *) { return phys_energy(b.ball.scene(), nullptr, &b.ball.state, &b.out.number); }},
        {"phys_energy: state", refused,
         [](Bench &b, phys_error *) { return phys_energy(b.ball.scene(), &b.ball.params, nullptr, &b.out.number); }},
        {"phys_energy: out", refused,
         [](Bench &b, phys_error *) { return phys_energy(b.ball.scene(), &b.ball.params, &b.ball.state, nullptr); }},
        {"phys_registry_info: out", refused,
         [](Bench &, phys_error *) { return phys_registry_info(nullptr, 0, nullptr); }},
        {"phys_stepper_info_init_params: info", refused,
         [](Bench &b, phys_error *) { return phys_stepper_info_init_params(nullptr, &b.out.params); }},
        {"phys_stepper_info_init_params: params", refused,
         [](Bench &, phys_error *) {
             phys_stepper_info info;
             phys_registry_info(nullptr, 0, &info);
             return phys_stepper_info_init_params(&info, nullptr);
         }},
    };
}

/// phys_stepper_info_init_params of an info that isn't as the library made it.
phys_status initParamsOf(Bench &bench, const std::vector<const phys_param_row *> &rows) {
    phys_stepper_info info{};
    info.row_count = static_cast<uint32_t>(rows.size());
    info.rows = rows.data();
    return phys_stepper_info_init_params(&info, &bench.out.params);
}

/// phys_param_set of a copied row.
phys_status setAt(Bench &bench, uint32_t offset, uint32_t flags, phys_error *error) {
    phys_param_row row = phys_param_rows(nullptr)[1];
    row.offset = offset;
    row.flags = flags;
    return phys_param_set(&bench.out.params, &row, 0.0, error);
}

std::vector<Misuse> wrongValuesOfTerseFunctions() {
    const phys_status refused = PHYS_ERROR_ARGUMENT;
    std::vector<Misuse> rows{
        {"phys_scene_desc_init: size", refused,
         [](Bench &b, phys_error *) { return phys_scene_desc_init(&b.out.desc, sizeof b.out.desc - 1); }},
        {"phys_params_init: size", refused,
         [](Bench &b, phys_error *) { return phys_params_init(&b.out.params, sizeof b.out.params + 8); }},
        {"phys_report_init: size", refused, [](Bench &b, phys_error *) { return phys_report_init(&b.out.report, 0); }},
        {"phys_registry_info: index", refused,
         [](Bench &b, phys_error *) { return phys_registry_info(nullptr, phys_registry_count(nullptr), &b.out.info); }},
        {"phys_stepper_info_init_params: no rows", refused,
         [](Bench &b, phys_error *) {
             phys_stepper_info info{};
             info.row_count = 1;
             return phys_stepper_info_init_params(&info, &b.out.params);
         }},
        {"phys_stepper_info_init_params: a row that is NULL", refused,
         [](Bench &b, phys_error *) { return initParamsOf(b, {nullptr}); }},
        {"phys_stepper_info_init_params: too many rows", refused,
         [](Bench &b, phys_error *) {
             phys_param_row row = phys_param_rows(nullptr)[1];
             row.offset = offsetof(phys_params, stepper);
             return initParamsOf(b, std::vector<const phys_param_row *>(PHYS_STEPPER_VALUES + 1, &row));
         }},
        {"phys_stepper_info_init_params: a row of the library", refused,
         [](Bench &b, phys_error *) { return initParamsOf(b, {phys_param_rows(nullptr) + 1}); }},
    };
    constexpr double kQuarterTurn = 1.5707963267948966;
    for (const double tilt : {kNaN, kInfinity, -kInfinity, kQuarterTurn, -kQuarterTurn, 100.0}) {
        rows.push_back({"phys_gravity_from_tilt: tilt_x " + digits(tilt), refused, [tilt](Bench &b, phys_error *) {
                            return phys_gravity_from_tilt(tilt, 0, 9.81, &b.out.vector);
                        }});
        rows.push_back({"phys_gravity_from_tilt: tilt_y " + digits(tilt), refused, [tilt](Bench &b, phys_error *) {
                            return phys_gravity_from_tilt(0, tilt, 9.81, &b.out.vector);
                        }});
    }
    for (const double value : {kNaN, kInfinity, -kInfinity, 0x1p101}) {
        const QByteArray told = digits(value);
        rows.push_back({"phys_scene_contacts: centre.x " + told, refused, [value](Bench &b, phys_error *) {
                            b.centre.x = value;
                            return b.contacts(1.0);
                        }});
        rows.push_back({"phys_energy: velocity.y " + told, refused, [value](Bench &b, phys_error *) {
                            b.ball.state.velocity.y = value;
                            return b.energy();
                        }});
        rows.push_back({"phys_energy: gravity.z " + told, refused, [value](Bench &b, phys_error *) {
                            b.ball.params.gravity.z = value;
                            return b.energy();
                        }});
    }
    for (const double value : {kNaN, kInfinity, -kInfinity, -1.0, 0x1.1p100}) {
        rows.push_back({"phys_gravity_from_tilt: strength " + digits(value), refused, [value](Bench &b, phys_error *) {
                            return phys_gravity_from_tilt(0, 0, value, &b.out.vector);
                        }});
    }
    for (const double value : {kNaN, kInfinity, -kInfinity, -1.0}) {
        rows.push_back({"phys_scene_contacts: reach " + digits(value), refused,
                        [value](Bench &b, phys_error *) { return b.contacts(value); }});
    }
    return rows;
}

std::vector<Misuse> wrongScenes() {
    std::vector<Misuse> rows;
    const auto add = [&rows](const QByteArray &name, phys_status status, const std::function<void(Bench &)> &spoil) {
        rows.push_back({name, status, [spoil](Bench &b, phys_error *e) {
                            spoil(b);
                            return b.create(e);
                        }});
    };
    for (const uint32_t size : {0U, 1U, static_cast<uint32_t>(sizeof(phys_scene_desc)) + 8U}) {
        add("struct_size " + QByteArray::number(size), PHYS_ERROR_ARGUMENT,
            [size](Bench &b) { b.desc.struct_size = size; });
    }
    add("a million and one boxes", PHYS_ERROR_SCENE, [](Bench &b) { b.desc.box_count = 1'000'001; });
    for (const double radius : {0.0, -1.0, 0.9e-9, 1.1e6, kNaN, kInfinity, -kInfinity}) {
        add("radius " + digits(radius), PHYS_ERROR_SCENE, [radius](Bench &b) { b.desc.radius = radius; });
    }
    for (const double value : {kNaN, kInfinity, -kInfinity, 1.1e9, -1.1e9}) {
        for (int i = 0; i < 3; ++i) {
            const QByteArray tag = QByteArray(1, "xyz"[i]) + " = " + digits(value);
            add("start." + tag, PHYS_ERROR_SCENE, [=](Bench &b) { (&b.desc.start.x)[i] = value; });
            add("min." + tag, PHYS_ERROR_SCENE, [=](Bench &b) { (&b.box.min.x)[i] = value; });
            add("max." + tag, PHYS_ERROR_SCENE, [=](Bench &b) { (&b.box.max.x)[i] = value; });
        }
    }
    for (int i = 0; i < 3; ++i) {
        add("min above max in " + QByteArray(1, "xyz"[i]), PHYS_ERROR_SCENE,
            [i](Bench &b) { (&b.box.max.x)[i] = -1e-9; });
    }
    return rows;
}

/// Arguments that are invalid for a step are also invalid for its requirements.
std::vector<Misuse> wrongSteps() {
    std::vector<Misuse> rows;
    const auto add = [&rows](const QByteArray &name, phys_status status, const std::function<void(Bench &)> &spoil,
                             double dt = 0.01) {
        rows.push_back({"phys_step: " + name, status, [=](Bench &b, phys_error *e) {
                            spoil(b);
                            return b.step(dt, e);
                        }});
        rows.push_back({"phys_stepper_requirements: " + name, status, [=](Bench &b, phys_error *e) {
                            spoil(b);
                            return b.require(dt, e);
                        }});
    };
    for (const double dt : {-1.0, -1e-300, kNaN, kInfinity, -kInfinity})
        add(
            "dt " + digits(dt), PHYS_ERROR_ARGUMENT, [](Bench &) {}, dt);
    add("params.struct_size", PHYS_ERROR_ARGUMENT, [](Bench &b) { b.ball.params.struct_size = 8; });
    add("params.options", PHYS_ERROR_RANGE, [](Bench &b) { b.ball.params.options = PHYS_OPTIONS + 1; });
    uint32_t count = 0;
    const phys_param_row *const first = phys_param_rows(&count);
    for (uint32_t i = 0; i < count; ++i) {
        const phys_param_row &row = first[i];
        if (row.flags & PHYS_ROW_CHOICE) {
            add(QByteArray(row.id) + " above its choices", PHYS_ERROR_RANGE, [&row](Bench &b) {
                const auto value = static_cast<uint32_t>(row.max) + 1;
                std::memcpy(reinterpret_cast<char *>(&b.ball.params) + row.offset, &value, sizeof value);
            });
            continue;
        }
        const double above = std::nextafter(row.max, kInfinity);
        const double below = std::nextafter(row.min, -kInfinity);
        for (const double value : {kNaN, kInfinity, -kInfinity, above, below}) {
            add(QByteArray(row.id) + " = " + digits(value), PHYS_ERROR_RANGE, [&row, value](Bench &b) {
                std::memcpy(reinterpret_cast<char *>(&b.ball.params) + row.offset, &value, sizeof value);
            });
        }
    }
    for (const double value : {0.5, 2.0, -1.0, kNaN})
        add("as_reported = " + digits(value), PHYS_ERROR_RANGE,
            [value](Bench &b) { b.ball.params.stepper[0] = value; });
    add("rolling_friction above sliding_friction", PHYS_ERROR_RANGE, [](Bench &b) {
        b.ball.params.model = PHYS_MODEL_RIGID;
        b.ball.params.rolling_friction = 0.3;
        b.ball.params.sliding_friction = 0.25;
    });
    for (const double gz : {0.0, 1.0})
        add("gravity_z = " + digits(gz) + " on the floor", PHYS_ERROR_RANGE,
            [gz](Bench &b) { b.ball.params.gravity.z = gz; });
    // time, followed by position, velocity, spin and orientation.
    for (const double value : {kNaN, kInfinity, -kInfinity}) {
        add("state.time = " + digits(value), PHYS_ERROR_STATE, [value](Bench &b) { b.ball.state.time = value; });
        for (int i = 0; i < 13; ++i)
            add("number " + QByteArray::number(i) + " of the state = " + digits(value), PHYS_ERROR_STATE,
                [i, value](Bench &b) { (&b.ball.state.position.x)[i] = value; });
    }
    add("orientation of length 0", PHYS_ERROR_STATE, [](Bench &b) { b.ball.state.orientation[3] = 0.0; });
    add("orientation of length 1.001", PHYS_ERROR_STATE, [](Bench &b) { b.ball.state.orientation[3] = 1.001; });
    add("an unknown flag", PHYS_ERROR_STATE, [](Bench &b) { b.ball.state.flags = PHYS_STATE_FLAGS + 1; });
    return rows;
}

std::vector<Misuse> otherWrongs() {
    return {
        {"phys_step: report.struct_size", PHYS_ERROR_ARGUMENT,
         [](Bench &b, phys_error *e) {
             phys_report report{};
             report.struct_size = sizeof report - 8;
             return phys_step(b.ball.stepper(), &b.ball.params, 0.01, &b.ball.state, &b.out.state, &report, e);
         }},
        {"phys_stepper_create: unknown id", PHYS_ERROR_UNKNOWN_STEPPER,
         [](Bench &b, phys_error *e) {
             return phys_stepper_create(nullptr, "leapfrog", b.ball.scene(), &b.out.stepper, e);
         }},
        {"phys_stepper_create: empty id", PHYS_ERROR_UNKNOWN_STEPPER,
         [](Bench &b, phys_error *e) { return phys_stepper_create(nullptr, "", b.ball.scene(), &b.out.stepper, e); }},
        {"phys_registry_find: unknown id", PHYS_ERROR_UNKNOWN_STEPPER,
         [](Bench &b, phys_error *e) { return phys_registry_find(nullptr, "RK4", &b.out.info, e); }},
        {"phys_param_set: offset of the size", PHYS_ERROR_ARGUMENT,
         [](Bench &b, phys_error *e) { return setAt(b, 0, 0, e); }},
        {"phys_param_set: offset between two values", PHYS_ERROR_ARGUMENT,
         [](Bench &b, phys_error *e) { return setAt(b, offsetof(phys_params, gravity) + 5, 0, e); }},
        {"phys_param_set: a choice where a number is", PHYS_ERROR_ARGUMENT,
         [](Bench &b, phys_error *e) { return setAt(b, offsetof(phys_params, gravity), PHYS_ROW_CHOICE, e); }},
        {"phys_scene_check_planar: a low kerb", PHYS_ERROR_UNSUPPORTED,
         [](Bench &, phys_error *e) {
             const auto scene = openFloor(1.0).box({{0.5, -1, 0}, {0.75, 1, 0.03125}}).build();
             return phys_scene_check_planar(scene.get(), e);
         }},
    };
}

} // namespace

class TestMisuse : public QObject {
    Q_OBJECT

private slots:
    void nullIsRefusedAndExplained_data() { addRows(nullPointers(), Explains::Yes); }
    void nullIsRefusedAndExplained() { check(); }
    void nullIsRefused_data() { addRows(nullPointersOfTerseFunctions(), Explains::No); }
    void nullIsRefused() { check(); }
    void wrongValueIsRefused_data() { addRows(wrongValuesOfTerseFunctions(), Explains::No); }
    void wrongValueIsRefused() { check(); }
    void wrongSceneIsRefused_data() { addRows(wrongScenes(), Explains::Yes); }
    void wrongSceneIsRefused() { check(); }
    void wrongStepIsRefused_data() { addRows(wrongSteps(), Explains::Yes); }
    void wrongStepIsRefused() { check(); }
    void otherWrongIsRefused_data() { addRows(otherWrongs(), Explains::Yes); }
    void otherWrongIsRefused() { check(); }

    void destroyingNothingDoesNothing();
    void gettersAnswerNullWithNothing();
    void versionIsThatOfTheHeader();
    void everyStatusHasItsNameAndText();
    void unknownStepperNamesTheKnownOnes();
    void refusalNamesParameterValueAndRange();
    void refusedSceneNamesTheBox();
    void successLeavesTheErrorAlone();
    void reportWithoutABufferCountsEventsAsLost();

private:
    void addRows(const std::vector<Misuse> &rows, Explains explains);
    void check();
};

void TestMisuse::addRows(const std::vector<Misuse> &rows, Explains explains) {
    QTest::addColumn<Call>("call");
    QTest::addColumn<int>("expected");
    QTest::addColumn<bool>("explains");
    for (const Misuse &row : rows) {
        QTest::newRow(row.name.constData())
            << row.call << static_cast<int>(row.expected) << (explains == Explains::Yes);
    }
}

void TestMisuse::check() {
    QFETCH(Call, call);
    QFETCH(int, expected);
    QFETCH(bool, explains);
    {
        Bench bench;
        const Outputs before = bench.out;
        phys_error error;
        std::memset(&error, 0x5a, sizeof error);
        QCOMPARE(call(bench, &error), static_cast<phys_status>(expected));
        QVERIFY(sameBits(before, bench.out));
        if (explains) {
            QCOMPARE(error.status, static_cast<phys_status>(expected));
            QCOMPARE(error.reserved, 0);
            QVERIFY(std::memchr(error.text, '\0', sizeof error.text));
            QVERIFY(error.text[0] != '\0' && !std::strchr(error.text, '\n'));
        }
    }
    Bench bench;
    const Outputs before = bench.out;
    QCOMPARE(call(bench, nullptr), static_cast<phys_status>(expected));
    QVERIFY(sameBits(before, bench.out));
}

void TestMisuse::destroyingNothingDoesNothing() {
    phys_scene_destroy(nullptr);
    phys_stepper_destroy(nullptr);
    phys_registry_destroy(nullptr);
}

void TestMisuse::gettersAnswerNullWithNothing() {
    QCOMPARE(phys_scene_radius(nullptr), 0.0);
    QCOMPARE(phys_scene_box_count(nullptr), 0U);
    QVERIFY(phys_scene_boxes(nullptr) == nullptr);
    QCOMPARE(phys_state_hash(nullptr), 0U);
    phys_params params;
    phys_params_init(&params, sizeof params);
    QVERIFY(std::isnan(phys_param_get(nullptr, phys_param_rows(nullptr))));
    QVERIFY(std::isnan(phys_param_get(&params, nullptr)));
    QVERIFY(phys_registry_count(nullptr) > 0);
}

/// How a program compiled with one version detects that it runs with another.
void TestMisuse::versionIsThatOfTheHeader() {
    QCOMPARE(QByteArray(phys_version()), QByteArray::number(PHYS_VERSION_MAJOR) + '.' +
                                             QByteArray::number(PHYS_VERSION_MINOR) + '.' +
                                             QByteArray::number(PHYS_VERSION_PATCH));
}

void TestMisuse::everyStatusHasItsNameAndText() {
    struct Status {
        phys_status status, value;
        const char *name, *text;
    };
#define STATUS_ROW(name, value, text) {name, value, #name, text},
    const Status all[] = {PHYS_STATUS_LIST(STATUS_ROW)};
#undef STATUS_ROW
    for (const Status &row : all) {
        QCOMPARE(row.status, row.value);
        QCOMPARE(phys_status_name(row.status), row.name);
        QCOMPARE(phys_status_text(row.status), row.text);
    }
    for (const phys_status unknown : {1, -16, std::numeric_limits<int32_t>::min()}) {
        QCOMPARE(phys_status_name(unknown), "unknown");
        QCOMPARE(phys_status_text(unknown), "unknown status");
    }
}

void TestMisuse::unknownStepperNamesTheKnownOnes() {
    Bench bench;
    phys_error error;
    QCOMPARE(phys_stepper_create(nullptr, "leapfrog", bench.ball.scene(), &bench.out.stepper, &error),
             PHYS_ERROR_UNKNOWN_STEPPER);
    const QByteArray text = error.text;
    QVERIFY(text.contains("leapfrog"));
    for (const QByteArray &id : stepperIds()) QVERIFY2(text.contains(id), error.text);
}

void TestMisuse::refusalNamesParameterValueAndRange() {
    Bench bench;
    bench.ball.params.restitution_wall = 1.25;
    phys_error error;
    QCOMPARE(bench.step(0.01, &error), PHYS_ERROR_RANGE);
    const QByteArray text = error.text;
    QVERIFY2(text.contains("restitution_wall") && text.contains("1.25") && text.contains("0 .. 1"), error.text);
}

void TestMisuse::refusedSceneNamesTheBox() {
    const std::vector<phys_box> boxes{{{0, 0, 0}, {1, 1, 1}}, {{0, 2, 0}, {1, 1, 1}}};
    auto scene = SceneBuilder();
    for (const phys_box &box : boxes) scene.box(box);
    phys_error error;
    QVERIFY(!scene.build(&error));
    QCOMPARE(error.status, PHYS_ERROR_SCENE);
    QVERIFY2(QByteArray(error.text).contains("box 1") && QByteArray(error.text).contains("min.y"), error.text);
}

void TestMisuse::successLeavesTheErrorAlone() {
    Bench bench;
    phys_error error;
    std::memset(&error, 0x5a, sizeof error);
    const phys_error before = error;
    QCOMPARE(bench.step(0.01, &error), PHYS_OK);
    QVERIFY(sameBits(before, error));
}

void TestMisuse::reportWithoutABufferCountsEventsAsLost() {
    Bench bench;
    bench.ball.setPosition(0.0625, 2.0);
    bench.ball.roll(-1.0, 0.0);
    bench.out.report.event_capacity = 5; // but events is NULL
    QCOMPARE(bench.step(0.001, nullptr), PHYS_OK);
    QCOMPARE(bench.out.report.event_count, 0U);
    QCOMPARE(bench.out.report.events_lost, 1U);
}

QTEST_GUILESS_MAIN(TestMisuse)
#include "tst_misuse.moc"
