// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "inlineedit.h"

#include <algorithm>
#include <utility>

#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QVBoxLayout>

namespace romanesco {

namespace {

constexpr int leastCharacters = 16;

}

InlineEdit *InlineEdit::open(QPlainTextEdit &editor, int position, Question question)
{
    auto *edit = new InlineEdit(editor, position, std::move(question));
    edit->show();
    edit->m_line->setFocus();
    return edit;
}

InlineEdit::InlineEdit(QPlainTextEdit &editor, int position, Question question)
    : QFrame(editor.viewport())
    , m_editor(editor)
    , m_position(position)
    , m_question(std::move(question))
    , m_line(new QLineEdit)
    , m_reason(new QLabel)
{
    setFrameShape(StyledPanel);
    setAutoFillBackground(true);
    setCursor(Qt::ArrowCursor);
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(2, 2, 2, 2);
    column->setSpacing(2);
    column->addWidget(m_line);
    column->addWidget(m_reason);
    m_reason->setTextFormat(Qt::PlainText);
    m_reason->setWordWrap(true);
    m_line->setFont(editor.font());
    m_line->setAccessibleName(m_question.title);
    m_line->setPlaceholderText(m_question.title);
    m_line->setMinimumWidth(leastCharacters * editor.fontMetrics().horizontalAdvance(u'n'));
    m_line->setText(m_question.text);
    m_line->selectAll();
    m_line->installEventFilter(this);
    connect(m_line, &QLineEdit::textChanged, this, &InlineEdit::check);
    connect(&editor, &QPlainTextEdit::textChanged, this, &InlineEdit::leave);
    check();
}

bool InlineEdit::eventFilter(QObject *watched, QEvent *event)
{
    if (event->type() == QEvent::FocusOut) {
        leave();
    } else if (event->type() == QEvent::KeyPress) {
        switch (static_cast<QKeyEvent *>(event)->key()) {
        case Qt::Key_Escape:
            leave();
            return true;
        case Qt::Key_Return:
        case Qt::Key_Enter:
            take();
            return true;
        default:
            break;
        }
    }
    return QFrame::eventFilter(watched, event);
}

void InlineEdit::check()
{
    // What stands there to begin with is no mistake.
    const bool isChanged = m_line->text() != m_question.text;
    const QString reason = isChanged ? m_question.check(m_line->text()) : QString();
    m_reason->setText(reason);
    m_reason->setVisible(!reason.isEmpty());
    m_line->setAccessibleDescription(reason);
    place();
}

void InlineEdit::take()
{
    const QString words = m_line->text();
    if (!m_question.check(words).isEmpty()) {
        return;
    }
    leave();
    m_question.take(words);
}

void InlineEdit::leave()
{
    if (isHidden()) {
        return;
    }
    const bool hadFocus = m_line->hasFocus();
    hide();
    deleteLater();
    if (hadFocus) {
        m_editor.setFocus();
    }
}

/// Over the word, and within sight.
void InlineEdit::place()
{
    layout()->activate();
    const QRect room = m_editor.viewport()->rect();
    QTextCursor cursor(m_editor.document());
    cursor.setPosition(m_position);
    const QRect word = m_editor.cursorRect(cursor);
    const int width = std::min(std::max(sizeHint().width(), minimumSizeHint().width()), room.width());
    const int height = std::max(sizeHint().height(), hasHeightForWidth() ? heightForWidth(width) : 0);
    const int left = std::clamp(word.left() - 4, 0, std::max(0, room.width() - width));
    const int top = std::clamp(word.top() - 4, 0, std::max(0, room.height() - height));
    setGeometry(left, top, width, height);
}

}
