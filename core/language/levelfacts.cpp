// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "levelfacts.h"

#include <algorithm>
#include <limits>
#include <unordered_map>
#include <unordered_set>

namespace romanesco {

namespace {

using Slot = LevelSequence::Slot;

constexpr std::size_t mostUses = 20'000;

/// A product of many small factors, most of which are multiplied by the machine.
class Product
{
public:
    void multiply(std::uint64_t factor)
    {
        std::uint64_t product = 0;
        if (__builtin_mul_overflow(m_pending, factor, &product)) {
            m_total *= Count(m_pending);
            product = factor;
        }
        m_pending = product;
    }
    void multiply(const Count &factor) { m_total *= factor; }
    [[nodiscard]] Count value() const { return m_total * Count(m_pending); }

private:
    Count m_total = 1;
    std::uint64_t m_pending = 1;
};

class LevelCounter
{
public:
    LevelCounter(const FdoDocument &document, std::uint32_t node)
        : m_document(document)
        , m_node(document.model.forest[node])
    {
        LevelSequence::Builder builder;
        document.model.forest.writeLevels(node, builder);
        m_levels = std::move(builder).build();
        m_end = m_node.isRecursive ? m_node.iterationLevels : m_levels.levelCount();
    }

    std::optional<LevelFacts> count()
    {
        if (!measureSets()) {
            return std::nullopt;
        }
        LevelFacts facts;
        facts.levelCount = m_end;
        for (Position position = 0; position < std::min<Position>(m_end, LevelFacts::mostSizes); ++position) {
            facts.sizes.push_back(sizeAt(m_levels.locate(position).slot));
        }
        multiplyPasses();
        facts.instances = m_passes[0];
        const std::vector<LevelSequence::Repeat> &repeats = m_levels.repeats();
        if (repeats.size() == 2 && repeats[1].offset == 0 && repeats[1].length() == m_end) {
            facts.iteration = LevelFacts::Iteration{m_passes[1], repeats[1].count};
        }
        return facts;
    }

private:
    [[nodiscard]] std::uint64_t sizeAt(Slot slot) const { return m_sizes.at(m_levels.set(slot)); }

    /// The sizes of all sets that the levels have; false where they hold too many transformations.
    bool measureSets()
    {
        std::size_t uses = 0;
        for (Slot slot = 0; slot < m_levels.slotCount(); ++slot) {
            const auto [entry, isNew] = m_sizes.try_emplace(m_levels.set(slot), 0);
            if (!isNew) {
                continue;
            }
            const auto [line, index] = m_document.model.sets[entry->first];
            const auto &node = std::get<ObjectDeclaration>(m_document.syntax.line(line).declaration);
            const SetExpression &set = node.value.sets[index];
            uses += set.uses.size();
            if (uses > mostUses) {
                return false;
            }
            entry->second = differentMaps(set, line);
        }
        return true;
    }

    [[nodiscard]] std::uint64_t differentMaps(const SetExpression &set, std::uint32_t line) const
    {
        std::unordered_set<AffineMap, AffineMapHash> maps;
        for (const TransformationUse &use : set.uses) {
            const std::optional<TransformParts> parts = m_document.model.parts(use, line);
            maps.insert(parts ? mapFromParts(parts->position, parts->rotation, parts->scale) : AffineMap{});
        }
        return maps.size();
    }

    /// What one pass of each repeat multiplies by, inner ones first; the whole sequence up to m_end only, which never
    /// falls into a repeat: the base of a recursive is none of its own iteration's parts.
    void multiplyPasses()
    {
        const std::vector<LevelSequence::Repeat> &repeats = m_levels.repeats();
        m_passes.assign(repeats.size(), Count(1));
        for (std::size_t i = repeats.size(); i-- > 0;) {
            const Position end = i == 0 ? m_end : std::numeric_limits<Position>::max();
            multiplyPass(repeats[i], end, m_passes[i]);
        }
    }

    void multiplyPass(const LevelSequence::Repeat &repeat, Position end, Count &result) const
    {
        Product product;
        Position position = 0;
        Slot slot = repeat.firstSlot;
        const auto multiplyTo = [&](Slot endSlot) {
            for (; slot < endSlot && position < end; ++slot, ++position) {
                product.multiply(sizeAt(slot));
            }
        };
        for (const std::uint32_t index : repeat.inner) {
            const LevelSequence::Repeat &inner = m_levels.repeats()[index];
            multiplyTo(inner.firstSlot);
            if (position >= end) {
                break;
            }
            product.multiply(power(m_passes[index], inner.count));
            position += inner.length();
            slot = inner.endSlot;
        }
        multiplyTo(repeat.endSlot);
        result = product.value();
    }

    const FdoDocument &m_document;
    const ObjectNode &m_node;
    LevelSequence m_levels;
    /// The levels before this position are asked for.
    Position m_end = 0;
    std::unordered_map<SetId, std::uint64_t> m_sizes;
    std::vector<Count> m_passes;
};

}

std::optional<LevelFacts> levelFacts(const FdoDocument &document, std::uint32_t node)
{
    const ObjectNode &start = document.model.forest[node];
    if (start.isBad || start.levels == std::numeric_limits<Position>::max()) {
        return std::nullopt;
    }
    return LevelCounter(document, node).count();
}

}
