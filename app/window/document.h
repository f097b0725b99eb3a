// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <cstdint>
#include <expected>
#include <filesystem>
#include <optional>
#include <string_view>

#include <QByteArray>
#include <QObject>

#include "backgroundtask.h"
#include "core/base/filelock.h"
#include "editor/documentbytes.h"
#include "editor/textsnapshot.h"

namespace romanesco {

class FdoEditor;
class FileAccess;

/// A text in an editor and the file it belongs to, which other programs may change, and other windows may have open.
class Document : public QObject
{
    Q_OBJECT
public:
    /// Both must outlive it.
    Document(FdoEditor &editor, const FileAccess &files, QObject *parent = nullptr);
    /// Waits for a save that is under way.
    ~Document() override;

    /// Another text, without undo history. The error is a phrase ("no such file"); the old text is then still there.
    [[nodiscard]] std::expected<void, QString> open(const QString &path);
    /// An empty text without a file.
    void startNew();
    /// Opens the file and changes it, as an edit: undo leads to what is on the disk. Where it cannot be opened, to an empty
    /// text, which has that file still where it is only gone. LF between the lines.
    void restore(const QString &path, std::string_view text);

    /// Writes the text, whole or not at all, and goes on with that file. The undo history stays. Never over a file whose
    /// characters the editor cannot keep, nor over a change by another program that was not looked at. Waits; the error is a
    /// phrase.
    [[nodiscard]] std::expected<void, QString> saveAs(const QString &path);
    /// The same in the background, the text as it is now: saved() or saveFailed() follows. If one is under way, this one waits
    /// for it, and takes the text as it is then.
    void startSaving(const QString &path);
    [[nodiscard]] bool isSaving() const { return m_save.isRunning(); }
    /// Until the save that is under way has ended; none follows it.
    void waitForSave();

    /// Empty for a text that has no file yet; starts with ":/" for one that the program brought along.
    [[nodiscard]] const QString &path() const { return m_path; }
    [[nodiscard]] bool isExample() const { return m_path.startsWith(QLatin1String(":/")); }
    /// Whether the text has a file that it can be saved to as it is.
    [[nodiscard]] bool hasOwnFile() const;
    /// Else the text holds characters that would be lost by saving, and is read-only.
    [[nodiscard]] bool isFaithful() const { return m_form.isFaithful; }
    /// The file's name, for people.
    [[nodiscard]] QString name() const;
    /// What paths in the text are relative to, and what tells the language.
    [[nodiscard]] std::filesystem::path scenePath() const;
    [[nodiscard]] bool isModified() const;
    /// The text as it was last announced.
    [[nodiscard]] const TextSnapshot &text() const { return m_text; }

    /// What has become of the file since it was read or written here: what it was; another text, while this one is modified
    /// too; no file; a file that cannot be read (see fileTrouble()).
    enum class FileState { Same, Changed, Removed, Unreadable };
    [[nodiscard]] FileState fileState() const { return m_fileState; }
    /// A phrase.
    [[nodiscard]] const QString &fileTrouble() const { return m_fileTrouble; }
    /// The other text, where it has Changed.
    [[nodiscard]] const QByteArray &bytesOnDisk() const { return m_bytesOnDisk; }
    /// The checksum() of the file when the text was last the same; 0 without a file.
    [[nodiscard]] std::uint64_t checksumOnDisk() const { return m_checksumOnDisk; }
    /// Another window has the file open: the text is read-only.
    [[nodiscard]] bool isHeldElsewhere() const { return m_isHeldElsewhere; }

public Q_SLOTS:
    /// Somebody else may have written the file: looks, in the background. An unmodified text becomes that of the file, in one
    /// undo step; else fileStateChanged() tells. What was saved here is no change.
    void checkFile();
    /// Where the file has Changed: takes its text, in one undo step.
    void reload();
    /// Where the file has Changed: the next save writes over it.
    void keepText();
    /// Although another window has the file open.
    void editAnyway();

Q_SIGNALS:
    /// Another text took the place of the last one; textChanged() follows.
    void replaced();
    /// The characters have changed, by an edit or because they are of another file.
    void textChanged();
    /// Another file, or the same text under another name.
    void nameChanged();
    void modifiedChanged(bool isModified);
    /// fileState(), or whether it is held elsewhere.
    void fileStateChanged();
    /// Another program has changed the file, and the text with it.
    void reloaded();
    /// Around each save.
    void savingStarted(const QString &path);
    void savingEnded(const QString &path);
    /// One of these after savingEnded(); saveFailed() also where a save cannot even begin in the background. The reason is a
    /// phrase.
    void saved(const QString &path);
    void saveFailed(const QString &path, const QString &reason);

private:
    /// A file as it is found.
    struct Look {
        explicit Look(const QString &path);

        QString path;
        bool isThere = false;
        std::expected<QByteArray, QString> bytes;
    };
    struct SaveResult {
        QString path;
        QByteArray bytes;
        std::expected<void, QString> outcome;
        /// Not written, since this is there and not what was expected.
        std::optional<Look> change;
    };

    void markUnsaved();
    void startText(const QString &path, const TextFileForm &form);
    [[nodiscard]] bool hasOtherCharacters(int from, int count) const;
    void takeText();
    void setPath(const QString &path);
    void lockFile();
    void updateReadOnly();
    void setFileState(FileState state, const QString &trouble = {});
    [[nodiscard]] std::expected<void, QString> write(const QString &path);
    void finishSaving(const SaveResult &result);
    void takeLook(const Look &look);
    void takeBytes(const QByteArray &bytes);
    [[nodiscard]] QByteArray bytes() const;

    FdoEditor &m_editor;
    const FileAccess &m_files;
    QString m_path;
    TextFileForm m_form;
    TextSnapshot m_text;
    bool m_isLoading = false;
    bool m_hasChanged = false;

    std::optional<FileLock> m_lock;
    bool m_isHeldElsewhere = false;
    FileState m_fileState = FileState::Same;
    QString m_fileTrouble;
    QByteArray m_bytesOnDisk;
    std::uint64_t m_checksumOnDisk = 0;

    /// What waits for the save or the look that is under way.
    std::optional<QString> m_nextSave;
    QString m_savingPath;
    bool m_mustLook = false;
    /// Grows whenever the file is read or written here.
    unsigned m_fileVersion = 0;
    std::optional<std::expected<void, QString>> m_lastSave;
    BackgroundTask<Look> m_look;
    BackgroundTask<SaveResult> m_save;
};

}
