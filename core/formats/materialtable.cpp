// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "materialtable.h"

#include <algorithm>
#include <cassert>

namespace romanesco {

namespace {

std::string oneLine(std::string name)
{
    std::ranges::replace_if(name, [](char c) { return static_cast<unsigned char>(c) < ' ' || c == '\x7F'; }, '_');
    return name.empty() ? "material" : name;
}

const Material &plainMaterial()
{
    static const Material plain = [] {
        Material material;
        material.name = "default";
        return material;
    }();
    return plain;
}

}

MaterialTable::MaterialTable(std::span<const CopySource::Item> items)
{
    bool lacksSome = false;
    for (const CopySource::Item &item : items) {
        const auto [known, isNew] = m_ofMesh.try_emplace(item.mesh);
        if (!isNew) {
            continue;
        }
        for (const Material &material : item.mesh->materials) {
            known->second.push_back(add(material));
        }
        lacksSome = lacksSome || std::ranges::contains(partsOf(*item.mesh), Mesh::none, &Mesh::Part::material);
    }
    if (lacksSome && !m_entries.empty()) {
        m_plain = add(plainMaterial());
    }
}

std::uint32_t MaterialTable::entryOf(const Mesh &mesh, std::uint32_t material) const
{
    assert(material == Mesh::none || material < mesh.materials.size());
    return material == Mesh::none ? m_plain : m_ofMesh.at(&mesh)[material];
}

std::uint32_t MaterialTable::add(const Material &material)
{
    const auto [begin, end] = m_ofName.equal_range(material.name);
    for (auto known = begin; known != end; ++known) {
        if (*m_entries[known->second].material == material) {
            return known->second;
        }
    }
    const auto entry = static_cast<std::uint32_t>(m_entries.size());
    m_entries.push_back({freeName(oneLine(material.name)), &material});
    m_ofName.emplace(material.name, entry);
    return entry;
}

std::string MaterialTable::freeName(const std::string &name) const
{
    const auto isTaken = [&](const std::string &wanted) {
        return std::ranges::find(m_entries, wanted, &Entry::name) != m_entries.end();
    };
    std::string free = name;
    for (int number = 2; isTaken(free); ++number) {
        free = name + "_" + std::to_string(number);
    }
    return free;
}

std::vector<Mesh::Part> partsOf(const Mesh &mesh)
{
    return mesh.parts.empty() ? std::vector{Mesh::Part{}} : mesh.parts;
}

std::uint32_t endOfPart(const Mesh &mesh, std::span<const Mesh::Part> parts, std::size_t part)
{
    return part + 1 < parts.size() ? parts[part + 1].firstFace : static_cast<std::uint32_t>(mesh.faces.size());
}

}
