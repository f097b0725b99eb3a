// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include <cmath>
#include <set>

#include <QTest>

#include "drawing.h"
#include "tests/testmain.h"

using namespace romanesco;
using namespace romanesco::test;

namespace {

constexpr int side = 100;

int brightness(const Pixel &p)
{
    return p[0] + p[1] + p[2];
}

std::size_t distinctColours(const Picture &picture)
{
    std::set<Pixel> colours;
    for (std::size_t i = 0; i < std::size_t(side) * side; ++i) {
        colours.insert(pixel(picture, i));
    }
    return colours.size();
}

/// Four pixels: red and green above blue and white.
std::expected<Image, std::string> decodeFour(const std::string &bytes)
{
    if (bytes != "four") {
        return std::unexpected("no picture");
    }
    return Image{2, 2, {255, 0, 0, 255, 0, 255, 0, 255, 0, 0, 255, 255, 255, 255, 255, 255}};
}

/// Two unit squares in the plane z = 0: x from -1 to 0 and from 0 to 1, y from 0 to 1.
const std::string squares = "v -1 0 0\nv 0 0 0\nv 1 0 0\nv -1 1 0\nv 0 1 0\nv 1 1 0\n";

/// Both squares fill the lower half of the view, 2 units high and wide, that is looked at along z.
View viewOfSquares()
{
    View view;
    view.camera.position = {0, 0, -5};
    view.camera.projection = Projection::Orthographic;
    view.camera.viewHeight = 2;
    view.width = side;
    view.height = side;
    view.backgroundTop = {0, 0, 0};
    view.backgroundBottom = {0, 0, 0};
    view.appearance.isLit = false;
    return view;
}

std::shared_ptr<const Scene> sceneOfObj(const std::string &obj, const std::string &mtl = {})
{
    TableFiles files;
    files.files = {{"m.obj", obj}, {"m.mtl", mtl}, {"four.png", "four"}};
    return SceneLoader(files, decodeFour).load("m.obj", obj).scene;
}

/// An octahedron with an .sdo line more.
std::shared_ptr<const Scene> sceneWith(const std::string &obj, const std::string &lines)
{
    TableFiles files;
    files.files = {{"m.obj", obj}};
    return SceneLoader(files).load("s.sdo", lines).scene;
}

const std::string octahedron = "v 1 0 0\nv -1 0 0\nv 0 1 0\nv 0 -1 0\nv 0 0 1\nv 0 0 -1\n";
const std::string octahedronFaces = "f 1 3 6\nf 6 3 2\nf 2 3 5\nf 5 3 1\nf 6 4 1\nf 2 4 6\nf 5 4 2\nf 1 4 5\n";

}

/// What surfaces look like.
class TestSurfaces : public DrawingTest
{
    Q_OBJECT

private Q_SLOTS:
    void facesHaveTheColoursOfTheirMaterials();
    void verticesMayHaveColours();
    void texturesLieAsTheirCoordinatesSay();
    void texturesMayBeLeftOut();
    void whatIsSeeThroughShowsWhatIsBehind();
    void lightsShineFromTheirPlaces();
    void smoothSurfacesAreRound();
    void mirroredCopiesAreLitAlike();
    void normalsFollowUnevenScales();
    void wiresAreDrawnAlongEdges();
    void selectedCopiesStandOut();
    void branchesHaveColoursOfTheirOwn();
};

void TestSurfaces::facesHaveTheColoursOfTheirMaterials()
{
    const auto scene = sceneOfObj("mtllib m.mtl\n" + squares + "usemtl b\nf 1 2 5 4\nusemtl r\nf 2 3 6 5\n",
                                  "newmtl r\nKd 1 0 0\nnewmtl b\nKd 0 0 1\nKe 0 1 0\n");
    const Picture picture = draw(scene, viewOfSquares());
    QCOMPARE(pixel(picture, 25, 25), (Pixel{0, 255, 255}));
    QCOMPARE(pixel(picture, 75, 25), (Pixel{255, 0, 0}));
    QCOMPARE(pixel(picture, 50, 75), (Pixel{0, 0, 0}));
}

void TestSurfaces::verticesMayHaveColours()
{
    const auto scene = sceneOfObj("v -1 0 0 1 0 0\nv 1 0 0 0 1 0\nv 1 1 0 0 1 0\nv -1 1 0 1 0 0\nf 1 2 3 4\n");
    const Picture picture = draw(scene, viewOfSquares());
    QVERIFY(areNear(pixel(picture, 1, 25), {255, 0, 0}, 40));
    QVERIFY(areNear(pixel(picture, 98, 25), {0, 255, 0}, 40));
    QVERIFY(areNear(pixel(picture, 50, 25), {188, 188, 0}, 3)); // half of each, in linear light
}

void TestSurfaces::texturesLieAsTheirCoordinatesSay()
{
    const auto scene =
        sceneOfObj("mtllib m.mtl\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n" + squares + "usemtl t\nf 1/1 3/2 6/3 4/4\n",
                   "newmtl t\nKd 1 1 1\nmap_Kd four.png\n");
    const Picture picture = draw(scene, viewOfSquares());
    // Where the middles of the image's pixels lie: nothing is mixed there.
    QVERIFY(areNear(pixel(picture, 25, 12), {255, 0, 0}, 40));
    QVERIFY(areNear(pixel(picture, 74, 12), {0, 255, 0}, 40));
    QVERIFY(areNear(pixel(picture, 25, 37), {0, 0, 255}, 40));
    QVERIFY(areNear(pixel(picture, 74, 37), {255, 255, 255}, 40));
}

void TestSurfaces::texturesMayBeLeftOut()
{
    const auto scene =
        sceneOfObj("mtllib m.mtl\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n" + squares + "usemtl t\nf 1/1 3/2 6/3 4/4\n",
                   "newmtl t\nKd 1 0 1\nmap_Kd four.png\n");
    View view = viewOfSquares();
    view.appearance.hasTextures = false;
    QCOMPARE(pixel(draw(scene, view), 87, 6), (Pixel{255, 0, 255}));
}

void TestSurfaces::whatIsSeeThroughShowsWhatIsBehind()
{
    const std::string behind = "v -1 0 1\nv 1 0 1\nv 1 1 1\nv -1 1 1\n";
    const auto scene =
        sceneOfObj("mtllib m.mtl\n" + squares + behind + "usemtl glass\nf 1 2 5 4\nusemtl none\nf 2 3 6 5\n"
                       + "usemtl wall\nf 7 8 9 10\n",
                   "newmtl glass\nKd 1 0 0\nd 0.25\nnewmtl none\nKd 1 0 0\nd 0\nnewmtl wall\nKd 0 0 1\n");
    View view = viewOfSquares();
    view.samples = 512;
    const Picture picture = draw(scene, view);
    QCOMPARE(pixel(picture, 75, 25), (Pixel{0, 0, 255}));
    // A quarter of red over three quarters of blue in linear light, within four standard deviations of 512 samples.
    QVERIFY2(areNear(pixel(picture, 25, 25), {137, 0, 225}, 24), "a quarter of red");
    QVERIFY(draw(scene, view).pixels == picture.pixels);
}

void TestSurfaces::lightsShineFromTheirPlaces()
{
    View view = viewOfSquares();
    view.camera.viewHeight = 3;
    view.appearance.isLit = true;
    const std::string obj = octahedron + octahedronFaces;
    view.camera.position.x = 100;
    const std::string there = "o \"m.obj\" ((100, 0, 0), #, #)\n";
    const auto fromLeft = draw(sceneWith(obj, there + "l (50, 0, -50) (0, 1, 0)\n"), view);
    const auto fromRight = draw(sceneWith(obj, there + "l (150, 0, -50) (0, 1, 0)\n"), view);
    const auto left = [](const Picture &picture) { return pixel(picture, 42, 42); };
    const auto right = [](const Picture &picture) { return pixel(picture, 57, 42); };
    QVERIFY(left(fromLeft)[1] > right(fromLeft)[1] + 40);
    QVERIFY(right(fromRight)[1] > left(fromRight)[1] + 40);
    QVERIFY2(left(fromLeft)[0] < 120, "a green light lends no red");
}

void TestSurfaces::smoothSurfacesAreRound()
{
    View view = viewOfSquares();
    view.camera.viewHeight = 3;
    view.appearance.isLit = true;
    const auto flat = sceneOfObj(octahedron + octahedronFaces);
    const auto smooth = sceneOfObj(octahedron + "s 1\n" + octahedronFaces);
    std::string normals;
    for (const char *normal : {"1 0 0", "-1 0 0", "0 1 0", "0 -1 0", "0 0 1", "0 0 -1"}) {
        normals += "vn " + std::string(normal) + "\n";
    }
    std::string faces;
    for (const char *face : {"1//1 3//3 6//6", "6//6 3//3 2//2", "2//2 3//3 5//5", "5//5 3//3 1//1", "6//6 4//4 1//1",
                             "2//2 4//4 6//6", "5//5 4//4 2//2", "1//1 4//4 5//5"}) {
        faces += "f " + std::string(face) + "\n";
    }
    const auto withNormals = sceneOfObj(octahedron + normals + faces);
    const Picture picture = draw(smooth, view);
    QVERIFY(distinctColours(draw(flat, view)) < 200); // four planes, each with its highlight
    QVERIFY(distinctColours(picture) > 500);
    QVERIFY2(draw(withNormals, view).pixels == picture.pixels, "those of the group are the same by symmetry");
    view.appearance.isSmooth = false;
    QVERIFY(draw(smooth, view).pixels == draw(flat, view).pixels);
}

void TestSurfaces::mirroredCopiesAreLitAlike()
{
    View view = viewOfSquares();
    view.camera.viewHeight = 3;
    view.appearance.isLit = true;
    for (const std::string smoothing : {"", "s 1\n"}) {
        const std::string obj = octahedron + smoothing + octahedronFaces;
        const Picture plain = draw(sceneWith(obj, "o \"m.obj\" #\n"), view);
        const Picture mirrored = draw(sceneWith(obj, "o \"m.obj\" (#, #, (-1, 1, 1))\n"), view);
        const double different = shareOfDifferent(plain, mirrored, 3);
        QVERIFY2(different < 3e-3, qPrintable(QString::number(different))); // along edges, where the order decides
    }
}

/// A sphere that is pressed flat towards the viewer faces the viewer nearly everywhere.
void TestSurfaces::normalsFollowUnevenScales()
{
    View view = viewOfSquares();
    view.camera.viewHeight = 3;
    view.appearance.isLit = true;
    const std::string obj = octahedron + "s 1\n" + octahedronFaces;
    const std::string light = "l (0, 0, -1000) (1, 1, 1)\n";
    const Picture round = draw(sceneWith(obj, "o \"m.obj\" #\n" + light), view);
    const Picture flat = draw(sceneWith(obj, "o \"m.obj\" (#, #, (1, 1, 0.01))\n" + light), view);
    QVERIFY(brightness(pixel(flat, 70, 50)) > brightness(pixel(round, 70, 50)) + 40);
    QVERIFY(std::abs(brightness(pixel(flat, 50, 50)) - brightness(pixel(round, 50, 50))) < 20);
}

void TestSurfaces::wiresAreDrawnAlongEdges()
{
    const auto scene = sceneOfObj(squares + "f 1 2 5 4\nf 2 3 6 5\n");
    View view = viewOfSquares();
    view.samples = 16;
    const Picture plain = draw(scene, view);
    view.appearance.hasWires = true;
    const Picture wired = draw(scene, view);
    QVERIFY(brightness(pixel(wired, 50, 25)) < brightness(pixel(plain, 50, 25)) * 0.85); // the edge between them
    QVERIFY(brightness(pixel(wired, 0, 25)) < brightness(pixel(plain, 0, 25)));
    QCOMPARE(pixel(wired, 15, 12), pixel(plain, 15, 12));
    // What is but a few pixels large would be nothing but wires.
    view.camera.viewHeight = 200;
    const Picture tiny = draw(scene, view);
    view.appearance.hasWires = false;
    QVERIFY(tiny.pixels == draw(scene, view).pixels);
}

void TestSurfaces::selectedCopiesStandOut()
{
    // Four cubes in a row, the second word of two picks each.
    const auto scene = sceneOf("v -4 0 0\nv 4 0 0\nv -2 0 0\nv 2 0 0\nx. \"box.obj\"\na.p. (p, #, #)\n"
                               "y. [a.3, a.4] x\nz. [a.1, a.2] y\n<$>. z\n");
    View view = viewOfSquares();
    view.camera.viewHeight = 14;
    const auto at = [](double x) { return static_cast<int>(std::lround((x / 14 + 0.5) * side)); };
    const Picture plain = draw(scene, view);
    view.appearance.colours.selection = Selection{0, {{1, 1}}};
    const Picture selected = draw(scene, view);
    for (const double x : {-6.0, -2.0}) {
        QCOMPARE(pixel(selected, at(x), 50), pixel(plain, at(x), 50));
    }
    for (const double x : {2.0, 6.0}) {
        QVERIFY(pixel(selected, at(x), 50)[2] > pixel(plain, at(x), 50)[2] + 30);
    }
    view.appearance.colours.selection = Selection{0, {{1, 1}, {0, 0}}};
    const Picture one = draw(scene, view);
    QCOMPARE(pixel(one, at(2), 50), pixel(selected, at(2), 50));
    QCOMPARE(pixel(one, at(6), 50), pixel(plain, at(6), 50));
    view.appearance.colours.selection = Selection{1, {}};
    QVERIFY2(draw(scene, view).pixels == plain.pixels, "of another item");
    // Of each pair the one that a map of the inner set makes.
    view.appearance.colours.selection.reset();
    view.appearance.colours.map = MapSelection{0, {0, 1}};
    const Picture made = draw(scene, view);
    for (const double x : {-6.0, 2.0}) {
        QCOMPARE(pixel(made, at(x), 50), pixel(plain, at(x), 50));
    }
    for (const double x : {-2.0, 6.0}) {
        QVERIFY(pixel(made, at(x), 50)[0] > pixel(plain, at(x), 50)[0] + 20);
    }
    view.appearance.colours.map->item = 1;
    QVERIFY2(draw(scene, view).pixels == plain.pixels, "of another item");
}

void TestSurfaces::branchesHaveColoursOfTheirOwn()
{
    const auto scene = sceneOf("v -4 0 0\nv 4 0 0\nh 0.4 0.4 0.4\nx. \"box.obj\"\na.p. (p, #, h)\n"
                               "z<x>. [a.1, a.2] x\n<$>. z 2\n");
    View view = viewOfSquares();
    view.camera.viewHeight = 14;
    const auto at = [](double x) { return static_cast<int>(std::lround((x / 14 + 0.5) * side)); };
    const auto colour = [&](Colouring colouring, double x) {
        view.appearance.colours.colouring = colouring;
        return pixel(draw(scene, view), at(x), 50);
    };
    QCOMPARE(colour(Colouring::Branch, -5.6), colour(Colouring::Branch, -2.4));
    QVERIFY(!areNear(colour(Colouring::Branch, -5.6), colour(Colouring::Branch, 5.6), 40));
    for (const Colouring same : {Colouring::Depth, Colouring::Set}) {
        QCOMPARE(colour(same, -5.6), colour(same, 5.6));
        QVERIFY(!areNear(colour(same, -5.6), colour(Colouring::Materials, -5.6), 40));
    }
}

ROMANESCO_TEST(TestSurfaces)
#include "testsurfaces.moc"
