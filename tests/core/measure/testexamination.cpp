// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "core/measure/examination.h"

#include <algorithm>

#include <QTest>
#include <glm/geometric.hpp>

#include "core/measure/scenefaces.h"
#include "core/scene/scenecollider.h"
#include "tests/core/collide/meshes.h"
#include "tests/core/physics/grounds.h"
#include "tests/testmain.h"

namespace romanesco::test {

namespace {

using Kind = SceneDescription::Kind;

/// Of a scene that has a surface.
std::vector<Examination> examined(const std::shared_ptr<const Scene> &scene, std::size_t points,
                                  const std::vector<Ball> &balls = {})
{
    const Subject subject = Subject::of(scene, balls).value();
    return examinations(subject, points, 0.1).value();
}

double distanceToBox(const Box &box, const glm::dvec3 &p)
{
    return glm::distance(p, glm::clamp(p, box.least, box.greatest));
}

const Query &queryOf(const Ask &ask)
{
    return std::get<Query>(ask.what);
}

}

class TestExamination : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void answersAreThoseOfBruteForce();
    void placesAreWhereTheyShouldBe();
    void nearPlacesAreOffTheirFace();
    void facesAreThoseOfTheSurface();
    void facesOfEveryDepthAreFound();
    void theSameIsAskedEveryTime();
    void ballsAskWhatTheyAskInAStep();
    void ballsThatMissAskToo();
    void whatHasNoSurfaceIsRefused();
    void whatTakesTooLongIsLeftOut();
    void stoppingIsHeard();
};

void TestExamination::answersAreThoseOfBruteForce()
{
    std::mt19937_64 random(seed(81));
    int asked = 0;
    for (int round = 0; round < 12; ++round) {
        const Written written = randomScene(random);
        const auto scene = sceneOf(written.items);
        std::vector<Ball> balls{{.position = {0.1, 9, 0.2}, .radius = 0.3, .restitution = 0.6},
                                {.position = {2, 8, -1}, .velocity = {-1, 0, 0}, .radius = 0.5, .restitution = 0.2}};
        const auto subject = Subject::of(scene, balls);
        if (!subject) {
            continue; // of balls only, or one point
        }
        const std::vector<Examination> sets = examinations(*subject, 8, 0.5).value();
        for (const Examination &examination : sets) {
            for (std::size_t i = 0; i < examination.asks.size(); ++i) {
                const Query *query = std::get_if<Query>(&examination.asks[i].what);
                if (query == nullptr || query->motion) {
                    continue;
                }
                const double least = std::min(static_cast<double>(written.distance(query->p)), query->radius);
                const double off = std::abs(examination.answers[i].length - least);
                QVERIFY2(off <= roundingOf(examination.asks[i], examination.size),
                         qPrintable(QStringLiteral("round %1, set %2: off by %3 of %4, radius %5")
                                        .arg(round)
                                        .arg(static_cast<int>(examination.queries))
                                        .arg(off)
                                        .arg(least)
                                        .arg(query->radius)));
                if (examination.queries != QuerySet::Balls && std::abs(least - 0.5) > 1e-9) {
                    QCOMPARE(examination.answers[i].touches, least < 0.5);
                }
                ++asked;
            }
        }
    }
    QVERIFY(asked > 200);
}

void TestExamination::placesAreWhereTheyShouldBe()
{
    const auto scene = sceneOf({{.model = modelOf(QStringLiteral("tree"), 5)}});
    const Subject subject = Subject::of(scene, {}).value();
    const auto sets = examined(scene, 400);
    QCOMPARE(sets.size(), 3u);
    const Box &box = subject.box;
    const glm::dvec3 half = 0.5 * box.size();
    int outside = 0;
    double distanceOfUniform = 0.0;
    int inBox = 0;
    for (std::size_t i = 0; i < sets[0].asks.size(); ++i) {
        const glm::dvec3 off = glm::abs(queryOf(sets[0].asks[i]).p - box.centre());
        QVERIFY(glm::all(glm::lessThanEqual(off, 1.5 * half)));
        const bool isInBox = glm::all(glm::lessThanEqual(off, 0.9 * half));
        outside += glm::any(glm::greaterThan(off, half)) ? 1 : 0;
        inBox += isInBox ? 1 : 0;
        distanceOfUniform += isInBox ? sets[0].answers[i].length : 0.0;
    }
    // 1 - 1/1.5^3 of them
    QVERIFY2(outside > 400 * 0.62 && outside < 400 * 0.79, qPrintable(QString::number(outside)));
    for (std::size_t i = 0; i < sets[1].asks.size(); ++i) {
        QVERIFY(sets[1].answers[i].length <= 0.0502 * subject.diagonal);
        QVERIFY(distanceToBox(box, queryOf(sets[1].asks[i]).p) <= 0.0502 * subject.diagonal);
    }
    double distanceOfPockets = 0.0;
    for (std::size_t i = 0; i < sets[2].asks.size(); ++i) {
        const glm::dvec3 off = glm::abs(queryOf(sets[2].asks[i]).p - box.centre());
        QVERIFY(glm::all(glm::lessThanEqual(off, 0.9000001 * half)));
        distanceOfPockets += sets[2].answers[i].length;
    }
    QVERIFY(distanceOfPockets / 400 > 1.5 * distanceOfUniform / inBox);
}

/// Of a floor each place is as far off as it was moved.
void TestExamination::nearPlacesAreOffTheirFace()
{
    const auto sets = examined(sceneOf({{.model = modelOf(floorMesh(5))}}), 500);
    const double diagonal = std::sqrt(200.0);
    int above = 0;
    int closer = 0;
    for (std::size_t i = 0; i < sets[1].asks.size(); ++i) {
        const glm::dvec3 &p = queryOf(sets[1].asks[i]).p;
        const double away = std::abs(p.y) / diagonal;
        QVERIFY2(away > 0.00099 && away < 0.0502, qPrintable(QString::number(away)));
        QVERIFY(std::abs(p.x) <= 5.0 && std::abs(p.z) <= 5.0);
        above += p.y > 0.0 ? 1 : 0;
        closer += away < 0.00708 ? 1 : 0; // half of them, since it is their logarithm that is uniform
    }
    QVERIFY(above > 200 && above < 300);
    QVERIFY(closer > 200 && closer < 300);
}

void TestExamination::facesAreThoseOfTheSurface()
{
    std::mt19937_64 random(seed(82));
    int found = 0;
    for (int round = 0; round < 10; ++round) {
        const Written written = randomScene(random);
        const auto scene = sceneOf(written.items);
        SceneFaces faces(*scene, 1.0);
        const bool hasSurface =
            std::ranges::any_of(written.items, [](const SceneItem &item) { return item.kind != Kind::Ball; });
        QCOMPARE(faces.isEmpty(), !hasSurface);
        for (int i = 0; hasSurface && i < 10; ++i) {
            const FaceSource::Face face = faces.draw(random);
            for (const glm::dvec3 &point : {face.corner, face.corner + face.edges[0], face.corner + face.edges[1],
                                            face.corner + 0.4 * face.edges[0] + 0.3 * face.edges[1]}) {
                QVERIFY(static_cast<double>(written.distance(point)) < 1e-12);
            }
            ++found;
        }
    }
    QVERIFY(found > 50);
}

/// Of copies as small as a half at each level: about half of the words of [#, a] end at each.
void TestExamination::facesOfEveryDepthAreFound()
{
    const auto model = modelOf(QStringLiteral("tree"), 40);
    const auto scene = sceneOf({{.model = model}});
    SceneFaces faces(*scene, 1.0);
    std::mt19937_64 random(seed(83));
    double largest = 0.0;
    double least = 1e9;
    for (int i = 0; i < 2'000; ++i) {
        const double length = glm::length(faces.draw(random).edges[0]);
        largest = std::max(largest, length);
        least = std::min(least, length);
    }
    QVERIFY(largest > 1e3 * least);
    // without an end there are points
    const auto endless = sceneOf({{.model = modelOf(QStringLiteral("menger"), 1'000'000'000)}});
    SceneFaces points(*endless, 1.0);
    const FaceSource::Face point = points.draw(random);
    QCOMPARE(point.edges[0], glm::dvec3(0.0));
    const SceneCollider exact = SceneCollider::create(endless, {}).value();
    Hit hit;
    exact.search()->closest({.p = point.corner}, hit);
    QVERIFY2(hit.distance < 2e-9, qPrintable(QString::number(hit.distance)));
}

void TestExamination::theSameIsAskedEveryTime()
{
    const auto scene = sceneOf({{.model = modelOf(QStringLiteral("tree"), 6)}});
    const std::vector<Ball> balls{{.position = {0.01, 3, 0.02}, .radius = 0.05, .restitution = 0.5}};
    const auto first = examined(scene, 60, balls);
    const auto second = examined(scene, 60, balls);
    QCOMPARE(first.size(), 4u);
    for (std::size_t set = 0; set < 4; ++set) {
        QCOMPARE(first[set].asks.size(), 60u);
        QCOMPARE(second[set].asks.size(), 60u);
        for (std::size_t i = 0; i < 60; ++i) {
            QCOMPARE(first[set].answers[i].length, second[set].answers[i].length);
            QCOMPARE(first[set].answers[i].cost.nodeVisits, second[set].answers[i].cost.nodeVisits);
        }
    }
}

/// A ball that falls on a floor asks on its way down, and where it lands.
void TestExamination::ballsAskWhatTheyAskInAStep()
{
    const auto scene = sceneOf({{.model = modelOf(floorMesh(5))}});
    const std::vector<Ball> balls{{.position = {0.5, 3, 0.5}, .radius = 0.25, .restitution = 0.5}};
    const auto sets = examined(scene, 1'000, balls);
    QVERIFY(sets.back().queries == QuerySet::Balls);
    const Examination &asked = sets.back();
    QVERIFY(asked.asks.size() > 5 && asked.asks.size() < 1'000);
    int touching = 0;
    bool hasSweep = false;
    for (std::size_t i = 0; i < asked.asks.size(); ++i) {
        touching += asked.answers[i].touches ? 1 : 0;
        const Query *query = std::get_if<Query>(&asked.asks[i].what);
        hasSweep = hasSweep || query == nullptr;
        const glm::dvec3 &p = query != nullptr ? query->p : std::get<Sweep>(asked.asks[i].what).p;
        QVERIFY(p.y > 0.24 && p.y <= 3.3 && std::abs(p.x - 0.5) < 1e-3);
    }
    QVERIFY(hasSweep && touching > 0);
    // fewer are spread over the same time
    const auto few = examined(scene, 5, balls);
    QCOMPARE(few.back().asks.size(), 5u);
}

void TestExamination::ballsThatMissAskToo()
{
    const auto scene = sceneOf({{.model = modelOf(floorMesh(5))}});
    const auto sets = examined(scene, 100, {{.position = {100, 3, 0}, .radius = 0.25, .restitution = 0.5}});
    QVERIFY(sets.back().queries == QuerySet::Balls && !sets.back().asks.empty());
    QVERIFY(std::ranges::none_of(sets.back().answers, &Answer::touches));
}

void TestExamination::whatHasNoSurfaceIsRefused()
{
    const auto refused = [](std::vector<SceneItem> items) {
        return QString::fromStdString(Subject::of(sceneOf(std::move(items)), {}).error());
    };
    QCOMPARE(refused({}), QStringLiteral("there is no surface to measure"));
    QCOMPARE(refused({{.model = modelOf(floorMesh(1)), .kind = Kind::Ball}}),
             QStringLiteral("there is no surface to measure"));
    QCOMPARE(refused({{.model = modelOf(Mesh{})}}), QStringLiteral("there is no surface to measure"));
    QVERIFY(refused({{.model = modelOf(floorMesh(1)), .worldFromModel = {glm::dmat3(0.0), {1, 2, 3}}}})
                .startsWith(QStringLiteral("the surface is a single point")));
    QVERIFY(refused({{.model = modelOf(floorMesh(1)), .worldFromModel = {glm::dmat3(1e110), {1, 2, 3}}}})
                .contains(QStringLiteral("beyond 10^100")));
}

/// From the middle of a sphere nearly all faces are equally far, and have to be looked at.
void TestExamination::whatTakesTooLongIsLeftOut()
{
    const auto scene = sceneOf({{.model = modelOf(ball(400))}});
    const auto sets = examined(scene, 4'000);
    QCOMPARE(sets[0].asks.size(), 4'000u);
    QVERIFY2(sets[2].asks.size() < 2'000 && sets[2].asks.size() > 20, qPrintable(QString::number(sets[2].asks.size())));
}

void TestExamination::stoppingIsHeard()
{
    const auto scene = sceneOf({{.model = modelOf(QStringLiteral("menger"), 4)}});
    const Subject subject = Subject::of(scene, {}).value();
    std::stop_source stop;
    int told = 0;
    const TrialContext context{stop.get_token(), [&](const std::string &, double) {
                                   if (++told == 2) {
                                       stop.request_stop();
                                   }
                               }};
    const auto made = examinations(subject, 1'000'000, 0.1, context);
    QVERIFY(!made.has_value());
    QCOMPARE(made.error(), std::string("cancelled"));
}

}

ROMANESCO_TEST(romanesco::test::TestExamination)

#include "testexamination.moc"
