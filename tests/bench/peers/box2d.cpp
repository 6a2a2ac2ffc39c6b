// SPDX-License-Identifier: MIT
// Box2D 2.4 of Debian: two dimensions, float, with continuous detection against everything static.
#include "peers/engine.h"

#include <box2d/box2d.h>

namespace bench {

namespace {

float single(double value) { return static_cast<float>(value); }

b2PolygonShape boxOf(const Wall &wall) {
    b2PolygonShape shape;
    shape.SetAsBox(single((wall.x1 - wall.x0) / 2), single((wall.y1 - wall.y0) / 2),
                   {single((wall.x0 + wall.x1) / 2), single((wall.y0 + wall.y1) / 2)}, 0);
    shape.m_radius = 0; // its skin of 1 cm would thicken every wall
    return shape;
}

class Box2dEngine final : public Engine {
public:
    explicit Box2dEngine(const Scene &scene)
        : m_world({0, 0})
        , m_share(scene.rolls ? 5.0 / 7.0 : 1.0) { // model.md 3.1
        m_world.SetAllowSleeping(false);
        b2BodyDef still;
        b2Body *ground = m_world.CreateBody(&still);
        for (const Wall &wall : scene.walls) addFixture(*ground, boxOf(wall), scene.restitution);
        b2BodyDef moving;
        moving.type = b2_dynamicBody;
        moving.bullet = true;
        moving.fixedRotation = true; // without friction no torque acts on it
        m_body = m_world.CreateBody(&moving);
        b2CircleShape circle;
        circle.m_radius = single(scene.radius);
        addFixture(*m_body, circle, 0); // Box2D uses the larger of both restitutions
        place(scene.start);
    }

    void place(const Ball &ball) override {
        m_body->SetTransform({single(ball.position.x), single(ball.position.y)}, 0);
        m_body->SetLinearVelocity({single(ball.velocity.x), single(ball.velocity.y)});
    }

    void setGravity(const phys_vec3 &gravity) override {
        m_world.SetGravity({single(m_share * gravity.x), single(m_share * gravity.y)});
    }

    void advance(double dt, int steps) override {
        constexpr int kVelocityIterations = 8;
        constexpr int kPositionIterations = 3;
        for (int step = 0; step < steps; ++step) m_world.Step(single(dt), kVelocityIterations, kPositionIterations);
    }

    Ball ball() const override {
        const b2Vec2 position = m_body->GetPosition();
        const b2Vec2 velocity = m_body->GetLinearVelocity();
        return {{position.x, position.y}, {velocity.x, velocity.y}};
    }

private:
    static void addFixture(b2Body &body, const b2Shape &shape, double restitution) {
        b2FixtureDef fixture;
        fixture.shape = &shape;
        fixture.friction = 0;
        fixture.density = 1;
        fixture.restitution = single(restitution);
        fixture.restitutionThreshold = 0; // 1 m/s by default: slower balls wouldn't bounce
        body.CreateFixture(&fixture);
    }

    b2World m_world;
    b2Body *m_body = nullptr;
    double m_share;
};

} // namespace

std::vector<EngineKind> box2dEngines() {
    return {{"box2d", false, false,
             "2D, float, top view without a floor; restitution threshold 0; walls without their skin of 1 cm; bullet "
             "flag; 8 and 3 "
             "iterations; at most 2 m a step (compiled in)",
             [](const Scene &scene, double) { return std::make_unique<Box2dEngine>(scene); }}};
}

} // namespace bench
