// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "inlaynumbers.h"

#include <QPainter>
#include <QTextBlock>
#include <QTextLayout>

#include "core/language/structure.h"
#include "fdoeditor.h"

namespace romanesco {

std::vector<InlayNumber> inlayNumbers(FdoEditor &editor)
{
    std::vector<InlayNumber> numbers;
    const std::vector<FdoEditor::VisibleLine> lines = editor.visibleLines();
    const FdoDocument *fdo = editor.language().fdo();
    if (!fdo || lines.empty()) {
        return numbers;
    }
    const qreal space = 2 * editor.fontMetrics().horizontalAdvance(u' ');
    const auto first = static_cast<std::size_t>(lines.front().number);
    auto line = lines.begin();
    for (const Inlay &inlay : inlays(*fdo, first, static_cast<std::size_t>(lines.back().number) + 1)) {
        const auto number = static_cast<int>(fdo->syntax.map().lineAt(inlay.offset));
        line = std::ranges::find(line, lines.end(), number, &FdoEditor::VisibleLine::number);
        if (line == lines.end()) {
            line = lines.begin(); // folded away
            continue;
        }
        const QTextLayout *layout = editor.document()->findBlockByNumber(number).layout();
        if (layout->lineCount() == 0) {
            continue;
        }
        const QTextLine row = layout->lineAt(layout->lineCount() - 1);
        const QPointF end(row.naturalTextRect().right() + space, row.y() + row.ascent());
        numbers.push_back({number, u'·' + QString::number(inlay.number), QPointF(line->area.topLeft()) + end});
    }
    return numbers;
}

void paintInlayNumbers(QPainter &painter, FdoEditor &editor)
{
    painter.setFont(editor.font());
    painter.setPen(editor.colour(KSyntaxHighlighting::Theme::LineNumbers));
    for (const InlayNumber &number : inlayNumbers(editor)) {
        painter.drawText(number.place, number.text);
    }
}

}
