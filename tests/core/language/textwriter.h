// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <algorithm>
#include <cstdint>
#include <format>
#include <random>
#include <string>
#include <vector>

#include "core/formats/fdoreader.h"
#include "core/formats/sdoreader.h"

/// Texts of either language with any layout, and what they mean.
namespace romanesco::test {

/// Lines to make texts of. A blank may stand at each |, and must at each ~.
struct Patterns {
    /// Good lines that mean something, in their order.
    std::vector<std::string> skeleton;
    /// Lines that can be read, whatever they mean there.
    std::vector<std::string> extras;
    /// Lines that cannot be read.
    std::vector<std::string> slips;
};

inline const Patterns fdoPatterns{{"v~1~.5~-2", "v~5.|,|+1|,|1e-3", "half~0.50~0.5~0.5", "\xC3\xA9tage~0~30~0",
                                   "t|.|a|.|(|a|,|#|,|half|)", "k|.|(|#|,|\xC3\xA9tage|,|3|)",
                                   "u|.|a|.|b|.|(|a|,|b|,|3|)", "x|.|\"a  # [b].obj\"",
                                   "y|.|[|#|,|t|.|1|,|t|.|2|.|,|k|]|x",
                                   "z|<|x|>|.|[|k|.|,|u|.|02|.|\xC3\xA9tage|.|]|[|#|]|y", "<|$|>|.|[|t|.|half|]|z~6"},
                                  {"v~1e-400~0~0", "half~1~1~1", "long_name~1~2~3", "t|.|(|#|,|#|,|#|)", "q|.|x",
                                   "r|<|x|>|.|x", "s|.|[|k|,|k|]|x", "w|.|[|#|,|gone|]|x", "<|$|>|.|z~2"},
                                  {"v~1~2", "x.  #", "t. a.(a,  #", "q 1", "$$  <", "1 2 3 4", "y. \"open  ",
                                   "m. [k, [ # no ]", "\xC3\xA9 \xC3\xA9", "v 1,5 2  3", "w.  [k.1.2.3.4]  x", "\x01"}};

inline const Patterns sdoPatterns{
    {"c|(|-48.7|,|25.5|,|64.40|)|(|-.07|,|-2.49|,|0|)|60", "l|(|20|,|+40|,|-10|)|#", "o|\"a  #(b).obj\"|#",
     "o|\"a.obj\"|(|(|0|,|2.|,|0|)|,|#|,|#|)", "f|\"c.fdo\"|(|#|,|(|0|,|90|,|0|)|,|(|1|,|1|,|1e-1|)|)",
     "p|\"b.obj\"|#~0.6|(|1|,|0|,|0|)", "p|\"b.obj\"|(|#|,|#|,|#|)|1", "l|#|(|1|,|0.95|,|0.9|)"},
    {"c|#|#|1~orthographic", "c|#|(|90|,|0|,|0|)|45~perspective", "l|#|#",
     "o|\"a.obj\"|(|(|1e-400|,|0|,|0|)|,|#|,|#|)"},
    {"c # #", "c  # # 60 persp", "o  \"a.obj\"  0", "o \"a.fdo\"  # # no", "p \"b.obj\" #  2", "l (1, 2,  3", "q  1",
     "f \"open.fdo  ", "o \"a.obj\" #note  x", "l (1,5, 2, 3)  #", "\x01"}};

/// A text made of patterns, with comments, blank lines and slips. The same seed gives the same text.
class TextWriter
{
public:
    TextWriter(const Patterns &patterns, std::uint32_t seed)
        : m_patterns(patterns)
        , m_random(seed)
    {
        const std::size_t kind = below(4);
        m_hasMixedEnds = kind == 3;
        m_end = m_ends[kind % 3];
        m_hasSlips = chance(2);
        text = oneOf({"", "", "\xEF\xBB\xBF"});
        for (const std::string &line : patterns.skeleton) {
            while (chance(3)) {
                addExtra();
            }
            addLine(line);
        }
        while (chance(2)) {
            addBlankLine();
        }
        if (chance(3)) {
            text.erase(text.find_last_not_of("\r\n") + 1);
        }
    }

    std::string text;
    /// Without the blanks at their ends.
    std::vector<std::string> comments;

private:
    std::size_t below(std::size_t count) { return m_random() % count; }
    bool chance(std::size_t oneIn) { return below(oneIn) == 0; }
    std::string oneOf(const std::vector<std::string> &choices) { return choices[below(choices.size())]; }
    std::string blanks() { return oneOf({"", "", "", " ", " ", "  ", "   ", "\t", " \v\f"}); }

    void addLine(const std::string &pattern)
    {
        text += blanks();
        for (const char c : pattern) {
            const std::string part = c == '|' || c == '~' ? blanks() : std::string(1, c);
            text += c == '~' && part.empty() ? " " : part;
        }
        text += blanks();
        if (chance(3)) {
            addComment();
        }
        endLine();
    }

    void addExtra()
    {
        switch (below(5)) {
        case 0:
            addBlankLine();
            break;
        case 1:
            text += blanks();
            addComment();
            endLine();
            break;
        case 2:
            addLine(oneOf(m_patterns.extras));
            break;
        default:
            if (m_hasSlips) {
                addLine(oneOf(m_patterns.slips));
            }
        }
    }

    void addBlankLine()
    {
        text += blanks();
        endLine();
    }

    void addComment()
    {
        comments.push_back(oneOf({"#", "# word", "#word  and \t word", "## [x, (y", "# \xFF \"\xC3\xA9"}));
        text += comments.back() + blanks();
    }

    void endLine() { text += m_hasMixedEnds ? oneOf(m_ends) : m_end; }

    const Patterns &m_patterns;
    std::mt19937 m_random;
    std::vector<std::string> m_ends{"\n", "\r\n", "\r"};
    std::string m_end;
    bool m_hasMixedEnds = false;
    bool m_hasSlips = false;
};

/// The numbers to the last bit.
inline std::string bits(const glm::dvec3 &v)
{
    return std::format(" {:a} {:a} {:a}", v.x, v.y, v.z);
}

inline std::string bits(const AffineMap &map)
{
    return bits(map.linear[0]) + bits(map.linear[1]) + bits(map.linear[2]) + bits(map.translation);
}

/// Mesh, depth, levels and maps; "nothing" where the text means nothing.
inline std::string meaning(const FdoResult &read)
{
    if (!read.description) {
        return "nothing";
    }
    const FractalDescription &fractal = *read.description;
    std::string words = fractal.meshPath + '\n';
    words += fractal.depth ? std::to_string(fractal.depth->value) : "no depth";
    for (const LevelSequence::Repeat &repeat : fractal.levels.repeats()) {
        words += std::format("\n{}-{} x{} in {} at {}", repeat.firstSlot, repeat.endSlot, repeat.count, repeat.parent,
                             repeat.offset);
    }
    for (LevelSequence::Slot slot = 0; slot < fractal.levels.slotCount(); ++slot) {
        const TransformSet &set = fractal.sets[fractal.levels.set(slot)];
        words += set.holdsIdentity ? "\n#" : "\n";
        for (const AffineMap &map : set.maps) {
            words += bits(map);
        }
    }
    return words;
}

/// Camera, items and lights; "nothing" where the text means nothing.
inline std::string meaning(const SdoResult &read)
{
    if (!read.description) {
        return "nothing";
    }
    const SceneDescription &scene = *read.description;
    std::string words;
    if (scene.camera) {
        words += bits(scene.camera->position) + bits(scene.camera->rotation);
        words += std::format(" {:a} {}", scene.camera->view, scene.camera->isOrthographic);
    }
    for (const SceneDescription::Item &item : scene.items) {
        words += std::format("\n{} {} {:a}", static_cast<int>(item.kind), item.path, item.restitution);
        words += bits(item.velocity) + bits(item.worldFromModel);
    }
    for (const SceneDescription::Light &light : scene.lights) {
        words += '\n' + bits(light.position) + bits(light.colour);
    }
    return words;
}

}
