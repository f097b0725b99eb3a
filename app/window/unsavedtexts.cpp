// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#include "unsavedtexts.h"

#include "namedfiles.h"

namespace romanesco {

QStringList UnsavedTexts::set(const void *owner, const QString &path, const TextSnapshot &text)
{
    const std::lock_guard lock(m_mutex);
    QStringList changed;
    const auto before = m_texts.find(owner);
    if (before != m_texts.end() && before->second.path != path) {
        changed << before->second.path;
        m_texts.erase(before);
    }
    if (!path.isEmpty()) {
        m_texts[owner] = {path, text};
        changed << path;
    }
    return changed;
}

std::optional<TextSnapshot> UnsavedTexts::find(const std::filesystem::path &path) const
{
    const QString whole = wholePath(path);
    const std::lock_guard lock(m_mutex);
    for (const auto &[owner, standIn] : m_texts) {
        if (standIn.path == whole) {
            return standIn.text;
        }
    }
    return {};
}

std::expected<std::string, std::string> UnsavedTexts::read(const std::filesystem::path &path) const
{
    const auto text = find(path);
    return text ? text->bytes() : m_files.read(path);
}

std::expected<void, std::string> UnsavedTexts::check(const std::filesystem::path &path) const
{
    return find(path) ? std::expected<void, std::string>() : m_files.check(path);
}

}
