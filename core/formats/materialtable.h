// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "copysource.h"

namespace romanesco {

/// The materials of several meshes, brought together for one file: what is alike is one material, and what only has the
/// same name gets another. Where some parts have a material and others none, these have a plain one: in a file a
/// material cannot be taken back.
class MaterialTable
{
public:
    struct Entry {
        /// Unlike all others, without line breaks, not empty.
        std::string name;
        /// Of one of the meshes.
        const Material *material;
    };

    /// The meshes must outlive it.
    explicit MaterialTable(std::span<const CopySource::Item> items);

    [[nodiscard]] const std::vector<Entry> &entries() const { return m_entries; }

    /// The entry of a part's material, or none, in one of the meshes; Mesh::none where there are no entries.
    [[nodiscard]] std::uint32_t entryOf(const Mesh &mesh, std::uint32_t material) const;

private:
    [[nodiscard]] std::uint32_t add(const Material &material);
    [[nodiscard]] std::string freeName(const std::string &name) const;

    std::vector<Entry> m_entries;
    std::uint32_t m_plain = Mesh::none;
    std::multimap<std::string, std::uint32_t> m_ofName;
    std::map<const Mesh *, std::vector<std::uint32_t>> m_ofMesh;
};

/// The parts of a mesh; one of all faces, without material and group, where it has none.
[[nodiscard]] std::vector<Mesh::Part> partsOf(const Mesh &mesh);

/// Where a part ends: the first face of the next.
[[nodiscard]] std::uint32_t endOfPart(const Mesh &mesh, std::span<const Mesh::Part> parts, std::size_t part);

}
