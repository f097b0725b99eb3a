// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <memory>

#include <QMainWindow>

#include "core/text/sourcerange.h"
#include "document.h"
#include "editor/textnumber.h"
#include "previewcontroller.h"
#include "resourcefiles.h"
#include "windowactions.h"

class QDockWidget;
class QSplitter;

namespace romanesco {

class DepthControl;
class FdoEditor;
class MessageStrip;
class ProblemsView;
class StatusLine;
class Viewport;
class ViewportPane;

/// The editor: the text on the left, its picture on the right, what is wrong with it below. The text is the source of
/// all that is shown; controls edit the text.
class MainWindow : public QMainWindow
{
    Q_OBJECT
public:
    explicit MainWindow(QWidget *parent = nullptr);
    ~MainWindow() override;

    /// Asks first where changes would be lost. Where the file cannot be opened, the window says so, keeps the text it
    /// has, and the result is false.
    bool openFile(const QString &path);
    /// The fractal that the program starts with.
    void openExample();
    /// Writes the text to a file and goes on with that. Where this fails, the window says so.
    bool saveFile(const QString &path);

protected:
    void closeEvent(QCloseEvent *event) override;
    void dragEnterEvent(QDragEnterEvent *event) override;
    void dropEvent(QDropEvent *event) override;

private:
    void layOut();
    void createToolBar();
    void createMenus();
    void connectFileActions();
    void connectEditActions();
    void connectViewActions();
    void connectPreview();
    void restoreLayout();
    void saveLayout() const;

    bool openPath(const QString &path);
    bool save();
    bool saveAs();
    /// Whether the text may go: it is saved, or need not be.
    [[nodiscard]] bool mayDropText();
    void takeFilesAlong(const QString &textPath);

    void startText();
    void build();
    void showDiagnostics(const Diagnostics &diagnostics, const TextSnapshot &text);
    void showPreview(const Preview &preview);
    void showTrouble();
    void showCursorPlace();
    void updateTitle();
    void updateDepth();
    void changeAppearance();
    void saveView();
    void showAddress();
    void goTo(SourceRange range, const TextSnapshot &text);
    void goToFile(const QString &file, TextPosition position);
    void setFullScreen(bool isFull);
    void showAbout();

    ResourceFiles m_files;
    FdoEditor *m_editor;
    MessageStrip *m_message;
    ViewportPane *m_pane;
    Viewport &m_viewport;
    ProblemsView *m_problems;
    QDockWidget *m_problemsDock;
    QSplitter *m_splitter;
    DepthControl *m_depthControl;
    StatusLine *m_status;
    WindowActions m_actions;

    Document m_document;
    TextNumber m_depth;
    PreviewController m_preview;
    /// Of the newest text, for the strip: what is wrong and where; what is wrong with its picture.
    QString m_textTrouble;
    SourceRange m_troublePlace;
    TextSnapshot m_troubleText;
    QString m_pictureTrouble;
    QString m_pictureRemark;
    bool m_isShownEndless = false;
    /// The next scene is the first of its file.
    bool m_isFirstScene = true;
    QString m_graphicsSystem;
};

}
