// SPDX-License-Identifier: MIT
// Misuses the library in ways that a sanitizer must detect in the library's own code.
// Usage: misuse LEVEL overrun|undefined|leak|race
#include <physics/physics.h>

#include <cstdio>
#include <cstring>
#include <memory>
#include <string_view>
#include <thread>
#include <vector>

namespace {

constexpr int kSteps = 1000;

struct Ball {
    phys_scene *scene = nullptr;
    phys_stepper *stepper = nullptr;
    phys_state state{};
    phys_params params{};

    explicit Ball(const char *level) {
        if (phys_scene_load(level, &scene, nullptr)) return;
        phys_stepper_create(nullptr, "exact", scene, &stepper, nullptr);
        phys_scene_start(scene, &state);
        phys_params_init(&params, sizeof params);
        phys_gravity_from_tilt(0.1, 0.05, 9.81, &params.gravity);
    }
    Ball(const Ball &) = delete;
    Ball &operator=(const Ball &) = delete;
    ~Ball() {
        phys_stepper_destroy(stepper);
        phys_scene_destroy(scene);
    }
};

/// The library is told of more room for events than there is, and fills it.
void overrun(Ball &ball) {
    const std::unique_ptr<phys_event> room(new phys_event);
    phys_report report;
    phys_report_init(&report, sizeof report);
    report.events = room.get();
    report.event_capacity = 64;
    phys_step(ball.stepper, &ball.params, 10.0, &ball.state, &ball.state, &report, nullptr);
}

/// The library reads numbers from a misaligned address.
void readMisaligned(Ball &ball) {
    std::vector<char> bytes(sizeof ball.state + 1);
    std::memcpy(bytes.data() + 1, &ball.state, sizeof ball.state);
    const void *address = bytes.data() + 1;
    phys_step(ball.stepper, &ball.params, 0.01, static_cast<const phys_state *>(address), &ball.state, nullptr,
              nullptr);
}

void leak(Ball &ball) { ball.scene = nullptr; }

/// Two threads use one stepper at the same time.
void race(Ball &ball) {
    const auto roll = [&ball] {
        phys_state state = ball.state;
        phys_params params = ball.params;
        for (int i = 0; i < kSteps; ++i) {
            params.gravity.x = i % 2 ? 0.5 : -0.5;
            phys_step(ball.stepper, &params, 0.01, &state, &state, nullptr, nullptr);
        }
    };
    std::thread other(roll);
    roll();
    other.join();
}

struct Misuse {
    std::string_view name;
    void (*run)(Ball &ball);
};
constexpr Misuse kMisuses[] = {{"overrun", overrun}, {"undefined", readMisaligned}, {"leak", leak}, {"race", race}};

} // namespace

int main(int argc, char **argv) {
    for (const Misuse &misuse : kMisuses) {
        if (argc != 3 || misuse.name != argv[2]) continue;
        Ball ball(argv[1]);
        if (!ball.stepper) break;
        misuse.run(ball);
        std::puts("misuse: nobody noticed");
        return 0;
    }
    std::fputs("misuse: expected LEVEL overrun|undefined|leak|race\n", stderr);
    return 2;
}
