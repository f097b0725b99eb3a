// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <filesystem>
#include <list>
#include <string>
#include <vector>

#include <QDateTime>
#include <QString>

#include "core/base/filelock.h"

namespace romanesco {

class FileAccess;

/// A text that was typed and not saved when its process ended.
struct LostText {
    /// Of its file; empty for a text that had none; starts with ":/" for one that the program brought along.
    QString path;
    /// When it was typed last.
    QDateTime time;
    /// LF between the lines.
    std::string text;
    /// What the file says now, in the same form; empty where it cannot be read.
    std::string onDisk;
    /// The file is what it was when the text was typed; another program has changed it since; it is gone or cannot be read.
    enum class Disk { Same, Changed, Gone } disk = Disk::Same;
    /// Of the journal.
    std::vector<std::filesystem::path> files;
};

/// The journals of processes that are no more. What is found is nobody else's to find as long as this lives.
class Recovery
{
public:
    /// In the data folder, without what is on the disk already. Reads all of it: in the background.
    [[nodiscard]] static Recovery search(const FileAccess &files);
    [[nodiscard]] static Recovery search(const std::filesystem::path &folder, const FileAccess &files);

    /// The newest first.
    [[nodiscard]] const std::vector<LostText> &texts() const { return m_texts; }

    /// Once it is restored and kept by another journal, or is not wanted: its files are removed.
    void drop(const LostText &text);

private:
    std::vector<LostText> m_texts;
    std::list<FileLock> m_locks;
};

}
