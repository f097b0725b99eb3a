// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <random>

#include "tests/core/physics/referee.h"
#include "tests/testmain.h"

/// Balls that are shot at surfaces, from everywhere, up to ten thousand radii a step.
namespace romanesco::test {

/// A closed surface: an octahedron whose faces are quartered so often, and blown up to a radius of 1.
inline Mesh roundMesh(int times)
{
    Mesh mesh{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {-1, 0, 0}, {0, -1, 0}, {0, 0, -1}}, {}};
    for (const std::uint32_t x : {0u, 3u}) {
        for (const std::uint32_t y : {1u, 4u}) {
            for (const std::uint32_t z : {2u, 5u}) {
                mesh.faces.push_back({x, y, z});
            }
        }
    }
    for (int time = 0; time < times; ++time) {
        std::vector<Mesh::Face> faces;
        for (const Mesh::Face &face : mesh.faces) {
            const auto next = static_cast<std::uint32_t>(mesh.vertices.size());
            for (std::size_t i = 0; i < 3; ++i) {
                mesh.vertices.push_back(glm::normalize(mesh.vertices[face[i]] + mesh.vertices[face[(i + 1) % 3]]));
            }
            for (std::uint32_t i = 0; i < 3; ++i) {
                faces.push_back({face[i], next + i, next + (i + 2) % 3});
            }
            faces.push_back({next, next + 1, next + 2});
        }
        mesh.faces = std::move(faces);
    }
    return mesh;
}

inline void addTargets()
{
    QTest::addColumn<std::vector<SceneItem>>("items");
    const auto row = [](const char *name, const std::shared_ptr<const Model> &model, const AffineMap &place = {}) {
        QTest::newRow(name) << std::vector<SceneItem>{{.model = model, .worldFromModel = place}};
    };
    const AffineMap turned = mapFromParts({0.3, -0.2, 0.1}, {25, -40, 70}, {1, 1, 1});
    row("a closed surface", modelOf(roundMesh(3)));
    row("Menger's sponge", modelOf(QStringLiteral("menger"), 2));
    row("a turned sponge", modelOf(QStringLiteral("menger"), 2), turned);
    row("two sets", modelOf(QStringLiteral("two-sets"), 2));
    row("a tree", modelOf(QStringLiteral("tree"), 5), turned);
    row("a sheared sponge", modelOf(QStringLiteral("menger"), 2),
        AffineMap{glm::dmat3(1, 0, 0, 0.4, 1, 0.2, 0, 0, 1), {}});
}

/// From where it touches nothing; a third towards a surface, so that they graze faces, edges and vertices of it.
inline BallState randomShot(std::mt19937_64 &random, const WrittenSurface &surface, const Sphere &around,
                            const Laws &laws)
{
    while (true) {
        BallState ball;
        ball.radius = around.radius * std::pow(10.0, uniform(random, -4.5, -1));
        ball.restitution = std::clamp(uniform(random, -0.5, 1.5), 0.0, 1.0);
        const double way = ball.radius * std::pow(10.0, uniform(random, 0, 4));
        glm::dvec3 along = glm::normalize(randomPoint(random, 1));
        ball.position = around.centre + randomPoint(random, 1.2 * around.radius);
        if (random() % 3 == 0) {
            const auto &triangle = surface.triangles()[random() % surface.triangles().size()];
            const auto vertex = [&](std::size_t i) {
                return glm::dvec3(triangle[i][0], triangle[i][1], triangle[i][2]);
            };
            const double s = random() % 2 == 0 ? 0.0 : uniform(random, 0, 1);
            const double t = random() % 2 == 0 ? 0.0 : uniform(random, 0, 1 - s);
            const glm::dvec3 at = vertex(0) + s * (vertex(1) - vertex(0)) + t * (vertex(2) - vertex(0));
            glm::dvec3 across = glm::cross(vertex(1) - vertex(0), vertex(2) - vertex(0));
            if (random() % 2 == 0) {
                across = glm::cross(along, randomPoint(random, 1));
            } else {
                along = glm::normalize(glm::cross(across, along));
            }
            const double off = (random() % 2 == 0 ? 1.0 : -1.0) * std::pow(10.0, uniform(random, -13, -1));
            ball.position =
                at + (1.0 + off) * ball.radius * glm::normalize(across) - uniform(random, 0, 1) * way * along;
        }
        ball.velocity = way / laws.timeStep * along;
        if (surface.distance(ball.position, ball.position, 2.0 * ball.radius) > 1.001 * ball.radius) {
            return ball;
        }
    }
}

/// Without gravity, or with.
inline void shoot(const std::vector<SceneItem> &items, int count, std::uint64_t own)
{
    Ground ground(items);
    const WrittenSurface surface(items);
    const Sphere around = boundingSphere(items.front());
    Referee referee(surface);
    std::mt19937_64 random(seed(own));
    for (int round = 0; round < count; ++round) {
        Laws laws;
        laws.gravity *= random() % 2 == 0 ? 1.0 : 0.0;
        BallState ball = randomShot(random, surface, around, laws);
        for (int step = 0; step < 2; ++step) {
            referee.step(ball, laws, ground.probe);
            const auto words = [&](const char *what, double number) {
                return qPrintable(QStringLiteral("%1 %2: round %3, r %4, e %5")
                                      .arg(QLatin1String(what))
                                      .arg(number)
                                      .arg(round)
                                      .arg(ball.radius)
                                      .arg(ball.restitution));
            };
            QVERIFY2(referee.penetration <= 1e-3, words("penetration", referee.penetration));
            QVERIFY2(referee.won <= 1.0, words("won", referee.won));
            QVERIFY2(referee.against <= 2e-4, words("against", referee.against));
        }
    }
    // a ball that bounces thousands of times in a step loses the rest of it
    QVERIFY(static_cast<double>(referee.exhausted) <= std::ceil(1e-5 * static_cast<double>(referee.steps)));
    QVERIFY(referee.contacts > referee.steps / 8);
}

}
