// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "core/measure/errorplot.h"

#include <cmath>
#include <random>

#include <QRegularExpression>
#include <QTest>
#include <QXmlStreamReader>

#include "tests/testmain.h"

namespace romanesco::test {

namespace {

/// The attributes of all circles, in order.
QList<QXmlStreamAttributes> circlesOf(const std::string &svg)
{
    QList<QXmlStreamAttributes> circles;
    QXmlStreamReader xml(QString::fromStdString(svg));
    while (!xml.atEnd()) {
        if (xml.readNext() == QXmlStreamReader::StartElement && xml.name() == QLatin1String("circle")) {
            circles.push_back(xml.attributes());
        }
    }
    return xml.hasError() ? QList<QXmlStreamAttributes>() : circles;
}

double number(const QXmlStreamAttributes &attributes, const char *name)
{
    return attributes.value(QLatin1String(name)).toDouble();
}

}

class TestErrorPlot : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void theFrontIsWhatNothingBeats();
    void placesGoByLogarithms();
    void whatIsNotOffStandsAtTheBottom();
    void fullPointsAreThoseOfTheFront();
    void labelsKeepOffEachOther();
    void wordsAreEscaped();
    void extremesStayInThePicture_data();
    void extremesStayInThePicture();
};

void TestErrorPlot::theFrontIsWhatNothingBeats()
{
    const std::vector<PlotPoint> points{{"cheap", 0, 1, 5}, {"middle", 0, 2, 3},   {"beaten", 0, 2.5, 3},
                                        {"worse", 0, 9, 4}, {"exact", 0, 8, 0},    {"slower", 0, 9, 0},
                                        {"same", 0, 2, 3},  {"same cost", 0, 1, 6}};
    const std::vector<bool> expected{true, true, false, false, true, false, true, false};
    QCOMPARE(paretoFront(points), expected);
    // sorted by cost, what is on it is always better than all before
    std::mt19937_64 random(seed(1));
    std::vector<PlotPoint> many;
    for (int i = 0; i < 300; ++i) {
        many.push_back(
            {"", 0, static_cast<double>(1 + random() % 1'000'000), static_cast<double>(random() % 1'000'000)});
    }
    std::ranges::sort(many, {}, &PlotPoint::cost);
    const std::vector<bool> front = paretoFront(many);
    double least = std::numeric_limits<double>::infinity();
    int count = 0;
    for (std::size_t i = 0; i < many.size(); ++i) {
        QCOMPARE(front[i], many[i].error < least);
        least = std::min(least, many[i].error);
        count += front[i] ? 1 : 0;
    }
    QVERIFY(count > 2);
}

void TestErrorPlot::placesGoByLogarithms()
{
    const auto circles =
        circlesOf(errorPlot(std::vector<PlotPoint>{{"a", 0, 2, 1}, {"b", 0, 20, 0.1}, {"c", 0, 200, 0.001}}, "x", "y"));
    QCOMPARE(circles.size(), 3);
    const double first = number(circles[1], "cx") - number(circles[0], "cx");
    const double second = number(circles[2], "cx") - number(circles[1], "cx");
    QVERIFY(first > 50 && std::abs(second - first) < 0.3);
    const double oneDecade = number(circles[1], "cy") - number(circles[0], "cy");
    const double twoDecades = number(circles[2], "cy") - number(circles[1], "cy");
    QVERIFY(oneDecade > 20 && std::abs(twoDecades - 2 * oneDecade) < 0.4);
}

void TestErrorPlot::whatIsNotOffStandsAtTheBottom()
{
    const std::string svg = errorPlot(std::vector<PlotPoint>{{"a", 0, 2, 1e-9}, {"b", 0, 20, 0.0}}, "x", "y");
    const auto circles = circlesOf(svg);
    QVERIFY(number(circles[1], "cy") > number(circles[0], "cy") + 5);
    QVERIFY(svg.contains(">none<"));
    QCOMPARE(circlesOf(errorPlot(std::vector<PlotPoint>{{"b", 0, 20, 0.0}}, "x", "y")).size(), 1);
    QCOMPARE(errorPlot({}, "x", "y"), std::string());
}

void TestErrorPlot::fullPointsAreThoseOfTheFront()
{
    const auto circles =
        circlesOf(errorPlot(std::vector<PlotPoint>{{"a", 2, 2, 1}, {"b", 2, 20, 2}, {"c", 3, 30, 0.5}}, "x", "y"));
    QVERIFY(circles[0].value(QLatin1String("fill")) != QLatin1String("none"));
    QVERIFY(circles[1].value(QLatin1String("fill")) == QLatin1String("none"));
    QVERIFY(circles[2].value(QLatin1String("fill")) != QLatin1String("none"));
    QVERIFY(circles[0].value(QLatin1String("stroke")) == circles[1].value(QLatin1String("stroke")));
    QVERIFY(circles[0].value(QLatin1String("stroke")) != circles[2].value(QLatin1String("stroke")));
}

/// All alike: some labels are left out, and each point keeps its title.
void TestErrorPlot::labelsKeepOffEachOther()
{
    const std::vector<PlotPoint> points(20, {"label", 0, 5, 1});
    const QString svg = QString::fromStdString(errorPlot(points, "x", "y"));
    const auto labels = svg.count(QLatin1String(">label</text>"));
    QVERIFY(labels >= 3 && labels <= 8);
    QCOMPARE(svg.count(QLatin1String("<title>label: ")), 20);
}

void TestErrorPlot::wordsAreEscaped()
{
    const std::string svg = errorPlot(std::vector<PlotPoint>{{"<a & \"b\"\x01>", 0, 1, 1}}, "<x>", "&");
    QCOMPARE(circlesOf(svg).size(), 1);
    QVERIFY(svg.contains("&lt;a &amp; &quot;b&quot;?&gt;"));
}

void TestErrorPlot::extremesStayInThePicture_data()
{
    QTest::addColumn<double>("cost");
    QTest::addColumn<double>("error");
    QTest::newRow("tiny") << 1e-300 << 1e-300;
    QTest::newRow("huge") << 1e300 << 1e300;
    QTest::newRow("one") << 1.0 << 1.0;
}

void TestErrorPlot::extremesStayInThePicture()
{
    QFETCH(const double, cost);
    QFETCH(const double, error);
    const std::string svg =
        errorPlot(std::vector<PlotPoint>{{"a", 0, 1, 1}, {"b", 0, cost, error}, {"c", 0, 3, 0}}, "x", "y");
    const auto circles = circlesOf(svg);
    QCOMPARE(circles.size(), 3);
    for (const auto &circle : circles) {
        QVERIFY(number(circle, "cx") >= 60 && number(circle, "cx") <= 560);
        QVERIFY(number(circle, "cy") >= 10 && number(circle, "cy") <= 330);
    }
    QVERIFY(svg.size() < 200'000);
}

}

ROMANESCO_TEST(romanesco::test::TestErrorPlot)

#include "testerrorplot.moc"
