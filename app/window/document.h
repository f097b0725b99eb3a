// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <expected>
#include <filesystem>

#include <QObject>

#include "editor/documentbytes.h"
#include "editor/textsnapshot.h"

namespace romanesco {

class FdoEditor;
class FileAccess;

/// A text in an editor and the file it belongs to.
class Document : public QObject
{
    Q_OBJECT
public:
    /// Both must outlive it.
    Document(FdoEditor &editor, const FileAccess &files, QObject *parent = nullptr);

    /// Another text, without undo history. The error is a phrase ("no such file"); the old text is then still there.
    [[nodiscard]] std::expected<void, QString> open(const QString &path);
    /// An empty text without a file.
    void startNew();
    /// Writes the text, whole or not at all, and goes on with that file. The undo history stays. Never over a file whose
    /// characters the editor cannot keep. The error is a phrase.
    [[nodiscard]] std::expected<void, QString> saveAs(const QString &path);

    /// Empty for a text that has no file yet; starts with ":/" for one that the program brought along.
    [[nodiscard]] const QString &path() const { return m_path; }
    [[nodiscard]] bool isExample() const { return m_path.startsWith(QLatin1String(":/")); }
    /// Whether the text has a file that it can be saved to as it is.
    [[nodiscard]] bool hasOwnFile() const;
    /// The file's name, for people.
    [[nodiscard]] QString name() const;
    /// What paths in the text are relative to, and what tells the language.
    [[nodiscard]] std::filesystem::path scenePath() const;
    [[nodiscard]] bool isModified() const;
    /// The text as it was last announced.
    [[nodiscard]] const TextSnapshot &text() const { return m_text; }

Q_SIGNALS:
    /// Another text took the place of the last one; textChanged() follows.
    void replaced();
    /// The characters have changed, by an edit or because they are of another file.
    void textChanged();
    /// Another file, or the same text under another name.
    void nameChanged();
    void modifiedChanged(bool isModified);

private:
    void startText(const QString &path, const TextFileForm &form);
    void takeText();
    void setPath(const QString &path);

    FdoEditor &m_editor;
    const FileAccess &m_files;
    QString m_path;
    TextFileForm m_form;
    TextSnapshot m_text;
    bool m_isLoading = false;
};

}
