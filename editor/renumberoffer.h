// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <QObject>
#include <QTextCursor>

#include "core/language/fdodocument.h"
#include "core/text/textedit.h"
#include "textsnapshot.h"

class QPlainTextEdit;

namespace romanesco {

class LanguageText;

/// Watches vectors come and go, and offers to change the uses by number that now mean another vector. The offer is about
/// the lines that are being edited: it follows what is typed there, and is withdrawn once something else is edited, or
/// edits are undone or redone.
class RenumberOffer : public QObject
{
    Q_OBJECT
public:
    /// Both must outlive it.
    RenumberOffer(QPlainTextEdit &editor, LanguageText &text);

    /// So many uses; 0 where nothing is offered.
    [[nodiscard]] int count() const { return static_cast<int>(m_edits.size()); }

    /// Changes the uses; undone together with the last edit of the vectors.
    void take();
    /// The numbers are right as they are.
    void dismiss();

Q_SIGNALS:
    void changed(int count);

private:
    void follow(int begin, int added);
    [[nodiscard]] bool isFreshEdit();
    [[nodiscard]] bool isElsewhere(int begin) const;
    void compare();
    void startFrom(const TextSnapshot &text);
    void offer(TextEdits edits);

    QPlainTextEdit &m_editor;
    LanguageText &m_text;
    /// The text when its numbers were right last, and how many vectors it has.
    TextSnapshot m_base;
    std::size_t m_baseVectors = 0;
    /// That text as it is read, where a comparison needed it.
    FdoDocument m_before;
    /// Before the last edit.
    TextSnapshot m_last;
    /// What was edited since then.
    QTextCursor m_edited;
    TextEdits m_edits;
    bool m_hasNewUndoStep = false;
    int m_redoSteps = 0;
    bool m_isTaking = false;
};

}
