// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "filelock.h"

#include <cerrno>
#include <utility>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include "systemerror.h"

namespace romanesco {

namespace {

/// Each time another process gave the lock back in between; they cannot do so for ever.
constexpr int mostTries = 1'000;

/// Whoever gives a lock back removes its file, which may be the one that was just opened here.
bool isStillThere(int descriptor, const std::filesystem::path &file)
{
    struct stat opened{};
    struct stat named{};
    return ::fstat(descriptor, &opened) == 0 && ::stat(file.c_str(), &named) == 0 && opened.st_dev == named.st_dev
        && opened.st_ino == named.st_ino;
}

}

std::expected<FileLock, FileLock::Refusal> FileLock::take(const std::filesystem::path &file)
{
    for (int i = 0; i < mostTries; ++i) {
        // Without O_NONBLOCK a pipe of that name would wait for its other end.
        const int descriptor = ::open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NONBLOCK | O_NOFOLLOW, 0600);
        if (descriptor < 0) {
            return std::unexpected(Refusal{false, systemReason(errno)});
        }
        if (::flock(descriptor, LOCK_EX | LOCK_NB) != 0) {
            const int reason = errno;
            ::close(descriptor);
            return std::unexpected(Refusal{reason == EWOULDBLOCK, systemReason(reason)});
        }
        if (isStillThere(descriptor, file)) {
            return FileLock(file, descriptor);
        }
        ::close(descriptor);
    }
    return std::unexpected(Refusal{true, systemReason(EWOULDBLOCK)});
}

FileLock::FileLock(std::filesystem::path file, int descriptor)
    : m_file(std::move(file))
    , m_descriptor(descriptor)
{
}

FileLock::FileLock(FileLock &&other) noexcept
    : m_file(std::move(other.m_file))
    , m_descriptor(std::exchange(other.m_descriptor, -1))
{
}

FileLock &FileLock::operator=(FileLock &&other) noexcept
{
    std::swap(m_file, other.m_file);
    std::swap(m_descriptor, other.m_descriptor);
    return *this;
}

FileLock::~FileLock()
{
    if (m_descriptor >= 0) {
        // While it is still held: afterwards the name might be another's.
        ::unlink(m_file.c_str());
        ::close(m_descriptor);
    }
}

}
