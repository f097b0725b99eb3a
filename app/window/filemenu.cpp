// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#include "filemenu.h"

#include <QAction>
#include <QDir>
#include <QFileDialog>
#include <QMainWindow>
#include <QMenu>
#include <QStandardPaths>

#include "broughttexts.h"
#include "examplegallery.h"
#include "exportdialog.h"
#include "exportwords.h"
#include "messagestrip.h"
#include "recoverydialog.h"
#include "texttab.h"
#include "texttabs.h"
#include "turntabledialog.h"
#include "viewport.h"

namespace romanesco {

namespace {

QString fileFilter()
{
    return FileMenu::tr("Fractals and scenes (*.fdo *.sdo);;Fractals (*.fdo);;Scenes (*.sdo);;Meshes (*.obj);;"
                        "All files (*)");
}

}

FileMenu::FileMenu(const WindowActions &actions, TextTabs &tabs, Viewport &viewport, QMainWindow &window)
    : QObject(&window)
    , m_actions(actions)
    , m_tabs(tabs)
    , m_viewport(viewport)
    , m_window(window)
    , m_pictures(
          window, [this] { return m_viewport.grabFramebuffer(); },
          [this] { return tab().document().isExample() ? QString() : tab().document().path(); })
    , m_lostTexts(*this)
{
    connectActions();
    connectPictures();
}

TextTab &FileMenu::tab() const
{
    return m_tabs.current();
}

void FileMenu::connectActions()
{
    connect(m_actions.newFile, &QAction::triggered, &m_tabs, &TextTabs::startNew);
    connect(m_actions.open, &QAction::triggered, this, &FileMenu::askForFile);
    connect(m_actions.examples, &QAction::triggered, this, &FileMenu::showExamples);
    connect(m_actions.save, &QAction::triggered, &m_tabs, &TextTabs::save);
    connect(m_actions.saveAs, &QAction::triggered, &m_tabs, &TextTabs::saveAs);
    connect(m_actions.reload, &QAction::triggered, this, [this] { tab().document().checkFile(); });
    connect(m_actions.saveTurntable, &QAction::triggered, this, &FileMenu::saveTurntable);
    connect(m_actions.exportMesh, &QAction::triggered, this, &FileMenu::exportMesh);
    connect(m_actions.closeTab, &QAction::triggered, this, [this] { m_tabs.closeTab(m_tabs.currentIndex()); });
    connect(m_actions.quit, &QAction::triggered, &m_window, &QWidget::close);
    connect(&m_tabs, &TextTabs::saved, this,
            [this](const QString &path) { Q_EMIT told(tr("Saved %1").arg(QDir::toNativeSeparators(path)), 3000); });
}

void FileMenu::connectPictures()
{
    connect(&m_pictures, &PictureActions::saved, this,
            [this](const QString &path) { Q_EMIT told(tr("Saved %1").arg(QDir::toNativeSeparators(path)), 5000); });
    connect(&m_pictures, &PictureActions::copied, this, [this] { Q_EMIT told(tr("The picture is copied"), 5000); });
    connect(&m_pictures, &PictureActions::failed, this, [this](const QString &words) { tab().strip().say(words); });
}

void FileMenu::fill(const WindowActions::OpenMenus &menus)
{
    menus.file->insertActions(menus.endOfFiles, {m_pictures.save(), m_pictures.copy(), m_actions.saveTurntable});
    for (const BroughtText &text : broughtTexts(TextTabs::templatesFolder)) {
        QAction *action = menus.templates->addAction(text.description.section(u':', 0, 0));
        action->setStatusTip(text.description);
        connect(action, &QAction::triggered, this, [this, path = text.path] { m_tabs.startFrom(path); });
    }
    connect(menus.recent, &QMenu::aboutToShow, this, [this, menu = menus.recent] { fillRecent(*menu); });
}

void FileMenu::fillRecent(QMenu &menu)
{
    menu.clear();
    for (const QString &path : TextTabs::recentFiles()) {
        const QAction *action = menu.addAction(QDir::toNativeSeparators(path).replace(u'&', QStringLiteral("&&")));
        connect(action, &QAction::triggered, this, [this, path] { m_tabs.openFile(path); });
    }
    if (menu.isEmpty()) {
        menu.addAction(tr("None yet"))->setEnabled(false);
    }
}

void FileMenu::askForFile()
{
    const Document &document = tab().document();
    const QString folder = document.hasOwnFile() ? QFileInfo(document.path()).path() : QString();
    for (const QString &path : QFileDialog::getOpenFileNames(&m_window, tr("Open"), folder, fileFilter())) {
        m_tabs.openFile(path);
    }
}

void FileMenu::showExamples()
{
    auto *gallery = new ExampleGallery(&m_window);
    gallery->setAttribute(Qt::WA_DeleteOnClose);
    connect(gallery, &ExampleGallery::chosen, &m_tabs, &TextTabs::openFile);
    gallery->open();
}

void FileMenu::offerLostTexts()
{
    m_lostTexts.start([files = &m_files] { return std::make_shared<Recovery>(Recovery::search(*files)); },
                      [this](const std::shared_ptr<Recovery> &found) {
                          if (!found->texts().empty()) {
                              showLostTexts(std::move(*found));
                          }
                      });
}

void FileMenu::showLostTexts(Recovery recovery)
{
    auto *dialog = new RecoveryDialog(std::move(recovery), &m_window);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &RecoveryDialog::restoreRequested, this,
            [this](const LostText &text, bool *isRestored) { *isRestored = m_tabs.restoreLost(text); });
    dialog->open();
}

/// Of the text as it is written, however deep the picture goes.
void FileMenu::exportMesh()
{
    const Preview &preview = tab().preview();
    if (!preview.scene) {
        tab().strip().say(tr("What has errors cannot be exported."));
        return;
    }
    const Document &document = tab().document();
    const bool hasPlace = !document.path().isEmpty() && !document.isExample();
    const QFileInfo text(hasPlace ? document.path() : QDir::home().filePath(document.name()));
    QStringList files = preview.files;
    if (hasPlace) {
        files << document.path();
    }
    auto *dialog = new ExportDialog({preview.scene, document.name(), files},
                                    text.dir().filePath(text.completeBaseName() + QStringLiteral(".obj")), &m_window);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &ExportDialog::exported, this, [this](const QString &path, quint64 bytes, const QString &remarks) {
        Q_EMIT told(tr("Exported %1 (%2)").arg(QDir::toNativeSeparators(path), sizeText(Count(bytes))), 10'000);
        if (!remarks.isEmpty()) {
            tab().strip().say(remarks);
        }
    });
    dialog->open();
}

/// Of what is seen, from where it is seen.
void FileMenu::saveTurntable()
{
    const std::optional<Turn> turn = m_viewport.turn();
    if (!turn) {
        tab().strip().say(tr("There is no picture yet."));
        return;
    }
    const Document &document = m_tabs.seen().document();
    const QDir folder = document.hasOwnFile()
        ? QFileInfo(document.path()).dir()
        : QDir(QStandardPaths::writableLocation(QStandardPaths::PicturesLocation));
    auto *dialog =
        new TurntableDialog(*turn, folder.filePath(QFileInfo(document.name()).completeBaseName()), &m_window);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &TurntableDialog::saved, this, [this](int count, const QString &path) {
        Q_EMIT told(tr("Saved %1 pictures in %2").arg(count).arg(QDir::toNativeSeparators(path)), 10'000);
    });
    dialog->open();
}

}
