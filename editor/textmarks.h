// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <array>
#include <vector>

#include <QTextEdit>

namespace romanesco {

/// Positions [begin, end) of a document.
struct TextStretch {
    int begin = 0;
    int end = 0;
    bool operator==(const TextStretch &) const = default;
};

/// What stands out in a text beside its problems; a later layer lies above an earlier one.
enum class MarkLayer { Uses, Matches, Brackets, Link };
constexpr std::size_t markLayerCount = 4;

/// Stretches of a text that are marked, layer by layer. However many there are, an editor is given those in sight only.
class TextMarks
{
public:
    /// Ascending stretches that do not overlap, in place of the layer's last.
    void set(MarkLayer layer, std::vector<TextStretch> stretches, const QTextCharFormat &format);
    void clear();

    [[nodiscard]] bool isEmpty() const;
    [[nodiscard]] const std::vector<TextStretch> &stretches(MarkLayer layer) const;

    /// Those that lie between two positions, at least in part; some hundred of each layer at most.
    [[nodiscard]] QList<QTextEdit::ExtraSelection> between(int begin, int end, QTextDocument &document) const;

private:
    struct Layer {
        std::vector<TextStretch> stretches;
        QTextCharFormat format;
    };
    std::array<Layer, markLayerCount> m_layers;
};

}
