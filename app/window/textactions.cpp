// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#include "textactions.h"

#include <utility>

#include <QAction>
#include <QMenu>
#include <QToolBar>

#include "editor/fdoeditor.h"
#include "editor/findbar.h"
#include "makeaction.h"

namespace romanesco {

TextActions::TextActions(QWidget &window)
    : QObject(&window)
    , m_window(window)
    , m_undo(makeChange(tr("&Undo"), QKeySequence::Undo, &FdoEditor::undo))
    , m_redo(makeChange(tr("&Redo"), QKeySequence::Redo, &FdoEditor::redo))
    , m_cut(makeChange(tr("Cu&t"), QKeySequence::Cut, &FdoEditor::cut))
    , m_copy(make(tr("&Copy"), QKeySequence::Copy, &FdoEditor::copy))
    , m_paste(makeChange(tr("&Paste"), QKeySequence::Paste, &FdoEditor::paste))
    , m_selectAll(make(tr("Select &All"), QKeySequence::SelectAll, &FdoEditor::selectAll))
    , m_find(makeSearch(tr("&Find…"), QKeySequence::Find, &FindBar::openFind))
    , m_replace(makeSearch(tr("Repl&ace…"), Qt::CTRL | Qt::Key_R, &FindBar::openReplace))
    , m_findNext(makeSearch(tr("Find Ne&xt"), Qt::CTRL | Qt::Key_G, &FindBar::findNext))
    , m_findPrevious(makeSearch(tr("Find Pre&vious"), Qt::CTRL | Qt::SHIFT | Qt::Key_G, &FindBar::findPrevious))
    , m_comment(makeChange(tr("Co&mment"), Qt::CTRL | Qt::Key_Slash, &FdoEditor::toggleComment))
    , m_duplicate(makeChange(tr("&Duplicate Line"), Qt::CTRL | Qt::Key_D, &FdoEditor::duplicateLines))
    , m_format(makeChange(tr("Tidy &Layout"), Qt::CTRL | Qt::Key_I, &FdoEditor::format))
    , m_rename(makeChange(tr("Re&name…"), Qt::Key_F2, &FdoEditor::rename))
    , m_renumber(makeChange(tr("Renum&ber Uses"), Qt::CTRL | Qt::SHIFT | Qt::Key_R, &FdoEditor::renumber))
    , m_complete(makeChange(tr("C&omplete"), Qt::CTRL | Qt::Key_Space, &FdoEditor::complete))
    , m_fix(makeChange(tr("Put &Right…"), Qt::CTRL | Qt::Key_Period, &FdoEditor::offerFixes))
    , m_definition(make(tr("&Definition"), Qt::Key_F12, &FdoEditor::goToDefinition))
    , m_nextUse(make(tr("Next &Use"), Qt::SHIFT | Qt::Key_F12, &FdoEditor::goToNextUse))
    , m_previousUse(make(tr("Pre&vious Use"), Qt::CTRL | Qt::SHIFT | Qt::Key_F12, &FdoEditor::goToPreviousUse))
    , m_line(make(tr("&Line…"), Qt::CTRL | Qt::Key_L, &FdoEditor::askForLine))
    , m_nextProblem(make(tr("&Next Problem"), Qt::CTRL | Qt::ALT | Qt::Key_E, &FdoEditor::goToNextProblem))
    , m_tip(make(tr("&Value of the Word"), Qt::CTRL | Qt::SHIFT | Qt::Key_Space, [](FdoEditor &e) { e.showTip(); }))
    , m_larger(make(tr("&Larger Text"), QKeySequence::ZoomIn, [](FdoEditor &e) { e.zoomBy(1); }))
    , m_smaller(make(tr("S&maller Text"), QKeySequence::ZoomOut, [](FdoEditor &e) { e.zoomBy(-1); }))
    , m_usual(make(tr("&Usual Text Size"), Qt::CTRL | Qt::Key_0, &FdoEditor::resetZoom))
    , m_fold(make(tr("&Fold"), Qt::ALT | Qt::Key_Minus, &FdoEditor::fold))
    , m_unfold(make(tr("&Unfold"), Qt::ALT | Qt::Key_Plus, &FdoEditor::unfold))
    , m_foldAll(make(tr("Fold &All"), {}, &FdoEditor::foldAll))
    , m_unfoldAll(make(tr("Unfold A&ll"), {}, &FdoEditor::unfoldAll))
{
    // What most keyboards have without Shift.
    m_larger->setShortcuts({QKeySequence(QKeySequence::ZoomIn), QKeySequence(Qt::CTRL | Qt::Key_Equal)});
    m_findNext->setShortcuts({QKeySequence(Qt::CTRL | Qt::Key_G), QKeySequence(Qt::Key_F3)});
    m_unfold->setShortcuts({QKeySequence(Qt::ALT | Qt::Key_Plus), QKeySequence(Qt::ALT | Qt::Key_Equal)});
    m_renumber->setEnabled(false);
}

TextActions::~TextActions() = default;

QAction *TextActions::make(const QString &text, const QKeySequence &key, Act act)
{
    QAction *action = makeAction(m_window, text, key);
    connect(action, &QAction::triggered, this, [this, act = std::move(act)] { act(*m_editor); });
    return action;
}

QAction *TextActions::makeSearch(const QString &text, const QKeySequence &key, void (FindBar::*act)())
{
    QAction *action = makeAction(m_window, text, key);
    connect(action, &QAction::triggered, this, [this, act] { (m_findBar->*act)(); });
    return action;
}

QAction *TextActions::makeChange(const QString &text, const QKeySequence &key, Act act)
{
    m_changes.push_back(make(text, key, std::move(act)));
    return m_changes.back();
}

void TextActions::follow(FdoEditor &editor, FindBar &findBar)
{
    m_editor = &editor;
    m_findBar = &findBar;
    m_whileFollowed = std::make_unique<QObject>();
    QObject *context = m_whileFollowed.get();
    connect(&editor, &QPlainTextEdit::undoAvailable, context,
            [this](bool is) { m_undo->setEnabled(is && !m_editor->isReadOnly()); });
    connect(&editor, &QPlainTextEdit::redoAvailable, context,
            [this](bool is) { m_redo->setEnabled(is && !m_editor->isReadOnly()); });
    connect(&editor, &QPlainTextEdit::copyAvailable, context, [this](bool is) {
        m_cut->setEnabled(is && !m_editor->isReadOnly());
        m_copy->setEnabled(is);
    });
    connect(&editor, &FdoEditor::renumberingOffered, context, [this](int count) { m_renumber->setEnabled(count > 0); });
    update();
}

void TextActions::update()
{
    const bool isSelected = m_editor->textCursor().hasSelection();
    for (QAction *action : m_changes) {
        action->setEnabled(!m_editor->isReadOnly());
    }
    // Which a text has that follows its file.
    m_undo->setEnabled(m_editor->document()->isUndoAvailable() && !m_editor->isReadOnly());
    m_redo->setEnabled(m_editor->document()->isRedoAvailable() && !m_editor->isReadOnly());
    m_cut->setEnabled(isSelected && !m_editor->isReadOnly());
    m_copy->setEnabled(isSelected);
    m_renumber->setEnabled(m_editor->renumberingCount() > 0);
}

void TextActions::fillEdit(QMenu &menu) const
{
    menu.addActions({m_undo, m_redo});
    menu.addSeparator();
    menu.addActions({m_cut, m_copy, m_paste, m_selectAll});
    menu.addSeparator();
    menu.addActions({m_find, m_findNext, m_findPrevious, m_replace});
    menu.addSeparator();
    menu.addActions({m_comment, m_duplicate, m_format});
    menu.addSeparator();
    menu.addActions({m_complete, m_fix, m_rename, m_renumber});
}

void TextActions::fillGo(QMenu &menu) const
{
    menu.addActions({m_definition, m_nextUse, m_previousUse});
    menu.addSeparator();
    menu.addActions({m_line, m_nextProblem});
    menu.addSeparator();
    menu.addAction(m_tip);
}

void TextActions::fillView(QMenu &menu) const
{
    menu.addActions({m_larger, m_smaller, m_usual});
    menu.addSeparator();
    menu.addActions({m_fold, m_unfold, m_foldAll, m_unfoldAll});
}

void TextActions::fill(QToolBar &bar) const
{
    bar.addActions({m_undo, m_redo});
}

}
