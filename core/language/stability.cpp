// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "stability.h"

#include <algorithm>
#include <cmath>
#include <format>
#include <utility>

#include <glm/matrix.hpp>

#include "core/formats/fdoreader.h"

namespace romanesco {

namespace {

/// What one set of the result says.
struct SetFacts {
    double largestNorm = 0.0;
    SourceRange largest;
    bool holdsIdentity = false;
    /// Uses that scale unevenly, and linear parts of uses that turn; some of each are enough to find a shear.
    struct Uneven {
        SourceRange use;
        glm::dmat3 linear;
    };
    std::vector<Uneven> uneven;
    std::vector<glm::dmat3> turned;
    bool saysGrowing = false;
    bool saysSheared = false;
    std::size_t turnsSeen = 0;
};

constexpr std::size_t mostKept = 16;
/// Copies of this size relative to the whole lie between neighbouring doubles.
constexpr double smallest = 1e-16;

/// Whether a map, after another, leaves right angles: the columns of their product stay orthogonal.
bool shears(const glm::dmat3 &outer, const glm::dmat3 &inner)
{
    const glm::dmat3 product = outer * inner;
    for (int i = 0; i < 3; ++i) {
        const glm::dvec3 &a = product[i];
        const glm::dvec3 &b = product[(i + 1) % 3];
        const double across = std::abs(a.x * b.x + a.y * b.y + a.z * b.z);
        if (across > 1e-9 * std::sqrt((a.x * a.x + a.y * a.y + a.z * a.z) * (b.x * b.x + b.y * b.y + b.z * b.z))) {
            return true;
        }
    }
    return false;
}

class Observer
{
public:
    Observer(const FdoDocument &document, const FractalDescription &description)
        : m_syntax(document.syntax)
        , m_model(document.model)
        , m_description(description)
        , m_facts(description.sets.size())
        , m_isLookedAt(description.sets.size())
    {
    }

    Diagnostics observe()
    {
        const LevelSequence &levels = m_description.levels;
        for (LevelSequence::Slot slot = 0; slot < levels.slotCount(); ++slot) {
            const SetId set = levels.set(slot);
            if (!m_isLookedAt[set]) {
                m_isLookedAt[set] = true;
                lookAt(set);
            }
        }
        for (std::size_t repeat = 1; repeat < levels.repeats().size(); ++repeat) {
            if (levels.repeats()[repeat].count > 1) {
                checkConvergence(levels.repeats()[repeat]);
            }
        }
        checkShear();
        checkDepth();
        sortByPlace(m_found);
        return std::move(m_found);
    }

private:
    void report(DiagnosticCode code, SourceRange range, std::vector<std::string> arguments)
    {
        m_found.push_back({code, range, std::move(arguments)});
    }

    [[nodiscard]] std::string words(SourceRange range) const
    {
        return m_syntax.text().substr(range.begin, range.length());
    }

    // ---- One set

    void lookAt(SetId id)
    {
        const SetPlace &place = m_model.sets[id];
        const auto &node = std::get<ObjectDeclaration>(m_syntax.line(place.line).declaration);
        SetFacts &facts = m_facts[id];
        facts.holdsIdentity = m_description.sets[id].holdsIdentity;
        bool saysMirrored = false;
        bool saysSingular = false;
        bool saysGimbal = false;
        for (const TransformationUse &use : node.value.sets[place.index].uses) {
            const std::optional<TransformParts> parts = m_model.parts(use, place.line);
            const AffineMap map = parts ? mapFromParts(parts->position, parts->rotation, parts->scale) : AffineMap{};
            if (!parts || map == AffineMap{}) {
                continue;
            }
            const SourceRange range = m_syntax.range(place.line, use.range);
            addFacts(facts, range, *parts, map);
            const glm::dvec3 &scale = parts->scale;
            const bool isFlat = scale.x == 0.0 || scale.y == 0.0 || scale.z == 0.0;
            if (isFlat && !std::exchange(saysSingular, true)) {
                report(DiagnosticCode::Singular, range, {words(range)});
            }
            const bool isMirrored = !isFlat && (scale.x < 0.0) != ((scale.y < 0.0) != (scale.z < 0.0));
            if (isMirrored && !std::exchange(saysMirrored, true)) {
                report(DiagnosticCode::Mirrored, range, {words(range)});
            }
            if (isNearGimbal(parts->rotation) && !std::exchange(saysGimbal, true)) {
                report(DiagnosticCode::NearGimbal, range, {words(range), std::format("{:.6g}", parts->rotation.y)});
            }
        }
    }

    static void addFacts(SetFacts &facts, SourceRange range, const TransformParts &parts, const AffineMap &map)
    {
        // the rotation keeps lengths, so the largest scale is the operator norm
        const glm::dvec3 scale(std::abs(parts.scale.x), std::abs(parts.scale.y), std::abs(parts.scale.z));
        const double norm = std::max({scale.x, scale.y, scale.z});
        if (facts.largest.length() == 0 || norm > facts.largestNorm) {
            facts.largestNorm = norm;
            facts.largest = range;
        }
        const bool isUneven = scale.x != scale.y || scale.y != scale.z;
        if (isUneven && facts.uneven.size() < mostKept) {
            facts.uneven.push_back({range, map.linear});
        }
        if (parts.rotation != glm::dvec3(0.0) && facts.turned.size() < mostKept) {
            facts.turned.push_back(map.linear);
        }
    }

    /// Within half a degree of ±90 about y, and turned about another axis as well.
    static bool isNearGimbal(const glm::dvec3 &degrees)
    {
        const double fromQuarter = std::abs(std::remainder(degrees.y - 90.0, 180.0));
        return fromQuarter < 0.5 && (degrees.x != 0.0 || degrees.z != 0.0);
    }

    // ---- Iterations

    /// A pass takes one map of each level, and `#` of those that hold it but not of all: it makes things smaller by all
    /// its maps together, or by one of them where the others may be passed over.
    void checkConvergence(const LevelSequence::Repeat &repeat)
    {
        const std::vector<double> passes = passesWithin(repeat);
        double pass = 0.0; // a logarithm
        bool areAllSmaller = true;
        SetFacts *widest = nullptr;
        for (LevelSequence::Slot slot = repeat.firstSlot; slot < repeat.endSlot; ++slot) {
            SetFacts &facts = m_facts[m_description.levels.set(slot)];
            if (facts.largest.length() == 0) {
                continue; // nothing but #
            }
            const double norm = std::log(facts.largestNorm);
            pass += passes[slot - repeat.firstSlot] * (facts.holdsIdentity ? std::max(0.0, norm) : norm);
            areAllSmaller = areAllSmaller && facts.largestNorm < 1.0;
            if (!widest || facts.largestNorm > widest->largestNorm) {
                widest = &facts;
            }
        }
        if (widest && !areAllSmaller && pass >= 0.0 && !std::exchange(widest->saysGrowing, true)) {
            report(DiagnosticCode::DoesNotConverge, widest->largest,
                   {words(widest->largest), std::format("{:.6g}", widest->largestNorm), nameOfRepeat(repeat)});
        }
    }

    /// How often one pass of a repeat goes through each of its slots.
    [[nodiscard]] std::vector<double> passesWithin(const LevelSequence::Repeat &repeat) const
    {
        std::vector<double> passes(repeat.endSlot - repeat.firstSlot, 1.0);
        std::vector<const LevelSequence::Repeat *> open{&repeat};
        while (!open.empty()) {
            const LevelSequence::Repeat &outer = *open.back();
            open.pop_back();
            for (const std::uint32_t index : outer.inner) {
                const LevelSequence::Repeat &inner = m_description.levels.repeats()[index];
                const auto begin = passes.begin() - repeat.firstSlot;
                std::for_each(begin + inner.firstSlot, begin + inner.endSlot,
                              [&](double &times) { times *= static_cast<double>(inner.count); });
                open.push_back(&inner);
            }
        }
        return passes;
    }

    /// The recursive whose iteration is repeated.
    [[nodiscard]] std::string nameOfRepeat(const LevelSequence::Repeat &repeat) const
    {
        const SetPlace &place = m_model.sets[m_description.levels.set(repeat.firstSlot)];
        Position position = repeat.offset;
        for (std::uint32_t at = repeat.parent; at != 0; at = m_description.levels.repeats()[at].parent) {
            position += m_description.levels.repeats()[at].offset;
        }
        const ObjectForest::Origin origin = m_model.forest.origin(m_model.result, position);
        const NameId name =
            origin.passes.empty() ? NameTable::nameless : m_model.forest[origin.passes.back().recursive].name;
        if (name != NameTable::nameless) {
            return std::string(m_syntax.names()[name]);
        }
        const auto &node = std::get<ObjectDeclaration>(m_syntax.line(place.line).declaration);
        return m_syntax.name(node.name);
    }

    // ---- The whole

    /// An uneven scale and, further inside or again in the next pass, a turn that it does not commute with.
    void checkShear()
    {
        const LevelSequence &levels = m_description.levels;
        std::vector<glm::dmat3> turned; // of the sets from a slot inwards
        std::vector<bool> isTaken(m_facts.size());
        LevelSequence::Slot taken = levels.slotCount();
        for (LevelSequence::Slot slot = levels.slotCount(); slot-- > 0;) {
            const LevelSequence::Repeat *repeat = outermostRepeat(slot);
            const LevelSequence::Slot from = repeat ? repeat->firstSlot : slot + 1;
            while (taken > from) {
                const SetId set = levels.set(--taken);
                if (turned.size() < mostKept && !isTaken[set]) {
                    isTaken[set] = true;
                    turned.insert(turned.end(), m_facts[set].turned.begin(), m_facts[set].turned.end());
                }
            }
            checkShear(m_facts[levels.set(slot)], turned);
        }
    }

    void checkShear(SetFacts &facts, const std::vector<glm::dmat3> &turned)
    {
        if (facts.saysSheared || facts.turnsSeen == turned.size()) {
            return; // looked at already
        }
        facts.turnsSeen = turned.size();
        for (const SetFacts::Uneven &uneven : facts.uneven) {
            const bool isSheared =
                std::ranges::any_of(turned, [&](const glm::dmat3 &inner) { return shears(uneven.linear, inner); });
            if (isSheared && !std::exchange(facts.saysSheared, true)) {
                report(DiagnosticCode::Sheared, uneven.use, {words(uneven.use)});
            }
        }
    }

    /// What is passed through more than once. Repeats are in order, and those of the whole sequence do not overlap.
    [[nodiscard]] const LevelSequence::Repeat *outermostRepeat(LevelSequence::Slot slot) const
    {
        const std::vector<LevelSequence::Repeat> &repeats = m_description.levels.repeats();
        const std::vector<std::uint32_t> &inner = repeats[0].inner;
        const auto after =
            std::ranges::upper_bound(inner, slot, {}, [&](std::uint32_t i) { return repeats[i].firstSlot; });
        const LevelSequence::Repeat *before = after == inner.begin() ? nullptr : &repeats[*(after - 1)];
        return before && before->count > 1 && slot < before->endSlot ? before : nullptr;
    }

    /// For the depth that a slider moves: where the copies that all passes have made smaller become too small.
    void checkDepth()
    {
        if (!m_description.depth) {
            return;
        }
        const LevelSequence &levels = m_description.levels;
        for (const std::uint32_t inner : levels.repeats()[0].inner) {
            const LevelSequence::Repeat &repeat = levels.repeats()[inner];
            if (repeat.count != m_description.depth->value) {
                continue;
            }
            const double pass = logOfPass(repeat);
            const double limit = std::ceil(std::log(smallest) / pass);
            if (pass < 0.0 && static_cast<double>(repeat.count) >= limit) {
                report(DiagnosticCode::BeyondDouble, m_description.depth->range, {std::format("{:.0f}", limit)});
            }
            return;
        }
    }

    /// The logarithm of how much smaller one pass makes what no `#` spares; 0 where a set is flat.
    [[nodiscard]] double logOfPass(const LevelSequence::Repeat &repeat) const
    {
        const std::vector<double> passes = passesWithin(repeat);
        double sum = 0.0;
        for (LevelSequence::Slot slot = repeat.firstSlot; slot < repeat.endSlot; ++slot) {
            const SetFacts &facts = m_facts[m_description.levels.set(slot)];
            if (facts.largest.length() > 0) {
                sum += passes[slot - repeat.firstSlot] * std::log(facts.largestNorm);
            }
        }
        return std::isfinite(sum) ? sum : 0.0;
    }

    const FdoSyntax &m_syntax;
    const FdoModel &m_model;
    const FractalDescription &m_description;
    std::vector<SetFacts> m_facts;
    std::vector<bool> m_isLookedAt;
    Diagnostics m_found;
};

}

Diagnostics stabilityHints(const FdoDocument &document, const FractalDescription &description)
{
    return Observer(document, description).observe();
}

Diagnostics stabilityHints(std::string_view text)
{
    const FdoDocument document{std::string(text)};
    const FdoResult read = describeFdo(document.syntax, document.model);
    return read.description ? stabilityHints(document, *read.description) : Diagnostics();
}

}
