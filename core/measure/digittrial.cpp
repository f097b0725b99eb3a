// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "digittrial.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <format>
#include <limits>
#include <utility>

#include <glm/geometric.hpp>

#include "core/export/forecast.h"
#include "core/formats/objreader.h"
#include "core/formats/objwriter.h"
#include "samplecopies.h"
#include "scenefaces.h"

namespace romanesco {

namespace {

constexpr int leastDigits = 3;
constexpr int mostDigits = 17;
constexpr int timedRounds = 5;

class TextSink final : public ByteSink
{
public:
    [[nodiscard]] std::expected<void, std::string> write(std::string_view bytes) override
    {
        m_text += bytes;
        return {};
    }
    [[nodiscard]] const std::string &text() const { return m_text; }

private:
    std::string m_text;
};

enum class FaceKind { Proper, Collapsed, Flat };

FaceKind kindOf(const Mesh &mesh, const Mesh::Face &face)
{
    const std::array<glm::dvec3, 3> corners{mesh.vertices[face[0]], mesh.vertices[face[1]], mesh.vertices[face[2]]};
    if (corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0]) {
        return FaceKind::Collapsed;
    }
    const glm::dvec3 u = corners[1] - corners[0];
    const glm::dvec3 v = corners[2] - corners[0];
    double size = 0.0;
    for (const glm::dvec3 &corner : corners) {
        size = std::max({size, std::abs(corner.x), std::abs(corner.y), std::abs(corner.z)});
    }
    // what the last digit of a double makes of an area
    const double rounding = 4.0 * std::numeric_limits<double>::epsilon() * size * (glm::length(u) + glm::length(v));
    return glm::length(glm::cross(u, v)) <= rounding ? FaceKind::Flat : FaceKind::Proper;
}

class Trial
{
public:
    Trial(const Scene &scene, const DigitTrial::Options &options, const TrialContext &context)
        : m_scene(scene)
        , m_context(context)
        , m_copies(scene, options.mostFaces, context.stop)
    {
    }

    std::expected<DigitTrial, std::string> run()
    {
        m_made.facesInAll = facesOf(m_scene.items);
        m_made.faces = m_copies.faceCount();
        m_made.isWhole = m_copies.isWhole();
        m_made.diagonal = glm::length(m_scene.extent.size());
        if (m_made.faces == 0 || !(m_made.diagonal > 0.0)) {
            return std::unexpected("there is nothing to be written");
        }
        placeVertices();
        for (int digits = leastDigits; digits <= mostDigits + 1; ++digits) {
            if (m_context.isStopped()) {
                return std::unexpected("cancelled");
            }
            DigitRow row{.digits = digits <= mostDigits ? std::optional(digits) : std::nullopt};
            m_context.tell("export, " + nameOf(row),
                           static_cast<double>(digits - leastDigits) / (mostDigits + 2 - leastDigits));
            if (!tryOne(row)) {
                return std::unexpected("what was written reads back as another mesh");
            }
            m_made.rows.push_back(std::move(row));
        }
        return std::move(m_made);
    }

private:
    void placeVertices()
    {
        for (std::size_t item = 0; item < m_copies.items().size(); ++item) {
            const Mesh &mesh = *m_copies.items()[item].mesh;
            (void)m_copies.visit(item, [&](const MeshCopy &copy) {
                for (const glm::dvec3 &vertex : mesh.vertices) {
                    m_exact.vertices.push_back(copy.worldFromMesh(vertex));
                }
                return true;
            });
        }
        m_made.vertices = m_exact.vertices.size();
    }

    /// Whether as many vertices were read as written.
    bool tryOne(DigitRow &row) const
    {
        const TextSink sink = written(row);
        const Mesh read = readObj(sink.text()).mesh;
        if (read.vertices.size() != m_exact.vertices.size()) {
            return false;
        }
        double squares = 0.0;
        for (std::size_t i = 0; i < m_exact.vertices.size(); ++i) {
            const double off = glm::distance(read.vertices[i], m_exact.vertices[i]) / m_made.diagonal;
            row.worst = std::max(row.worst, off);
            squares += off * off;
        }
        row.rms = std::sqrt(squares / static_cast<double>(m_exact.vertices.size()));
        countFaces(read, row);
        const auto known = forecast(m_scene, {.format = ExportFormat::Obj, .digits = row.digits});
        row.bytes = known ? std::optional(known->bytes) : std::nullopt;
        return true;
    }

    [[nodiscard]] TextSink written(DigitRow &row) const
    {
        std::vector<double> nanoseconds;
        TextSink last;
        for (int i = 0; i < timedRounds; ++i) {
            TextSink sink;
            const double begin = threadSeconds();
            // into memory, which takes all
            (void)writeObj(m_copies, {.digits = row.digits}, sink);
            nanoseconds.push_back(1e9 * (threadSeconds() - begin) / static_cast<double>(m_made.faces));
            last = std::move(sink);
        }
        row.nanoseconds = spreadOf(std::move(nanoseconds));
        return last;
    }

    /// Of those that were proper before.
    void countFaces(const Mesh &read, DigitRow &row) const
    {
        for (const Mesh::Face &face : read.faces) {
            const FaceKind kind = kindOf(read, face);
            if (kind != FaceKind::Proper && kindOf(m_exact, face) == FaceKind::Proper) {
                ++(kind == FaceKind::Collapsed ? row.collapsed : row.flat);
            }
        }
    }

    const Scene &m_scene;
    const TrialContext &m_context;
    SampleCopies m_copies;
    /// Its vertices alone, in the order in which they are written.
    Mesh m_exact;
    DigitTrial m_made;
};

}

std::string nameOf(const DigitRow &row)
{
    return row.digits ? std::format("{} digits", *row.digits) : std::string("shortest");
}

std::expected<DigitTrial, std::string> tryDigits(const Scene &scene, const DigitTrial::Options &options,
                                                 const TrialContext &context)
{
    return Trial(scene, options, context).run();
}

}
