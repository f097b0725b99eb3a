// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <optional>

#include <QPoint>

#include "liveedit.h"
#include "numberplace.h"

class QMouseEvent;

namespace romanesco {

class FdoEditor;

/// Moves numbers by hand: with Ctrl a number is dragged to the right and left, by keys it is stepped. Shift is finer. The
/// text follows at once; a drag is one undo step, and so is all stepping of a number until endSteps().
class Scrubber
{
public:
    /// editor must outlive it.
    explicit Scrubber(FdoEditor &editor);

    /// Each returns whether the event is its own: a press on a number, what moves it, and the end of a drag.
    bool press(const QMouseEvent &event);
    bool move(const QMouseEvent &event);
    bool release(const QMouseEvent &event);

    /// Steps the number at the cursor; nothing where there is none.
    void step(int steps, bool isFiner);
    void endSteps();

private:
    void track(const NumberPlace &place);

    FdoEditor &m_editor;
    LiveEdit m_edit;
    /// What is dragged, as it was at the start.
    std::optional<NumberPlace> m_number;
    QPoint m_pressed;
    bool m_isDragging = false;
    bool m_isStepping = false;
};

}
