// SPDX-License-Identifier: MIT
#include "contract.h"

#include "surroundings.h"
#include "trial.h"

#include "support/handles.h"

#include <physics/plugin.h>

#include <algorithm>
#include <array>
#include <cfenv>
#include <cmath>
#include <cstring>
#include <dlfcn.h>
#include <exception>
#include <filesystem>

namespace plugin_check {

namespace {

constexpr double kStep = 0.01;

/// A value with memory around it that nobody may write to.
template<class T>
class Guarded {
public:
    explicit Guarded(const T &initial)
        : value(initial)
        , m_initial(initial) {
        before.fill(kPattern);
        behind.fill(kPattern);
    }
    bool isChanged() const { return std::memcmp(&value, &m_initial, sizeof value) != 0; } // NOLINT: no padding
    bool isOverrun() const { return !isWhole(before) || !isWhole(behind); }

private:
    static constexpr unsigned char kPattern = 0xa5;
    using Guard = std::array<unsigned char, 256>; // more than an event has
    static bool isWhole(const Guard &guard) {
        return std::ranges::all_of(guard, [](unsigned char byte) { return byte == kPattern; });
    }

    alignas(16) Guard before{};

public:
    T value;

private:
    Guard behind{};
    T m_initial;
};

/// A floor and a wall, as a plugin sees them.
class Host {
public:
    Host() {
        phys_scene_desc desc;
        phys_scene_desc_init(&desc, sizeof desc);
        desc.boxes = m_boxes.data();
        desc.box_count = static_cast<uint32_t>(m_boxes.size());
        desc.radius = kRadius;
        phys_scene *scene = nullptr;
        phys_scene_create(&desc, &scene, nullptr);
        m_scene.reset(scene);
        m_view.struct_size = sizeof m_view;
        m_view.box_count = desc.box_count;
        m_view.boxes = m_boxes.data();
        m_view.radius = kRadius;
        m_view.scene = this;
        m_view.query = query;
        m_view.contacts = contacts;
    }
    const phys_scene_view *view() const { return &m_view; }

private:
    static bool overlap(const phys_box &a, const phys_box &b) {
        return a.min.x <= b.max.x && b.min.x <= a.max.x && a.min.y <= b.max.y && b.min.y <= a.max.y &&
               a.min.z <= b.max.z && b.min.z <= a.max.z;
    }
    static uint32_t query(const void *host, const phys_box *region, uint32_t *out, uint32_t capacity) {
        const Host &self = *static_cast<const Host *>(host);
        uint32_t count = 0;
        for (uint32_t i = 0; i < self.m_boxes.size(); ++i) {
            if (!overlap(self.m_boxes[i], *region)) continue;
            if (count < capacity) out[count] = i;
            ++count;
        }
        return count;
    }
    static uint32_t contacts(const void *host, const phys_vec3 *centre, double reach, phys_contact *out,
                             uint32_t capacity) {
        uint32_t count = 0;
        const Host &self = *static_cast<const Host *>(host);
        phys_scene_contacts(self.m_scene.get(), centre, reach, out, capacity, &count);
        return count;
    }

    std::array<phys_box, 2> m_boxes = {{{{-1, -1, -0.1}, {1, 1, 0}}, {{0.05, -1, 0}, {0.06, 1, 0.05}}}};
    support::ScenePtr m_scene;
    phys_scene_view m_view{};
};

bool isKnown(phys_status status) { return std::strcmp(phys_status_name(status), "unknown") != 0; }

bool isFinite(const phys_state &state) {
    for (const phys_vec3 *v : {&state.position, &state.velocity, &state.spin}) {
        if (!std::isfinite(v->x) || !std::isfinite(v->y) || !std::isfinite(v->z)) return false;
    }
    return true;
}

/// The calls in the life of one stepper; notes each breach.
class Inspection {
public:
    explicit Inspection(const phys_stepper_api &api)
        : m_api(api) {}

    std::vector<std::string> run() {
        void *self = nullptr;
        if (!create(&self)) return m_breaches;
        for (const bool withReport : {false, true}) step(self, withReport);
        refusal(self);
        requirements(self);
        guarded("destroy", [&] { m_api.destroy(self); });
        return m_breaches;
    }

private:
    /// Once, although several calls may commit it.
    void note(const std::string &breach) {
        if (std::ranges::find(m_breaches, breach) == m_breaches.end()) m_breaches.push_back(breach);
    }

    /// False if it threw.
    template<class Call>
    bool guarded(const char *function, const Call &call) {
        try {
            call();
            return true;
        } catch (const std::exception &exception) {
            note(std::string(function) + " throws an exception: " + exception.what());
        } catch (...) {
            note(std::string(function) + " throws an exception");
        }
        return false;
    }

    bool create(void **self) {
        phys_error error{};
        phys_status status = PHYS_OK;
        if (!guarded("create", [&] { status = m_api.create(m_host.view(), self, &error); })) return false;
        if (status > 0 || !isKnown(status)) note("create returns the unknown status " + std::to_string(status));
        if (status < 0) note(std::string("create refuses a floor with a wall: ") + error.text);
        return status == PHYS_OK;
    }

    phys_params initialParams() const {
        phys_params params;
        phys_params_init(&params, sizeof params);
        for (uint32_t i = 0; i < m_api.row_count; ++i) {
            phys_param_set(&params, m_api.rows[i], m_api.rows[i]->initial, nullptr);
        }
        return params;
    }

    static phys_state rollingState() {
        phys_state state{};
        state.position = {0, 0, kRadius};
        state.velocity = {0.2, 0.1, 0};
        state.spin = {-0.1 / kRadius, 0.2 / kRadius, 0};
        state.orientation[3] = 1.0;
        return state;
    }

    void step(void *self, bool withReport) {
        Guarded params(initialParams());
        Guarded in(rollingState());
        phys_state next = in.value;
        next.time = kStep;
        next.step = 1;
        Guarded out(next);
        Guarded events(std::array<phys_event, 2>{});
        phys_report told;
        phys_report_init(&told, sizeof told);
        told.events = events.value.data();
        told.event_capacity = static_cast<uint32_t>(events.value.size());
        Guarded report(told);
        phys_error noReason{};
        std::memset(noReason.text, 'x', sizeof noReason.text);
        noReason.text[0] = '\0';
        Guarded reason(noReason);
        const phys_error &error = reason.value;
        phys_status status = PHYS_OK;
        const Arithmetic arithmetic = Arithmetic::now();
        const bool isDone = guarded("step", [&] {
            status = m_api.step(self, &params.value, kStep, &in.value, &out.value, withReport ? &report.value : nullptr,
                                &reason.value);
        });
        checkArithmetic(arithmetic);
        if (in.isChanged()) note("step writes to the state it is given");
        if (params.isChanged()) note("step writes to the parameters it is given");
        const auto checkGuards = [&](const char *name, const auto &guarded) {
            if (guarded.isOverrun()) note(std::string("step writes beyond ") + name);
        };
        checkGuards("the state it is given", in);
        checkGuards("the parameters it is given", params);
        checkGuards("the state `out`", out);
        checkGuards("the report", report);
        checkGuards("the report's buffer of events", events);
        checkGuards("the error", reason);
        if (!isDone) return;
        if (status) {
            if (status > 0 || !isKnown(status)) note("step returns the unknown status " + std::to_string(status));
            if (!error.text[0]) note("step fails without a reason");
            if (!std::memchr(error.text, '\0', sizeof error.text)) note("step's reason has no end");
            if (status < 0 && isKnown(status))
                note(std::string("step refuses a ball that rolls on a floor: ") + phys_status_name(status));
            return;
        }
        checkState(out.value);
        if (withReport) checkReport(report.value, events.value.data());
    }

    /// Restores the process-wide state that anyone can change, because the rest of the check computes.
    void checkArithmetic(const Arithmetic &before) {
        const Arithmetic now = Arithmetic::now();
        if (now.rounding != before.rounding) note("step leaves another rounding than it found");
        if (now.trapped != before.trapped) note("step leaves other exceptions trapped than it found");
        if (now.hasSubnormals != before.hasSubnormals) note("step leaves subnormal numbers flushed");
        std::fesetround(before.rounding);
        fedisableexcept(FE_ALL_EXCEPT);
        feenableexcept(before.trapped);
    }

    /// A step that hardly any stepper supports; one that doesn't reports this with one line and a status of phys_step.
    void refusal(void *self) {
        const phys_params params = initialParams();
        phys_state in{};
        in.position = {0, 0, kRadius};
        in.velocity = {1e12, 0, 0};
        in.orientation[3] = 1.0;
        phys_state out = in;
        out.time = 1.0;
        out.step = 1;
        phys_error error{};
        phys_status status = PHYS_OK;
        if (!guarded("step", [&] { status = m_api.step(self, &params, 1.0, &in, &out, nullptr, &error); })) return;
        if (!status) return;
        if (!error.text[0]) note("step refuses 1e12 m/s without a reason");
        if (status < PHYS_ERROR_EVENT_CAP || status > 0)
            note(std::string("step refuses 1e12 m/s with ") + phys_status_name(status) +
                 ", which isn't one of phys_step's");
    }

    void checkState(const phys_state &out) {
        if (out.time != kStep) note("step changes the time that the host has set");
        if (out.step != 1) note("step changes the step number that the host has set");
        if (!isFinite(out)) note("step writes a number that isn't finite");
        if (out.flags & ~uint64_t{PHYS_STATE_FLAGS}) note("step sets unknown flags");
        double norm = 0;
        for (const double q : out.orientation) norm += q * q;
        if (!(std::abs(norm - 1) < 1e-6)) note("step writes an orientation that is no unit quaternion");
    }

    void checkReport(const phys_report &report, const phys_event *events) {
        if (report.events != events || report.event_capacity != 2 || report.struct_size != sizeof report) {
            note("step changes the report's size or its event buffer");
        }
        if (report.event_count > 2) note("step reports more events than there is room for");
        for (const double part : {report.penetration, report.lost_impact, report.lost_rolling, report.lost_slip}) {
            if (!std::isfinite(part)) note("step reports a number that isn't finite");
        }
    }

    void requirements(void *self) {
        if (!PHYS_HAS_SLOT(phys_stepper_api, &m_api, requirements)) return;
        const phys_params params = initialParams();
        phys_state state{};
        state.position = {0, 0, kRadius};
        state.orientation[3] = 1.0;
        phys_requirements out{};
        phys_error error{};
        phys_status status = PHYS_OK;
        if (!guarded("requirements", [&] { status = m_api.requirements(self, &params, kStep, &state, &out, &error); }))
            return;
        if (status) note(std::string("requirements fails: ") + phys_status_name(status));
        for (const char(&reason)[120] : out.reasons) {
            if (!std::memchr(reason, '\0', sizeof reason)) {
                note("requirements writes a reason without an end");
                return;
            }
        }
    }

    const phys_stepper_api &m_api;
    Host m_host;
    std::vector<std::string> m_breaches;
};

} // namespace

std::vector<std::string> breaches(const std::string &file, const std::string &stepper) {
    const std::string path = std::filesystem::absolute(file); // a plain name is looked for among the system's libraries
    void *handle = dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL); // stays loaded, as in the library's loader
    const auto *plugin = handle ? static_cast<const phys_plugin *>(dlsym(handle, "phys_plugin_entry")) : nullptr;
    if (!plugin) return {"phys_plugin_entry isn't there"};
    for (uint32_t i = 0; i < plugin->stepper_count; ++i) {
        if (plugin->steppers[i]->id == stepper) return Inspection(*plugin->steppers[i]).run();
    }
    return {"no stepper " + stepper};
}

} // namespace plugin_check
