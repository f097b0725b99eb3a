// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "sdosyntax.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <format>
#include <numbers>

#include "lineparser.h"
#include "sdorepair.h"

namespace romanesco {

namespace {

/// In lower case, as far as it is ASCII.
std::string lowered(std::string_view text)
{
    std::string result(text);
    std::ranges::transform(result, result.begin(),
                           [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
    return result;
}

/// The shortest decimals that read back as the value.
std::string shortest(double value)
{
    char digits[32];
    const auto [end, status] = std::to_chars(std::begin(digits), std::end(digits), value);
    return {digits, end};
}

constexpr const char *positionWords = "a position in parentheses or #";
constexpr const char *rotationWords = "a rotation in parentheses or #";

/// Parses one line. Each parse function reports at most one error and returns false after it.
class SdoLineParser : private LineParser
{
public:
    SdoLineParser(std::string_view line, std::size_t skipped, SdoLine &result)
        : LineParser(line, skipped, result.diagnostics)
        , m_result(result)
    {
    }

    // line := [ camera | object | fractal | physics | light ] [comment]
    void parse()
    {
        const Token first = peek();
        if (first.is(TokenKind::EndOfLine) || first.is(TokenKind::Hash)) {
            return;
        }
        parseDeclaration(first);
        m_result.range = inLine({first.range.begin, std::max(first.range.end, lastEnd())});
    }

private:
    bool parseDeclaration(const Token &letter)
    {
        if (letter.text == "c") {
            return parseCamera(begin<CameraLine>());
        }
        if (letter.text == "o") {
            return parseObject(begin<ObjectLine>());
        }
        if (letter.text == "f") {
            return parseFractal(begin<FractalLine>());
        }
        if (letter.text == "p") {
            return parsePhysics(begin<BallLine>());
        }
        if (letter.text == "l") {
            return parseLight(begin<LightLine>());
        }
        return error(DiagnosticCode::ExpectedSceneLine, letter.range, {described(letter)}, meantLetter(letter));
    }

    template<typename Node>
    Node &begin()
    {
        m_letter = take();
        return m_result.declaration.emplace<Node>();
    }

    /// `C`, or `camera` for `c`.
    static std::optional<Fix> meantLetter(const Token &token)
    {
        const std::string word = lowered(token.text);
        for (const std::string_view name : {"camera", "object", "fractal", "physics", "light"}) {
            const std::string letter(name.substr(0, 1));
            if (word == name || word == letter) {
                return replacement(std::format("Write {}", letter), token.range, letter);
            }
        }
        return std::nullopt;
    }

    // ---- Declarations

    // camera := "c" vec vec number [ "perspective" | "orthographic" ]
    bool parseCamera(CameraLine &camera)
    {
        if (!parseVector(camera.position, positionWords) || !parseVector(camera.rotation, rotationWords)
            || !parseMeasure(camera.view, "a field of view in degrees") || !parseProjection(camera)
            || !checkView(camera) || !parseEnd()) {
            return false;
        }
        doubtAngles(camera.rotation);
        return true;
    }

    bool parseProjection(CameraLine &camera)
    {
        const Token token = peek();
        if (!token.is(TokenKind::Name)) {
            return true;
        }
        if (token.text != "perspective" && token.text != "orthographic") {
            return expected("perspective, orthographic or the end of the line", token, meantProjection(token));
        }
        take();
        camera.projection = inLine(token.range);
        camera.isOrthographic = token.text == "orthographic";
        return true;
    }

    /// Words that start alike are taken for misspelt ones, others for a comment.
    static Fix meantProjection(const Token &token)
    {
        const std::string word = lowered(token.text);
        for (const char *const projection : {"perspective", "orthographic"}) {
            if (word.size() >= 4 && word[0] == projection[0]) {
                return replacement(std::format("Write {}", projection), token.range, projection);
            }
        }
        return insertion("Make it a comment", token.range.begin, "# ");
    }

    bool checkView(const CameraLine &camera)
    {
        const double view = camera.view.value;
        if (camera.isOrthographic) {
            return view > 0.0 || errorAt(DiagnosticCode::HeightNotPositive, camera.view.range);
        }
        return (view > 0.0 && view < 180.0) || errorAt(DiagnosticCode::FieldOfViewOutside, camera.view.range);
    }

    /// Angles beyond a full turn are probably meant in degrees.
    void doubtAngles(const VectorExpression &rotation)
    {
        for (int i = 0; i < 3; ++i) {
            if (std::abs(rotation.value[i]) > 2.0 * std::numbers::pi) {
                error(DiagnosticCode::AngleInDegrees, from(rotation.range), {text(from(rotation.numbers[i]))},
                      radians(rotation));
                return;
            }
        }
    }

    static Fix radians(const VectorExpression &rotation)
    {
        Fix fix{"Convert from degrees", {}};
        for (int i = 0; i < 3; ++i) {
            // several turns become one, or there would be a warning still
            const double degrees = rotation.value[i];
            const double reduced = std::abs(degrees) > 360.0 ? std::remainder(degrees, 360.0) : degrees;
            if (degrees != 0.0) {
                fix.edits.push_back({from(rotation.numbers[i]), shortest(reduced * (std::numbers::pi / 180.0))});
            }
        }
        return fix;
    }

    // object := "o" STRING(.obj) transform
    bool parseObject(ObjectLine &object)
    {
        return parsePath(object.file) && checkMesh(object.file) && parseTransform(object.file.transform)
            && parseFileEnd();
    }

    // fractal := "f" STRING(.fdo) transform
    bool parseFractal(FractalLine &fractal)
    {
        return parsePath(fractal.file) && checkFractal(fractal.file) && parseTransform(fractal.file.transform)
            && parseFileEnd();
    }

    // physics := "p" STRING(.obj) transform number [vec]
    bool parsePhysics(BallLine &ball)
    {
        if (!parsePath(ball.file) || !checkMesh(ball.file) || !parseTransform(ball.file.transform)
            || !parseMeasure(ball.restitution, "a coefficient of restitution (0 to 1)")) {
            return false;
        }
        if (!(ball.restitution.value >= 0.0 && ball.restitution.value <= 1.0)) {
            return errorAt(DiagnosticCode::RestitutionOutside, ball.restitution.range);
        }
        // a # is a comment here
        if (peek().is(TokenKind::OpenParenthesis) || peek().is(TokenKind::Number)) {
            return parseVector(ball.velocity.emplace(), "a velocity in parentheses") && parseEnd();
        }
        return parseEnd();
    }

    // light := "l" vec vec
    bool parseLight(LightLine &light)
    {
        if (!parseVector(light.position, positionWords) || !parseVector(light.colour, "a colour in parentheses or #")) {
            return false;
        }
        for (int i = 0; i < 3; ++i) {
            if (light.colour.value[i] < 0.0) {
                return errorAt(DiagnosticCode::NegativeColour, light.colour.numbers[i]);
            }
        }
        return parseEnd();
    }

    // ---- Files

    bool parsePath(PlacedFile &file)
    {
        SourceRange quoted;
        const bool isGood = parseString(quoted);
        file.path = inLine(quoted);
        return isGood;
    }

    bool checkMesh(const PlacedFile &file)
    {
        const std::string path = pathOf(file);
        if (m_letter.text == "o" && hasEnding(path, ".fdo")) {
            return wrongLetter(file, "a fractal", "f");
        }
        return hasEnding(path, ".obj") || error(DiagnosticCode::NotAMeshPath, from(file.path), {path});
    }

    bool checkFractal(const PlacedFile &file)
    {
        const std::string path = pathOf(file);
        if (hasEnding(path, ".obj")) {
            return wrongLetter(file, "a mesh", "o");
        }
        return hasEnding(path, ".fdo") || error(DiagnosticCode::NotAFractalPath, from(file.path), {path});
    }

    bool wrongLetter(const PlacedFile &file, const char *what, const char *letter)
    {
        return error(DiagnosticCode::WrongLetter, m_letter.range,
                     {pathOf(file), what, letter, std::string(m_letter.text)},
                     replacement(std::format("Write {}", letter), m_letter.range, letter));
    }

    [[nodiscard]] std::string pathOf(const PlacedFile &file) const
    {
        return std::string(unquoted(text(from(file.path))));
    }

    /// Of what is no ball: a number, and a velocity after it, was meant for p.
    bool parseFileEnd()
    {
        const Token token = peek();
        if (!token.is(TokenKind::Number)) {
            return parseEnd();
        }
        // words after # are a comment that lacks its own #
        const std::size_t begin = lastEnd();
        LineLexer ahead = lexer();
        SourceRange all = ahead.take().range;
        if (ahead.peek().is(TokenKind::OpenParenthesis)) {
            Token inside = ahead.take();
            while (!inside.is(TokenKind::EndOfLine) && !inside.is(TokenKind::CloseParenthesis)) {
                inside = ahead.take();
            }
            all = joined(all, inside.range);
        }
        if (!ahead.peek().is(TokenKind::EndOfLine) && !ahead.peek().is(TokenKind::Hash)) {
            return parseEnd();
        }
        return error(DiagnosticCode::RestitutionBelongsToBall, token.range,
                     {std::string(token.text), std::string(m_letter.text)},
                     replacement("Remove it", {begin, all.end}, ""));
    }

    // ---- Numbers, vectors, transformations

    /// A vector or a transformation that is being read, which can be put right as a whole.
    struct Whole {
        LineLexer start;
        std::optional<Fix> (*repaired)(LineLexer);
        [[nodiscard]] std::optional<Fix> fix() const { return repaired(start); }
    };

    // transform := "(" vec "," vec "," vec ")" | "#"
    bool parseTransform(TransformExpression &transform)
    {
        const Whole whole{lexer(), repairedTransform};
        const Token first = peek();
        transform.range = inLine(first.range);
        if (first.is(TokenKind::Hash)) {
            take();
            transform.isIdentity = true;
            return true;
        }
        if (!first.is(TokenKind::OpenParenthesis)) {
            return missingIdentity("a transformation in parentheses or #", whole);
        }
        take();
        const bool isGood = parsePart(transform.position, positionWords, whole) && takeComma(whole)
            && parsePart(transform.rotation, rotationWords, whole) && takeComma(whole)
            && parsePart(transform.scale, "a scale in parentheses or #", whole) && takeClosing(whole);
        transform.range.end = inLine({0, lastEnd()}).end;
        return isGood;
    }

    bool parseVector(VectorExpression &vector, const char *what)
    {
        return parsePart(vector, what, {lexer(), repairedVector});
    }

    // vec := "(" number "," number "," number ")" | "#"
    bool parsePart(VectorExpression &vector, const char *what, const Whole &whole)
    {
        const Token first = peek();
        vector.range = inLine(first.range);
        if (first.is(TokenKind::Hash)) {
            take();
            vector.isIdentity = true;
            return true;
        }
        if (!first.is(TokenKind::OpenParenthesis)) {
            return missingIdentity(what, whole);
        }
        const LineLexer start = lexer();
        take();
        const bool isGood = parseNumbers(vector, start, whole) && takeClosing(whole);
        vector.range.end = inLine({0, lastEnd()}).end;
        return isGood;
    }

    bool parseNumbers(VectorExpression &vector, const LineLexer &start, const Whole &whole)
    {
        for (int i = 0; i < 3; ++i) {
            if (i > 0 && peek().is(TokenKind::Number) && !checkDecimalCommas(decimalCommasInVector(start))) {
                return false;
            }
            if (i > 0 && !takeComma(whole)) {
                return false;
            }
            vector.numbers[i] = inLine(peek().range);
            if (!parseNumber(vector.value[i])) {
                return false;
            }
        }
        return !peek().is(TokenKind::Comma) || checkDecimalCommas(decimalCommasInVector(start));
    }

    /// A number that stands alone.
    bool parseMeasure(NumberExpression &number, const char *what)
    {
        const LineLexer start = lexer();
        number.range = inLine(peek().range);
        return parseNumber(number.value, what)
            && (!peek().is(TokenKind::Comma) || checkDecimalCommas(decimalCommaInNumber(start)));
    }

    bool checkDecimalCommas(std::optional<DecimalCommas> commas)
    {
        return !commas || error(DiagnosticCode::DecimalComma, commas->range, {commas->number}, std::move(commas->fix));
    }

    bool takeComma(const Whole &whole)
    {
        if (!peek().is(TokenKind::Comma)) {
            return expected("\",\"", peek(), whole.fix());
        }
        take();
        return true;
    }

    bool takeClosing(const Whole &whole)
    {
        if (!peek().is(TokenKind::CloseParenthesis)) {
            return expected("\")\"", peek(), whole.fix());
        }
        take();
        return true;
    }

    /// Where a value is required: brackets may be missing, a comma be one too many, or the value not be there at all.
    bool missingIdentity(const char *what, const Whole &whole)
    {
        const Token token = peek();
        const bool isInside = token.range.begin > whole.start.peek().range.begin;
        std::optional<Fix> fix = whole.fix();
        if (fix) {
            return expected(what, token, std::move(fix));
        }
        if (token.is(TokenKind::Comma) && !isInside) {
            fix = replacement("Remove the comma", token.range, "");
        } else if (token.is(TokenKind::Comma)
                   || (!isInside
                       && (token.is(TokenKind::EndOfLine) || token.is(TokenKind::Name)
                           || token.is(TokenKind::Number)))) {
            fix = insertion("Insert #", lastEnd(), " #");
        }
        return expected(what, token, std::move(fix));
    }

    // ---- Places

    /// The line starts at 0.
    static SourceRange from(LineRange range) { return range.from(0); }

    bool errorAt(DiagnosticCode code, LineRange number) { return error(code, from(number), {text(from(number))}); }

    SdoLine &m_result;
    Token m_letter;
};

}

SdoLine parseSdoLine(std::string_view line, std::size_t skipped)
{
    SdoLine result;
    SdoLineParser(line, skipped, result).parse();
    result.isBad = hasErrors(result.diagnostics);
    return result;
}

}
