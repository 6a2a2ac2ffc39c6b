// SPDX-License-Identifier: MIT
// Random scenes, balls and parameters that are the same on every system, and a hash of the results.
#pragma once

#include <physics/physics.h>

#include <bit>
#include <cstdint>
#include <vector>

namespace bits {

/// FNV-1a over the bytes of words, least significant first: the same on big-endian processors.
class Hash {
public:
    void add(uint64_t word) {
        for (int byte = 0; byte < 8; ++byte, word >>= 8) m_value = (m_value ^ (word & 0xff)) * 0x100000001b3U;
    }
    void add(double number) { add(std::bit_cast<uint64_t>(number)); }
    void add(const phys_vec3 &v) {
        for (const double number : {v.x, v.y, v.z}) add(number);
    }
    void add(const phys_report &report);
    void addContacts(const phys_scene *scene, const phys_vec3 &centre, double reach);
    uint64_t value() const { return m_value; }

private:
    uint64_t m_value = 0xcbf29ce484222325U;
};

class RandomScene {
public:
    explicit RandomScene(uint64_t seed)
        : m_state(seed) {}

    /// Boxes around a ball: floors, walls, kerbs, shelves, tiles, on a raster or anywhere.
    phys_status create(phys_scene **out);
    void fill(const phys_stepper_info &info, uint32_t model, phys_params &params);
    phys_vec3 velocity();
    double dt();     ///< s
    double length(); ///< of the size of a ball, m

private:
    uint64_t next();
    double between(double low, double high);
    bool oneIn(uint64_t count) { return next() % count == 0; }
    phys_box box();
    double place(double size);

    uint64_t m_state;
    bool m_onRaster = false;
};

} // namespace bits
