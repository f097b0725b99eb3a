// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "core/measure/survey.h"

#include <cmath>

#include <QTest>

#include "tests/testmain.h"

namespace romanesco::test {

namespace {

/// Answers the query at (i, 0, 0) with the distance of a table, at a cost of i faces and two nodes.
class TableCollider final : public Collider
{
public:
    explicit TableCollider(std::vector<double> distances)
        : m_distances(std::move(distances))
    {
    }

    [[nodiscard]] std::unique_ptr<Search> search() const override { return std::make_unique<TableSearch>(m_distances); }
    [[nodiscard]] std::size_t memoryUse() const override { return 0; }

private:
    class TableSearch final : public Search
    {
    public:
        explicit TableSearch(const std::vector<double> &distances)
            : m_distances(distances)
        {
        }
        void closest(const Query &query, Hit &hit) override
        {
            const auto i = static_cast<std::size_t>(query.p.x);
            hit = {};
            hit.distance = m_distances[i];
            hit.cost = {i, 2};
        }
        void sweep(const Sweep &sweep, Touch &touch) override
        {
            const auto i = static_cast<std::size_t>(sweep.p.x);
            touch = {};
            touch.time = m_distances[i];
            touch.cost = {i, 2};
        }

    private:
        const std::vector<double> &m_distances;
    };

    std::vector<double> m_distances;
};

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr std::uint64_t noLimit = 1'000'000'000;

/// A ball of radius 1 at places that are so far from the surface.
Examination examinationOf(const std::vector<double> &distances)
{
    Examination examination;
    for (std::size_t i = 0; i < distances.size(); ++i) {
        examination.asks.push_back({Query{.p = {static_cast<double>(i), 0, 0}}, 1.0});
        examination.answers.push_back({distances[i], distances[i] < 1.0, true, {}});
    }
    return examination;
}

}

class TestSurvey : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void errorsAreCountedByTheirSize();
    void roundingIsNoError();
    void missesAreOfWhatTouches();
    void costsAreMeansAndTheNinetyNinthOfAHundred();
    void sweepsAreComparedByTheirWay();
    void whatTakesTooManyOperationsIsNotAsked();
};

void TestSurvey::errorsAreCountedByTheirSize()
{
    const Survey found = survey(TableCollider({2, 2 * (1 + 2e-6), 2 * (1 - 2e-6), 2.03, 1.7, 5}),
                                examinationOf({2, 2, 2, 2, 2, 2}), noLimit);
    QCOMPARE(found.asked, 6u);
    QCOMPARE(found.wrong[0].count, 5u);
    QCOMPARE(found.wrong[1].count, 3u);
    QCOMPARE(found.wrong[2].count, 2u);
    QCOMPARE(found.wrong[2].of, 6u);
    QVERIFY(std::abs(found.worst - 1.5) < 1e-9);
}

void TestSurvey::roundingIsNoError()
{
    Examination examination = examinationOf({1e-14, 0, 3});
    examination.size = 100;
    const Survey found = survey(TableCollider({1.5e-14, 1e-14, 3 + 1e-12}), examination, noLimit);
    QCOMPARE(found.wrong[0].count, 0u);
    QCOMPARE(found.worst, 0.0);
    const Survey off = survey(TableCollider({1e-14, 1e-10, 3}), examination, noLimit);
    QCOMPARE(off.wrong[2].count, 1u);
    QVERIFY(std::isfinite(off.worst) && off.worst > 1.0);
}

void TestSurvey::missesAreOfWhatTouches()
{
    const Survey found = survey(TableCollider({0.5, 1.5, 0.2, 3, 1}), examinationOf({0.5, 0.5, 0.5, 3, 1}), noLimit);
    QCOMPARE(found.missed.of, 3u);
    QCOMPARE(found.missed.count, 1u);
    const Survey none = survey(TableCollider({0.5}), examinationOf({5}), noLimit);
    QCOMPARE(none.missed.of, 0u); // what is found too near is wrong, but no miss
    QCOMPARE(none.wrong[2].count, 1u);
}

void TestSurvey::costsAreMeansAndTheNinetyNinthOfAHundred()
{
    const std::vector<double> ones(200, 1.0);
    const Survey found = survey(TableCollider(ones), examinationOf(ones), noLimit);
    QCOMPARE(found.faceTestsMean, 99.5);
    QCOMPARE(found.faceTestsP99, 197.0);
    QCOMPARE(found.nodeVisitsMean, 2.0);
}

void TestSurvey::sweepsAreComparedByTheirWay()
{
    Examination examination;
    for (int i = 0; i < 3; ++i) {
        examination.asks.push_back({Sweep{.p = {i, 0, 0}, .v = {0, -2, 0}, .time = 4, .radius = 1}});
        examination.answers.push_back({1.0 + 2.0 * 3.0, true, true, {}});
    }
    // on time, half a second late, never
    const Survey found = survey(TableCollider({3, 3.5, infinity}), examination, noLimit);
    QCOMPARE(found.wrong[1].count, 2u);
    QCOMPARE(found.wrong[2].count, 2u);
    QVERIFY(std::abs(found.worst - 2.0 / 7.0) < 1e-4); // the way ends after four seconds
    QCOMPARE(found.missed.of, 3u);
    QCOMPARE(found.missed.count, 1u);
}

/// i faces and two nodes for the i-th: 8, 17, 27, … in all.
void TestSurvey::whatTakesTooManyOperationsIsNotAsked()
{
    const std::vector<double> ones(20, 1.0);
    const Examination examination = examinationOf(ones);
    QCOMPARE(survey(TableCollider(ones), examination, 1).asked, 1u);
    QCOMPARE(survey(TableCollider(ones), examination, 18).asked, 3u);
    QCOMPARE(survey(TableCollider(ones), examination, noLimit).asked, 20u);
    const Survey few = survey(TableCollider(ones), examination, 18);
    QCOMPARE(few.wrong[0].of, 3u);
    QCOMPARE(few.faceTestsMean, 1.0);
}

}

ROMANESCO_TEST(romanesco::test::TestSurvey)

#include "testsurvey.moc"
