// SPDX-License-Identifier: MIT
#include "case.h"

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <map>
#include <sstream>
#include <stdexcept>

namespace witness {

namespace {

std::string number(double value) {
    char text[40];
    for (int digits = 1; digits <= 17; ++digits) {
        std::snprintf(text, sizeof text, "%.*g", digits, value);
        if (std::strtod(text, nullptr) == value) break;
    }
    return text;
}

std::string numbers(const phys_vec3 &v) { return number(v.x) + ' ' + number(v.y) + ' ' + number(v.z); }

/// Reads the numbers of one line; on failure throws what was expected.
class Line {
public:
    explicit Line(const std::string &rest)
        : m_stream(rest) {}

    Real real() {
        std::string word;
        m_stream >> word;
        char *end = nullptr;
        const Real value = std::strtold(word.c_str(), &end);
        if (word.empty() || *end) throw std::runtime_error("expected a number, found '" + word + "'");
        return value;
    }
    double real64() {
        std::string word;
        m_stream >> word;
        char *end = nullptr;
        const double value = std::strtod(word.c_str(), &end);
        if (word.empty() || *end) throw std::runtime_error("expected a number, found '" + word + "'");
        return value;
    }
    phys_vec3 vector64() {
        const double x = real64();
        const double y = real64();
        return {x, y, real64()};
    }
    Vector vector() {
        const Real x = real();
        const Real y = real();
        return {x, y, real()};
    }
    std::string text() {
        std::string text;
        std::getline(m_stream >> std::ws, text);
        return text;
    }

private:
    std::istringstream m_stream;
};

using Reader = std::function<void(Case &, Line &)>;

const std::map<std::string, Reader> &readers() {
    static const std::map<std::string, Reader> kReaders = {
        {"note", [](Case &c, Line &line) { c.note += (c.note.empty() ? "" : "\n") + line.text(); }},
        {"stepper", [](Case &c, Line &line) { c.stepper = line.text(); }},
        {"check", [](Case &c, Line &line) { c.check = line.text(); }},
        {"model",
         [](Case &c, Line &line) {
             const std::string word = line.text();
             if (word != "rolling" && word != "rigid") throw std::runtime_error("expected rolling or rigid");
             c.params.model = word == "rigid" ? PHYS_MODEL_RIGID : PHYS_MODEL_ROLLING;
         }},
        {"radius", [](Case &c, Line &line) { c.radius = line.real64(); }},
        {"box",
         [](Case &c, Line &line) {
             const phys_vec3 low = line.vector64();
             c.boxes.push_back({low, line.vector64()});
         }},
        {"rolling_friction", [](Case &c, Line &line) { c.params.rolling_friction = line.real64(); }},
        {"sliding_friction", [](Case &c, Line &line) { c.params.sliding_friction = line.real64(); }},
        {"wall_friction", [](Case &c, Line &line) { c.params.wall_friction = line.real64(); }},
        {"restitution_floor", [](Case &c, Line &line) { c.params.restitution_floor = line.real64(); }},
        {"restitution_wall", [](Case &c, Line &line) { c.params.restitution_wall = line.real64(); }},
        {"position", [](Case &c, Line &line) { c.start.position = line.vector64(); }},
        {"velocity", [](Case &c, Line &line) { c.start.velocity = line.vector64(); }},
        {"spin", [](Case &c, Line &line) { c.start.spin = line.vector64(); }},
        {"steps",
         [](Case &c, Line &line) {
             Leg leg{};
             leg.steps = static_cast<uint32_t>(line.real64());
             leg.dt = line.real64();
             leg.gravity = line.vector64();
             c.legs.push_back(leg);
         }},
        {"sample",
         [](Case &c, Line &line) {
             Sample sample{};
             sample.time = line.real();
             sample.place = line.vector();
             sample.velocity = line.vector();
             sample.spin = line.vector();
             sample.isAtRest = line.real() != 0;
             c.samples.push_back(sample);
         }},
    };
    return kReaders;
}

} // namespace

double Case::duration() const {
    double sum = 0.0;
    for (const Leg &leg : legs) sum += leg.dt * leg.steps;
    return sum;
}

uint64_t Case::stepCount() const {
    uint64_t sum = 0;
    for (const Leg &leg : legs) sum += leg.steps;
    return sum;
}

phys_scene_desc descOf(const std::vector<phys_box> &boxes, double radius, const phys_vec3 &start) {
    phys_scene_desc desc;
    phys_scene_desc_init(&desc, sizeof desc);
    desc.boxes = boxes.data();
    desc.box_count = static_cast<uint32_t>(boxes.size());
    desc.radius = radius;
    desc.start = start;
    return desc;
}

Case emptyCase() {
    Case scene;
    phys_params_init(&scene.params, sizeof scene.params);
    scene.start.orientation[3] = 1.0;
    return scene;
}

std::string textOf(const Case &scene) {
    std::string text = "case " + scene.name + '\n';
    std::istringstream note(scene.note);
    for (std::string line; std::getline(note, line);) text += "note " + line + '\n';
    if (!scene.stepper.empty()) text += "stepper " + scene.stepper + '\n';
    if (!scene.check.empty()) text += "check " + scene.check + '\n';
    text += std::string("model ") + (scene.params.model == PHYS_MODEL_RIGID ? "rigid" : "rolling") + '\n';
    text += "radius " + number(scene.radius) + '\n';
    for (const phys_box &box : scene.boxes) text += "box " + numbers(box.min) + "  " + numbers(box.max) + '\n';
    text += "rolling_friction " + number(scene.params.rolling_friction) + '\n';
    text += "sliding_friction " + number(scene.params.sliding_friction) + '\n';
    text += "wall_friction " + number(scene.params.wall_friction) + '\n';
    text += "restitution_floor " + number(scene.params.restitution_floor) + '\n';
    text += "restitution_wall " + number(scene.params.restitution_wall) + '\n';
    text += "position " + numbers(scene.start.position) + '\n';
    text += "velocity " + numbers(scene.start.velocity) + '\n';
    text += "spin " + numbers(scene.start.spin) + '\n';
    for (const Leg &leg : scene.legs) {
        text += "steps " + std::to_string(leg.steps) + ' ' + number(leg.dt) + "  " + numbers(leg.gravity) + '\n';
    }
    return text;
}

std::vector<Case> readCases(const std::string &path) {
    std::ifstream file(path);
    if (!file) throw std::runtime_error(path + ": can't be read");
    std::vector<Case> cases;
    int lineNumber = 0;
    for (std::string text; std::getline(file, text);) {
        ++lineNumber;
        std::istringstream stream(text);
        std::string key;
        if (!(stream >> key) || key[0] == '#') continue;
        std::string rest;
        std::getline(stream, rest);
        Line line(rest);
        try {
            if (key == "case") {
                cases.push_back(emptyCase());
                cases.back().name = line.text();
                continue;
            }
            const auto reader = readers().find(key);
            if (cases.empty()) throw std::runtime_error("expected 'case NAME' first");
            if (reader == readers().end()) throw std::runtime_error("'" + key + "' is no line of a case");
            reader->second(cases.back(), line);
        } catch (const std::runtime_error &error) {
            throw std::runtime_error(path + ":" + std::to_string(lineNumber) + ": " + error.what());
        }
    }
    return cases;
}

} // namespace witness
