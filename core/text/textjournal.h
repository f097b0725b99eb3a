// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <cstdint>
#include <expected>
#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>

#include "core/base/filecalls.h"

namespace romanesco {

/// Tells texts apart that are not made to look alike (FNV-1a).
[[nodiscard]] std::uint64_t checksum(std::string_view bytes, std::uint64_t seed = 0xcbf29ce484222325);

/// A text as a journal keeps it.
struct KeptText {
    /// Of its file; empty for none.
    std::string path;
    /// The checksum of that file's bytes when the text was last the same; 0 for none.
    std::uint64_t onDisk = 0;
    std::string text;
    bool operator==(const KeptText &) const = default;
};

/// A text as it is edited, written down as it goes so that a process that is killed loses nothing. Each edit is appended;
/// when the file has grown long, or could not be written to its end, another takes its place: files are named
/// NAME.1, NAME.2, … A file is lines in words, each followed by as many bytes as it says and an LF:
///
///     file CHECKSUM LENGTH SUM        the path, and the checksum of what is on the disk there
///     text 0 LENGTH SUM               the whole text
///     edit OFFSET REMOVED LENGTH SUM  bytes in place of so many
///
/// SUM is the checksum of the words before it and of the bytes.
class TextJournal
{
public:
    /// Nothing is made before the first put(). The folder must be there by then.
    TextJournal(std::filesystem::path folder, std::string name, FileCalls &calls = FileCalls::system());
    TextJournal(const TextJournal &) = delete;
    TextJournal &operator=(const TextJournal &) = delete;
    /// What is written stays.
    ~TextJournal();

    /// Hands what is new of the text over to the system: from then on it outlives the process. The error completes "cannot
    /// write …: "; the text that was put before is still there, and the next put() makes up for it. Cost: the text is read
    /// once, what differs is written.
    [[nodiscard]] std::expected<void, std::string> put(const KeptText &kept);

    /// Waits until what was put is on the disk, so that it outlives the machine too; drops what it took the place of. Also
    /// while put() runs on another thread.
    [[nodiscard]] std::expected<void, std::string> settle();

    /// Nothing is kept.
    void remove();

private:
    using Result = std::expected<void, std::string>;
    struct OpenFile;

    [[nodiscard]] Result openFolder();
    [[nodiscard]] Result start(const KeptText &kept);
    [[nodiscard]] Result append(const KeptText &kept);
    [[nodiscard]] Result write(std::string_view words, std::string_view bytes);
    [[nodiscard]] std::string nameOf(unsigned generation) const;
    [[nodiscard]] bool isLong() const;

    std::filesystem::path m_folderPath;
    std::string m_name;
    FileCalls &m_calls;
    std::shared_ptr<OpenFile> m_folder;

    /// Guards m_file and the generations, which settle() looks at.
    std::mutex m_mutex;
    std::shared_ptr<OpenFile> m_file;
    unsigned m_generation = 0;
    unsigned m_oldest = 1;

    /// What the file says.
    KeptText m_kept;
    bool m_isTorn = false;
    std::size_t m_startLength = 0;
    std::size_t m_appendedLength = 0;
    std::size_t m_appendedCount = 0;
};

/// What a journal's file says up to where it is whole; nothing where not even its first text is.
[[nodiscard]] std::optional<KeptText> readJournal(std::string_view bytes);

}
