// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <expected>
#include <filesystem>
#include <string>

namespace romanesco {

/// Where the program keeps what it must not lose, such as journals: $XDG_DATA_HOME/romanesco, by default in
/// ~/.local/share. Made where it is not there, for the user alone. The error completes "cannot …: ".
[[nodiscard]] std::expected<std::filesystem::path, std::string> dataFolder(const char *name);

/// Where it keeps what may be lost, such as locks: $XDG_STATE_HOME/romanesco, by default in ~/.local/state. The same.
[[nodiscard]] std::expected<std::filesystem::path, std::string> stateFolder(const char *name);

}
