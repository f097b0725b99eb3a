// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "liveedit.h"

#include <algorithm>

#include <QPlainTextEdit>
#include <QScrollBar>

namespace romanesco {

namespace {

/// Where a position goes when [begin, begin + removed) becomes `added` units long.
int moved(int position, int begin, int removed, int added)
{
    if (position <= begin) {
        return position;
    }
    return position >= begin + removed ? position + added - removed : std::min(position, begin + added);
}

}

LiveEdit::LiveEdit(QPlainTextEdit &editor)
    : m_editor(editor)
{
}

void LiveEdit::track(int begin, int end)
{
    m_place = QTextCursor(m_editor.document());
    m_place.setPosition(begin);
    m_place.setPosition(end, QTextCursor::KeepAnchor);
}

void LiveEdit::clear()
{
    m_place = QTextCursor();
}

void LiveEdit::beginGesture()
{
    m_isInGesture = true;
    m_gestureRevision.reset();
}

void LiveEdit::endGesture()
{
    m_isInGesture = false;
}

void LiveEdit::replace(const QString &text)
{
    if (m_place.isNull() || m_editor.isReadOnly() || text == m_place.selectedText()) {
        return;
    }
    const int begin = m_place.selectionStart();
    const int removed = m_place.selectionEnd() - begin;
    const int added = static_cast<int>(text.size());
    const QTextCursor before = m_editor.textCursor();
    const int anchor = moved(before.anchor(), begin, removed, added);
    const int position = moved(before.position(), begin, removed, added);
    const int horizontal = m_editor.horizontalScrollBar()->value();
    const int vertical = m_editor.verticalScrollBar()->value();

    // Something else may have been edited during the gesture; that must not be undone with it.
    const bool isContinued = m_isInGesture && m_gestureRevision == m_editor.document()->revision();
    if (isContinued) {
        m_place.joinPreviousEditBlock();
    } else {
        m_place.beginEditBlock();
    }
    m_place.insertText(text);
    m_place.endEditBlock();
    m_gestureRevision = m_editor.document()->revision();
    track(begin, begin + added);

    QTextCursor after = m_editor.textCursor();
    if (after.anchor() != anchor || after.position() != position) {
        after.setPosition(anchor);
        after.setPosition(position, QTextCursor::KeepAnchor);
        m_editor.setTextCursor(after);
    }
    m_editor.horizontalScrollBar()->setValue(horizontal);
    m_editor.verticalScrollBar()->setValue(vertical);
}

}
