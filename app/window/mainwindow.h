// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <memory>

#include <QMainWindow>

#include "core/text/sourcerange.h"
#include "core/text/textposition.h"
#include "editor/textsnapshot.h"
#include "panels.h"
#include "physicsactions.h"
#include "textactions.h"
#include "windowactions.h"
#include "windowlayout.h"

class QSplitter;

namespace romanesco {

class AddressLink;
class DepthControl;
class FileMenu;
class MeasureController;
class PhysicsController;
class StatusLine;
class TextTab;
class TextTabs;
class ViewTools;
class Viewport;
class ViewportPane;

/// The editor: texts on the left, the picture of the one that is looked at on the right, what is wrong with it below. The
/// text is the source of all that is shown; controls edit the text.
class MainWindow : public QMainWindow
{
    Q_OBJECT
public:
    explicit MainWindow(QWidget *parent = nullptr);
    ~MainWindow() override;

    /// Where the file cannot be opened, the window says so, and the result is false.
    bool openFile(const QString &path);
    /// The fractal that the program starts with.
    void openExample();
    /// What was open when the program ended last; false where that was nothing, or the user would rather not.
    bool openSession();
    /// See FileMenu.
    void offerLostTexts();
    /// Writes the text to a file and goes on with that. Where this fails, the window says so.
    bool saveFile(const QString &path);

protected:
    void changeEvent(QEvent *event) override;
    void closeEvent(QCloseEvent *event) override;
    void dragEnterEvent(QDragEnterEvent *event) override;
    void dropEvent(QDropEvent *event) override;

private:
    void layOut();
    void createToolBar();
    void createMenus();
    void connectTexts();
    void connectPanels();
    void connectViewActions();
    void connectViewport();
    void takeTab();
    void connectText(TextTab &tab);
    void connectPicture(TextTab &tab);
    void showText();
    void showScene();
    void showPreview();
    void showEndless();
    void showProblems();
    void showTrouble();
    void followTrouble();
    void showCursorPlace();
    void showDepth();
    void showTitle();
    void rebuild();
    void saveView();
    void goTo(SourceRange range, const TextSnapshot &text);
    bool openBeside(const QString &file);
    void goToFile(const QString &file, TextPosition position);
    void setFullScreen(bool isFull);
    void showPreferences();
    /// The one that is looked at, and the one whose picture is.
    [[nodiscard]] TextTab &tab() const { return *m_tab; }
    [[nodiscard]] TextTab &seen() const { return *m_seen; }

    TextTabs *m_tabs;
    ViewportPane *m_pane;
    Viewport &m_viewport;
    Panels m_panels;
    AddressLink *m_addressLink;
    QSplitter *m_splitter;
    WindowLayout m_layout;
    DepthControl *m_depthControl;
    StatusLine *m_status;
    WindowActions m_actions;
    TextActions m_textActions;
    ViewTools *m_viewTools;
    PhysicsActions m_physicsActions;
    PhysicsController *m_physics;
    MeasureController *m_measure;
    FileMenu *m_files;

    TextTab *m_tab = nullptr;
    TextTab *m_seen = nullptr;
    /// Live as long as these are looked at, for what is connected to them.
    std::unique_ptr<QObject> m_whileLooked;
    std::unique_ptr<QObject> m_whileSeen;
    QString m_pictureTrouble;
    QString m_graphicsSystem;
};

}
