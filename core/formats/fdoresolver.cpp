// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "fdoresolver.h"

#include <format>
#include <limits>
#include <unordered_map>
#include <unordered_set>
#include <utility>

#include "core/text/linemap.h"
#include "fdoparser.h"
#include "objectforest.h"

namespace romanesco {

namespace {

enum class SymbolKind { Vector, Transformation, Object, Recursive, Unknown };

const char *described(SymbolKind kind)
{
    switch (kind) {
    case SymbolKind::Vector:
        return "a vector";
    case SymbolKind::Transformation:
        return "a transformation";
    case SymbolKind::Object:
        return "an object";
    case SymbolKind::Recursive:
        return "a recursive";
    case SymbolKind::Unknown:
        break;
    }
    return "unknown";
}

/// What a name stands for: index counts vectors, transformations, or nodes of the forest, by kind.
struct Symbol {
    SymbolKind kind;
    std::uint32_t index;
    SourceRange range;
    bool isBad = false;
    bool isUsed = false;
    bool isRepeated = false;
};

struct VectorEntry {
    glm::dvec3 value;
    bool isBad;
};

/// A result of a transformation: the identity, a vector of the file, or a parameter.
struct ResultSource {
    enum class Kind { Identity, Vector, Parameter } kind = Kind::Identity;
    std::size_t index = 0;
};

struct TransformationEntry {
    std::size_t parameterCount = 0;
    std::array<ResultSource, 3> results;
};

constexpr std::array<glm::dvec3, 3> identityParts{glm::dvec3(0.0), glm::dvec3(0.0), glm::dvec3(1.0)};

std::string plural(std::size_t count, const char *noun)
{
    return std::format("{} {}{}", count, noun, count == 1 ? "" : "s");
}

class Resolver
{
public:
    explicit Resolver(const FdoSyntax &syntax)
        : m_syntax(syntax)
        , m_lines(syntax.text)
    {
    }

    FdoResult resolve()
    {
        m_result.diagnostics = m_syntax.diagnostics;
        for (const Declaration &declaration : m_syntax.declarations) {
            std::visit([&](const auto &node) { declare(node, declaration.isBad); }, declaration.node);
        }
        hintAtUnused();
        describeResult();
        sortByPlace(m_result.diagnostics);
        return std::move(m_result);
    }

private:
    bool report(DiagnosticCode code, SourceRange range, std::vector<std::string> arguments = {})
    {
        m_result.diagnostics.push_back({code, range, std::move(arguments)});
        return false;
    }

    // ---- Declarations

    void declare(const VectorDeclaration &vector, bool isBad)
    {
        const auto index = static_cast<std::uint32_t>(m_vectors.size());
        m_vectors.push_back({vector.value, isBad});
        if (vector.name.text == "v" || vector.name.text.empty()) {
            return;
        }
        const auto known = m_symbols.find(vector.name.text);
        if (known != m_symbols.end() && known->second.kind == SymbolKind::Vector) {
            known->second.isRepeated = true; // fine until somebody refers to it
        } else {
            declareName(vector.name, SymbolKind::Vector, index, isBad);
        }
    }

    void declare(const TransformationDeclaration &node, bool isBad)
    {
        TransformationEntry entry;
        const bool isGood = !isBad && checkName(node.name) && resolveTransformation(node, entry);
        m_transformations.push_back(entry);
        declareName(node.name, SymbolKind::Transformation, static_cast<std::uint32_t>(m_transformations.size()) - 1,
                    !isGood);
    }

    void declare(const ObjectDeclaration &node, bool isBad)
    {
        ObjectNode object;
        object.name = node.isResult() ? std::string_view("<$>") : node.name.text;
        object.nameRange = node.name.range;
        object.isRecursive = node.base.has_value();
        const ObjectNode nameOnly = object;
        const bool isGood = !isBad && checkName(node.name) && resolveValue(node.value, object)
            && (!node.base || resolveBase(node, object));
        if (!isGood) {
            object = nameOnly;
            object.isBad = true;
        }
        const std::uint32_t index = m_forest.add(std::move(object));
        if (!node.isResult()) {
            declareName(node.name, node.base ? SymbolKind::Recursive : SymbolKind::Object, index, !isGood);
            return;
        }
        if (m_resultNode != ObjectNode::none) {
            if (isGood) { // else it has its message already
                report(DiagnosticCode::SecondResult, node.name.range, {lineOf(m_forest[m_resultNode].nameRange)});
            }
            return;
        }
        m_resultNode = index;
    }

    void declare(const UnknownDeclaration &node, bool) { declareName(node.name, SymbolKind::Unknown, 0, true); }

    bool checkName(const Word &name)
    {
        return name.text != "v" || report(DiagnosticCode::ReservedName, name.range, {"this one"});
    }

    /// The first declaration of a name stays; a bad one is silent about itself.
    void declareName(const Word &name, SymbolKind kind, std::uint32_t index, bool isBad)
    {
        const auto [known, isNew] = m_symbols.try_emplace(name.text, Symbol{kind, index, name.range, isBad});
        if (isNew) {
            m_names.push_back(name.text);
        } else if (!isBad) {
            report(DiagnosticCode::Redeclared, name.range, {std::string(name.text), lineOf(known->second.range)});
        }
    }

    std::string lineOf(SourceRange range) const { return std::to_string(m_lines.position(range.begin).line); }

    // ---- Transformations

    bool resolveTransformation(const TransformationDeclaration &node, TransformationEntry &entry)
    {
        entry.parameterCount = node.parameters.size();
        for (std::size_t i = 0; i < node.parameters.size(); ++i) {
            const Word &parameter = node.parameters[i];
            if (parameterIndex(node, parameter.text) < i) {
                return report(DiagnosticCode::RepeatedParameter, parameter.range, {std::string(parameter.text)});
            }
            const auto known = m_symbols.find(parameter.text);
            if (known != m_symbols.end() && known->second.kind == SymbolKind::Vector) {
                report(DiagnosticCode::ParameterHidesVector, parameter.range, {std::string(parameter.text)});
            }
        }
        for (std::size_t i = 0; i < entry.results.size(); ++i) {
            if (!node.results[i]) {
                continue;
            }
            const VectorReference &reference = *node.results[i];
            const std::size_t parameter =
                reference.index ? node.parameters.size() : parameterIndex(node, reference.word.text);
            if (parameter < node.parameters.size()) {
                entry.results[i] = {ResultSource::Kind::Parameter, parameter};
                continue;
            }
            const std::optional<std::size_t> vector = findVector(reference);
            if (!vector) {
                return false;
            }
            entry.results[i] = {ResultSource::Kind::Vector, *vector};
        }
        return true;
    }

    static std::size_t parameterIndex(const TransformationDeclaration &node, std::string_view name)
    {
        std::size_t index = 0;
        while (index < node.parameters.size() && node.parameters[index].text != name) {
            ++index;
        }
        return index;
    }

    /// The index in m_vectors of what a reference names; reports where there is none, and is silent about a bad one.
    std::optional<std::size_t> findVector(const VectorReference &reference)
    {
        const std::string text(reference.word.text);
        if (reference.index) {
            const std::uint64_t number = *reference.index;
            if (number == 0 || number > m_vectors.size()) {
                const std::size_t count = m_vectors.size();
                report(DiagnosticCode::UnknownVectorIndex, reference.word.range,
                       {text,
                        number == 0      ? "vectors are counted from 1"
                            : count == 0 ? "none is declared above"
                            : count == 1 ? "only 1 is declared above"
                                         : std::format("only {} are declared above", count)});
                return std::nullopt;
            }
            return goodVector(number - 1);
        }
        const auto known = m_symbols.find(reference.word.text);
        if (known == m_symbols.end()) {
            report(DiagnosticCode::UnknownVectorName, reference.word.range, {text});
            return std::nullopt;
        }
        Symbol &symbol = known->second;
        symbol.isUsed = true;
        if (symbol.kind == SymbolKind::Unknown) {
            return std::nullopt;
        }
        if (symbol.kind != SymbolKind::Vector) {
            report(DiagnosticCode::UnknownVectorName, reference.word.range, {text});
            return std::nullopt;
        }
        if (symbol.isRepeated) {
            report(DiagnosticCode::RepeatedVectorName, reference.word.range, {text});
            return std::nullopt;
        }
        return goodVector(symbol.index);
    }

    std::optional<std::size_t> goodVector(std::size_t index) const
    {
        return m_vectors[index].isBad ? std::nullopt : std::optional(index);
    }

    // ---- Sets

    /// A symbol of a good declaration of one of two kinds; reports what it is instead, and is silent about a bad one.
    Symbol *find(const Word &name, SymbolKind kind, SymbolKind otherKind, DiagnosticCode mismatch)
    {
        const auto known = m_symbols.find(name.text);
        if (known == m_symbols.end()) {
            report(DiagnosticCode::UnknownName, name.range, {std::string(name.text)});
            return nullptr;
        }
        Symbol &symbol = known->second;
        symbol.isUsed = true;
        if (symbol.kind != kind && symbol.kind != otherKind && symbol.kind != SymbolKind::Unknown) {
            report(mismatch, name.range, {std::string(name.text), described(symbol.kind)});
            return nullptr;
        }
        return symbol.isBad ? nullptr : &symbol;
    }

    bool resolveSet(const SetExpression &expression, SetId &id)
    {
        TransformSet set;
        set.range = expression.range;
        std::unordered_set<AffineMap, AffineMapHash> seen;
        bool isGood = true;
        bool hasRepeats = false;
        for (const TransformationUse &use : expression.uses) {
            const std::optional<AffineMap> map = resolveUse(use);
            if (!map) {
                isGood = false;
                break; // one message a line
            }
            const bool isNew = seen.insert(*map).second;
            if (!isNew && !std::exchange(hasRepeats, true)) {
                const std::string text(m_syntax.text.substr(use.range.begin, use.range.length()));
                report(DiagnosticCode::EqualMaps, use.range, {text});
            }
            if (isNew && *map == AffineMap{}) {
                set.holdsIdentity = true;
            } else if (isNew) {
                set.maps.push_back(*map);
                set.uses.push_back(use.range);
            }
        }
        id = static_cast<SetId>(m_sets.size());
        m_sets.push_back(std::move(set));
        return isGood;
    }

    std::optional<AffineMap> resolveUse(const TransformationUse &use)
    {
        if (use.isIdentity()) {
            return AffineMap{};
        }
        const Symbol *symbol =
            find(use.name, SymbolKind::Transformation, SymbolKind::Transformation, DiagnosticCode::NotATransformation);
        if (!symbol) {
            return std::nullopt;
        }
        const TransformationEntry &entry = m_transformations[symbol->index];
        if (use.arguments.size() != entry.parameterCount) {
            report(DiagnosticCode::WrongArgumentCount, use.range,
                   {std::string(use.name.text), plural(entry.parameterCount, "argument"),
                    std::to_string(use.arguments.size())});
            return std::nullopt;
        }
        std::array<std::size_t, 3> arguments{};
        for (std::size_t i = 0; i < use.arguments.size(); ++i) {
            const std::optional<std::size_t> vector = findVector(use.arguments[i]);
            if (!vector) {
                return std::nullopt;
            }
            arguments[i] = *vector;
        }
        std::array<glm::dvec3, 3> parts = identityParts;
        for (std::size_t i = 0; i < parts.size(); ++i) {
            const ResultSource &source = entry.results[i];
            if (source.kind != ResultSource::Kind::Identity) {
                const bool isVector = source.kind == ResultSource::Kind::Vector;
                parts[i] = m_vectors[isVector ? source.index : arguments[source.index]].value;
            }
        }
        return mapFromParts(parts[0], parts[1], parts[2]);
    }

    // ---- Objects

    bool resolveValue(const Value &value, ObjectNode &object)
    {
        for (const SetExpression &expression : value.sets) {
            if (!resolveSet(expression, object.sets.emplace_back())) {
                return false;
            }
        }
        if (value.isMesh) {
            object.meshPath = value.inner.text;
            object.meshRange = value.inner.range;
            return true;
        }
        const Symbol *symbol =
            find(value.inner, SymbolKind::Object, SymbolKind::Recursive, DiagnosticCode::NotAnObject);
        if (!symbol) {
            return false;
        }
        const std::string name(value.inner.text);
        if (symbol->kind == SymbolKind::Object) {
            object.next = symbol->index;
            return !value.depth || report(DiagnosticCode::NotARecursive, value.inner.range, {name, "an object"});
        }
        if (!value.depth) {
            return report(DiagnosticCode::RecursiveNeedsDepth, value.inner.range, {name});
        }
        object.repeated = symbol->index;
        object.count = *value.depth;
        object.countRange = value.depthRange;
        object.next = m_forest[symbol->index].base;
        return true;
    }

    /// The base must be an object that the body is built on by name.
    bool resolveBase(const ObjectDeclaration &node, ObjectNode &object)
    {
        const Symbol *symbol = find(*node.base, SymbolKind::Object, SymbolKind::Object, DiagnosticCode::NotAnObject);
        if (!symbol) {
            return false;
        }
        object.base = symbol->index;
        const bool isReached = object.next != ObjectNode::none && m_forest.standsOn(object.next, object.base);
        if (!isReached) {
            const std::string chain = object.next == ObjectNode::none ? '"' + std::string(object.meshPath) + '"'
                                                                      : m_forest.chain(object.next);
            const std::string name(node.name.text);
            return report(DiagnosticCode::BaseNotReached, node.base->range,
                          {name, std::string(node.base->text), name + " → " + chain});
        }
        const bool addsLevels = !object.sets.empty()
            || (object.repeated != ObjectNode::none && object.count > 0
                && m_forest[object.repeated].iterationLevels > 0)
            || m_forest[object.next].levels > m_forest[object.base].levels;
        if (!addsLevels) {
            report(DiagnosticCode::EmptyIteration, node.name.range, {std::string(node.name.text)});
        }
        return true;
    }

    // ---- The result

    /// In a text with errors nobody knows what the bad lines use.
    void hintAtUnused()
    {
        if (hasErrors(m_result.diagnostics)) {
            return;
        }
        for (const std::string_view name : m_names) {
            const Symbol &symbol = m_symbols.at(name);
            const bool isNumbered = symbol.kind == SymbolKind::Vector;
            if (!symbol.isUsed && !symbol.isBad && !isNumbered) {
                report(DiagnosticCode::Unused, symbol.range, {std::string(name)});
            }
        }
    }

    void describeResult()
    {
        if (m_resultNode == ObjectNode::none) {
            const bool isText =
                m_syntax.diagnostics.empty() || m_syntax.diagnostics.front().code != DiagnosticCode::NotUtf8;
            if (isText) {
                report(DiagnosticCode::NoResult, {m_syntax.text.size(), m_syntax.text.size()});
            }
            return;
        }
        if (m_forest[m_resultNode].isBad) {
            return;
        }
        const std::optional<FractalDescription::Depth> depth = sliderDepth();
        if (m_forest[m_resultNode].levels == std::numeric_limits<Position>::max()) {
            report(DiagnosticCode::TooManyLevels, depth ? depth->range : m_forest[m_resultNode].nameRange);
            return;
        }
        LevelSequence::Builder builder;
        m_forest.writeLevels(m_resultNode, builder);
        const ObjectNode &mesh = m_forest.mesh(m_resultNode);
        m_result.description = FractalDescription{std::string(mesh.meshPath), mesh.meshRange, std::move(m_sets),
                                                  std::move(builder).build(), depth};
    }

    std::optional<FractalDescription::Depth> sliderDepth() const
    {
        for (std::uint32_t at = m_resultNode; at != ObjectNode::none; at = m_forest[at].next) {
            if (m_forest[at].repeated != ObjectNode::none) {
                return FractalDescription::Depth{m_forest[at].count, m_forest[at].countRange};
            }
        }
        return std::nullopt;
    }

    const FdoSyntax &m_syntax;
    LineMap m_lines;
    FdoResult m_result;
    std::unordered_map<std::string_view, Symbol> m_symbols;
    std::vector<std::string_view> m_names;
    std::vector<VectorEntry> m_vectors;
    std::vector<TransformationEntry> m_transformations;
    std::vector<TransformSet> m_sets;
    ObjectForest m_forest;
    std::uint32_t m_resultNode = ObjectNode::none;
};

}

FdoResult resolveFdo(const FdoSyntax &syntax)
{
    return Resolver(syntax).resolve();
}

FdoResult readFdo(std::string_view text)
{
    return resolveFdo(parseFdo(text));
}

}
