// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <map>
#include <string>

#include "core/base/file.h"

namespace romanesco::test {

/// Files by their path, in memory; all else is missing. Counts how often it is asked.
class TableFiles final : public FileAccess
{
public:
    explicit TableFiles(std::map<std::string, std::string> files)
        : m_files(std::move(files))
    {
    }

    [[nodiscard]] std::expected<std::string, std::string> read(const std::filesystem::path &path) const override
    {
        ++m_reads;
        const auto file = m_files.find(path.generic_string());
        if (file == m_files.end()) {
            return std::unexpected("no such file");
        }
        return file->second;
    }

    void put(const std::string &path, const std::string &text) { m_files[path] = text; }
    void remove(const std::string &path) { m_files.erase(path); }
    [[nodiscard]] int reads() const { return m_reads; }

private:
    std::map<std::string, std::string> m_files;
    mutable int m_reads = 0;
};

inline const std::string triangleObj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

}
