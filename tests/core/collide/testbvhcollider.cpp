// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "core/collide/bvhcollider.h"

#include <QTest>

#include "core/collide/simplecollider.h"
#include "core/formats/objreader.h"
#include "tests/core/collide/allocations.h"
#include "tests/core/collide/meshes.h"
#include "tests/core/fractal/samples.h"
#include "tests/core/geometry/wild.h"
#include "tests/testmain.h"

namespace romanesco::test {

namespace {

Mesh example(const char *file)
{
    return readObj(exampleText(QLatin1String(file))).mesh;
}

Mesh meshCalled(const QString &name)
{
    std::mt19937_64 random(seed(7));
    if (name == QLatin1String("cube")) {
        return example("cube.obj");
    }
    if (name == QLatin1String("lighthouse")) {
        return example("lighthouse.obj");
    }
    if (name == QLatin1String("ball")) {
        return ball(24);
    }
    if (name == QLatin1String("plate")) {
        return plate(20);
    }
    if (name == QLatin1String("needles")) {
        return soup(random, 500, 1.0, 1e-7);
    }
    if (name == QLatin1String("segments")) {
        return soup(random, 300, 0.1, 0.0);
    }
    if (name == QLatin1String("points")) {
        return soup(random, 300, 0.0);
    }
    return soup(random, 800, name == QLatin1String("large triangles") ? 1.0 : 0.02);
}

Hit found(const Collider &collider, const Query &query)
{
    Hit hit;
    collider.search()->closest(query, hit);
    return hit;
}

/// In 100 digits.
std::pair<Real, Mesh::Face> nearestFace(const Mesh &mesh, const glm::dvec3 &p)
{
    std::pair<Real, Mesh::Face> nearest(std::numeric_limits<double>::infinity(), {});
    for (const Mesh::Face &face : mesh.faces) {
        const auto corner = [&](std::size_t k) { return exact(mesh.vertices[face[k]]); };
        nearest = std::min(nearest, {truth::distance<Real>({corner(0), corner(1), corner(2)}, exact(p)), face});
    }
    return nearest;
}

/// The mesh, and a few faces more that stand far away.
Mesh withFacesFarAway(const Mesh &mesh, std::mt19937_64 &random)
{
    Mesh more = mesh;
    const Mesh far = soup(random, 50, 1.0);
    const auto before = static_cast<std::uint32_t>(mesh.vertices.size());
    for (const glm::dvec3 &vertex : far.vertices) {
        more.vertices.push_back(1000.0 * vertex + glm::dvec3(0, 5000, 0));
    }
    for (const Mesh::Face &face : far.faces) {
        more.faces.push_back({face[0] + before, face[1] + before, face[2] + before});
    }
    return more;
}

}

class TestBvhCollider : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void nothingIsNearerThanWhatIsFound_data();
    void nothingIsNearerThanWhatIsFound();
    void largeMeshesAreAsTheSimpleColliderHasThem_data();
    void largeMeshesAreAsTheSimpleColliderHasThem();
    void theRadiusEndsTheSearch();
    void aSmallRadiusSavesWork();
    void ofEqualFacesTheFirstIsFound();
    void facesFarAwayChangeNothing();
    void theDirectionIsTheContactNormal();
    void fewFacesAreLookedAt();
    void costsAreCounted();
    void coordinatesMayBeOfAnySize();
    void sizesMayBeMixed();
    void meshesOfAnyShapeAreTaken();
    void meshesWithoutNumbersAreRefused();
    void buildingCanBeStopped();
    void searchesNeverAllocate();
    void memoryIsAsTold();
};

void TestBvhCollider::nothingIsNearerThanWhatIsFound_data()
{
    QTest::addColumn<QString>("name");
    for (const char *name : {"cube", "lighthouse", "ball", "plate", "small triangles", "large triangles", "needles",
                             "segments", "points"}) {
        QTest::newRow(name) << name;
    }
}

void TestBvhCollider::nothingIsNearerThanWhatIsFound()
{
    QFETCH(QString, name);
    const Mesh mesh = meshCalled(name);
    const auto collider = BvhCollider::create(mesh);
    const auto search = collider->search();
    const Places places(mesh);
    std::mt19937_64 random(seed(1));
    Hit hit;
    for (const Place place : {Place::Uniform, Place::Near, Place::OnFaces, Place::AtVertices, Place::Far}) {
        for (int i = 0; i < 20; ++i) {
            const glm::dvec3 p = places(random, place);
            search->closest({p}, hit);
            const Wide truth = distanceToMesh(mesh, p);
            const Wide unit = Wide(largestOffset(mesh, p)) * 0x1p-53;
            QVERIFY(hit.promise == Promise::Exact && hit.address.empty());
            QVERIFY(hit.distance >= truth - 8 * unit && hit.distance <= truth + 64 * unit);
            QVERIFY(hit.lower <= truth && hit.distance - hit.lower <= 64 * unit);
            QVERIFY(distanceToFace(mesh, mesh.faces.at(hit.face), p) <= truth + 64 * unit);
            QVERIFY(abs(glm::distance(hit.point, p) - hit.distance) <= 16 * unit + 1e-15 * glm::length(p));
            QVERIFY(hit.cost.faceTests >= 1 && hit.cost.faceTests <= mesh.faces.size());
        }
    }
}

void TestBvhCollider::largeMeshesAreAsTheSimpleColliderHasThem_data()
{
    QTest::addColumn<QString>("file");
    QTest::newRow("bunny") << "/usr/share/glmark2/models/bunny.obj";
    QTest::newRow("regr01") << "/usr/share/assimp/models/OBJ/regr01.obj";
    QTest::newRow("spider") << "/usr/share/assimp/models/OBJ/spider.obj";
    QTest::newRow("WusonOBJ") << "/usr/share/assimp/models/OBJ/WusonOBJ.obj";
}

void TestBvhCollider::largeMeshesAreAsTheSimpleColliderHasThem()
{
    QFETCH(QString, file);
    QFile source(file);
    QVERIFY2(source.open(QIODevice::ReadOnly), qPrintable(file));
    const Mesh mesh = readObj(source.readAll().toStdString()).mesh;
    const auto collider = BvhCollider::create(mesh);
    const FractalGraph graph = FractalGraph::ofMesh(boundingSphere(mesh));
    const SimpleCollider oracle(graph, mesh);
    const Places places(mesh);
    std::mt19937_64 random(seed(2));
    for (const Place place : {Place::Uniform, Place::Near, Place::OnFaces, Place::AtVertices, Place::Far}) {
        for (int i = 0; i < 5; ++i) {
            const glm::dvec3 p = places(random, place);
            const Hit hit = found(*collider, {p});
            const Hit truth = found(oracle, {p});
            const double unit = largestOffset(mesh, p) * 0x1p-53;
            QVERIFY(std::abs(hit.distance - truth.distance) <= 64 * unit);
            QVERIFY(hit.lower <= truth.distance + 8 * unit && hit.distance - hit.lower <= 64 * unit);
            QVERIFY(hit.cost.faceTests < truth.cost.faceTests / 4);
        }
    }
}

void TestBvhCollider::theRadiusEndsTheSearch()
{
    const Mesh mesh = ball(16);
    const auto collider = BvhCollider::create(mesh);
    const Places places(mesh);
    std::mt19937_64 random(seed(3));
    for (int i = 0; i < 300; ++i) {
        const glm::dvec3 p = places(random, i % 2 == 0 ? Place::Uniform : Place::Near);
        const double least = found(*collider, {p}).distance;
        const double radius = least * std::array{1e-9, 0.5, 0.999999, 1.0, 1.000001, 3.0, 1e9}[random() % 7];
        const Hit hit = found(*collider, {p, radius});
        QCOMPARE(hit.isFound(), least <= radius);
        QVERIFY(hit.lower <= least);
        if (hit.isFound()) {
            QCOMPARE(hit.distance, least);
        } else {
            QVERIFY(hit.lower >= radius * (1 - 1e-15));
        }
    }
}

void TestBvhCollider::aSmallRadiusSavesWork()
{
    const Mesh mesh = ball(40);
    const auto collider = BvhCollider::create(mesh);
    const Hit all = found(*collider, {{0.1, 0.2, 0.3}});
    const Hit none = found(*collider, {{0.1, 0.2, 0.3}, 0.5});
    QVERIFY(!none.isFound());
    QVERIFY(none.cost.nodeVisits * 2 < all.cost.nodeVisits);
    QVERIFY(none.lower >= 0.5 && none.lower <= all.distance);
    const Hit far = found(*collider, {{5, 0, 0}, 1.0});
    QCOMPARE(far.cost.nodeVisits, 0u);
    QVERIFY(far.lower > 3.9 && far.lower <= 4.01);
}

void TestBvhCollider::ofEqualFacesTheFirstIsFound()
{
    std::mt19937_64 random(seed(4));
    Mesh mesh = plate(9);
    const std::vector<Mesh::Face> faces = mesh.faces;
    for (int i = 0; i < 2; ++i) {
        mesh.faces.insert(mesh.faces.end(), faces.begin(), faces.end());
    }
    std::shuffle(mesh.faces.begin(), mesh.faces.end(), random);
    const auto collider = BvhCollider::create(mesh);
    for (int i = 0; i < 200; ++i) {
        // whole and half numbers: corners, edges and middles of squares
        const glm::dvec3 p = 0.5 * glm::dvec3(random() % 24, random() % 5, random() % 24) - glm::dvec3(1.0, 1.0, 1.0);
        const Hit hit = found(*collider, {p});
        const Wide truth = distanceToMesh(mesh, p);
        const auto isNearest = [&](const Mesh::Face &face) { return distanceToFace(mesh, face, p) == truth; };
        const auto first = std::ranges::find_if(mesh.faces, isNearest);
        QCOMPARE(hit.face, static_cast<std::uint32_t>(first - mesh.faces.begin()));
    }
}

void TestBvhCollider::facesFarAwayChangeNothing()
{
    std::mt19937_64 random(seed(5));
    for (const char *name : {"ball", "plate", "cube", "small triangles", "needles"}) {
        const Mesh mesh = meshCalled(QLatin1String(name));
        const Places places(mesh);
        const Mesh more = withFacesFarAway(mesh, random);
        const auto one = BvhCollider::create(mesh);
        const auto other = BvhCollider::create(more);
        for (int i = 0; i < 300; ++i) {
            const auto place = std::array{Place::Uniform, Place::Near, Place::OnFaces, Place::AtVertices}[random() % 4];
            const glm::dvec3 p = places(random, place);
            const Hit hit = found(*one, {p});
            const Hit same = found(*other, {p});
            QCOMPARE(same.face, hit.face);
            QVERIFY(same.distance == hit.distance && same.point == hit.point && same.direction == hit.direction);
        }
    }
}

void TestBvhCollider::theDirectionIsTheContactNormal()
{
    const Mesh triangle{{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}, {{0, 1, 2}}};
    const auto collider = BvhCollider::create(triangle);
    QCOMPARE(found(*collider, {{1, 1, 3}}).direction, glm::dvec3(0, 0, 1));
    QCOMPARE(found(*collider, {{1, 1, -1e-200}}).direction, glm::dvec3(0, 0, -1));
    QCOMPARE(found(*collider, {{1, 1, 0}}).direction, glm::dvec3(0, 0, 1));
    QCOMPARE(found(*collider, {{-2, 0, 0}}).direction, glm::dvec3(-1, 0, 0));
    QCOMPARE(found(*collider, {{1, 1, 0}}).distance, 0.0);
}

void TestBvhCollider::fewFacesAreLookedAt()
{
    const Mesh mesh = ball(60);
    const auto collider = BvhCollider::create(mesh);
    const Places places(mesh);
    std::mt19937_64 random(seed(6));
    // of 7,080; from afar all faces at the near end are about equally far
    for (const auto &[place, most] :
         {std::pair(Place::Uniform, 70), {Place::Near, 8}, {Place::OnFaces, 6}, {Place::Far, 180}}) {
        std::uint64_t faceTests = 0;
        std::uint64_t nodeVisits = 0;
        for (int i = 0; i < 500; ++i) {
            const Hit hit = found(*collider, {places(random, place)});
            faceTests += hit.cost.faceTests;
            nodeVisits += hit.cost.nodeVisits;
        }
        QVERIFY(faceTests < 500u * most);
        QVERIFY(nodeVisits < 500u * (most + 10));
    }
}

void TestBvhCollider::costsAreCounted()
{
    const Mesh one{{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}, {{0, 1, 2}}};
    const auto leaf = BvhCollider::create(one);
    const Hit hit = found(*leaf, {{1, 1, 1}});
    QCOMPARE(hit.cost.faceTests, 1u);
    QCOMPARE(hit.cost.nodeVisits, 1u);
    // two groups of three faces, far apart: the root and a leaf
    Mesh two;
    for (const double x : {0.0, 100.0}) {
        for (int i = 0; i < 3; ++i) {
            const auto first = static_cast<std::uint32_t>(two.vertices.size());
            two.vertices.insert(two.vertices.end(), {{x, i, 0}, {x + 1, i, 0}, {x, i, 1}});
            two.faces.push_back({first, first + 1, first + 2});
        }
    }
    const auto tree = BvhCollider::create(two);
    const Hit nearOne = found(*tree, {{99, 1, 0}});
    QCOMPARE(nearOne.cost.faceTests, 3u);
    QCOMPARE(nearOne.cost.nodeVisits, 2u);
}

void TestBvhCollider::coordinatesMayBeOfAnySize()
{
    std::mt19937_64 random(seed(8));
    const Mesh plain = soup(random, 200, 0.2);
    const auto ofPlain = BvhCollider::create(plain);
    for (const int exponent : {-900, -600, -300, -200, 0, 200, 300, 600, 900, 995}) {
        Mesh mesh = plain;
        for (glm::dvec3 &vertex : mesh.vertices) {
            vertex *= std::ldexp(1.0, exponent);
        }
        const auto collider = BvhCollider::create(mesh);
        QVERIFY(collider.has_value());
        for (int i = 0; i < 20; ++i) {
            const glm::dvec3 p = randomPoint(random, i % 2 == 0 ? 1.0 : 1.99);
            const glm::dvec3 scaled = std::ldexp(1.0, exponent) * p;
            const Hit hit = found(*collider, {scaled});
            const Wide truth = distanceToMesh(mesh, scaled);
            const Wide unit = Wide(largestOffset(mesh, scaled)) * 0x1p-53;
            QVERIFY(abs(hit.distance - truth) <= 64 * unit && hit.lower <= truth);
            QVERIFY(hit.distance - hit.lower <= 64 * unit);
            const SearchCost usual = found(*ofPlain, {p}).cost;
            QVERIFY(hit.cost.faceTests <= usual.faceTests + 4 && hit.cost.nodeVisits <= usual.nodeVisits + 4);
        }
    }
}

void TestBvhCollider::sizesMayBeMixed()
{
    std::mt19937_64 random(seed(9));
    for (int i = 0; i < 40; ++i) {
        // groups of triangles about the origin, each of another size
        Mesh mesh;
        for (const int exponent : {-300, -250, -160, -40, 0, 60, 170, 290}) {
            Mesh group = soup(random, 6, 0.3);
            const auto before = static_cast<std::uint32_t>(mesh.vertices.size());
            for (const glm::dvec3 &vertex : group.vertices) {
                mesh.vertices.push_back(vertex * std::pow(10.0, exponent));
            }
            for (const Mesh::Face &face : group.faces) {
                mesh.faces.push_back({face[0] + before, face[1] + before, face[2] + before});
            }
        }
        const auto collider = BvhCollider::create(mesh);
        for (const int exponent : {-299, -250, -161, -100, -41, 0, 30, 61, 171, 200, 290, 299}) {
            const glm::dvec3 p = std::pow(10.0, exponent) * randomPoint(random, 2.0);
            const Hit hit = found(*collider, {p});
            const auto [truth, nearest] = nearestFace(mesh, p);
            const Mesh ofBoth{mesh.vertices, {mesh.faces.at(hit.face), nearest}};
            const Real unit = Real(largestOffset(ofBoth, p)) * 0x1p-53;
            QVERIFY(Real(hit.lower) <= truth);
            QVERIFY(abs(Real(hit.distance) - truth) <= 128 * unit);
            const Hit again = found(*collider, {p, hit.distance});
            QVERIFY(again.isFound() && again.distance == hit.distance);
            QVERIFY(!found(*collider, {p, hit.lower * 0.999}).isFound() || hit.lower == 0.0);
        }
    }
}

void TestBvhCollider::meshesOfAnyShapeAreTaken()
{
    const Mesh empty{{{1, 2, 3}}, {}};
    const auto nothing = BvhCollider::create(empty);
    QVERIFY(!found(*nothing, {{0, 0, 0}}).isFound());
    QCOMPARE(found(*nothing, {{0, 0, 0}}).lower, std::numeric_limits<double>::infinity());

    Mesh stacked{{{-1, 0, 0}, {1, 0, 0}, {0, 0, 0}}, {}};
    stacked.faces.resize(1000, {0, 1, 2});
    const auto equal = BvhCollider::create(stacked);
    const Hit hit = found(*equal, {{0, 2, 0}});
    QVERIFY(hit.distance == 2.0 && hit.face == 0);

    // ever smaller towards one end: each plane takes few away
    Mesh spiral;
    double x = 1e300;
    for (std::uint32_t i = 0; i < 20'000; ++i, x *= 0.97) {
        spiral.vertices.push_back({x, 0, 0});
        spiral.vertices.push_back({x, 0.01 * x, 0});
        spiral.vertices.push_back({x, 0, 0.01 * x});
        spiral.faces.push_back({3 * i, 3 * i + 1, 3 * i + 2});
    }
    const auto deep = BvhCollider::create(spiral);
    const Hit far = found(*deep, {{1e-9, 1e-9, 0}});
    QVERIFY(far.isFound() && far.cost.faceTests < 500);
}

void TestBvhCollider::meshesWithoutNumbersAreRefused()
{
    for (const double bad : {std::nan(""), std::numeric_limits<double>::infinity(), -2e300}) {
        Mesh mesh = ball(4);
        mesh.vertices[mesh.faces[5][1]].y = bad;
        const auto collider = BvhCollider::create(mesh);
        QVERIFY(!collider && collider.error().contains(std::format("vertex {} ", mesh.faces[5][1] + 1)));
        mesh = ball(4);
        mesh.vertices.push_back({0, bad, 0}); // of no face
        QVERIFY(BvhCollider::create(mesh).has_value());
    }
}

void TestBvhCollider::buildingCanBeStopped()
{
    std::stop_source stop;
    stop.request_stop();
    const Mesh mesh = ball(10);
    const auto collider = BvhCollider::create(mesh, stop.get_token());
    QVERIFY(!collider);
    QCOMPARE(collider.error(), std::string("cancelled"));
}

void TestBvhCollider::searchesNeverAllocate()
{
    std::mt19937_64 random(seed(10));
    for (const char *name : {"ball", "needles", "points"}) {
        const Mesh mesh = meshCalled(QLatin1String(name));
        const auto collider = BvhCollider::create(mesh);
        const auto search = collider->search();
        const Places places(mesh);
        std::vector<glm::dvec3> points;
        for (int i = 0; i < 200; ++i) {
            points.push_back(places(random, i % 2 == 0 ? Place::Uniform : Place::OnFaces));
        }
        Hit hit;
        const std::size_t before = allocationCount();
        for (const glm::dvec3 &p : points) {
            search->closest({p}, hit);
        }
        QCOMPARE(allocationCount(), before);
    }
}

void TestBvhCollider::memoryIsAsTold()
{
    const Mesh mesh = ball(50);
    const std::size_t before = bytesAllocated();
    const auto collider = BvhCollider::create(mesh);
    QCOMPARE(collider->memoryUse() - sizeof(BvhCollider), bytesAllocated() - before);
    QVERIFY(collider->memoryUse() < 50 * mesh.faces.size());
}

}

ROMANESCO_TEST(romanesco::test::TestBvhCollider)

#include "testbvhcollider.moc"
