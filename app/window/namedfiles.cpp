// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#include "namedfiles.h"

#include <utility>

#include <QDir>
#include <QFile>
#include <QFileInfo>

namespace romanesco {

QString wholePath(const std::filesystem::path &path)
{
    return QDir::cleanPath(QFileInfo(QFile::decodeName(path.c_str())).absoluteFilePath());
}

std::expected<std::string, std::string> NamedFiles::read(const std::filesystem::path &path) const
{
    note(path);
    return m_files.read(path);
}

std::expected<void, std::string> NamedFiles::check(const std::filesystem::path &path) const
{
    note(path);
    return m_files.check(path);
}

QStringList NamedFiles::take() const
{
    m_asked.removeDuplicates();
    return std::exchange(m_asked, {});
}

void NamedFiles::note(const std::filesystem::path &path) const
{
    if (!path.native().starts_with(":/")) {
        m_asked << wholePath(path);
    }
}

}
