// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include <algorithm>
#include <format>

#include "completionlist.h"
#include "fdoplace.h"
#include "plainwords.h"

namespace romanesco {

namespace {

using Kind = FdoPlace::Kind;

class FdoCompleter
{
public:
    FdoCompleter(const FdoDocument &document, std::size_t line, FdoPlace place)
        : m_syntax(document.syntax)
        , m_model(document.model)
        , m_line(line)
        , m_place(std::move(place))
        , m_list(document.syntax.text(), document.syntax.range(line, m_place.begun), m_place.kind == Kind::MeshPath)
    {
    }

    std::vector<Completion> complete(const FileNames &files)
    {
        switch (m_place.kind) {
        case Kind::Nothing:
            break;
        case Kind::LineStart:
            addLineStarts();
            break;
        case Kind::Part:
            addParts();
            break;
        case Kind::Value:
            addObjects();
            [[fallthrough]];
        case Kind::MeshPath:
            if (m_place.base.empty()) { // the body of a recursive stands on its base, not on a mesh
                m_list.addFiles(files, ".obj");
            }
            break;
        case Kind::BaseName:
            addObjects();
            break;
        case Kind::UseName:
            addTransformations();
            addIdentity();
            break;
        case Kind::Argument:
            addArguments();
            break;
        }
        return m_list.take();
    }

private:
    [[nodiscard]] std::string_view nameOf(const Word &word) const { return m_syntax.names()[word.name]; }

    /// Of entries that ascend by their lines, how many are declared above.
    template<typename Entry>
    [[nodiscard]] std::size_t above(const std::vector<Entry> &entries) const
    {
        const auto at = std::ranges::lower_bound(entries, m_line, {}, &Entry::line);
        return static_cast<std::size_t>(at - entries.begin());
    }

    void addIdentity() { m_list.add("#", "the identity", "#", CompletionKind::Identity); }

    void addLineStarts()
    {
        bool hasResult = false;
        for (std::uint32_t i = 0; i < m_model.forest.size() && !hasResult; ++i) {
            hasResult = m_model.forest[i].name == NameTable::nameless && m_model.forest[i].line != m_line;
        }
        m_list.add("v", "a vector", "v", " ", CompletionKind::Keyword);
        if (!hasResult) {
            const bool isDotted = m_list.following().starts_with('.');
            m_list.add("<$>.", "the result", isDotted ? "<$>" : "<$>. ", CompletionKind::Keyword);
        }
    }

    void addParts()
    {
        for (const std::string_view parameter : m_place.parameters) {
            m_list.add(std::string(parameter), "a parameter", parameter, CompletionKind::Parameter);
        }
        addIdentity();
        addVectors();
    }

    /// Numbers, and before each the name by which the vector can be meant as well.
    void addVectors()
    {
        for (std::size_t i = above(m_model.vectors); i-- > 0 && !m_list.isFull();) {
            const VectorEntry &vector = m_model.vectors[i];
            const Word &name = std::get<VectorDeclaration>(m_syntax.line(vector.line).declaration).name;
            if (isMeant(name, i)) {
                addVector(nameOf(name), vector);
            }
            addVector(std::to_string(i + 1), vector);
        }
    }

    void addVector(std::string_view words, const VectorEntry &vector)
    {
        if (m_list.wants(words)) {
            m_list.add(std::string(words), vector.isBad ? std::string() : plainWords(vector.value), words,
                       CompletionKind::Vector);
        }
    }

    /// Whether the name alone means this vector.
    [[nodiscard]] bool isMeant(const Word &name, std::size_t index) const
    {
        const Symbol *symbol = m_model.find(name.name, m_line);
        return symbol && symbol->kind == SymbolKind::Vector && symbol->index == index && symbol->repeatLine >= m_line
            && !std::ranges::contains(m_place.parameters, nameOf(name));
    }

    void addTransformations()
    {
        for (std::size_t i = above(m_model.transformations); i-- > 0 && !m_list.isFull();) {
            const std::uint32_t line = m_model.transformations[i].line;
            const auto &node = std::get<TransformationDeclaration>(m_syntax.line(line).declaration);
            if (isReachable(node.name, line)) {
                std::string parameters;
                for (const Word &parameter : node.parameters) {
                    parameters += (parameters.empty() ? "" : ", ") + std::string(nameOf(parameter));
                }
                const std::string_view name = nameOf(node.name);
                m_list.add(std::string(name), parameters, name, parameters.empty() ? "" : ".",
                           CompletionKind::Transformation);
            }
        }
    }

    /// Whether a name means the declaration in a line.
    [[nodiscard]] bool isReachable(const Word &name, std::uint32_t line) const
    {
        const Symbol *symbol = m_model.find(name.name, m_line);
        return symbol && symbol->line == line && name.name != m_syntax.plainVector();
    }

    /// As many as the transformation takes; of one that is bad or unknown nobody knows how many.
    void addArguments()
    {
        const std::optional<NameId> name = m_syntax.names().find(m_place.transformation);
        const Symbol *symbol = name ? m_model.find(*name, m_line) : nullptr;
        const bool isKnown = symbol && symbol->kind == SymbolKind::Transformation && !symbol->isBad;
        if (m_place.argument < (isKnown ? m_model.transformations[symbol->index].parameterCount : mostParameters)) {
            addVectors();
        }
    }

    void addObjects()
    {
        const ObjectForest &forest = m_model.forest;
        const std::optional<std::uint32_t> base = baseNode();
        std::uint32_t i = forest.size();
        while (i > 0 && forest[i - 1].line >= m_line) {
            --i;
        }
        while (i-- > 0 && !m_list.isFull()) {
            const ObjectNode &node = forest[i];
            const bool isMeant = node.name != NameTable::nameless && isReachable({node.name, {}}, node.line);
            if (isMeant && (!base || standsOn(i, *base))) {
                addObject(node);
            }
        }
    }

    /// A recursive is asked for with a depth, which stands on its base.
    [[nodiscard]] bool standsOn(std::uint32_t index, std::uint32_t below) const
    {
        const ObjectNode &node = m_model.forest[index];
        return !node.isBad && m_model.forest.standsOn(node.isRecursive ? node.base : index, below);
    }

    /// The base of the recursive whose body is asked for; nothing where any object will do.
    [[nodiscard]] std::optional<std::uint32_t> baseNode() const
    {
        const std::optional<NameId> name = m_place.base.empty() ? std::nullopt : m_syntax.names().find(m_place.base);
        const Symbol *symbol = name ? m_model.find(*name, m_line) : nullptr;
        return symbol && symbol->kind == SymbolKind::Object ? std::optional(symbol->index) : std::nullopt;
    }

    void addObject(const ObjectNode &node)
    {
        const std::string_view name = m_syntax.names()[node.name];
        if (!node.isRecursive) {
            m_list.add(std::string(name), "an object", name, CompletionKind::Object);
        } else if (m_place.kind == Kind::Value) {
            const std::string_view next = m_list.following();
            const bool hasDepth = !next.empty() && next[0] >= '0' && next[0] <= '9';
            const std::string detail =
                node.isBad ? "a recursive" : std::format("around {}", m_syntax.names()[m_model.forest[node.base].name]);
            m_list.add(std::string(name), detail, hasDepth ? std::string(name) : std::format("{} 6", name),
                       CompletionKind::Recursive);
        }
    }

    const FdoSyntax &m_syntax;
    const FdoModel &m_model;
    std::size_t m_line;
    FdoPlace m_place;
    CompletionList m_list;
};

}

std::vector<Completion> complete(const FdoDocument &document, std::size_t offset, const FileNames &files)
{
    const LineMap &map = document.syntax.map();
    const std::size_t line = map.lineAt(offset);
    if (line >= document.syntax.lineCount() || offset > map.line(line).end) {
        return {};
    }
    const std::string_view text = map.lineText(line).substr(0, offset - map.start(line));
    return FdoCompleter(document, line, fdoPlace(text, document.syntax.skipped(line))).complete(files);
}

}
