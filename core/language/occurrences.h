// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/text/sourcerange.h"
#include "fdodocument.h"

namespace romanesco {

/// What a word of a text stands for. Each declaration makes one: where a name is declared again, which is an error unless
/// it is a vector's, the second declaration is something of its own that nothing refers to by name.
struct Entity {
    enum class Kind {
        Vector,
        Transformation,
        Object,
        Recursive,
        Unknown,   ///< of a line of which only the name could be read
        Parameter, ///< known in its own line only
        Result,    ///< <$>
        Path,      ///< of a file
    };
    Kind kind = Kind::Unknown;
    /// The line (from 0) that declares it; 0 for a Result and a Path.
    std::uint32_t line = 0;
    /// Into the model's vectors, or which of the line's parameters; else 0.
    std::uint32_t index = 0;
    /// Of a Path, as written, without quotes. The same words are the same file.
    std::string path = {};

    bool operator==(const Entity &) const = default;
};

/// A word that stands for something.
struct Occurrence {
    SourceRange range;
    Entity entity;
    bool isDeclaration = false;
    /// The word is a name, rather than a vector's number, a path or <$>.
    bool isName = false;
};

/// The word that a cursor touches, standing inside it or at either end. Nothing where there is none, or one that stands
/// for nothing: a name that is not declared above, a vector's name that is repeated above, a depth. Of two words that
/// touch each other it is the first. Any offset is allowed. Cost linear in the line.
[[nodiscard]] std::optional<Occurrence> occurrenceAt(const FdoDocument &document, std::size_t offset);

/// All words that stand for the same, the declaration among them, in the order of the text. A vector is meant by its
/// number as well as by its name. Cost linear in the text; of a parameter, in its line.
[[nodiscard]] std::vector<Occurrence> occurrences(const FdoDocument &document, const Entity &entity);

/// The word that declares it: the name, or the first <$>. Nothing for a path. Cost linear in the line, for <$> in the
/// objects.
[[nodiscard]] std::optional<SourceRange> declaration(const FdoDocument &document, const Entity &entity);

/// What a word of a line stands for.
struct LineWord;
[[nodiscard]] std::optional<Entity> entityOf(const FdoDocument &document, std::uint32_t line, const LineWord &word);

}
