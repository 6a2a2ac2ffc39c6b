// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "gl/depth_target.h"
#include "gl/frame.h"
#include "gl/mesh_buffer.h"
#include "gl/occlusion_map.h"
#include "gl/shader_library.h"
#include "gl/stroke_renderer.h"
#include "mesh/mesh.h"

#include <memory>

#include <QOpenGLFunctions_3_3_Core>
#include <QOpenGLTexture>
#include <QOpenGLVertexArrayObject>

namespace inspector::gl {

/// Draws a board with its ball into the bound framebuffer. Knows meshes and poses, no physics and no widgets. Created,
/// used and destroyed with the same context current.
class MazeRenderer {
public:
    /// Null, with one line in `error` (not null), if the current context isn't sufficient.
    static std::unique_ptr<MazeRenderer> create(QString *error);
    ~MazeRenderer();

    /// Both meshes must be closed, with counter-clockwise triangles seen from outside: back faces are culled.
    void setMaze(const Mesh &mesh); ///< board frame, m
    void setBall(const Mesh &mesh); ///< radius 1 around the origin
    ShaderLibrary &shaders() { return m_shaders; }

    void render(const Frame &frame, const View &view);

    /// Everything that determines the picture of board and table, except for the ball's shadow.
    struct StaticScene {
        glm::dmat4 clipFromBoard{0.0};
        glm::dmat4 worldFromBoard{0.0};
        glm::ivec2 pixels{0};
        Quality quality = Quality::Low;
        Backdrop backdrop;
        uint64_t maze = 0;
        uint64_t shaders = 0;
        bool operator==(const StaticScene &) const = default;
    };
    StaticScene staticSceneOf(const Frame &frame, const View &view);
    /// render() in two parts with the same result, for callers that cache the picture of the first one together with
    /// its depth: first board and table, then everything that moves, with the part of the board that the ball affects.
    void renderStatic(const Frame &frame, const View &view);
    void renderMoving(const Frame &frame, const View &view);
    /// Draws a finished picture (a texture of the view's size) with antialiased edges.
    void smooth(unsigned picture, const View &view);

private:
    struct Scene; ///< data shared by all passes of a frame

    /// The emissive part of the maze, the exit, as a light source for its surroundings.
    struct Beacon {
        glm::vec3 position{0.0F}; ///< m, board frame
        glm::vec3 albedo{0.0F};   ///< sRGB; black if there is none
    };
    static Beacon beaconOf(const Mesh &mesh);

    explicit MazeRenderer(QOpenGLFunctions_3_3_Core *gl);

    Scene describe(const Frame &frame, const View &view) const;
    bool prepare(const Scene &scene);
    void clear();
    glm::ivec4 changedByBall(const Scene &scene) const;
    void makeOcclusionMap();
    void updateShadowMap(const Scene &scene, Quality quality);
    void drawDepth(DepthTarget &target, const glm::dmat4 &clipFromBoard);
    void bindTextures();
    void setLighting(QOpenGLShaderProgram &program, const Scene &scene);
    void drawBoard(const Scene &scene, const Ball &ball);
    void drawMaze(const Scene &scene, const Ball &ball);
    void drawMoving(const Scene &scene);
    void drawBall(const Scene &scene, const Ball &ball, const Colour &tint);
    void drawBackdrop(const Scene &scene);
    void drawOverAll();
    void drawGhosts(const Scene &scene);
    void drawStrokes(const Scene &scene);

    QOpenGLFunctions_3_3_Core *m_gl;
    ShaderLibrary m_shaders;
    MeshBuffer m_maze;
    MeshBuffer m_ball;
    StrokeRenderer m_strokes;
    QOpenGLVertexArrayObject m_noVertices; ///< the core profile requires one, even without vertices
    QOpenGLTexture m_grain;
    OcclusionMap m_occlusion;
    bool m_isOcclusionStale = true;

    std::unique_ptr<DepthTarget> m_shadow;
    glm::dvec3 m_shadowDirection{0.0}; ///< light direction of the current map
    bool m_isShadowStale = true;

    Bounds m_bounds;
    bool m_hasBoard = false;
    Beacon m_beacon;
    uint64_t m_mazes = 0; ///< counts the mazes set
};

} // namespace inspector::gl
