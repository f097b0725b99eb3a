// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "mtlreader.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string>

#include "objscanner.h"

namespace romanesco {

namespace {

/// Of map_Kd, and how many words belong to it; of numbers there may be fewer.
struct Option {
    std::string_view word;
    int words;
    bool areNumbers = false;
};
constexpr auto options = std::to_array<Option>({
    {"-blendu", 1},
    {"-blendv", 1},
    {"-bm", 1},
    {"-boost", 1},
    {"-cc", 1},
    {"-clamp", 1},
    {"-imfchan", 1},
    {"-mm", 2},
    {"-o", 3, true},
    {"-s", 3, true},
    {"-t", 3, true},
    {"-texres", 1},
    {"-type", 1},
});

class MtlReader
{
public:
    explicit MtlReader(std::string_view text)
        : m_text(text)
        , m_scan(text)
    {
    }

    MtlResult read()
    {
        if (auto refusal = refusalOfBytes(m_text)) {
            m_result.diagnostics.push_back(std::move(*refusal));
            return std::move(m_result);
        }
        for (; !m_scan.isAtEnd(); m_scan.skipLine()) {
            if (m_scan.toWord()) {
                readStatement(m_scan.takeWord());
            }
        }
        return std::move(m_result);
    }

private:
    void readStatement(std::string_view keyword);
    void readValue(std::string_view keyword, MtlResult::Entry &entry);
    std::optional<float> readNumber(float most);
    void readColour(glm::vec3 &colour);
    void readTexture(MtlResult::Entry &entry);
    void passOptions();
    bool isAtNumber();

    std::string_view m_text;
    ObjScanner m_scan;
    MtlResult m_result;
};

void MtlReader::readStatement(std::string_view keyword)
{
    if (keyword == "newmtl") {
        m_result.materials.emplace_back().material.name = m_scan.takeRest();
    } else if (!m_result.materials.empty()) {
        readValue(keyword, m_result.materials.back());
    }
}

void MtlReader::readValue(std::string_view keyword, MtlResult::Entry &entry)
{
    Material &material = entry.material;
    if (keyword == "Kd") {
        readColour(material.diffuse);
    } else if (keyword == "Ks") {
        readColour(material.specular);
    } else if (keyword == "Ke") {
        readColour(material.emission);
    } else if (keyword == "Ns") {
        material.shininess = readNumber(1e6F).value_or(material.shininess);
    } else if (keyword == "d") {
        material.opacity = readNumber(1.0F).value_or(material.opacity);
    } else if (keyword == "Tr") {
        material.opacity = 1.0F - readNumber(1.0F).value_or(1.0F - material.opacity);
    } else if (keyword == "map_Kd") {
        readTexture(entry);
    }
}

/// Held to 0…most. Nothing, and an error, where there is none.
std::optional<float> MtlReader::readNumber(float most)
{
    if (!m_scan.toWord()) {
        const std::size_t at = m_scan.offset();
        m_result.diagnostics.push_back({DiagnosticCode::Expected, {at, at}, {"the end of the line", "a number"}});
        return std::nullopt;
    }
    const std::size_t begin = m_scan.offset();
    const auto [value, status] = m_scan.takeNumber();
    if (status == NumberStatus::Malformed || status == NumberStatus::Overflow) {
        const SourceRange place{begin, m_scan.offset()};
        const bool isMalformed = status == NumberStatus::Malformed;
        m_result.diagnostics.push_back({isMalformed ? DiagnosticCode::BadNumber : DiagnosticCode::NumberTooLarge,
                                        place,
                                        {std::string(m_text.substr(begin, place.length()))}});
        return std::nullopt;
    }
    return static_cast<float>(std::clamp(value, 0.0, static_cast<double>(most)));
}

void MtlReader::readColour(glm::vec3 &colour)
{
    const std::optional<float> red = readNumber(1.0F);
    if (!red) {
        return;
    }
    if (!m_scan.toWord()) {
        colour = glm::vec3(*red);
        return;
    }
    const std::optional<float> green = readNumber(1.0F);
    const std::optional<float> blue = green ? readNumber(1.0F) : std::nullopt;
    if (blue) {
        colour = {*red, *green, *blue};
    }
}

void MtlReader::readTexture(MtlResult::Entry &entry)
{
    passOptions();
    const std::size_t begin = m_scan.offset();
    std::string name(m_scan.takeRest());
    const SourceRange place{begin, m_scan.offset()};
    if (name.empty()) {
        m_result.diagnostics.push_back(
            {DiagnosticCode::Expected, place, {"the end of the line", "the name of a file"}});
        return;
    }
    std::ranges::replace(name, '\\', '/');
    entry.material.diffuseTexture = std::move(name);
    entry.texturePlace = place;
}

/// What starts with "-" and is no option is a name.
void MtlReader::passOptions()
{
    while (m_scan.toWord()) {
        const std::size_t begin = m_scan.offset();
        const auto *option = std::ranges::find(options, m_scan.takeWord(), &Option::word);
        if (option == options.end()) {
            m_scan.goTo(begin);
            return;
        }
        for (int i = 0; i < option->words && m_scan.toWord() && (!option->areNumbers || isAtNumber()); ++i) {
            m_scan.takeWord();
        }
    }
}

bool MtlReader::isAtNumber()
{
    const std::size_t begin = m_scan.offset();
    const ParsedNumber number = m_scan.takeNumber();
    m_scan.goTo(begin);
    return number.status != NumberStatus::Malformed;
}

}

MtlResult readMtl(std::string_view text)
{
    return MtlReader(text).read();
}

}
