// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#include "mainwindow.h"

#include <QCloseEvent>
#include <QDir>
#include <QFileInfo>
#include <QMenuBar>
#include <QMimeData>
#include <QSplitter>
#include <QTextBlock>
#include <QToolBar>

#include "aboutbox.h"
#include "addresslink.h"
#include "core/text/linemap.h"
#include "depthcontrol.h"
#include "editor/fdoeditor.h"
#include "filemenu.h"
#include "keylist.h"
#include "measurecontroller.h"
#include "messagestrip.h"
#include "outlinepane.h"
#include "parameterspane.h"
#include "physicschoices.h"
#include "physicscontroller.h"
#include "physicspane.h"
#include "preferencesdialog.h"
#include "problemsview.h"
#include "scenedrop.h"
#include "statusline.h"
#include "texttab.h"
#include "texttabs.h"
#include "viewcontrols.h"
#include "viewport.h"
#include "viewportpane.h"
#include "viewtools.h"

namespace romanesco {

MainWindow::MainWindow(QWidget *parent)
    : QMainWindow(parent)
    , m_tabs(new TextTabs)
    , m_pane(new ViewportPane)
    , m_viewport(m_pane->viewport())
    , m_panels(*this)
    , m_addressLink(new AddressLink(m_panels.address(), m_viewport, this))
    , m_splitter(new QSplitter)
    , m_layout(*this, *m_splitter, m_panels)
    , m_depthControl(new DepthControl(tr("Depth")))
    , m_status(new StatusLine)
    , m_actions(*this, m_viewport)
    , m_textActions(*this)
    , m_viewTools(new ViewTools(m_actions, *m_pane, this))
    , m_physicsActions(*this, m_viewport)
    , m_physics(new PhysicsController(m_physicsActions, m_panels.physics(), m_viewport, m_viewTools->dropper(), *this))
    , m_measure(
          new MeasureController(m_panels.measure(), *m_physics, m_panels.physics().choices(), m_pane->quality(), *this))
    , m_files(new FileMenu(m_actions, *m_tabs, m_viewport, *this))
{
    layOut();
    createToolBar();
    createMenus();
    connectTexts();
    connectPanels();
    connectViewActions();
    connectViewport();
    setAcceptDrops(true);
    m_layout.restore();
    takeTab();
    tab().editor().setFocus();
}

MainWindow::~MainWindow() = default;

// ---- Building the window

void MainWindow::layOut()
{
    m_splitter->addWidget(m_tabs);
    m_splitter->addWidget(m_pane);
    m_splitter->setChildrenCollapsible(false);
    // The picture takes what a larger window gives.
    m_splitter->setStretchFactor(1, 1);
    setCentralWidget(m_splitter);
    setStatusBar(m_status);
}

void MainWindow::createToolBar()
{
    QToolBar *bar = addToolBar(tr("Tools"));
    bar->setObjectName(QStringLiteral("tools"));
    bar->setMovable(false);
    m_actions.fill(*bar, m_textActions);
    bar->addWidget(m_depthControl);
}

void MainWindow::createMenus()
{
    const WindowActions::OpenMenus menus = m_actions.fill(*menuBar());
    m_files->fill(menus);
    m_textActions.fillEdit(*menus.edit);
    menus.edit->addSeparator();
    menus.edit->addAction(m_actions.preferences);
    m_textActions.fillGo(*menus.go);
    m_physicsActions.fill(*menus.physics);
    m_textActions.fillView(*menus.view);
    m_panels.fill(*menus.window);
}

void MainWindow::connectTexts()
{
    connect(m_files, &FileMenu::told, m_status, &QStatusBar::showMessage);
    connect(m_actions.nextTab, &QAction::triggered, this, [this] { m_tabs->goToNext(1); });
    connect(m_actions.previousTab, &QAction::triggered, this, [this] { m_tabs->goToNext(-1); });
    const auto goToPart = [this](int step) { m_panels.goToNext({&tab().editor(), &m_viewport}, step); };
    connect(m_actions.nextPart, &QAction::triggered, this, [goToPart] { goToPart(1); });
    connect(m_actions.previousPart, &QAction::triggered, this, [goToPart] { goToPart(-1); });
    connect(m_tabs, &TextTabs::currentTabChanged, this, &MainWindow::takeTab);
    connect(m_tabs, &TextTabs::currentNamed, this, &MainWindow::showTitle);
}

void MainWindow::connectPanels()
{
    connect(&m_panels.problems(), &ProblemsView::chosen, this, &MainWindow::goTo);
    connect(&m_panels.problems(), &ProblemsView::chosenElsewhere, this, &MainWindow::goToFile);
    connect(m_addressLink, &AddressLink::told, m_status,
            [this](const QString &words) { m_status->showMessage(words); });

    m_panels.physics().choices().addActions(m_physicsActions, *m_actions.dropBalls);
    connect(m_physics, &PhysicsController::colliderChanged, m_status, &StatusLine::setCollider);
    connect(m_physics, &PhysicsController::told, m_status,
            [this](const QString &words) { m_status->showMessage(words, 5000); });

    connect(m_depthControl, &DepthControl::depthEdited, this, [this](quint64 depth) { tab().depth().setValue(depth); });
    connect(m_depthControl, &DepthControl::dragBegan, this, [this] { tab().depth().beginGesture(); });
    connect(m_depthControl, &DepthControl::dragEnded, this, [this] {
        tab().depth().endGesture();
        showDepth();
    });
}

void MainWindow::connectViewActions()
{
    connectViewControls(m_actions, *m_pane);
    m_addressLink->use(*m_actions.zoomToCopy, *m_actions.collapse);
    m_physics->inspector().setNaming(
        [this](std::size_t item, const Address &address) { return m_addressLink->wordsOf(item, address); });
    m_viewTools->measuring().setNaming([this](const Selection &copy) { return m_addressLink->wordsOf(copy); });
    connect(m_viewTools, &ViewTools::remarkChanged, this, &MainWindow::showTrouble);
    connect(m_viewTools, &ViewTools::told, m_status, [this](const QString &words) { m_status->showMessage(words); });
    connect(m_actions.endless, &QAction::toggled, this, [this](bool isEndless) { seen().setEndless(isEndless); });
    connect(m_actions.pin, &QAction::toggled, m_tabs, &TextTabs::setPinned);
    connect(m_actions.rebuild, &QAction::triggered, this, &MainWindow::rebuild);
    connect(m_actions.saveView, &QAction::triggered, this, &MainWindow::saveView);
    connect(m_actions.preferences, &QAction::triggered, this, &MainWindow::showPreferences);
    connect(m_actions.fullScreen, &QAction::toggled, this, &MainWindow::setFullScreen);
    connect(m_actions.resetLayout, &QAction::triggered, this, [this] { m_layout.reset(); });
    connect(m_actions.keys, &QAction::triggered, this, [this] { showKeyList(*this); });
    connect(m_actions.about, &QAction::triggered, this, [this] { showAbout(*this, m_graphicsSystem); });
}

void MainWindow::connectViewport()
{
    connect(&m_viewport, &Viewport::pictureAdvanced, m_status, &StatusLine::setDrawn);
    connect(&m_viewport, &Viewport::ready, this, [this](const QString &system) { m_graphicsSystem = system; });
    connect(&m_viewport, &Viewport::pictureFailed, this, [this](const QString &reason) {
        if (reason != m_pictureTrouble) {
            m_pictureTrouble = reason;
            showTrouble();
        }
    });
    connect(&m_pane->strip(), &MessageStrip::followed, this, &MainWindow::followTrouble);
}

// ---- Files

bool MainWindow::openFile(const QString &path)
{
    return m_tabs->openFile(path);
}

void MainWindow::openExample()
{
    m_tabs->openFile(TextTabs::examplesFolder + QStringLiteral("/romanesco.fdo"));
}

bool MainWindow::openSession()
{
    return Preferences::read().reopensTexts && m_tabs->restore();
}

void MainWindow::offerLostTexts()
{
    m_files->offerLostTexts();
}

bool MainWindow::saveFile(const QString &path)
{
    return m_tabs->saveFile(path);
}

void MainWindow::closeEvent(QCloseEvent *event)
{
    if (!m_tabs->mayCloseAll()) {
        event->ignore();
        return;
    }
    m_tabs->remember();
    m_layout.save();
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
    QStringList files;
    for (const QUrl &url : event->mimeData()->urls()) {
        files << url.toLocalFile();
    }
    const QWidget *under = childAt(event->position().toPoint());
    if (under && (under == &m_viewport || m_viewport.isAncestorOf(under))) {
        files = addToScene(seen(), files);
    } else if (under && tab().editor().isAncestorOf(under)) {
        files = addToScene(tab(), files);
    }
    for (const QString &file : std::as_const(files)) {
        openFile(file);
    }
}

// ---- The text that is looked at

void MainWindow::takeTab()
{
    TextTab *const before = std::exchange(m_seen, &m_tabs->seen());
    if (before != m_seen && before && m_viewport.isViewStarted()) {
        before->view = m_viewport.view();
    }
    m_tab = &m_tabs->current();
    m_whileLooked = std::make_unique<QObject>();
    connectText(*m_tab);
    if (before != m_seen) {
        m_whileSeen = std::make_unique<QObject>();
        connectPicture(*m_seen);
        showScene();
    }
    m_addressLink->follow(*m_seen, m_seen == m_tab);
    m_viewTools->follow(*m_seen, m_seen == m_tab);
    showText();
}

void MainWindow::connectText(TextTab &tab)
{
    QObject *looked = m_whileLooked.get();
    connect(&tab, &TextTab::restarted, looked, [this] { showText(); });
    connect(&tab, &TextTab::previewed, looked, [this] {
        showProblems();
        showDepth();
    });
    connect(&tab.editor(), &QPlainTextEdit::cursorPositionChanged, looked, [this] { showCursorPlace(); });
    connect(&tab.editor(), &FdoEditor::openFileRequested, looked, [this](const QString &path) { openBeside(path); });
    m_textActions.follow(tab.editor(), tab.findBar());
    m_panels.parameters().follow(tab.editor());
    m_panels.outline().follow(tab.editor());
    connect(&tab.document(), &Document::fileStateChanged, looked, [this] {
        m_textActions.update();
        m_panels.outline().update();
        showDepth();
    });
}

void MainWindow::connectPicture(TextTab &tab)
{
    QObject *seen = m_whileSeen.get();
    connect(&tab, &TextTab::restarted, seen, [this] { showScene(); });
    connect(&tab, &TextTab::previewed, seen, [this] { showPreview(); });
    connect(&tab, &TextTab::counted, seen, [this] { m_status->setSummary(m_seen->summary()); });
}

/// All that is of the text.
void MainWindow::showText()
{
    m_status->clearMessage();
    showProblems();
    showDepth();
    showTrouble();
    showCursorPlace();
    showTitle();
    const QSignalBlocker blocker(m_actions.pin);
    m_actions.pin->setChecked(m_tabs->isPinned());
}

/// All that is of the picture.
void MainWindow::showScene()
{
    m_viewport.startScene(seen().shown(), seen().view);
    m_physics->start(seen());
    m_measure->follow(seen());
    m_status->setSummary(seen().summary());
    m_status->clearDrawn();
    m_addressLink->clear();
    showEndless();
    showTrouble();
}

void MainWindow::showPreview()
{
    showEndless();
    m_viewport.setScene(seen().shown());
    m_physics->update();
    m_addressLink->update();
    showTrouble();
}

void MainWindow::showEndless()
{
    const QSignalBlocker blocker(m_actions.endless);
    m_actions.endless->setChecked(seen().isEndless());
}

void MainWindow::showProblems()
{
    m_panels.showProblems(tab().document().name(), tab().preview());
}

/// What is looked at and what is seen.
void MainWindow::rebuild()
{
    tab().rebuild();
    if (m_seen != m_tab) {
        seen().rebuild();
    }
}

/// As a line of the text.
void MainWindow::saveView()
{
    FdoEditor &editor = seen().editor();
    if (editor.isReadOnly() || !m_viewport.view().surroundings()) {
        return;
    }
    m_tabs->setCurrentWidget(m_seen);
    SavedView view = m_viewport.view().saved();
    view.isEndless = seen().isShownEndless();
    const TextSnapshot text = editor.snapshot();
    const bool isSdo = fileKind(seen().document().scenePath()) == FileKind::Sdo;
    editor.apply(editsToSave(view, writtenOf(m_viewport.view().cameraInWorld()), text.bytes(), isSdo), text);
}

void MainWindow::showTrouble()
{
    MessageStrip &strip = m_pane->strip();
    const TextTab::Trouble &trouble = seen().trouble();
    if (trouble.isOfText) {
        strip.say(
            (seen().shown() ? tr("Showing the last good version — %1") : tr("No picture yet — %1")).arg(trouble.words),
            true);
    } else if (!m_pictureTrouble.isEmpty()) {
        strip.say(m_pictureTrouble);
    } else if (!trouble.words.isEmpty()) {
        strip.say(trouble.words);
    } else if (!m_viewTools->remark().isEmpty()) {
        strip.say(m_viewTools->remark());
    } else if (m_tabs->isPinned()) {
        strip.say(tr("The picture stays with “%1”. Click here to let it go.").arg(seen().document().name()), true);
    } else {
        strip.fallSilent();
    }
}

void MainWindow::followTrouble()
{
    const TextTab::Trouble trouble = seen().trouble();
    if (trouble.isOfText) {
        m_tabs->setCurrentWidget(m_seen);
        goTo(trouble.place, trouble.text);
    } else if (m_tabs->isPinned()) {
        m_actions.pin->setChecked(false);
    }
}

void MainWindow::showDepth()
{
    const std::optional<quint64> depth = tab().depth().value();
    m_depthControl->setDepth(tab().editor().isReadOnly() ? std::nullopt : depth);
    m_panels.parameters().update();
    m_status->setDepth(depth);
}

void MainWindow::showCursorPlace()
{
    // Columns count characters, as in messages.
    const QTextCursor cursor = tab().editor().textCursor();
    const QString before = cursor.block().text().first(cursor.positionInBlock());
    m_status->setCursorPlace(cursor.blockNumber() + 1, static_cast<int>(before.toUcs4().size()) + 1);
}

void MainWindow::showTitle()
{
    const Document &document = m_tabs->current().document();
    setWindowTitle(tr("%1[*] — Romanesco").arg(document.name()));
    setWindowModified(document.isModified());
}

void MainWindow::changeEvent(QEvent *event)
{
    QMainWindow::changeEvent(event);
    if (event->type() == QEvent::ActivationChange && isActiveWindow()) {
        m_tabs->lookForChanges();
    }
}

void MainWindow::goTo(SourceRange range, const TextSnapshot &text)
{
    tab().editor().goTo(range, text);
}

/// A file that is named as in the text.
bool MainWindow::openBeside(const QString &file)
{
    return openFile(QFileInfo(tab().document().path()).dir().filePath(file));
}

void MainWindow::goToFile(const QString &file, TextPosition position)
{
    if (openBeside(file)) {
        const TextSnapshot text = tab().document().text();
        const std::size_t offset = LineMap(text.bytes()).offset(position);
        goTo({offset, offset}, text);
    }
}

void MainWindow::setFullScreen(bool isFull)
{
    setWindowState(isFull ? windowState() | Qt::WindowFullScreen : windowState() & ~Qt::WindowFullScreen);
}

void MainWindow::showPreferences()
{
    auto *dialog = new PreferencesDialog(this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &PreferencesDialog::changed, m_tabs, &TextTabs::setPreferences);
    dialog->open();
}

}
