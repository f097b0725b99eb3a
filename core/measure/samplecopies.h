// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <stop_token>
#include <vector>

#include "core/formats/copysource.h"
#include "core/scene/scene.h"

namespace romanesco {

/// Copies of a scene, few enough to be held: all of them, or some that are drawn at random, each as likely as any other, the
/// same ones each time.
class SampleCopies final : public CopySource
{
public:
    /// Of so many faces or hardly more; of each item with faces one copy at least. The scene must outlive it.
    SampleCopies(const Scene &scene, std::uint64_t mostFaces, const std::stop_token &stop = {});

    [[nodiscard]] bool isWhole() const { return m_isWhole; }
    [[nodiscard]] std::size_t faceCount() const;

    [[nodiscard]] std::span<const Item> items() const override { return m_items; }
    [[nodiscard]] std::expected<void, std::string> visit(std::size_t item, const Visitor &visitor) const override;

private:
    void takeAll(const Scene &scene, const std::vector<std::uint64_t> &counts, const std::stop_token &stop);
    void draw(const Scene &scene, std::uint64_t mostFaces, const std::stop_token &stop);

    std::vector<Item> m_items;
    /// Beside items.
    std::vector<std::vector<MeshCopy>> m_copies;
    bool m_isWhole = false;
};

}
