// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include "tests/core/export/exported.h"

namespace romanesco::test {

/// A GLB taken apart by the specification, which knows nothing of how it was made.
class Glb
{
public:
    explicit Glb(const std::string &bytes)
    {
        m_isSound = bytes.size() >= 20 && bytes.starts_with("glTF") && word(bytes, 4) == 2
            && word(bytes, 8) == bytes.size() && bytes.size() % 4 == 0 && bytes.substr(16, 4) == "JSON"
            && word(bytes, 12) % 4 == 0;
        if (!m_isSound) {
            return;
        }
        const std::size_t size = word(bytes, 12);
        json = QJsonDocument::fromJson(QByteArray(bytes.data() + 20, static_cast<qsizetype>(size))).object();
        m_isSound = !json.isEmpty();
        if (m_isSound && 20 + size < bytes.size()) {
            m_isSound = bytes.substr(24 + size, 4) == std::string("BIN\0", 4)
                && word(bytes, 20 + size) == bytes.size() - 28 - size
                && at("buffers", 0)["byteLength"].toInteger() == static_cast<qint64>(bytes.size() - 28 - size);
            m_binary = bytes.substr(28 + size);
        }
        m_isSound = m_isSound && viewsAreSound() && accessorsAreSound();
    }

    [[nodiscard]] bool isSound() const { return m_isSound; }

    QJsonObject json;

    [[nodiscard]] QJsonObject at(const char *list, qint64 index) const
    {
        return json[QLatin1String(list)].toArray()[static_cast<qsizetype>(index)].toObject();
    }

    /// The numbers of an accessor, some for each element.
    [[nodiscard]] std::vector<std::vector<double>> elements(qint64 accessor) const
    {
        const QJsonObject object = at("accessors", accessor);
        const QJsonObject view = at("bufferViews", object["bufferView"].toInteger());
        const std::size_t width = widthOf(object);
        const auto stride = static_cast<std::size_t>(view["byteStride"].toInteger(static_cast<qint64>(4 * width)));
        const auto begin = static_cast<std::size_t>(view["byteOffset"].toInteger() + object["byteOffset"].toInteger());
        std::vector<std::vector<double>> result;
        for (std::size_t i = 0; i < static_cast<std::size_t>(object["count"].toInteger()); ++i) {
            std::vector<double> &element = result.emplace_back();
            for (std::size_t j = 0; j < width; ++j) {
                const std::size_t place = begin + i * stride + 4 * j;
                float number = 0;
                std::memcpy(&number, m_binary.data() + place, 4);
                const bool isFloat = object["componentType"].toInt() == 5126;
                element.push_back(isFloat ? static_cast<double>(number) : static_cast<double>(word(m_binary, place)));
            }
        }
        return result;
    }

    [[nodiscard]] std::string bytesOfView(qint64 index) const
    {
        const QJsonObject view = at("bufferViews", index);
        return m_binary.substr(static_cast<std::size_t>(view["byteOffset"].toInteger()),
                               static_cast<std::size_t>(view["byteLength"].toInteger()));
    }

    /// Of all nodes with all their instances.
    [[nodiscard]] std::vector<Triangle> triangles() const
    {
        std::vector<Triangle> result;
        const QJsonArray nodes = json["scenes"].toArray()[0].toObject()["nodes"].toArray();
        for (const QJsonValue &number : nodes) {
            const QJsonObject node = at("nodes", number.toInteger());
            const QJsonArray primitives = at("meshes", node["mesh"].toInteger())["primitives"].toArray();
            for (const Placing &instance : instancesOf(node)) {
                for (const QJsonValue &primitive : primitives) {
                    append(primitive.toObject(), placingOf(node), instance, result);
                }
            }
        }
        return result;
    }

private:
    struct Placing {
        std::vector<double> translation{0, 0, 0};
        std::vector<double> rotation{0, 0, 0, 1};
        std::vector<double> scale{1, 1, 1};

        /// Rotation by v + 2w(q x v) + 2q x (q x v).
        [[nodiscard]] Corner operator()(const Corner &point) const
        {
            Corner v;
            for (std::size_t i = 0; i < 3; ++i) {
                v[i] = point[i] * scale[i];
            }
            const Corner q{rotation[0], rotation[1], rotation[2]};
            const Corner once = cross(q, v);
            const Corner twice = cross(q, once);
            for (std::size_t i = 0; i < 3; ++i) {
                v[i] += 2 * (rotation[3] * once[i] + twice[i]) + translation[i];
            }
            return v;
        }
        static Corner cross(const Corner &a, const Corner &b)
        {
            return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
        }
        /// Faces are turned by readers where this is negative.
        [[nodiscard]] double sign() const { return scale[0] * scale[1] * scale[2]; }
    };

    static std::uint32_t word(const std::string &bytes, std::size_t place)
    {
        std::uint32_t value = 0;
        std::memcpy(&value, bytes.data() + place, 4);
        return value;
    }

    static std::size_t widthOf(const QJsonObject &accessor)
    {
        const QString type = accessor["type"].toString();
        return type == "SCALAR" ? 1 : static_cast<std::size_t>(type.last(1).toInt());
    }

    static std::vector<double> numbers(const QJsonValue &value, std::vector<double> otherwise)
    {
        if (value.isArray()) {
            otherwise.clear();
            for (const QJsonValue &number : value.toArray()) {
                otherwise.push_back(number.toDouble());
            }
        }
        return otherwise;
    }

    static Placing placingOf(const QJsonObject &node)
    {
        return {numbers(node["translation"], {0, 0, 0}), numbers(node["rotation"], {0, 0, 0, 1}),
                numbers(node["scale"], {1, 1, 1})};
    }

    [[nodiscard]] std::vector<Placing> instancesOf(const QJsonObject &node) const
    {
        const QJsonObject attributes =
            node["extensions"].toObject()["EXT_mesh_gpu_instancing"].toObject()["attributes"].toObject();
        if (attributes.isEmpty()) {
            return {Placing()};
        }
        const auto translations = elements(attributes["TRANSLATION"].toInteger());
        const auto rotations = elements(attributes["ROTATION"].toInteger());
        const auto scales = elements(attributes["SCALE"].toInteger());
        std::vector<Placing> result;
        for (std::size_t i = 0; i < translations.size(); ++i) {
            result.push_back({translations[i], rotations.at(i), scales.at(i)});
        }
        return result;
    }

    /// Instances are taken for never mirrored by themselves, as viewers do, which turn faces by the node alone.
    void append(const QJsonObject &primitive, const Placing &node, const Placing &instance,
                std::vector<Triangle> &result) const
    {
        const auto positions = elements(primitive["attributes"].toObject()["POSITION"].toInteger());
        const auto indices = elements(primitive["indices"].toInteger());
        for (std::size_t i = 0; i < indices.size(); i += 3) {
            Triangle triangle;
            for (std::size_t corner = 0; corner < 3; ++corner) {
                const std::vector<double> &p = positions.at(static_cast<std::size_t>(indices[i + corner][0]));
                triangle[node.sign() < 0 ? 2 - corner : corner] = node(instance({p[0], p[1], p[2]}));
            }
            result.push_back(triangle);
        }
    }

    [[nodiscard]] bool viewsAreSound() const
    {
        std::size_t end = 0;
        for (const QJsonValue &value : json["bufferViews"].toArray()) {
            const QJsonObject view = value.toObject();
            const auto offset = static_cast<std::size_t>(view["byteOffset"].toInteger());
            if (offset < end || offset % 4 != 0) {
                return false;
            }
            end = offset + static_cast<std::size_t>(view["byteLength"].toInteger());
        }
        return end <= m_binary.size() && m_binary.size() < end + 4;
    }

    [[nodiscard]] bool accessorsAreSound() const
    {
        for (qint64 i = 0; i < json["accessors"].toArray().size(); ++i) {
            const QJsonObject accessor = at("accessors", i);
            const QJsonObject view = at("bufferViews", accessor["bufferView"].toInteger());
            const qint64 width = 4 * static_cast<qint64>(widthOf(accessor));
            const qint64 end = accessor["byteOffset"].toInteger()
                + (accessor["count"].toInteger() - 1) * view["byteStride"].toInteger(width) + width;
            if (accessor["count"].toInteger() < 1 || end > view["byteLength"].toInteger()
                || (accessor.contains("min") && !boundsHold(i, accessor))) {
                return false;
            }
        }
        return true;
    }

    /// The bounds are those of the numbers, to the last bit.
    [[nodiscard]] bool boundsHold(qint64 index, const QJsonObject &accessor) const
    {
        std::vector<std::vector<double>> all = elements(index);
        for (qsizetype i = 0; i < accessor["min"].toArray().size(); ++i) {
            const auto at = [&](const std::vector<double> &element) { return element[static_cast<std::size_t>(i)]; };
            const auto [least, greatest] = std::ranges::minmax(all, {}, at);
            if (at(least) != accessor["min"].toArray()[i].toDouble()
                || at(greatest) != accessor["max"].toArray()[i].toDouble()) {
                return false;
            }
        }
        return true;
    }

    std::string m_binary;
    bool m_isSound = false;
};

inline std::string glbOf(const Scene &scene)
{
    return exported(scene, {.format = ExportFormat::Glb, .source = "a.fdo"});
}

}
