// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <QStringList>

#include "core/base/file.h"

namespace romanesco {

/// Absolute, without detours.
[[nodiscard]] QString wholePath(const std::filesystem::path &path);

/// Remembers which files of the disk somebody asks for, whether they are there or not. One thread.
class NamedFiles final : public FileAccess
{
public:
    /// files must outlive it.
    explicit NamedFiles(const FileAccess &files)
        : m_files(files)
    {
    }

    [[nodiscard]] std::expected<std::string, std::string> read(const std::filesystem::path &path) const override;
    [[nodiscard]] std::expected<void, std::string> check(const std::filesystem::path &path) const override;

    /// Those that were asked for since this was asked last, with absolute paths, each once.
    [[nodiscard]] QStringList take() const;

private:
    void note(const std::filesystem::path &path) const;

    const FileAccess &m_files;
    mutable QStringList m_asked;
};

}
