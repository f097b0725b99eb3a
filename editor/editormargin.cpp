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
    return {space + static_cast<int>(digits) * digit + space + barWidth + space, 0};
}

bool EditorMargin::event(QEvent *event)
{
    if (event->type() != QEvent::ToolTip) {
        return QWidget::event(event);
    }
    const auto *help = static_cast<QHelpEvent *>(event);
    QToolTip::showText(help->globalPos(), m_editor.messagesInLine(lineAt(help->pos().y())), this);
    return true;
}

void EditorMargin::mousePressEvent(QMouseEvent *event)
{
    const QTextBlock line = m_editor.document()->findBlockByNumber(lineAt(event->position().toPoint().y()));
    if (line.isValid()) {
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
    const int numberWidth = width() - barWidth - 2 * space;
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
            painter.fillRect(width() - barWidth - space, top + 1, barWidth, height - 2,
                             severityColour(line.worst->severity));
        }
    }
}

void EditorMargin::wheelEvent(QWheelEvent *event)
{
    QCoreApplication::sendEvent(m_editor.viewport(), event);
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
