// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "systemerror.h"

#include <cerrno>
#include <system_error>

namespace romanesco {

std::string systemReason(int number)
{
    switch (number) {
    case ENOENT:
        return "no such file";
    case EISDIR:
        return "it is a directory";
    case EACCES:
    case EPERM:
        return "permission denied";
    case EROFS:
        return "read-only file system";
    case ENOSPC:
        return "disk full";
    case EDQUOT:
        return "disk quota exceeded";
    case EFBIG:
        return "larger than a file may be here";
    case EIO:
        return "the disk reports an error";
    case ELOOP:
        return "too many symbolic links";
    case ENAMETOOLONG:
        return "the name is too long";
    case EPIPE:
        return "nobody reads it";
    default:
        return std::generic_category().message(number);
    }
}

}
