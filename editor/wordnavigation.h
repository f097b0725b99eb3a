// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <QObject>
#include <QPoint>
#include <QTimer>

#include "core/language/navigation.h"

class QMouseEvent;

namespace romanesco {

class FdoEditor;

/// Ways from a word to what it stands for, and to its other uses. While the cursor rests on a word, its uses are marked.
/// With Ctrl held, the word under the mouse is a link to what it stands for; a path leads to its file.
class WordNavigation : public QObject
{
    Q_OBJECT
public:
    /// editor must outlive it.
    explicit WordNavigation(FdoEditor &editor);

    /// Whether the word at the cursor leads anywhere; then the cursor is there, or the file is asked for.
    bool goToDefinition();
    /// The use after the one at the cursor, or before it, going round; nothing where there is no other.
    void goToUse(bool isForward);

    /// Each returns whether the event is its own. A click is a press and a release in one place.
    bool press(const QMouseEvent &event);
    bool release(const QMouseEvent &event);
    /// What was pressed became something else.
    void forgetPress() { m_pressed.reset(); }
    /// The mouse is at a point of the viewport, or has gone. Underlines the link there.
    void point(const QPoint &place, Qt::KeyboardModifiers modifiers);
    /// A key was pressed or released where the mouse is.
    void changeModifiers(Qt::KeyboardModifiers modifiers);

Q_SIGNALS:
    /// A path as it is written in the text.
    void openFileRequested(const QString &path);

private:
    [[nodiscard]] std::optional<Target> targetAt(int position);
    [[nodiscard]] std::vector<Occurrence> usesAtCursor();
    bool follow(int position);
    void goTo(std::size_t offset);
    void markUses();
    void markLink(std::optional<int> position);

    FdoEditor &m_editor;
    QTimer m_rest;
    QPoint m_mouse;
    /// Where a click on a link began.
    std::optional<QPoint> m_pressed;
};

}
