// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <cstddef>

#include <sys/stat.h>
#include <sys/types.h>

namespace romanesco {

/// The calls of the system by which AtomicFile writes, each as POSIX and Linux have it: -1 and errno where it fails. A
/// test puts calls that fail in their place.
class FileCalls
{
public:
    virtual ~FileCalls() = default;

    [[nodiscard]] virtual int open(const char *path, int flags);
    [[nodiscard]] virtual int openat(int folder, const char *name, int flags, mode_t mode);
    [[nodiscard]] virtual ssize_t readlinkat(int folder, const char *name, char *buffer, std::size_t size);
    [[nodiscard]] virtual int fstatat(int folder, const char *name, struct stat *status);
    /// Whether the effective user may write it.
    [[nodiscard]] virtual int mayWrite(int folder, const char *name);
    [[nodiscard]] virtual int fchown(int file, uid_t owner, gid_t group);
    [[nodiscard]] virtual int fchmod(int file, mode_t mode);
    [[nodiscard]] virtual ssize_t write(int file, const void *bytes, std::size_t size);
    [[nodiscard]] virtual int fsync(int file);
    /// Gives a file that has no name one.
    [[nodiscard]] virtual int link(int file, int folder, const char *name);
    [[nodiscard]] virtual int renameat(int folder, const char *from, const char *to);
    virtual int unlinkat(int folder, const char *name);
    virtual int close(int file);

    /// Those of the system itself.
    [[nodiscard]] static FileCalls &system();
};

}
