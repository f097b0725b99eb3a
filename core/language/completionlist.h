// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "completion.h"

namespace romanesco {

/// Gathers what begins as the word at a cursor does, and makes the edits.
class CompletionList
{
public:
    /// begun is what stands of the word left of the cursor; the rest of it, right of the cursor, is replaced with it
    /// where any is begun. Of a path in quotes that is everything up to the closing quote, or to a blank where that is
    /// missing.
    CompletionList(std::string_view text, SourceRange begun, bool isInQuotes);

    [[nodiscard]] bool isFull() const { return m_list.size() >= mostCompletions; }

    /// Whether there is room, and the word begun begins so.
    [[nodiscard]] bool wants(std::string_view label) const;

    /// Writes words for the label, if it is wanted.
    void add(std::string label, std::string detail, std::string_view words, CompletionKind kind);

    /// The same with an ending (a dot, a blank, a quote) that is written unless it follows already.
    void add(std::string label, std::string detail, std::string_view words, std::string_view ending,
             CompletionKind kind);

    /// Paths that end so (".obj"), in quotes.
    void addFiles(const FileNames &files, std::string_view ending);

    /// What follows the word that is replaced, blanks passed over.
    [[nodiscard]] std::string_view following() const;

    [[nodiscard]] std::vector<Completion> take() { return std::move(m_list); }

private:
    std::string_view m_text;
    std::string_view m_begun;
    SourceRange m_replaced;
    bool m_isInQuotes;
    std::vector<Completion> m_list;
};

}
