// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "textjournal.h"

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <format>
#include <utility>

#include <fcntl.h>

#include "core/base/systemerror.h"
#include "textedit.h"

namespace romanesco {

namespace {

/// Reading goes through all edits, each of which may move all of the text.
constexpr std::size_t mostEdits = 1'000;
constexpr std::size_t leastLength = 65'536;

std::uint64_t sumOf(std::string_view words, std::string_view bytes)
{
    return checksum(bytes, checksum(words));
}

}

std::uint64_t checksum(std::string_view bytes, std::uint64_t seed)
{
    for (const char byte : bytes) {
        seed = (seed ^ static_cast<unsigned char>(byte)) * 0x100000001b3;
    }
    return seed;
}

struct TextJournal::OpenFile {
    FileCalls &calls;
    int descriptor;

    OpenFile(FileCalls &c, int d)
        : calls(c)
        , descriptor(d)
    {
    }
    OpenFile(const OpenFile &) = delete;
    OpenFile &operator=(const OpenFile &) = delete;
    ~OpenFile() { calls.close(descriptor); }
};

TextJournal::TextJournal(std::filesystem::path folder, std::string name, FileCalls &calls)
    : m_folderPath(std::move(folder))
    , m_name(std::move(name))
    , m_calls(calls)
{
}

TextJournal::~TextJournal() = default;

std::expected<void, std::string> TextJournal::put(const KeptText &kept)
{
    if (!m_file || m_isTorn) {
        return start(kept);
    }
    if (isLong() && start(kept)) {
        return {};
    }
    return append(kept);
}

bool TextJournal::isLong() const
{
    return m_appendedCount >= mostEdits || m_appendedLength > m_startLength + leastLength;
}

std::string TextJournal::nameOf(unsigned generation) const
{
    return m_name + '.' + std::to_string(generation);
}

TextJournal::Result TextJournal::openFolder()
{
    if (!m_folder) {
        const int folder = m_calls.open(m_folderPath.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
        if (folder < 0) {
            return std::unexpected(systemReason(errno));
        }
        m_folder = std::make_shared<OpenFile>(m_calls, folder);
    }
    return {};
}

/// A new file with all of it.
TextJournal::Result TextJournal::start(const KeptText &kept)
{
    if (Result opened = openFolder(); !opened) {
        return opened;
    }
    const std::string name = nameOf(m_generation + 1);
    const int descriptor = m_calls.openat(m_folder->descriptor, name.c_str(),
                                          O_CREAT | O_EXCL | O_WRONLY | O_APPEND | O_CLOEXEC, S_IRUSR | S_IWUSR);
    if (descriptor < 0) {
        return std::unexpected(systemReason(errno));
    }
    auto file = std::make_shared<OpenFile>(m_calls, descriptor);
    {
        const std::lock_guard lock(m_mutex);
        std::swap(m_file, file);
    }
    Result written = write(std::format("file {:x}", kept.onDisk), kept.path);
    written = written ? write("text 0", kept.text) : std::move(written);
    const std::lock_guard lock(m_mutex);
    if (!written) {
        // What is on the disk of the file before is better than a part of this one.
        m_calls.unlinkat(m_folder->descriptor, name.c_str());
        m_file = std::move(file);
        return written;
    }
    ++m_generation;
    m_kept = kept;
    m_isTorn = false;
    m_startLength = kept.text.size();
    m_appendedLength = 0;
    m_appendedCount = 0;
    return {};
}

TextJournal::Result TextJournal::append(const KeptText &kept)
{
    Result written;
    if (kept.path != m_kept.path || kept.onDisk != m_kept.onDisk) {
        written = write(std::format("file {:x}", kept.onDisk), kept.path);
    }
    const std::string_view before = m_kept.text;
    const std::string_view now = kept.text;
    const std::size_t start = commonStart(before, now);
    const std::size_t end = commonEnd(before.substr(start), now.substr(start));
    const std::size_t removed = before.size() - start - end;
    const std::string_view added = now.substr(start, now.size() - start - end);
    if (written && (removed > 0 || !added.empty())) {
        written = write(std::format("edit {} {}", start, removed), added);
    }
    if (!written) {
        m_isTorn = true;
        return written;
    }
    m_kept.path = kept.path;
    m_kept.onDisk = kept.onDisk;
    m_kept.text.replace(start, removed, added);
    return {};
}

/// In one call of the system where that takes it all, so that hardly ever half a line is left.
TextJournal::Result TextJournal::write(std::string_view words, std::string_view bytes)
{
    std::string line = std::format("{} {} ", words, bytes.size());
    line += std::format("{:016x}\n", sumOf(line, bytes));
    line += bytes;
    line += '\n';
    ++m_appendedCount;
    m_appendedLength += line.size();
    std::string_view rest = line;
    while (!rest.empty()) {
        const ssize_t written = m_calls.write(m_file->descriptor, rest.data(), rest.size());
        if (written <= 0 && !(written < 0 && errno == EINTR)) {
            return std::unexpected(systemReason(written == 0 ? EIO : errno));
        }
        rest.remove_prefix(written > 0 ? static_cast<std::size_t>(written) : 0);
    }
    return {};
}

std::expected<void, std::string> TextJournal::settle()
{
    std::unique_lock lock(m_mutex);
    const std::shared_ptr<OpenFile> file = m_file;
    const std::shared_ptr<OpenFile> folder = m_folder;
    const unsigned generation = m_generation;
    if (!file || generation == 0) {
        return {};
    }
    lock.unlock();
    // EINVAL: a file system that has nothing to put on a disk.
    for (const int descriptor : {file->descriptor, folder->descriptor}) {
        if (m_calls.fsync(descriptor) != 0 && errno != EINVAL) {
            return std::unexpected(systemReason(errno));
        }
    }
    lock.lock();
    for (; m_oldest < generation; ++m_oldest) {
        m_calls.unlinkat(folder->descriptor, nameOf(m_oldest).c_str());
    }
    return {};
}

void TextJournal::remove()
{
    const std::lock_guard lock(m_mutex);
    for (; m_oldest <= m_generation; ++m_oldest) {
        m_calls.unlinkat(m_folder->descriptor, nameOf(m_oldest).c_str());
    }
    m_file.reset();
}

namespace {

/// Takes records off the front of a journal.
class Reader
{
public:
    explicit Reader(std::string_view bytes)
        : m_rest(bytes)
    {
    }

    /// Whether there is one more that is whole.
    bool next()
    {
        const std::size_t lineEnd = m_rest.find('\n');
        if (lineEnd == std::string_view::npos || lineEnd < sumLength) {
            return false;
        }
        const std::string_view words = m_rest.substr(0, lineEnd - sumLength);
        m_kind = words.substr(0, words.find(' '));
        m_words = words.substr(m_kind.size());
        // The length is the last word.
        const std::size_t last = words.substr(0, words.size() - 1).rfind(' ');
        std::size_t length = 0;
        if (last == std::string_view::npos || !read(words.substr(last + 1), length)
            || length >= m_rest.size() - lineEnd - 1) {
            return false;
        }
        m_bytes = m_rest.substr(lineEnd + 1, length);
        std::uint64_t sum = 0;
        if (!read(m_rest.substr(lineEnd - sumLength), sum, 16) || sum != sumOf(words, m_bytes)) {
            return false;
        }
        m_rest.remove_prefix(lineEnd + 1 + length + 1);
        return true;
    }

    [[nodiscard]] std::string_view kind() const { return m_kind; }
    [[nodiscard]] std::string_view bytes() const { return m_bytes; }
    /// The next of the numbers between the kind and the length.
    template<typename Number>
    [[nodiscard]] bool takeNumber(Number &number, int base = 10)
    {
        m_words.remove_prefix(std::min<std::size_t>(m_words.size(), 1));
        const bool isThere = read(m_words, number, base);
        m_words.remove_prefix(std::min(m_words.find(' '), m_words.size()));
        return isThere;
    }

private:
    static constexpr std::size_t sumLength = 16;

    template<typename Number>
    static bool read(std::string_view word, Number &number, int base = 10)
    {
        return std::from_chars(word.data(), word.data() + word.size(), number, base).ec == std::errc();
    }

    std::string_view m_rest;
    std::string_view m_kind;
    std::string_view m_words;
    std::string_view m_bytes;
};

/// Whether the record makes sense.
bool takeOver(Reader &record, KeptText &kept)
{
    if (record.kind() == "file") {
        const bool isThere = record.takeNumber(kept.onDisk, 16);
        kept.path = isThere ? record.bytes() : kept.path;
        return isThere;
    }
    if (record.kind() == "text") {
        kept.text = record.bytes();
        return true;
    }
    std::size_t offset = 0;
    std::size_t removed = 0;
    if (record.kind() != "edit" || !record.takeNumber(offset) || !record.takeNumber(removed)
        || offset > kept.text.size() || removed > kept.text.size() - offset) {
        return false;
    }
    kept.text.replace(offset, removed, record.bytes());
    return true;
}

}

std::optional<KeptText> readJournal(std::string_view bytes)
{
    Reader record(bytes);
    KeptText kept;
    bool hasText = false;
    while (record.next()) {
        const bool isText = record.kind() == "text";
        if (!takeOver(record, kept)) {
            break;
        }
        hasText = hasText || isText;
    }
    return hasText ? std::optional(std::move(kept)) : std::nullopt;
}

}
