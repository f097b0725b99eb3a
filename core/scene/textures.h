// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <expected>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <string>

#include "core/base/file.h"
#include "core/geometry/image.h"

namespace romanesco {

/// Makes pixels of a file's bytes. The error is a phrase that completes "no texture …: ". Called on the loading thread.
using ImageDecoder = std::function<std::expected<Image, std::string>(const std::string &bytes)>;

/// The images that textures name. Each file is read once in a round, and decoded again only when its bytes have changed.
/// One thread at a time.
class Textures
{
public:
    /// files must outlive it. Without a decoder no image is made; it is only looked whether the files are there.
    Textures(const FileAccess &files, ImageDecoder decoder);

    /// From here on files are looked at anew.
    void beginRound();
    /// Forgets the files that were not asked for in this round.
    void dropUnused();

    using Found = std::expected<std::shared_ptr<const Image>, std::string>;
    /// Null without a decoder.
    [[nodiscard]] Found find(const std::filesystem::path &path);

private:
    struct Entry {
        std::string bytes;
        Found found;
        bool isUsed = false;
    };
    void renew(Entry &entry, const std::filesystem::path &path) const;

    const FileAccess &m_files;
    ImageDecoder m_decoder;
    std::map<std::filesystem::path, Entry> m_entries;
};

}
