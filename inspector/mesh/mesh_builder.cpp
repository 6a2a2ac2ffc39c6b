// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/mesh_builder.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace inspector::gl {

namespace {

std::uint8_t toByte(float value) {
    return static_cast<std::uint8_t>(std::lround(glm::clamp(value, 0.0F, 1.0F) * 255.0F));
}

/// A pseudo-random number in 0..1, always the same for the same piece.
float scatter(unsigned index, unsigned salt) {
    unsigned hash = index * 0x9E3779B9U + salt * 0x85EBCA6BU;
    hash = (hash ^ (hash >> 15)) * 0x2C1B3C6DU;
    hash ^= hash >> 13;
    return static_cast<float>(hash & 0xFFFFU) / 65535.0F;
}

} // namespace

void MeshBuilder::beginPiece(const Material &material, const Bounds &bounds) {
    // Vary the colour between planks.
    const float shade = 1.0F + 0.10F * material.grain * (scatter(m_pieces, 3) - 0.5F);
    const glm::vec3 albedo = material.albedo * shade;
    m_prototype.albedo = {toByte(albedo.r), toByte(albedo.g), toByte(albedo.b), 255};
    m_prototype.surface = {toByte(material.reflectance), toByte(material.roughness), toByte(material.grain),
                           toByte(material.emission)};
    m_alongY = bounds.size().y > bounds.size().x;
    m_grainOrigin = {scatter(m_pieces, 1), scatter(m_pieces, 2)};
    m_pieceBegin = m_mesh.vertices.size();
    ++m_pieces;
}

glm::vec2 MeshBuilder::grainCoordinate(const glm::vec3 &position, const glm::vec3 &normal) const {
    const float along = m_alongY ? position.y : position.x;
    const float side = m_alongY ? position.x : position.y;
    // Top and bottom show the plank's width, its sides the height, and its ends (cut fibres) both.
    const bool isEnd = std::abs(m_alongY ? normal.y : normal.x) > 0.8F;
    if (isEnd) return m_grainOrigin + glm::vec2(side, position.z);
    return m_grainOrigin + glm::vec2(along, std::abs(normal.z) > 0.6F ? side : position.z);
}

void MeshBuilder::triangle(const std::array<glm::vec3, 3> &positions, const std::array<glm::vec3, 3> &normals) {
    for (std::size_t i = 0; i < 3; ++i) {
        m_prototype.position = positions[i];
        m_prototype.normal = normals[i];
        m_prototype.grain = grainCoordinate(positions[i], normals[i]);
        m_mesh.indices.push_back(indexOf(m_prototype));
    }
}

/// Equal vertices of adjacent triangles are among the last few, so only those are searched.
std::uint32_t MeshBuilder::indexOf(const Vertex &vertex) {
    constexpr std::size_t kLookBack = 8;
    std::vector<Vertex> &vertices = m_mesh.vertices;
    const std::size_t oldest = std::max(m_pieceBegin, vertices.size() - std::min(vertices.size(), kLookBack));
    for (std::size_t i = vertices.size(); i-- > oldest;) {
        if (vertices[i].position == vertex.position && vertices[i].normal == vertex.normal)
            return static_cast<std::uint32_t>(i);
    }
    vertices.push_back(vertex);
    return static_cast<std::uint32_t>(vertices.size() - 1);
}

void MeshBuilder::polygon(std::span<const glm::vec3> corners, const glm::vec3 &normal) {
    for (std::size_t i = 2; i < corners.size(); ++i)
        triangle({corners[0], corners[i - 1], corners[i]}, {normal, normal, normal});
}

Mesh MeshBuilder::take() { return std::exchange(m_mesh, {}); }

Material boxMaterial(BoxKind kind) {
    switch (kind) {
    case BoxKind::Floor:
        return {"floor", {0.87F, 0.74F, 0.55F}, 0.04F, 0.55F, 1.0F, 0.0F};
    case BoxKind::Wall:
        return {"wall", {0.56F, 0.34F, 0.19F}, 0.04F, 0.40F, 0.8F, 0.0F};
    case BoxKind::Rim:
        return {"rim", {0.36F, 0.21F, 0.13F}, 0.05F, 0.32F, 0.8F, 0.0F};
    case BoxKind::Exit:
        return {"exit", {0.10F, 0.66F, 0.50F}, 0.04F, 0.35F, 0.0F, 0.25F};
    }
    return {};
}

namespace {

/// A box whose four upper edges are cut off by `chamfer` metres at 45 degrees.
void addChamferedBox(MeshBuilder &builder, const MazeBox &box, float chamfer) {
    const glm::vec3 lo = box.minimum;
    const glm::vec3 hi = box.maximum;
    const float shoulder = hi.z - chamfer;
    // Four rings of corners, counter-clockwise from above: bottom, shoulder, and the top drawn in by the chamfer.
    const auto ring = [&](float inset, float z) {
        return std::array{glm::vec3(lo.x + inset, lo.y + inset, z), glm::vec3(hi.x - inset, lo.y + inset, z),
                          glm::vec3(hi.x - inset, hi.y - inset, z), glm::vec3(lo.x + inset, hi.y - inset, z)};
    };
    const auto bottom = ring(0.0F, lo.z);
    const auto middle = ring(0.0F, shoulder);
    const auto top = ring(chamfer, hi.z);
    constexpr std::array kOutward{glm::vec3(0, -1, 0), glm::vec3(1, 0, 0), glm::vec3(0, 1, 0), glm::vec3(-1, 0, 0)};

    builder.polygon(top, {0, 0, 1});
    builder.polygon(std::array{bottom[3], bottom[2], bottom[1], bottom[0]}, {0, 0, -1});
    for (std::size_t i = 0; i < 4; ++i) {
        const std::size_t next = (i + 1) % 4;
        builder.polygon(std::array{bottom[i], bottom[next], middle[next], middle[i]}, kOutward[i]);
        const glm::vec3 slanted = glm::normalize(kOutward[i] + glm::vec3(0, 0, 1));
        builder.polygon(std::array{middle[i], middle[next], top[next], top[i]}, slanted);
    }
}

} // namespace

Mesh mazeFromBoxes(std::span<const MazeBox> boxes) {
    MeshBuilder builder;
    for (const MazeBox &box : boxes) {
        builder.beginPiece(boxMaterial(box.kind), {box.minimum, box.maximum});
        const glm::dvec3 size = box.maximum - box.minimum;
        const bool isFlat = box.kind == BoxKind::Floor || box.kind == BoxKind::Exit;
        const double chamfer = isFlat ? 0.0 : 0.12 * std::min({size.x, size.y, size.z});
        addChamferedBox(builder, box, static_cast<float>(chamfer));
    }
    return builder.take();
}

Mesh patternedBall() {
    constexpr int kStacks = 32;
    constexpr int kSlices = 48;
    const Material light{"ball light", {0.93F, 0.93F, 0.91F}, 0.06F, 0.12F, 0.0F, 0.0F};
    const Material dark{"ball dark", {0.80F, 0.12F, 0.10F}, 0.06F, 0.12F, 0.0F, 0.0F};
    const auto at = [](int stack, int slice) {
        const double latitude = std::numbers::pi * stack / kStacks;
        const double longitude = 2.0 * std::numbers::pi * (slice % kSlices) / kSlices;
        return glm::vec3(std::sin(latitude) * std::cos(longitude), std::sin(latitude) * std::sin(longitude),
                         std::cos(latitude));
    };
    MeshBuilder builder;
    for (int stack = 0; stack < kStacks; ++stack) {
        for (int slice = 0; slice < kSlices; ++slice) {
            // Eight fields like those of a beach ball, swapped at the equator, so that only a full turn looks like
            // none.
            const bool isDark = (slice / (kSlices / 8) + stack / (kStacks / 2)) % 2 == 0;
            builder.beginPiece(isDark ? dark : light, {});
            const glm::vec3 a = at(stack, slice);
            const glm::vec3 b = at(stack + 1, slice);
            const glm::vec3 c = at(stack + 1, slice + 1);
            const glm::vec3 d = at(stack, slice + 1);
            if (stack + 1 < kStacks) builder.triangle({a, b, c}, {a, b, c});
            if (stack > 0) builder.triangle({a, c, d}, {a, c, d});
        }
    }
    return builder.take();
}

} // namespace inspector::gl
