// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#include "viewcontrols.h"

#include <QActionGroup>
#include <QMenu>

#include "axestripod.h"
#include "qualitycontrol.h"
#include "viewport.h"
#include "viewportpane.h"
#include "windowactions.h"
#include "windowstate.h"

namespace romanesco {

namespace {

void changeAppearance(const WindowActions &actions, Viewport &viewport)
{
    Appearance appearance = viewport.appearance();
    // In the order of the enumeration.
    const auto chosen = actions.colouring->actions().indexOf(actions.colouring->checkedAction());
    appearance.colours.colouring = static_cast<Colouring>(chosen);
    appearance.hasWires = actions.wireframe->isChecked();
    appearance.isLit = actions.lighting->isChecked();
    appearance.hasTextures = actions.textures->isChecked();
    appearance.isSmooth = actions.smooth->isChecked();
    viewport.setAppearance(appearance);
}

void openMenu(const WindowActions &actions, Viewport &viewport, const QPoint &globalPlace)
{
    auto *menu = new QMenu(&viewport);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    menu->setToolTipsVisible(true);
    menu->addActions({actions.zoomToCopy, actions.collapse});
    menu->addSeparator();
    menu->addActions({actions.fit, actions.resetView});
    menu->addSeparator();
    menu->addActions(actions.tools->actions());
    menu->addAction(actions.copyMeasurement);
    menu->popup(globalPlace);
}

}

void connectViewControls(const WindowActions &actions, ViewportPane &pane)
{
    Viewport &viewport = pane.viewport();
    const auto onTrigger = [&viewport](const QAction *action, auto act) {
        QObject::connect(action, &QAction::triggered, &viewport, act);
    };
    using Side = Viewport::Side;
    onTrigger(actions.fit, [&viewport] { viewport.fit(); });
    onTrigger(actions.resetView, [&viewport] { viewport.resetView(); });
    onTrigger(actions.front, [&viewport] { viewport.lookFrom(Side::Front); });
    onTrigger(actions.right, [&viewport] { viewport.lookFrom(Side::Right); });
    onTrigger(actions.top, [&viewport] { viewport.lookFrom(Side::Top); });

    QObject::connect(actions.trail, &QActionGroup::triggered, &viewport, [&viewport](const QAction *action) {
        const QVariant levels = action->data();
        viewport.setTrail(levels.isValid() ? std::optional<std::size_t>(levels.toUInt()) : std::nullopt);
    });

    const auto change = [actions, &viewport] { changeAppearance(actions, viewport); };
    QObject::connect(actions.colouring, &QActionGroup::triggered, &viewport, change);
    for (const QAction *action : {actions.wireframe, actions.lighting, actions.textures, actions.smooth}) {
        QObject::connect(action, &QAction::toggled, &viewport, change);
    }

    QObject::connect(&viewport, &Viewport::menuRequested, &viewport,
                     [actions, &viewport](const QPoint &place) { openMenu(actions, viewport, place); });

    AxesTripod &axes = pane.axes();
    actions.axes->setChecked(WindowState().value("axes", true).toBool());
    axes.setVisible(actions.axes->isChecked());
    QObject::connect(actions.axes, &QAction::toggled, &axes, [&axes](bool areShown) {
        axes.setVisible(areShown);
        WindowState().setValue("axes", areShown);
    });

    QualityControl &quality = pane.quality();
    QObject::connect(&quality, &QualityControl::toleranceChanged, &viewport, [&viewport](double pixels) {
        viewport.setPixelTolerance(pixels);
        WindowState().setValue("pixelTolerance", pixels);
    });
    QObject::connect(&viewport, &Viewport::viewMoved, &quality,
                     [&quality, &viewport] { quality.setShift(viewport.shiftOfTolerance()); });
    quality.setTolerance(WindowState().value("pixelTolerance", 1.0).toDouble());
    pane.addTools(actions.tools->actions());

    QObject::connect(actions.orthographic, &QAction::toggled, &viewport, [&viewport](bool isOrthographic) {
        viewport.setProjection(isOrthographic ? Projection::Orthographic : Projection::Perspective);
    });
    QObject::connect(
        &viewport, &Viewport::projectionChanged, actions.orthographic,
        [action = actions.orthographic](Projection now) { action->setChecked(now == Projection::Orthographic); });
}

}
