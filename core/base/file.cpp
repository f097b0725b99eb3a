// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "file.h"

#include <cerrno>
#include <utility>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include "systemerror.h"

namespace romanesco {

namespace {

/// A file is read whole; one of a mistaken size must not take all the memory there is.
constexpr off_t largestFile = 2'000'000'000;

class Descriptor
{
public:
    explicit Descriptor(int number)
        : m_number(number)
    {
    }
    ~Descriptor()
    {
        if (m_number >= 0) {
            ::close(m_number);
        }
    }
    Descriptor(Descriptor &&other) noexcept
        : m_number(std::exchange(other.m_number, -1))
    {
    }
    Descriptor &operator=(Descriptor &&) = delete;
    operator int() const { return m_number; }

private:
    int m_number;
};

std::unexpected<std::string> failure(int number)
{
    return std::unexpected(systemReason(number));
}

struct RegularFile {
    Descriptor descriptor;
    off_t size = 0;
};

std::expected<RegularFile, std::string> open(const std::filesystem::path &path)
{
    if (path.native().contains('\0')) {
        return failure(ENOENT); // open() would see a shorter name
    }

    // Without O_NONBLOCK the opening of a pipe would wait for its writer.
    Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
    if (file < 0) {
        return failure(errno);
    }
    struct stat status{};
    if (::fstat(file, &status) != 0) {
        return failure(errno);
    }
    if (S_ISDIR(status.st_mode)) {
        return std::unexpected("it is a directory");
    }
    if (!S_ISREG(status.st_mode)) {
        return std::unexpected("it is not a regular file");
    }
    if (status.st_size > largestFile) {
        return std::unexpected("it is larger than 2 GB");
    }
    return RegularFile{std::move(file), status.st_size};
}

}

std::expected<void, std::string> FileAccess::check(const std::filesystem::path &path) const
{
    return read(path).transform([](const std::string &) { });
}

std::expected<void, std::string> DiskFiles::check(const std::filesystem::path &path) const
{
    return open(path).transform([](const RegularFile &) { });
}

std::expected<std::string, std::string> DiskFiles::read(const std::filesystem::path &path) const
{
    const auto opened = open(path);
    if (!opened) {
        return std::unexpected(opened.error());
    }
    const Descriptor &file = opened->descriptor;

    // The size is a hint: a file may grow or shrink while it is read.
    std::string bytes;
    std::size_t used = 0;
    bytes.resize(static_cast<std::size_t>(opened->size) + 1);
    while (true) {
        const ssize_t got = ::read(file, bytes.data() + used, bytes.size() - used);
        if (got < 0 && errno == EINTR) {
            continue;
        }
        if (got < 0) {
            return failure(errno);
        }
        if (got == 0) {
            break;
        }
        used += static_cast<std::size_t>(got);
        if (used == bytes.size()) {
            bytes.resize(bytes.size() * 2);
        }
    }
    bytes.resize(used);
    return bytes;
}

}
