// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "scenecopies.h"

#include <algorithm>
#include <cassert>
#include <filesystem>
#include <map>
#include <utility>

#include "core/fractal/copies.h"
#include "core/fractal/counts.h"
#include "core/geometry/normals.h"

namespace romanesco {

namespace {

/// Whether a copy of the item can be mirrored.
bool mirrors(const SceneItem &item)
{
    const FractalGraph &graph = item.model->graph;
    bool isAny = isMirrored(item.worldFromModel.linear);
    for (SetId set = 0; set < graph.setCount(); ++set) {
        isAny = isAny || std::ranges::any_of(graph.facts(set), [](const MapFacts &facts) { return facts.sign < 0; });
    }
    return isAny;
}

/// The path's last part without its ending, made a single word; with a number where it has been used before.
std::vector<std::string> namesOf(const Scene &scene, const std::string &name)
{
    std::vector<std::string> names;
    std::map<std::string, int> uses;
    for (const SceneItem &item : scene.items) {
        std::string stem = std::filesystem::path(item.path.empty() ? name : item.path).stem().string();
        std::ranges::replace_if(stem, [](char c) { return static_cast<unsigned char>(c) <= ' '; }, '_');
        stem = stem.empty() ? "item" : stem;
        const int use = ++uses[stem];
        names.push_back(use == 1 ? stem : stem + "-" + std::to_string(use));
    }
    return names;
}

/// Keeps the name of the branch while it stays the same.
class BranchName
{
public:
    explicit BranchName(const std::string &item)
        : m_item(item)
        , m_name(item)
    {
    }

    std::string_view of(std::span<const Pick> address)
    {
        const std::optional<Pick> first = address.empty() ? std::nullopt : std::optional(address.front());
        if (first != m_first) {
            m_first = first;
            m_name = m_item;
            if (first) {
                m_name += "." + std::to_string(first->position + 1) + "." + std::to_string(first->map + 1);
            }
        }
        return m_name;
    }

private:
    const std::string &m_item;
    std::optional<Pick> m_first;
    std::string m_name;
};

}

std::optional<std::vector<std::uint64_t>> SceneCopies::count(const Scene &scene)
{
    std::map<const Model *, std::uint64_t> known;
    std::vector<std::uint64_t> counts;
    for (const SceneItem &item : scene.items) {
        const auto [model, isNew] = known.try_emplace(item.model.get());
        if (isNew) {
            const std::optional<Count> count = instancesDistinct(item.model->graph);
            const std::optional<std::uint64_t> fitting = count ? count->toInteger() : std::nullopt;
            if (!fitting) {
                return std::nullopt;
            }
            model->second = *fitting;
        }
        counts.push_back(model->second);
    }
    return counts;
}

SceneCopies::SceneCopies(const Scene &scene, const std::vector<std::uint64_t> &counts, Branches branches,
                         const std::string &name, std::stop_token stop)
    : m_scene(scene)
    , m_branches(branches)
    , m_stop(std::move(stop))
    , m_names(namesOf(scene, name))
{
    assert(counts.size() == scene.items.size() && "a count for each item");
    for (std::size_t i = 0; i < scene.items.size(); ++i) {
        m_items.push_back({scene.items[i].model->mesh.get(), counts[i]});
    }
}

std::expected<void, std::string> SceneCopies::visit(std::size_t item, const Visitor &visitor) const
{
    const SceneItem &placed = m_scene.items[item];
    const bool isPlaced = placed.worldFromModel != AffineMap{};
    const bool mayMirror = mirrors(placed);
    const bool isNamed = m_branches == Branches::Named;
    BranchName branch(m_names[item]);
    CopyWalk walk(placed.model->graph, isNamed ? CopyWalk::Addresses::Keep : CopyWalk::Addresses::Drop, m_stop);
    MeshCopy copy;
    while (walk.next()) {
        copy.worldFromMesh = isPlaced ? placed.worldFromModel * walk.modelFromBase() : walk.modelFromBase();
        copy.isMirrored = mayMirror && isMirrored(copy.worldFromMesh.linear);
        if (isNamed) {
            copy.branch = branch.of(walk.address());
        }
        if (!visitor(copy)) {
            return {};
        }
    }
    return m_stop.stop_requested() ? std::expected<void, std::string>(std::unexpect, "cancelled")
                                   : std::expected<void, std::string>();
}

}
