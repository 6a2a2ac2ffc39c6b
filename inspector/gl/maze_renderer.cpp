// SPDX-License-Identifier: GPL-3.0-or-later
#include "gl/maze_renderer.h"

#include "gl/board_pose.h"
#include "gl/surface_format.h"
#include "gl/wood_grain.h"
#include "mesh/mesh_builder.h"

#include <algorithm>
#include <cmath>

#include <QMatrix4x4>
#include <QOpenGLContext>
#include <QOpenGLPixelTransferOptions>
#include <QOpenGLVersionFunctionsFactory>
#include <QVector3D>
#include <QVector4D>

#include <glm/ext/matrix_clip_space.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/matrix.hpp>

namespace inspector::gl {

namespace {

/// The key light, fixed in the world: a window high up behind the left shoulder of an observer at the far side.
const glm::dvec3 kToLight = glm::normalize(glm::dvec3(-0.52, 0.34, 0.78));
constexpr glm::vec3 kLightRadiance{1.02F, 0.97F, 0.88F};
constexpr glm::vec3 kSkyRadiance{0.42F, 0.44F, 0.49F};
constexpr glm::vec3 kGroundRadiance{0.26F, 0.20F, 0.15F};

constexpr double kLightDisc = 0.12;  ///< tangent of the half angle
constexpr double kBallReach = 12.0;  ///< radii, up to which a ball occludes the sky
constexpr double kSteepLight = 0.25; ///< sine of the light's elevation; below, shadows are long

constexpr int kGrainTexels = 512;
constexpr int kGrainUnit = 0; ///< texture units
constexpr int kOcclusionUnit = 1;
constexpr int kShadowUnit = 2;
constexpr int kPictureUnit = 3;

QMatrix4x4 toQt(const glm::dmat4 &matrix) {
    QMatrix4x4 result(Qt::Uninitialized);
    for (int row = 0; row < 4; ++row) {
        for (int column = 0; column < 4; ++column) result(row, column) = static_cast<float>(matrix[column][row]);
    }
    return result;
}

QVector3D toQt(const glm::vec3 &v) { return {v.x, v.y, v.z}; }
QVector4D toQt(const glm::vec4 &v) { return {v.x, v.y, v.z, v.w}; }

glm::dvec4 sphere(const Ball &ball) { return {ball.position, ball.radius}; }

/// A position so far away along the light that it has no effect.
Ball absentBall(const glm::dvec3 &toLight) {
    Ball ball;
    ball.position = -1e3 * toLight;
    return ball;
}

/// Light space: a tight box around the bounds, seen along the light. Maps board coordinates to clip coordinates.
glm::dmat4 orthographicAround(const Bounds &bounds, const glm::dvec3 &back) {
    const glm::dvec3 helper = std::abs(back.y) < 0.9 ? glm::dvec3(0.0, 1.0, 0.0) : glm::dvec3(1.0, 0.0, 0.0);
    const glm::dvec3 right = glm::normalize(glm::cross(helper, back));
    const glm::dvec3 up = glm::cross(back, right);
    const glm::dmat3 lightFromBoard = glm::transpose(glm::dmat3(right, up, back));
    const glm::dvec3 centre = lightFromBoard * bounds.centre();
    const glm::dvec3 half = 0.5 * bounds.size();
    glm::dvec3 extent(0.0);
    for (int axis = 0; axis < 3; ++axis) extent += glm::abs(lightFromBoard[axis]) * half[axis];
    extent = 1.02 * extent + 1e-4;
    const glm::dvec3 lo = centre - extent;
    const glm::dvec3 hi = centre + extent;
    return glm::ortho(lo.x, hi.x, lo.y, hi.y, -hi.z, -lo.z) * glm::dmat4(lightFromBoard);
}

/// Boards are seen from above, so drawing high occluders first saves shading what they hide.
Mesh highestFirst(Mesh mesh) {
    using Triangle = std::array<std::uint32_t, 3>;
    std::vector<Triangle> triangles(mesh.indices.size() / 3);
    for (std::size_t i = 0; i < triangles.size(); ++i) std::copy_n(&mesh.indices[3 * i], 3, triangles[i].begin());
    const auto height = [&](const Triangle &one) {
        const auto z = [&](std::uint32_t index) { return mesh.vertices[index].position.z; };
        return std::max({z(one[0]), z(one[1]), z(one[2])});
    };
    std::stable_sort(triangles.begin(), triangles.end(),
                     [&](const Triangle &a, const Triangle &b) { return height(a) > height(b); });
    mesh.indices.clear();
    for (const Triangle &one : triangles) mesh.indices.insert(mesh.indices.end(), one.begin(), one.end());
    return mesh;
}

} // namespace

struct MazeRenderer::Scene {
    const Frame &frame;
    const View &view;
    glm::dmat4 worldFromBoard;
    glm::dmat4 clipFromBoard;
    glm::dmat4 shadowFromBoard;
    glm::dvec3 toLight; ///< these three in the board frame
    glm::dvec3 up;
    glm::dvec3 eye;
};

std::unique_ptr<MazeRenderer> MazeRenderer::create(QString *error) {
    QOpenGLContext *context = QOpenGLContext::currentContext();
    *error = contextProblem(context);
    if (!error->isEmpty()) return nullptr;
    auto *gl = QOpenGLVersionFunctionsFactory::get<QOpenGLFunctions_3_3_Core>(context);
    if (!gl || !gl->initializeOpenGLFunctions()) {
        *error = QStringLiteral("OpenGL: expected the functions of 3.3 core, found that some are missing");
        return nullptr;
    }
    return std::unique_ptr<MazeRenderer>(new MazeRenderer(gl));
}

MazeRenderer::MazeRenderer(QOpenGLFunctions_3_3_Core *gl)
    : m_gl(gl)
    , m_maze(gl)
    , m_ball(gl)
    , m_strokes(gl)
    , m_grain(QOpenGLTexture::Target2D)
    , m_occlusion(gl) {
    m_noVertices.create();
    m_grain.setFormat(QOpenGLTexture::R8_UNorm);
    m_grain.setSize(kGrainTexels, kGrainTexels);
    m_grain.setMipLevels(m_grain.maximumMipLevels());
    m_grain.allocateStorage();
    // Averaged here, once: an OpenGL by software compiles shaders for each context that is to make mipmaps.
    static const std::vector<std::vector<std::uint8_t>> grain = mipmapsOf(woodGrain(kGrainTexels), kGrainTexels);
    m_grain.setAutoMipMapGenerationEnabled(false);
    QOpenGLPixelTransferOptions packed;
    packed.setAlignment(1);
    for (int level = 0; level < static_cast<int>(grain.size()); ++level)
        m_grain.setData(level, QOpenGLTexture::Red, QOpenGLTexture::UInt8, grain[level].data(), &packed);
    m_grain.setMinMagFilters(QOpenGLTexture::LinearMipMapNearest, QOpenGLTexture::Linear);
    setBall(patternedBall());
}

MazeRenderer::~MazeRenderer() = default;

void MazeRenderer::setMaze(const Mesh &mesh) {
    m_maze.upload(highestFirst(mesh));
    m_bounds = mesh.bounds();
    m_hasBoard = !mesh.vertices.empty();
    m_beacon = beaconOf(mesh);
    ++m_mazes;
    m_isOcclusionStale = true;
    m_isShadowStale = true;
}

MazeRenderer::Beacon MazeRenderer::beaconOf(const Mesh &mesh) {
    Beacon beacon;
    float count = 0.0F;
    for (const Vertex &vertex : mesh.vertices) {
        if (vertex.surface.w == 0) continue;
        beacon.position += vertex.position;
        beacon.albedo += glm::vec3(vertex.albedo) / 255.0F;
        ++count;
    }
    if (count == 0.0F) return beacon;
    return {beacon.position / count, beacon.albedo / count};
}

void MazeRenderer::setBall(const Mesh &mesh) { m_ball.upload(mesh); }

void MazeRenderer::render(const Frame &frame, const View &view) {
    const Scene scene = describe(frame, view);
    if (!prepare(scene)) return;
    clear();
    drawBoard(scene, frame.ball);
    drawMoving(scene);
}

void MazeRenderer::renderStatic(const Frame &frame, const View &view) {
    const Scene scene = describe(frame, view);
    if (!prepare(scene)) return;
    clear();
    drawBoard(scene, absentBall(scene.toLight));
}

void MazeRenderer::renderMoving(const Frame &frame, const View &view) {
    const Scene scene = describe(frame, view);
    if (!prepare(scene)) return;
    const glm::ivec4 changed = changedByBall(scene);
    m_gl->glEnable(GL_SCISSOR_TEST);
    m_gl->glScissor(changed.x, changed.y, changed.z, changed.w);
    clear();
    drawBoard(scene, frame.ball);
    m_gl->glDisable(GL_SCISSOR_TEST);
    drawMoving(scene);
}

void MazeRenderer::smooth(unsigned picture, const View &view) {
    if (!m_shaders.update(view.quality)) return;
    QOpenGLShaderProgram &program = m_shaders.use(Program::Smooth);
    program.setUniformValue("picture", kPictureUnit);
    m_gl->glActiveTexture(GL_TEXTURE0 + kPictureUnit);
    m_gl->glBindTexture(GL_TEXTURE_2D, picture);
    m_gl->glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    m_gl->glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    m_gl->glActiveTexture(GL_TEXTURE0);
    m_gl->glDisable(GL_DEPTH_TEST);
    m_gl->glViewport(0, 0, view.pixels.x, view.pixels.y);
    drawOverAll();
}

/// Draws one triangle that covers the viewport.
void MazeRenderer::drawOverAll() {
    const QOpenGLVertexArrayObject::Binder binder(&m_noVertices);
    m_gl->glDrawArrays(GL_TRIANGLES, 0, 3);
}

MazeRenderer::StaticScene MazeRenderer::staticSceneOf(const Frame &frame, const View &view) {
    m_shaders.update(view.quality);
    const Scene scene = describe(frame, view);
    return {scene.clipFromBoard,   scene.worldFromBoard, view.pixels, view.quality, view.backdrop, m_mazes,
            m_shaders.generation()};
}

/// False if there are no programs to draw with.
bool MazeRenderer::prepare(const Scene &scene) {
    if (!m_shaders.update(scene.view.quality)) return false;
    m_gl->glEnable(GL_DEPTH_TEST);
    m_gl->glDepthFunc(GL_LEQUAL);
    m_gl->glDepthMask(GL_TRUE);
    m_gl->glDisable(GL_BLEND);
    m_gl->glEnable(GL_CULL_FACE);
    if (m_isOcclusionStale) makeOcclusionMap();
    if (scene.view.quality != Quality::Low) updateShadowMap(scene, scene.view.quality);
    m_gl->glViewport(0, 0, scene.view.pixels.x, scene.view.pixels.y);
    bindTextures();
    return true;
}

/// Colours needn't be cleared, as the backdrop covers every pixel.
void MazeRenderer::clear() { m_gl->glClear(GL_DEPTH_BUFFER_BIT); }

/// The pixels (x, y, width, height) of the board that the ball and its shadow darken.
glm::ivec4 MazeRenderer::changedByBall(const Scene &scene) const {
    const glm::ivec4 all(0, 0, scene.view.pixels);
    if (scene.toLight.z < kSteepLight) return all;
    const Ball &ball = scene.frame.ball;
    const double radius = 1.05 * ball.radius; // the shadow's edge is soft even where the ball touches
    // Along the light to the lowest point of the board; the shadow widens with the light's disc.
    const double fall = std::max(ball.position.z + radius - m_bounds.minimum.z, 0.0) / (scene.toLight.z - kLightDisc);
    const glm::dvec3 foot = ball.position - fall * scene.toLight;
    const double footRadius = radius + kLightDisc * fall;
    const double reach = kBallReach * ball.radius;
    glm::dvec3 lo = glm::max(glm::min(ball.position - reach, foot - footRadius), m_bounds.minimum);
    glm::dvec3 hi = glm::min(glm::max(ball.position + reach, foot + footRadius), m_bounds.maximum);
    lo.z = m_bounds.minimum.z;
    hi.z = m_bounds.maximum.z;
    if (lo.x >= hi.x || lo.y >= hi.y) return glm::ivec4(0);
    glm::dvec2 first(1.0); // clip coordinates
    glm::dvec2 last(-1.0);
    for (int corner = 0; corner < 8; ++corner) {
        const glm::dvec3 place(corner & 1 ? lo.x : hi.x, corner & 2 ? lo.y : hi.y, corner & 4 ? lo.z : hi.z);
        const glm::dvec4 clip = scene.clipFromBoard * glm::dvec4(place, 1.0);
        if (clip.w <= 0.0) return all; // behind the eye
        first = glm::min(first, glm::dvec2(clip) / clip.w);
        last = glm::max(last, glm::dvec2(clip) / clip.w);
    }
    const glm::dvec2 size(scene.view.pixels);
    const glm::ivec2 begin = glm::floor(0.5 * (glm::clamp(first, -1.0, 1.0) + 1.0) * size);
    const glm::ivec2 end = glm::ceil(0.5 * (glm::clamp(last, -1.0, 1.0) + 1.0) * size);
    return {begin, glm::max(end - begin, 0)};
}

/// Table and horizon are drawn last, as they are visible only where nothing hides them.
void MazeRenderer::drawBoard(const Scene &scene, const Ball &ball) {
    drawMaze(scene, ball);
    drawBackdrop(scene);
}

void MazeRenderer::drawMoving(const Scene &scene) {
    drawBall(scene, scene.frame.ball, Colour(0.0F, 0.0F, 0.0F, 1.0F));
    m_gl->glEnable(GL_BLEND);
    m_gl->glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    drawGhosts(scene);
    drawStrokes(scene);
    m_gl->glDisable(GL_BLEND);
}

MazeRenderer::Scene MazeRenderer::describe(const Frame &frame, const View &view) const {
    const glm::dmat4 worldFromBoard = boardToWorld(frame.tiltX, frame.tiltY, boardPivot(m_bounds));
    const glm::dmat4 eyeFromBoard = view.view * worldFromBoard;
    const glm::dmat3 toBoard = glm::transpose(glm::dmat3(worldFromBoard));
    const glm::dvec3 toLight = toBoard * kToLight;
    // Maps clip coordinates -1..1 to texture coordinates 0..1.
    const glm::dmat4 half(glm::dvec4(0.5, 0, 0, 0), glm::dvec4(0, 0.5, 0, 0), glm::dvec4(0, 0, 0.5, 0),
                          glm::dvec4(0.5, 0.5, 0.5, 1));
    return {frame,
            view,
            worldFromBoard,
            view.projection * eyeFromBoard,
            half * orthographicAround(m_bounds, toLight),
            toLight,
            toBoard * glm::dvec3(0.0, 0.0, 1.0),
            glm::dvec3(glm::inverse(eyeFromBoard)[3])};
}

void MazeRenderer::drawDepth(DepthTarget &target, const glm::dmat4 &clipFromBoard) {
    QOpenGLShaderProgram &program = m_shaders.use(Program::Depth);
    program.setUniformValue("clip_from_board", toQt(clipFromBoard));
    target.drawInto([this] { m_maze.draw(); });
}

/// The heights are the board seen straight from above; blurred, they tell how much of the sky each point sees.
void MazeRenderer::makeOcclusionMap() {
    m_isOcclusionStale = false;
    constexpr double kReach = 0.012; // m, over which a wall darkens its surroundings
    DepthTarget heights(m_gl, OcclusionMap::kSize);
    const glm::dvec3 lo = m_bounds.minimum;
    const glm::dvec3 hi = m_bounds.maximum;
    if (hi.x <= lo.x || hi.y <= lo.y || hi.z <= lo.z) return;
    drawDepth(heights, glm::ortho(lo.x, hi.x, lo.y, hi.y, -hi.z, -lo.z));
    std::vector<float> values = heights.read();
    for (float &value : values) value = 1.0F - value;
    const auto texels = [](double length) {
        return std::clamp(static_cast<int>(0.5 * kReach / length * OcclusionMap::kSize), 1, OcclusionMap::kSize / 8);
    };
    m_occlusion.upload(std::move(values), texels(hi.x - lo.x), texels(hi.y - lo.y));
}

/// The maze's shadow on itself changes only when the board tilts relative to the light; the ball's shadow is computed
/// per pixel.
void MazeRenderer::updateShadowMap(const Scene &scene, Quality quality) {
    const int size = quality == Quality::High ? 1536 : 1024;
    if (!m_shadow || m_shadow->size() != size) {
        m_shadow = std::make_unique<DepthTarget>(m_gl, size);
        m_isShadowStale = true;
    }
    constexpr double kNoticeable = 1e-5; // rad; well below a texel's width at the board's edge
    if (!m_isShadowStale && glm::distance(m_shadowDirection, scene.toLight) < kNoticeable) return;
    m_isShadowStale = false;
    m_shadowDirection = scene.toLight;
    m_gl->glEnable(GL_POLYGON_OFFSET_FILL);
    m_gl->glPolygonOffset(1.5F, 2.0F);
    drawDepth(*m_shadow, orthographicAround(m_bounds, scene.toLight));
    m_gl->glDisable(GL_POLYGON_OFFSET_FILL);
}

void MazeRenderer::bindTextures() {
    m_grain.bind(kGrainUnit);
    m_gl->glActiveTexture(GL_TEXTURE0 + kOcclusionUnit);
    m_gl->glBindTexture(GL_TEXTURE_2D, m_occlusion.texture());
    m_gl->glActiveTexture(GL_TEXTURE0 + kShadowUnit);
    m_gl->glBindTexture(GL_TEXTURE_2D, m_shadow ? m_shadow->texture() : 0);
    m_gl->glActiveTexture(GL_TEXTURE0);
}

void MazeRenderer::setLighting(QOpenGLShaderProgram &program, const Scene &scene) {
    program.setUniformValue("clip_from_board", toQt(scene.clipFromBoard));
    program.setUniformValue("shadow_from_board", toQt(scene.shadowFromBoard));
    program.setUniformValue("to_light", toQt(glm::vec3(scene.toLight)));
    program.setUniformValue("world_up", toQt(glm::vec3(scene.up)));
    program.setUniformValue("eye", toQt(glm::vec3(scene.eye)));
    program.setUniformValue("light_radiance", toQt(kLightRadiance));
    program.setUniformValue("sky_radiance", toQt(kSkyRadiance));
    program.setUniformValue("ground_radiance", toQt(kGroundRadiance));
    program.setUniformValue("board_minimum", toQt(glm::vec3(m_bounds.minimum)));
    program.setUniformValue("board_size", toQt(glm::vec3(glm::max(m_bounds.size(), glm::dvec3(1e-6)))));
    program.setUniformValue("shadow_texel", m_shadow ? 1.0F / static_cast<float>(m_shadow->size()) : 1.0F);
    program.setUniformValue("wood_grain", kGrainUnit);
    program.setUniformValue("occlusion_map", kOcclusionUnit);
    program.setUniformValue("shadow_map", kShadowUnit);
}

void MazeRenderer::drawMaze(const Scene &scene, const Ball &ball) {
    QOpenGLShaderProgram &program = m_shaders.use(Program::Maze);
    setLighting(program, scene);
    program.setUniformValue("ball", toQt(glm::vec4(sphere(ball))));
    program.setUniformValue("ball_reach", static_cast<float>(kBallReach * ball.radius));
    program.setUniformValue("light_disc", static_cast<float>(kLightDisc));
    program.setUniformValue("beacon", toQt(m_beacon.position));
    program.setUniformValue("beacon_albedo", toQt(m_beacon.albedo));
    m_maze.draw();
}

/// tint: opacity 1 draws the ball itself; less draws a ghost of that opacity, blended towards tint.rgb.
void MazeRenderer::drawBall(const Scene &scene, const Ball &ball, const Colour &tint) {
    QOpenGLShaderProgram &program = m_shaders.use(Program::Ball);
    setLighting(program, scene);
    const auto [x, y, z, w] = ball.orientation;
    program.setUniformValue("ball", toQt(glm::vec4(sphere(ball))));
    program.setUniformValue("orientation", toQt(glm::dmat4(glm::mat4_cast(glm::dquat(w, x, y, z)))));
    program.setUniformValue("tint", toQt(tint));
    m_ball.draw();
}

void MazeRenderer::drawBackdrop(const Scene &scene) {
    QOpenGLShaderProgram &program = m_shaders.use(Program::Backdrop);
    const glm::dvec3 half = 0.5 * m_bounds.size();
    const double reach = std::hypot(half.x, half.y);
    const glm::dmat4 worldFromClip = glm::inverse(scene.view.projection * scene.view.view);
    program.setUniformValue("world_from_clip", toQt(worldFromClip));
    program.setUniformValue("world_to_board", toQt(glm::inverse(scene.worldFromBoard)));
    program.setUniformValue("eye", toQt(glm::vec3(glm::inverse(scene.view.view)[3])));
    program.setUniformValue("to_light", toQt(glm::vec3(kToLight)));
    program.setUniformValue("board_centre", toQt(glm::vec3(m_bounds.centre())));
    program.setUniformValue("board_half", toQt(glm::vec3(half)));
    program.setUniformValue("board_opacity", m_hasBoard ? 1.0F : 0.0F);
    // Low enough that no corner of a board tilted by a quarter of a radian touches the table.
    program.setUniformValue("table_height", static_cast<float>(m_bounds.minimum.z - 0.25 * reach));
    program.setUniformValue("table_colour", toQt(scene.view.backdrop.table));
    program.setUniformValue("horizon_colour", toQt(scene.view.backdrop.horizon));
    drawOverAll();
}

void MazeRenderer::drawGhosts(const Scene &scene) {
    // Each ghost hides its own far side but not the next ghost: first depth, then colour at the nearest surface.
    for (const GhostBall &ghost : scene.frame.ghosts) {
        m_gl->glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
        drawBall(scene, ghost.ball, ghost.colour);
        m_gl->glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
        drawBall(scene, ghost.ball, ghost.colour);
    }
}

void MazeRenderer::drawStrokes(const Scene &scene) {
    Strokes trails;
    const double spacing = 0.15 * scene.frame.ball.radius;
    for (const Trail &trail : scene.frame.trails) trails.trail(trail.points, trail.colour, trail.width, spacing);
    if (trails.empty() && scene.frame.strokes.empty()) return;

    QOpenGLShaderProgram &program = m_shaders.use(Program::Stroke);
    program.setUniformValue("clip_from_board", toQt(scene.clipFromBoard));
    program.setUniformValue("pixels", static_cast<float>(scene.view.pixels.x), static_cast<float>(scene.view.pixels.y));
    program.setUniformValue("pixel_ratio", static_cast<float>(scene.view.pixelRatio));
    program.setUniformValue("opacity", 1.0F);
    m_gl->glDepthMask(GL_FALSE);
    m_gl->glDisable(GL_CULL_FACE); // a stroke's winding depends on its direction
    if (!trails.empty()) {
        m_strokes.upload(trails);
        m_strokes.draw();
    }
    if (!scene.frame.strokes.empty()) {
        m_strokes.upload(scene.frame.strokes);
        m_strokes.draw();
        // Draw the hidden parts faintly.
        m_gl->glDepthFunc(GL_GREATER);
        program.setUniformValue("opacity", 0.3F);
        m_strokes.draw();
        m_gl->glDepthFunc(GL_LEQUAL);
    }
    m_gl->glDepthMask(GL_TRUE);
}

} // namespace inspector::gl
