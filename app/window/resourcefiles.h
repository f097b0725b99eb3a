// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include "core/base/file.h"

namespace romanesco {

/// What the program carries with it, under paths that start with ":/", and the disk under all other paths.
class ResourceFiles final : public FileAccess
{
public:
    [[nodiscard]] std::expected<std::string, std::string> read(const std::filesystem::path &path) const override;
    [[nodiscard]] std::expected<void, std::string> check(const std::filesystem::path &path) const override;

private:
    DiskFiles m_disk;
};

}
