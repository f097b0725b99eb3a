// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <expected>
#include <filesystem>
#include <string>
#include <string_view>

#include "bytesink.h"
#include "filecalls.h"

namespace romanesco {

/// A file that appears whole or not at all, whatever happens in between: a full disk, a process killed, a machine that
/// loses its power. Until commit() the path holds what it held before; after it, the new bytes, which are then on the
/// disk.
///
/// The bytes go to a file without a name (O_TMPFILE) in the folder of the target, so that nothing is left behind by a
/// process that ends; where the file system has no such files, to a hidden one, which a process that is killed leaves.
/// To take the place of an old file even the first kind has a hidden name for an instant.
///
/// Only regular files are written over, and only where the user may write them: a device, a pipe and a folder are
/// refused. A symbolic link stays and its target is written. A file that is written over keeps its permissions, and its
/// owner and group where the user may give them; a new one has those of the umask. Access lists and hard links are not
/// kept. Errors are phrases that complete "cannot write …: ". One thread at a time.
class AtomicFile final : public ByteSink
{
public:
    /// Opens the target's folder and a file in it, not the target.
    [[nodiscard]] static std::expected<AtomicFile, std::string> create(const std::filesystem::path &path,
                                                                       FileCalls &calls = FileCalls::system());

    AtomicFile(AtomicFile &&other) noexcept;
    AtomicFile &operator=(AtomicFile &&) = delete;
    /// Without commit() nothing has happened.
    ~AtomicFile() override;

    /// Not buffered: each call is one of the system, or more. After an error commit() must not be called.
    [[nodiscard]] std::expected<void, std::string> write(std::string_view bytes) override;

    /// Waits until the bytes are on the disk and puts them in their place; once, as the last call. Where the very last
    /// step fails (the folder cannot be put on the disk) the new file stands there whole, and it is an error nevertheless.
    [[nodiscard]] std::expected<void, std::string> commit();

private:
    using Result = std::expected<void, std::string>;

    explicit AtomicFile(FileCalls &calls)
        : m_calls(&calls)
    {
    }
    [[nodiscard]] Result findTarget(std::filesystem::path path);
    [[nodiscard]] Result openFolder(const std::filesystem::path &folder);
    [[nodiscard]] Result openFile();
    [[nodiscard]] bool openUnnamed(mode_t mode);
    [[nodiscard]] bool openHidden(mode_t mode);
    [[nodiscard]] Result keepOwnerAndMode(const struct stat &old);
    [[nodiscard]] bool takeName();
    [[nodiscard]] bool takeHiddenName();

    FileCalls *m_calls;
    int m_folder = -1;
    int m_file = -1;
    /// Of the target, in the folder.
    std::string m_name;
    /// The name that the file has so far; empty for none.
    std::string m_hiddenName;
};

/// The bytes as the whole of a file.
[[nodiscard]] std::expected<void, std::string> writeWhole(const std::filesystem::path &path, std::string_view bytes);

}
