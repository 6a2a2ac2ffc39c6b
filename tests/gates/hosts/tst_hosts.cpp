// SPDX-License-Identifier: MIT
// Hosts with another rounding mode, with subnormals flushed to zero, with trapping floating-point exceptions or with
// small stacks: the results have the same bits, and the host's setting is restored.
#include "support/handles.h"
#include "support/random.h"
#include "support/scene_builder.h"
#include "support/stepper_rows.h"

#include <QtTest>

#include <algorithm>
#include <cfenv>
#include <cstdlib>
#include <functional>
#include <pthread.h>
#include <vector>

#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

namespace {

constexpr int kSteps = 400;
constexpr double kHostDt = 0.004;

support::ScenePtr level(int number) {
    phys_scene *scene = nullptr;
    phys_scene_load(qPrintable(QStringLiteral("%1/%2.txt").arg(LEVELS).arg(number, 2, 10, QLatin1Char('0'))), &scene,
                    nullptr);
    return support::ScenePtr(scene);
}

/// Scenes of all kinds: a level, an empty scene, a start beside the floor, a room without a floor, a start in the air.
std::vector<support::ScenePtr> scenesOfAllKinds() {
    std::vector<support::ScenePtr> all;
    all.push_back(level(3));
    all.push_back(support::SceneBuilder().build());
    all.push_back(support::SceneBuilder().floor(-1, -1, 1, 1).start(3, 0).build());
    all.push_back(support::SceneBuilder().wall(1, -1, 2, 1).start(0, 0).build());
    all.push_back(support::squareRoom(1.0).start({0.5, 0.5, 0.375}).build());
    return all;
}

/// Makes all kinds of calls on one scene and hashes all results.
std::vector<uint64_t> use(const phys_scene *scene, const QByteArray &id, uint32_t model, double speed) {
    std::vector<uint64_t> results;
    phys_stepper *raw = nullptr;
    if (phys_stepper_create(nullptr, id, scene, &raw, nullptr)) return results;
    const support::StepperPtr stepper(raw);
    phys_state state;
    phys_params params;
    phys_report report;
    phys_requirements requirements;
    phys_scene_start(scene, &state);
    state.velocity = {speed, 0.25 * speed, 0.0};
    phys_params_init(&params, sizeof params);
    phys_report_init(&report, sizeof report);
    params.model = model;
    params.options = PHYS_OPTION_ORIENTATION;
    for (int step = 0; step < kSteps; ++step) {
        const double lean = 0.02 * (step / 40 % 5 - 2);
        phys_gravity_from_tilt(lean, -0.5 * lean, 9.81, &params.gravity);
        phys_stepper_requirements(stepper.get(), &params, kHostDt, &state, &requirements, nullptr);
        const phys_status status = phys_step(stepper.get(), &params, kHostDt, &state, &state, &report, nullptr);
        double energy = 0.0;
        phys_contact contacts[8];
        uint32_t count = 0;
        phys_energy(scene, &params, &state, &energy);
        phys_scene_contacts(scene, &state.position, 0.01, contacts, 8, &count);
        if (status) break;
        phys_state mixed = state;
        mixed.time = energy;
        results.push_back(phys_state_hash(&mixed) + count);
    }
    return results;
}

/// Rough and smooth hits and leaning between walls, kerbs and edges, by single steps and by a batch that counts.
void strain(const phys_scene *scene, const QByteArray &id, uint32_t model) {
    constexpr uint64_t kBalls = 16;
    phys_stepper *raw = nullptr;
    if (phys_stepper_create(nullptr, id, scene, &raw, nullptr)) return;
    const support::StepperPtr stepper(raw);
    phys_params params;
    phys_params_init(&params, sizeof params);
    params.model = model;
    params.sliding_friction = params.wall_friction = 0.5;
    params.gravity = {1.0, 0.9, -9.7};
    phys_batch batch;
    phys_batch_init(&batch, sizeof batch);
    phys_report report;
    phys_report_init(&report, sizeof report);
    uint64_t impacts[kBalls] = {};
    double lost[kBalls] = {};
    phys_status statuses[kBalls];
    phys_state states[kBalls];
    support::Random random(1);
    for (const double dt : {0.01, 0.1, 0.5}) {
        for (int times = 0; times < 4; ++times) {
            for (phys_state &state : states) {
                phys_scene_start(scene, &state);
                state.position.x = random.between(-0.09, 0.02);
                state.position.y = random.between(-0.09, 0.02);
                state.velocity = {random.between(-0.5, 0.5), random.between(-0.5, 0.5), 0.0};
                phys_state after;
                phys_step(stepper.get(), &params, dt, &state, &after, &report, nullptr);
            }
            batch.ball_count = kBalls;
            batch.step_count = 3;
            batch.dt = dt;
            batch.params = &params;
            batch.states = states;
            batch.states_stride = sizeof(phys_state);
            batch.statuses = statuses;
            batch.impacts = impacts;
            batch.energy_lost = lost;
            phys_batch_run(stepper.get(), &batch, 0, kBalls, nullptr);
        }
    }
}

/// How many bytes of its stack a thread touches.
size_t stackUsedBy(void *(*work)(void *)) {
    constexpr size_t kRoom = size_t{1} << 20;
    constexpr char kPaint = 0x5a;
    char *stack = static_cast<char *>(std::aligned_alloc(4096, kRoom));
    std::fill_n(stack, kRoom, kPaint);
    pthread_attr_t attributes;
    pthread_attr_init(&attributes);
    pthread_attr_setstack(&attributes, stack, kRoom);
    pthread_t thread{};
    pthread_create(&thread, &attributes, work, nullptr);
    pthread_join(thread, nullptr);
    pthread_attr_destroy(&attributes);
    const auto untouched =
        static_cast<size_t>(std::find_if(stack, stack + kRoom, [](char c) { return c != kPaint; }) - stack);
    std::free(stack);
    return kRoom - untouched;
}

using HostSetting = std::function<bool()>; ///< false: not on this system

bool round(int direction) { return std::fesetround(direction) == 0; }

bool flushSubnormals() {
#if defined(__SSE2__)
    _mm_setcsr(_mm_getcsr() | 0x8040); // results and arguments
    return true;
#else
    return false;
#endif
}

bool trap() { return feenableexcept(FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW) != -1; }

/// The host's view of its floating-point setting.
unsigned setting() {
#if defined(__SSE2__)
    return _mm_getcsr() & ~0x3fu;
#else
    return static_cast<unsigned>(std::fegetround());
#endif
}

/// Restores the default setting at the end, whatever a test does to it.
class Restored {
public:
    Restored() { std::fegetenv(&m_before); }
    ~Restored() { std::fesetenv(&m_before); }
    Restored(const Restored &) = delete;
    Restored &operator=(const Restored &) = delete;

private:
    std::fenv_t m_before;
};

} // namespace

class HostsTest : public QObject {
    Q_OBJECT

private slots:
    void everySettingGivesTheSameBitsAndIsKept_data() {
        QTest::addColumn<HostSetting>("set");
        QTest::newRow("rounds up") << HostSetting([] { return round(FE_UPWARD); });
        QTest::newRow("rounds down") << HostSetting([] { return round(FE_DOWNWARD); });
        QTest::newRow("rounds to zero") << HostSetting([] { return round(FE_TOWARDZERO); });
        QTest::newRow("flushes subnormals") << HostSetting(flushSubnormals);
        QTest::newRow("traps exceptions") << HostSetting(trap);
    }
    void everySettingGivesTheSameBitsAndIsKept() {
        QFETCH(HostSetting, set);
        for (const support::ScenePtr &scene : scenesOfAllKinds()) {
            for (const QByteArray &stepper : support::stepperIds()) {
                for (const uint32_t model : {PHYS_MODEL_ROLLING, PHYS_MODEL_RIGID}) {
                    for (const double speed : {0.5, 1e-300}) {
                        const std::vector<uint64_t> expected = use(scene.get(), stepper, model, speed);
                        const Restored restored;
                        if (!set()) QSKIP("not on this system");
                        const unsigned before = setting();
                        const std::vector<uint64_t> results = use(scene.get(), stepper, model, speed);
                        const unsigned after = setting();
                        std::fesetenv(FE_DFL_ENV);
                        QCOMPARE(results, expected);
                        QCOMPARE(after, before);
                    }
                }
            }
        }
    }

    void scenesAreMadeAlikeInEverySetting() {
        const support::ScenePtr expected = level(5);
        for (const int direction : {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
            const Restored restored;
            round(direction);
            const support::ScenePtr scene = level(5);
            std::fesetenv(FE_DFL_ENV);
            QCOMPARE(use(scene.get(), "exact", PHYS_MODEL_ROLLING, 0.5),
                     use(expected.get(), "exact", PHYS_MODEL_ROLLING, 0.5));
        }
    }

    void normalUseRaisesNoException_data() { support::addStepperAndModelRows(); }
    void normalUseRaisesNoException() {
        QFETCH(QByteArray, stepper);
        QFETCH(uint32_t, model);
        std::feclearexcept(FE_ALL_EXCEPT);
        for (const support::ScenePtr &scene : scenesOfAllKinds()) {
            for (const double speed : {0.0, 0.5, 1e-300}) {
                use(scene.get(), stepper, model, speed);
                QVERIFY2(!std::fetestexcept(FE_INVALID), qPrintable(QStringLiteral("at %1 m/s").arg(speed)));
                QVERIFY2(!std::fetestexcept(FE_DIVBYZERO), qPrintable(QStringLiteral("at %1 m/s").arg(speed)));
                QVERIFY2(!std::fetestexcept(FE_OVERFLOW), qPrintable(QStringLiteral("at %1 m/s").arg(speed)));
            }
        }
    }

    void aStackOf128KilobytesSuffices() {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
        QSKIP("sanitizers make the frames larger");
#endif
        const auto work = [](void *) -> void * {
            std::vector<support::ScenePtr> all = scenesOfAllKinds();
            all.push_back(support::SceneBuilder()
                              .ball(0.006)
                              .start({-0.05, -0.05, 0.006})
                              .box({{-0.1, -0.1, -0.01}, {0.1, 0.1, 0.0}})
                              .box({{0.03, -0.1, 0.0}, {0.04, 0.1, 0.02}})
                              .box({{-0.1, 0.03, 0.0}, {0.1, 0.04, 0.02}})
                              .box({{-0.02, -0.02, 0.0}, {-0.01, -0.01, 0.004}})
                              .build());
            for (const support::ScenePtr &scene : all) {
                for (const QByteArray &stepper : support::stepperIds()) {
                    for (const uint32_t model : {PHYS_MODEL_ROLLING, PHYS_MODEL_RIGID}) {
                        use(scene.get(), stepper, model, 0.5);
                        strain(scene.get(), stepper, model);
                    }
                }
            }
            phys_registry *registry = nullptr;
            phys_registry_create(&registry, nullptr);
            phys_registry_scan(registry, nullptr, nullptr, nullptr, nullptr);
            phys_registry_destroy(registry);
            return nullptr;
        };
        const size_t used = stackUsedBy(work);
        qInfo("%zu bytes used", used);
        QVERIFY(used <= size_t{128} * 1024);
    }
};

QTEST_GUILESS_MAIN(HostsTest)
#include "tst_hosts.moc"
