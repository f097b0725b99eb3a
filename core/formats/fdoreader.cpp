// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "fdoreader.h"

#include <cassert>
#include <unordered_map>

#include "core/text/places.h"
#include "lineparser.h"

namespace romanesco {

namespace {

class Reader
{
public:
    Reader(const FdoSyntax &syntax, const FdoModel &model)
        : m_syntax(syntax)
        , m_model(model)
        , m_sets(model.sets.size())
    {
    }

    FdoResult read()
    {
        m_result.diagnostics = m_model.diagnostics;
        for (std::uint32_t i = 0; i < m_model.forest.size(); ++i) {
            const ObjectNode &node = m_model.forest[i];
            for (SetId id = node.firstSet; id < node.endSet; ++id) {
                m_sets[id] = evaluated(m_model.sets[id]);
            }
        }
        describeResult();
        sortByPlace(m_result.diagnostics);
        return std::move(m_result);
    }

private:
    [[nodiscard]] const Value &valueIn(std::uint32_t line) const
    {
        return std::get<ObjectDeclaration>(m_syntax.line(line).declaration).value;
    }

    TransformSet evaluated(const SetPlace &place)
    {
        const SetExpression &expression = valueIn(place.line).sets[place.index];
        TransformSet set;
        set.range = m_syntax.range(place.line, expression.range);
        set.maps.reserve(expression.uses.size());
        set.uses.reserve(expression.uses.size());
        std::unordered_map<AffineMap, LineRange, AffineMapHash> seen;
        std::optional<Diagnostic> repeats; // one message a set
        LineRange previous;
        for (const TransformationUse &use : expression.uses) {
            AffineMap map;
            if (!use.isIdentity()) {
                const std::optional<TransformParts> parts = m_model.parts(use, place.line);
                assert(parts && "the uses of a good object are good");
                map = mapFromParts(parts->position, parts->rotation, parts->scale);
            }
            const auto [first, isNew] = seen.try_emplace(map, use.range);
            if (!isNew) {
                if (!repeats) {
                    repeats = repeat(place.line, use.range, first->second);
                }
                // it goes with the comma before it
                repeats->fix->edits.push_back({m_syntax.range(place.line, {previous.end, use.range.end}), ""});
            } else if (map == AffineMap{}) {
                set.holdsIdentity = true;
            } else {
                set.maps.push_back(map);
                set.uses.push_back(m_syntax.range(place.line, use.range));
            }
            previous = use.range;
        }
        if (repeats) {
            m_result.diagnostics.push_back(std::move(*repeats));
        }
        return set;
    }

    Diagnostic repeat(std::uint32_t line, LineRange use, LineRange earlier)
    {
        const SourceRange place = m_syntax.range(line, earlier);
        Diagnostic diagnostic{DiagnosticCode::EqualMaps,
                              m_syntax.range(line, use),
                              {std::string(m_syntax.words(line, use))}};
        diagnostic.fix = Fix{"Remove what is repeated", {}};
        diagnostic.notes.push_back(
            {DiagnosticCode::EarlierHere, place, {"the earlier one"}, {}, m_places.at(place.begin)});
        return diagnostic;
    }

    void describeResult()
    {
        if (m_model.result == ObjectNode::none || m_model.forest[m_model.result].isBad) {
            return;
        }
        LevelSequence::Builder builder;
        m_model.forest.writeLevels(m_model.result, builder);
        const std::uint32_t line = m_model.forest[m_model.forest.meshNode(m_model.result)].line;
        const LineRange mesh = valueIn(line).inner.range;
        m_result.description =
            FractalDescription{std::string(unquoted(m_syntax.words(line, mesh))), m_syntax.range(line, mesh),
                               std::move(m_sets), std::move(builder).build(), depth()};
    }

    [[nodiscard]] std::optional<FractalDescription::Depth> depth() const
    {
        const std::optional<std::uint32_t> line = m_model.depthLine();
        if (!line) {
            return std::nullopt;
        }
        const Value &value = valueIn(*line);
        return FractalDescription::Depth{value.depth.value_or(0), m_syntax.range(*line, value.depthRange)};
    }

    const FdoSyntax &m_syntax;
    const FdoModel &m_model;
    std::vector<TransformSet> m_sets;
    FdoResult m_result;
    Places m_places{m_syntax.map()};
};

}

FdoResult describeFdo(const FdoSyntax &syntax, const FdoModel &model)
{
    return Reader(syntax, model).read();
}

FdoResult readFdo(std::string_view text)
{
    const FdoSyntax syntax{std::string(text)};
    return describeFdo(syntax, resolveFdo(syntax));
}

}
