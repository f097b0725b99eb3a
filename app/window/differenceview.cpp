// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#include "differenceview.h"

#include <algorithm>

#include <QFontDatabase>
#include <QTextBlock>

#include "core/text/linediff.h"

namespace romanesco {

namespace {

constexpr std::size_t context = 3;
/// Nobody reads more, and a text widget takes seconds for it.
constexpr int mostLines = 5'000;
constexpr int mostCharacters = 500;

using Lines = std::vector<std::string_view>;

QString shown(std::string_view line)
{
    // Before it is converted: a line may be all of a large file.
    const QString text =
        QString::fromUtf8(line.data(), static_cast<qsizetype>(std::min<std::size_t>(line.size(), 4 * mostCharacters)));
    return text.size() > mostCharacters || line.size() > 4 * mostCharacters
        ? text.first(std::min<qsizetype>(text.size(), mostCharacters)) + u'…'
        : text;
}

/// Lines with a mark before each: a space where both texts have it.
class Listing
{
public:
    void add(QChar mark, const Lines &lines, std::size_t begin, std::size_t end)
    {
        for (std::size_t i = begin; i < end; ++i) {
            if (m_lines.size() == mostLines) {
                m_isWhole = false;
                return;
            }
            m_lines += mark + QStringLiteral(" ") + shown(lines[i]);
        }
    }
    void addHeading(const QString &words)
    {
        if (m_lines.size() < mostLines) {
            m_lines += words;
        }
    }
    [[nodiscard]] bool isWhole() const { return m_isWhole; }
    [[nodiscard]] QString text() const { return m_lines.join(u'\n'); }

private:
    QStringList m_lines;
    bool m_isWhole = true;
};

const QChar went(u'−');
const QChar came(u'+');

}

DifferenceView::DifferenceView(QWidget *parent)
    : QPlainTextEdit(parent)
{
    setReadOnly(true);
    setLineWrapMode(NoWrap);
    setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
    setAccessibleName(tr("Differences"));
}

void DifferenceView::setTexts(std::string_view before, std::string_view after)
{
    const Lines oldLines = linesOf(before);
    const Lines newLines = linesOf(after);
    const std::vector<LineChange> changes = lineChanges(oldLines, newLines);
    Listing listing;
    std::size_t told = 0; // lines of the old text
    for (std::size_t i = 0; i < changes.size(); ++i) {
        const LineChange &change = changes[i];
        const std::size_t start = std::max(told, change.oldBegin - std::min(change.oldBegin, context));
        if (start > told || i == 0) {
            listing.addHeading(tr("line %1").arg(start + 1));
        }
        listing.add(u' ', oldLines, start, change.oldBegin);
        listing.add(went, oldLines, change.oldBegin, change.oldEnd);
        listing.add(came, newLines, change.newBegin, change.newEnd);
        const std::size_t next = i + 1 < changes.size() ? changes[i + 1].oldBegin : oldLines.size();
        told = std::min(change.oldEnd + context, next);
        listing.add(u' ', oldLines, change.oldEnd, told);
    }
    if (changes.empty()) {
        listing.addHeading(tr("The texts are alike."));
    }
    setPlainText(listing.isWhole() ? listing.text() : listing.text() + u'\n' + tr("… and more"));

    const bool isDark = palette().color(QPalette::Base).lightness() < 128;
    QList<QTextEdit::ExtraSelection> colours;
    for (QTextBlock line = document()->begin(); line.isValid(); line = line.next()) {
        const QChar mark = line.text().isEmpty() ? QChar() : line.text().front();
        if (mark == went || mark == came) {
            QTextEdit::ExtraSelection colour;
            colour.cursor = QTextCursor(line);
            colour.format.setProperty(QTextFormat::FullWidthSelection, true);
            colour.format.setBackground(mark == went ? (isDark ? QColor(0x5a, 0x2a, 0x2a) : QColor(0xff, 0xdc, 0xd8))
                                                     : (isDark ? QColor(0x24, 0x4a, 0x2c) : QColor(0xd8, 0xf3, 0xdc)));
            colours += colour;
        }
    }
    setExtraSelections(colours);
}

}
