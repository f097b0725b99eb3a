// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#include "recovery.h"

#include <algorithm>
#include <charconv>
#include <map>
#include <optional>
#include <system_error>

#include <QByteArray>
#include <QFile>
#include <QFileInfo>

#include "core/base/file.h"
#include "core/text/textjournal.h"
#include "editor/documentbytes.h"
#include "userfolders.h"

namespace romanesco {

namespace {

using Path = std::filesystem::path;
/// The files of a journal, by their generation.
using Generations = std::map<unsigned, Path>;
/// By session, then by name in it.
using Sessions = std::map<std::string, std::map<std::string, Generations>>;

/// Of files named SESSION.NUMBER.GENERATION, and of locks that nothing is left of.
Sessions sessionsIn(const Path &folder)
{
    Sessions sessions;
    std::error_code error;
    const std::filesystem::directory_iterator last;
    for (std::filesystem::directory_iterator file(folder, error); !error && file != last; file.increment(error)) {
        const std::string name = file->path().filename().native();
        const std::size_t first = name.find('.');
        const std::size_t second = name.rfind('.');
        if (first == std::string::npos) {
            continue;
        }
        auto &session = sessions[name.substr(0, first)];
        unsigned generation = 0;
        const char *nameEnd = name.data() + name.size();
        const auto [end, failure] = std::from_chars(name.data() + second + 1, nameEnd, generation);
        if (first != second && failure == std::errc() && end == nameEnd) {
            session[name.substr(first, second - first)].emplace(generation, file->path());
        }
    }
    return sessions;
}

void compareWithDisk(LostText &lost, std::uint64_t known, const FileAccess &files)
{
    if (lost.path.isEmpty()) {
        return;
    }
    const auto read = files.read(QFile::encodeName(lost.path).toStdString());
    const auto text = read ? textOf(QByteArray::fromStdString(*read)) : std::unexpected(QString());
    if (!text) {
        lost.disk = LostText::Disk::Gone;
        return;
    }
    lost.onDisk = *text;
    lost.disk = checksum(*read) == known ? LostText::Disk::Same : LostText::Disk::Changed;
}

/// The newest file that is whole enough has it.
std::optional<LostText> readLostText(const Generations &generations, const FileAccess &files)
{
    for (auto newest = generations.rbegin(); newest != generations.rend(); ++newest) {
        const auto bytes = DiskFiles().read(newest->second);
        auto kept = bytes ? readJournal(*bytes) : std::nullopt;
        if (!kept) {
            continue;
        }
        LostText lost;
        lost.path = QFile::decodeName(QByteArray::fromStdString(kept->path));
        lost.time = QFileInfo(QFile::decodeName(newest->second.c_str())).lastModified();
        lost.text = std::move(kept->text);
        compareWithDisk(lost, kept->onDisk, files);
        for (const auto &[generation, path] : generations) {
            lost.files.push_back(path);
        }
        return lost;
    }
    return std::nullopt;
}

void removeFiles(const LostText &lost)
{
    for (const Path &file : lost.files) {
        std::error_code ignored; // it is offered again then
        std::filesystem::remove(file, ignored);
    }
}

}

Recovery Recovery::search(const FileAccess &files)
{
    const auto folder = dataFolder("journals");
    return folder ? search(*folder, files) : Recovery();
}

Recovery Recovery::search(const Path &folder, const FileAccess &files)
{
    Recovery recovery;
    for (const auto &[session, journals] : sessionsIn(folder)) {
        auto lock = FileLock::take(folder / (session + ".lock"));
        if (!lock && lock.error().isHeld) {
            continue; // alive
        }
        if (lock) {
            recovery.m_locks.push_back(std::move(*lock));
        }
        for (const auto &[name, generations] : journals) {
            auto lost = readLostText(generations, files);
            if (lost && lost->text == lost->onDisk) {
                removeFiles(*lost); // saved in its last moment
            } else if (lost) {
                recovery.m_texts.push_back(std::move(*lost));
            }
        }
    }
    std::ranges::sort(recovery.m_texts, std::ranges::greater(), &LostText::time);
    return recovery;
}

void Recovery::drop(const LostText &text)
{
    removeFiles(text);
    std::erase_if(m_texts, [files = text.files](const LostText &other) { return other.files == files; });
}

}
