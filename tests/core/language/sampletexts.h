// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include <rapidcheck.h>

/// Texts for properties: .fdo texts without errors, and bytes that look a little like one.
namespace romanesco::test {

/// Writes a text line by line; what it has declared says what the next line may use.
class SampleFdo
{
public:
    std::string write()
    {
        const int lines = *rc::gen::inRange(0, 14);
        addVector();
        addMesh();
        for (int i = 0; i < lines; ++i) {
            addLine();
        }
        addLine("<$>." + blank() + value(pick(m_objects), false));
        if (*rc::gen::arbitrary<bool>()) {
            addVector();
        }
        return m_text;
    }

private:
    struct Transformation {
        std::string name;
        int parameters;
    };
    /// An object and those that it is built on by name, itself first.
    struct Object {
        std::string name;
        std::vector<std::string> chain;
    };
    struct Recursive {
        std::string name;
        Object base;
    };

    template<typename T>
    static const T &pick(const std::vector<T> &from)
    {
        return from[*rc::gen::inRange<std::size_t>(0, from.size())];
    }

    static std::string blank() { return *rc::gen::element<std::string>("", " ", "  ", "\t"); }

    /// Unlike all others: its number is part of it.
    std::string freshName()
    {
        const std::string start = *rc::gen::element<std::string>("a", "_", "t", "v", "\u00E9", "\u4E2D");
        return start + std::to_string(++m_names);
    }

    void addLine(const std::string &line)
    {
        m_text += blank() + line + *rc::gen::element<std::string>("", " ", "  # a note, t.1 \"x\"");
        m_text += *rc::gen::element<std::string>("\n", "\r\n", "\n\n", "\n# t.1 [v]\n");
    }

    void addLine()
    {
        switch (*rc::gen::inRange(0, 8)) {
        case 0:
        case 1:
            return addVector();
        case 2:
        case 3:
            return addTransformation();
        case 4:
            return addMesh();
        case 5:
        case 6:
            return addObject();
        default:
            return addRecursive();
        }
    }

    void addVector()
    {
        const bool isNamed = *rc::gen::arbitrary<bool>();
        const std::string comma = *rc::gen::element<std::string>(" ", ", ");
        std::string line = isNamed ? freshName() : "v";
        ++m_vectorCount;
        if (isNamed) {
            m_vectors.push_back(line);
        }
        for (int i = 0; i < 3; ++i) {
            line += (i == 0 ? " " : comma) + *rc::gen::element<std::string>("1", "-2", "0.5", ".25", "90", "1e-1");
        }
        addLine(line);
    }

    /// By number or by name.
    std::string vector()
    {
        if (m_vectors.empty() || *rc::gen::arbitrary<bool>()) {
            return std::to_string(*rc::gen::inRange(1, m_vectorCount + 1));
        }
        return pick(m_vectors);
    }

    void addTransformation()
    {
        Transformation made{freshName(), *rc::gen::inRange(0, 4)};
        std::vector<std::string> parameters;
        std::string line = made.name + '.';
        for (int i = 0; i < made.parameters; ++i) {
            // now and then the name of a vector, which it hides
            const bool isHiding = !m_vectors.empty() && *rc::gen::inRange(0, 4) == 0;
            std::string name = isHiding ? pick(m_vectors) : std::string(1, static_cast<char>('p' + i));
            if (std::ranges::contains(parameters, name)) {
                name = std::string(1, static_cast<char>('p' + i));
            }
            parameters.push_back(name);
            line += blank() + name + '.';
        }
        line += blank() + '(';
        for (int i = 0; i < 3; ++i) {
            const int choice = *rc::gen::inRange(0, 3);
            const bool isParameter = choice == 0 && !parameters.empty();
            line += blank() + (choice == 1 ? "#" : isParameter ? pick(parameters) : vector()) + (i < 2 ? "," : ")");
        }
        m_transformations.push_back(std::move(made));
        addLine(line);
    }

    std::string use()
    {
        if (m_transformations.empty() || *rc::gen::inRange(0, 5) == 0) {
            return "#";
        }
        const Transformation &transformation = pick(m_transformations);
        std::string text = transformation.name;
        for (int i = 0; i < transformation.parameters; ++i) {
            text += '.' + blank() + vector();
        }
        return text + *rc::gen::element<std::string>("", ".", "");
    }

    std::string sets(int least)
    {
        std::string text;
        for (int set = *rc::gen::inRange(least, 3); set > 0; --set) {
            text += '[' + blank() + use();
            for (int more = *rc::gen::inRange(0, 3); more > 0; --more) {
                text += blank() + ',' + blank() + use();
            }
            text += "] ";
        }
        return text;
    }

    std::string value(const Object &inner, bool needsSet) { return sets(needsSet ? 1 : 0) + inner.name; }

    void addMesh()
    {
        Object made{freshName(), {}};
        made.chain = {made.name};
        addLine(made.name + '.' + blank() + sets(0) + *rc::gen::element<std::string>("\"x.obj\"", "\"a b.obj\""));
        m_objects.push_back(std::move(made));
    }

    void addObject()
    {
        Object made{freshName(), {}};
        if (!m_recursives.empty() && *rc::gen::arbitrary<bool>()) {
            const Recursive &inner = pick(m_recursives);
            made.chain = inner.base.chain;
            addLine(made.name + '.' + blank() + sets(0) + inner.name + ' ' + std::to_string(*rc::gen::inRange(0, 4)));
        } else {
            const Object &inner = pick(m_objects);
            made.chain = inner.chain;
            addLine(made.name + '.' + blank() + value(inner, false));
        }
        made.chain.insert(made.chain.begin(), made.name);
        m_objects.push_back(std::move(made));
    }

    void addRecursive()
    {
        const Object &body = pick(m_objects);
        const std::string base = pick(body.chain);
        const Recursive made{freshName(), *std::ranges::find(m_objects, base, &Object::name)};
        addLine(made.name + blank() + '<' + blank() + base + '>' + blank() + '.' + blank() + value(body, true));
        m_recursives.push_back(made);
    }

    std::string m_text;
    int m_names = 0;
    int m_vectorCount = 0;
    /// Those with a name of their own.
    std::vector<std::string> m_vectors;
    std::vector<Transformation> m_transformations;
    std::vector<Object> m_objects;
    std::vector<Recursive> m_recursives;
};

/// An .fdo text without an error, that uses what it declares in every way.
inline rc::Gen<std::string> validFdo()
{
    return rc::gen::exec([] { return SampleFdo().write(); });
}

/// Any bytes, most of them such as the languages are made of.
inline rc::Gen<std::string> anyBytes()
{
    using Pieces = std::vector<std::string>;
    return rc::gen::map(
        rc::gen::container<Pieces>(rc::gen::oneOf(
            rc::gen::element<std::string>("v", "t", "x", "z", "c", "o", "f", "p", "l", ".", ".", ",", "(", ")", "[",
                                          "]", "<", ">", "<$>", "#", "\"", ".obj", ".fdo", "1", "2", "0.5", "-3", "6"),
            rc::gen::element<std::string>(" ", " ", "\n", "\r\n", "\r", "\t", "\u00E9", "\xC3", "\xEF\xBB\xBF", "%"),
            rc::gen::element<std::string>("v 1 1 1\n", "half 1 2 3\n", "t.a. (a, 1, half)\n", "x. \"x.obj\"\n",
                                          "z<x>. [t.1, #] x\n", "\n<$>. z 6", "y. [t.half", "o \"x.obj\" #\n",
                                          "c # # 60 ", "((1, 2, 3), #, #)"),
            rc::gen::map(rc::gen::arbitrary<std::uint8_t>(),
                         [](std::uint8_t byte) { return std::string(1, static_cast<char>(byte)); }))),
        [](const Pieces &pieces) {
            std::string text;
            for (const std::string &piece : pieces) {
                text += piece;
            }
            return text;
        });
}

}
