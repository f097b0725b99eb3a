// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <QObject>

#include "core/language/completion.h"
#include "textsnapshot.h"

class QCompleter;
class QKeyEvent;
class QPlainTextEdit;
class QStandardItemModel;
class QTreeView;

namespace romanesco {

class LanguageText;

/// A list under the cursor of what may stand there. It opens when asked, and by itself while a name is being typed; never
/// in a comment, for a number, or in a read-only text. Typing narrows it, Enter and Tab write what is chosen as one undo
/// step, Esc closes it. Where the word that is typed is one of them already, none is chosen and Enter is a new line.
class CompletionPopup : public QObject
{
    Q_OBJECT
public:
    /// Both must outlive it.
    CompletionPopup(QPlainTextEdit &editor, LanguageText &text);

    /// Asked where a path may stand, once for each word that is begun there.
    void setFiles(FileNames files) { m_files = std::move(files); }

    /// As asked for: also where no word is begun.
    void open();
    [[nodiscard]] bool isOpen() const;

    /// Whether a key is for the open list, so that the editor must ignore it.
    [[nodiscard]] bool takes(const QKeyEvent &key) const;
    /// After the editor has done what a key asks for.
    void follow(const QKeyEvent &key);

private:
    [[nodiscard]] std::vector<Completion> completions();
    [[nodiscard]] QString begunWord() const;
    void update(bool isAsked);
    void fill(const QString &begun);
    void write(int row);

    QPlainTextEdit &m_editor;
    LanguageText &m_text;
    FileNames m_files;
    /// What it said of this word.
    std::optional<std::vector<std::string>> m_listed;
    QCompleter *m_completer;
    QStandardItemModel *m_model;
    QTreeView *m_view;
    bool m_isAsked = false;
    std::vector<Completion> m_completions;
    /// The text that their edits are of.
    TextSnapshot m_snapshot;
};

}
