// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <expected>
#include <filesystem>
#include <string>

namespace romanesco {

/// A lock that one process at a time has, and one place in it. It ends with its process, whatever ends that: the system
/// holds it (flock) and no number is written down that another process might have later. Where home is on a network, it
/// holds between machines as far as that file system's locks do.
class FileLock
{
public:
    struct Refusal {
        /// Somebody has it; else there can be no lock there, for the reason.
        bool isHeld = false;
        /// Completes "cannot lock …: ".
        std::string reason;
    };

    /// Makes the file, which stands for the lock alone. Does not wait.
    [[nodiscard]] static std::expected<FileLock, Refusal> take(const std::filesystem::path &file);

    FileLock(FileLock &&other) noexcept;
    FileLock &operator=(FileLock &&other) noexcept;
    /// Gives it back, and the file is gone.
    ~FileLock();

    [[nodiscard]] const std::filesystem::path &file() const { return m_file; }

private:
    FileLock(std::filesystem::path file, int descriptor);

    std::filesystem::path m_file;
    int m_descriptor;
};

}
