// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "core/formats/parsedlines.h"

#include <format>
#include <string>
#include <variant>
#include <vector>

#include <QTest>
#include <rapidcheck.h>

#include "core/formats/fdomodel.h"
#include "core/formats/fdosyntax.h"
#include "core/formats/sdosyntax.h"
#include "tests/testmain.h"

namespace romanesco::test {

namespace {

/// Writes down all that a line holds, so that two can be compared and what differs be read. Names are written as words:
/// their numbers depend on what was typed before.
class Transcript
{
public:
    explicit Transcript(const NameTable *names = nullptr)
        : m_names(names)
    {
    }

    [[nodiscard]] const std::string &text() const { return m_text; }

    template<typename... Parts>
    void add(const Parts &...parts)
    {
        m_text += '(';
        (write(parts), ...);
        m_text += ')';
    }

    void write(std::monostate) { m_text += "nothing "; }
    void write(bool value) { m_text += value ? "yes " : "no "; }
    void write(double value) { m_text += std::format("{}", value) + ' '; }
    void write(std::uint32_t value) { m_text += std::to_string(value) + ' '; }
    void write(std::uint64_t value) { m_text += std::to_string(value) + ' '; }
    void write(LineRange range) { add(range.begin, range.end); }
    void write(SourceRange range) { add(range.begin, range.end); }
    void write(const glm::dvec3 &vector) { add(vector.x, vector.y, vector.z); }
    void write(const std::string &words) { m_text += words + ' '; }

    template<typename Part>
    void write(const std::optional<Part> &part)
    {
        if (part) {
            add(*part);
        } else {
            m_text += "none ";
        }
    }

    template<typename Range>
        requires requires(const Range &range) { range.begin() != range.end(); }
    void write(const Range &range)
    {
        for (const auto &part : range) {
            add(part);
        }
    }

    void write(const TextEdit &edit) { add(edit.range, edit.text); }
    void write(const Fix &fix) { add(fix.title, fix.edits); }
    void write(const Note &note)
    {
        add(static_cast<std::uint32_t>(note.code), note.range, note.arguments, note.file, note.position.line,
            note.position.column);
    }
    void write(const Diagnostic &diagnostic)
    {
        add(static_cast<std::uint32_t>(diagnostic.code), diagnostic.range, diagnostic.arguments, diagnostic.fix,
            diagnostic.notes);
    }

    void write(const Word &word) { add(std::string((*m_names)[word.name]), word.range); }
    void write(const VectorReference &reference) { add(reference.word, reference.number); }
    void write(const VectorDeclaration &node) { add(node.name, node.value); }
    void write(const TransformationDeclaration &node) { add(node.name, node.parameters, node.results); }
    void write(const TransformationUse &use) { add(use.name, use.arguments, use.range); }
    void write(const SetExpression &set) { add(set.uses, set.range); }
    void write(const Value &value) { add(value.sets, value.inner, value.isMesh, value.depth, value.depthRange); }
    void write(const ObjectDeclaration &node) { add(node.name, node.base, node.value); }
    void write(const UnknownDeclaration &node) { add(node.name); }

    void write(const NumberExpression &number) { add(number.value, number.range); }
    void write(const VectorExpression &vector) { add(vector.value, vector.isIdentity, vector.range, vector.numbers); }
    void write(const TransformExpression &transform)
    {
        add(transform.position, transform.rotation, transform.scale, transform.isIdentity, transform.range);
    }
    void write(const PlacedFile &file) { add(file.path, file.transform); }
    void write(const CameraLine &node)
    {
        add(node.position, node.rotation, node.view, node.isOrthographic, node.projection);
    }
    void write(const ObjectLine &node) { add(node.file); }
    void write(const FractalLine &node) { add(node.file); }
    void write(const BallLine &node) { add(node.file, node.restitution, node.velocity); }
    void write(const LightLine &node) { add(node.position, node.colour); }

    template<typename Line>
    void line(const Line &line)
    {
        m_text += std::to_string(line.declaration.index()) + ' ';
        std::visit([&](const auto &node) { write(node); }, line.declaration);
        add(line.isBad, line.diagnostics);
        if constexpr (requires { line.range; }) {
            add(line.range);
        }
    }

private:
    const NameTable *m_names;
    std::string m_text;
};

template<typename Syntax>
std::string transcript(const Syntax &syntax)
{
    const NameTable *names = nullptr;
    if constexpr (requires { syntax.names(); }) {
        names = &syntax.names();
    }
    Transcript transcript(names);
    transcript.add(syntax.text(), syntax.lineCount(), syntax.diagnostics());
    for (std::size_t i = 0; i < syntax.lineCount(); ++i) {
        transcript.add(std::string(syntax.map().lineText(i)));
        transcript.line(syntax.line(i));
    }
    return transcript.text();
}

std::string remarks(const FdoSyntax &syntax)
{
    Transcript transcript;
    transcript.add(resolveFdo(syntax).diagnostics);
    return transcript.text();
}

using Pieces = std::vector<std::string>;

/// What shakes a reader of lines in any language.
const Pieces shaking = {"\n", "\r",   "\r\n", "\n\n",     "\xEF\xBB\xBF",      "\"", "#", " ", "(",
                        ",",  "\xC3", "é",    "\xFF\xFE", std::string(1, '\0')};

const Pieces fdoPieces = {"v 1 1 -2\n",
                          "half 0.5 0.5 0.5\n",
                          "x. \"a.obj\"\n",
                          "t.a. (a, #, half)\n",
                          "y. [#, t.1] x\n",
                          "z<x>. [t.half] y\n",
                          "<$>. z 6\n",
                          "x",
                          "1",
                          "."};

const Pieces sdoPieces = {"c (1, 2, 3) (0, 90, 0) 60\n",
                          "o \"a.obj\" ((0, 2, 0), #, #) # a note\n",
                          "f \"a.fdo\" #\n",
                          "p \"a.obj\" # 0.6 (1, 0, 0)\n",
                          "l # (1, 0.95, 0.9)\n",
                          "o",
                          "1",
                          "."};

/// One keystroke or one paste: some bytes go, a piece comes, anywhere.
std::string edited(std::string text, const Pieces &pieces)
{
    const auto at = *rc::gen::inRange<std::size_t>(0, text.size() + 1);
    const auto removed = *rc::gen::element<std::size_t>(0, 0, 1, 1, 2, 7, 40);
    const bool isShaken = *rc::gen::arbitrary<bool>();
    const std::string piece = *rc::gen::elementOf(isShaken ? shaking : pieces);
    return text.replace(at, removed, *rc::gen::arbitrary<bool>() ? piece : std::string());
}

/// Calls compare with a syntax that has lived through edits, after each.
template<typename Syntax, typename Compare>
bool holdsAfterEveryEdit(const Pieces &pieces, Compare &&compare)
{
    return rc::check([&] {
        std::string text;
        for (const std::string &piece : *rc::gen::container<Pieces>(rc::gen::elementOf(pieces))) {
            text += piece;
        }
        Syntax syntax(text);
        for (int edits = *rc::gen::inRange(1, 100); edits > 0; --edits) {
            text = edited(std::move(text), pieces);
            syntax.setText(text);
            compare(syntax, Syntax(text));
        }
    });
}

}

/// Property: a text that was edited reads as one that was opened.
class TestParsedLines : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void editedFractalsReadAsOpenedOnes();
    void editedScenesReadAsOpenedOnes();
};

void TestParsedLines::editedFractalsReadAsOpenedOnes()
{
    QVERIFY(holdsAfterEveryEdit<FdoSyntax>(fdoPieces, [](const FdoSyntax &syntax, const FdoSyntax &fresh) {
        RC_ASSERT(transcript(syntax) == transcript(fresh));
        RC_ASSERT(remarks(syntax) == remarks(fresh));
    }));
}

void TestParsedLines::editedScenesReadAsOpenedOnes()
{
    QVERIFY(holdsAfterEveryEdit<SdoSyntax>(sdoPieces, [](const SdoSyntax &syntax, const SdoSyntax &fresh) {
        RC_ASSERT(transcript(syntax) == transcript(fresh));
    }));
}

}

ROMANESCO_TEST(romanesco::test::TestParsedLines)

#include "testparsedlines.moc"
