// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "filecalls.h"

#include <cstdio>
#include <string>

#include <fcntl.h>
#include <unistd.h>

namespace romanesco {

int FileCalls::open(const char *path, int flags)
{
    return ::open(path, flags);
}

int FileCalls::openat(int folder, const char *name, int flags, mode_t mode)
{
    return ::openat(folder, name, flags, mode);
}

ssize_t FileCalls::readlinkat(int folder, const char *name, char *buffer, std::size_t size)
{
    return ::readlinkat(folder, name, buffer, size);
}

int FileCalls::fstatat(int folder, const char *name, struct stat *status)
{
    return ::fstatat(folder, name, status, AT_SYMLINK_NOFOLLOW);
}

int FileCalls::mayWrite(int folder, const char *name)
{
    return ::faccessat(folder, name, W_OK, AT_EACCESS);
}

int FileCalls::fchown(int file, uid_t owner, gid_t group)
{
    return ::fchown(file, owner, group);
}

int FileCalls::fchmod(int file, mode_t mode)
{
    return ::fchmod(file, mode);
}

ssize_t FileCalls::write(int file, const void *bytes, std::size_t size)
{
    return ::write(file, bytes, size);
}

int FileCalls::fsync(int file)
{
    return ::fsync(file);
}

int FileCalls::link(int file, int folder, const char *name)
{
    // AT_EMPTY_PATH would need a privilege
    const std::string path = "/proc/self/fd/" + std::to_string(file);
    return ::linkat(AT_FDCWD, path.c_str(), folder, name, AT_SYMLINK_FOLLOW);
}

int FileCalls::renameat(int folder, const char *from, const char *to)
{
    return ::renameat(folder, from, folder, to);
}

int FileCalls::unlinkat(int folder, const char *name)
{
    return ::unlinkat(folder, name, 0);
}

int FileCalls::close(int file)
{
    return ::close(file);
}

FileCalls &FileCalls::system()
{
    static FileCalls calls;
    return calls;
}

}
