// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "atomicfile.h"

#include <array>
#include <atomic>
#include <cassert>
#include <cerrno>
#include <climits>
#include <optional>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <unistd.h>

#include "systemerror.h"

namespace romanesco {

namespace {

/// As many as Linux follows.
constexpr int mostLinks = 40;
constexpr int mostNames = 1'000;

std::unexpected<std::string> failure(int number = errno)
{
    return std::unexpected(systemReason(number));
}

/// A name that no other file has: of this process, and each time another. The one who opens it checks.
std::string newHiddenName()
{
    static std::atomic<unsigned> count = 0;
    return ".romanesco-" + std::to_string(::getpid()) + "-" + std::to_string(count++);
}

/// Tries hidden names until one is free; act() is a call of the system.
template<typename Act>
bool withFreeName(std::string &name, const Act &act)
{
    for (int i = 0; i < mostNames; ++i) {
        name = newHiddenName();
        if (act() >= 0) {
            return true;
        }
        if (errno != EEXIST) {
            break;
        }
    }
    name.clear();
    return false;
}

}

std::expected<AtomicFile, std::string> AtomicFile::create(const std::filesystem::path &path, FileCalls &calls)
{
    if (path.native().contains('\0')) {
        return failure(ENOENT); // the system would see a shorter name
    }
    AtomicFile file(calls);
    if (Result found = file.findTarget(path); !found) {
        return std::unexpected(std::move(found.error()));
    }
    if (Result opened = file.openFile(); !opened) {
        return std::unexpected(std::move(opened.error()));
    }
    return file;
}

AtomicFile::AtomicFile(AtomicFile &&other) noexcept
    : m_calls(other.m_calls)
    , m_folder(std::exchange(other.m_folder, -1))
    , m_file(std::exchange(other.m_file, -1))
    , m_name(std::move(other.m_name))
    , m_hiddenName(std::exchange(other.m_hiddenName, {}))
{
}

AtomicFile::~AtomicFile()
{
    if (!m_hiddenName.empty()) {
        m_calls->unlinkat(m_folder, m_hiddenName.c_str());
    }
    if (m_file >= 0) {
        m_calls->close(m_file);
    }
    if (m_folder >= 0) {
        m_calls->close(m_folder);
    }
}

/// Follows links by hand: the file is to be made in the folder of what they lead to, which need not exist.
AtomicFile::Result AtomicFile::findTarget(std::filesystem::path path)
{
    for (int i = 0; i < mostLinks; ++i) {
        m_name = path.filename().native();
        if (m_name.empty() || m_name == "." || m_name == "..") {
            return std::unexpected("it is a directory");
        }
        if (Result opened = openFolder(path.parent_path()); !opened) {
            return opened;
        }
        std::array<char, PATH_MAX> buffer;
        const ssize_t length = m_calls->readlinkat(m_folder, m_name.c_str(), buffer.data(), buffer.size());
        if (length < 0 && (errno == EINVAL || errno == ENOENT)) {
            return {}; // no link, or nothing yet
        }
        if (length < 0) {
            return failure();
        }
        path = path.parent_path() / std::filesystem::path(buffer.data(), buffer.data() + length);
    }
    return failure(ELOOP);
}

AtomicFile::Result AtomicFile::openFolder(const std::filesystem::path &folder)
{
    if (m_folder >= 0) {
        m_calls->close(std::exchange(m_folder, -1));
    }
    const char *path = folder.empty() ? "." : folder.c_str();
    m_folder = m_calls->open(path, O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (m_folder < 0 && errno == EACCES) {
        m_folder = m_calls->open(path, O_PATH | O_DIRECTORY | O_CLOEXEC); // files may be made where none may be listed
    }
    if (m_folder < 0) {
        return errno == ENOENT ? std::unexpected(std::string("no such folder")) : failure();
    }
    return {};
}

AtomicFile::Result AtomicFile::openFile()
{
    std::optional<struct stat> old;
    struct stat status{};
    if (m_calls->fstatat(m_folder, m_name.c_str(), &status) == 0) {
        old = status;
    } else if (errno != ENOENT) {
        return failure();
    }
    if (old && S_ISDIR(old->st_mode)) {
        return std::unexpected("it is a directory");
    }
    if (old && !S_ISREG(old->st_mode)) {
        return std::unexpected("it is not a regular file");
    }
    if (old && m_calls->mayWrite(m_folder, m_name.c_str()) != 0) {
        return failure(); // a rename would not ask
    }
    // What replaces a file that others may not read must not be theirs to read while it is written.
    const mode_t mode = old ? S_IRUSR | S_IWUSR : S_IRUSR | S_IWUSR | S_IRGRP | S_IWGRP | S_IROTH | S_IWOTH;
    if (!openUnnamed(mode) && !openHidden(mode)) {
        return failure();
    }
    return old ? keepOwnerAndMode(*old) : Result();
}

/// Not where there is no way to give the file a name at last.
bool AtomicFile::openUnnamed(mode_t mode)
{
    std::error_code ignored;
    if (!std::filesystem::exists("/proc/self/fd", ignored)) {
        return false;
    }
    m_file = m_calls->openat(m_folder, ".", O_TMPFILE | O_WRONLY | O_CLOEXEC, mode);
    return m_file >= 0;
}

bool AtomicFile::openHidden(mode_t mode)
{
    return withFreeName(m_hiddenName, [&] {
        return m_file = m_calls->openat(m_folder, m_hiddenName.c_str(), O_CREAT | O_EXCL | O_WRONLY | O_CLOEXEC, mode);
    });
}

AtomicFile::Result AtomicFile::keepOwnerAndMode(const struct stat &old)
{
    // Only the superuser may give files away, and a group only its members: else the file is the user's own.
    if (m_calls->fchown(m_file, old.st_uid, old.st_gid) != 0) {
        static_cast<void>(m_calls->fchown(m_file, static_cast<uid_t>(-1), old.st_gid));
    }
    return m_calls->fchmod(m_file, old.st_mode & 0777) == 0 ? Result() : failure();
}

std::expected<void, std::string> AtomicFile::write(std::string_view bytes)
{
    while (!bytes.empty()) {
        const ssize_t written = m_calls->write(m_file, bytes.data(), bytes.size());
        if (written > 0) {
            bytes.remove_prefix(static_cast<std::size_t>(written));
        } else if (written == 0) {
            return failure(EIO); // else this would go on for ever
        } else if (errno != EINTR) {
            return failure();
        }
    }
    return {};
}

std::expected<void, std::string> AtomicFile::commit()
{
    assert(m_file >= 0 && "committed once");
    // The bytes before the name: else a crash could leave the name of an empty file.
    if (m_calls->fsync(m_file) != 0 || !takeName()) {
        return failure();
    }
    m_calls->close(std::exchange(m_file, -1));
    // EBADF: a folder that may not be listed. EINVAL: a file system that has nothing to put on a disk.
    if (m_calls->fsync(m_folder) != 0 && errno != EBADF && errno != EINVAL) {
        return failure();
    }
    return {};
}

bool AtomicFile::takeName()
{
    if (m_hiddenName.empty()) {
        if (m_calls->link(m_file, m_folder, m_name.c_str()) == 0) {
            return true;
        }
        // A link never replaces a file, only a rename does, and that takes a name.
        if (errno != EEXIST || !takeHiddenName()) {
            return false;
        }
    }
    if (m_calls->renameat(m_folder, m_hiddenName.c_str(), m_name.c_str()) != 0) {
        return false;
    }
    m_hiddenName.clear();
    return true;
}

bool AtomicFile::takeHiddenName()
{
    return withFreeName(m_hiddenName, [&] { return m_calls->link(m_file, m_folder, m_hiddenName.c_str()); });
}

std::expected<void, std::string> writeWhole(const std::filesystem::path &path, std::string_view bytes)
{
    auto file = AtomicFile::create(path);
    if (!file) {
        return std::unexpected(std::move(file.error()));
    }
    if (auto written = file->write(bytes); !written) {
        return written;
    }
    return file->commit();
}

}
