// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <cstddef>
#include <cstdint>
#include <expected>
#include <functional>
#include <span>
#include <string>
#include <string_view>

#include "core/geometry/affinemap.h"
#include "core/geometry/mesh.h"

namespace romanesco {

/// A copy of a mesh, as a file is to hold it.
struct MeshCopy {
    AffineMap worldFromMesh;
    /// The map turns the mesh inside out: its faces are turned once more, so that they look outwards again.
    bool isMirrored = false;
    /// What the copy belongs to, where files are to say so; else empty. Valid during the visit.
    std::string_view branch = {};
};

/// What the writers of files write: meshes, each with its copies, which are never listed but visited, as often as a
/// format needs.
class CopySource
{
public:
    struct Item {
        const Mesh *mesh = nullptr;
        /// As many as visit() gives.
        std::uint64_t copyCount = 0;
    };
    /// Is given each copy; false ends the visit.
    using Visitor = std::function<bool(const MeshCopy &)>;

    virtual ~CopySource() = default;

    [[nodiscard]] virtual std::span<const Item> items() const = 0;

    /// Goes through the copies of an item, the same ones in the same order each time. The error is the reason why not
    /// all were visited ("cancelled"), other than that the visitor had enough.
    [[nodiscard]] virtual std::expected<void, std::string> visit(std::size_t item, const Visitor &visitor) const = 0;
};

/// A mesh as it is.
class PlainMesh final : public CopySource
{
public:
    /// The mesh must outlive it.
    explicit PlainMesh(const Mesh &mesh)
        : m_item{&mesh, 1}
    {
    }

    [[nodiscard]] std::span<const Item> items() const override { return {&m_item, 1}; }
    [[nodiscard]] std::expected<void, std::string> visit(std::size_t, const Visitor &visitor) const override
    {
        visitor({});
        return {};
    }

private:
    Item m_item;
};

}
