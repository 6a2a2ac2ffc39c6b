// SPDX-License-Identifier: MIT
// Bullet in double precision (the -float64 libraries of Debian): three dimensions, on a floor.
#define BT_USE_DOUBLE_PRECISION
#include "peers/engine.h"

#include <BulletCollision/CollisionDispatch/btSphereBoxCollisionAlgorithm.h>
#include <btBulletDynamicsCommon.h>

namespace bench {

namespace {

constexpr double kMass = 1; // kg

// The general algorithm is iterative; this one is exact for a sphere and a box, in either order.
struct SphereBoxConfiguration : btDefaultCollisionConfiguration {
    SphereBoxConfiguration() { boxSphere.m_swapped = true; }
    btCollisionAlgorithmCreateFunc *getCollisionAlgorithmCreateFunc(int first, int second) override {
        if (first == SPHERE_SHAPE_PROXYTYPE && second == BOX_SHAPE_PROXYTYPE) return &sphereBox;
        if (first == BOX_SHAPE_PROXYTYPE && second == SPHERE_SHAPE_PROXYTYPE) return &boxSphere;
        return btDefaultCollisionConfiguration::getCollisionAlgorithmCreateFunc(first, second);
    }
    btSphereBoxCollisionAlgorithm::CreateFunc sphereBox;
    btSphereBoxCollisionAlgorithm::CreateFunc boxSphere;
};

class BulletEngine final : public Engine {
public:
    explicit BulletEngine(const Scene &scene)
        : m_sphere(scene.radius)
        , m_radius(scene.radius) {
        m_world.setForceUpdateAllAabbs(false);
        btContactSolverInfo &solver = m_world.getSolverInfo();
        solver.m_restitutionVelocityThreshold = 0;
        solver.m_splitImpulsePenetrationThreshold = 1e10; // otherwise being pushed out of a wall adds speed
        addFloor(scene);
        addWalls(scene);
        addBall(scene);
        place(scene.start);
    }
    BulletEngine(const BulletEngine &) = delete;
    BulletEngine &operator=(const BulletEngine &) = delete;
    ~BulletEngine() override {
        for (const auto &body : m_bodies) m_world.removeRigidBody(body.get());
    }

    void place(const Ball &ball) override {
        btRigidBody &body = *m_bodies.back();
        const btTransform transform(btQuaternion::getIdentity(), {ball.position.x, ball.position.y, m_radius});
        body.setWorldTransform(transform);
        body.setInterpolationWorldTransform(transform);
        body.setLinearVelocity({ball.velocity.x, ball.velocity.y, 0});
        body.setAngularVelocity({0, 0, 0});
        body.clearForces();
    }

    void setGravity(const phys_vec3 &gravity) override { m_world.setGravity({gravity.x, gravity.y, gravity.z}); }

    void advance(double dt, int steps) override {
        for (int step = 0; step < steps; ++step) m_world.stepSimulation(dt, 0);
    }

    Ball ball() const override {
        const btVector3 &position = m_bodies.back()->getWorldTransform().getOrigin();
        const btVector3 &velocity = m_bodies.back()->getLinearVelocity();
        return {{position.x(), position.y()}, {velocity.x(), velocity.y()}};
    }

private:
    btBoxShape *addBox(const btVector3 &halfSize) {
        auto shape = std::make_unique<btBoxShape>(halfSize);
        shape->setMargin(0);
        m_boxes.push_back(std::move(shape));
        return m_boxes.back().get();
    }

    btRigidBody &addBody(double mass, btCollisionShape &shape, const btVector3 &centre, double restitution) {
        btVector3 inertia(0, 0, 0);
        if (mass > 0) shape.calculateLocalInertia(mass, inertia);
        m_bodies.push_back(std::make_unique<btRigidBody>(mass, nullptr, &shape, inertia));
        btRigidBody &body = *m_bodies.back();
        body.setWorldTransform(btTransform(btQuaternion::getIdentity(), centre));
        body.setRestitution(restitution); // Bullet multiplies both restitutions, and frictions as well
        body.setFriction(0);
        body.setDamping(0, 0);
        body.setContactProcessingThreshold(0); // otherwise the ball stops before it touches
        m_world.addRigidBody(&body);
        return body;
    }

    void addFloor(const Scene &scene) {
        const Wall floor = floorOf(scene);
        btBoxShape *box = addBox({(floor.x1 - floor.x0) / 2, (floor.y1 - floor.y0) / 2, kFloorThickness / 2});
        const btVector3 centre((floor.x0 + floor.x1) / 2, (floor.y0 + floor.y1) / 2, -kFloorThickness / 2);
        addBody(0, *box, centre, 0).setFriction(scene.rolls ? 1 : 0);
    }

    // One compound: a single broad-phase object with a tree inside.
    void addWalls(const Scene &scene) {
        if (scene.walls.empty()) return;
        for (const Wall &wall : scene.walls) {
            btBoxShape *box = addBox({(wall.x1 - wall.x0) / 2, (wall.y1 - wall.y0) / 2, kWallHeight / 2});
            const btVector3 centre((wall.x0 + wall.x1) / 2, (wall.y0 + wall.y1) / 2, kWallHeight / 2);
            m_walls.addChildShape(btTransform(btQuaternion::getIdentity(), centre), box);
        }
        addBody(0, m_walls, {0, 0, 0}, scene.restitution);
    }

    void addBall(const Scene &scene) {
        btRigidBody &body = addBody(kMass, m_sphere, {0, 0, scene.radius}, 1);
        body.setFriction(1);
        body.setActivationState(DISABLE_DEACTIVATION);
        body.setCcdMotionThreshold(scene.radius);
        body.setCcdSweptSphereRadius(scene.radius / 2);
    }

    SphereBoxConfiguration m_configuration;
    btCollisionDispatcher m_dispatcher{&m_configuration};
    btDbvtBroadphase m_broadphase;
    btSequentialImpulseConstraintSolver m_solver;
    btDiscreteDynamicsWorld m_world{&m_dispatcher, &m_broadphase, &m_solver, &m_configuration};
    btSphereShape m_sphere;
    btCompoundShape m_walls;
    std::vector<std::unique_ptr<btBoxShape>> m_boxes;
    std::vector<std::unique_ptr<btRigidBody>> m_bodies; // the ball is the last
    double m_radius;
};

} // namespace

std::vector<EngineKind> bulletEngines() {
    return {{"bullet", false, false,
             "3D, double; box margin 0; the sphere-box algorithm in both orders; walls in one compound; restitution "
             "threshold 0; contact "
             "processing threshold 0; split impulse at any depth; no deactivation; continuous detection from one "
             "radius a step",
             [](const Scene &scene, double) { return std::make_unique<BulletEngine>(scene); }}};
}

} // namespace bench
