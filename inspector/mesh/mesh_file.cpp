// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/mesh_file.h"

#include "core/setup/files.h"
#include "core/setup/lines.h"
#include "mesh/mesh_builder.h"
#include "mesh/obj_text.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <tiny_obj_loader.h>

namespace inspector::gl {

namespace {

constexpr qint64 kLargestMesh = 200 * kMegabyte;
constexpr qint64 kLargestMaterials = 10 * kMegabyte;

/// The loader's result for the checked text.
struct Loaded {
    tinyobj::attrib_t attributes;
    std::vector<tinyobj::shape_t> shapes;
    std::vector<tinyobj::material_t> materials;
};

/// Returns the checked materials, whichever file the loader requests.
class CheckedMaterials : public tinyobj::MaterialReader {
public:
    explicit CheckedMaterials(const QByteArray &text)
        : m_text(text.toStdString()) {}

    bool operator()(const std::string &, std::vector<tinyobj::material_t> *materials, std::map<std::string, int> *map,
                    std::string *warning, std::string *error) override {
        tinyobj::LoadMtl(map, materials, &m_text, warning, error);
        return true;
    }

private:
    std::istringstream m_text;
};

std::optional<Loaded> load(const CheckedObj &checked, QString *error) {
    Loaded loaded;
    std::istringstream shapes("mtllib checked\n" + checked.shapes.toStdString());
    CheckedMaterials materials(checked.materials);
    std::string warning; // about missing materials, which the note reports
    std::string reason;
    if (tinyobj::LoadObj(&loaded.attributes, &loaded.shapes, &loaded.materials, &warning, &reason, &shapes, &materials))
        return loaded;
    *error = QStringLiteral(" ") + oneLine(QString::fromStdString(reason).simplified());
    return std::nullopt;
}

Material materialOf(const tinyobj::material_t &source) {
    const auto strongest = [](const float *rgb) { return std::max({rgb[0], rgb[1], rgb[2]}); };
    Material material;
    material.name = source.name;
    material.albedo = glm::clamp(glm::vec3(source.diffuse[0], source.diffuse[1], source.diffuse[2]), 0.0F, 1.0F);
    // Ks 0.5 stands for the 4 % reflectance of wood, paint and plastic; Blinn's exponent is converted to a roughness.
    material.reflectance = 0.08F * strongest(source.specular);
    material.roughness = std::pow(2.0F / (std::max(source.shininess, 0.0F) + 2.0F), 0.25F);
    material.emission = strongest(source.emission) / std::max(strongest(source.diffuse), 0.05F);
    // Materials that emit light aren't wood.
    material.grain = material.emission > 0.0F ? 0.0F : 1.0F;
    return material;
}

glm::vec3 vectorAt(const std::vector<tinyobj::real_t> &values, int index) {
    const auto first = static_cast<std::size_t>(index) * 3;
    return {values[first], values[first + 1], values[first + 2]};
}

/// Checks that the loader has lost nothing: it counts and triangulates on its own.
bool isComplete(const Loaded &loaded) {
    const auto has = [](const std::vector<tinyobj::real_t> &values, int index) {
        return index >= 0 && static_cast<std::size_t>(index) * 3 + 2 < values.size();
    };
    const auto isGood = [&](const tinyobj::index_t &index) {
        return has(loaded.attributes.vertices, index.vertex_index) &&
               (index.normal_index < 0 || has(loaded.attributes.normals, index.normal_index));
    };
    return std::all_of(loaded.shapes.begin(), loaded.shapes.end(), [&](const tinyobj::shape_t &shape) {
        const std::size_t faces = shape.mesh.num_face_vertices.size();
        const auto isKnown = [&](int id) { return id < static_cast<int>(loaded.materials.size()); };
        return shape.mesh.indices.size() == 3 * faces && shape.mesh.material_ids.size() == faces &&
               std::all_of(shape.mesh.indices.begin(), shape.mesh.indices.end(), isGood) &&
               std::all_of(shape.mesh.material_ids.begin(), shape.mesh.material_ids.end(), isKnown);
    });
}

Bounds shapeBounds(const tinyobj::attrib_t &attributes, const tinyobj::shape_t &shape) {
    if (shape.mesh.indices.empty()) return {};
    glm::vec3 minimum = vectorAt(attributes.vertices, shape.mesh.indices.front().vertex_index);
    glm::vec3 maximum = minimum;
    for (const tinyobj::index_t &index : shape.mesh.indices) {
        minimum = glm::min(minimum, vectorAt(attributes.vertices, index.vertex_index));
        maximum = glm::max(maximum, vectorAt(attributes.vertices, index.vertex_index));
    }
    return {minimum, maximum};
}

/// False for a degenerate triangle, which has no normal and no pixels.
bool addTriangle(MeshBuilder &builder, const tinyobj::attrib_t &attributes, const tinyobj::index_t *corners) {
    std::array<glm::vec3, 3> positions;
    std::array<glm::vec3, 3> normals;
    for (std::size_t i = 0; i < 3; ++i) positions[i] = vectorAt(attributes.vertices, corners[i].vertex_index);
    // Computed in double, because the area of a small face underflows in float.
    const glm::dvec3 area = glm::cross(glm::dvec3(positions[1]) - glm::dvec3(positions[0]),
                                       glm::dvec3(positions[2]) - glm::dvec3(positions[0]));
    if (glm::length(area) == 0.0) return false;
    for (std::size_t i = 0; i < 3; ++i) {
        const int index = corners[i].normal_index;
        const glm::dvec3 given = index < 0 ? area : glm::dvec3(vectorAt(attributes.normals, index));
        normals[i] = glm::normalize(glm::length(given) > 0.0 ? given : area);
    }
    builder.triangle(positions, normals);
    return true;
}

/// Adds the faces except degenerate ones, whose number it returns.
int addShape(MeshBuilder &builder, const Loaded &loaded, const tinyobj::shape_t &shape) {
    const Bounds bounds = shapeBounds(loaded.attributes, shape);
    int current = -2; // not a valid material number
    int slivers = 0;
    for (std::size_t face = 0; face < shape.mesh.num_face_vertices.size(); ++face) {
        const int id = shape.mesh.material_ids[face];
        if (id != current)
            builder.beginPiece(id < 0 ? Material{} : materialOf(loaded.materials[static_cast<std::size_t>(id)]),
                               bounds);
        current = id;
        slivers += addTriangle(builder, loaded.attributes, &shape.mesh.indices[3 * face]) ? 0 : 1;
    }
    return slivers;
}

} // namespace

std::optional<Mesh> parseMesh(const QByteArray &text, const MaterialSource &materials, QString *problem) {
    const std::optional<CheckedObj> checked = checkObj(text, materials, problem);
    const std::optional<Loaded> loaded = checked ? load(*checked, problem) : std::nullopt;
    if (!loaded) return std::nullopt;
    if (!isComplete(*loaded)) {
        *problem = QStringLiteral(" the loader made other faces than are in the file");
        return std::nullopt;
    }
    MeshBuilder builder;
    int slivers = 0;
    for (const tinyobj::shape_t &shape : loaded->shapes) slivers += addShape(builder, *loaded, shape);
    Mesh mesh = builder.take();
    if (mesh.indices.empty()) {
        *problem = QStringLiteral(" expected a face with an area, found none");
        return std::nullopt;
    }
    *problem = checked->note;
    if (problem->isEmpty() && slivers > 0) *problem = QStringLiteral(" %1 triangles have no area").arg(slivers);
    return mesh;
}

std::optional<Mesh> loadMesh(const QString &path, QString *problem) {
    const std::optional<QByteArray> text = readFile(path, kLargestMesh, problem);
    if (!text) return std::nullopt;
    const QString folder = path.left(path.lastIndexOf(QLatin1Char('/')) + 1);
    const auto readMaterials = [&](const QString &name, QString *error) {
        const bool isAbsolute = name.startsWith(QLatin1Char('/'));
        return readFile(isAbsolute ? name : folder + name, kLargestMaterials, error);
    };
    std::optional<Mesh> mesh = parseMesh(*text, readMaterials, problem);
    if (!problem->isEmpty()) problem->prepend(oneLine(path) + QLatin1Char(':'));
    return mesh;
}

} // namespace inspector::gl
