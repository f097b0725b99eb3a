// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "core/measure/digittrial.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>

#include <QTest>
#include <glm/geometric.hpp>

#include "core/export/exporter.h"
#include "core/fractal/copies.h"
#include "tests/core/physics/grounds.h"
#include "tests/testmain.h"

namespace romanesco::test {

namespace {

std::shared_ptr<const Scene> sceneWith(const std::shared_ptr<const Model> &model)
{
    return std::make_shared<const Scene>(romanesco::sceneOf(model));
}

std::shared_ptr<const Scene> sceneWith(const char *example, std::uint64_t depth)
{
    return sceneWith(modelOf(QLatin1String(example), depth));
}

DigitTrial tried(const char *example, std::uint64_t depth)
{
    return tryDigits(*sceneWith(example, depth), {}).value();
}

/// Through printf and strtod.
double rounded(double number, int digits)
{
    char text[64];
    std::snprintf(text, sizeof(text), "%.*g", digits, number);
    return std::strtod(text, nullptr);
}

/// What rounding does to a fractal, without a file.
struct Rounding {
    double worst = 0.0;
    double squares = 0.0;
    std::size_t vertices = 0;
    std::size_t collapsed = 0;

    Rounding(const Model &model, int digits)
    {
        const Mesh &mesh = *model.mesh;
        CopyWalk walk(model.graph, CopyWalk::Addresses::Drop);
        while (walk.next()) {
            std::vector<glm::dvec3> corners;
            for (const glm::dvec3 &vertex : mesh.vertices) {
                const glm::dvec3 exact = walk.modelFromBase()(vertex);
                corners.emplace_back(rounded(exact.x, digits), rounded(exact.y, digits), rounded(exact.z, digits));
                const double off = glm::distance(corners.back(), exact);
                worst = std::max(worst, off);
                squares += off * off;
                ++vertices;
            }
            for (const auto &[a, b, c] : mesh.faces) {
                collapsed += corners[a] == corners[b] || corners[b] == corners[c] || corners[c] == corners[a] ? 1 : 0;
            }
        }
    }
};

}

class TestDigitTrial : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void errorsAreThoseOfRounding_data();
    void errorsAreThoseOfRounding();
    void seventeenDigitsAndTheShortestLoseNothing();
    void flatFacesAreCounted();
    void bytesAreThoseOfTheFile();
    void whatIsTooLargeIsSampled();
    void allIsTheSameInEveryRun();
    void nothingToWriteIsRefused();
    void stoppingIsHeard();
};

void TestDigitTrial::errorsAreThoseOfRounding_data()
{
    QTest::addColumn<QString>("example");
    QTest::addColumn<int>("depth");
    QTest::newRow("tree") << "tree" << 3;
    QTest::newRow("snowflake") << "snowflake" << 2;
    QTest::newRow("sierpinski") << "sierpinski" << 6;
}

void TestDigitTrial::errorsAreThoseOfRounding()
{
    QFETCH(const QString, example);
    QFETCH(const int, depth);
    const auto scene = sceneWith(qPrintable(example), static_cast<std::uint64_t>(depth));
    const DigitTrial trial = tryDigits(*scene, {}).value();
    QVERIFY(trial.isWhole);
    QCOMPARE(trial.rows.size(), 16u);
    for (const DigitRow &row : trial.rows) {
        const Rounding rounding(*scene->items[0].model, row.digits.value_or(17));
        QCOMPARE(trial.vertices, rounding.vertices);
        const double worst = rounding.worst / trial.diagonal;
        const double rms = std::sqrt(rounding.squares / double(rounding.vertices)) / trial.diagonal;
        QVERIFY2(std::abs(row.worst - worst) <= 1e-12 * worst, qPrintable(QString::number(row.worst)));
        QVERIFY2(std::abs(row.rms - rms) <= 1e-9 * rms, qPrintable(QString::number(row.rms)));
        QCOMPARE(row.collapsed, rounding.collapsed);
    }
    QVERIFY(trial.rows.front().worst > 1e-5);
}

void TestDigitTrial::seventeenDigitsAndTheShortestLoseNothing()
{
    for (const char *example : {"menger", "tree", "two-sets"}) {
        const DigitTrial trial = tried(example, 2);
        const DigitRow &seventeen = trial.rows[14];
        QCOMPARE(seventeen.digits, std::optional(17));
        for (const DigitRow &row : {seventeen, trial.rows.back()}) {
            QCOMPARE(row.worst, 0.0);
            QCOMPARE(row.collapsed + row.flat, 0u);
        }
        QVERIFY(trial.rows.front().worst > 1e-5);
        QVERIFY(trial.rows.back().bytes->log10() < seventeen.bytes->log10());
        QVERIFY(!trial.rows.back().digits);
    }
}

/// A face whose corners stay apart but come to stand on a line.
void TestDigitTrial::flatFacesAreCounted()
{
    Mesh mesh;
    mesh.vertices = {{0, 0, 0}, {2, 0, 0}, {1, 1e-9, 1}, {1, 1.00001, 1}, {3, 1.00002, 1}, {2, 1.00003, 1}};
    mesh.faces = {{0, 1, 2}, {3, 4, 5}};
    const DigitTrial trial = tryDigits(*sceneWith(modelOf(mesh)), {}).value();
    for (const DigitRow &row : trial.rows) {
        QCOMPARE(row.collapsed, 0u);
        QCOMPARE(row.flat, row.digits && *row.digits < 6 ? 1u : 0u);
    }
}

void TestDigitTrial::bytesAreThoseOfTheFile()
{
    const auto scene = sceneWith("tree", 3);
    const DigitTrial trial = tryDigits(*scene, {}).value();
    for (const DigitRow &row : trial.rows) {
        CountingSink sink;
        QVERIFY(exportScene(*scene, {.digits = row.digits}, sink));
        QCOMPARE(row.bytes->toInteger(), std::optional(sink.count()));
        QVERIFY(row.nanoseconds.median > 0.0);
    }
}

void TestDigitTrial::whatIsTooLargeIsSampled()
{
    const DigitTrial trial = tried("menger", 40);
    QVERIFY(!trial.isWhole);
    QVERIFY(trial.faces >= 50'000 && trial.faces < 50'012);
    QVERIFY(std::abs(trial.facesInAll->log10() - 40 * std::log10(20.0) - std::log10(12.0)) < 1e-9);
    for (const DigitRow &row : trial.rows) {
        // coordinates are below 1.5, and half a digit off at most
        const double most = row.digits ? 0.5 * std::pow(10.0, 1 - *row.digits) * std::sqrt(3.0) / trial.diagonal : 0.0;
        QVERIFY2(row.worst <= 1.0001 * most && (row.worst > 0.5 * most || most < 1e-15),
                 qPrintable(QString::number(row.worst)));
        // a cube is smaller than what a double tells of its place, and was so before
        QCOMPARE(row.collapsed + row.flat, 0u);
        const double bytesAFace = std::pow(10.0, row.bytes->log10() - trial.facesInAll->log10());
        QVERIFY2(bytesAFace > 50 && bytesAFace < 300, qPrintable(QString::number(bytesAFace)));
    }
}

void TestDigitTrial::allIsTheSameInEveryRun()
{
    const DigitTrial first = tried("two-sets", 3);
    const DigitTrial second = tried("two-sets", 3);
    QCOMPARE(first.faces, second.faces);
    for (std::size_t i = 0; i < first.rows.size(); ++i) {
        QCOMPARE(first.rows[i].worst, second.rows[i].worst);
        QCOMPARE(first.rows[i].rms, second.rows[i].rms);
        QCOMPARE(first.rows[i].collapsed, second.rows[i].collapsed);
        QCOMPARE(first.rows[i].flat, second.rows[i].flat);
        QVERIFY(first.rows[i].bytes == second.rows[i].bytes);
    }
}

void TestDigitTrial::nothingToWriteIsRefused()
{
    const auto trial = tryDigits(*sceneOf({}), {});
    QVERIFY(!trial);
    QCOMPARE(trial.error(), std::string("there is nothing to be written"));
}

void TestDigitTrial::stoppingIsHeard()
{
    std::stop_source stop;
    int told = 0;
    const auto trial = tryDigits(*sceneWith("tree", 3), {}, {stop.get_token(), [&](const std::string &, double) {
                                                                 ++told;
                                                                 stop.request_stop();
                                                             }});
    QVERIFY(!trial && trial.error() == "cancelled");
    QCOMPARE(told, 1);
}

}

ROMANESCO_TEST(romanesco::test::TestDigitTrial)

#include "testdigittrial.moc"
