// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#include "windowactions.h"

#include <QAction>
#include <QActionGroup>
#include <QMenuBar>
#include <QToolBar>

namespace romanesco {

namespace {

QAction *make(QWidget &owner, const QString &text, const QKeySequence &key = {})
{
    auto *action = new QAction(text, &owner);
    action->setShortcut(key);
    QString tip = text;
    tip.remove(u'&').remove(u'…');
    // On buttons, where an ellipsis would only be noise.
    action->setIconText(tip);
    if (!key.isEmpty()) {
        tip += QStringLiteral(" (%1)").arg(key.toString(QKeySequence::NativeText));
    }
    action->setToolTip(tip);
    return action;
}

/// A key that means a letter or a figure everywhere but in the viewport.
QAction *makeFor(QWidget &viewport, const QString &text, const QKeySequence &key)
{
    QAction *action = make(viewport, text, key);
    action->setShortcutContext(Qt::WidgetShortcut);
    viewport.addAction(action);
    return action;
}

}

WindowActions::WindowActions(QWidget &window, QWidget &viewport)
    : newFile(make(window, tr("&New"), QKeySequence::New))
    , open(make(window, tr("&Open…"), QKeySequence::Open))
    , save(make(window, tr("&Save"), QKeySequence::Save))
    , saveAs(make(window, tr("Save &As…"), Qt::CTRL | Qt::SHIFT | Qt::Key_S))
    , quit(make(window, tr("&Quit"), Qt::CTRL | Qt::Key_Q))
    , undo(make(window, tr("&Undo"), QKeySequence::Undo))
    , redo(make(window, tr("&Redo"), QKeySequence::Redo))
    , cut(make(window, tr("Cu&t"), QKeySequence::Cut))
    , copy(make(window, tr("&Copy"), QKeySequence::Copy))
    , paste(make(window, tr("&Paste"), QKeySequence::Paste))
    , selectAll(make(window, tr("Select &All"), QKeySequence::SelectAll))
    , nextProblem(make(window, tr("&Next Problem"), Qt::CTRL | Qt::ALT | Qt::Key_E))
    , fit(makeFor(viewport, tr("&Fit"), Qt::Key_F))
    , resetView(makeFor(viewport, tr("&Reset View"), Qt::Key_Home))
    , front(makeFor(viewport, tr("Fr&ont"), Qt::Key_1))
    , right(makeFor(viewport, tr("&Side"), Qt::Key_3))
    , top(makeFor(viewport, tr("&Top"), Qt::Key_7))
    , orthographic(makeFor(viewport, tr("Ort&hographic"), Qt::Key_5))
    , endless(makeFor(viewport, tr("&Endless"), Qt::Key_E))
    , saveView(make(window, tr("Sa&ve View in Text")))
    , trail(new QActionGroup(&window))
    , colouring(new QActionGroup(&window))
    , wireframe(make(window, tr("&Wireframe")))
    , lighting(make(window, tr("&Lighting")))
    , textures(make(window, tr("&Textures")))
    , smooth(make(window, tr("&Smooth Shading")))
    , largerText(make(window, tr("&Larger Text"), QKeySequence::ZoomIn))
    , smallerText(make(window, tr("S&maller Text"), QKeySequence::ZoomOut))
    , usualText(make(window, tr("&Usual Text Size"), Qt::CTRL | Qt::Key_0))
    , fullScreen(make(window, tr("&Full Screen"), Qt::Key_F11))
    , about(make(window, tr("&About Romanesco")))
{
    for (const QString &words : {tr("&Materials"), tr("&Depth"), tr("&Branch"), tr("S&et")}) {
        QAction *action = make(window, words);
        action->setCheckable(true);
        colouring->addAction(action);
    }
    colouring->actions().first()->setChecked(true);
    for (QAction *action : {wireframe, lighting, textures, smooth}) {
        action->setCheckable(true);
        action->setChecked(action != wireframe);
    }
    const auto addTrail = [&](const QString &words, const QVariant &levels) {
        QAction *action = make(window, words);
        action->setCheckable(true);
        action->setData(levels);
        trail->addAction(action);
    };
    addTrail(tr("&Off"), {});
    for (const int levels : {0, 1, 2, 3, 5, 8}) {
        addTrail(tr("Trail of &%1").arg(levels), levels);
    }
    trail->actions().first()->setChecked(true);
    orthographic->setCheckable(true);
    endless->setCheckable(true);
    endless->setStatusTip(tr("Detail wherever the view leads, as if the depth had no end"));
    orthographic->setIconText(tr("Ortho"));
    fullScreen->setCheckable(true);
    // What most keyboards have without Shift.
    largerText->setShortcuts({QKeySequence(QKeySequence::ZoomIn), QKeySequence(Qt::CTRL | Qt::Key_Equal)});
}

WindowActions::OpenMenus WindowActions::fill(QMenuBar &bar) const
{
    QMenu *file = bar.addMenu(tr("&File"));
    file->addActions({newFile, open});
    QMenu *examples = file->addMenu(tr("Open &Example"));
    file->addSeparator();
    file->addActions({save, saveAs});
    file->addSeparator();
    file->addAction(quit);

    QMenu *edit = bar.addMenu(tr("&Edit"));
    edit->addActions({undo, redo});
    edit->addSeparator();
    edit->addActions({cut, copy, paste, selectAll});
    edit->addSeparator();
    edit->addAction(nextProblem);

    QMenu *view = bar.addMenu(tr("&View"));
    view->addActions({fit, resetView});
    view->addSeparator();
    view->addActions({front, right, top, orthographic});
    view->addSeparator();
    view->addActions({endless, saveView});
    view->addMenu(tr("&Dissertation's Zoom"))->addActions(trail->actions());
    view->addSeparator();
    view->addMenu(tr("&Colour By"))->addActions(colouring->actions());
    view->addActions({wireframe, lighting, textures, smooth});
    view->addSeparator();
    view->addActions({largerText, smallerText, usualText});

    QMenu *window = bar.addMenu(tr("&Window"));
    window->addAction(fullScreen);
    window->addSeparator();

    bar.addMenu(tr("&Help"))->addAction(about);
    return {examples, window};
}

void WindowActions::fill(QToolBar &bar) const
{
    // Words: they need no guessing.
    bar.setToolButtonStyle(Qt::ToolButtonTextOnly);
    bar.addActions({newFile, open, save});
    bar.addSeparator();
    bar.addActions({undo, redo});
    bar.addSeparator();
    bar.addActions({fit, orthographic, endless});
    bar.addSeparator();
}

}
