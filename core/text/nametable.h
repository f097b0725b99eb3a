// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>

namespace romanesco {

/// A name as a number: within one table equal names have equal numbers, so that what names mean can be kept in arrays.
using NameId = std::uint32_t;

/// The names seen so far. It only grows; nothing moves when it does.
class NameTable
{
public:
    /// The empty name, which is there from the start.
    static constexpr NameId nameless = 0;

    NameTable() { (void)idOf({}); }
    // keys are views of the names
    NameTable(const NameTable &) = delete;
    NameTable &operator=(const NameTable &) = delete;
    NameTable(NameTable &&) = default; // NOLINT(performance-noexcept-move-constructor): a deque allocates
    NameTable &operator=(NameTable &&) = default;

    /// The number of a name, a new one if need be. One look-up in a hash table.
    NameId idOf(std::string_view name)
    {
        const auto known = m_ids.find(name);
        if (known != m_ids.end()) {
            return known->second;
        }
        const auto id = static_cast<NameId>(m_names.size());
        m_ids.emplace(m_names.emplace_back(name), id);
        return id;
    }

    /// The number of a name that is there.
    [[nodiscard]] std::optional<NameId> find(std::string_view name) const
    {
        const auto known = m_ids.find(name);
        return known == m_ids.end() ? std::nullopt : std::optional(known->second);
    }

    [[nodiscard]] std::string_view operator[](NameId id) const { return m_names[id]; }
    [[nodiscard]] std::size_t size() const { return m_names.size(); }

private:
    std::deque<std::string> m_names;
    std::unordered_map<std::string_view, NameId> m_ids;
};

}
