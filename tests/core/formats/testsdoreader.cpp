// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "core/formats/sdoreader.h"

#include <clocale>
#include <cmath>
#include <limits>
#include <locale>
#include <string>

#include <QFile>
#include <QTest>
#include <glm/geometric.hpp>

#include "core/text/linemap.h"
#include "tests/sourcetree.h"
#include "tests/testmain.h"

namespace romanesco::test {

namespace {

using Kind = SceneDescription::Kind;

const double pi = std::acos(-1.0);

std::string words(const std::string &text, SourceRange range)
{
    return text.substr(range.begin, range.length());
}

std::string words(const std::string &line, LineRange range)
{
    return words(line, range.from(0));
}

QList<double> numbers(const glm::dvec3 &vector)
{
    return {vector.x, vector.y, vector.z};
}

std::string appendixA()
{
    QFile file(test::sourcePath("tests/golden/diagnostics/appendix-a.sdo"));
    return file.open(QIODevice::ReadOnly) ? file.readAll().toStdString() : std::string();
}

/// pitch·yaw·roll by radians, from the definition of the rotation; columns are right, up, forward.
glm::dmat3 rotation(const glm::dvec3 &angles)
{
    const auto rows = [](const glm::dvec3 &a, const glm::dvec3 &b, const glm::dvec3 &c) {
        return glm::transpose(glm::dmat3(a, b, c));
    };
    const glm::dvec3 c(std::cos(angles.x), std::cos(angles.y), std::cos(angles.z));
    const glm::dvec3 s(std::sin(angles.x), std::sin(angles.y), std::sin(angles.z));
    const glm::dmat3 pitch = rows({1, 0, 0}, {0, c.x, s.x}, {0, -s.x, c.x});
    const glm::dmat3 yaw = rows({c.y, 0, -s.y}, {0, 1, 0}, {s.y, 0, c.y});
    const glm::dmat3 roll = rows({c.z, s.z, 0}, {-s.z, c.z, 0}, {0, 0, 1});
    return pitch * yaw * roll;
}

}

class TestSdoReader : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void appendixAIsRead();
    void theCameraOfAppendixALooksAtTheScene();
    void camerasSayWhatIsLookedAt_data();
    void camerasSayWhatIsLookedAt();
    void transformationsBecomeMaps_data();
    void transformationsBecomeMaps();
    void itemsKeepTheirOrderAndPlaces();
    void ballsAndLights();
    void linesKeepTheirRanges();
    void numbersHaveManySpellings_data();
    void numbersHaveManySpellings();
    void aFullTurnIsNotDoubted_data();
    void aFullTurnIsNotDoubted();
    void encodingsAndLineEnds_data();
    void encodingsAndLineEnds();
    void everyLocaleReadsAlike();
    void anErrorLeavesNoScene();
    void anEmptyTextIsAnEmptyScene();
    void longLinesAndManyLines();
};

void TestSdoReader::appendixAIsRead()
{
    const std::string text = appendixA();
    const SdoResult result = readSdo(text);
    QVERIFY(result.diagnostics.empty());
    const SceneDescription &scene = result.description.value();
    QCOMPARE(numbers(scene.camera.value().position), (QList<double>{-48.761894, 25.567242, 64.429054}));
    QCOMPARE(numbers(scene.camera->rotation), (QList<double>{-0.071402885, -2.4999454, 0}));
    QCOMPARE(scene.camera->view, 60.0);
    QVERIFY(!scene.camera->isOrthographic);
    QCOMPARE(words(text, scene.camera->range), "c (-48.761894, 25.567242, 64.429054) (-0.071402885, -2.4999454, 0) 60");
    QCOMPARE(scene.items.size(), 2u);
    QCOMPARE(scene.items[0].path, "SampleAsset1.obj");
    QCOMPARE(numbers(scene.items[0].worldFromModel.translation), (QList<double>{1, 1, 1}));
    const glm::dmat3 turned = rotation({pi / 2, 0, pi / 6});
    for (int i = 0; i < 3; ++i) {
        QVERIFY(glm::length(scene.items[0].worldFromModel.linear[i] - turned[i]) < 1e-15);
    }
    QCOMPARE(scene.items[1].path, "SampleAsset2.obj");
    QVERIFY(scene.items[1].worldFromModel == AffineMap{});
    QVERIFY(scene.lights.empty());
}

/// The origin is 20.8° off the axis, at (-0.02, -0.38) of ±0.577: which only one reading of the angles gives.
void TestSdoReader::theCameraOfAppendixALooksAtTheScene()
{
    const SceneDescription scene = readSdo(appendixA()).description.value();
    const glm::dmat3 worldFromCamera = rotation(scene.camera->rotation);
    const glm::dvec3 origin = glm::transpose(worldFromCamera) * -scene.camera->position;
    QCOMPARE(std::round(std::acos(origin.z / glm::length(origin)) * 180.0 / pi * 10.0), 208.0);
    QCOMPARE(std::round(origin.x / origin.z * 100.0), -2.0);
    QCOMPARE(std::round(origin.y / origin.z * 100.0), -38.0);
    const double half = std::tan(scene.camera->view / 2.0 * pi / 180.0);
    QCOMPARE(std::round(half * 1000.0), 577.0);
}

void TestSdoReader::camerasSayWhatIsLookedAt_data()
{
    QTest::addColumn<QString>("line");
    QTest::addColumn<QList<double>>("position");
    QTest::addColumn<QList<double>>("rotation");
    QTest::addColumn<double>("view");
    QTest::addColumn<bool>("isOrthographic");
    const QList<double> zero = {0, 0, 0};
    QTest::newRow("identities") << "c # # 60" << zero << zero << 60.0 << false;
    QTest::newRow("perspective") << "c (1, 2, 3) # 0.001 perspective" << QList<double>{1, 2, 3} << zero << 0.001
                                 << false;
    QTest::newRow("orthographic") << "c # (1, -2, 3) 180 orthographic # far" << zero << QList<double>{1, -2, 3} << 180.0
                                  << true;
    QTest::newRow("no blanks") << "c(1,2,3)(1,2,3)60orthographic" << QList<double>{} << QList<double>{} << 0.0 << false;
    QTest::newRow("few blanks") << "c(1,2,3)#179.9#" << QList<double>{1, 2, 3} << zero << 179.9 << false;
}

void TestSdoReader::camerasSayWhatIsLookedAt()
{
    QFETCH(QString, line);
    QFETCH(QList<double>, position);
    QFETCH(double, view);
    const SdoResult result = readSdo(line.toStdString());
    QCOMPARE(result.description.has_value(), !position.isEmpty()); // else a number runs into a word
    if (!result.description) {
        return;
    }
    const SceneDescription::Camera &camera = result.description->camera.value();
    QCOMPARE(numbers(camera.position), position);
    QTEST(numbers(camera.rotation), "rotation");
    QCOMPARE(camera.view, view);
    QTEST(camera.isOrthographic, "isOrthographic");
}

void TestSdoReader::transformationsBecomeMaps_data()
{
    QTest::addColumn<QString>("transform");
    QTest::addColumn<QList<double>>("image"); // of (1, 10, 100)
    const auto row = [](const char *transform, const QList<double> &image) {
        QTest::newRow(transform) << QString::fromLatin1(transform) << image;
    };
    row("#", {1, 10, 100});
    row("(#, #, #)", {1, 10, 100});
    row("((1, 2, 3), #, #)", {2, 12, 103});
    row("(#, #, (2, 3, 4))", {2, 30, 400});
    row("(#, #, (0, -3, 0))", {0, -30, 0});
    row("(#, (90, 0, 0), #)", {1, 100, -10}); // pitch: (x, y, z) to (x, z, -y)
    row("(#, (0, 90, 0), #)", {-100, 10, 1}); // yaw: to (-z, y, x)
    row("(#, (0, 0, 90), #)", {10, -1, 100}); // roll: to (y, -x, z)
    row("(#, (90, 90, 0), #)", {-100, 1, -10});
    row("(#, (0, 90, 90), #)", {-100, -1, 10});
    row("(#, (36000090, 0, 0), #)", {1, 100, -10});
    row("((1, 2, 3), (90, 0, 0), (2, 3, 4))", {3, 402, -27}); // scaled first, then turned, then moved
    row("( ( 1 ,2, 3 ),#,# )", {2, 12, 103});
}

void TestSdoReader::transformationsBecomeMaps()
{
    QFETCH(QString, transform);
    const auto line = [&](const char *start, const char *end) { return start + transform.toStdString() + end + '\n'; };
    const SdoResult result = readSdo(line("o \"x.obj\" ", "") + line("f \"x.fdo\" ", "") + line("p \"x.obj\" ", " 1"));
    QVERIFY(result.description.has_value());
    for (const SceneDescription::Item &item : result.description->items) {
        QTEST(numbers(item.worldFromModel({1, 10, 100})), "image");
    }
}

void TestSdoReader::itemsKeepTheirOrderAndPlaces()
{
    const std::string text = "f \"some folder/ü #1.FDO\" # # ü\np \"b.obj\" # 1\n\no \"../a.Obj\" #\nf \"c.fdo\" #";
    const SdoResult result = readSdo(text);
    QVERIFY(result.diagnostics.empty());
    const std::vector<SceneDescription::Item> &items = result.description->items;
    const std::vector<std::pair<Kind, std::string>> expected = {{Kind::Fractal, "some folder/ü #1.FDO"},
                                                                {Kind::Ball, "b.obj"},
                                                                {Kind::Object, "../a.Obj"},
                                                                {Kind::Fractal, "c.fdo"}};
    QCOMPARE(items.size(), expected.size());
    for (std::size_t i = 0; i < items.size(); ++i) {
        QVERIFY(items[i].kind == expected[i].first);
        QCOMPARE(items[i].path, expected[i].second);
        QCOMPARE(words(text, items[i].pathRange), '"' + items[i].path + '"');
    }
}

void TestSdoReader::ballsAndLights()
{
    const SdoResult result = readSdo("p \"b.obj\" ((0, 9, 0), #, #) 0.6 (1, -2, .5)\n"
                                     "p \"b.obj\" # 0 # (1, 0, 0)\n"
                                     "l (20, 40, -10) (1, 0.95, 90)\nl # #\nl (1, 2, 3) # # white\n");
    QVERIFY(result.diagnostics.empty());
    const auto &[camera, items, lights] = *result.description;
    QVERIFY(!camera.has_value());
    QCOMPARE(items.size(), 2u);
    QCOMPARE(items[0].restitution, 0.6);
    QCOMPARE(numbers(items[0].velocity), (QList<double>{1, -2, 0.5}));
    QCOMPARE(items[1].restitution, 0.0);
    QCOMPARE(numbers(items[1].velocity), (QList<double>{0, 0, 0}));
    QCOMPARE(lights.size(), 3u);
    QCOMPARE(numbers(lights[0].position), (QList<double>{20, 40, -10}));
    QCOMPARE(numbers(lights[0].colour), (QList<double>{1, 0.95, 90}));
    QCOMPARE(numbers(lights[1].position), (QList<double>{0, 0, 0}));
    QCOMPARE(numbers(lights[1].colour), (QList<double>{1, 1, 1}));
    QCOMPARE(numbers(lights[2].colour), (QList<double>{1, 1, 1}));
}

void TestSdoReader::linesKeepTheirRanges()
{
    const std::string ball = "  p \"b.obj\" ((0, 9, +1e1), #, ( 2,3 ,4 )) .5 (1, 0, 0) # a note";
    const SdoLine line = parseSdoLine(ball, 0);
    const auto &node = std::get<BallLine>(line.declaration);
    const TransformExpression &transform = node.file.transform;
    QCOMPARE(line.file(), &node.file);
    QCOMPARE(words(ball, line.range), "p \"b.obj\" ((0, 9, +1e1), #, ( 2,3 ,4 )) .5 (1, 0, 0)");
    QCOMPARE(words(ball, node.file.path), "\"b.obj\"");
    QCOMPARE(words(ball, transform.range), "((0, 9, +1e1), #, ( 2,3 ,4 ))");
    QCOMPARE(words(ball, transform.position.range), "(0, 9, +1e1)");
    QCOMPARE(words(ball, transform.position.numbers[2]), "+1e1");
    QVERIFY(!transform.position.isIdentity && transform.rotation.isIdentity);
    QCOMPARE(words(ball, transform.rotation.range), "#");
    QCOMPARE(words(ball, transform.scale.range), "( 2,3 ,4 )");
    QCOMPARE(words(ball, transform.scale.numbers[1]), "3");
    QCOMPARE(words(ball, node.restitution.range), ".5");
    QCOMPARE(words(ball, node.velocity.value().range), "(1, 0, 0)");

    const std::string camera = "\xEF\xBB\xBF"
                               "c # (0, 1, 2) 60 perspective#";
    const SdoLine marked = parseSdoLine(camera, 3);
    const auto &view = std::get<CameraLine>(marked.declaration);
    QCOMPARE(words(camera, marked.range), "c # (0, 1, 2) 60 perspective");
    QCOMPARE(words(camera, view.position.range), "#");
    QCOMPARE(words(camera, view.rotation.numbers[0]), "0");
    QCOMPARE(words(camera, view.view.range), "60");
    QCOMPARE(words(camera, view.projection), "perspective");
    QVERIFY(!marked.file());

    const std::string bad = "o \"a.obj\" ((1, 2, 3), #, x";
    const SdoLine partial = parseSdoLine(bad, 0);
    QVERIFY(partial.isBad);
    QCOMPARE(words(bad, partial.file()->path), "\"a.obj\"");
    QCOMPARE(words(bad, partial.file()->transform.position.range), "(1, 2, 3)");
}

void TestSdoReader::numbersHaveManySpellings_data()
{
    QTest::addColumn<double>("value"); // nan: no number
    const double none = std::numeric_limits<double>::quiet_NaN();
    const auto row = [](const char *spelling, double value) { QTest::newRow(spelling) << value; };
    row("1", 1);
    row("+1", 1);
    row("-1", -1);
    row("01", 1);
    row(".5", 0.5);
    row("-.5", -0.5);
    row("5.", 5);
    row("1.25", 1.25);
    row("1e3", 1000);
    row("1E+3", 1000);
    row("1.e-3", 0.001);
    row(".5e1", 5);
    row("0.1", 0.1);
    row("1.7976931348623157e308", std::numeric_limits<double>::max());
    row("5e-324", std::numeric_limits<double>::denorm_min());
    row("1e-400", 0);
    row("0.1000000000000000055511151231257827021181583404541015625", 0.1);
    for (const char *spelling : {"1e309", "nan", "NaN",   "inf", "-inf", "infinity", "0x10", "1e",    "1e+", "1.2.3",
                                 "--1",   "+-1", "1_000", "1f",  ".",    "-",        "e5",   "1'000", "½",   "١"}) {
        row(spelling, none);
    }
}

void TestSdoReader::numbersHaveManySpellings()
{
    QFETCH(double, value);
    const std::string spelling = QTest::currentDataTag();
    const SdoResult result =
        readSdo("l (0, " + spelling + ",0) (1,1,1)\nl (" + spelling + "," + spelling + " ," + spelling + ") #");
    QCOMPARE(result.description.has_value(), !std::isnan(value));
    if (result.description) {
        QCOMPARE(result.description->lights[0].position.y, value);
        QCOMPARE(numbers(result.description->lights[1].position), (QList<double>{value, value, value}));
    } else {
        QCOMPARE(result.diagnostics.size(), 2u); // one a line
        QCOMPARE(result.diagnostics[0].range.begin, 6u);
    }
}

void TestSdoReader::aFullTurnIsNotDoubted_data()
{
    QTest::addColumn<QString>("converted"); // what the fix makes of it; none: no warning
    const auto row = [](const char *angles, const char *converted) { QTest::newRow(angles) << converted; };
    row("(6.283185307179586, -6.283185307179586, 0)", "");
    row("(0, 0, 6.2831853071796)", "(0, 0, 0.10966227112321533)");
    row("(-6.2831853071796, 0, 0)", "(-0.10966227112321533, 0, 0)");
    row("( 90,-180 , 0)", "( 1.5707963267948966,-3.141592653589793 , 0)");
    row("(360, 1, 0)", "(6.283185307179586, 0.017453292519943295, 0)");
    row("(720, 405, 3)", "(0, 0.7853981633974483, 0.05235987755982989)"); // whole turns go
}

void TestSdoReader::aFullTurnIsNotDoubted()
{
    QFETCH(QString, converted);
    const std::string start = "o \"x.obj\" #\nc # ";
    const std::string text = start + QTest::currentDataTag() + " 60";
    const SdoResult result = readSdo(text);
    QVERIFY(result.description.has_value());
    QCOMPARE(result.diagnostics.empty(), converted.isEmpty());
    if (!result.diagnostics.empty()) {
        const std::string fixed = applied(text, result.diagnostics.front().fix.value().edits);
        QCOMPARE(fixed, start + converted.toStdString() + " 60");
        QVERIFY(readSdo(fixed).diagnostics.empty());
    }
}

void TestSdoReader::encodingsAndLineEnds_data()
{
    QTest::addColumn<QByteArray>("bytes");
    QTest::addColumn<QString>("message"); // none: it reads well
    const QByteArray good = "c # # 60\no \"x.obj\" #\nl # #\n";
    const QString letters =
        QStringLiteral(" a line starts with c (camera), o (object), f (fractal), p (ball) or l (light), found ");
    QTest::newRow("LF") << good << "";
    QTest::newRow("no final end") << good.chopped(1) << "";
    QTest::newRow("CR LF") << QByteArray(good).replace("\n", "\r\n") << "";
    QTest::newRow("CR") << QByteArray(good).replace("\n", "\r") << "";
    QTest::newRow("BOM") << "\xEF\xBB\xBF" + good << "";
    QTest::newRow("tabs and form feeds") << QByteArray(good).replace(" ", "\t\f ") << "";
    QTest::newRow("second BOM") << "\n\xEF\xBB\xBF" + good << "2:1" + letters + QString::fromUtf8("\"\uFEFF\"");
    QTest::newRow("UTF-16 LE") << QByteArray("\xFF\xFEx\0.\0", 6)
                               << "1:1 the file is not UTF-8 text (it looks like UTF-16)";
    QTest::newRow("UTF-16 BE") << QByteArray("\xFE\xFF\0x\0.", 6)
                               << "1:1 the file is not UTF-8 text (it looks like UTF-16)";
    QTest::newRow("NUL") << good + QByteArray("y\0", 2) << "1:1 the file is not UTF-8 text (it holds NUL bytes)";
    QTest::newRow("NUL far in") << QByteArray(5'000, '\n') + good + QByteArray("\0", 1)
                                << "5004:1" + letters + "a control character";
    QTest::newRow("Latin-1") << QByteArray("\xFC") << "1:1" + letters + QString::fromUtf8("\"\uFFFD\"");
    QTest::newRow("column after a BOM") << QByteArray("\xEF\xBB\xBF?") << "1:2" + letters + "\"?\"";
    QTest::newRow("column after umlauts")
        << QByteArray("o \"\u00FC.obj\" ?") << "1:11 a transformation in parentheses or # expected, found \"?\"";
}

void TestSdoReader::encodingsAndLineEnds()
{
    QFETCH(QByteArray, bytes);
    QFETCH(QString, message);
    const std::string text = bytes.toStdString();
    const SdoResult result = readSdo(text);
    if (message.isEmpty()) {
        QVERIFY(result.diagnostics.empty());
        QVERIFY(result.description.value().camera.has_value());
        QCOMPARE(result.description->items.size(), 1u);
        QCOMPARE(result.description->lights.size(), 1u);
        return;
    }
    QVERIFY(!result.description.has_value());
    const Diagnostic &first = result.diagnostics.at(0);
    const TextPosition at = LineMap(text).position(first.range.begin);
    QCOMPARE(QString::fromStdString(std::to_string(at.line) + ':' + std::to_string(at.column) + ' ' + first.message()),
             message);
}

void TestSdoReader::everyLocaleReadsAlike()
{
    // A decimal comma in the streams of C++, and in those of C where such a locale is installed.
    struct Comma : std::numpunct<char> {
        [[nodiscard]] char do_decimal_point() const override { return ','; }
    };
    const std::locale previous = std::locale::global(std::locale(std::locale::classic(), new Comma));
    for (const char *name : {"de_DE.UTF-8", "de_DE.utf8", "fr_FR.UTF-8"}) {
        std::setlocale(LC_ALL, name);
    }
    const SdoResult result = readSdo("c (0.5, 1.25, 1e-3) (0, 45.5, 0) 60.5");
    std::setlocale(LC_ALL, "C");
    std::locale::global(previous);
    QCOMPARE(numbers(result.description.value().camera.value().position), (QList<double>{0.5, 1.25, 1e-3}));
    QCOMPARE(result.diagnostics.at(0).fix.value().edits.at(0).text, "0.7941248096574199");
}

void TestSdoReader::anErrorLeavesNoScene()
{
    QVERIFY(readSdo("o \"x.obj\" #\nl # #").description.has_value());
    QVERIFY(!readSdo("o \"x.obj\" #\nl #\nl # #").description.has_value());
    QVERIFY(!readSdo("c # # 60\nc # # 60").description.has_value());
    QVERIFY(readSdo("l (1e-400, 0, 0) #").description.has_value()); // a warning
}

void TestSdoReader::anEmptyTextIsAnEmptyScene()
{
    for (const char *text : {"", "\n", "# nothing", "\xEF\xBB\xBF", "   \r\t"}) {
        const SdoResult result = readSdo(text);
        QVERIFY(result.diagnostics.empty());
        QVERIFY(result.description.value().items.empty() && !result.description->camera);
    }
}

/// Lines of a megabyte of each kind of word, and a megabyte of short lines: none takes more than linear time.
void TestSdoReader::longLinesAndManyLines()
{
    const std::size_t size = 1'000'000;
    const auto repeated = [&](const std::string &piece) {
        std::string text;
        while (text.size() < size) {
            text += piece;
        }
        return text;
    };
    for (const char *start : {"", "c ", "c (", "o \"x.obj\" ", "o \"x.obj\" (", "o ", "p \"x.obj\" # "}) {
        for (const char *piece : {"x", "1", "1 ", "1,", "1, ", "(", ")", "# ", "#, ", "(1, 2, 3) ", "\"", "\"x.obj\" ",
                                  "x.obj ", "\xFC", "."}) {
            const SdoResult result = readSdo(start + repeated(piece));
            QVERIFY(result.diagnostics.size() <= 1);
        }
    }
    QVERIFY(readSdo(repeated("o \"x.obj\" # # ")).description.has_value());
    QCOMPARE(readSdo(repeated("l\n")).diagnostics.size(), size / 2);
    QCOMPARE(readSdo(repeated("l # #\n")).description.value().lights.size(), (size + 5) / 6);
}

}

ROMANESCO_TEST(romanesco::test::TestSdoReader)

#include "testsdoreader.moc"
