// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#include "document.h"

#include <format>
#include <utility>

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QTextBlock>
#include <QTextDocument>

#include "core/base/atomicfile.h"
#include "core/base/file.h"
#include "core/text/textjournal.h"
#include "editor/fdoeditor.h"
#include "userfolders.h"

namespace romanesco {

namespace {

std::filesystem::path asPath(const QString &name)
{
    return QFile::encodeName(name).toStdString();
}

std::string_view viewOf(const QByteArray &bytes)
{
    return {bytes.constData(), static_cast<std::size_t>(bytes.size())};
}

/// Not beside the file: whoever looks into its folder would wonder.
std::expected<FileLock, FileLock::Refusal> lockOf(const QString &path)
{
    const auto folder = stateFolder("locks");
    if (!folder) {
        return std::unexpected(FileLock::Refusal{false, folder.error()});
    }
    const QFileInfo info(path);
    const QString real = info.exists() ? info.canonicalFilePath() : info.absoluteFilePath();
    return FileLock::take(*folder / std::format("{:016x}", checksum(asPath(real).native())));
}

}

Document::Look::Look(const QString &file)
    : path(file)
{
    const auto read = DiskFiles().read(asPath(file));
    std::error_code error;
    isThere = read || std::filesystem::exists(asPath(file), error) || error;
    if (read) {
        bytes = QByteArray::fromStdString(*read);
    } else {
        bytes = std::unexpected(QString::fromStdString(read.error()));
    }
}

Document::Document(FdoEditor &editor, const FileAccess &files, QObject *parent)
    : QObject(parent)
    , m_editor(editor)
    , m_files(files)
    , m_look(*this)
    , m_save(*this)
{
    connect(editor.document(), &QTextDocument::contentsChange, this, [this](int from, int removed, int added) {
        m_hasChanged = m_hasChanged || removed != added || hasOtherCharacters(from, added);
    });
    connect(editor.document(), &QTextDocument::contentsChanged, this, &Document::takeText);
    connect(editor.document(), &QTextDocument::modificationChanged, this, [this](bool isModified) {
        // A document that is filled counts as modified for a moment.
        if (!m_isLoading) {
            Q_EMIT modifiedChanged(isModified);
        }
    });
    setPath({});
}

Document::~Document() = default;

std::expected<void, QString> Document::open(const QString &path)
{
    const std::expected<std::string, std::string> read = m_files.read(asPath(path));
    if (!read) {
        return std::unexpected(QString::fromStdString(read.error()));
    }
    waitForSave();
    m_isLoading = true;
    const auto form = loadBytes(*m_editor.document(), QByteArray::fromStdString(*read));
    m_isLoading = false;
    if (!form) {
        return std::unexpected(form.error());
    }
    m_checksumOnDisk = checksum(*read);
    startText(path, *form);
    return {};
}

void Document::startNew()
{
    waitForSave();
    m_isLoading = true;
    const TextFileForm form = loadBytes(*m_editor.document(), {}).value_or(TextFileForm{});
    m_isLoading = false;
    m_checksumOnDisk = 0;
    startText({}, form);
}

void Document::startText(const QString &path, const TextFileForm &form)
{
    ++m_fileVersion;
    m_form = form;
    setFileState(FileState::Same);
    m_editor.moveCursor(QTextCursor::Start);
    setPath(path);
    m_text = m_editor.snapshot();
    Q_EMIT modifiedChanged(false);
    Q_EMIT replaced();
    Q_EMIT textChanged();
}

void Document::restore(const QString &path, std::string_view text)
{
    if (path.isEmpty() || !open(path)) {
        startNew();
        const bool isGone = !path.isEmpty() && !path.startsWith(QLatin1String(":/")) && !Look(path).isThere;
        if (isGone) {
            setPath(path);
            setFileState(FileState::Removed);
        }
    }
    changeToText(m_editor, text);
}

QByteArray Document::bytes() const
{
    return toBytes(*m_editor.document(), m_form.hasByteOrderMark);
}

// ---- Saving

void Document::waitForSave()
{
    m_nextSave.reset();
    m_save.finish();
}

std::expected<void, QString> Document::saveAs(const QString &path)
{
    waitForSave();
    if (const auto begun = write(path); !begun) {
        return begun;
    }
    m_save.finish();
    return std::exchange(m_lastSave, std::nullopt).value();
}

void Document::startSaving(const QString &path)
{
    if (m_save.isRunning()) {
        // What is being written is the text's own file by then.
        m_nextSave = path == m_path ? m_savingPath : path;
    } else if (const auto begun = write(path); !begun) {
        Q_EMIT saveFailed(path, begun.error());
    }
}

/// Begins to.
std::expected<void, QString> Document::write(const QString &path)
{
    if (path == m_path && !m_form.isFaithful) {
        return std::unexpected(tr("it holds characters that would be lost; choose another name"));
    }
    const auto work = [path, bytes = bytes(), isOwn = path == m_path, known = m_checksumOnDisk] {
        SaveResult result{path, bytes, {}, {}};
        if (const Look look(path); isOwn && look.bytes && checksum(viewOf(*look.bytes)) != known) {
            result.change = look;
            result.outcome = std::unexpected(tr("another program has changed it"));
        } else if (auto written = writeWhole(asPath(path), viewOf(bytes)); !written) {
            result.outcome = std::unexpected(QString::fromStdString(written.error()));
        }
        return result;
    };
    m_savingPath = path;
    Q_EMIT savingStarted(path);
    m_save.start(work, [this](const SaveResult &result) { finishSaving(result); });
    return {};
}

void Document::finishSaving(const SaveResult &result)
{
    const QString &path = result.path;
    ++m_fileVersion;
    m_lastSave = result.outcome;
    if (result.outcome) {
        m_checksumOnDisk = checksum(viewOf(result.bytes));
        // What was typed meanwhile is not on the disk.
        if (bytes() == result.bytes) {
            m_editor.document()->setModified(false);
        } else {
            markUnsaved();
        }
        setFileState(FileState::Same);
        if (path != m_path) {
            m_form.isFaithful = true;
            setPath(path);
            // Paths in the text now mean other files.
            Q_EMIT textChanged();
        }
    }
    Q_EMIT savingEnded(path);
    if (result.outcome) {
        Q_EMIT saved(path);
    } else {
        if (result.change) {
            takeLook(*result.change);
        }
        // Else the text is the file's by now.
        if (!result.change || m_fileState != FileState::Same) {
            Q_EMIT saveFailed(path, result.outcome.error());
        }
    }
    if (m_nextSave && !m_save.isRunning()) {
        startSaving(*std::exchange(m_nextSave, std::nullopt));
    }
    if (std::exchange(m_mustLook, false)) {
        checkFile();
    }
}

/// No step back leads to what is on the disk.
void Document::markUnsaved()
{
    // A document that is modified already would keep the step at which it was not.
    m_isLoading = true;
    m_editor.document()->setModified(false);
    m_isLoading = false;
    m_editor.document()->setModified(true);
}

// ---- The file meanwhile

void Document::checkFile()
{
    if (m_path.isEmpty() || isExample()) {
        return;
    }
    if (m_save.isRunning() || m_look.isRunning()) {
        m_mustLook = true;
        return;
    }
    m_look.start([path = m_path] { return Look(path); },
                 [this, version = m_fileVersion](const Look &look) {
                     // What was found while a save went on may be of before it.
                     const bool isOld = m_save.isRunning() || version != m_fileVersion;
                     if (!isOld) {
                         takeLook(look);
                     }
                     if (std::exchange(m_mustLook, false) || isOld) {
                         checkFile();
                     }
                 });
}

void Document::takeLook(const Look &look)
{
    if (look.path != m_path) {
        return;
    }
    if (!look.bytes) {
        // The text is no longer on the disk.
        markUnsaved();
        setFileState(look.isThere ? FileState::Unreadable : FileState::Removed, look.bytes.error());
        return;
    }
    const std::uint64_t found = checksum(viewOf(*look.bytes));
    const bool isKnown = found == m_checksumOnDisk;
    if (isKnown && m_fileState == FileState::Same) {
        return;
    }
    if (*look.bytes == bytes()) {
        m_checksumOnDisk = found;
        m_editor.document()->setModified(false);
        setFileState(FileState::Same);
    } else if (isKnown) {
        setFileState(FileState::Same);
    } else if (isModified()) {
        m_bytesOnDisk = *look.bytes;
        setFileState(FileState::Changed);
    } else {
        takeBytes(*look.bytes);
    }
}

void Document::reload()
{
    if (m_fileState == FileState::Changed) {
        takeBytes(QByteArray(m_bytesOnDisk));
    }
}

void Document::takeBytes(const QByteArray &bytes)
{
    const auto form = changeToBytes(m_editor, bytes);
    if (!form) {
        markUnsaved();
        setFileState(FileState::Unreadable, form.error());
        return;
    }
    m_form = *form;
    m_checksumOnDisk = checksum(viewOf(bytes));
    m_editor.document()->setModified(false);
    setFileState(FileState::Same);
    Q_EMIT reloaded();
}

void Document::keepText()
{
    if (m_fileState == FileState::Changed) {
        m_checksumOnDisk = checksum(viewOf(m_bytesOnDisk));
        markUnsaved();
        setFileState(FileState::Same);
    }
}

void Document::editAnyway()
{
    m_isHeldElsewhere = false;
    updateReadOnly();
    Q_EMIT fileStateChanged();
}

void Document::setFileState(FileState state, const QString &trouble)
{
    if (state != FileState::Changed) {
        m_bytesOnDisk.clear();
    }
    m_fileTrouble = trouble;
    m_fileState = state;
    updateReadOnly();
    Q_EMIT fileStateChanged();
}

void Document::lockFile()
{
    m_lock.reset();
    m_isHeldElsewhere = false;
    if (!m_path.isEmpty() && !isExample()) {
        auto lock = lockOf(m_path);
        m_isHeldElsewhere = !lock && lock.error().isHeld;
        // Where there can be no locks, two windows are the user's to know of.
        if (lock) {
            m_lock = std::move(*lock);
        }
    }
    updateReadOnly();
    Q_EMIT fileStateChanged();
}

void Document::updateReadOnly()
{
    m_editor.setReadOnly(!m_form.isFaithful || m_isHeldElsewhere);
}

// ---- The text

bool Document::hasOwnFile() const
{
    return !m_path.isEmpty() && !isExample() && m_form.isFaithful && !m_isHeldElsewhere;
}

QString Document::name() const
{
    return m_path.isEmpty() ? tr("untitled.fdo") : QFileInfo(m_path).fileName();
}

std::filesystem::path Document::scenePath() const
{
    return asPath(m_path.isEmpty() ? QDir::current().filePath(QStringLiteral("untitled.fdo")) : m_path);
}

bool Document::isModified() const
{
    return m_editor.document()->isModified();
}

/// Colouring the text counts as a change too, line by line in a large text, but changes no character.
bool Document::hasOtherCharacters(int from, int count) const
{
    const QTextDocument &document = *m_editor.document();
    if (static_cast<std::size_t>(document.blockCount()) != m_text.lineCount()) {
        return true;
    }
    for (QTextBlock line = document.findBlock(from); line.isValid() && line.position() <= from + count;
         line = line.next()) {
        if (viewOf(line.text().toUtf8()) != m_text.line(static_cast<std::size_t>(line.blockNumber()))) {
            return true;
        }
    }
    return false;
}

void Document::takeText()
{
    if (m_isLoading || !std::exchange(m_hasChanged, false)) {
        return;
    }
    TextSnapshot text = m_editor.snapshot();
    if (text.bytes() != m_text.bytes()) {
        m_text = std::move(text);
        Q_EMIT textChanged();
    }
}

void Document::setPath(const QString &path)
{
    m_path = path;
    m_editor.setFileName(name());
    lockFile();
    Q_EMIT nameChanged();
}

}
