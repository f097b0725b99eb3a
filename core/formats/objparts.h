// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/geometry/mesh.h"
#include "core/text/nametable.h"
#include "core/text/sourcerange.h"

namespace romanesco {

/// Parts a mesh by what OBJ statements say of the faces behind them. A statement costs nothing more until a face comes, so
/// that only what faces use is kept.
class ObjParts
{
public:
    /// place is where the name stands. An empty name is none.
    void setMaterial(std::string_view name, SourceRange place);
    void setGroup(std::string_view name);
    void setSmoothing(std::uint32_t group);

    /// To be called before faces are added.
    void beginFaces(Mesh &mesh)
    {
        if (m_isChanged) {
            beginPart(mesh);
        }
    }

    /// Gives the mesh the names that its parts count.
    void nameParts(Mesh &mesh) const;
    /// Beside the materials: where each is named before its first face.
    [[nodiscard]] const std::vector<SourceRange> &materialPlaces() const { return m_materialPlaces; }

private:
    void beginPart(Mesh &mesh);

    // of the next face
    std::string m_material;
    SourceRange m_materialPlace;
    std::string m_group;
    std::uint32_t m_smoothing = 0;
    bool m_isChanged = false;

    /// Those of a list that faces use, in the order in which they first do, behind the empty name.
    NameTable m_materials;
    NameTable m_groups;
    std::vector<SourceRange> m_materialPlaces;
};

}
