// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "editormargin.h"

#include <algorithm>

#include <QCoreApplication>
#include <QHelpEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QTextBlock>
#include <QToolTip>
#include <QWheelEvent>

#include "fdoeditor.h"
#include "folding.h"

namespace romanesco {

namespace {

constexpr int space = 8;
constexpr int barWidth = 3;

}

EditorMargin::EditorMargin(FdoEditor &editor)
    : QWidget(&editor)
    , m_editor(editor)
{
    setCursor(Qt::ArrowCursor);
}

QSize EditorMargin::sizeHint() const
{
    const qsizetype digits = std::max<qsizetype>(2, QString::number(m_editor.blockCount()).size());
    const int digit = m_editor.fontMetrics().horizontalAdvance(u'9');
    return {space + static_cast<int>(digits) * digit + space + barWidth + foldWidth(), 0};
}

bool EditorMargin::event(QEvent *event)
{
    if (event->type() != QEvent::ToolTip) {
        return QWidget::event(event);
    }
    const auto *help = static_cast<QHelpEvent *>(event);
    QString words = m_editor.messagesInLine(lineAt(help->pos().y())).toHtmlEscaped();
    if (isFoldMark(help->pos())) {
        words =
            m_editor.folding().isFolded(lineAt(help->pos().y())) ? tr("Unfold the section") : tr("Fold the section");
    }
    QToolTip::showText(help->globalPos(), words.replace(u'\n', QLatin1String("<br>")), this);
    return true;
}

void EditorMargin::mousePressEvent(QMouseEvent *event)
{
    const QPoint point = event->position().toPoint();
    const QTextBlock line = m_editor.document()->findBlockByNumber(lineAt(point.y()));
    if (isFoldMark(point)) {
        m_editor.folding().toggle(line.blockNumber());
    } else if (line.isValid()) {
        m_editor.setTextCursor(QTextCursor(line));
    }
    m_editor.setFocus(Qt::MouseFocusReason);
}

void EditorMargin::paintEvent(QPaintEvent *event)
{
    using KSyntaxHighlighting::Theme;
    QPainter painter(this);
    painter.fillRect(event->rect(), m_editor.palette().base());
    painter.setFont(m_editor.font());
    const int current = m_editor.textCursor().blockNumber();
    const int barLeft = width() - foldWidth() - barWidth;
    const int numberWidth = barLeft - space;
    for (const FdoEditor::VisibleLine &line : m_editor.visibleLines()) {
        const int top = line.area.top();
        const int height = line.area.height();
        const bool isCurrent = line.number == current;
        if (isCurrent) {
            painter.fillRect(0, top, width(), height, m_editor.colour(Theme::CurrentLine));
        }
        painter.setPen(m_editor.colour(isCurrent ? Theme::CurrentLineNumber : Theme::LineNumbers));
        painter.drawText(0, top, numberWidth, height, Qt::AlignRight | Qt::AlignTop, QString::number(line.number + 1));
        if (line.worst) {
            painter.fillRect(barLeft, top + 1, barWidth, height - 2, severityColour(line.worst->severity));
        }
        if (m_editor.folding().canFold(line.number)) {
            paintFoldMark(painter, top, m_editor.fontMetrics().height(), m_editor.folding().isFolded(line.number));
        }
    }
}

void EditorMargin::wheelEvent(QWheelEvent *event)
{
    QCoreApplication::sendEvent(m_editor.viewport(), event);
}

int EditorMargin::foldWidth() const
{
    return m_editor.fontMetrics().height();
}

bool EditorMargin::isFoldMark(const QPoint &point) const
{
    return point.x() >= width() - foldWidth() && m_editor.folding().canFold(lineAt(point.y()));
}

/// A triangle that points to what is shown below, or to what is not.
void EditorMargin::paintFoldMark(QPainter &painter, int top, int height, bool isFolded) const
{
    const qreal half = height / 5.0;
    const QPointF middle(width() - foldWidth() / 2.0, top + height / 2.0);
    QPolygonF triangle{QPointF(-half, -half / 2), QPointF(half, -half / 2), QPointF(0, half)};
    triangle = (isFolded ? QTransform().rotate(-90) : QTransform()).map(triangle);
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setBrush(painter.pen().color());
    painter.setPen(Qt::NoPen);
    painter.drawPolygon(triangle.translated(middle));
    painter.restore();
}

int EditorMargin::lineAt(int y) const
{
    for (const FdoEditor::VisibleLine &line : m_editor.visibleLines()) {
        if (y >= line.area.top() && y < line.area.bottom() + 1) {
            return line.number;
        }
    }
    return -1;
}

}
