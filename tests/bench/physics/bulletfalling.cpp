// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include <chrono>
#include <deque>

#include <btBulletDynamicsCommon.h>

#include "falling.h"
#include "tests/bench/heap.h"

namespace romanesco::bench {

namespace {

/// Of the radius: what moves by more in a step is swept, as a sphere so large.
constexpr double leastMotion = 0.5;
constexpr double sweptRadius = 0.9;

constexpr int groundGroup = 1;
constexpr int ballGroup = 2;

btScalar single(double value)
{
    return static_cast<btScalar>(value);
}

btVector3 vector(const glm::dvec3 &v)
{
    return {single(v.x), single(v.y), single(v.z)};
}

btTransform placed(const glm::dvec3 &position)
{
    return btTransform(btQuaternion::getIdentity(), vector(position));
}

/// Without friction, spin or damping, as ours are.
btRigidBody::btRigidBodyConstructionInfo infoOf(btScalar mass, btCollisionShape &shape, const glm::dvec3 &position)
{
    btRigidBody::btRigidBodyConstructionInfo info(mass, nullptr, &shape, btVector3(0, 0, 0));
    info.m_startWorldTransform = placed(position);
    info.m_friction = 0;
    info.m_restitution = 1;
    return info;
}

class BulletFalling final : public Falling
{
public:
    BulletFalling(btBvhTriangleMeshShape &mesh, const std::vector<Ball> &balls, const Options &options)
        : m_timeStep(single(options.timeStep))
        , m_dispatcher(&m_configuration)
        , m_world(&m_dispatcher, &m_broadphase, &m_solver, &m_configuration)
        , m_ground(infoOf(0, mesh, glm::dvec3(0.0)))
    {
        m_world.setGravity(btVector3(0, single(-9.8), 0));
        m_world.addRigidBody(&m_ground, groundGroup, ballGroup);
        for (const Ball &ball : balls) {
            m_shapes.emplace_back(single(ball.radius));
            auto info = infoOf(1, m_shapes.back(), ball.position);
            info.m_restitution = single(ball.restitution); // of both it takes the product
            btRigidBody &body = m_bodies.emplace_back(info);
            body.setLinearVelocity(vector(ball.velocity));
            body.setCcdMotionThreshold(single(leastMotion * ball.radius));
            body.setCcdSweptSphereRadius(single(sweptRadius * ball.radius));
            m_world.addRigidBody(&body, ballGroup, options.areSolid ? groundGroup | ballGroup : groundGroup);
        }
    }

    ~BulletFalling() override
    {
        for (btRigidBody &body : m_bodies) {
            m_world.removeRigidBody(&body);
        }
        m_world.removeRigidBody(&m_ground);
    }

    void step() override { m_world.stepSimulation(m_timeStep, 0); }

    void look(std::vector<State> &states) const override
    {
        states.resize(m_bodies.size());
        for (std::size_t i = 0; i < states.size(); ++i) {
            const btVector3 &place = m_bodies[i].getWorldTransform().getOrigin();
            states[i] = {{place.x(), place.y(), place.z()}, m_bodies[i].isActive(), false};
        }
    }

private:
    btScalar m_timeStep;
    btDefaultCollisionConfiguration m_configuration;
    btCollisionDispatcher m_dispatcher;
    btDbvtBroadphase m_broadphase;
    btSequentialImpulseConstraintSolver m_solver;
    btDiscreteDynamicsWorld m_world;
    btRigidBody m_ground;
    std::deque<btSphereShape> m_shapes;
    std::deque<btRigidBody> m_bodies;
};

class BulletEngine final : public Engine
{
public:
    explicit BulletEngine(const Ground &ground)
    {
        const std::size_t before = heapInUse();
        const auto begin = std::chrono::steady_clock::now();
        for (const glm::dvec3 &vertex : ground.all.vertices) {
            for (int i = 0; i < 3; ++i) {
                m_vertices.push_back(single(vertex[i]));
            }
        }
        m_vertices.shrink_to_fit();
        for (const Mesh::Face &face : ground.all.faces) {
            m_indices.insert(m_indices.end(),
                             {static_cast<int>(face[0]), static_cast<int>(face[1]), static_cast<int>(face[2])});
        }
        m_indices.shrink_to_fit();
        m_mesh = std::make_unique<btTriangleIndexVertexArray>(
            static_cast<int>(ground.all.faces.size()), m_indices.data(), static_cast<int>(3 * sizeof(int)),
            static_cast<int>(ground.all.vertices.size()), m_vertices.data(), static_cast<int>(3 * sizeof(btScalar)));
        m_shape = std::make_unique<btBvhTriangleMeshShape>(m_mesh.get(), true);
        m_shape->setMargin(0); // else everything is so much thicker
        m_seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
        m_bytes = heapInUse() - before;
    }

    [[nodiscard]] std::unique_ptr<Falling> fall(const std::vector<Ball> &balls,
                                                const Falling::Options &options) const override
    {
        return std::make_unique<BulletFalling>(*m_shape, balls, options);
    }
    [[nodiscard]] double seconds() const override { return m_seconds; }
    [[nodiscard]] std::size_t bytes() const override { return m_bytes; }

private:
    std::vector<btScalar> m_vertices;
    std::vector<int> m_indices;
    std::unique_ptr<btTriangleIndexVertexArray> m_mesh;
    std::unique_ptr<btBvhTriangleMeshShape> m_shape;
    double m_seconds = 0.0;
    std::size_t m_bytes = 0;
};

}

std::unique_ptr<Engine> bulletEngine(const Ground &ground)
{
    return std::make_unique<BulletEngine>(ground);
}

}
