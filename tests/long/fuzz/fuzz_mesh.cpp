// SPDX-License-Identifier: MIT
// Any bytes as a mesh; those after a byte 1 are its materials. The result is triangles of finite numbers with valid
// indices, or one line with the reason.
#include "input.h"
#include "mesh/mesh_file.h"

#include <cmath>

using namespace inspector::gl;

namespace {

void check(const Mesh &mesh) {
    fuzz::demand(!mesh.indices.empty() && mesh.indices.size() % 3 == 0);
    for (const std::uint32_t index : mesh.indices) fuzz::demand(index < mesh.vertices.size());
    for (const Vertex &vertex : mesh.vertices) {
        for (int axis = 0; axis < 3; ++axis)
            fuzz::demand(std::abs(double(vertex.position[axis])) <= kLargestCoordinate &&
                         std::isfinite(vertex.normal[axis]));
    }
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    const QByteArray bytes(reinterpret_cast<const char *>(data), qsizetype(size));
    const qsizetype end = bytes.indexOf('\1');
    const MaterialSource materials = [&](const QString &, QString *error) {
        if (end >= 0) return std::optional(bytes.mid(end + 1));
        *error = QStringLiteral("none");
        return std::optional<QByteArray>();
    };
    QString problem;
    const std::optional<Mesh> mesh = parseMesh(bytes.left(end), materials, &problem);
    fuzz::demand(mesh || !problem.isEmpty());
    fuzz::demand(!problem.contains(QLatin1Char('\n')) && !problem.contains(QChar(0x1b)));
    if (mesh) check(*mesh);
    return 0;
}
