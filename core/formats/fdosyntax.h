// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include <boost/container/static_vector.hpp>
#include <glm/vec3.hpp>

#include "core/text/nametable.h"
#include "parsedlines.h"

namespace romanesco {

/// The syntax of one .fdo text, a node for each declaration. All ranges count from the start of the line.
/// A bad declaration keeps what could be read of it: its name stays declared, and a bad vector keeps its number.

/// A name where it stands.
struct Word {
    NameId name = NameTable::nameless;
    LineRange range;
};

/// A vector by number (from 1) or by name; in a transformation's results also a parameter by name.
struct VectorReference {
    Word word;
    /// A number that no vector can have is held at the greatest value.
    std::optional<std::uint32_t> number;
};

/// v 1 1 -2
struct VectorDeclaration {
    Word name;
    glm::dvec3 value{0.0};
};

constexpr std::size_t mostParameters = 3;

/// t.a. (a, #, 5); an empty result is `#`, the identity of its place.
struct TransformationDeclaration {
    Word name;
    boost::container::static_vector<Word, mostParameters> parameters;
    std::array<std::optional<VectorReference>, 3> results;
};

/// u.6.10, or `#`, which is nameless.
struct TransformationUse {
    Word name;
    boost::container::static_vector<VectorReference, mostParameters> arguments;
    LineRange range;

    [[nodiscard]] bool isIdentity() const { return name.name == NameTable::nameless; }
};

struct SetExpression {
    std::vector<TransformationUse> uses;
    LineRange range;
};

/// Sets, outermost first, round a mesh, an object, or a recursive with a depth.
struct Value {
    std::vector<SetExpression> sets;
    /// A name; or nameless and the range of a path, with its quotes, where isMesh.
    Word inner;
    bool isMesh = false;
    std::optional<std::uint64_t> depth;
    LineRange depthRange;
};

/// x. "base.obj"     z<x>. [#, u.6.10] y     <$>. z 6
struct ObjectDeclaration {
    /// Nameless for the result <$>; its range is there all the same.
    Word name;
    std::optional<Word> base = std::nullopt;
    Value value = {};

    [[nodiscard]] bool isResult() const { return name.name == NameTable::nameless; }
};

/// A line of which only the name could be read.
struct UnknownDeclaration {
    Word name;
};

/// One line: a declaration, or nothing but a comment or blanks.
struct FdoLine {
    std::variant<std::monostate, VectorDeclaration, TransformationDeclaration, ObjectDeclaration, UnknownDeclaration>
        declaration;
    /// Has its one error already: nothing more is said about it, and nothing about uses of its name.
    bool isBad = false;
    Diagnostics diagnostics;
};

/// Reads one line without its end mark; its first bytes, so many, are passed over. Cost linear in the line.
[[nodiscard]] FdoLine parseFdoLine(std::string_view line, std::size_t skipped, NameTable &names);

/// A whole text, read line by line: a bad line gets one error, and reading goes on at the next.
class FdoSyntax : public ParsedLines<FdoLine>
{
public:
    FdoSyntax() = default;
    explicit FdoSyntax(std::string text) { setText(std::move(text)); }

    /// Another text; lines that it shares with the last one, before and after what differs, are kept.
    void setText(std::string text);

    [[nodiscard]] const NameTable &names() const { return m_names; }
    /// The number of the name `v`, which vectors without a name of their own have.
    [[nodiscard]] NameId plainVector() const { return m_plainVector; }
    [[nodiscard]] std::string name(const Word &word) const { return std::string(m_names[word.name]); }

private:
    NameTable m_names;
    NameId m_plainVector = m_names.idOf("v");
};

}
