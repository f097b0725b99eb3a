// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <cstdint>
#include <deque>
#include <memory>
#include <span>
#include <vector>

#include "cut.h"

namespace romanesco {

/// The copies to draw of a whole scene: the cuts of its items, one after another in the order of their nodes. Items that
/// share a model share the states that were made of it. One thread.
class SceneCut
{
public:
    /// scene must outlive it.
    explicit SceneCut(const Scene &scene);

    /// Starts over (see Cut::begin()), with what surrounds a place in the scene.
    void begin(const Projector &projector, std::shared_ptr<const Surroundings> surroundings, double pixelTolerance,
               const CopyColours &colours = {}, bool leavesOutBalls = false);

    /// See Cut::setDepths().
    void setDepths(const Depths *depths);

    /// Nothing is left to be found.
    [[nodiscard]] bool isComplete() const { return m_runs.empty(); }
    /// The model whose copies come next, unless isComplete().
    [[nodiscard]] const Model &model() const { return *m_scene.items[item()].model; }
    /// The next copies of model(), about `count` of them, fewer or none (see Cut::next()). The reference holds until the
    /// next call.
    [[nodiscard]] const std::vector<Instance> &next(std::size_t count);
    /// Beside those; empty where copies have no colours of their own. Holds as long.
    [[nodiscard]] const std::vector<Tint> &tints() const { return *m_tints; }

    /// See Cut::isInDoubt().
    [[nodiscard]] bool isInDoubt() const { return m_isInDoubt; }

    /// Since begin(), of all items.
    [[nodiscard]] std::uint64_t instanceCount() const { return m_instances; }
    [[nodiscard]] std::uint64_t statesVisited() const { return m_visited; }
    [[nodiscard]] std::uint64_t hiddenCount() const { return m_hidden; }
    /// Greatest number of bytes held since begin().
    [[nodiscard]] std::size_t memoryUse() const { return m_memory; }

private:
    [[nodiscard]] std::size_t item() const { return m_runs.front().front().item; }
    [[nodiscard]] double nearestOf(std::span<const Surroundings::Node> nodes) const;
    void beginItem(Cut &cut);
    void finishItem();
    void dropSpent();

    /// What is drawn of a model, and the bytes that its cut held when it was looked at last.
    struct Part {
        Cut cut;
        std::size_t bytes = 0;
    };

    const Scene &m_scene;
    std::vector<Part> m_parts;
    /// By item, its model's.
    std::vector<std::size_t> m_partOf;
    std::shared_ptr<const Surroundings> m_surroundings;
    /// The nodes of an item each, of those that are not finished.
    std::deque<std::span<const Surroundings::Node>> m_runs;
    /// The part whose last copies were handed out, to be forgotten once they are used.
    Part *m_spent = nullptr;
    bool m_isItemBegun = false;
    Projector m_projector;
    double m_tolerance = 1.0;
    CopyColours m_colours;
    const std::vector<Tint> *m_tints = nullptr;
    std::uint64_t m_instances = 0;
    std::uint64_t m_visited = 0;
    std::uint64_t m_hidden = 0;
    bool m_isInDoubt = false;
    std::size_t m_bytes = 0;
    std::size_t m_memory = 0;
};

}
