// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <memory>

#include <QObject>

#include "backgroundtask.h"
#include "picture.h"
#include "recovery.h"
#include "resourcefiles.h"
#include "windowactions.h"

class QMainWindow;

namespace romanesco {

class TextTab;
class TextTabs;
class Viewport;

/// What the menu of files does: texts, examples and templates, and what is made of them as files: pictures, turntables,
/// meshes. For the GUI thread.
class FileMenu : public QObject
{
    Q_OBJECT
public:
    /// window owns it; all must outlive it.
    FileMenu(const WindowActions &actions, TextTabs &tabs, Viewport &viewport, QMainWindow &window);

    void fill(const WindowActions::OpenMenus &menus);
    /// Looks in the background for texts that were not saved when the program ended last, and offers them.
    void offerLostTexts();

Q_SIGNALS:
    /// What has been done, for so many milliseconds.
    void told(const QString &words, int milliseconds);

private:
    void connectActions();
    void connectPictures();
    void fillRecent(QMenu &menu);
    void askForFile();
    void showExamples();
    void showLostTexts(Recovery recovery);
    void exportMesh();
    void saveTurntable();
    /// The one that is looked at.
    [[nodiscard]] TextTab &tab() const;

    const WindowActions &m_actions;
    TextTabs &m_tabs;
    Viewport &m_viewport;
    QMainWindow &m_window;
    PictureActions m_pictures;
    ResourceFiles m_files;
    /// Last: it uses the rest.
    BackgroundTask<std::shared_ptr<Recovery>> m_lostTexts;
};

}
