// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#include "resourcefiles.h"

#include <QFile>

namespace romanesco {

std::expected<std::string, std::string> ResourceFiles::read(const std::filesystem::path &path) const
{
    if (!path.native().starts_with(":/")) {
        return m_disk.read(path);
    }
    QFile file(QString::fromStdString(path.lexically_normal().generic_string()));
    if (!file.open(QIODevice::ReadOnly)) {
        return std::unexpected("no such file");
    }
    return file.readAll().toStdString();
}

std::expected<void, std::string> ResourceFiles::check(const std::filesystem::path &path) const
{
    return path.native().starts_with(":/") ? FileAccess::check(path) : m_disk.check(path);
}

}
