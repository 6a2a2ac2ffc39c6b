// SPDX-License-Identifier: MIT
// ODE in double precision: three dimensions, on a floor. It has no continuous detection.
#include "peers/engine.h"

#include <ode/ode.h>

namespace bench {

namespace {

static_assert(sizeof(dReal) == sizeof(double));

constexpr double kMass = 1; // kg

// Once for the whole program.
struct Library {
    Library() { dInitODE2(0); }
    ~Library() { dCloseODE(); }
};

dWorldID newWorld() {
    static const Library library;
    return dWorldCreate();
}

dSpaceID quadTreeAround(const Scene &scene) {
    constexpr int kDepth = 6;
    const Wall floor = floorOf(scene);
    const dVector3 centre = {(floor.x0 + floor.x1) / 2, (floor.y0 + floor.y1) / 2, 0};
    const dVector3 halfSize = {(floor.x1 - floor.x0) / 2, (floor.y1 - floor.y0) / 2, 1};
    return dQuadTreeSpaceCreate(nullptr, centre, halfSize, kDepth);
}

class OdeEngine final : public Engine {
public:
    explicit OdeEngine(const Scene &scene)
        : m_world(newWorld())
        , m_walls(quadTreeAround(scene))
        , m_contacts(dJointGroupCreate(0))
        , m_radius(scene.radius)
        , m_restitution(scene.restitution)
        , m_floorFriction(scene.rolls ? dInfinity : 0) {
        dWorldSetCFM(m_world, 1e-15); // the default of 1e-10 is too soft; 0 fails with friction
        dWorldSetERP(m_world, 0.2);
        dWorldSetAutoDisableFlag(m_world, 0);
        m_floor = dCreatePlane(nullptr, 0, 0, 1, 0);
        for (const Wall &wall : scene.walls) {
            dGeomID box = dCreateBox(m_walls, wall.x1 - wall.x0, wall.y1 - wall.y0, kWallHeight);
            dGeomSetPosition(box, (wall.x0 + wall.x1) / 2, (wall.y0 + wall.y1) / 2, kWallHeight / 2);
        }
        m_body = dBodyCreate(m_world);
        dMass mass;
        dMassSetSphereTotal(&mass, kMass, scene.radius);
        dBodySetMass(m_body, &mass);
        m_ball = dCreateSphere(nullptr, scene.radius);
        dGeomSetBody(m_ball, m_body);
        place(scene.start);
    }
    OdeEngine(const OdeEngine &) = delete;
    OdeEngine &operator=(const OdeEngine &) = delete;
    ~OdeEngine() override {
        dGeomDestroy(m_ball);
        dGeomDestroy(m_floor);
        dJointGroupDestroy(m_contacts);
        dSpaceDestroy(m_walls);
        dWorldDestroy(m_world);
    }

    void place(const Ball &ball) override {
        dBodySetPosition(m_body, ball.position.x, ball.position.y, m_radius);
        dBodySetLinearVel(m_body, ball.velocity.x, ball.velocity.y, 0);
        dBodySetAngularVel(m_body, 0, 0, 0);
    }

    void setGravity(const phys_vec3 &gravity) override { dWorldSetGravity(m_world, gravity.x, gravity.y, gravity.z); }

    void advance(double dt, int steps) override {
        for (int step = 0; step < steps; ++step) {
            addContacts(m_floor, m_floorFriction, 0);
            dSpaceCollide2(m_ball, reinterpret_cast<dGeomID>(m_walls), this,
                           [](void *self, dGeomID first, dGeomID second) {
                               auto *engine = static_cast<OdeEngine *>(self);
                               engine->addContacts(first == engine->m_ball ? second : first, 0, engine->m_restitution);
                           });
            dWorldStep(m_world, dt);
            dJointGroupEmpty(m_contacts);
        }
    }

    Ball ball() const override {
        const dReal *position = dBodyGetPosition(m_body);
        const dReal *velocity = dBodyGetLinearVel(m_body);
        return {{position[0], position[1]}, {velocity[0], velocity[1]}};
    }

private:
    void addContacts(dGeomID other, double friction, double restitution) {
        dContactGeom touching;
        if (dCollide(m_ball, other, 1, &touching, sizeof touching) == 0) return;
        dContact contact{};
        contact.geom = touching;
        contact.surface.mode = dContactBounce | dContactApprox1;
        contact.surface.mu = friction;
        contact.surface.bounce = restitution;
        contact.surface.bounce_vel = 0;
        dJointAttach(dJointCreateContact(m_world, m_contacts, &contact), m_body, nullptr);
    }

    dWorldID m_world;
    dSpaceID m_walls;
    dJointGroupID m_contacts;
    dGeomID m_floor = nullptr;
    dGeomID m_ball = nullptr;
    dBodyID m_body = nullptr;
    double m_radius;
    double m_restitution;
    double m_floorFriction;
};

} // namespace

std::vector<EngineKind> odeEngines() {
    return {{"ode", false, false,
             "3D, double; quadtree; dWorldStep; CFM 1e-15, ERP 0.2; bounce_vel 0; no auto-disable; no continuous "
             "detection exists",
             [](const Scene &scene, double) { return std::make_unique<OdeEngine>(scene); }}};
}

} // namespace bench
