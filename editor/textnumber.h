// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <optional>

#include "liveedit.h"

namespace romanesco {

/// A whole number in an editor's text that something else moves, such as a slider: see LiveEdit.
class TextNumber
{
public:
    /// editor must outlive it.
    explicit TextNumber(QPlainTextEdit &editor);

    /// The number stands at the positions [begin, end) of the document.
    void track(int begin, int end) { m_edit.track(begin, end); }
    void clear() { m_edit.clear(); }

    /// What the text says now; nothing where no number is tracked or the text there is one no more.
    [[nodiscard]] std::optional<quint64> value() const;

    /// One undo step; between beginGesture() and endGesture() all calls together are one. Nothing happens where there is
    /// no number, where it has this value already, or where the text is read-only.
    void setValue(quint64 value);

    void beginGesture() { m_edit.beginGesture(); }
    void endGesture() { m_edit.endGesture(); }

private:
    LiveEdit m_edit;
};

}
