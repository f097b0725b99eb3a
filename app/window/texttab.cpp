// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#include "texttab.h"

#include <algorithm>
#include <utility>

#include <QDir>
#include <QSaveFile>
#include <QSet>
#include <QVBoxLayout>

#include "core/text/linemap.h"
#include "documentstrip.h"
#include "editor/fdoeditor.h"
#include "editor/findbar.h"
#include "messagestrip.h"

namespace romanesco {

TextTab::TextTab(JournalSession &journals, FileWatch &watch, const FileAccess &files, QWidget *parent)
    : QWidget(parent)
    , m_editor(new FdoEditor)
    , m_strip(new MessageStrip(MessageStrip::Closing::ByUser))
    , m_findBar(new FindBar(*m_editor))
    , m_document(*m_editor, m_files)
    , m_journal(m_document, journals)
    , m_watch(watch)
    , m_depth(*m_editor)
    , m_preview(files)
{
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(m_strip);
    column->addWidget(new DocumentStrip(m_document));
    column->addWidget(m_editor, 1);
    column->addWidget(m_findBar);
    setFocusProxy(m_editor);
    connectFile();
    m_editor->setFiles([this] { return filesBeside(); });
    connect(m_editor, &FdoEditor::renumberingOffered, this, &TextTab::offerRenumbering);
    connect(m_strip, &MessageStrip::followed, m_editor, &FdoEditor::renumber);
    connect(m_strip, &MessageStrip::closed, this, [this](const QString &text) {
        if (text == m_offer) {
            m_editor->dismissRenumbering();
        }
    });
    connect(&m_document, &Document::replaced, this, &TextTab::restart);
    connect(&m_document, &Document::textChanged, this, &TextTab::build);
    connect(&m_preview, &PreviewController::built, this, &TextTab::takePreview);
    connect(&m_preview, &PreviewController::counted, this, [this](const Summary &summary) {
        m_summary = summary;
        Q_EMIT counted();
    });
}

/// The bar goes before the text that it looks through.
TextTab::~TextTab()
{
    m_document.waitForSave();
    delete m_findBar;
}

void TextTab::connectFile()
{
    connect(&m_document, &Document::saved, this, [this](const QString &path) {
        if (m_editor->renumberingCount() == 0) {
            m_strip->fallSilent();
        }
        Q_EMIT saved(path);
    });
    connect(&m_document, &Document::saveFailed, this, &TextTab::sayNotSaved);
    connect(&m_journal, &Journal::troubleChanged, this, [this](const QString &reason) {
        if (!reason.isEmpty()) {
            m_strip->say(tr("What you type is not safe from a crash until you save: %1.").arg(reason));
        }
    });
    connect(&m_document, &Document::savingStarted, &m_watch, &FileWatch::beginOwnWrite);
    connect(&m_document, &Document::savingEnded, &m_watch, &FileWatch::endOwnWrite);
    connect(&m_document, &Document::nameChanged, this, &TextTab::watchFiles);
    connect(&m_watch, &FileWatch::changed, this, &TextTab::takeChanges);
}

void TextTab::sayNotSaved(const QString &path, const QString &reason)
{
    m_strip->say(tr("Cannot save “%1”: %2. The text is still here, unsaved.").arg(path, reason));
}

/// The text's own, and those that the scene is made of.
void TextTab::watchFiles()
{
    if (m_document.path().isEmpty() || m_document.isExample()) {
        m_watch.setPaths(this, {});
        return;
    }
    m_watch.setPaths(this, QStringList(m_document.path()) + m_newest.files);
}

void TextTab::takeChanges(const QStringList &paths)
{
    if (paths.contains(m_document.path())) {
        m_document.checkFile();
    }
    const auto isChanged = [&](const QString &file) { return paths.contains(file); };
    if (std::ranges::any_of(m_newest.files, isChanged)) {
        build();
    }
}

bool TextTab::isUntouched() const
{
    return !m_document.isModified() && (m_document.isExample() || m_document.path().isEmpty());
}

bool TextTab::open(const QString &path)
{
    if (const auto opened = m_document.open(path); !opened) {
        m_strip->say(tr("Cannot open “%1”: %2.").arg(QDir::toNativeSeparators(path), opened.error()));
        return false;
    }
    if (!m_document.isFaithful()) {
        m_strip->say(tr("“%1” holds characters that would be lost by saving, so it can only be read here. "
                        "Save As makes a copy that can be edited.")
                         .arg(m_document.name()));
    } else if (!m_document.isExample()) {
        m_strip->fallSilent();
    }
    return true;
}

bool TextTab::saveTo(const QString &path)
{
    if (m_document.isExample()) {
        takeFilesAlong(path);
    }
    const auto saved = m_document.saveAs(path);
    if (!saved) {
        sayNotSaved(path, saved.error());
    }
    return saved.has_value();
}

void TextTab::startSavingTo(const QString &path)
{
    if (m_document.isExample()) {
        takeFilesAlong(path);
    }
    m_document.startSaving(path);
}

/// An example names files beside it. A copy of the example would not find them, so they are copied too, unless a file of
/// that name is there.
void TextTab::takeFilesAlong(const QString &textPath)
{
    QSet<QString> names;
    if (const std::shared_ptr<const Scene> &scene = m_preview.lastGoodScene()) {
        for (const SceneItem &item : scene->items) {
            names << QString::fromStdString(item.path) << QString::fromStdString(item.model->meshPath);
        }
    }
    const QDir examples = QFileInfo(m_document.path()).dir();
    for (const QString &name : names) {
        const QString target = QFileInfo(textPath).dir().filePath(name);
        QFile source(examples.filePath(name));
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

/// Those that the text may name.
std::vector<std::string> TextTab::filesBeside() const
{
    std::vector<std::string> names;
    const QDir folder = QFileInfo(m_document.path()).dir();
    const QStringList kinds{QStringLiteral("*.obj"), QStringLiteral("*.fdo")};
    for (const QString &name : folder.entryList(kinds, QDir::Files, QDir::Name)) {
        names.push_back(name.toStdString());
    }
    return names;
}

void TextTab::offerRenumbering(int count)
{
    if (count > 0) {
        m_offer = tr("%1 uses of vectors by number now mean another vector. Click here, or press Ctrl+Shift+R, to let "
                     "them mean what they did.")
                      .arg(count);
        m_strip->say(m_offer, true);
    } else if (m_strip->text() == m_offer) {
        m_strip->fallSilent();
    }
}

void TextTab::setWatched(bool isWatched)
{
    m_isWatched = isWatched;
    if (m_isWatched && m_isStale) {
        build();
    }
}

void TextTab::setEndless(bool isEndless)
{
    if (isEndless != m_preview.isEndless()) {
        m_preview.setEndless(isEndless);
        build();
    }
}

/// Nothing of the old text stays: its places mean nothing in this one.
void TextTab::restart()
{
    m_preview.forget();
    m_preview.setEndless(false); // what is asked for is asked of one file
    m_newest = {};
    m_newest.text = m_document.text();
    m_shown.reset();
    m_isShownEndless = false;
    m_isFirstScene = true;
    m_summary.reset();
    m_trouble = {};
    m_depth.clear();
    m_editor->setDiagnostics({}, m_document.text());
    view.reset();
    Q_EMIT restarted();
}

void TextTab::build()
{
    m_isStale = !m_isWatched;
    if (m_isWatched) {
        m_preview.build(m_document.scenePath(), m_document.text());
    }
}

void TextTab::takePreview(const Preview &preview)
{
    const bool hasOtherFiles = m_newest.files != preview.files;
    m_newest = preview;
    if (hasOtherFiles) {
        watchFiles();
    }
    if (!preview.isOutdated) {
        m_editor->setDiagnostics(preview.diagnostics, preview.text);
    }
    if (preview.scene) {
        const bool wantsEndless =
            std::exchange(m_isFirstScene, false) && preview.scene->view && preview.scene->view->isEndless;
        if (wantsEndless && !m_preview.isEndless()) {
            setEndless(true);
            return; // the preview that follows
        }
        m_shown = preview.shown;
        m_isShownEndless = preview.shown != preview.scene;
        if (preview.isOutdated) {
            // The depth moves with what is typed.
        } else if (preview.scene->depth) {
            const SourceRange place = preview.scene->depth->range;
            m_depth.track(preview.text.position(place.begin), preview.text.position(place.end));
        } else {
            m_depth.clear();
        }
    }
    const auto error = std::ranges::find_if(preview.diagnostics, &Diagnostic::isError);
    if (error != preview.diagnostics.end()) {
        const std::size_t line = LineMap(preview.text.bytes()).position(error->range.begin).line;
        m_trouble = {tr("line %1: %2").arg(line).arg(QString::fromStdString(error->message())), true, error->range,
                     preview.text};
    } else if (!preview.failure.isEmpty()) {
        m_trouble = {preview.failure, true, {}, preview.text};
    } else {
        m_trouble = {preview.remark, false, {}, {}};
    }
    Q_EMIT previewed();
}

}
