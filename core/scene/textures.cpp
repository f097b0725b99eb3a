// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "textures.h"

#include <utility>

namespace romanesco {

Textures::Textures(const FileAccess &files, ImageDecoder decoder)
    : m_files(files)
    , m_decoder(std::move(decoder))
{
}

void Textures::beginRound()
{
    for (auto &[path, entry] : m_entries) {
        entry.isUsed = false;
    }
}

void Textures::dropUnused()
{
    std::erase_if(m_entries, [](const auto &known) { return !known.second.isUsed; });
}

Textures::Found Textures::find(const std::filesystem::path &path)
{
    Entry &entry = m_entries[path];
    if (!std::exchange(entry.isUsed, true)) {
        renew(entry, path);
    }
    return entry.found;
}

void Textures::renew(Entry &entry, const std::filesystem::path &path) const
{
    if (!m_decoder) {
        entry.found = m_files.check(path).transform([] { return std::shared_ptr<const Image>(); });
        return;
    }
    auto bytes = m_files.read(path);
    if (!bytes) {
        entry = {{}, std::unexpected(bytes.error()), true};
    } else if (!entry.found || !*entry.found || *bytes != entry.bytes) {
        entry.found =
            m_decoder(*bytes).transform([](Image &&image) { return std::make_shared<const Image>(std::move(image)); });
        entry.bytes = std::move(*bytes);
    }
}

}
