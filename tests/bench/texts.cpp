// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "texts.h"

#include <algorithm>
#include <format>
#include <iterator>

namespace romanesco {

namespace {

/// What most shapes stand on.
constexpr std::string_view head = "v 0 1 0\n"
                                  "half .5 .5 .5\n"
                                  "t.a. (a, #, half)\n"
                                  "o0. \"trunk.obj\"\n";

/// Appends to a text; std::format would make a string for each line.
template<typename... Arguments>
void add(std::string &text, std::format_string<Arguments...> words, Arguments &&...arguments)
{
    std::format_to(std::back_inserter(text), words, std::forward<Arguments>(arguments)...);
}

/// Parts of ten lines: a comment, vectors, transformations, sets of five uses, a recursive; each part stands on the one
/// before.
std::string person(std::size_t lines)
{
    std::string text = "# A tree that somebody drew part by part\n"
                       "half  0.5 0.5 0.5\n"
                       "left  0 0 35\n"
                       "right 0 0 -35.25\n"
                       "trunk_0. \"trunk.obj\"\n";
    for (std::size_t i = 1; i <= lines / 10; ++i) {
        add(text, "# part {}: how this branch turns, and how far\n", i);
        add(text, "up_{}     0 {}.125 0\n", i, i);
        add(text, "v 1.5, {}, -2e-1\n\n", i);
        add(text, "turn_{}.way.angle. (way, angle, half)\n", i);
        add(text, "grow_{}. (up_{}, left, half)    # stays upright\n", i, i);
        add(text, "start_{}. trunk_{}\n", i, i - 1);
        add(text, "ring_{0}. [#, grow_{0}, turn_{0}.up_{0}.right, turn_{0}.half.left, turn_{0}.half.right] start_{0}\n",
            i);
        add(text,
            "twig_{0}<ring_{0}>. [#, turn_{0}.up_{0}.right, turn_{0}.{1}.left, turn_{0}.1.2, grow_{0}] ring_{0}\n", i,
            3 + 2 * i);
        add(text, "trunk_{0}. twig_{0} 6\n", i);
    }
    add(text, "<$>. trunk_{}\n", lines / 10);
    return text;
}

std::string chained(std::size_t objects)
{
    std::string text(head);
    for (std::size_t i = 1; i <= objects; ++i) {
        add(text, "o{}. [t.1] o{}\n", i, i - 1);
    }
    add(text, "<$>. o{}\n", objects);
    return text;
}

/// Recursives on recursives: one iteration of each is one of the one before, and a level.
std::string recursives(std::size_t count)
{
    std::string text(head);
    text += "r0<o0>. [t.1] o0\n";
    for (std::size_t i = 1; i <= count; ++i) {
        add(text, "r{}<o0>. [t.1] r{} 1\n", i, i - 1);
    }
    add(text, "<$>. r{} 3\n", count);
    return text;
}

/// One set of many uses, no two of which are the same map.
std::string oneSet(std::size_t uses)
{
    std::string text(head);
    for (std::size_t i = 0; i < 1'000; ++i) {
        add(text, "v {} 1 1\n", 0.0625 * static_cast<double>(i + 2)); // also as angles no two are equal
    }
    text += "u.a.b. (a, b, half)\n<$>. [#, t.1";
    for (std::size_t i = 0; i < uses; ++i) {
        add(text, ", u.{}.{}", 3 + i / 1'000 % 1'000, 3 + i % 1'000);
    }
    return text + "] o0\n";
}

/// Set after set in one value.
std::string manySets(std::size_t sets)
{
    std::string text(head);
    text += "<$>. ";
    for (std::size_t i = 0; i < sets; ++i) {
        text += "[t.1] ";
    }
    return text + "o0\n";
}

/// What a parser by recursive descent would descend into.
std::string openBrackets(std::size_t count)
{
    return std::string(head) + "<$>. " + std::string(count, '[') + "\n" + "t.p. " + std::string(count, '(') + "\n"
        + "v " + std::string(count, '-') + "1\n" + "z" + std::string(count, '<') + "\n";
}

/// Many words on one line, which could be a vector until its last.
std::string longLine(std::size_t bytes)
{
    std::string text(head);
    text += "far";
    while (text.size() < bytes) {
        text += " nan 12.5,";
    }
    return text + "\n<$>. [t.1] o0\n";
}

/// One name and one number, each half of the text.
std::string longWords(std::size_t bytes)
{
    return std::string(head) + std::string(bytes / 2, 'n') + " 1 2 " + std::string(bytes / 2, '9')
        + "\n<$>. [t.1] o0\n";
}

std::string longComment(std::size_t bytes)
{
    return "# " + std::string(bytes, '#') + "\n" + std::string(head) + "<$>. [t.1] o0\n";
}

/// Names that differ only at their ends.
std::string samePrefix(std::size_t names)
{
    std::string text(head);
    for (std::size_t i = 0; i < names; ++i) {
        add(text, "the_same_beginning_of_quite_some_length_for_every_name_{0:08}. [t.1] o0\n", i);
    }
    return text + "<$>. [t.1] o0\n";
}

/// One name declared again and again, a vector name repeated, and a use of each.
std::string sameName(std::size_t lines)
{
    std::string text(head);
    for (std::size_t i = 0; i < lines / 3; ++i) {
        text += "again 1 2 3\no1. [t.again] o0\no1. o1\n";
    }
    return text + "<$>. [t.1] o0\n";
}

/// An error on every line, of several kinds.
std::string errors(std::size_t lines)
{
    static constexpr std::string_view kinds[] = {
        "a 1 2\n",         "b. [none] o0\n", "c. (#, #)\n",    "d<>. o0\n", "1e 2 3 4\n",     "f 1 2,5 3\n",
        "g. [t.1.2] o0\n", "h. [t.99] o0\n", "i. \"x.png\"\n", "j. ]\n",    "k. none 99x9\n", "\xFF\xC3\xA4 \xE2\x82\n",
    };
    std::string text(head);
    for (std::size_t i = 0; i < lines; ++i) {
        text += kinds[i % std::size(kinds)];
    }
    return text + "<$>. [t.1] o0\n";
}

/// What somebody could place in a scene, item by item.
std::string scene(std::size_t lines)
{
    std::string text = "# A scene\nc (1, 2, -3) (0.1, -0.2, 0) 60\n";
    for (std::size_t i = 0; i < lines / 4; ++i) {
        add(text, "o \"house_{0}.obj\" (({0}, 0, 2.5), #, (1, 1, 1.5)) # number {0}\n", i);
        add(text, "f \"tree.fdo\" (({}, 0, 0), (0, {}.5, 0), #)\n", i, i % 360);
        add(text, "p \"ball.obj\" ((0, {}, 0), #, #) 0.6 (1, 0, -2e-1)\n", i);
        add(text, "l ({}, 40, -10) (1, 0.95, 0.9)\n", i);
    }
    return text;
}

std::string sceneErrors(std::size_t lines)
{
    static constexpr std::string_view kinds[] = {
        "o \"a.obj\"\n",        "f \"a.obj\" #\n",         "p \"a.obj\" # 7\n", "l (1, 2 3) #\n",
        "c (1,5 2,5 3) # 60\n", "o \"a.obj\" ((((\n",      "camera\n",          "x\n",
        "o \"a.obj # #\n",      "\xFF\xC3\xA4 \xE2\x82\n",
    };
    std::string text;
    for (std::size_t i = 0; i < lines; ++i) {
        text += kinds[i % std::size(kinds)];
    }
    return text;
}

std::string sceneBrackets(std::size_t count)
{
    return "o \"a.obj\" " + std::string(count, '(') + '\n';
}

/// One line of sets that each repeat a map.
std::string repeats(std::size_t sets)
{
    std::string text(head);
    text += "<$>. ";
    for (std::size_t i = 0; i < sets; ++i) {
        text += "[#,#]";
    }
    return text + " o0\n";
}

/// Many small faces, with all that corners may have.
std::string objFaces(std::size_t faces)
{
    std::string text = "v 0 0 0\nv 1 0 0.25\nv 1 1 -1e-3\nv 0 1 3.14159265358979\n";
    for (std::size_t i = 1; i <= faces; ++i) {
        add(text, "v {}.125 -{}e-1 .5\nvt 0.{} 1\nvn 0 0 1\nf -1/-1/-1 {}//{} 1/{} 2\n", i, i, i, i, i, i);
    }
    return text;
}

std::string objConvex(std::size_t corners)
{
    std::string text;
    std::string face = "f";
    for (std::size_t i = 0; i < corners; ++i) {
        add(text, "v {} {} 0\n", i, i * i); // a parabola
        add(face, " {}", i + 1);
    }
    return text + face + '\n';
}

/// One face with teeth of four corners.
std::string objComb(std::size_t teeth)
{
    std::string text = "v 0 -1 0\n";
    std::string face = "f 1";
    for (std::size_t i = 0; i < teeth; ++i) {
        add(text, "v {0} 0 0\nv {0} -{1} 0\nv {0}.5 -{1} 0\nv {0}.5 0 0\n", i, 2 + i % 7);
        add(face, " {} {} {} {}", 4 * i + 2, 4 * i + 3, 4 * i + 4, 4 * i + 5);
    }
    add(text, "v {} 1 0\nv 0 1 0\n", teeth);
    add(face, " {} {}\n", 4 * teeth + 2, 4 * teeth + 3);
    return text + face;
}

/// A part for each face, each of another material and group.
std::string objParts(std::size_t faces)
{
    std::string text = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
    for (std::size_t i = 0; i < faces; ++i) {
        add(text, "usemtl m{}\ng g{}\nf 1 2 3\n", i, i);
    }
    return text;
}

std::string objUnknown(std::size_t lines)
{
    std::string text;
    for (std::size_t i = 0; i < lines; ++i) {
        add(text, "word{} 1 2 3\np {}\n", i, i);
    }
    return text;
}

/// One face, each corner on a line of its own.
std::string objContinued(std::size_t corners)
{
    std::string text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3";
    for (std::size_t i = 0; i < corners; ++i) {
        text += " \\\n1";
    }
    return text + '\n';
}

/// Lines that end in a CR alone: the next LF is never near.
std::string objCarriageReturns(std::size_t lines)
{
    std::string text = "v 0 0 0\rv 1 0 0\rv 0 1 0\rf 1 2 3\r";
    for (std::size_t i = 0; i < lines; ++i) {
        text += "# comment\rv 1 2 3\r";
    }
    return text;
}

constexpr TextShape shapes[] = {
    {"person", person, 2'500, 100'000, true},
    {"chained", chained, 5'000, 100'000, true},
    {"recursives", recursives, 2'500, 100'000, true},
    {"one-set", oneSet, 5'000, 200'000, true},
    {"many-sets", manySets, 5'000, 100'000, true},
    {"open-brackets", openBrackets, 300'000, 1'000'000, false},
    {"long-line", longLine, 300'000, 1'000'000, false},
    {"long-words", longWords, 300'000, 1'000'000, false},
    {"long-comment", longComment, 1'500'000, 50'000'000, true},
    {"same-prefix", samePrefix, 2'500, 100'000, false}, // nothing uses them
    {"same-name", sameName, 5'000, 100'000, false},
    {"errors", errors, 5'000, 100'000, false},
    {"repeats", repeats, 5'000, 100'000, false},
    {"scene", scene, 5'000, 100'000, true},
    {"scene-errors", sceneErrors, 5'000, 100'000, false},
    {"scene-brackets", sceneBrackets, 300'000, 1'000'000, false},
    {"obj-faces", objFaces, 5'000, 200'000, true},
    {"obj-convex", objConvex, 20'000, 300'000, true},
    {"obj-comb", objComb, 5'000, 75'000, true},
    {"obj-parts", objParts, 5'000, 200'000, true},
    {"obj-unknown", objUnknown, 5'000, 200'000, false},
    {"obj-continued", objContinued, 50'000, 1'000'000, true},
    {"obj-carriage-returns", objCarriageReturns, 20'000, 1'000'000, true},
};

}

std::span<const TextShape> textShapes()
{
    return shapes;
}

const TextShape *findTextShape(std::string_view name)
{
    const auto found = std::ranges::find(shapes, name, &TextShape::name);
    return found == std::end(shapes) ? nullptr : found;
}

}
