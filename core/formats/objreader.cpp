// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "objreader.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <optional>
#include <span>
#include <string>
#include <utility>

#include <glm/common.hpp>

#include "core/geometry/polygoncutter.h"
#include "lineparser.h"
#include "objparts.h"
#include "objscanner.h"
#include "objslips.h"

namespace romanesco {

namespace {

constexpr std::uint32_t none = Mesh::none;

/// What corners may name.
struct Indexed {
    const char *one;
    const char *many;
};
constexpr auto indexed = std::to_array<Indexed>({
    {"vertex", "vertices"},
    {"texture coordinate", "texture coordinates"},
    {"normal", "normals"},
});

/// A list beside the vertices or faces starts with the first that has something; those without get a filling.
template<typename Value>
void putBeside(std::vector<Value> &list, std::size_t index, const Value &value, const Value &filling)
{
    assert(list.size() <= index && "each is put once, in order");
    list.resize(index, filling);
    list.push_back(value);
}

class ObjReader
{
public:
    explicit ObjReader(std::string_view text)
        : m_text(text)
        , m_scan(text)
    {
        assert(text.size() < none && "indices have 32 bits");
    }

    ObjResult read(const std::stop_token &stop);

private:
    using Face = Mesh::Face;
    struct Corner {
        std::uint32_t vertex = none;
        std::uint32_t textureCoordinate = none;
        std::uint32_t normal = none;
    };

    bool error(DiagnosticCode code, SourceRange place, std::vector<std::string> arguments = {});
    /// From where the statement starts to where the scanner is.
    [[nodiscard]] SourceRange statement() const { return {m_statement, m_scan.offset()}; }

    void readStatements(const std::stop_token &stop);
    bool readStatement();
    bool readElement(std::string_view keyword);
    void readOther(std::string_view keyword);

    bool readNumber(double &value);
    bool readNumbers(std::span<double> values, const char *rule);
    bool readVertex();
    bool readColour();
    bool readTextureCoordinates();
    bool readNormal();

    bool readFace();
    bool readCorner(Corner &corner);
    bool readIndex(std::size_t size, std::uint32_t &index);
    bool cornerError(std::string_view corner);
    void addPolygon();
    void addTriangle(const Corner &a, const Corner &b, const Corner &c);

    void readSmoothing();
    void readLibraries();
    void finish();

    std::string_view m_text;
    ObjScanner m_scan;
    ObjResult m_result;
    Mesh &m_mesh = m_result.mesh;
    std::size_t m_statement = 0;

    std::vector<Corner> m_corners;
    std::vector<glm::dvec3> m_polygon;
    PolygonCutter m_cutter;

    ObjParts m_parts;
    ObjSlips m_slips;
};

ObjResult ObjReader::read(const std::stop_token &stop)
{
    if (auto refusal = refusalOfBytes(m_text)) {
        m_result.diagnostics.push_back(std::move(*refusal));
    } else {
        readStatements(stop);
    }
    finish();
    return std::move(m_result);
}

bool ObjReader::error(DiagnosticCode code, SourceRange place, std::vector<std::string> arguments)
{
    m_result.diagnostics.push_back({code, place, std::move(arguments)});
    return false;
}

void ObjReader::readStatements(const std::stop_token &stop)
{
    constexpr std::size_t betweenLooks = 1 << 16;
    for (std::size_t i = 1; !m_scan.isAtEnd(); ++i) {
        if (!readStatement() || (i % betweenLooks == 0 && stop.stop_requested())) {
            return;
        }
    }
}

/// One line, with those in which it goes on. False after an error.
bool ObjReader::readStatement()
{
    if (m_scan.toWord()) {
        m_statement = m_scan.offset();
        if (!readElement(m_scan.takeWord())) {
            return false;
        }
    }
    m_scan.skipLine();
    return true;
}

bool ObjReader::readElement(std::string_view keyword)
{
    if (keyword == "v") {
        return readVertex();
    }
    if (keyword == "f") {
        return readFace();
    }
    if (keyword == "vn") {
        return readNormal();
    }
    if (keyword == "vt") {
        return readTextureCoordinates();
    }
    readOther(keyword);
    return true;
}

/// Statements about the faces behind them, and those that are passed over.
void ObjReader::readOther(std::string_view keyword)
{
    if (keyword == "usemtl") {
        const std::string_view name = m_scan.takeRest();
        m_parts.setMaterial(name, statement());
    } else if (keyword == "g" || keyword == "o") {
        m_parts.setGroup(m_scan.takeRest());
    } else if (keyword == "s") {
        readSmoothing();
    } else if (keyword == "mtllib") {
        readLibraries();
    } else {
        m_slips.count(ObjSlips::ofKeyword(keyword), statement());
        m_scan.takeRest(); // with the lines in which it goes on
    }
}

bool ObjReader::readNumber(double &value)
{
    const std::size_t begin = m_scan.offset();
    const ParsedNumber number = m_scan.takeNumber();
    value = number.value;
    if (number.status == NumberStatus::Good) [[likely]] {
        return true;
    }
    const SourceRange place{begin, m_scan.offset()};
    if (number.status == NumberStatus::Underflow) {
        m_slips.count(ObjSlips::Kind::SmallNumber, place);
        return true;
    }
    const bool isMalformed = number.status == NumberStatus::Malformed;
    return error(isMalformed ? DiagnosticCode::BadNumber : DiagnosticCode::NumberTooLarge, place,
                 {std::string(m_text.substr(place.begin, place.length()))});
}

/// As many as there is place for.
bool ObjReader::readNumbers(std::span<double> values, const char *rule)
{
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (!m_scan.toWord()) {
            return error(DiagnosticCode::ObjTooFewCoordinates, statement(), {rule, std::to_string(i)});
        }
        if (!readNumber(values[i])) {
            return false;
        }
    }
    return true;
}

bool ObjReader::readVertex()
{
    std::array<double, 3> v;
    if (!readNumbers(v, "a vertex has three coordinates")) {
        return false;
    }
    m_mesh.vertices.emplace_back(v[0], v[1], v[2]);
    return !m_scan.toWord() || readColour();
}

/// Behind the coordinates: one number is a weight, three or more start with a colour.
bool ObjReader::readColour()
{
    std::array<double, 3> parts{};
    for (double &part : parts) {
        if (!m_scan.toWord()) {
            return true;
        }
        if (!readNumber(part)) {
            return false;
        }
    }
    const glm::dvec3 written(parts[0], parts[1], parts[2]);
    const glm::dvec3 colour = glm::clamp(written, 0.0, 1.0);
    if (colour != written) {
        m_slips.count(ObjSlips::Kind::Colour, statement());
    }
    putBeside(m_mesh.colours, m_mesh.vertices.size() - 1, glm::vec3(colour), glm::vec3(1.0F));
    return true;
}

bool ObjReader::readTextureCoordinates()
{
    double u = 0.0;
    double v = 0.0;
    if (!readNumbers({&u, 1}, "texture coordinates are one number or more") || (m_scan.toWord() && !readNumber(v))) {
        return false;
    }
    m_mesh.textureCoordinates.emplace_back(u, v);
    return true;
}

bool ObjReader::readNormal()
{
    std::array<double, 3> n;
    if (!readNumbers(n, "a normal has three coordinates")) {
        return false;
    }
    m_mesh.normals.emplace_back(n[0], n[1], n[2]);
    return true;
}

bool ObjReader::readFace()
{
    m_corners.clear();
    while (m_scan.toWord()) {
        if (!readCorner(m_corners.emplace_back())) {
            return false;
        }
    }
    if (m_corners.size() < 3) {
        return error(DiagnosticCode::ObjTooFewCorners, statement(), {std::to_string(m_corners.size())});
    }
    m_parts.beginFaces(m_mesh);
    if (m_corners.size() == 3) {
        addTriangle(m_corners[0], m_corners[1], m_corners[2]);
    } else {
        addPolygon();
    }
    return true;
}

bool ObjReader::readCorner(Corner &corner)
{
    const std::size_t begin = m_scan.offset();
    bool isGood = readIndex(m_mesh.vertices.size(), corner.vertex);
    // an index between slashes may be left out
    if (isGood && m_scan.take('/') && !m_scan.isAt('/') && !m_scan.isAtWordEnd()) {
        isGood = readIndex(m_mesh.textureCoordinates.size(), corner.textureCoordinate);
    }
    if (isGood && m_scan.take('/') && !m_scan.isAtWordEnd()) {
        isGood = readIndex(m_mesh.normals.size(), corner.normal);
    }
    if (isGood && m_scan.isAtWordEnd()) [[likely]] {
        return true;
    }
    m_scan.goTo(begin);
    return cornerError(m_scan.takeWord());
}

/// Of a list of that size so far.
bool ObjReader::readIndex(std::size_t size, std::uint32_t &index)
{
    const bool isFromEnd = m_scan.take('-');
    std::uint64_t number = 0;
    if (!m_scan.takeWhole(number) || number == 0 || number > size) {
        return false;
    }
    index = static_cast<std::uint32_t>(isFromEnd ? size - number : number - 1);
    return true;
}

/// Tells what is wrong with a corner that readCorner() did not take.
bool ObjReader::cornerError(std::string_view corner)
{
    const SourceRange place{m_scan.offset() - corner.size(), m_scan.offset()};
    const std::size_t sizes[] = {m_mesh.vertices.size(), m_mesh.textureCoordinates.size(), m_mesh.normals.size()};
    std::string_view rest = corner;
    for (std::size_t kind = 0; kind < indexed.size(); ++kind) {
        const std::string_view word = rest.substr(0, rest.find('/'));
        rest.remove_prefix(std::min(word.size() + 1, rest.size()));
        if (word.empty() && kind > 0) {
            continue;
        }
        const auto number = wholeFromText(word.substr(word.starts_with('-') ? 1 : 0));
        if (!number) {
            break;
        }
        if (*number == 0) {
            return error(DiagnosticCode::ObjIndexZero, place, {indexed[kind].many, indexed[kind].one});
        }
        if (*number > sizes[kind]) {
            const char *form = sizes[kind] == 1 ? indexed[kind].one : indexed[kind].many;
            return error(DiagnosticCode::ObjIndexOutside, place,
                         {indexed[kind].one, std::string(word), std::to_string(sizes[kind]) + ' ' + form});
        }
    }
    return error(DiagnosticCode::ObjBadIndex, place, {std::string(corner)});
}

void ObjReader::addPolygon()
{
    m_polygon.clear();
    for (const Corner &corner : m_corners) {
        m_polygon.push_back(m_mesh.vertices[corner.vertex]);
    }
    for (const auto &[a, b, c] : m_cutter.cut(m_polygon)) {
        addTriangle(m_corners[a], m_corners[b], m_corners[c]);
    }
}

void ObjReader::addTriangle(const Corner &a, const Corner &b, const Corner &c)
{
    constexpr Face empty{none, none, none};
    const std::size_t index = m_mesh.faces.size();
    m_mesh.faces.push_back({a.vertex, b.vertex, c.vertex});
    const Face textureCoordinates{a.textureCoordinate, b.textureCoordinate, c.textureCoordinate};
    if (textureCoordinates != empty) {
        putBeside(m_mesh.faceTextureCoordinates, index, textureCoordinates, empty);
    }
    const Face normals{a.normal, b.normal, c.normal};
    if (normals != empty) {
        putBeside(m_mesh.faceNormals, index, normals, empty);
    }
}

void ObjReader::readSmoothing()
{
    const std::string_view word = m_scan.takeRest();
    const std::optional<std::uint64_t> number = wholeFromText(word);
    if (!number && word != "off" && word != "on") {
        m_slips.count(ObjSlips::Kind::Unknown, statement());
    }
    const std::uint64_t group = number.value_or(word == "on" ? 1 : 0);
    m_parts.setSmoothing(static_cast<std::uint32_t>(std::min<std::uint64_t>(group, none)));
}

/// Names of files are parted by blanks and may hold some; only the ending tells which.
void ObjReader::readLibraries()
{
    const std::string_view rest = m_scan.takeRest();
    std::size_t begin = 0;
    while (begin < rest.size() && rest[begin] != '#') {
        std::size_t end = begin;
        do {
            end = std::min(rest.find_first_of(" \t", end + 1), rest.size());
        } while (end < rest.size() && !hasEnding(rest.substr(begin, end - begin), ".mtl"));
        m_result.sources.libraries.push_back({std::string(rest.substr(begin, end - begin)), statement()});
        begin = std::min(rest.find_first_not_of(" \t", end), rest.size());
    }
}

/// Fills up the lists beside others, drops what nothing names, and tells what was counted.
void ObjReader::finish()
{
    constexpr Face empty{none, none, none};
    const auto fill = [](auto &list, std::size_t size, const auto &filling) {
        if (!list.empty()) {
            list.resize(size, filling);
        }
    };
    fill(m_mesh.colours, m_mesh.vertices.size(), glm::vec3(1.0F));
    fill(m_mesh.faceTextureCoordinates, m_mesh.faces.size(), empty);
    fill(m_mesh.faceNormals, m_mesh.faces.size(), empty);
    if (m_mesh.faceTextureCoordinates.empty()) {
        m_mesh.textureCoordinates = {};
    }
    if (m_mesh.faceNormals.empty()) {
        m_mesh.normals = {};
    }
    m_parts.nameParts(m_mesh);
    m_result.sources.materialPlaces = m_parts.materialPlaces();
    m_slips.report(m_result.diagnostics);
    sortByPlace(m_result.diagnostics);
}

}

ObjResult readObj(std::string_view text, const std::stop_token &stop)
{
    return ObjReader(text).read(stop);
}

}
