// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "core/collide/facelanes.h"

#include <numeric>

#include "core/collide/leaffaces.h"
#include "tests/core/collide/bruteforce.h"
#include "tests/core/collide/instructionsets.h"
#include "tests/core/geometry/triangles.h"
#include "tests/testmain.h"

namespace romanesco::test {

namespace {

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
    std::mt19937_64 random(4);
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
    std::mt19937_64 random(5);
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

ROMANESCO_TEST(TestFaceLanes)

}

#include "testfacelanes.moc"
