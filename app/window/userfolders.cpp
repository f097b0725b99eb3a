// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#include "userfolders.h"

#include <system_error>

#include <QByteArray>

#include "core/base/systemerror.h"

namespace romanesco {

namespace {

std::expected<std::filesystem::path, std::string> made(const std::filesystem::path &folder)
{
    std::error_code error;
    if (std::filesystem::create_directories(folder, error)) {
        std::filesystem::permissions(folder, std::filesystem::perms::owner_all, error);
    }
    if (error) {
        return std::unexpected(systemReason(error.value()));
    }
    return folder;
}

std::expected<std::filesystem::path, std::string> userFolder(const char *variable, const char *usual, const char *name)
{
    std::filesystem::path base = qgetenv(variable).toStdString();
    if (!base.is_absolute()) { // as the standard asks
        const std::filesystem::path home = qgetenv("HOME").toStdString();
        if (!home.is_absolute()) {
            return std::unexpected("there is no home directory");
        }
        base = home / usual;
    }
    return made(base / "romanesco" / name);
}

}

std::expected<std::filesystem::path, std::string> dataFolder(const char *name)
{
    return userFolder("XDG_DATA_HOME", ".local/share", name);
}

std::expected<std::filesystem::path, std::string> stateFolder(const char *name)
{
    return userFolder("XDG_STATE_HOME", ".local/state", name);
}

}
