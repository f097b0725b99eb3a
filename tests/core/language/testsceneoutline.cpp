// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include <format>

#include <QTest>

#include "core/language/sceneoutline.h"
#include "tests/testmain.h"

namespace romanesco::test {

namespace {

const std::string sample = "\xEF\xBB\xBF# o \"first.obj\" #\r\n"
                           "c (0, 1, -5) # 40\r\n"
                           "  f \"größe.fdo\" #   # a fractal\r\n"
                           "#o \"near.obj\" ((0, 1, 0), #, #) # a mesh\r\n"
                           "# o \"bad.obj\"\r\n"
                           "# o is a mesh\r\n"
                           "p \"ball.obj\" # 0.5\r\n"
                           "x\r\n"
                           "l (4, 6, -3) #";

std::string described(const SdoSyntax &syntax)
{
    std::string all;
    for (const SceneEntry &entry : outline(syntax)) {
        const std::string word = syntax.text().substr(entry.range.begin, entry.range.length());
        all +=
            std::format("{}{}{} {}; ", entry.line + 1, entry.isShown ? "+" : "-", static_cast<int>(entry.kind), word);
    }
    return all;
}

}

/// What a scene places, also where it is hidden in comments.
class TestSceneOutline : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void whatIsPlacedIsListed();
    void hidingAndShowingMakesComments();
    void whatPlacesNothingStays();
};

void TestSceneOutline::whatIsPlacedIsListed()
{
    QCOMPARE(described(SdoSyntax(sample)),
             std::string("1-1 \"first.obj\"; 2+0 c; 3+2 \"größe.fdo\"; 4-1 \"near.obj\"; 7+3 \"ball.obj\"; 9+4 l; "));
}

void TestSceneOutline::hidingAndShowingMakesComments()
{
    SdoSyntax syntax(sample);
    for (const std::size_t line : {0, 2, 3, 6}) {
        const bool isShown = syntax.line(line).file() != nullptr;
        QVERIFY(withVisibility(syntax, line, isShown).empty());
        const TextEdits edits = withVisibility(syntax, line, !isShown);
        QCOMPARE(edits.size(), std::size_t{1});
        const SdoSyntax changed(applied(syntax.text(), edits));
        QCOMPARE(changed.line(line).file() != nullptr, !isShown);
        QCOMPARE(outline(changed).size(), outline(syntax).size());
        const SdoSyntax back(applied(changed.text(), withVisibility(changed, line, isShown)));
        // A mark without a blank comes back with one.
        QCOMPARE(described(back).size(), described(syntax).size());
        if (isShown) {
            QCOMPARE(back.text(), syntax.text());
        }
    }
}

void TestSceneOutline::whatPlacesNothingStays()
{
    const SdoSyntax syntax(sample);
    for (const std::size_t line : {1, 4, 5, 7, 8, 9, 1'000}) {
        QVERIFY(withVisibility(syntax, line, false).empty());
        QVERIFY(withVisibility(syntax, line, true).empty());
    }
    QVERIFY(outline(SdoSyntax()).empty());
}

}

ROMANESCO_TEST(romanesco::test::TestSceneOutline)
#include "testsceneoutline.moc"
