// SPDX-License-Identifier: MIT
// Chipmunk 7: two dimensions, double. Its top view has no floor.
#include "peers/engine.h"

#include <chipmunk/chipmunk.h>

#include <cfenv>

namespace bench {

namespace {

/// Its Release build has -ffast-math, which flushes subnormals to zero in every program that links it. phys_step would
/// restore the default twice a step, at 40 ns; so all others have the default, and Chipmunk its own while it steps.
class OwnEnvironment {
public:
    OwnEnvironment() { std::fesetenv(&kAsLinked); }
    ~OwnEnvironment() { std::fesetenv(FE_DFL_ENV); }
    OwnEnvironment(const OwnEnvironment &) = delete;
    OwnEnvironment &operator=(const OwnEnvironment &) = delete;

private:
    static std::fenv_t leaveToChipmunk() {
        std::fenv_t environment;
        std::fegetenv(&environment);
        std::fesetenv(FE_DFL_ENV);
        return environment;
    }
    static const std::fenv_t kAsLinked;
};
const std::fenv_t OwnEnvironment::kAsLinked = leaveToChipmunk();

// A ball that rolls has 5/7 of the tilt's acceleration: model.md 3.1.
double shareOfTilt(const Scene &scene) { return scene.rolls ? 5.0 / 7.0 : 1.0; }

class ChipmunkEngine final : public Engine {
public:
    explicit ChipmunkEngine(const Scene &scene)
        : m_space(cpSpaceNew())
        , m_share(shareOfTilt(scene)) {
        cpSpaceSetCollisionSlop(m_space, 4e-4 * scene.radius); // its default of 0.1 m is made for pixels
        cpBody *ground = cpSpaceGetStaticBody(m_space);
        for (const Wall &wall : scene.walls) {
            cpShape *shape = cpBoxShapeNew2(ground, cpBBNew(wall.x0, wall.y0, wall.x1, wall.y1), 0);
            cpShapeSetElasticity(shape, 1); // Chipmunk multiplies both elasticities
            cpSpaceAddShape(m_space, shape);
        }
        m_body = cpSpaceAddBody(m_space, cpBodyNew(1, INFINITY)); // without friction no torque acts on it
        cpShape *circle = cpSpaceAddShape(m_space, cpCircleShapeNew(m_body, scene.radius, cpvzero));
        cpShapeSetElasticity(circle, scene.restitution);
        place(scene.start);
    }
    ChipmunkEngine(const ChipmunkEngine &) = delete;
    ChipmunkEngine &operator=(const ChipmunkEngine &) = delete;
    ~ChipmunkEngine() override {
        cpSpaceEachShape(
            m_space, [](cpShape *shape, void *all) { static_cast<std::vector<cpShape *> *>(all)->push_back(shape); },
            &m_shapes);
        for (cpShape *shape : m_shapes) {
            cpSpaceRemoveShape(m_space, shape);
            cpShapeFree(shape);
        }
        cpSpaceRemoveBody(m_space, m_body);
        cpBodyFree(m_body);
        cpSpaceFree(m_space);
    }

    void place(const Ball &ball) override {
        cpBodySetPosition(m_body, cpv(ball.position.x, ball.position.y));
        cpBodySetVelocity(m_body, cpv(ball.velocity.x, ball.velocity.y));
    }

    void setGravity(const phys_vec3 &gravity) override {
        cpSpaceSetGravity(m_space, cpv(m_share * gravity.x, m_share * gravity.y));
    }

    void advance(double dt, int steps) override {
        const OwnEnvironment environment;
        for (int step = 0; step < steps; ++step) cpSpaceStep(m_space, dt);
    }

    Ball ball() const override {
        const cpVect position = cpBodyGetPosition(m_body);
        const cpVect velocity = cpBodyGetVelocity(m_body);
        return {{position.x, position.y}, {velocity.x, velocity.y}};
    }

private:
    cpSpace *m_space;
    cpBody *m_body = nullptr;
    double m_share;
    std::vector<cpShape *> m_shapes;
};

} // namespace

std::vector<EngineKind> chipmunkEngines() {
    return {
        {"chipmunk", false, false,
         "2D, top view without a floor; collision slop 4e-4 radii; no speed threshold; no continuous detection exists",
         [](const Scene &scene, double) { return std::make_unique<ChipmunkEngine>(scene); }}};
}

} // namespace bench
