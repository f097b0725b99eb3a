// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "scenecut.h"

#include <algorithm>
#include <map>
#include <utility>

namespace romanesco {

namespace {

/// Above this, what was made of a model does not wait for the next pass.
constexpr std::size_t mostBytesAtRest = 24'000'000;

}

SceneCut::SceneCut(const Scene &scene)
    : m_scene(scene)
{
    std::map<const Model *, std::size_t> known;
    for (const SceneItem &item : scene.items) {
        const auto [place, isNew] = known.try_emplace(item.model.get(), m_parts.size());
        if (isNew) {
            m_parts.emplace_back(Cut(*item.model));
        }
        m_partOf.push_back(place->second);
    }
}

void SceneCut::begin(const Projector &projector, double pixelTolerance, const CopyColours &colours)
{
    dropSpent();
    m_projector = projector;
    m_tolerance = pixelTolerance;
    m_colours = colours;
    m_item = 0;
    m_isItemBegun = false;
    m_instances = 0;
    m_visited = 0;
    m_memory = m_bytes;
}

const std::vector<Instance> &SceneCut::next(std::size_t count)
{
    dropSpent();
    Part &part = m_parts[m_partOf[m_item]];
    if (!m_isItemBegun) {
        m_isItemBegun = true;
        const std::optional<Selection> &selection = m_colours.selection;
        const bool isSelected = selection && selection->item == m_item;
        part.cut.setColours(m_colours.colouring, isSelected ? &selection->address : nullptr);
        part.cut.begin(m_projector, m_scene.items[m_item].worldFromModel, m_tolerance);
    }
    const std::vector<Instance> &instances = part.cut.next(count);
    m_tints = &part.cut.tints();
    const std::size_t others = m_bytes - part.bytes;
    m_memory = std::max(m_memory, others + part.cut.memoryUse());
    part.bytes = part.cut.memoryHeld();
    m_bytes = others + part.bytes;
    if (part.cut.isComplete()) {
        finishItem();
    }
    return instances;
}

void SceneCut::finishItem()
{
    Part &part = m_parts[m_partOf[m_item]];
    m_instances += part.cut.instanceCount();
    m_visited += part.cut.statesVisited();
    if (m_parts.size() > 1 && m_bytes > mostBytesAtRest) {
        m_spent = &part; // its copies are still looked at
    }
    ++m_item;
    m_isItemBegun = false;
}

void SceneCut::dropSpent()
{
    if (Part *part = std::exchange(m_spent, nullptr)) {
        part->cut.forget();
        m_bytes -= part->bytes;
        part->bytes = part->cut.memoryHeld();
        m_bytes += part->bytes;
    }
}

}
