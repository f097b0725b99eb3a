// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#include "windowactions.h"

#include <QAction>
#include <QActionGroup>
#include <QMenuBar>
#include <QToolBar>

#include "makeaction.h"
#include "textactions.h"

namespace romanesco {

WindowActions::WindowActions(QWidget &window, QWidget &viewport)
    : newFile(makeAction(window, tr("&New"), QKeySequence::New))
    , open(makeAction(window, tr("&Open…"), QKeySequence::Open))
    , examples(makeAction(window, tr("Open &Example…"), Qt::CTRL | Qt::SHIFT | Qt::Key_O))
    , save(makeAction(window, tr("&Save"), QKeySequence::Save))
    , saveAs(makeAction(window, tr("Save &As…"), Qt::CTRL | Qt::SHIFT | Qt::Key_S))
    , reload(makeAction(window, tr("Re&load"), Qt::Key_F4))
    , exportMesh(makeAction(window, tr("&Export…"), Qt::CTRL | Qt::Key_E))
    , saveTurntable(makeAction(window, tr("Save &Turntable…"), Qt::CTRL | Qt::SHIFT | Qt::Key_T))
    , closeTab(makeAction(window, tr("&Close"), Qt::CTRL | Qt::Key_W))
    , nextTab(makeAction(window, tr("&Next Text"), Qt::CTRL | Qt::Key_Tab))
    , previousTab(makeAction(window, tr("&Previous Text"), Qt::CTRL | Qt::SHIFT | Qt::Key_Tab))
    , quit(makeAction(window, tr("&Quit"), Qt::CTRL | Qt::Key_Q))
    , preferences(makeAction(window, tr("Pre&ferences…"), Qt::CTRL | Qt::Key_Comma))
    , fit(makeViewAction(viewport, tr("&Fit"), Qt::Key_F))
    , resetView(makeViewAction(viewport, tr("&Reset View"), Qt::Key_Home))
    , front(makeViewAction(viewport, tr("Fr&ont"), Qt::Key_1))
    , right(makeViewAction(viewport, tr("&Side"), Qt::Key_3))
    , top(makeViewAction(viewport, tr("&Top"), Qt::Key_7))
    , orthographic(makeViewAction(viewport, tr("Ort&hographic"), Qt::Key_5))
    , endless(makeViewAction(viewport, tr("&Endless"), Qt::Key_E))
    , pin(makeAction(window, tr("&Pin Picture"), Qt::CTRL | Qt::SHIFT | Qt::Key_I))
    , saveView(makeAction(window, tr("Sa&ve View in Text")))
    , rebuild(makeAction(window, tr("Re&build"), Qt::Key_F5))
    , trail(new QActionGroup(&window))
    , colouring(new QActionGroup(&window))
    , wireframe(makeAction(window, tr("&Wireframe")))
    , lighting(makeAction(window, tr("&Lighting")))
    , textures(makeAction(window, tr("&Textures")))
    , smooth(makeAction(window, tr("&Smooth Shading")))
    , axes(makeAction(window, tr("A&xes")))
    , zoomToCopy(makeViewAction(viewport, tr("&Zoom Into This Copy"), Qt::Key_Z))
    , collapse(makeViewAction(viewport, tr("Collapse to Here"), Qt::Key_C))
    , tools(new QActionGroup(&window))
    , measure(makeViewAction(viewport, tr("&Measure"), Qt::Key_M))
    , move(makeViewAction(viewport, tr("Mo&ve"), Qt::Key_G))
    , rotate(makeViewAction(viewport, tr("Rotat&e"), Qt::Key_R))
    , scale(makeViewAction(viewport, tr("Scale"), Qt::Key_T))
    , dropBalls(makeViewAction(viewport, tr("Drop &Balls"), Qt::Key_B))
    , copyMeasurement(makeAction(window, tr("Copy Meas&urement"), Qt::CTRL | Qt::ALT | Qt::Key_C))
    , nextPart(makeAction(window, tr("Next &Part"), Qt::Key_F7))
    , previousPart(makeAction(window, tr("Previous P&art"), Qt::SHIFT | Qt::Key_F7))
    , fullScreen(makeAction(window, tr("&Full Screen"), Qt::Key_F11))
    , resetLayout(makeAction(window, tr("&Reset Layout")))
    , keys(makeAction(window, tr("&Keys"), Qt::Key_F1))
    , about(makeAction(window, tr("&About Romanesco")))
{
    for (const QString &words : {tr("&Materials"), tr("&Depth"), tr("&Branch"), tr("S&et")}) {
        QAction *action = makeAction(window, words);
        action->setCheckable(true);
        colouring->addAction(action);
    }
    colouring->actions().first()->setChecked(true);
    for (QAction *action : {wireframe, lighting, textures, smooth}) {
        action->setCheckable(true);
        action->setChecked(action != wireframe);
    }
    const auto addTrail = [&](const QString &words, const QVariant &levels) {
        QAction *action = makeAction(window, words);
        action->setCheckable(true);
        action->setData(levels);
        trail->addAction(action);
    };
    addTrail(tr("&Off"), {});
    for (const int levels : {0, 1, 2, 3, 5, 8}) {
        addTrail(tr("Trail of &%1").arg(levels), levels);
    }
    trail->actions().first()->setChecked(true);
    zoomToCopy->setStatusTip(tr("Lets the copy that stands out fill the view"));
    collapse->setStatusTip(tr("Changes the depth in the text, so that the copy that stands out is of the last level"));
    collapse->setToolTip(
        tr("Changes the depth in the text, so that the copy that stands out is of the last level (C)"));
    tools->setExclusionPolicy(QActionGroup::ExclusionPolicy::ExclusiveOptional);
    for (QAction *tool : {measure, move, rotate, scale, dropBalls}) {
        tool->setCheckable(true);
        tools->addAction(tool);
    }
    measure->setStatusTip(tr("Clicks tell place, normal and address of the surface, and the distance between two"));
    move->setStatusTip(tr("Handles at what was clicked change its position in the text; with Shift finer"));
    rotate->setStatusTip(tr("Rings round what was clicked change its angles in the text; with Shift finer"));
    scale->setStatusTip(tr("Handles at what was clicked change its scale in the text; with Shift finer"));
    dropBalls->setStatusTip(tr("Each click lets a ball fall on what is clicked"));
    axes->setCheckable(true);
    axes->setStatusTip(tr("The world's axes in the corner; a click on one looks along it"));
    orthographic->setCheckable(true);
    endless->setCheckable(true);
    pin->setCheckable(true);
    pin->setStatusTip(tr("The picture stays that of this text while you edit others"));
    endless->setStatusTip(tr("Detail wherever the view leads, as if the depth had no end"));
    orthographic->setIconText(tr("Ortho"));
    fullScreen->setCheckable(true);
    exportMesh->setShortcuts({QKeySequence(Qt::CTRL | Qt::Key_E), QKeySequence(Qt::Key_F6)});
}

WindowActions::OpenMenus WindowActions::fill(QMenuBar &bar) const
{
    QMenu *file = bar.addMenu(tr("&File"));
    file->addAction(newFile);
    QMenu *templates = file->addMenu(tr("New From &Template"));
    file->addAction(open);
    QMenu *recent = file->addMenu(tr("Open &Recent"));
    file->addAction(examples);
    file->addSeparator();
    file->addActions({save, saveAs, reload});
    file->addSeparator();
    file->addAction(exportMesh);
    QAction *const end = file->addSeparator();
    file->addActions({closeTab, quit});

    QMenu *edit = bar.addMenu(tr("&Edit"));
    QMenu *view = bar.addMenu(tr("&View"));
    view->addActions({fit, resetView, zoomToCopy, collapse});
    view->addSeparator();
    view->addActions({front, right, top, orthographic});
    view->addSeparator();
    view->addActions({endless, pin, saveView, rebuild});
    view->addMenu(tr("&Dissertation's Zoom"))->addActions(trail->actions());
    view->addSeparator();
    view->addMenu(tr("&Colour By"))->addActions(colouring->actions());
    view->addActions({wireframe, lighting, textures, smooth});
    view->addSeparator();
    view->addAction(axes);
    view->addActions(tools->actions());
    view->addAction(copyMeasurement);
    view->addSeparator();

    QMenu *physics = bar.addMenu(tr("&Physics"));
    QMenu *go = bar.addMenu(tr("&Go"));

    QMenu *window = bar.addMenu(tr("&Window"));
    window->addActions({nextTab, previousTab, nextPart, previousPart});
    window->addSeparator();
    window->addActions({fullScreen, resetLayout});
    window->addSeparator();

    bar.addMenu(tr("&Help"))->addActions({keys, about});
    return {file, end, templates, recent, edit, go, view, physics, window};
}

void WindowActions::fill(QToolBar &bar, const TextActions &textActions) const
{
    // Words: they need no guessing.
    bar.setToolButtonStyle(Qt::ToolButtonTextOnly);
    bar.addActions({newFile, open, save});
    bar.addSeparator();
    textActions.fill(bar);
    bar.addSeparator();
    bar.addActions({fit, orthographic, endless});
    bar.addSeparator();
}

}
