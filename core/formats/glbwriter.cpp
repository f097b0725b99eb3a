// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "glbwriter.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>
#include <map>
#include <vector>

#include <glm/vec4.hpp>

#include "binaryoutput.h"
#include "core/geometry/normals.h"
#include "core/geometry/trs.h"
#include "gltfmesh.h"
#include "jsontext.h"

namespace romanesco {

namespace {

using Result = std::expected<void, std::string>;
using Failure = std::unexpected<std::string>;

constexpr int floats = 5126;
constexpr int unsignedInts = 5125;
constexpr int vertexTarget = 34962;
constexpr int indexTarget = 34963;
constexpr std::uint32_t jsonChunk = 0x4E4F534A;
constexpr std::uint32_t binaryChunk = 0x004E4942;

constexpr std::string_view tooLarge = "a GLB file holds at most 4294967295 bytes";
constexpr std::string_view beyondFloats = "a coordinate is beyond what GLB's floats hold (3.4e38)";

/// z is negated, in a vector, and on both sides of a map.
glm::dvec3 flipped(const glm::dvec3 &v)
{
    return {v.x, v.y, -v.z};
}

AffineMap flipped(const AffineMap &map)
{
    return {glm::dmat3(flipped(map.linear[0]), flipped(map.linear[1]), -flipped(map.linear[2])),
            flipped(map.translation)};
}

/// Seen from a node that is scaled by -1 along z.
AffineMap mirrored(const AffineMap &map)
{
    return {glm::dmat3(flipped(map.linear[0]), flipped(map.linear[1]), flipped(map.linear[2])),
            flipped(map.translation)};
}

/// All of glTF's have length 1; one without a direction, as faces without an area have, gets some.
glm::dvec3 unitNormal(const glm::dmat3 &matrix, const glm::dvec3 &normal)
{
    const glm::dvec3 unit = transformedNormal(matrix, transformedNormal(glm::dmat3(1.0), normal));
    return unit == glm::dvec3(0.0) ? glm::dvec3(0.0, 0.0, 1.0) : unit;
}

char *put(char *to, const glm::vec3 &v)
{
    return putBinary(putBinary(putBinary(to, v.x), v.y), v.z);
}

struct Bounds {
    glm::vec3 least{std::numeric_limits<float>::infinity()};
    glm::vec3 greatest{-std::numeric_limits<float>::infinity()};

    [[nodiscard]] bool isFinite() const
    {
        const glm::vec3 size = greatest - least;
        return std::isfinite(size.x) && std::isfinite(size.y) && std::isfinite(size.z);
    }
};

std::string vectorText(const glm::dvec3 &v)
{
    return jsonNumbers(std::span(&v.x, 3));
}

std::string mimeType(std::string_view image)
{
    return image.starts_with("\x89PNG\r\n\x1A\n") ? "image/png" : image.starts_with("\xFF\xD8\xFF") ? "image/jpeg" : "";
}

class GlbWriter
{
public:
    GlbWriter(const CopySource &copies, const GlbOptions &options, ByteSink &sink)
        : m_copies(copies)
        , m_options(options)
        , m_materials(copies.items())
        , m_out(sink)
    {
    }

    std::expected<GlbReport, std::string> write()
    {
        for (std::size_t item = 0; item < m_copies.items().size(); ++item) {
            if (Result planned = planItem(item); !planned) {
                return Failure(planned.error());
            }
        }
        planMaterials();
        std::string json = jsonText();
        json.resize((json.size() + 3) / 4 * 4, ' ');
        const std::uint64_t size = 12 + 8 + json.size() + (m_binarySize > 0 ? 8 + m_binarySize : 0);
        if (size > mostGlbBytes) {
            return Failure(tooLarge);
        }
        writeHead(size, json);
        for (const View &view : m_views) {
            if (Result written = view.write(); !written) {
                return Failure(written.error());
            }
            m_out.append(std::string(paddingOf(view.size), '\0'));
        }
        if (Result flushed = m_out.flush(); !flushed) {
            return Failure(flushed.error());
        }
        return m_report;
    }

private:
    /// A run of bytes of the binary chunk, and how it is written.
    struct View {
        std::uint64_t size;
        std::function<Result()> write;
    };

    static std::size_t paddingOf(std::uint64_t size) { return static_cast<std::size_t>((4 - size % 4) % 4); }

    std::size_t addView(std::uint64_t size, const std::string &more, std::function<Result()> write)
    {
        m_viewTexts.push_back("{\"buffer\":0,\"byteOffset\":" + std::to_string(m_binarySize)
                              + ",\"byteLength\":" + std::to_string(size) + more + "}");
        m_binarySize += size + paddingOf(size);
        m_views.push_back({size, std::move(write)});
        return m_views.size() - 1;
    }

    std::size_t addAccessor(std::size_t view, std::uint64_t offset, int component, const char *type,
                            std::uint64_t count, const std::string &more = {})
    {
        m_accessors.push_back("{\"bufferView\":" + std::to_string(view) + ",\"byteOffset\":" + std::to_string(offset)
                              + ",\"componentType\":" + std::to_string(component)
                              + ",\"count\":" + std::to_string(count) + ",\"type\":\"" + type + "\"" + more + "}");
        return m_accessors.size() - 1;
    }

    /// As a node of its own, as instances of its mesh, or with all copies baked into one.
    Result planItem(std::size_t item)
    {
        const auto &[mesh, count] = m_copies.items()[item];
        if (mesh->faces.empty()) {
            return {}; // a mesh must have something
        }
        if (count > mostGlbBytes / glbBytesOfInstance) {
            return Failure(tooLarge); // baked copies take more still
        }
        std::array<std::uint64_t, 2> batches{};
        std::optional<Trs> last;
        const Result visited = m_copies.visit(item, [&](const MeshCopy &copy) {
            last = trsOf(flipped(copy.worldFromMesh));
            ++batches[last && last->scale.z < 0.0 ? 1 : 0];
            return last.has_value();
        });
        if (!visited) {
            return visited;
        }
        if (!last) {
            return planBaked(item);
        }
        const auto meshIndex = instancedMesh(mesh);
        if (!meshIndex) {
            return Failure(meshIndex.error());
        }
        if (count == 1) {
            addNode(*meshIndex, *last);
            return {};
        }
        for (const bool isMirrored : {false, true}) {
            if (batches[isMirrored] > 0) {
                addInstances(item, *meshIndex, isMirrored, batches[isMirrored]);
            }
        }
        return {};
    }

    void addNode(std::size_t mesh, const Trs &trs)
    {
        const std::array<double, 4> rotation{trs.rotation.x, trs.rotation.y, trs.rotation.z, trs.rotation.w};
        m_nodes.push_back("{\"mesh\":" + std::to_string(mesh) + ",\"translation\":" + vectorText(trs.translation)
                          + ",\"rotation\":" + jsonNumbers(rotation) + ",\"scale\":" + vectorText(trs.scale) + "}");
    }

    void addInstances(std::size_t item, std::size_t mesh, bool isMirrored, std::uint64_t count)
    {
        std::string attributes;
        const auto add = [&](const char *name, const char *type, std::size_t size, const auto &part) {
            const std::size_t view =
                addView(count * size, "", [=, this] { return writeInstances(item, isMirrored, size, part); });
            attributes += std::string(attributes.empty() ? "" : ",") + "\"" + name
                + "\":" + std::to_string(addAccessor(view, 0, floats, type, count));
        };
        add("TRANSLATION", "VEC3", 12, [](char *to, const Trs &trs) { return put(to, glm::vec3(trs.translation)); });
        add("ROTATION", "VEC4", 16, [](char *to, const Trs &trs) {
            const glm::dquat &q = trs.rotation;
            return putBinary(put(to, glm::vec3(q.x, q.y, q.z)), static_cast<float>(q.w));
        });
        add("SCALE", "VEC3", 12, [](char *to, const Trs &trs) { return put(to, glm::vec3(trs.scale)); });
        m_nodes.push_back("{\"mesh\":" + std::to_string(mesh) + (isMirrored ? ",\"scale\":[1,1,-1]" : "")
                          + ",\"extensions\":{\"EXT_mesh_gpu_instancing\":{\"attributes\":{" + attributes + "}}}}");
        m_hasInstances = true;
    }

    template<typename Part>
    Result writeInstances(std::size_t item, bool isMirrored, std::size_t size, const Part &part)
    {
        bool isFinite = true;
        const Result visited = m_copies.visit(item, [&](const MeshCopy &copy) {
            const AffineMap map = flipped(copy.worldFromMesh);
            std::optional<Trs> trs = trsOf(map);
            assert(trs && "the same copies are visited each time");
            if ((trs->scale.z < 0.0) != isMirrored) {
                return true;
            }
            if (isMirrored) {
                trs = trsOf(mirrored(map));
            }
            const glm::vec3 translation(trs->translation);
            isFinite = std::isfinite(translation.x + translation.y + translation.z);
            m_out.take(part(m_out.room(size), *trs));
            return isFinite && m_out.isGood();
        });
        return visited && !isFinite ? Failure(beyondFloats) : visited;
    }

    /// The mesh by itself, which stands in the file once.
    std::expected<std::size_t, std::string> instancedMesh(const Mesh *mesh)
    {
        const auto known = m_instancedMeshes.find(mesh);
        if (known != m_instancedMeshes.end()) {
            return known->second;
        }
        const auto source = std::make_shared<PlainMesh>(*mesh);
        if (Result planned = planMesh(source, 0); !planned) {
            return Failure(planned.error());
        }
        m_instancedMeshes.emplace(mesh, m_meshes.size() - 1);
        return m_meshes.size() - 1;
    }

    Result planBaked(std::size_t item)
    {
        // not to be deleted: the copies outlive the writer
        const std::shared_ptr<const CopySource> source(&m_copies, [](const CopySource *) { });
        if (Result planned = planMesh(source, item); !planned) {
            return planned;
        }
        m_nodes.push_back("{\"mesh\":" + std::to_string(m_meshes.size() - 1) + "}");
        m_report.bakedCopies += m_copies.items()[item].copyCount;
        return {};
    }

    /// A mesh of all copies of an item.
    Result planMesh(const std::shared_ptr<const CopySource> &source, std::size_t item)
    {
        const auto &[mesh, count] = source->items()[item];
        auto primitives = m_primitives.find(mesh);
        if (primitives == m_primitives.end()) {
            primitives = m_primitives.emplace(mesh, primitivesOf(*mesh, m_materials)).first;
        }
        std::vector<std::string> texts;
        for (const GltfPrimitive &primitive : primitives->second) {
            const std::uint64_t vertices = count * primitive.vertices.size();
            if (vertices > mostGlbBytes / primitive.stride() || count * primitive.faces.size() > mostGlbBytes / 12) {
                return Failure(tooLarge);
            }
            const auto bounds = boundsOf(*source, item, primitive);
            if (!bounds) {
                return Failure(bounds.error());
            }
            texts.push_back(addPrimitive(source, item, primitive, *bounds));
        }
        m_meshes.push_back("{\"primitives\":" + jsonArray(texts) + "}");
        return {};
    }

    static std::expected<Bounds, std::string> boundsOf(const CopySource &source, std::size_t item,
                                                       const GltfPrimitive &primitive)
    {
        const Mesh &mesh = *source.items()[item].mesh;
        Bounds bounds;
        const Result visited = source.visit(item, [&](const MeshCopy &copy) {
            for (const GltfPrimitive::Vertex &vertex : primitive.vertices) {
                const glm::vec3 place(flipped(copy.worldFromMesh(mesh.vertices[vertex.position])));
                bounds.least = glm::min(bounds.least, place);
                bounds.greatest = glm::max(bounds.greatest, place);
            }
            return true;
        });
        if (!visited) {
            return Failure(visited.error());
        }
        return bounds.isFinite() ? std::expected<Bounds, std::string>(bounds) : Failure(beyondFloats);
    }

    std::string addPrimitive(const std::shared_ptr<const CopySource> &source, std::size_t item,
                             const GltfPrimitive &primitive, const Bounds &bounds)
    {
        const std::uint64_t copies = source->items()[item].copyCount;
        const std::uint64_t vertices = copies * primitive.vertices.size();
        const std::uint64_t indices = 3 * copies * primitive.faces.size();
        const std::size_t vertexView = addView(
            vertices * primitive.stride(),
            ",\"byteStride\":" + std::to_string(primitive.stride()) + ",\"target\":" + std::to_string(vertexTarget),
            [=, this, &primitive] { return writeVertices(*source, item, primitive); });
        const std::size_t indexView = addView(4 * indices, ",\"target\":" + std::to_string(indexTarget),
                                              [=, this, &primitive] { return writeIndices(*source, item, primitive); });
        std::uint64_t offset = 0;
        const auto attribute = [&](const char *name, const char *type, std::uint64_t size,
                                   const std::string &more = {}) {
            const std::size_t accessor = addAccessor(vertexView, offset, floats, type, vertices, more);
            offset += size;
            return "\"" + std::string(name) + "\":" + std::to_string(accessor);
        };
        std::string text = "{\"attributes\":{"
            + attribute("POSITION", "VEC3", 12,
                        ",\"min\":" + vectorText(bounds.least) + ",\"max\":" + vectorText(bounds.greatest));
        text += primitive.hasNormals ? "," + attribute("NORMAL", "VEC3", 12) : "";
        text += primitive.hasTextureCoordinates ? "," + attribute("TEXCOORD_0", "VEC2", 8) : "";
        text += primitive.hasColours ? "," + attribute("COLOR_0", "VEC3", 12) : "";
        assert(offset == primitive.stride());
        return text + "},\"indices\":" + std::to_string(addAccessor(indexView, 0, unsignedInts, "SCALAR", indices))
            + ",\"material\":" + std::to_string(materialOf(primitive.material)) + "}";
    }

    Result writeVertices(const CopySource &source, std::size_t item, const GltfPrimitive &primitive)
    {
        const Mesh &mesh = *source.items()[item].mesh;
        return source.visit(item, [&](const MeshCopy &copy) {
            const glm::dmat3 normals = normalMatrix(copy.worldFromMesh.linear);
            for (const GltfPrimitive::Vertex &vertex : primitive.vertices) {
                char *to = m_out.room(primitive.stride());
                to = put(to, glm::vec3(flipped(copy.worldFromMesh(mesh.vertices[vertex.position]))));
                if (primitive.hasNormals) {
                    to = put(to, glm::vec3(flipped(unitNormal(normals, mesh.normals[vertex.normal]))));
                }
                if (primitive.hasTextureCoordinates) {
                    to = putTextureCoordinates(to, mesh, vertex.textureCoordinates);
                }
                if (primitive.hasColours) {
                    to = put(to, glm::clamp(mesh.colours[vertex.position], 0.0F, 1.0F));
                }
                m_out.take(to);
            }
            return m_out.isGood();
        });
    }

    /// From the top left corner of an image, where OBJ counts from the bottom.
    static char *putTextureCoordinates(char *to, const Mesh &mesh, std::uint32_t index)
    {
        const glm::dvec2 place = index == Mesh::none ? glm::dvec2(0.0) : mesh.textureCoordinates[index];
        return putBinary(putBinary(to, static_cast<float>(place.x)), static_cast<float>(1.0 - place.y));
    }

    Result writeIndices(const CopySource &source, std::size_t item, const GltfPrimitive &primitive)
    {
        std::uint32_t first = 0;
        return source.visit(item, [&](const MeshCopy &copy) {
            // once for the mirror that is in the copy, once for the one that negates z
            const std::array<std::size_t, 3> order = cornerOrder(!copy.isMirrored);
            for (const Mesh::Face &face : primitive.faces) {
                char *to = m_out.room(sizeof(face));
                for (const std::size_t corner : order) {
                    to = putBinary(to, first + face[corner]);
                }
                m_out.take(to);
            }
            first += static_cast<std::uint32_t>(primitive.vertices.size());
            return m_out.isGood();
        });
    }

    /// Parts without a material have a plain one: glTF's own is made of metal.
    std::size_t materialOf(std::uint32_t entry)
    {
        m_needsPlain = m_needsPlain || entry == Mesh::none;
        return entry == Mesh::none ? m_materials.entries().size() : entry;
    }

    void planMaterials()
    {
        for (const MaterialTable::Entry &entry : m_materials.entries()) {
            m_materialTexts.push_back(materialText(entry.name, *entry.material));
        }
        if (m_needsPlain) {
            m_materialTexts.push_back(materialText("default", Material()));
        }
    }

    std::string materialText(const std::string &name, const Material &material)
    {
        const auto share = [](float value) { return std::clamp(static_cast<double>(value), 0.0, 1.0); };
        const auto colour = [&](const glm::vec3 &c) { return glm::dvec3(share(c.x), share(c.y), share(c.z)); };
        const glm::dvec3 diffuse = colour(material.diffuse);
        const std::array<double, 4> base{diffuse.x, diffuse.y, diffuse.z, share(material.opacity)};
        // Of a highlight's exponent, as Beckmann's and Blinn's come near one another (Walter et al. 2007).
        const double roughness = std::sqrt(2.0 / (2.0 + std::max(0.0, static_cast<double>(material.shininess))));
        const std::optional<std::size_t> texture = textureOf(material.diffuseTexture);
        return "{\"name\":" + jsonString(name) + ",\"pbrMetallicRoughness\":{\"baseColorFactor\":" + jsonNumbers(base)
            + (texture ? ",\"baseColorTexture\":{\"index\":" + std::to_string(*texture) + "}" : "")
            + ",\"metallicFactor\":0,\"roughnessFactor\":" + jsonNumber(roughness) + "},\"emissiveFactor\":"
            + vectorText(colour(material.emission)) + (material.opacity < 1.0F ? ",\"alphaMode\":\"BLEND\"" : "") + "}";
    }

    /// Textures and images have the same numbers.
    std::optional<std::size_t> textureOf(const std::filesystem::path &path)
    {
        if (path.empty()) {
            return std::nullopt;
        }
        const auto [known, isNew] = m_textures.try_emplace(path);
        if (isNew) {
            std::optional<std::string> image = m_options.readImage ? m_options.readImage(path) : std::nullopt;
            const std::string type = image ? mimeType(*image) : "";
            if (type.empty()) {
                ++m_report.missingImages;
            } else {
                const std::size_t view = addImage(std::move(*image));
                m_images.push_back("{\"bufferView\":" + std::to_string(view) + ",\"mimeType\":\"" + type + "\"}");
                m_textureTexts.push_back("{\"source\":" + std::to_string(m_images.size() - 1) + "}");
                known->second = m_images.size() - 1;
            }
        }
        return known->second;
    }

    std::size_t addImage(std::string bytes)
    {
        const std::uint64_t size = bytes.size();
        return addView(size, "", [this, kept = std::move(bytes)] {
            m_out.append(kept);
            return Result();
        });
    }

    std::string jsonText() const
    {
        std::string json = "{\"asset\":{\"version\":\"2.0\",\"generator\":\"Romanesco\"";
        json += m_options.comment.empty() ? "" : ",\"extras\":{\"comment\":" + jsonString(m_options.comment) + "}";
        json += "}";
        if (m_hasInstances) {
            json += ",\"extensionsUsed\":[\"EXT_mesh_gpu_instancing\"]"
                    ",\"extensionsRequired\":[\"EXT_mesh_gpu_instancing\"]";
        }
        std::vector<std::string> roots;
        roots.reserve(m_nodes.size());
        for (std::size_t i = 0; i < m_nodes.size(); ++i) {
            roots.push_back(std::to_string(i));
        }
        json += ",\"scene\":0,\"scenes\":[" + std::string(roots.empty() ? "{}" : "{\"nodes\":" + jsonArray(roots) + "}")
            + "]";
        // an empty list is no list
        const auto add = [&](const char *name, const std::vector<std::string> &values) {
            json += values.empty() ? "" : ",\"" + std::string(name) + "\":" + jsonArray(values);
        };
        add("nodes", m_nodes);
        add("meshes", m_meshes);
        add("materials", m_materialTexts);
        add("textures", m_textureTexts);
        add("images", m_images);
        add("accessors", m_accessors);
        add("bufferViews", m_viewTexts);
        if (m_binarySize > 0) {
            json += ",\"buffers\":[{\"byteLength\":" + std::to_string(m_binarySize) + "}]";
        }
        return json + "}";
    }

    void writeHead(std::uint64_t size, const std::string &json)
    {
        m_out.append("glTF");
        const auto words = [&](std::uint64_t first, std::uint64_t second) {
            char *to = putBinary(m_out.room(8), static_cast<std::uint32_t>(first));
            m_out.take(putBinary(to, static_cast<std::uint32_t>(second)));
        };
        words(2, size);
        words(json.size(), jsonChunk);
        m_out.append(json);
        if (m_binarySize > 0) {
            words(m_binarySize, binaryChunk);
        }
    }

    const CopySource &m_copies;
    const GlbOptions &m_options;
    MaterialTable m_materials;
    BufferedOutput m_out;
    GlbReport m_report;
    /// Referred to by the views, which write later.
    std::map<const Mesh *, std::vector<GltfPrimitive>> m_primitives;
    std::map<const Mesh *, std::size_t> m_instancedMeshes;
    std::map<std::filesystem::path, std::optional<std::size_t>> m_textures;
    std::vector<View> m_views;
    std::uint64_t m_binarySize = 0;
    bool m_hasInstances = false;
    bool m_needsPlain = false;
    /// The JSON's lists.
    std::vector<std::string> m_nodes;
    std::vector<std::string> m_meshes;
    std::vector<std::string> m_materialTexts;
    std::vector<std::string> m_textureTexts;
    std::vector<std::string> m_images;
    std::vector<std::string> m_accessors;
    std::vector<std::string> m_viewTexts;
};

}

std::uint64_t glbBytesOfCopy(const Mesh &mesh)
{
    const MaterialTable materials(PlainMesh(mesh).items());
    std::uint64_t bytes = 0;
    for (const GltfPrimitive &primitive : primitivesOf(mesh, materials)) {
        bytes += primitive.vertices.size() * primitive.stride() + primitive.faces.size() * sizeof(Mesh::Face);
    }
    return bytes;
}

std::expected<GlbReport, std::string> writeGlb(const CopySource &copies, const GlbOptions &options, ByteSink &sink)
{
    return GlbWriter(copies, options, sink).write();
}

}
