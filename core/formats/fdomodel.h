// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "core/geometry/affinemap.h"
#include "core/text/diagnostic.h"
#include "fdosyntax.h"
#include "objectforest.h"

namespace romanesco {

enum class SymbolKind { Undeclared, Vector, Transformation, Object, Recursive, Unknown };

/// "a vector", "a recursive", …
[[nodiscard]] const char *described(SymbolKind kind);

/// What a name stands for: its first declaration.
struct Symbol {
    SymbolKind kind = SymbolKind::Undeclared;
    /// The declaration has an error; uses of the name pass without a message.
    bool isBad = false;
    bool isUsed = false;
    /// The line (from 0) of the declaration.
    std::uint32_t line = 0;
    /// Where a vector's name is declared again, which is fine until somebody below refers to it.
    static constexpr std::uint32_t never = 0xFFFFFFFF;
    std::uint32_t repeatLine = never;
    /// Into the model's vectors or transformations, or a node of its forest, by kind.
    std::uint32_t index = 0;
};

struct VectorEntry {
    glm::dvec3 value;
    std::uint32_t line;
    bool isBad;
};

/// One of the three parts of a transformation: the identity, a vector of the file, or a parameter.
struct PartSource {
    enum class Kind { Identity, Vector, Parameter } kind = Kind::Identity;
    std::uint32_t index = 0;
};

struct TransformationEntry {
    std::uint32_t line = 0;
    std::uint32_t parameterCount = 0;
    /// Position, rotation, scale.
    std::array<PartSource, 3> parts;
};

/// Where a set is written: the line, and which set of its value.
struct SetPlace {
    std::uint32_t line;
    std::uint32_t index;
};

/// Position, rotation in degrees, scale: what a transformation says before it becomes a map.
struct TransformParts {
    glm::dvec3 position{0.0};
    glm::dvec3 rotation{0.0};
    glm::dvec3 scale{1.0};
};

/// What the names of an .fdo text stand for, beside all that is wrong with it. No map is computed yet: what a keystroke
/// needs is here, the numbers come with describeFdo().
struct FdoModel {
    /// Of reading the lines and of their names, sorted by place.
    Diagnostics diagnostics;
    /// By NameId.
    std::vector<Symbol> symbols;
    /// A vector's number is its index and 1.
    std::vector<VectorEntry> vectors;
    std::vector<TransformationEntry> transformations;
    /// By SetId; of bad declarations too.
    std::vector<SetPlace> sets;
    ObjectForest forest;
    /// The first <$>; ObjectNode::none where there is none, or one of more levels than can be counted.
    std::uint32_t result = ObjectNode::none;

    /// What a name means to a line: null where it is not declared above.
    [[nodiscard]] const Symbol *find(NameId name, std::size_t line) const;
    /// The index of the vector that a reference in a line means; nothing where there is none, or where it is bad or its
    /// name repeated.
    [[nodiscard]] std::optional<std::uint32_t> vector(const VectorReference &reference, std::size_t line) const;
    /// What a use in a line says. Nothing where it is `#` or wrong.
    [[nodiscard]] std::optional<TransformParts> parts(const TransformationUse &use, std::size_t line) const;
    /// The line of the number that a depth slider moves: from <$> inwards through assignments and sets, the first
    /// `NAME INDEX`.
    [[nodiscard]] std::optional<std::uint32_t> depthLine() const;
};

/// Finds what every name stands for and what <$> is. Uses of names whose declaration is bad pass without a message.
/// Cost linear in the text, times a logarithm for each recursive; for a text that was changed a little, of some ten
/// nanoseconds for each use.
[[nodiscard]] FdoModel resolveFdo(const FdoSyntax &syntax);

}
