// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <stop_token>
#include <string>
#include <vector>

#include "core/formats/copysource.h"
#include "core/scene/scene.h"

namespace romanesco {

/// The copies that a scene consists of: those of each item in turn, in the world.
class SceneCopies final : public CopySource
{
public:
    enum class Branches { Unnamed, Named };

    /// Copies of each item, distinct ones (see instancesDistinct()); nothing where they cannot be counted or are 2^64 or
    /// more, and then there is no SceneCopies either.
    [[nodiscard]] static std::optional<std::vector<std::uint64_t>> count(const Scene &scene);

    /// scene must outlive it. Named branches: the copies of an item that start with the same pick belong together, as
    /// "tree.1.2" (item, level, map, each from 1); those without a pick are "tree". name is that of an item which has no
    /// path. Visits end with "cancelled" once a stop is asked for.
    SceneCopies(const Scene &scene, const std::vector<std::uint64_t> &counts, Branches branches,
                const std::string &name, std::stop_token stop);

    [[nodiscard]] std::span<const Item> items() const override { return m_items; }
    [[nodiscard]] std::expected<void, std::string> visit(std::size_t item, const Visitor &visitor) const override;

private:
    const Scene &m_scene;
    Branches m_branches;
    std::stop_token m_stop;
    std::vector<Item> m_items;
    /// Beside items.
    std::vector<std::string> m_names;
};

}
