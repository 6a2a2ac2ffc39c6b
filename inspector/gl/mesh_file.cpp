// SPDX-License-Identifier: GPL-3.0-or-later
#include "gl/mesh_file.h"

#include "gl/mesh_builder.h"

#include <algorithm>
#include <cmath>

#include <QFile>
#include <QFileInfo>
#include <QList>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <tiny_obj_loader.h>

namespace inspector::gl {

namespace {

// tinyobjloader reads "v 1 abc 2" as (1, 0, 2) and skips faces with missing corners: what can be wrong in a file is
// looked for here, with its line.
class ObjCheck {
public:
    explicit ObjCheck(QString path)
        : m_path(std::move(path))
        , m_folder(QFileInfo(m_path).path()) {}

    // Empty, or the first problem.
    QString run() {
        QFile file(m_path);
        if (!file.open(QIODevice::ReadOnly)) return QStringLiteral("%1: %2").arg(m_path, file.errorString());
        for (m_line = 1; !file.atEnd(); ++m_line) {
            const QString problem = checkLine(file.readLine().simplified());
            if (!problem.isEmpty()) return QStringLiteral("%1:%2: %3").arg(m_path).arg(m_line).arg(problem);
        }
        if (m_faces == 0) return QStringLiteral("%1: expected at least one face, found none").arg(m_path);
        return {};
    }

private:
    QString checkLine(const QByteArray &line) {
        const QList<QByteArray> words = line.split(' ');
        if (words[0] == "v") return ++m_positions, checkNumbers(words);
        if (words[0] == "vn") return ++m_normals, checkNumbers(words);
        if (words[0] == "f") return ++m_faces, checkFace(words);
        if (words[0] == "mtllib") return checkLibrary(line.mid(7));
        if (words[0] == "usemtl" && !m_materials.contains(line.mid(7)))
            return QStringLiteral("expected a material of the .mtl file, found '%1'")
                .arg(QString::fromUtf8(line.mid(7)));
        return {};
    }

    static QString checkNumbers(const QList<QByteArray> &words) {
        bool is_good = words.size() >= 4;
        for (qsizetype i = 1; is_good && i < 4; ++i) is_good = std::isfinite(words[i].toDouble(&is_good)) && is_good;
        if (is_good) return {};
        return QStringLiteral("expected three finite numbers, found '%1'").arg(QString::fromUtf8(words.join(' ')));
    }

    QString checkFace(const QList<QByteArray> &words) const {
        if (words.size() < 4)
            return QStringLiteral("expected a face of three or more corners, found %1").arg(words.size() - 1);
        for (qsizetype i = 1; i < words.size(); ++i) {
            const QList<QByteArray> indices = words[i].split('/'); // position / texture / normal
            if (!isIndex(indices[0], m_positions) || (indices.size() > 2 && !isIndex(indices[2], m_normals)))
                return QStringLiteral("expected indices of the %1 vertices and %2 normals above, found '%3'")
                    .arg(m_positions)
                    .arg(m_normals)
                    .arg(QString::fromUtf8(words[i]));
        }
        return {};
    }

    // Counted from 1, or backwards from -1.
    static bool isIndex(const QByteArray &word, qsizetype count) {
        bool is_number = false;
        const int index = word.toInt(&is_number);
        return is_number && index != 0 && std::abs(index) <= count;
    }

    QString checkLibrary(const QByteArray &name) {
        QFile file(m_folder + QLatin1Char('/') + QFile::decodeName(name));
        if (!file.open(QIODevice::ReadOnly))
            return QStringLiteral("material file '%1': %2").arg(file.fileName(), file.errorString());
        while (!file.atEnd()) {
            const QByteArray line = file.readLine().simplified();
            if (line.startsWith("newmtl ")) m_materials.append(line.mid(7));
        }
        return {};
    }

    QString m_path;
    QString m_folder;
    int m_line = 0;
    qsizetype m_positions = 0;
    qsizetype m_normals = 0;
    qsizetype m_faces = 0;
    QList<QByteArray> m_materials;
};

Material materialOf(const tinyobj::material_t &source) {
    const auto strongest = [](const float *rgb) { return std::max({rgb[0], rgb[1], rgb[2]}); };
    Material material;
    material.name = source.name;
    material.albedo = {source.diffuse[0], source.diffuse[1], source.diffuse[2]};
    // Ks 0.5 means the 4 % that wood, paint and plastic reflect; Blinn's exponent becomes a roughness.
    material.reflectance = 0.08F * strongest(source.specular);
    material.roughness = std::pow(2.0F / (source.shininess + 2.0F), 0.25F);
    material.emission = strongest(source.emission) / std::max(strongest(source.diffuse), 0.05F);
    // Wood unless it shines by itself.
    material.grain = material.emission > 0.0F ? 0.0F : 1.0F;
    return material;
}

glm::vec3 vectorAt(const std::vector<tinyobj::real_t> &values, int index) {
    const auto first = static_cast<std::size_t>(index) * 3;
    return {values[first], values[first + 1], values[first + 2]};
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

void addTriangle(MeshBuilder &builder, const tinyobj::attrib_t &attributes, const tinyobj::index_t *corners) {
    std::array<glm::vec3, 3> positions;
    std::array<glm::vec3, 3> normals;
    for (std::size_t i = 0; i < 3; ++i) positions[i] = vectorAt(attributes.vertices, corners[i].vertex_index);
    const glm::vec3 area = glm::cross(positions[1] - positions[0], positions[2] - positions[0]);
    if (glm::length(area) == 0.0F) return; // a sliver of no area has no normal and no pixels
    for (std::size_t i = 0; i < 3; ++i) {
        const int index = corners[i].normal_index;
        normals[i] = glm::normalize(index < 0 ? area : vectorAt(attributes.normals, index));
    }
    builder.triangle(positions, normals);
}

void addShape(MeshBuilder &builder, const tinyobj::ObjReader &reader, const tinyobj::shape_t &shape) {
    const Bounds bounds = shapeBounds(reader.GetAttrib(), shape);
    int current = -2; // no material of a file has this number
    for (std::size_t face = 0; face < shape.mesh.num_face_vertices.size(); ++face) {
        const int id = shape.mesh.material_ids[face];
        if (id != current) builder.beginPiece(id < 0 ? Material{} : materialOf(reader.GetMaterials()[id]), bounds);
        current = id;
        addTriangle(builder, reader.GetAttrib(), &shape.mesh.indices[3 * face]);
    }
}

} // namespace

std::optional<Mesh> loadMesh(const QString &path, QString *error) {
    *error = ObjCheck(path).run();
    if (!error->isEmpty()) return std::nullopt;
    tinyobj::ObjReader reader;
    if (!reader.ParseFromFile(QFile::encodeName(path).toStdString())) {
        *error = QStringLiteral("%1: %2").arg(path, QString::fromStdString(reader.Error()).simplified());
        return std::nullopt;
    }
    MeshBuilder builder;
    for (const tinyobj::shape_t &shape : reader.GetShapes()) addShape(builder, reader, shape);
    return builder.take();
}

} // namespace inspector::gl
