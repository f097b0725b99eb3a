// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "brackets.h"

#include <optional>

#include <QTextBlock>
#include <QTextDocument>

namespace romanesco {

namespace {

constexpr QStringView brackets = u"()[]<>";

/// A line with what stands in quotes blanked out.
QString withoutQuoted(QString line)
{
    bool isQuoted = false;
    for (QChar &c : line) {
        const bool isQuote = c == u'"';
        isQuoted = isQuoted != isQuote;
        c = isQuoted ? QChar(u' ') : c;
    }
    return line;
}

std::optional<qsizetype> partner(QStringView line, qsizetype at)
{
    const qsizetype kind = at >= 0 && at < line.size() ? brackets.indexOf(line[at]) : -1;
    if (kind < 0) {
        return std::nullopt;
    }
    const QChar other = brackets[kind ^ 1];
    const int step = kind % 2 == 0 ? 1 : -1;
    int depth = 0;
    for (qsizetype i = at; i >= 0 && i < line.size(); i += step) {
        depth += line[i] == line[at] ? 1 : line[i] == other ? -1 : 0;
        if (depth == 0) {
            return i;
        }
    }
    return std::nullopt;
}

}

std::vector<TextStretch> matchingBrackets(const QTextDocument &document, int position)
{
    const QTextBlock block = document.findBlock(position);
    const QString line = withoutQuoted(block.text());
    for (const qsizetype at : {position - 1 - block.position(), position - block.position()}) {
        if (const std::optional<qsizetype> other = partner(line, at)) {
            const auto first = block.position() + static_cast<int>(std::min(at, *other));
            const auto second = block.position() + static_cast<int>(std::max(at, *other));
            return {{first, first + 1}, {second, second + 1}};
        }
    }
    return {};
}

}
