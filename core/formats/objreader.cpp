// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "objreader.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <string>

#include "core/text/linemap.h"
#include "numbers.h"

namespace romanesco {

namespace {

constexpr std::string_view blanks = " \t\v\f";

/// Takes the next word off a line; empty at its end.
std::string_view takeWord(std::string_view &line)
{
    const std::size_t begin = std::min(line.find_first_not_of(blanks), line.size());
    const std::size_t end = std::min(line.find_first_of(blanks, begin), line.size());
    const std::string_view word = line.substr(begin, end - begin);
    line.remove_prefix(end);
    return word;
}

class ObjReader
{
public:
    explicit ObjReader(std::string_view text)
        : m_text(text)
    {
    }

    ObjResult read()
    {
        if (m_text.starts_with("\x1F\x8B")) {
            error(DiagnosticCode::ObjCompressed, m_text.substr(0, 0));
        } else if (m_text.starts_with("\xFF\xFE") || m_text.starts_with("\xFE\xFF")) {
            error(DiagnosticCode::NotUtf8, m_text.substr(0, 0), {"it looks like UTF-16"});
        } else {
            readLines();
        }
        return std::move(m_result);
    }

private:
    bool error(DiagnosticCode code, std::string_view place, std::vector<std::string> arguments = {})
    {
        const auto begin = static_cast<std::size_t>(place.data() - m_text.data());
        m_result.diagnostics.push_back({code, {begin, begin + place.size()}, std::move(arguments)});
        return false;
    }

    void readLines()
    {
        const LineMap lines(m_text);
        for (std::size_t i = 0; i < lines.lineCount(); ++i) {
            SourceRange range = lines.line(i);
            if (i == 0 && m_text.starts_with("\xEF\xBB\xBF")) {
                range.begin += 3;
            }
            std::string_view line = m_text.substr(range.begin, range.length());
            std::string_view rest = line;
            const std::string_view keyword = takeWord(rest);
            const bool isVertex = keyword == "v";
            if (!isVertex && keyword != "f") {
                continue;
            }
            m_words.clear();
            collectWords(rest);
            while (!m_words.empty() && m_words.back() == "\\" && i + 1 < lines.lineCount()) {
                m_words.pop_back();
                const SourceRange next = lines.line(++i);
                collectWords(m_text.substr(next.begin, next.length()));
            }
            if (!(isVertex ? readVertex(line) : readFace(line))) {
                return;
            }
        }
    }

    /// The words of a line up to a comment.
    void collectWords(std::string_view rest)
    {
        for (std::string_view word = takeWord(rest); !word.empty() && word[0] != '#'; word = takeWord(rest)) {
            // "3\" at the end of a line is the word 3 and the mark that the line goes on.
            if (word.size() > 1 && word.back() == '\\') {
                m_words.push_back(word.substr(0, word.size() - 1));
                m_words.push_back(word.substr(word.size() - 1)); // of the text, as errors name its place
            } else {
                m_words.push_back(word);
            }
        }
    }

    bool readVertex(std::string_view line)
    {
        if (m_words.size() < 3) {
            return error(DiagnosticCode::ObjTooFewCoordinates, line, {std::to_string(m_words.size())});
        }
        glm::dvec3 vertex;
        for (int i = 0; i < 3; ++i) {
            const std::string_view word = m_words[static_cast<std::size_t>(i)];
            const auto [value, status] = numberFromText(word);
            if (status == NumberStatus::Malformed || status == NumberStatus::Overflow) {
                const bool isMalformed = status == NumberStatus::Malformed;
                return error(isMalformed ? DiagnosticCode::BadNumber : DiagnosticCode::NumberTooLarge, word,
                             {std::string(word)});
            }
            vertex[i] = value;
        }
        m_result.mesh.vertices.push_back(vertex);
        return true;
    }

    bool readFace(std::string_view line)
    {
        if (m_words.size() < 3) {
            return error(DiagnosticCode::ObjTooFewCorners, line, {std::to_string(m_words.size())});
        }
        std::uint32_t first = 0;
        std::uint32_t previous = 0;
        for (std::size_t i = 0; i < m_words.size(); ++i) {
            const std::optional<std::uint32_t> index = readIndex(m_words[i]);
            if (!index) {
                return false;
            }
            if (i == 0) {
                first = *index;
            } else if (i > 1) {
                m_result.mesh.faces.push_back({first, previous, *index});
            }
            previous = *index;
        }
        return true;
    }

    std::optional<std::uint32_t> readIndex(std::string_view corner)
    {
        const std::string_view word = corner.substr(0, corner.find('/'));
        const bool isFromEnd = word.starts_with('-');
        const std::optional<std::uint64_t> number = wholeFromText(word.substr(isFromEnd ? 1 : 0));
        if (!number) {
            error(DiagnosticCode::ObjBadIndex, corner, {std::string(corner)});
            return std::nullopt;
        }
        const std::size_t count = m_result.mesh.vertices.size();
        if (*number == 0) {
            error(DiagnosticCode::ObjIndexZero, corner);
            return std::nullopt;
        }
        if (*number > count || count > std::numeric_limits<std::uint32_t>::max()) {
            const char *form = count == 1 ? " vertex" : " vertices";
            error(DiagnosticCode::ObjIndexOutside, corner, {std::string(word), std::to_string(count) + form});
            return std::nullopt;
        }
        return static_cast<std::uint32_t>(isFromEnd ? count - *number : *number - 1);
    }

    std::string_view m_text;
    ObjResult m_result;
    std::vector<std::string_view> m_words;
};

}

ObjResult readObj(std::string_view text)
{
    return ObjReader(text).read();
}

}
