// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <QCoreApplication>

class QAction;
class QActionGroup;
class QMenu;
class QMenuBar;
class QToolBar;
class QWidget;

namespace romanesco {

class TextActions;

/// All that menus and tool bar offer, with words and keys; what they do is the window's to connect. Owned by the window.
struct WindowActions {
    Q_DECLARE_TR_FUNCTIONS(WindowActions)
public:
    /// viewport is the widget whose keys (F, Home, E, 1, 3, 7, 5, Z, C, M, G, R, T, B) work only while it has the focus.
    WindowActions(QWidget &window, QWidget &viewport);

    /// Returns the menus that the window adds to.
    struct OpenMenus {
        QMenu *file;
        /// Of what has to do with files, before closing.
        QAction *endOfFiles;
        QMenu *templates;
        QMenu *recent;
        QMenu *edit;
        QMenu *go;
        QMenu *view;
        QMenu *physics;
        QMenu *window;
    };
    OpenMenus fill(QMenuBar &bar) const;
    void fill(QToolBar &bar, const TextActions &textActions) const;

    QAction *newFile;
    QAction *open;
    QAction *examples;
    QAction *save;
    QAction *saveAs;
    QAction *reload;
    QAction *exportMesh;
    QAction *saveTurntable;
    QAction *closeTab;
    QAction *nextTab;
    QAction *previousTab;
    QAction *quit;

    QAction *preferences;

    QAction *fit;
    QAction *resetView;
    QAction *front;
    QAction *right;
    QAction *top;
    QAction *orthographic;
    QAction *endless;
    QAction *pin;
    QAction *saveView;
    QAction *rebuild;
    /// One of them is checked; its data is a number of levels, or none where it is off.
    QActionGroup *trail;
    /// One of them is checked: materials, depth, branch, set.
    QActionGroup *colouring;
    QAction *wireframe;
    QAction *lighting;
    QAction *textures;
    QAction *smooth;
    QAction *axes;
    /// Of the copy that stands out.
    QAction *zoomToCopy;
    QAction *collapse;
    /// Of these one is checked, or none.
    QActionGroup *tools;
    QAction *measure;
    QAction *move;
    QAction *rotate;
    QAction *scale;
    QAction *dropBalls;
    QAction *copyMeasurement;

    QAction *nextPart;
    QAction *previousPart;
    QAction *fullScreen;
    QAction *resetLayout;
    QAction *keys;
    QAction *about;
};

}
