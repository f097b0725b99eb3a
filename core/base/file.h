// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <expected>
#include <filesystem>
#include <string>

namespace romanesco {

/// Where text and meshes come from: the disk, or an editor's unsaved buffers, or a test's own table.
/// Calls may come from any thread.
class FileAccess
{
public:
    virtual ~FileAccess() = default;

    /// The whole file as bytes, or a phrase that completes "cannot read …: " ("no such file").
    [[nodiscard]] virtual std::expected<std::string, std::string> read(const std::filesystem::path &path) const = 0;

    /// Whether read() finds a file there, or what it would say. Unless a class knows better it reads the file.
    [[nodiscard]] virtual std::expected<void, std::string> check(const std::filesystem::path &path) const;
};

/// Regular files of the disk. Everything else (a directory, a device, a pipe) is refused before it is opened for
/// reading, so that a path in a file cannot make the program wait.
class DiskFiles final : public FileAccess
{
public:
    [[nodiscard]] std::expected<std::string, std::string> read(const std::filesystem::path &path) const override;
    [[nodiscard]] std::expected<void, std::string> check(const std::filesystem::path &path) const override;
};

}
