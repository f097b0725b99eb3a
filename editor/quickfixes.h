// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <vector>

#include <QObject>

#include "core/text/diagnostic.h"
#include "textsnapshot.h"

class QPlainTextEdit;

namespace romanesco {

class LanguageText;

/// Offers to put right what is wrong under the cursor.
class QuickFixes : public QObject
{
    Q_OBJECT
public:
    /// Both must outlive it.
    QuickFixes(QPlainTextEdit &editor, LanguageText &text);

    /// What is remarked on a text, hints included.
    void setDiagnostics(const Diagnostics &diagnostics, const TextSnapshot &text);

    /// The fixes of what the cursor touches; where it touches nothing, those of its line. None once the text has changed,
    /// until it is remarked on anew, and none in a read-only text.
    [[nodiscard]] std::vector<Fix> atCursor();

    /// A menu of them at the cursor, or a word that there are none.
    void offer();

private:
    struct Place {
        SourceRange range;
        Fix fix;
    };

    QPlainTextEdit &m_editor;
    LanguageText &m_text;
    std::vector<Place> m_places;
    TextSnapshot m_snapshot;
};

}
