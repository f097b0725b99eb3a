// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include <QKeySequence>
#include <QObject>

class QAction;
class QMenu;
class QToolBar;
class QWidget;

namespace romanesco {

class FdoEditor;
class FindBar;

/// All that menus offer to do to the text that is looked at. Owned by the window.
class TextActions : public QObject
{
    Q_OBJECT
public:
    explicit TextActions(QWidget &window);
    ~TextActions() override;

    /// From now on they are about this text, which outlives that.
    void follow(FdoEditor &editor, FindBar &findBar);
    /// Whether the text can be changed may be another matter now.
    void update();

    void fillEdit(QMenu &menu) const;
    void fillGo(QMenu &menu) const;
    void fillView(QMenu &menu) const;
    void fill(QToolBar &bar) const;

private:
    using Act = std::function<void(FdoEditor &editor)>;
    QAction *make(const QString &text, const QKeySequence &key, Act act);
    QAction *makeSearch(const QString &text, const QKeySequence &key, void (FindBar::*act)());
    /// Which have no meaning where the text cannot be changed.
    QAction *makeChange(const QString &text, const QKeySequence &key, Act act);

    QWidget &m_window;
    FdoEditor *m_editor = nullptr;
    FindBar *m_findBar = nullptr;
    /// Lives as long as an editor is followed, for what is connected to it.
    std::unique_ptr<QObject> m_whileFollowed;

    std::vector<QAction *> m_changes;
    QAction *m_undo;
    QAction *m_redo;
    QAction *m_cut;
    QAction *m_copy;
    QAction *m_paste;
    QAction *m_selectAll;
    QAction *m_find;
    QAction *m_replace;
    QAction *m_findNext;
    QAction *m_findPrevious;
    QAction *m_comment;
    QAction *m_duplicate;
    QAction *m_format;
    QAction *m_rename;
    QAction *m_renumber;
    QAction *m_complete;
    QAction *m_fix;
    QAction *m_definition;
    QAction *m_nextUse;
    QAction *m_previousUse;
    QAction *m_line;
    QAction *m_nextProblem;
    QAction *m_tip;
    QAction *m_larger;
    QAction *m_smaller;
    QAction *m_usual;
    QAction *m_fold;
    QAction *m_unfold;
    QAction *m_foldAll;
    QAction *m_unfoldAll;
};

}
