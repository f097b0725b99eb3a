// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#include "mainwindow.h"

#include <algorithm>
#include <utility>

#include <QActionGroup>
#include <QApplication>
#include <QCloseEvent>
#include <QDir>
#include <QDockWidget>
#include <QFileDialog>
#include <QMenu>
#include <QMenuBar>
#include <QMessageBox>
#include <QMimeData>
#include <QSaveFile>
#include <QSet>
#include <QSettings>
#include <QSplitter>
#include <QTextBlock>
#include <QToolBar>
#include <QVBoxLayout>

#include "addresswords.h"
#include "core/text/linemap.h"
#include "depthcontrol.h"
#include "editor/fdoeditor.h"
#include "messagestrip.h"
#include "problemsview.h"
#include "statusline.h"
#include "viewport.h"
#include "viewportpane.h"

namespace romanesco {

namespace {

const QString examplesFolder = QStringLiteral(":/examples");

/// Window sizes and such are state, not settings (XDG Base Directory 0.8).
QString stateFile()
{
    QString folder = qEnvironmentVariable("XDG_STATE_HOME");
    if (folder.isEmpty()) {
        folder = QDir::home().filePath(QStringLiteral(".local/state"));
    }
    return folder + QStringLiteral("/romanesco/window.ini");
}

QString fileFilter()
{
    return MainWindow::tr("Fractals and scenes (*.fdo *.sdo);;Fractals (*.fdo);;Scenes (*.sdo);;Meshes (*.obj);;"
                          "All files (*)");
}

}

MainWindow::MainWindow(QWidget *parent)
    : QMainWindow(parent)
    , m_editor(new FdoEditor)
    , m_message(new MessageStrip(MessageStrip::Closing::ByUser))
    , m_pane(new ViewportPane)
    , m_viewport(m_pane->viewport())
    , m_problems(new ProblemsView)
    , m_problemsDock(new QDockWidget(tr("Problems"), this))
    , m_splitter(new QSplitter)
    , m_depthControl(new DepthControl)
    , m_status(new StatusLine)
    , m_actions(*this, m_viewport)
    , m_document(*m_editor, m_files)
    , m_depth(*m_editor)
    , m_preview(std::make_unique<ResourceFiles>())
{
    layOut();
    createToolBar();
    createMenus();
    connectFileActions();
    connectEditActions();
    connectViewActions();
    connectPreview();
    setAcceptDrops(true);
    restoreLayout();
    showCursorPlace();
    updateTitle();
    m_editor->setFocus();
}

MainWindow::~MainWindow() = default;

// ---- Building the window

void MainWindow::layOut()
{
    auto *textSide = new QWidget;
    auto *column = new QVBoxLayout(textSide);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(m_message);
    column->addWidget(m_editor, 1);

    m_splitter->addWidget(textSide);
    m_splitter->addWidget(m_pane);
    m_splitter->setChildrenCollapsible(false);
    // The picture takes what a larger window gives.
    m_splitter->setStretchFactor(1, 1);
    setCentralWidget(m_splitter);

    m_problemsDock->setObjectName(QStringLiteral("problems"));
    m_problemsDock->setWidget(m_problems);
    addDockWidget(Qt::BottomDockWidgetArea, m_problemsDock);
    setStatusBar(m_status);
}

void MainWindow::createToolBar()
{
    QToolBar *bar = addToolBar(tr("Tools"));
    bar->setObjectName(QStringLiteral("tools"));
    bar->setMovable(false);
    m_actions.fill(*bar);
    bar->addWidget(m_depthControl);
}

void MainWindow::createMenus()
{
    const WindowActions::OpenMenus menus = m_actions.fill(*menuBar());
    const QStringList kinds{QStringLiteral("*.fdo"), QStringLiteral("*.sdo")};
    for (const QString &name : QDir(examplesFolder).entryList(kinds, QDir::Files, QDir::Name)) {
        const QString plain = name.chopped(4);
        QAction *action =
            menus.examples->addAction(name.endsWith(QLatin1String(".sdo")) ? tr("%1 (scene)").arg(plain) : plain);
        connect(action, &QAction::triggered, this, [this, name] { openFile(examplesFolder + u'/' + name); });
    }
    menus.window->addAction(m_problemsDock->toggleViewAction());
}

void MainWindow::connectFileActions()
{
    connect(m_actions.newFile, &QAction::triggered, this, [this] {
        if (mayDropText()) {
            m_document.startNew();
        }
    });
    connect(m_actions.open, &QAction::triggered, this, [this] {
        const QString folder = m_document.hasOwnFile() ? QFileInfo(m_document.path()).path() : QString();
        const QString path = QFileDialog::getOpenFileName(this, tr("Open"), folder, fileFilter());
        if (!path.isEmpty()) {
            openFile(path);
        }
    });
    connect(m_actions.save, &QAction::triggered, this, &MainWindow::save);
    connect(m_actions.saveAs, &QAction::triggered, this, &MainWindow::saveAs);
    connect(m_actions.quit, &QAction::triggered, this, &QWidget::close);
    connect(&m_document, &Document::nameChanged, this, &MainWindow::updateTitle);
    connect(&m_document, &Document::modifiedChanged, this, &QWidget::setWindowModified);
}

void MainWindow::connectEditActions()
{
    connect(m_actions.undo, &QAction::triggered, m_editor, &QPlainTextEdit::undo);
    connect(m_actions.redo, &QAction::triggered, m_editor, &QPlainTextEdit::redo);
    connect(m_actions.cut, &QAction::triggered, m_editor, &QPlainTextEdit::cut);
    connect(m_actions.copy, &QAction::triggered, m_editor, &QPlainTextEdit::copy);
    connect(m_actions.paste, &QAction::triggered, m_editor, &QPlainTextEdit::paste);
    connect(m_actions.selectAll, &QAction::triggered, m_editor, &QPlainTextEdit::selectAll);
    connect(m_actions.nextProblem, &QAction::triggered, m_editor, &FdoEditor::goToNextProblem);
    connect(m_editor, &QPlainTextEdit::undoAvailable, m_actions.undo, &QAction::setEnabled);
    connect(m_editor, &QPlainTextEdit::redoAvailable, m_actions.redo, &QAction::setEnabled);
    connect(m_editor, &QPlainTextEdit::copyAvailable, m_actions.cut, &QAction::setEnabled);
    connect(m_editor, &QPlainTextEdit::copyAvailable, m_actions.copy, &QAction::setEnabled);
    for (QAction *action : {m_actions.undo, m_actions.redo, m_actions.cut, m_actions.copy}) {
        action->setEnabled(false);
    }
    connect(m_editor, &QPlainTextEdit::cursorPositionChanged, this, &MainWindow::showCursorPlace);
    connect(m_problems, &ProblemsView::chosen, this, &MainWindow::goTo);
    connect(m_problems, &ProblemsView::chosenElsewhere, this, &MainWindow::goToFile);

    connect(m_depthControl, &DepthControl::depthEdited, this, [this](quint64 depth) { m_depth.setValue(depth); });
    connect(m_depthControl, &DepthControl::dragBegan, this, [this] { m_depth.beginGesture(); });
    connect(m_depthControl, &DepthControl::dragEnded, this, [this] {
        m_depth.endGesture();
        updateDepth();
    });
}

void MainWindow::changeAppearance()
{
    Appearance appearance = m_viewport.appearance();
    // In the order of the enumeration.
    const auto chosen = m_actions.colouring->actions().indexOf(m_actions.colouring->checkedAction());
    appearance.colours.colouring = static_cast<Colouring>(chosen);
    appearance.hasWires = m_actions.wireframe->isChecked();
    appearance.isLit = m_actions.lighting->isChecked();
    appearance.hasTextures = m_actions.textures->isChecked();
    appearance.isSmooth = m_actions.smooth->isChecked();
    m_viewport.setAppearance(appearance);
}

void MainWindow::connectViewActions()
{
    connect(m_actions.endless, &QAction::toggled, this, [this](bool isEndless) {
        m_preview.setEndless(isEndless);
        build();
    });
    connect(&m_viewport, &Viewport::clicked, this, &MainWindow::showAddress);
    connect(m_actions.trail, &QActionGroup::triggered, this, [this](const QAction *action) {
        const QVariant levels = action->data();
        m_viewport.setTrail(levels.isValid() ? std::optional<std::size_t>(levels.toUInt()) : std::nullopt);
    });
    connect(m_actions.saveView, &QAction::triggered, this, &MainWindow::saveView);
    connect(m_actions.fit, &QAction::triggered, &m_viewport, &Viewport::fit);
    connect(m_actions.resetView, &QAction::triggered, &m_viewport, &Viewport::resetView);
    using Side = Viewport::Side;
    connect(m_actions.front, &QAction::triggered, this, [this] { m_viewport.lookFrom(Side::Front); });
    connect(m_actions.right, &QAction::triggered, this, [this] { m_viewport.lookFrom(Side::Right); });
    connect(m_actions.top, &QAction::triggered, this, [this] { m_viewport.lookFrom(Side::Top); });
    connect(m_actions.colouring, &QActionGroup::triggered, this, &MainWindow::changeAppearance);
    for (QAction *action : {m_actions.wireframe, m_actions.lighting, m_actions.textures, m_actions.smooth}) {
        connect(action, &QAction::toggled, this, &MainWindow::changeAppearance);
    }
    connect(m_actions.orthographic, &QAction::toggled, this, [this](bool isOrthographic) {
        m_viewport.setProjection(isOrthographic ? Projection::Orthographic : Projection::Perspective);
    });
    connect(&m_viewport, &Viewport::projectionChanged, this, [this](Projection projection) {
        m_actions.orthographic->setChecked(projection == Projection::Orthographic);
    });
    connect(m_actions.largerText, &QAction::triggered, this, [this] { m_editor->zoomBy(1); });
    connect(m_actions.smallerText, &QAction::triggered, this, [this] { m_editor->zoomBy(-1); });
    connect(m_actions.usualText, &QAction::triggered, m_editor, &FdoEditor::resetZoom);
    connect(m_actions.fullScreen, &QAction::toggled, this, &MainWindow::setFullScreen);
    connect(m_actions.about, &QAction::triggered, this, &MainWindow::showAbout);
}

void MainWindow::connectPreview()
{
    connect(&m_document, &Document::replaced, this, &MainWindow::startText);
    connect(&m_document, &Document::textChanged, this, &MainWindow::build);
    connect(&m_preview, &PreviewController::built, this, &MainWindow::showPreview);
    connect(&m_preview, &PreviewController::counted, m_status, &StatusLine::setSummary);
    connect(&m_viewport, &Viewport::pictureAdvanced, m_status, &StatusLine::setDrawn);
    connect(&m_viewport, &Viewport::ready, this, [this](const QString &system) { m_graphicsSystem = system; });
    connect(&m_viewport, &Viewport::pictureFailed, this, [this](const QString &reason) {
        if (reason != m_pictureTrouble) {
            m_pictureTrouble = reason;
            showTrouble();
        }
    });
    connect(&m_pane->strip(), &MessageStrip::followed, this, [this] { goTo(m_troublePlace, m_troubleText); });
}

void MainWindow::restoreLayout()
{
    const QSettings state(stateFile(), QSettings::IniFormat);
    if (!restoreGeometry(state.value("geometry").toByteArray())) {
        resize(1280, 800);
    }
    if (!restoreState(state.value("docks").toByteArray())) {
        resizeDocks({m_problemsDock}, {120}, Qt::Vertical);
    }
    if (!m_splitter->restoreState(state.value("splitter").toByteArray())) {
        m_splitter->setSizes({500, 780});
    }
}

void MainWindow::saveLayout() const
{
    QSettings state(stateFile(), QSettings::IniFormat);
    state.setValue("geometry", saveGeometry());
    state.setValue("docks", saveState());
    state.setValue("splitter", m_splitter->saveState());
}

// ---- Files

bool MainWindow::openFile(const QString &path)
{
    return mayDropText() && openPath(path);
}

void MainWindow::openExample()
{
    openPath(examplesFolder + QStringLiteral("/romanesco.fdo"));
}

bool MainWindow::openPath(const QString &path)
{
    const bool isOurs = path.startsWith(examplesFolder);
    const QString whole = isOurs ? path : QFileInfo(path).absoluteFilePath();
    if (const auto opened = m_document.open(whole); !opened) {
        m_message->say(tr("Cannot open “%1”: %2.").arg(QDir::toNativeSeparators(path), opened.error()));
        return false;
    }
    if (m_editor->isReadOnly()) {
        m_message->say(tr("“%1” holds characters that would be lost by saving, so it can only be read here. "
                          "Save As makes a copy that can be edited.")
                           .arg(m_document.name()));
    } else if (!isOurs) {
        m_message->fallSilent();
    }
    return true;
}

bool MainWindow::save()
{
    return m_document.hasOwnFile() ? saveFile(m_document.path()) : saveAs();
}

bool MainWindow::saveAs()
{
    QString proposal = m_document.name();
    if (!m_document.path().isEmpty() && !m_document.isExample()) {
        proposal = m_document.path();
    }
    QFileDialog dialog(this, tr("Save As"), QString(), fileFilter());
    dialog.setAcceptMode(QFileDialog::AcceptSave);
    dialog.setDefaultSuffix(QFileInfo(proposal).suffix());
    dialog.selectFile(proposal);
    return dialog.exec() == QDialog::Accepted && saveFile(dialog.selectedFiles().constFirst());
}

bool MainWindow::saveFile(const QString &path)
{
    const bool wasExample = m_document.isExample();
    const QString whole = QFileInfo(path).absoluteFilePath();
    if (wasExample) {
        takeFilesAlong(whole);
    }
    if (const auto saved = m_document.saveAs(whole); !saved) {
        m_message->say(tr("Cannot save “%1”: %2. The text is still here, unsaved.").arg(path, saved.error()));
        return false;
    }
    m_message->fallSilent();
    m_status->showMessage(tr("Saved %1").arg(QDir::toNativeSeparators(path)), 3000);
    return true;
}

/// An example names files beside it. A copy of the example would not find them, so they are copied too, unless a file of
/// that name is there.
void MainWindow::takeFilesAlong(const QString &textPath)
{
    QSet<QString> names;
    if (const std::shared_ptr<const Scene> &scene = m_preview.lastGoodScene()) {
        for (const SceneItem &item : scene->items) {
            names << QString::fromStdString(item.path) << QString::fromStdString(item.model->meshPath);
        }
    }
    for (const QString &name : names) {
        const QString target = QFileInfo(textPath).dir().filePath(name);
        QFile source(examplesFolder + u'/' + name);
        if (name.isEmpty() || name.contains(u'/') || QFileInfo::exists(target) || !source.open(QIODevice::ReadOnly)) {
            continue;
        }
        // Should this fail, the text says that a file is missing.
        QSaveFile copy(target);
        if (copy.open(QIODevice::WriteOnly)) {
            copy.write(source.readAll());
            copy.commit();
        }
    }
}

bool MainWindow::mayDropText()
{
    if (!m_document.isModified()) {
        return true;
    }
    const auto answer = QMessageBox::warning(
        this, tr("Unsaved changes"), tr("“%1” has changes that are not saved.").arg(m_document.name()),
        QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, QMessageBox::Save);
    return answer == QMessageBox::Discard || (answer == QMessageBox::Save && save());
}

void MainWindow::closeEvent(QCloseEvent *event)
{
    if (!mayDropText()) {
        event->ignore();
        return;
    }
    saveLayout();
    event->accept();
}

void MainWindow::dragEnterEvent(QDragEnterEvent *event)
{
    const QList<QUrl> urls = event->mimeData()->urls();
    if (!urls.isEmpty() && urls.first().isLocalFile()) {
        event->acceptProposedAction();
    }
}

void MainWindow::dropEvent(QDropEvent *event)
{
    event->acceptProposedAction();
    openFile(event->mimeData()->urls().first().toLocalFile());
}

// ---- Text and picture

void MainWindow::startText()
{
    // Nothing of the old text stays: its places mean nothing in this one.
    m_preview.forget();
    showDiagnostics({}, m_document.text());
    m_textTrouble.clear();
    m_pictureRemark.clear();
    showTrouble();
    m_depth.clear();
    m_isFirstScene = true;
    const QSignalBlocker blocker(m_actions.endless); // what is asked for is asked of one file
    m_actions.endless->setChecked(false);
    m_preview.setEndless(false);
    m_viewport.setScene(nullptr);
    m_status->setSummary(std::nullopt);
    m_status->clearDrawn();
    updateDepth();
}

void MainWindow::build()
{
    m_preview.build(m_document.scenePath(), m_document.text());
}

void MainWindow::showDiagnostics(const Diagnostics &diagnostics, const TextSnapshot &text)
{
    m_editor->setDiagnostics(diagnostics, text);
    m_problems->setDiagnostics(m_document.name(), diagnostics, text);
    const QString counts = m_problems->counts();
    m_problemsDock->setWindowTitle(counts.isEmpty() ? tr("Problems") : tr("Problems — %1").arg(counts));
    m_problemsDock->toggleViewAction()->setText(tr("Problems"));
}

/// Of the copy that stands out.
void MainWindow::showAddress()
{
    const std::optional<Selection> &selection = m_viewport.appearance().colours.selection;
    const auto &surroundings = m_viewport.view().surroundings();
    if (!selection || !surroundings) {
        m_status->clearMessage();
        return;
    }
    const DepthChange depth(m_files, m_isShownEndless ? DepthChange::endless : "");
    m_status->showMessage(addressWords(*surroundings->scene, *selection, depth.changed(m_document.text().bytes())));
}

/// As a line of the text.
void MainWindow::saveView()
{
    const SceneView &seen = m_viewport.view();
    if (m_editor->isReadOnly() || !seen.surroundings()) {
        return;
    }
    SavedView view = seen.saved();
    view.isEndless = m_isShownEndless;
    const TextSnapshot text = m_editor->snapshot();
    const bool isSdo = fileKind(m_document.scenePath()) == FileKind::Sdo;
    m_editor->apply(editsToSave(view, writtenOf(seen.cameraInWorld()), text.bytes(), isSdo), text);
}

void MainWindow::showPreview(const Preview &preview)
{
    showDiagnostics(preview.diagnostics, preview.text);
    const bool wantsEndless = m_isFirstScene && preview.scene && preview.scene->view && preview.scene->view->isEndless;
    if (wantsEndless && !m_preview.isEndless()) {
        m_actions.endless->setChecked(true);
        return; // the preview that follows
    }
    if (preview.scene) {
        if (preview.scene->depth) {
            const SourceRange place = preview.scene->depth->range;
            m_depth.track(preview.text.position(place.begin), preview.text.position(place.end));
        } else {
            m_depth.clear();
        }
        m_viewport.setScene(preview.shown);
        m_isShownEndless = preview.shown != preview.scene;
        if (std::exchange(m_isFirstScene, false)) {
            m_viewport.resetView();
        }
    }
    updateDepth();

    m_pictureRemark = preview.remark;
    m_textTrouble = preview.failure;
    const auto error = std::ranges::find_if(preview.diagnostics, &Diagnostic::isError);
    if (error != preview.diagnostics.end()) {
        m_troublePlace = error->range;
        m_troubleText = preview.text;
        const std::size_t line = LineMap(preview.text.bytes()).position(error->range.begin).line;
        m_textTrouble = tr("line %1: %2").arg(line).arg(QString::fromStdString(error->message()));
    }
    showTrouble();
}

void MainWindow::showTrouble()
{
    MessageStrip &strip = m_pane->strip();
    if (!m_textTrouble.isEmpty()) {
        const bool showsLast = m_preview.lastGoodScene() != nullptr;
        strip.say((showsLast ? tr("Showing the last good version — %1") : tr("No picture yet — %1")).arg(m_textTrouble),
                  true);
    } else if (!m_pictureTrouble.isEmpty()) {
        strip.say(m_pictureTrouble);
    } else if (!m_pictureRemark.isEmpty()) {
        strip.say(m_pictureRemark);
    } else {
        strip.fallSilent();
    }
}

void MainWindow::updateDepth()
{
    const std::optional<quint64> depth = m_depth.value();
    m_depthControl->setDepth(m_editor->isReadOnly() ? std::nullopt : depth);
    m_status->setDepth(depth);
}

void MainWindow::showCursorPlace()
{
    // Columns count characters, as in messages.
    const QTextCursor cursor = m_editor->textCursor();
    const QString before = cursor.block().text().first(cursor.positionInBlock());
    m_status->setCursorPlace(cursor.blockNumber() + 1, static_cast<int>(before.toUcs4().size()) + 1);
}

void MainWindow::updateTitle()
{
    setWindowTitle(tr("%1[*] — Romanesco").arg(m_document.name()));
    setWindowModified(m_document.isModified());
}

void MainWindow::goTo(SourceRange range, const TextSnapshot &text)
{
    m_editor->goTo(range, text);
}

/// file is named as in the text.
void MainWindow::goToFile(const QString &file, TextPosition position)
{
    if (openFile(QFileInfo(m_document.path()).dir().filePath(file))) {
        const std::size_t offset = LineMap(m_document.text().bytes()).offset(position);
        goTo({offset, offset}, m_document.text());
    }
}

void MainWindow::setFullScreen(bool isFull)
{
    setWindowState(isFull ? windowState() | Qt::WindowFullScreen : windowState() & ~Qt::WindowFullScreen);
}

void MainWindow::showAbout()
{
    const QString graphics = m_graphicsSystem.isEmpty() ? tr("no OpenGL") : m_graphicsSystem;
    auto *box = new QMessageBox(QMessageBox::NoIcon, tr("About Romanesco"),
                                tr("Romanesco %1\n\nAn editor for fractals.\n\nQt %2\n%3")
                                    .arg(QCoreApplication::applicationVersion(), QLatin1String(qVersion()), graphics),
                                QMessageBox::Close, this);
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->setModal(false);
    box->show();
}

}
