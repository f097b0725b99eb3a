// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <variant>
#include <vector>

#include <glm/vec3.hpp>

#include "core/text/diagnostic.h"
#include "core/text/sourcerange.h"

namespace romanesco {

/// The syntax of one .fdo text, a node for each declaration. Names are views of the text, which must outlive them.
/// A bad declaration keeps what could be read of it: its name stays declared, and a bad vector keeps its number.

/// A name where it stands.
struct Word {
    std::string_view text;
    SourceRange range;
};

/// A vector by number (from 1) or by name; in a transformation's results also a parameter by name.
struct VectorReference {
    Word word;
    std::optional<std::uint64_t> index;
};

/// v 1 1 -2
struct VectorDeclaration {
    Word name;
    glm::dvec3 value{0.0};
};

/// t.a. (a, #, 5); an empty result is `#`, the identity of its place.
struct TransformationDeclaration {
    Word name;
    std::vector<Word> parameters;
    std::array<std::optional<VectorReference>, 3> results;
};

/// u.6.10, or `#`, whose name is empty.
struct TransformationUse {
    Word name;
    std::vector<VectorReference> arguments;
    SourceRange range;

    [[nodiscard]] bool isIdentity() const { return name.text.empty(); }
};

struct SetExpression {
    std::vector<TransformationUse> uses;
    SourceRange range;
};

/// Sets, outermost first, round a mesh, an object, or a recursive with a depth.
struct Value {
    std::vector<SetExpression> sets;
    /// The path without its quotes where isMesh, else a name.
    Word inner;
    bool isMesh = false;
    std::optional<std::uint64_t> depth;
    SourceRange depthRange;
};

/// x. "base.obj"     z<x>. [#, u.6.10] y     <$>. z 6
struct ObjectDeclaration {
    /// Empty for the result <$>; its range is there all the same.
    Word name;
    std::optional<Word> base = std::nullopt;
    Value value = {};

    [[nodiscard]] bool isResult() const { return name.text.empty(); }
};

/// A line of which only the name could be read.
struct UnknownDeclaration {
    Word name;
};

struct Declaration {
    std::variant<VectorDeclaration, TransformationDeclaration, ObjectDeclaration, UnknownDeclaration> node;
    /// Has its one error already: nothing more is said about it, and nothing about uses of its name.
    bool isBad = false;
};

struct FdoSyntax {
    std::string_view text;
    std::vector<Declaration> declarations;
    Diagnostics diagnostics;
};

}
