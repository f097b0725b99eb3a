// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <optional>

#include <QTextCursor>

class QPlainTextEdit;

namespace romanesco {

/// A word in an editor's text that something else moves, such as a slider or the mouse. It is found again however the
/// text around it changes; to replace it is an edit of the text that leaves the cursor, the selection and the view in
/// place.
class LiveEdit
{
public:
    /// editor must outlive it.
    explicit LiveEdit(QPlainTextEdit &editor);

    /// The word stands at the positions [begin, end) of the document.
    void track(int begin, int end);
    void clear();

    /// What stands there now; empty where no word is tracked or it is gone.
    [[nodiscard]] QString text() const { return m_place.selectedText(); }
    [[nodiscard]] int begin() const { return m_place.selectionStart(); }
    [[nodiscard]] int end() const { return m_place.selectionEnd(); }

    /// One undo step; between beginGesture() and endGesture() all calls together are one. Nothing happens where no word
    /// is tracked, where it reads so already, or where the text is read-only.
    void replace(const QString &text);

    void beginGesture();
    void endGesture();

private:
    QPlainTextEdit &m_editor;
    QTextCursor m_place;
    bool m_isInGesture = false;
    /// The document's revision after the gesture's last edit; none before its first.
    std::optional<int> m_gestureRevision;
};

}
