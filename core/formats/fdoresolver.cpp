// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "fdomodel.h"

#include <algorithm>
#include <format>
#include <limits>
#include <utility>

#include "core/text/places.h"
#include "core/text/spelling.h"

namespace romanesco {

namespace {

std::string plural(std::size_t count, const char *noun)
{
    return std::format("{} {}{}", count, noun, count == 1 ? "" : "s");
}

/// In a text with more to put right nobody looks on for what each word was to be.
constexpr std::size_t mostLooksForNames = 100'000;
constexpr std::size_t longestCompared = 40;

class Resolver
{
public:
    explicit Resolver(const FdoSyntax &syntax)
        : m_syntax(syntax)
    {
        m_model.diagnostics = syntax.diagnostics();
        m_hasText = m_model.diagnostics.empty() || m_model.diagnostics.front().code != DiagnosticCode::NotUtf8;
        m_model.symbols.resize(syntax.names().size());
    }

    FdoModel resolve()
    {
        for (std::size_t i = 0; i < m_syntax.lineCount(); ++i) {
            m_line = static_cast<std::uint32_t>(i);
            m_isTold = false;
            const FdoLine &line = m_syntax.line(i);
            std::visit([&](const auto &node) { declare(node, line.isBad); }, line.declaration);
        }
        hintAtUnused();
        lookForResult();
        sortByPlace(m_model.diagnostics);
        return std::move(m_model);
    }

private:
    Diagnostic &reportInText(DiagnosticCode code, SourceRange range, std::vector<std::string> arguments = {})
    {
        return m_model.diagnostics.emplace_back(code, range, std::move(arguments));
    }

    /// In the line that is looked at.
    Diagnostic &report(DiagnosticCode code, LineRange range, std::vector<std::string> arguments = {})
    {
        m_isTold = m_isTold || severity(code) == Severity::Error;
        return reportInText(code, inText(range), std::move(arguments));
    }

    /// Whether all are good. One error a line is told: after it the rest is left alone, but what is silently bad does not
    /// hide what follows.
    template<typename List, typename IsGood>
    bool areGood(const List &list, IsGood isGood)
    {
        bool all = true;
        for (const auto &entry : list) {
            all = isGood(entry) && all;
            if (m_isTold) {
                return false;
            }
        }
        return all;
    }

    [[nodiscard]] SourceRange inText(LineRange range) const { return m_syntax.range(m_line, range); }

    /// The name in the line that declares it, as another place of a diagnostic.
    [[nodiscard]] Note declaredHere(std::uint32_t line)
    {
        const Word &name = nameIn(line);
        const SourceRange range = m_syntax.range(line, name.range);
        const std::string words(m_syntax.words(line, name.range));
        return {DiagnosticCode::DeclaredHere, range, {words}, {}, m_places.at(range.begin)};
    }

    [[nodiscard]] const Word &nameIn(std::uint32_t line) const
    {
        static const Word nothing;
        return std::visit(
            [](const auto &node) -> const Word & {
                if constexpr (requires { node.name; }) {
                    return node.name;
                } else {
                    return nothing;
                }
            },
            m_syntax.line(line).declaration);
    }

    // ---- Declarations

    void declare(std::monostate, bool) { }

    void declare(const VectorDeclaration &vector, bool isBad)
    {
        const auto index = static_cast<std::uint32_t>(m_model.vectors.size());
        m_model.vectors.push_back({vector.value, m_line, isBad});
        m_usedVectors.push_back(false);
        if (vector.name.name == m_syntax.plainVector() || vector.name.name == NameTable::nameless) {
            return;
        }
        Symbol &known = m_model.symbols[vector.name.name];
        if (known.kind != SymbolKind::Vector) {
            declareName(vector.name, SymbolKind::Vector, index, isBad);
        } else if (known.repeatLine == Symbol::never) {
            known.repeatLine = m_line;
        }
    }

    void declare(const TransformationDeclaration &node, bool isBad)
    {
        TransformationEntry entry;
        entry.line = m_line;
        const bool isGood = !isBad && checkName(node.name) && resolveTransformation(node, entry);
        m_model.transformations.push_back(entry);
        declareName(node.name, SymbolKind::Transformation,
                    static_cast<std::uint32_t>(m_model.transformations.size()) - 1, !isGood);
    }

    void declare(const ObjectDeclaration &node, bool isBad)
    {
        ObjectNode object;
        object.name = node.name.name;
        object.line = m_line;
        object.isRecursive = node.base.has_value();
        object.firstSet = static_cast<SetId>(m_model.sets.size());
        const ObjectNode nameOnly = object;
        const bool isGood = !isBad && checkName(node.name) && resolveValue(node.value, object)
            && (!node.base || resolveBase(node, object));
        if (!isGood) {
            object = nameOnly;
            object.endSet = object.firstSet;
            object.isBad = true;
        }
        const std::uint32_t index = m_model.forest.add(object);
        if (!node.isResult()) {
            declareName(node.name, node.base ? SymbolKind::Recursive : SymbolKind::Object, index, !isGood);
        } else if (m_model.result == ObjectNode::none) {
            m_model.result = index;
        } else if (isGood) { // else it has its message already
            const std::uint32_t first = m_model.forest[m_model.result].line;
            report(DiagnosticCode::SecondResult, node.name.range, {lineNumber(first)})
                .notes.push_back(declaredHere(first));
        }
    }

    void declare(const UnknownDeclaration &node, bool) { declareName(node.name, SymbolKind::Unknown, 0, true); }

    bool checkName(const Word &name)
    {
        if (name.name == m_syntax.plainVector()) {
            report(DiagnosticCode::ReservedName, name.range, {"this one"});
            return false;
        }
        return true;
    }

    /// The first declaration of a name stays; a bad one is silent about itself.
    void declareName(const Word &name, SymbolKind kind, std::uint32_t index, bool isBad)
    {
        Symbol &symbol = m_model.symbols[name.name];
        if (symbol.kind == SymbolKind::Undeclared) {
            symbol = {.kind = kind, .isBad = isBad, .line = m_line, .index = index};
        } else if (!isBad) {
            report(DiagnosticCode::Redeclared, name.range, {m_syntax.name(name), lineNumber(symbol.line)})
                .notes.push_back(declaredHere(symbol.line));
        }
    }

    static std::string lineNumber(std::uint32_t line) { return std::to_string(std::uint64_t{line} + 1); }

    // ---- Transformations

    bool resolveTransformation(const TransformationDeclaration &node, TransformationEntry &entry)
    {
        entry.parameterCount = static_cast<std::uint32_t>(node.parameters.size());
        for (std::size_t i = 0; i < node.parameters.size(); ++i) {
            const Word &parameter = node.parameters[i];
            if (parameterIndex(node, parameter.name) < i) {
                report(DiagnosticCode::RepeatedParameter, parameter.range, {m_syntax.name(parameter)});
                return false;
            }
            const Symbol &known = m_model.symbols[parameter.name];
            if (known.kind == SymbolKind::Vector) {
                report(DiagnosticCode::ParameterHidesVector, parameter.range, {m_syntax.name(parameter)})
                    .notes.push_back(declaredHere(known.line));
            }
        }
        PartSource *part = entry.parts.data();
        return areGood(node.results, [&](const std::optional<VectorReference> &result) {
            PartSource &source = *part++;
            return !result || resolvePart(node, *result, source);
        });
    }

    bool resolvePart(const TransformationDeclaration &node, const VectorReference &reference, PartSource &part)
    {
        const std::size_t parameter =
            reference.number ? node.parameters.size() : parameterIndex(node, reference.word.name);
        if (parameter < node.parameters.size()) {
            part = {PartSource::Kind::Parameter, static_cast<std::uint32_t>(parameter)};
            return true;
        }
        part.kind = PartSource::Kind::Vector;
        return findVector(reference, part.index);
    }

    static std::size_t parameterIndex(const TransformationDeclaration &node, NameId name)
    {
        std::size_t index = 0;
        while (index < node.parameters.size() && node.parameters[index].name != name) {
            ++index;
        }
        return index;
    }

    /// The index of the vector that a reference names; reports where there is none, and is silent about a bad one.
    bool findVector(const VectorReference &reference, std::uint32_t &index)
    {
        if (reference.number) {
            const std::uint32_t number = *reference.number;
            if (number == 0 || number > m_model.vectors.size()) {
                reportNumber(reference);
                return false;
            }
            index = number - 1;
            m_usedVectors[index] = true;
            return !m_model.vectors[index].isBad;
        }
        Symbol &symbol = m_model.symbols[reference.word.name];
        symbol.isUsed = true;
        if (symbol.kind == SymbolKind::Unknown || (symbol.isBad && symbol.kind != SymbolKind::Vector)) {
            return false;
        }
        if (symbol.kind != SymbolKind::Vector) {
            Diagnostic &unknown =
                report(DiagnosticCode::UnknownVectorName, reference.word.range, {m_syntax.name(reference.word)});
            if (symbol.kind != SymbolKind::Undeclared) {
                unknown.notes.push_back(declaredHere(symbol.line));
            }
            suggest(unknown, reference.word, SymbolKind::Vector, SymbolKind::Vector);
            return false;
        }
        if (symbol.repeatLine != Symbol::never) {
            Diagnostic &repeated =
                report(DiagnosticCode::RepeatedVectorName, reference.word.range, {m_syntax.name(reference.word)});
            repeated.notes.push_back(declaredHere(symbol.line));
            repeated.notes.push_back(declaredHere(symbol.repeatLine));
            return false;
        }
        index = symbol.index;
        return !m_model.vectors[index].isBad;
    }

    /// The name of one of two kinds, declared above, that a word is most like, where it is like one.
    void suggest(Diagnostic &diagnostic, const Word &word, SymbolKind kind, SymbolKind otherKind)
    {
        const std::string_view written = m_syntax.names()[word.name];
        std::size_t fewest = mostSlips(written) + 1;
        NameId best = NameTable::nameless;
        for (NameId id = 0; id < m_model.symbols.size() && m_looksForNames > 0; ++id, --m_looksForNames) {
            const Symbol &symbol = m_model.symbols[id];
            const std::string_view name = m_syntax.names()[id];
            const std::size_t lengths = std::max(name.size(), written.size()) - std::min(name.size(), written.size());
            if ((symbol.kind != kind && symbol.kind != otherKind) || lengths >= fewest
                || name.size() > longestCompared) {
                continue;
            }
            if (const std::size_t slips = slipsBetween(name, written); slips < fewest) {
                fewest = slips;
                best = id;
            }
        }
        if (best != NameTable::nameless) {
            const std::string name(m_syntax.names()[best]);
            diagnostic.fix = replacement(std::format("Write {}", name), inText(word.range), name);
        }
    }

    void reportNumber(const VectorReference &reference)
    {
        const std::size_t count = m_model.vectors.size();
        const std::string text(m_syntax.words(m_line, reference.word.range));
        report(DiagnosticCode::UnknownVectorIndex, reference.word.range,
               {text,
                *reference.number == 0 ? "vectors are counted from 1"
                    : count == 0       ? "none is declared above"
                    : count == 1       ? "only 1 is declared above"
                                       : std::format("only {} are declared above", count)});
    }

    // ---- Values

    /// The symbol of a good declaration of one of two kinds; reports what it is instead, and is silent about a bad one.
    const Symbol *find(const Word &name, SymbolKind kind, SymbolKind otherKind, DiagnosticCode mismatch)
    {
        Symbol &symbol = m_model.symbols[name.name];
        symbol.isUsed = true;
        if (symbol.kind == SymbolKind::Undeclared) {
            suggest(report(DiagnosticCode::UnknownName, name.range, {m_syntax.name(name)}), name, kind, otherKind);
            return nullptr;
        }
        if (symbol.isBad) { // what was meant is a guess
            return nullptr;
        }
        if (symbol.kind != kind && symbol.kind != otherKind) {
            report(mismatch, name.range, {m_syntax.name(name), described(symbol.kind)})
                .notes.push_back(declaredHere(symbol.line));
            return nullptr;
        }
        return &symbol;
    }

    /// One message a line: the first wrong use ends it.
    bool checkUse(const TransformationUse &use)
    {
        if (use.isIdentity()) {
            return true;
        }
        const Symbol *symbol =
            find(use.name, SymbolKind::Transformation, SymbolKind::Transformation, DiagnosticCode::NotATransformation);
        if (!symbol) {
            return false;
        }
        const TransformationEntry &entry = m_model.transformations[symbol->index];
        if (use.arguments.size() != entry.parameterCount) {
            report(DiagnosticCode::WrongArgumentCount, use.range,
                   {m_syntax.name(use.name), plural(entry.parameterCount, "argument"),
                    std::to_string(use.arguments.size())})
                .notes.push_back(declaredHere(entry.line));
            return false;
        }
        std::uint32_t vector = 0;
        return areGood(use.arguments, [&](const VectorReference &argument) { return findVector(argument, vector); });
    }

    bool resolveValue(const Value &value, ObjectNode &object)
    {
        std::uint32_t index = 0;
        const bool areSetsGood = areGood(value.sets, [&](const SetExpression &set) {
            m_model.sets.push_back({m_line, index++});
            return areGood(set.uses, [&](const TransformationUse &use) { return checkUse(use); });
        });
        if (m_isTold) {
            return false;
        }
        object.endSet = static_cast<SetId>(m_model.sets.size());
        object.isMesh = value.isMesh;
        return (value.isMesh || resolveInner(value, object)) && areSetsGood;
    }

    bool resolveInner(const Value &value, ObjectNode &object)
    {
        const Symbol *symbol =
            find(value.inner, SymbolKind::Object, SymbolKind::Recursive, DiagnosticCode::NotAnObject);
        if (!symbol) {
            return false;
        }
        const SourceRange place = inText(value.inner.range);
        if (symbol->kind == SymbolKind::Object) {
            object.next = symbol->index;
            if (value.depth) {
                report(DiagnosticCode::NotARecursive, value.inner.range, {m_syntax.name(value.inner), "an object"})
                    .fix = replacement("Remove the depth", {place.end, inText(value.depthRange).end}, "");
            }
            return !value.depth;
        }
        if (!value.depth) {
            report(DiagnosticCode::RecursiveNeedsDepth, value.inner.range, {m_syntax.name(value.inner)}).fix =
                insertion("Give it a depth of 6", place.end, " 6");
            return false;
        }
        object.repeated = symbol->index;
        object.count = *value.depth;
        object.next = m_model.forest[symbol->index].base;
        return true;
    }

    /// The base must be an object that the body is built on by name.
    bool resolveBase(const ObjectDeclaration &node, ObjectNode &object)
    {
        const Symbol *symbol = find(*node.base, SymbolKind::Object, SymbolKind::Object, DiagnosticCode::NotAnObject);
        if (!symbol) {
            return false;
        }
        const ObjectForest &forest = m_model.forest;
        object.base = symbol->index;
        if (object.next == ObjectNode::none || !forest.standsOn(object.next, object.base)) {
            const std::string name = m_syntax.name(node.name);
            std::string chain = shortened(name);
            std::uint32_t last = object.line;
            if (object.next != ObjectNode::none) {
                chain += " → " + forest.chain(object.next, m_syntax.names());
                last = forest[forest.meshNode(object.next)].line;
            }
            const auto &mesh = std::get<ObjectDeclaration>(m_syntax.line(last).declaration).value.inner;
            chain += " → " + shortened(m_syntax.words(last, mesh.range));
            report(DiagnosticCode::BaseNotReached, node.base->range, {name, m_syntax.name(*node.base), chain})
                .notes.push_back(declaredHere(symbol->line));
            return false;
        }
        const bool addsLevels = object.firstSet < object.endSet
            || (object.repeated != ObjectNode::none && object.count > 0 && forest[object.repeated].iterationLevels > 0)
            || forest[object.next].levels > forest[object.base].levels;
        if (!addsLevels) {
            report(DiagnosticCode::EmptyIteration, node.name.range, {m_syntax.name(node.name)});
        }
        return true;
    }

    // ---- The whole

    /// In a text with errors nobody knows what the bad lines use.
    void hintAtUnused()
    {
        if (hasErrors(m_model.diagnostics)) {
            return;
        }
        for (const Symbol &symbol : m_model.symbols) {
            const bool isNumbered = symbol.kind == SymbolKind::Vector && m_usedVectors[symbol.index];
            if (symbol.kind != SymbolKind::Undeclared && !symbol.isUsed && !symbol.isBad && !isNumbered) {
                const Word &name = nameIn(symbol.line);
                reportInText(DiagnosticCode::Unused, m_syntax.range(symbol.line, name.range), {m_syntax.name(name)});
            }
        }
    }

    void lookForResult()
    {
        const std::size_t end = m_syntax.text().size();
        if (m_model.result == ObjectNode::none) {
            if (m_hasText) {
                reportInText(DiagnosticCode::NoResult, {end, end}).fix = resultOfLast();
            }
            return;
        }
        const ObjectNode &result = m_model.forest[m_model.result];
        if (!result.isBad && result.levels == std::numeric_limits<Position>::max()) {
            const std::uint32_t line = m_model.depthLine().value_or(result.line);
            const Value &value = std::get<ObjectDeclaration>(m_syntax.line(line).declaration).value;
            reportInText(DiagnosticCode::TooManyLevels, m_syntax.range(line, value.depthRange));
            m_model.result = ObjectNode::none;
        }
    }

    /// A line that makes the last good object or recursive the result.
    [[nodiscard]] std::optional<Fix> resultOfLast() const
    {
        for (std::uint32_t i = m_model.forest.size(); i-- > 0;) {
            const ObjectNode &node = m_model.forest[i];
            if (!node.isBad) {
                const std::string name(m_syntax.names()[node.name]);
                const std::string line = std::format("<$>. {}{}", name, node.isRecursive ? " 6" : "");
                const std::string &text = m_syntax.text();
                const bool isAtStart = text.empty() || text.back() == '\n' || text.back() == '\r';
                return insertion(std::format("Make {} the result", name), text.size(),
                                 (isAtStart ? "" : "\n") + line + '\n');
            }
        }
        return std::nullopt;
    }

    const FdoSyntax &m_syntax;
    Places m_places{m_syntax.map()};
    FdoModel m_model;
    bool m_hasText = true;
    /// By number, beside the model's vectors.
    std::vector<bool> m_usedVectors;
    std::uint32_t m_line = 0;
    /// Whether an error of this line was reported.
    bool m_isTold = false;
    std::size_t m_looksForNames = mostLooksForNames;
};

}

FdoModel resolveFdo(const FdoSyntax &syntax)
{
    return Resolver(syntax).resolve();
}

}
