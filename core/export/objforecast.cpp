// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "objforecast.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <random>
#include <span>

#include "copysampler.h"
#include "core/formats/objwriter.h"
#include "core/geometry/normals.h"

namespace romanesco {

namespace {

constexpr std::size_t sampledCopies = 2'000;
constexpr std::size_t leastCopies = 20;
constexpr std::size_t verticesOfCopy = 30;
constexpr std::uint64_t mostWork = 10'000'000;

/// How many digits whole numbers have on average, of those from 1 to 10^logarithm.
double meanDigits(double logarithm)
{
    const double digits = std::floor(std::max(logarithm, 0.0)) + 1.0;
    return std::max(digits - std::pow(10.0, digits - logarithm) / 9.0, 1.0);
}

/// Copies of a mesh, all in one place.
class Heap final : public CopySource
{
public:
    Heap(const Mesh &mesh, std::uint64_t count)
        : m_item{&mesh, count}
    {
    }
    [[nodiscard]] std::span<const Item> items() const override { return {&m_item, 1}; }
    [[nodiscard]] std::expected<void, std::string> visit(std::size_t, const Visitor &visitor) const override
    {
        for (std::uint64_t i = 0; i < m_item.copyCount; ++i) {
            visitor({});
        }
        return {};
    }

private:
    Item m_item;
};

double objBytes(const CopySource &copies, std::optional<int> digits)
{
    CountingSink sink;
    static_cast<void>(writeObj(copies, {.digits = digits, .materialLibrary = "m"}, sink)); // counting does not fail
    return static_cast<double>(sink.count());
}

double digitsOf(const std::vector<Mesh::Face> &indices, std::size_t before)
{
    double digits = 0.0;
    for (const Mesh::Face &face : indices) {
        for (const std::uint32_t index : face) {
            digits += index == Mesh::none ? 0.0 : static_cast<double>(std::to_string(before + index + 1).size());
        }
    }
    return digits;
}

double cornersWith(const std::vector<Mesh::Face> &indices)
{
    double count = 0.0;
    for (const Mesh::Face &face : indices) {
        count += static_cast<double>(3 - std::ranges::count(face, Mesh::none));
    }
    return count;
}

/// Of the faces of a copy and what stands before them, as OBJ text: all but the digits of what is numbered anew in each
/// copy. The second copy of two tells it, since the first begins with what then holds for all.
struct FaceText {
    double bytes;
    double vertexIndices;
    double normalIndices;
};

FaceText faceTextOf(const Mesh &mesh)
{
    Mesh skeleton = mesh;
    std::ranges::fill(skeleton.vertices, glm::dvec3(0.0));
    std::ranges::fill(skeleton.normals, glm::dvec3(0.0));
    skeleton.colours.clear();
    const double both = objBytes(Heap(skeleton, 2), {}) - objBytes(Heap(skeleton, 1), {});
    constexpr double vertexBytes = sizeof("v 0 0 0\n") - 1;
    constexpr double normalBytes = sizeof("vn 0 0 0\n") - 1;
    const double numbered =
        digitsOf(mesh.faces, mesh.vertices.size()) + digitsOf(mesh.faceNormals, mesh.normals.size());
    return {both - vertexBytes * static_cast<double>(mesh.vertices.size())
                - normalBytes * static_cast<double>(mesh.normals.size()) - numbered,
            3.0 * static_cast<double>(mesh.faces.size()), cornersWith(mesh.faceNormals)};
}

/// Bytes of a vertex's line and of a normal's.
struct LineText {
    double vertex;
    double normal;
};

class ObjForecast
{
public:
    ObjForecast(const Scene &scene, std::optional<int> digits)
        : m_digits(digits)
        , m_copiesOfItem(std::max(leastCopies, sampledCopies / std::max<std::size_t>(scene.items.size(), 1)))
    {
    }

    /// Of a copy of the item, where so many numbers stand in the file in all, as decimal logarithms.
    double bytesOfCopy(const SceneItem &item, double vertices, double normals)
    {
        const Mesh &mesh = *item.model->mesh;
        auto text = m_faceTexts.find(&mesh);
        if (text == m_faceTexts.end()) {
            text = m_faceTexts.emplace(&mesh, faceTextOf(mesh)).first;
        }
        const LineText line = lineTextOf(item);
        return text->second.bytes + text->second.vertexIndices * meanDigits(vertices)
            + text->second.normalIndices * meanDigits(normals) + line.vertex * static_cast<double>(mesh.vertices.size())
            + line.normal * static_cast<double>(mesh.normals.size());
    }

private:
    LineText lineTextOf(const SceneItem &item)
    {
        Mesh sample = sampleOf(item);
        const auto vertices = static_cast<double>(std::max<std::size_t>(sample.vertices.size(), 1));
        const double both = objBytes(PlainMesh(sample), m_digits);
        sample.normals.clear();
        const double alone = objBytes(PlainMesh(sample), m_digits);
        return {alone / vertices, (both - alone) / vertices};
    }

    /// Some vertices of some copies of an item, and as many normals, in the world.
    Mesh sampleOf(const SceneItem &item)
    {
        const Mesh &mesh = *item.model->mesh;
        std::unique_ptr<CopySampler> &copies = m_samplers[item.model.get()];
        if (!copies) {
            copies = std::make_unique<CopySampler>(item.model->graph);
        }
        Mesh sample;
        const std::uint64_t workBefore = copies->work();
        for (std::size_t i = 0; i < m_copiesOfItem && copies->work() - workBefore <= mostWork; ++i) {
            const AffineMap map = item.worldFromModel * copies->sample(m_random);
            const glm::dmat3 matrix = normalMatrix(map.linear);
            for (std::size_t j = 0; j < verticesOfCopy; ++j) {
                const std::size_t vertex = m_random() % mesh.vertices.size();
                sample.vertices.push_back(map(mesh.vertices[vertex]));
                if (!mesh.colours.empty()) {
                    sample.colours.push_back(mesh.colours[vertex]);
                }
                if (!mesh.normals.empty()) {
                    const glm::dvec3 &normal = mesh.normals[m_random() % mesh.normals.size()];
                    sample.normals.push_back(transformedNormal(matrix, normal));
                }
            }
        }
        return sample;
    }

    std::optional<int> m_digits;
    std::size_t m_copiesOfItem;
    std::mt19937_64 m_random{20'250'607};
    std::map<const Mesh *, FaceText> m_faceTexts;
    std::map<const Model *, std::unique_ptr<CopySampler>> m_samplers;
};

/// Groups that start in an item, each a line of some 12 bytes.
double branchesOf(const SceneItem &item)
{
    double branches = 1.0;
    for (const auto &[position, slot] : item.model->graph.reach(0).levels) {
        branches += static_cast<double>(item.model->graph.setAt(slot).maps.size());
    }
    return branches;
}

/// The bytes of a copy are no whole number; those of more copies than a double can count are taken for one.
Count product(const Count &copies, double bytesOfCopy)
{
    const std::optional<std::uint64_t> count = copies.toInteger();
    const double bytes = static_cast<double>(count.value_or(0)) * bytesOfCopy;
    return count && bytes < 1e18 ? Count(static_cast<std::uint64_t>(bytes))
                                 : copies * Count(static_cast<std::uint64_t>(std::llround(bytesOfCopy)));
}

}

Count objBytes(const Scene &scene, const std::vector<Count> &copies, const ExportOptions &options)
{
    Count vertices;
    Count normals;
    for (std::size_t i = 0; i < scene.items.size(); ++i) {
        vertices += copies[i] * Count(scene.items[i].model->mesh->vertices.size());
        normals += copies[i] * Count(scene.items[i].model->mesh->normals.size());
    }
    ObjForecast forecast(scene, options.digits);
    Count bytes;
    for (std::size_t i = 0; i < scene.items.size(); ++i) {
        bytes += product(copies[i], forecast.bytesOfCopy(scene.items[i], vertices.log10(), normals.log10()));
        if (options.isGrouped) {
            constexpr double bytesOfLine = 12.0;
            bytes += product(Count(1), bytesOfLine * branchesOf(scene.items[i]));
        }
    }
    return bytes;
}

}
