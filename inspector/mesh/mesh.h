// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <glm/gtc/type_precision.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace inspector::gl {

/// The appearance of a surface: a .mtl material in the shaders' terms.
struct Material {
    std::string name;
    glm::vec3 albedo{0.8F};    ///< sRGB, 0..1
    float reflectance = 0.04F; ///< at normal incidence, 0..1
    float roughness = 0.6F;    ///< 0 mirror .. 1 matt
    float grain = 0.0F;        ///< strength of the wood grain, 0..1
    float emission = 0.0F;     ///< emitted light in units of the albedo, 0..1
};

/// The material is stored per vertex, so that a whole mesh is one draw call.
struct Vertex {
    glm::vec3 position;
    glm::vec3 normal;
    glm::vec2 grain;     ///< m along and across the wood's fibres
    glm::u8vec4 albedo;  ///< sRGB; the fourth component is unused
    glm::u8vec4 surface; ///< reflectance, roughness, grain, emission
};
static_assert(sizeof(Vertex) == 40, "MeshBuffer describes this layout to OpenGL");

struct Bounds {
    glm::dvec3 minimum{0.0};
    glm::dvec3 maximum{0.0};

    glm::dvec3 centre() const { return 0.5 * (minimum + maximum); }
    glm::dvec3 size() const { return maximum - minimum; }
};

struct Mesh {
    std::vector<Vertex> vertices;
    std::vector<std::uint32_t> indices; ///< three per triangle
    Bounds bounds() const;              ///< a small board's when empty, so that camera and light have a size
};

} // namespace inspector::gl
