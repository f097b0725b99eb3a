// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "objparts.h"

namespace romanesco {

namespace {

/// Names count from 1 in the table, where 0 is no name, and from 0 in the mesh.
std::uint32_t indexOf(NameTable &names, std::string_view name)
{
    static_assert(NameTable::nameless - 1 == Mesh::none);
    return names.idOf(name) - 1;
}

bool isLike(const Mesh::Part &a, const Mesh::Part &b)
{
    return a.material == b.material && a.group == b.group && a.smoothing == b.smoothing;
}

}

void ObjParts::setMaterial(std::string_view name, SourceRange place)
{
    m_material = name;
    m_materialPlace = place;
    m_isChanged = true;
}

void ObjParts::setGroup(std::string_view name)
{
    m_group = name;
    m_isChanged = true;
}

void ObjParts::setSmoothing(std::uint32_t group)
{
    m_smoothing = group;
    m_isChanged = true;
}

void ObjParts::beginPart(Mesh &mesh)
{
    m_isChanged = false;
    const Mesh::Part part{static_cast<std::uint32_t>(mesh.faces.size()), indexOf(m_materials, m_material),
                          indexOf(m_groups, m_group), m_smoothing};
    if (m_materials.size() > m_materialPlaces.size() + 1) {
        m_materialPlaces.push_back(m_materialPlace);
    }
    if (isLike(part, mesh.parts.empty() ? Mesh::Part() : mesh.parts.back())) {
        return;
    }
    if (mesh.parts.empty() && part.firstFace > 0) {
        mesh.parts.emplace_back(); // of the faces so far
    }
    mesh.parts.push_back(part);
}

void ObjParts::nameParts(Mesh &mesh) const
{
    for (NameId id = 1; id < m_materials.size(); ++id) {
        mesh.materials.emplace_back().name = m_materials[id];
    }
    for (NameId id = 1; id < m_groups.size(); ++id) {
        mesh.groups.emplace_back(m_groups[id]);
    }
}

}
