// SPDX-License-Identifier: MIT
#include "random_scene.h"

namespace bits {

namespace {

constexpr double kRadius = 0.0625;

} // namespace

void Hash::add(const phys_report &report) {
    for (const uint32_t number : {report.event_count, report.events_lost, report.substeps, report.passes}) {
        add(static_cast<uint64_t>(number));
    }
    for (const double number : {report.penetration, report.energy_before, report.energy_after, report.lost_impact,
                                report.lost_rolling, report.lost_slip, report.energy_scheme}) {
        add(number);
    }
    for (uint32_t i = 0; i < report.event_count; ++i) {
        const phys_event &event = report.events[i];
        add(event.time);
        add(event.point);
        add(event.normal);
        add(event.speed_before);
        add(event.speed_after);
        add(static_cast<uint64_t>(event.kind) << 32 | event.box);
    }
}

void Hash::addContacts(const phys_scene *scene, const phys_vec3 &centre, double reach) {
    phys_contact contacts[16];
    uint32_t count = 0;
    add(static_cast<uint64_t>(phys_scene_contacts(scene, &centre, reach, contacts, 16, &count)));
    for (uint32_t i = 0; i < count && i < 16; ++i) {
        add(contacts[i].point);
        add(contacts[i].normal);
        add(contacts[i].gap);
        add(static_cast<uint64_t>(contacts[i].feature) << 32 | contacts[i].box);
    }
}

uint64_t RandomScene::next() { // SplitMix64
    uint64_t z = m_state += 0x9e3779b97f4a7c15U;
    z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9U;
    z = (z ^ z >> 27) * 0x94d049bb133111ebU;
    return z ^ z >> 31;
}

double RandomScene::between(double low, double high) {
    return low + (high - low) * (static_cast<double>(next() >> 11) * 0x1p-53);
}

/// A coordinate: on a raster of the ball's radius or anywhere.
double RandomScene::place(double size) {
    if (!m_onRaster) return between(-size, size);
    const int steps = static_cast<int>(size / kRadius);
    return kRadius * static_cast<double>(static_cast<int>(next() % static_cast<uint64_t>(2 * steps + 1)) - steps);
}

phys_box RandomScene::box() {
    phys_box box{{place(1.0), place(1.0), 0.0}, {}};
    box.max = {box.min.x + between(0.0, 0.5), box.min.y + between(0.0, 0.5), 0.25};
    if (m_onRaster) {
        const int across = 1 + static_cast<int>(next() % 6), along = 1 + static_cast<int>(next() % 6);
        box.max = {box.min.x + kRadius * across, box.min.y + kRadius * along, 0.25};
    }
    if (oneIn(4)) box.max.z = between(0.0, 0.2); // a kerb, or a top to roll on
    if (oneIn(6)) box.min.z = between(0.0, box.max.z);
    return box;
}

phys_status RandomScene::create(phys_scene **out) {
    std::vector<phys_box> boxes;
    m_onRaster = oneIn(2);
    if (!oneIn(8)) boxes.push_back({{-1.0, -1.0, -0.1}, {oneIn(3) ? 0.25 : 1.0, 1.0, 0.0}});
    if (oneIn(3)) boxes.push_back({{0.25, -1.0, -0.1}, {1.0, 1.0, 0.0}});
    for (uint64_t count = next() % 9; count > 0; --count) boxes.push_back(box());
    phys_scene_desc desc;
    phys_scene_desc_init(&desc, sizeof desc);
    desc.boxes = boxes.data();
    desc.box_count = static_cast<uint32_t>(boxes.size());
    desc.radius = kRadius;
    desc.start = {place(0.5), place(0.5), oneIn(3) ? between(kRadius, 0.5) : kRadius};
    return phys_scene_create(&desc, out, nullptr);
}

void RandomScene::fill(const phys_stepper_info &info, uint32_t model, phys_params &params) {
    phys_params_init(&params, sizeof params);
    phys_stepper_info_init_params(&info, &params);
    params.model = model;
    params.options = PHYS_OPTION_ORIENTATION;
    const double steep = oneIn(10) ? 1.5 : 0.2;
    const double tilts[] = {between(-steep, steep), between(-steep, steep)}; // arguments have no order of evaluation
    phys_gravity_from_tilt(tilts[0], tilts[1], 9.81, &params.gravity);
    params.restitution_wall = oneIn(4) ? 1.0 : between(0.0, 1.0);
    params.restitution_floor = oneIn(4) ? 0.0 : between(0.0, 1.0);
    params.sliding_friction = between(0.0, 0.6);
    params.rolling_friction = oneIn(3) ? 0.0 : between(0.0, 0.05) * params.sliding_friction;
    params.wall_friction = oneIn(3) ? 0.0 : between(0.0, 0.6);
}

phys_vec3 RandomScene::velocity() {
    const double speed = oneIn(4) ? 0.0 : between(0.0, 3.0);
    return {between(-speed, speed), between(-speed, speed), oneIn(3) ? between(-speed, speed) : 0.0};
}

double RandomScene::dt() { return oneIn(8) ? between(0.0, 0.2) : between(0.0005, 0.02); }

double RandomScene::length() { return between(0.0, 2.0 * kRadius); }

} // namespace bits
