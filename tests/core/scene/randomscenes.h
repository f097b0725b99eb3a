// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <limits>
#include <memory>
#include <random>
#include <vector>

#include <QTest>

#include "core/collide/colliderkind.h"
#include "core/fractal/extent.h"
#include "core/scene/scene.h"
#include "tests/core/collide/bruteforce.h"
#include "tests/core/fractal/samples.h"

/// Scenes of fractals in random places, small enough to be written out.
namespace romanesco::test {

inline std::shared_ptr<const Model> modelOf(const FractalGraph &graph, const Mesh &mesh)
{
    const auto shared = std::make_shared<const Mesh>(mesh);
    BoxBounds boxes(graph, *shared);
    const Box box = extent(graph, boxes, *shared);
    return std::make_shared<const Model>(Model{shared, graph, std::move(boxes), box, {}});
}

inline std::shared_ptr<const Model> modelOf(const Mesh &mesh)
{
    return modelOf(FractalGraph::ofMesh(boundingSphere(mesh)), mesh);
}

inline std::shared_ptr<const Model> modelOf(const QString &example, std::uint64_t depth)
{
    const Sample made = sample(example, depth);
    return modelOf(made.graph, made.mesh);
}

inline std::shared_ptr<const Scene> sceneOf(std::vector<SceneItem> items)
{
    Scene scene;
    scene.items = std::move(items);
    return std::make_shared<const Scene>(std::move(scene));
}

/// Six of them among each other, at angles of their own.
inline std::vector<SceneItem> heapOf(const std::shared_ptr<const Model> &model, std::mt19937_64 &random)
{
    std::vector<SceneItem> items;
    for (int i = 0; i < 6; ++i) {
        items.push_back(
            {.model = model, .worldFromModel = mapFromParts(randomPoint(random, 4), {10.0 * i, 50, 0}, {1, 1, 1})});
    }
    return items;
}

/// A row for each kind of collider.
inline void addKinds()
{
    QTest::addColumn<ColliderKind>("kind");
    QTest::newRow("exact") << ColliderKind::Exact;
    QTest::newRow("approximate") << ColliderKind::Approximate;
    QTest::newRow("bvh") << ColliderKind::Bvh;
    QTest::newRow("simple") << ColliderKind::Simple;
    QTest::newRow("greedy") << ColliderKind::Greedy;
    QTest::newRow("octree") << ColliderKind::Octree;
}

/// Moved only, or a similarity, a mirror, sheared, of unequal scales, flat, a line, a point, or where it was.
inline AffineMap randomPlace(std::mt19937_64 &random)
{
    const auto angle = [&] { return uniform(random, -180, 180); };
    const auto size = [&] { return uniform(random, 0.3, 2); };
    const glm::dvec3 scales[]{glm::dvec3(1), glm::dvec3(size()),   {-1, 1, 1}, {size(), size(), size()},
                              {1, 1, 0},     {0, size(), -size()}, {0, 2, 0},  {0, 0, 0}};
    const std::uint64_t kind = random() % 10;
    if (kind == 9) {
        return {};
    }
    AffineMap map = mapFromParts(randomPoint(random, 6), {angle(), angle(), angle()}, scales[kind % 8]);
    if (kind == 8) {
        map.linear[0] += size() * map.linear[2];
    }
    return map;
}

/// A random scene, and how far a point is from it, by all that is written in it.
struct Written {
    std::vector<RandomFractal> fractals;
    std::vector<SceneItem> items;
    /// Beside items.
    std::vector<std::size_t> fractalOfItem;

    [[nodiscard]] Wide distanceToItem(std::size_t item, const glm::dvec3 &p) const
    {
        const RandomFractal &written = fractals[fractalOfItem[item]];
        naive::Fractal placed = written.fractal;
        placed.maps.push_back(items[item].worldFromModel);
        Wide least = std::numeric_limits<double>::infinity();
        for (naive::Picks picks : naive::allPicks(placed.levels())) {
            picks.insert(picks.begin(), static_cast<int>(placed.maps.size()) - 1);
            least = std::min(least, distanceToCopy(placed, written.mesh, picks, p));
        }
        return least;
    }

    [[nodiscard]] Wide distance(const glm::dvec3 &p) const
    {
        Wide least = std::numeric_limits<double>::infinity();
        for (std::size_t i = 0; i < items.size(); ++i) {
            if (items[i].kind != SceneDescription::Kind::Ball) {
                least = std::min(least, distanceToItem(i, p));
            }
        }
        return least;
    }
};

inline Written randomScene(std::mt19937_64 &random)
{
    Written written;
    std::vector<std::shared_ptr<const Model>> models;
    while (models.size() < 2) {
        RandomFractal one = randomFractalWithMesh(random, 0.7);
        if (naive::wordsAsWritten(one.fractal.levels()) <= 40) {
            models.push_back(modelOf(one.graph, one.mesh));
            written.fractals.push_back(std::move(one));
        }
    }
    const std::size_t count = random() % 5 + 1;
    for (std::size_t i = 0; i < count; ++i) {
        written.fractalOfItem.push_back(random() % 2);
        written.items.push_back(
            {.model = models[written.fractalOfItem.back()],
             .worldFromModel = randomPlace(random),
             .kind = random() % 7 == 0 ? SceneDescription::Kind::Ball : SceneDescription::Kind::Fractal});
    }
    return written;
}

}
