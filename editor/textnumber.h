// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <optional>

#include <QTextCursor>

class QPlainTextEdit;

namespace romanesco {

/// A whole number in an editor's text that something else moves, such as a slider. It is found again however the text
/// around it changes; setting it is an edit of the text that leaves the cursor, the selection and the view in place.
class TextNumber
{
public:
    /// editor must outlive it.
    explicit TextNumber(QPlainTextEdit &editor);

    /// The number stands at the positions [begin, end) of the document.
    void track(int begin, int end);
    void clear();

    /// What the text says now; nothing where no number is tracked or the text there is one no more.
    [[nodiscard]] std::optional<quint64> value() const;

    /// One undo step; between beginGesture() and endGesture() all calls together are one. Nothing happens where there is
    /// no number, where it has this value already, or where the text is read-only.
    void setValue(quint64 value);

    void beginGesture();
    void endGesture();

private:
    void replace(const QString &text);

    QPlainTextEdit &m_editor;
    QTextCursor m_place;
    bool m_isInGesture = false;
    /// The document's revision after the gesture's last edit; none before its first.
    std::optional<int> m_gestureRevision;
};

}
