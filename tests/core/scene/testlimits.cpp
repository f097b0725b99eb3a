// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include <atomic>
#include <functional>
#include <string>

#include <QTest>

#include <pthread.h>

#include "core/formats/objreader.h"
#include "core/scene/sceneloader.h"
#include "core/scene/summary.h"
#include "core/text/linemap.h"
#include "core/text/places.h"
#include "tests/core/scene/tablefiles.h"
#include "tests/testmain.h"

namespace romanesco::test {

namespace {

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr std::size_t stackBytes = 1024 * 1024; // their frames are many times larger
#else
constexpr std::size_t stackBytes = 64 * 1024;
#endif

/// In a thread with a small stack: what recurses on what a file says does not come back.
void onSmallStack(std::function<void()> work)
{
    pthread_attr_t attributes;
    pthread_attr_init(&attributes);
    QCOMPARE(pthread_attr_setstacksize(&attributes, stackBytes), 0);
    pthread_t thread;
    const auto run = [](void *function) -> void * {
        (*static_cast<std::function<void()> *>(function))();
        return nullptr;
    };
    QCOMPARE(pthread_create(&thread, &attributes, run, &work), 0);
    pthread_join(thread, nullptr);
    pthread_attr_destroy(&attributes);
}

std::string repeated(std::string_view part, std::size_t count)
{
    std::string all;
    all.reserve(part.size() * count);
    for (std::size_t i = 0; i < count; ++i) {
        all += part;
    }
    return all;
}

const std::string start = "v 1 2 3\nhalf 0.5 0.5 0.5\nt.p. (p, #, half)\nx. \"x.obj\"\n";

std::string number(int i)
{
    return std::to_string(i);
}

}

/// Texts of every wasteful shape. Each has to end, on a stack of 64 KB; the test's time limit is the only clock.
class TestLimits : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void texts_data();
    void texts();
    void summariesOfWideAndDeepTexts_data();
    void summariesOfWideAndDeepTexts();
    void meshes_data();
    void meshes();
};

void TestLimits::texts_data()
{
    QTest::addColumn<std::string>("text");
    QTest::addColumn<bool>("isScene");
    const auto row = [](const char *name, const std::string &text, bool isScene) {
        QTest::newRow(name) << text << isScene;
    };
    const int many = 10'000;

    std::string chain = start + "y0. [t.1] x\n";
    for (int i = 1; i < many; ++i) {
        chain += "y" + number(i) + ". [#, t.1] y" + number(i - 1) + "\n";
    }
    row("chained sets", chain + "<$>. y9999", true);

    std::string different = start + "y0. [t.1] x\n";
    for (int i = 1; i < many; ++i) {
        different +=
            "v " + number(i) + " 0 0\ny" + number(i) + ". [#, t." + number(i + 2) + "] y" + number(i - 1) + "\n";
    }
    row("chained sets that differ", different + "<$>. y9999", true);

    std::string copies = start + "y0. x\n";
    for (int i = 1; i < many; ++i) {
        copies += "y" + number(i) + ". y" + number(i - 1) + "\n";
    }
    row("chained copies", copies + "<$>. y9999", true);

    std::string nested = start + "w0<x>. [t.1] x\n";
    for (int i = 1; i < many; ++i) {
        nested += "w" + number(i) + "<x>. [t.1] w" + number(i - 1) + " 1\n";
    }
    row("recursives in recursives, once each", nested + "<$>. w9999 1", true);
    row("and at a great depth", nested + "<$>. w9999 100000000000", true);

    std::string doubling = start + "w0<x>. [#, t.1] x\n";
    for (int i = 1; i < 61; ++i) {
        doubling += "w" + number(i) + "<x>. [t.half] w" + number(i - 1) + " 2\n";
    }
    row("recursives in recursives, twice each", doubling + "<$>. w60 2", true);

    std::string row1 = start + "y0. x\n";
    for (int i = 1; i < many; ++i) {
        const std::string above = "y" + number(i - 1);
        row1 += "z" + number(i) + "<" + above + ">. [t.1] " + above + "\ny" + number(i) + ". z" + number(i) + " 3\n";
    }
    row("recursives one after another", row1 + "<$>. y9999", true);

    std::string unreached = start + "y0. [t.1] x\nother. x\n";
    for (int i = 1; i < many; ++i) {
        unreached +=
            "y" + number(i) + ". [t.1] y" + number(i - 1) + "\nr" + number(i) + "<other>. y" + number(i) + "\n";
    }
    row("bases that are not reached", unreached + "<$>. y9999", false);

    row("100,000 sets in one value", start + "<$>. " + repeated("[t.1]", 100'000) + " x", true);
    row("200,000 equal maps", start + "<$>. [" + repeated("t.1, ", 200'000) + "#] x", true);

    std::string wide = start + "u.a.b. (a, b, half)\n";
    for (int i = 0; i < 450; ++i) {
        wide += "v " + number(i) + " 0 " + number(i % 7) + "\n";
    }
    wide += "z<x>. [#";
    for (int i = 0; i < 200'000; ++i) {
        wide += ", u." + number(3 + i / 450) + "." + number(3 + i % 450);
    }
    wide += "] x\n<$>. z ";
    row("200,000 maps in a set", wide + "1", true);
    row("200,000 maps in a set, deep", wide + "1000000", true);

    row("a number of a megabyte", start + "v 1 2 0." + std::string(1'000'000, '3') + "\n<$>. x", true);
    row("a bad number of a megabyte", start + "v 1 2 0." + std::string(1'000'000, '3') + "x\n<$>. x", false);
    row("a name of a megabyte", start + std::string(1'000'000, 'n') + ". x\n<$>. " + std::string(1'000'000, 'n'), true);
    row("a path of a megabyte", "<$>. \"" + std::string(1'000'000, 'p') + ".obj\"", false);
    row("blanks of a megabyte", start + "<$>. " + std::string(1'000'000, ' ') + "x", true);
    row("brackets of a megabyte", start + "<$>. " + std::string(1'000'000, '['), false);
    row("quotes of a megabyte", start + "<$>. " + std::string(1'000'001, '"'), false);
    row("dots of a megabyte", start + "<$>. [t" + std::string(1'000'000, '.') + "] x", false);
    row("an index of a megabyte", start + "<$>. [t." + std::string(1'000'000, '9') + "] x", false);
    row("a depth of a megabyte", start + "z<x>. [t.1] x\n<$>. z " + std::string(1'000'000, '0') + "7", true);
    row("bytes that are no UTF-8", start + "<$>. " + std::string(1'000'000, '\xFF'), false);
    row("a comment of 50 MB", start + "# " + std::string(50'000'000, 'c') + "\n<$>. x", true);
    row("5,000,000 empty lines", start + std::string(5'000'000, '\n') + "<$>. x", true);
    row("200,000 bad lines", start + repeated("w [\n", 200'000) + "<$>. x", false);
    row("200,000 vectors", start + repeated("v 1 2 3\n", 200'000) + "<$>. x", true);
    row("200,000 declarations of one name", start + repeated("x. \"x.obj\"\n", 200'000) + "<$>. x", false);
    row("200,000 results", start + repeated("<$>. x\n", 200'000), false);
    row("carriage returns", start + std::string(1'000'000, '\r') + "<$>. x", true);
}

void TestLimits::texts()
{
    QFETCH(std::string, text);
    QFETCH(bool, isScene);
    const TableFiles files({{"x.obj", triangleObj}});
    SceneResult result;
    std::size_t length = 0;
    onSmallStack([&] {
        SceneLoader loader(files);
        result = loader.load("a.fdo", text);
        const LineMap lines(text);
        Places places(lines);
        for (std::size_t i = 0; i < std::min<std::size_t>(result.diagnostics.size(), 100); ++i) {
            length = std::max(length, toLines(result.diagnostics[i], "a.fdo", places).size());
        }
    });
    QCOMPARE(result.scene != nullptr, isScene);
    QCOMPARE(hasErrors(result.diagnostics), !isScene);
    QVERIFY(length < 2'000); // a message can be read
}

void TestLimits::summariesOfWideAndDeepTexts_data()
{
    texts_data();
}

void TestLimits::summariesOfWideAndDeepTexts()
{
    QFETCH(std::string, text);
    QFETCH(bool, isScene);
    if (!isScene) {
        return;
    }
    const TableFiles files({{"x.obj", triangleObj}});
    bool isSummed = false;
    onSmallStack([&] {
        SceneLoader loader(files);
        const auto scene = loader.load("a.fdo", text).scene;
        isSummed = scene && !summarise(*scene).instancesAsWritten.isZero();
    });
    QVERIFY(isSummed);
}

void TestLimits::meshes_data()
{
    QTest::addColumn<std::string>("text");
    QTest::addColumn<bool>("isMesh");
    const auto row = [](const char *name, const std::string &text, bool isMesh) {
        QTest::newRow(name) << text << isMesh;
    };
    row("a line of a megabyte", triangleObj + "# " + std::string(1'000'000, 'c'), true);
    row("a face of 300,000 corners", triangleObj + "f" + repeated(" 1 2 3", 100'000), true);
    row("300,000 lines that go on", triangleObj + "f" + repeated(" 1 2 3 \\\n", 100'000) + " 1", true);
    row("a word of a megabyte", triangleObj + "v 1 2 " + std::string(1'000'000, 'x'), false);
    row("blanks of a megabyte", triangleObj + "f 1 2" + std::string(1'000'000, ' ') + "3", true);
    row("backslashes", triangleObj + "f 1 2 3 " + std::string(1'000'000, '\\'), false);
    row("200,000 faces", triangleObj + repeated("f 1 2 3\n", 200'000), true);
}

void TestLimits::meshes()
{
    QFETCH(std::string, text);
    QFETCH(bool, isMesh);
    std::atomic<bool> isRead = false;
    onSmallStack([&] {
        const ObjResult result = readObj(text);
        isRead = !hasErrors(result.diagnostics) && !boundingSphere(result.mesh).isEmpty();
    });
    QCOMPARE(isRead.load(), isMesh);
}

}

ROMANESCO_TEST(romanesco::test::TestLimits)

#include "testlimits.moc"
