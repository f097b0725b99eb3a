// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "renumberoffer.h"

#include <algorithm>
#include <utility>

#include <QPlainTextEdit>
#include <QTextBlock>

#include "core/language/renumbering.h"
#include "languagetext.h"
#include "textediting.h"

namespace romanesco {

RenumberOffer::RenumberOffer(QPlainTextEdit &editor, LanguageText &text)
    : QObject(&editor)
    , m_editor(editor)
    , m_text(text)
{
    connect(editor.document(), &QTextDocument::undoCommandAdded, this, [this] { m_hasNewUndoStep = true; });
    connect(editor.document(), &QTextDocument::contentsChange, this,
            [this](int begin, int, int added) { follow(begin, added); });
}

void RenumberOffer::take()
{
    const TextEdits edits = std::exchange(m_edits, {});
    m_isTaking = true;
    applyEdits(m_editor, edits, m_text.snapshot(), UndoStep::Last);
    m_isTaking = false;
    startFrom(m_text.snapshot());
    Q_EMIT changed(0);
}

void RenumberOffer::dismiss()
{
    startFrom(m_text.snapshot());
    offer({});
}

void RenumberOffer::follow(int begin, int added)
{
    const TextSnapshot now = m_text.snapshot();
    const bool isFresh = isFreshEdit();
    if (m_isTaking || now.bytes() == m_last.bytes()) {
        return;
    }
    const TextSnapshot before = std::exchange(m_last, now);
    if (!m_text.fdo() || !isFresh) {
        startFrom(now);
        offer({});
        return;
    }
    if (isElsewhere(begin)) {
        startFrom(before);
    }
    // It grows with what is edited, and moves with the text.
    const int first = m_edited.isNull() ? begin : std::min(m_edited.selectionStart(), begin);
    const int last = m_edited.isNull() ? begin + added : std::max(m_edited.selectionEnd(), begin + added);
    m_edited = QTextCursor(m_editor.document());
    m_edited.setPosition(first);
    m_edited.setPosition(std::min(last, m_editor.document()->characterCount() - 1), QTextCursor::KeepAnchor);
    compare();
}

/// Typed or pasted, and not undone or redone: then numbers are as they were beside the vectors that came or went.
bool RenumberOffer::isFreshEdit()
{
    const QTextDocument &document = *m_editor.document();
    const int redoSteps = document.availableRedoSteps();
    const bool isPlain = redoSteps == 0 && std::exchange(m_redoSteps, redoSteps) == 0;
    m_redoSteps = redoSteps;
    return (std::exchange(m_hasNewUndoStep, false) || isPlain) && document.isUndoRedoEnabled();
}

bool RenumberOffer::isElsewhere(int begin) const
{
    if (m_edited.isNull()) {
        return false;
    }
    const QTextDocument &document = *m_editor.document();
    const QTextBlock last = document.findBlock(m_edited.selectionEnd());
    return begin < document.findBlock(m_edited.selectionStart()).position() || begin >= last.position() + last.length();
}

void RenumberOffer::compare()
{
    const FdoDocument &now = *m_text.fdo();
    if (now.model.vectors.size() == m_baseVectors) {
        startFrom(m_last);
        offer({});
        return;
    }
    if (m_before.syntax.text() != m_base.bytes()) {
        m_before.setText(m_base.bytes());
    }
    offer(renumbering(m_before, now).edits);
}

void RenumberOffer::startFrom(const TextSnapshot &text)
{
    m_base = text;
    m_last = m_text.snapshot();
    m_edited = QTextCursor();
    const FdoDocument *fdo = m_text.fdo();
    if (!fdo) {
        return;
    }
    if (text.bytes() == m_last.bytes()) {
        m_baseVectors = fdo->model.vectors.size();
    } else {
        m_before.setText(text.bytes());
        m_baseVectors = m_before.model.vectors.size();
    }
}

void RenumberOffer::offer(TextEdits edits)
{
    const int before = count();
    m_edits = std::move(edits);
    if (count() != before) {
        Q_EMIT changed(count());
    }
}

}
