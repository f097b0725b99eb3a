// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "core/collide/facelanes.h"

#include <limits>
#include <numeric>
#include <random>

#include "core/collide/leaffaces.h"
#include "core/geometry/movingsphere.h"
#include "tests/core/collide/bruteforce.h"
#include "tests/core/collide/instructionsets.h"
#include "tests/core/geometry/triangles.h"
#include "tests/testmain.h"

namespace romanesco::test {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Faces that share no corners.
Mesh meshOf(std::span<const Triangle> triangles)
{
    Mesh mesh;
    for (const Triangle &triangle : triangles) {
        const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
        mesh.vertices.insert(mesh.vertices.end(), triangle.begin(), triangle.end());
        mesh.faces.push_back({first, first + 1, first + 2});
    }
    return mesh;
}

/// As slim as a plain one may be, at the most.
Triangle slimTriangle(Draw &draw)
{
    const glm::dvec3 a = draw.vector();
    const glm::dvec3 along = draw.vector();
    const double share = draw.number(-0.2, 1.2);
    return {a, a + along, a + share * along + draw.vector(draw.size(-2, 0))};
}

glm::dvec3 near(const Triangle &triangle, Draw &draw)
{
    const double b = draw.number(-0.1, 1);
    const double c = draw.number(-0.1, 1);
    return triangle[0] + b * (triangle[1] - triangle[0]) + c * (triangle[2] - triangle[0])
        + draw.vector(draw.size(-12, 1));
}

Triangle seenFrom(const glm::dvec3 &p, const Triangle &triangle)
{
    return {triangle[0] - p, triangle[1] - p, triangle[2] - p};
}

/// Of every shape, and a sphere that starts somewhere and moves towards one of them.
struct SweptMesh {
    std::vector<Triangle> triangles;
    glm::dvec3 start{0.0};
    MovingSphere sphere;
    /// Of what counts for rounding.
    double reach = 0.0;

    SweptMesh(Shape shape, Draw &draw, std::mt19937_64 &random)
    {
        const std::size_t count = 1 + random() % LeafFaces::most;
        for (std::size_t k = 0; k < count; ++k) {
            triangles.push_back(trianglePoint(k % 3 == 0 ? shape : Shape::Plain, draw).first);
        }
        const Triangle &aim = triangles[random() % count];
        const double size = std::max({1e-3, glm::distance(aim[0], aim[1]), glm::distance(aim[0], aim[2])});
        sphere.radius = size * draw.size(-3, 0);
        start = aim[0] + size * draw.vector(draw.size(-1, 2));
        const glm::dvec3 way = near(aim, draw) - start;
        sphere.direction = glm::length(way) > 0.0 ? glm::normalize(way) : glm::dvec3(0.0, 1.0, 0.0);
        reach = sphere.radius;
        for (const Triangle &triangle : triangles) {
            reach = std::max(reach, largestOffset(triangle, start));
        }
    }

    /// Of a sphere whose radius differs by so much.
    [[nodiscard]] double wayTo(std::size_t face, double more) const
    {
        return touch(seenFrom(start, triangles[face]), {sphere.direction, std::max(0.0, sphere.radius + more)}).way;
    }
};

}

class TestFaceLanes : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void distancesOfPlainFacesAreWithinTheirError();
    void slimFacesAreNotPlain_data();
    void slimFacesAreNotPlain();
    void ordinaryFacesArePlain();
    void everyInstructionSetGivesTheSameBits();
    void theNearestFaceOfAMeshIsFound_data();
    void theNearestFaceOfAMeshIsFound();
    void waysToFacesAreAsOneByOne_data();
    void waysToFacesAreAsOneByOne();
    void theFirstFaceThatIsTouchedIsFound_data();
    void theFirstFaceThatIsTouchedIsFound();
};

/// The measured error is below half of what is stated.
void TestFaceLanes::distancesOfPlainFacesAreWithinTheirError()
{
    Draw draw(1);
    double worst = 0.0;
    int plain = 0;
    for (int i = 0; i < 4'000; ++i) {
        const double scale = i % 2 == 0 ? 1.0 : draw.size(-60, 60);
        std::vector<Triangle> triangles;
        for (int k = 0; k < 10; ++k) {
            Triangle triangle = slimTriangle(draw);
            for (glm::dvec3 &vertex : triangle) {
                vertex *= scale;
            }
            triangles.push_back(triangle);
        }
        const Mesh mesh = meshOf(triangles);
        const std::vector<CornerLanes> corners = cornersOf(mesh);
        std::vector<FaceLanes> faces(corners.size());
        placeFaces(corners, {}, faces.data());
        const Triangle &aim = triangles[static_cast<std::size_t>(i) % triangles.size()];
        const glm::dvec3 p = scale * near({aim[0] / scale, aim[1] / scale, aim[2] / scale}, draw);
        std::vector<double> distances(faces.size() * laneCount);
        faceDistances(faces, p, distances.data());
        for (std::size_t k = 0; k < triangles.size(); ++k) {
            if (faces[k / laneCount].isPlain[k % laneCount] != 0.0) {
                ++plain;
                const double error = static_cast<double>(abs(Real(distances[k]) - trueDistance(triangles[k], p)))
                    / largestOffset(triangles[k], p);
                worst = std::max(worst, error / errorOfFaceDistances);
            }
        }
    }
    QVERIFY(plain > 20'000);
    QVERIFY2(worst < 0.5, qPrintable(QString::number(worst)));
    QVERIFY2(worst > 0.01, qPrintable(QString::number(worst)));
}

void TestFaceLanes::slimFacesAreNotPlain_data()
{
    QTest::addColumn<Shape>("shape");
    QTest::newRow("needles") << Shape::Needle;
    QTest::newRow("slivers") << Shape::Sliver;
    QTest::newRow("segments") << Shape::Segment;
    QTest::newRow("points") << Shape::Point;
}

void TestFaceLanes::slimFacesAreNotPlain()
{
    QFETCH(const Shape, shape);
    Draw draw(2);
    for (int i = 0; i < 1'000; ++i) {
        const Triangle triangle = trianglePoint(shape, draw).first;
        const std::vector<CornerLanes> corners = cornersOf(meshOf({&triangle, 1}));
        FaceLanes faces;
        placeFaces(corners, {}, &faces);
        QCOMPARE(faces.isPlain[0], 0.0);
    }
}

void TestFaceLanes::ordinaryFacesArePlain()
{
    Draw draw(3);
    int plain = 0;
    for (int i = 0; i < 1'000; ++i) {
        const Triangle triangle = trianglePoint(Shape::Plain, draw).first;
        const std::vector<CornerLanes> corners = cornersOf(meshOf({&triangle, 1}));
        FaceLanes faces;
        placeFaces(corners, {}, &faces);
        plain += faces.isPlain[0] != 0.0 ? 1 : 0;
    }
    QVERIFY2(plain > 980, qPrintable(QString::number(plain)));
}

void TestFaceLanes::everyInstructionSetGivesTheSameBits()
{
    Draw draw(4);
    std::mt19937_64 random(seed(4));
    for (int i = 0; i < 1'000; ++i) {
        std::vector<Triangle> triangles;
        for (int k = 0; k < 12; ++k) {
            triangles.push_back(trianglePoint(static_cast<Shape>((i + k) % 7), draw).first);
        }
        const std::vector<CornerLanes> corners = cornersOf(meshOf(triangles));
        const AffineMap map{{draw.vector(), draw.vector(), draw.vector()}, draw.vector()};
        const glm::dvec3 p = draw.vector(draw.size(-2, 2));
        std::vector<std::vector<double>> results;
        withEveryInstructionSet([&] {
            std::vector<FaceLanes> faces(corners.size());
            placeFaces(corners, map, faces.data());
            std::vector<double> &result = results.emplace_back(faces.size() * laneCount);
            faceDistances(faces, p, result.data());
            std::vector<double> ways(result.size());
            waysToFaces(faces, p, {glm::normalize(-p), 0.1}, 0.0, infinity, ways.data());
            result.insert(result.end(), ways.begin(), ways.end());
            for (const FaceLanes &block : faces) {
                result.insert(result.end(), block.isPlain.begin(), block.isPlain.end());
            }
        });
        for (const std::vector<double> &result : results) {
            QCOMPARE(result, results.front());
        }
    }
}

void TestFaceLanes::theNearestFaceOfAMeshIsFound_data()
{
    addShapes();
}

/// Of every shape, beside the truth; also as a map places it.
void TestFaceLanes::theNearestFaceOfAMeshIsFound()
{
    QFETCH(const Shape, shape);
    Draw draw(5);
    std::mt19937_64 random(seed(5));
    for (int i = 0; i < 500; ++i) {
        std::vector<Triangle> triangles;
        glm::dvec3 p{0.0};
        const std::size_t count = 1 + random() % LeafFaces::most;
        for (std::size_t k = 0; k < count; ++k) {
            const auto [triangle, from] = trianglePoint(k % 3 == 0 ? shape : Shape::Plain, draw);
            triangles.push_back(triangle);
            p = k % 3 == 0 ? from : p;
        }
        Real truth = std::numeric_limits<double>::infinity();
        double reach = 0.0;
        for (const Triangle &triangle : triangles) {
            truth = std::min(truth, trueDistance(triangle, p));
            reach = std::max(reach, largestOffset(triangle, p));
        }
        const Mesh mesh = meshOf(triangles);
        const LeafFaces faces(mesh);
        const AffineMap seenFromP{glm::dmat3(1.0), -p};
        LeafHit itself;
        LeafHit placed;
        faces.measure(p, std::numeric_limits<double>::infinity(), {}, itself);
        faces.measure(seenFromP, std::numeric_limits<double>::infinity(), {}, placed);
        for (const LeafHit &hit : {itself, placed}) {
            QCOMPARE(hit.faceTests, count);
            QVERIFY(abs(Real(hit.distance) - truth) <= Real(errorOfFaceDistances * reach));
            QVERIFY(Real(hit.lower) <= truth + Real(1e-15 * reach)); // corners that are seen from p are rounded
            QVERIFY(Real(hit.lower) >= truth - Real(2 * errorOfFaceDistances * reach));
        }
        faces.measure(p, static_cast<double>(truth) * 0.99 - 1e-12 * reach, {}, itself);
        if (truth > Real(1e-9 * reach)) {
            QCOMPARE(itself.face, Mesh::none);
            QVERIFY(Real(itself.lower) <= truth
                    && Real(itself.lower) >= truth - Real(errorOfFaceDistances * reach) * 2);
        }
    }
}

void TestFaceLanes::waysToFacesAreAsOneByOne_data()
{
    addShapes();
}

/// Never more, and for most hardly less.
void TestFaceLanes::waysToFacesAreAsOneByOne()
{
    QFETCH(const Shape, shape);
    Draw draw(6);
    std::mt19937_64 random(seed(6));
    int tight = 0;
    int loose = 0;
    for (int i = 0; i < 500; ++i) {
        const SweptMesh swept(shape, draw, random);
        const Mesh mesh = meshOf(swept.triangles);
        const std::vector<CornerLanes> corners = cornersOf(mesh);
        std::vector<FaceLanes> faces(corners.size());
        placeFaces(corners, {}, faces.data());
        std::vector<double> ways(faces.size() * laneCount);
        waysToFaces(faces, swept.start, swept.sphere, 0.0, infinity, ways.data());
        for (std::size_t k = 0; k < swept.triangles.size(); ++k) {
            QVERIFY(ways[k] >= 0.0);
            QVERIFY(ways[k] <= swept.wayTo(k, -1e-13 * swept.reach));
            if (faces[k / laneCount].isPlain[k % laneCount] != 0.0) {
                ++(ways[k] >= swept.wayTo(k, 0.01 * swept.sphere.radius + 1e-13 * swept.reach) ? tight : loose);
            }
        }
    }
    QVERIFY2(tight > 1'000 && loose * 20 < tight, qPrintable(QStringLiteral("%1 %2").arg(tight).arg(loose)));
}

void TestFaceLanes::theFirstFaceThatIsTouchedIsFound_data()
{
    addShapes();
}

/// Beside every face by itself; also as a map places it, and from a way on.
void TestFaceLanes::theFirstFaceThatIsTouchedIsFound()
{
    QFETCH(const Shape, shape);
    Draw draw(7);
    std::mt19937_64 random(seed(7));
    int touched = 0;
    for (int i = 0; i < 500; ++i) {
        const SweptMesh swept(shape, draw, random);
        const Mesh mesh = meshOf(swept.triangles);
        const LeafFaces faces(mesh);
        double sooner = infinity;
        double later = infinity;
        for (std::size_t k = 0; k < swept.triangles.size(); ++k) {
            sooner = std::min(sooner, swept.wayTo(k, 1e-13 * swept.reach));
            later = std::min(later, swept.wayTo(k, -1e-13 * swept.reach));
        }
        const double slack = 1e-5 * swept.sphere.radius;
        const double limit = i % 2 == 0 ? infinity : 2.0 * swept.reach;
        const double from = i % 3 == 0 || sooner == infinity ? 0.0 : 0.9 * sooner;
        SweptFace itself;
        SweptFace placed;
        faces.sweep(swept.start, swept.sphere, from, limit, slack, itself);
        faces.sweep({glm::dmat3(1.0), -swept.start}, swept.sphere, from, limit, slack, placed);
        for (const SweptFace &found : {itself, placed}) {
            QCOMPARE(found.faceTests, swept.triangles.size());
            QVERIFY(found.lower <= std::max(later, from));
            if (found.face == Mesh::none) {
                QVERIFY(later > limit || later == infinity);
            } else {
                ++touched;
                QVERIFY(found.way >= sooner && found.way <= later + slack);
                QVERIFY(found.lower >= sooner - slack);
                QCOMPARE(found.triangle, seenFrom(swept.start, swept.triangles[found.face]));
            }
        }
    }
    QVERIFY2(touched > 300, qPrintable(QString::number(touched)));
}

ROMANESCO_TEST(TestFaceLanes)

}

#include "testfacelanes.moc"
