// SPDX-License-Identifier: MIT
// A plugin's view of a scene: the host's queries compared with a test of every box.
#include <QTest>

#include <physics/plugin.h>

#include <array>
#include <random>
#include <vector>

namespace {

constexpr unsigned kSeed = 20240607;

bool touch(const phys_box &a, const phys_box &b) {
    return a.min.x <= b.max.x && b.min.x <= a.max.x && a.min.y <= b.max.y && b.min.y <= a.max.y && a.min.z <= b.max.z &&
           b.min.z <= a.max.z;
}

/// Boxes with corners on a grid of half radii, so that many touch, overlap and merge.
class RandomBoxes {
public:
    phys_box box(double extent) {
        const auto interval = [&](double span) {
            const double low = 0.5 * std::uniform_int_distribution<int>(0, static_cast<int>(2 * span))(m_random);
            return std::array<double, 2>{low, low + 0.5 * std::uniform_int_distribution<int>(0, 6)(m_random)};
        };
        const auto x = interval(extent);
        const auto y = interval(extent);
        const auto z = interval(4.0);
        return {{x[0], y[0], z[0]}, {x[1], y[1], z[1]}};
    }

private:
    std::mt19937 m_random{kSeed};
};

} // namespace

class PluginView : public QObject {
    Q_OBJECT

private slots:
    void initTestCase();
    void cleanupTestCase();
    void describesTheScene();
    void queryFindsWhatALookAtEveryBoxFinds();
    void aShortBufferGetsTheLowestNumbers();
    void aRegionThatIsNoBoxTouchesNothing();
    void nothingIsFoundForNull();
    void contactsAreTheLibrarys();

private:
    std::vector<uint32_t> query(const phys_box &region, size_t capacity) const {
        std::vector<uint32_t> found(capacity);
        const uint32_t count = m_view->query(m_view->scene, &region, found.data(), static_cast<uint32_t>(capacity));
        found.resize(std::min<size_t>(count, capacity));
        return found;
    }

    std::vector<phys_box> m_boxes;
    phys_registry *m_registry = nullptr;
    phys_scene *m_scene = nullptr;
    phys_stepper *m_stepper = nullptr;
    const phys_scene_view *m_view = nullptr;
};

void PluginView::initTestCase() {
    RandomBoxes random;
    m_boxes.push_back({{0, 0, -1}, {20, 40, 0}});
    m_boxes.push_back({{20, 0, -1}, {40, 40, 0}});
    for (int i = 0; i < 300; ++i) m_boxes.push_back(random.box(40.0));
    phys_scene_desc desc;
    phys_scene_desc_init(&desc, sizeof desc);
    desc.boxes = m_boxes.data();
    desc.box_count = static_cast<uint32_t>(m_boxes.size());
    desc.radius = 1.0;
    desc.start = {1, 1, 1};
    phys_error error{};
    QVERIFY2(phys_scene_create(&desc, &m_scene, &error) == PHYS_OK, error.text);
    QCOMPARE(phys_registry_create(&m_registry, &error), PHYS_OK);
    QVERIFY2(phys_registry_load_file(m_registry, FIXTURES "/lending/view.so", &error) == PHYS_OK, error.text);
    QVERIFY2(phys_stepper_create(m_registry, "view", m_scene, &m_stepper, &error) == PHYS_OK, error.text);

    phys_params params;
    phys_params_init(&params, sizeof params);
    phys_state state;
    phys_scene_start(m_scene, &state);
    phys_event event{};
    phys_report report;
    phys_report_init(&report, sizeof report);
    report.events = &event;
    report.event_capacity = 1;
    QVERIFY2(phys_step(m_stepper, &params, 1.0, &state, &state, &report, &error) == PHYS_OK, error.text);
    std::memcpy(&m_view, &event, sizeof m_view);
}

void PluginView::cleanupTestCase() {
    phys_stepper_destroy(m_stepper);
    phys_registry_destroy(m_registry);
    phys_scene_destroy(m_scene);
}

void PluginView::describesTheScene() {
    QCOMPARE(m_view->struct_size, sizeof(phys_scene_view));
    QCOMPARE(m_view->box_count, m_boxes.size());
    QCOMPARE(std::memcmp(m_view->boxes, m_boxes.data(), m_boxes.size() * sizeof(phys_box)), 0);
    QCOMPARE(m_view->radius, 1.0);
}

void PluginView::queryFindsWhatALookAtEveryBoxFinds() {
    RandomBoxes random;
    for (int round = 0; round < 2000; ++round) {
        const phys_box region = random.box(44.0); // some reach outside of all boxes
        std::vector<uint32_t> expected;
        for (uint32_t i = 0; i < m_boxes.size(); ++i) {
            if (touch(m_boxes[i], region)) expected.push_back(i);
        }
        QVERIFY2(query(region, m_boxes.size()) == expected,
                 qPrintable(QStringLiteral("seed %1, round %2").arg(kSeed).arg(round)));
    }
}

void PluginView::aShortBufferGetsTheLowestNumbers() {
    const phys_box everything{{-1e9, -1e9, -1e9}, {1e9, 1e9, 1e9}};
    QCOMPARE(query(everything, 5), (std::vector<uint32_t>{0, 1, 2, 3, 4}));
    QCOMPARE(m_view->query(m_view->scene, &everything, nullptr, 0), m_boxes.size());
}

void PluginView::aRegionThatIsNoBoxTouchesNothing() {
    QCOMPARE(query({{1, 0, 0}, {0, 1, 1}}, 5), std::vector<uint32_t>{});
    QCOMPARE(query({{qQNaN(), 0, 0}, {1, 1, 1}}, 5), std::vector<uint32_t>{});
}

void PluginView::nothingIsFoundForNull() {
    const phys_box everything{{-100, -100, -100}, {100, 100, 100}};
    const phys_vec3 centre{10, 10, 1};
    uint32_t box = 7;
    phys_contact contact{};
    QCOMPARE(m_view->query(nullptr, &everything, &box, 1), 0U);
    QCOMPARE(m_view->query(m_view->scene, nullptr, &box, 1), 0U);
    QCOMPARE(m_view->query(m_view->scene, &everything, nullptr, 1), 0U);
    QCOMPARE(m_view->contacts(nullptr, &centre, 2.0, &contact, 1), 0U);
    QCOMPARE(m_view->contacts(m_view->scene, nullptr, 2.0, &contact, 1), 0U);
    QCOMPARE(m_view->contacts(m_view->scene, &centre, 2.0, nullptr, 1), 0U);
    QCOMPARE(box, 7U);
}

void PluginView::contactsAreTheLibrarys() {
    const phys_vec3 centre{10, 10, 1};
    std::array<phys_contact, 64> expected{};
    std::array<phys_contact, 64> found{};
    uint32_t count = 0;
    QCOMPARE(phys_scene_contacts(m_scene, &centre, 2.0, expected.data(), expected.size(), &count), PHYS_OK);
    QVERIFY(count > 0);
    QCOMPARE(m_view->contacts(m_view->scene, &centre, 2.0, found.data(), found.size()), count);
    QCOMPARE(std::memcmp(found.data(), expected.data(), sizeof found), 0);
}

QTEST_GUILESS_MAIN(PluginView)
#include "tst_plugin_view.moc"
