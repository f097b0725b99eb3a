// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "core/formats/fdosyntax.h"

namespace romanesco {

/// What a word of a line stands there for.
enum class WordRole {
    VectorName,         ///< half 0.5 0.5 0.5
    TransformationName, ///< t.a. (a, #, 5)
    ParameterName,      ///< its first a
    Part,               ///< its second a, its 5
    ObjectName,         ///< of a recursive too
    ResultName,         ///< <$>
    UnknownName,        ///< of a line of which only the name could be read
    BaseName,           ///< z<x>. …: the x
    UseName,            ///< [u.6.10]: the u
    Argument,           ///< its 6 and 10
    InnerName,          ///< what the sets stand round: the z of z 6
    Depth,              ///< its 6
    Path,               ///< "base.obj", with its quotes, or what there is of it where the second is missing
};

struct LineWord {
    WordRole role;
    Word word;
    /// Of a vector that is referred to by number.
    std::optional<std::uint32_t> number = std::nullopt;
    /// Which of the line's parameters a ParameterName is.
    std::uint32_t parameter = 0;
};

/// Calls visit(LineWord) for each word of a line that was read, in the order of the text. Of bad lines it is those
/// before the error.
template<typename Visit>
class FdoWords
{
public:
    explicit FdoWords(Visit visit)
        : m_visit(visit)
    {
    }

    void operator()(std::monostate) { }
    void operator()(const VectorDeclaration &node) { m_visit({WordRole::VectorName, node.name}); }
    void operator()(const UnknownDeclaration &node) { m_visit({WordRole::UnknownName, node.name}); }

    void operator()(const TransformationDeclaration &node)
    {
        m_visit({WordRole::TransformationName, node.name});
        for (std::uint32_t i = 0; i < node.parameters.size(); ++i) {
            m_visit({WordRole::ParameterName, node.parameters[i], std::nullopt, i});
        }
        for (const std::optional<VectorReference> &part : node.results) {
            if (part) {
                m_visit({WordRole::Part, part->word, part->number});
            }
        }
    }

    void operator()(const ObjectDeclaration &node)
    {
        m_visit({node.isResult() ? WordRole::ResultName : WordRole::ObjectName, node.name});
        if (node.base && node.base->name != NameTable::nameless) {
            m_visit({WordRole::BaseName, *node.base});
        }
        for (const SetExpression &set : node.value.sets) {
            for (const TransformationUse &use : set.uses) {
                visitUse(use);
            }
        }
        visitInner(node.value);
    }

private:
    void visitUse(const TransformationUse &use)
    {
        if (use.isIdentity()) {
            return;
        }
        m_visit({WordRole::UseName, use.name});
        for (const VectorReference &argument : use.arguments) {
            m_visit({WordRole::Argument, argument.word, argument.number});
        }
    }

    void visitInner(const Value &value)
    {
        if (value.isMesh) {
            m_visit({WordRole::Path, value.inner});
        } else if (value.inner.name != NameTable::nameless) {
            m_visit({WordRole::InnerName, value.inner});
        }
        if (value.depth) {
            m_visit({WordRole::Depth, {NameTable::nameless, value.depthRange}});
        }
    }

    Visit m_visit;
};

template<typename Visit>
void forEachWord(const FdoLine &line, Visit visit)
{
    std::visit(FdoWords<Visit>(visit), line.declaration);
}

}
