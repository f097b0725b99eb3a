// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "greedycollider.h"

#include <algorithm>
#include <cassert>
#include <format>
#include <optional>

#include "nearest.h"
#include "sweeping.h"

namespace romanesco {

namespace {

using Slot = LevelSequence::Slot;
using Maps = std::vector<AffineMap>;

constexpr Position mostLevels = 1'000'000;
constexpr std::size_t mostTransformations = 100'000;

Maps mapsOf(const TransformSet &set)
{
    Maps maps = set.maps;
    if (set.holdsIdentity) {
        maps.emplace_back();
    }
    return maps;
}

/// All products of a pick from each level of an iteration; empty where they are too many.
Maps productsOf(const LevelSequence::Repeat &iteration, const std::vector<Maps> &ofSlot)
{
    Maps products{AffineMap{}};
    for (Slot slot = iteration.firstSlot; slot < iteration.endSlot; ++slot) {
        if (products.size() * ofSlot[slot].size() > mostTransformations) {
            return {};
        }
        Maps longer;
        for (const AffineMap &outer : products) {
            for (const AffineMap &inner : ofSlot[slot]) {
                longer.push_back(outer * inner);
            }
        }
        products = std::move(longer);
    }
    return products;
}

}

/// Goes down the fractal once for each query.
class GreedyCollider::Descent final : public Search
{
public:
    Descent(const GreedyCollider &collider, const AffineMap &worldFromModel)
        : m_collider(collider)
        , m_worldFromModel(worldFromModel)
    {
    }

    void closest(const Query &query, Hit &hit) override
    {
        clear(hit);
        NearestFace nearest(m_collider.m_mesh, query);
        if (m_collider.m_graph.levels().levelCount() == 0) {
            nearest.consider(m_worldFromModel, NearestFace::Counted::Ahead, m_vertices);
        }
        const bool isAtEnd =
            descend(query.stop, hit, [&](const Maps &maps, const AffineMap &worldFromStep, bool isLast) {
                nearest.restart();
                // the way down is to what is nearest in any case
                const auto counted = isLast ? NearestFace::Counted::Ahead : NearestFace::Counted::All;
                return lastOf(maps, worldFromStep,
                              [&](const AffineMap &map) { return nearest.consider(map, counted, m_vertices); })
                    .value_or(0);
            });
        if (!isAtEnd) {
            nearest.restart(); // what an earlier step found need not be there in the end
        }
        report(nearest, query, Promise::UpperBound, hit);
    }

    void sweep(const Sweep &sweep, Touch &touch) override
    {
        clear(touch);
        const Path path(sweep);
        FirstTouch first(m_collider.m_mesh, path);
        if (m_collider.m_graph.levels().levelCount() == 0) {
            first.consider(m_worldFromModel, m_vertices);
        }
        const bool isAtEnd = descend(sweep.stop, touch, [&](const Maps &maps, const AffineMap &worldFromStep, bool) {
            first.restart();
            const auto isFirst = [&](const AffineMap &map) { return first.consider(map, m_vertices); };
            if (const auto chosen = lastOf(maps, worldFromStep, isFirst)) {
                return *chosen;
            }
            const Query fromStart{.p = sweep.p};
            NearestFace nearest(m_collider.m_mesh, fromStart);
            return lastOf(maps, worldFromStep,
                          [&](const AffineMap &map) {
                              return nearest.consider(map, NearestFace::Counted::All, m_vertices);
                          })
                .value_or(0);
        });
        if (!isAtEnd) {
            first.restart();
        }
        first.report(sweep, touch);
        touch.promise = Promise::UpperBound;
        touch.lower = 0.0;
    }

private:
    /// From step to step: choose() says which transformation to go on in. Whether it came to the end.
    template<typename Choose>
    bool descend(const std::stop_token &stop, SurfacePoint &found, const Choose &choose)
    {
        const LevelSequence &levels = m_collider.m_graph.levels();
        AffineMap worldFromStep = m_worldFromModel;
        for (Position position = 0; position < levels.levelCount();) {
            if (stop.stop_requested()) {
                return false;
            }
            const LevelSequence::Location at = levels.locate(position);
            const Maps &iteration = m_collider.m_ofIteration[at.repeat];
            const Maps &maps = iteration.empty() ? m_collider.m_ofSlot[at.slot] : iteration;
            const Position end = position + (iteration.empty() ? 1 : levels.repeats()[at.repeat].passLength);
            assert(!maps.empty() && "a level has a map or #");
            const std::size_t chosen = choose(maps, worldFromStep, end == levels.levelCount());
            worldFromStep = worldFromStep * maps[chosen];
            appendPicks(position, end, chosen, found.address);
            ++found.cost.nodeVisits;
            position = end;
        }
        return true;
    }

    /// The last whose base mesh is better than those before; none where none counts.
    template<typename IsBetter>
    static std::optional<std::size_t> lastOf(const Maps &maps, const AffineMap &worldFromStep, const IsBetter &isBetter)
    {
        std::optional<std::size_t> chosen;
        for (std::size_t i = 0; i < maps.size(); ++i) {
            if (isBetter(worldFromStep * maps[i])) {
                chosen = i;
            }
        }
        return chosen;
    }

    /// The levels [position, end) are numbered by a step's transformations like the digits of a number.
    void appendPicks(Position position, Position end, std::size_t number, Address &address) const
    {
        const FractalGraph &graph = m_collider.m_graph;
        const std::size_t before = address.size();
        while (end-- > position) {
            const TransformSet &set = graph.setAt(graph.levels().locate(end).slot);
            const std::size_t map = number % set.size();
            number /= set.size();
            if (map < set.maps.size()) {
                address.push_back({end, static_cast<std::uint32_t>(map)});
            }
        }
        std::reverse(address.begin() + static_cast<std::ptrdiff_t>(before), address.end());
    }

    const GreedyCollider &m_collider;
    AffineMap m_worldFromModel;
    std::vector<glm::dvec3> m_vertices;
};

GreedyCollider::GreedyCollider(const FractalGraph &graph, const Mesh &mesh)
    : m_graph(graph)
    , m_mesh(mesh)
    , m_ofIteration(graph.levels().repeats().size())
{
    const LevelSequence &levels = graph.levels();
    for (Slot slot = 0; slot < levels.slotCount(); ++slot) {
        m_ofSlot.push_back(mapsOf(graph.setAt(slot)));
    }
    for (std::size_t i = 1; i < levels.repeats().size(); ++i) {
        if (levels.repeats()[i].inner.empty()) {
            m_ofIteration[i] = productsOf(levels.repeats()[i], m_ofSlot);
        }
    }
}

std::expected<GreedyCollider, std::string> GreedyCollider::create(const FractalGraph &graph, const Mesh &mesh)
{
    if (graph.levels().levelCount() > mostLevels) {
        return std::unexpected(std::format("a step for each of {} levels would take too long (at most {})",
                                           graph.levels().levelCount(), mostLevels));
    }
    return GreedyCollider(graph, mesh);
}

std::unique_ptr<Search> GreedyCollider::searchPlaced(const AffineMap &worldFromModel) const
{
    return std::make_unique<Descent>(*this, worldFromModel);
}

std::size_t GreedyCollider::memoryUse() const
{
    std::size_t bytes = sizeof(*this);
    for (const std::vector<Maps> *lists : {&m_ofIteration, &m_ofSlot}) {
        for (const Maps &maps : *lists) {
            bytes += sizeof(maps) + maps.capacity() * sizeof(AffineMap);
        }
    }
    return bytes;
}

}
