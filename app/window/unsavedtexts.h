// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <map>
#include <mutex>

#include <QStringList>

#include "core/base/file.h"
#include "editor/textsnapshot.h"

namespace romanesco {

/// What texts would be if they were saved: a text that is open and modified stands in for its file wherever another text
/// names that. All other files are asked of another source. read() and check() from any thread.
class UnsavedTexts final : public FileAccess
{
public:
    /// files must outlive it.
    explicit UnsavedTexts(const FileAccess &files)
        : m_files(files)
    {
    }

    /// From now on a text stands in for that file, and for no other; for none where path is empty. owner is who has the text
    /// open. Returns the files that are others than before, as NamedFiles gives them.
    QStringList set(const void *owner, const QString &path, const TextSnapshot &text);

    [[nodiscard]] std::expected<std::string, std::string> read(const std::filesystem::path &path) const override;
    [[nodiscard]] std::expected<void, std::string> check(const std::filesystem::path &path) const override;

private:
    struct StandIn {
        QString path;
        TextSnapshot text;
    };
    [[nodiscard]] std::optional<TextSnapshot> find(const std::filesystem::path &path) const;

    const FileAccess &m_files;
    mutable std::mutex m_mutex;
    std::map<const void *, StandIn> m_texts;
};

}
