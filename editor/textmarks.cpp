// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "textmarks.h"

#include <algorithm>
#include <utility>

namespace romanesco {

namespace {

/// More than fit a screen; each costs with every line that is drawn.
constexpr int mostInSight = 500;

}

void TextMarks::set(MarkLayer layer, std::vector<TextStretch> stretches, const QTextCharFormat &format)
{
    m_layers[static_cast<std::size_t>(layer)] = {std::move(stretches), format};
}

void TextMarks::clear()
{
    m_layers = {};
}

bool TextMarks::isEmpty() const
{
    return std::ranges::all_of(m_layers, [](const Layer &layer) { return layer.stretches.empty(); });
}

const std::vector<TextStretch> &TextMarks::stretches(MarkLayer layer) const
{
    return m_layers[static_cast<std::size_t>(layer)].stretches;
}

QList<QTextEdit::ExtraSelection> TextMarks::between(int begin, int end, QTextDocument &document) const
{
    QList<QTextEdit::ExtraSelection> selections;
    for (const Layer &layer : m_layers) {
        auto at = std::ranges::lower_bound(layer.stretches, begin, {}, &TextStretch::end);
        for (int count = 0; at != layer.stretches.end() && at->begin <= end && count < mostInSight; ++at, ++count) {
            QTextEdit::ExtraSelection selection;
            selection.format = layer.format;
            selection.cursor = QTextCursor(&document);
            selection.cursor.setPosition(std::min(at->begin, document.characterCount() - 1));
            selection.cursor.setPosition(std::min(at->end, document.characterCount() - 1), QTextCursor::KeepAnchor);
            selections += selection;
        }
    }
    return selections;
}

}
