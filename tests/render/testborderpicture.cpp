// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include <algorithm>
#include <array>
#include <cmath>
#include <format>
#include <map>
#include <string>
#include <vector>

#include <QTest>
#include <glm/geometric.hpp>

#include "drawing.h"
#include "tests/testmain.h"

using namespace romanesco;
using namespace romanesco::test;

namespace {

/// A way down along a border between two parts of the whole, and what is at the border near its end.
struct Border {
    std::shared_ptr<const Scene> scene;
    std::vector<std::uint32_t> path;
    /// The first map on the other side.
    std::uint32_t across;
    glm::dvec3 place;
};

/// Two of four tetrahedra touch at one corner.
Border tetrahedra(std::size_t depth)
{
    Border border{example("sierpinski.fdo", "300"), std::vector<std::uint32_t>(depth, 1), 1, {1, 0, 0.57736}};
    border.path[0] = 0;
    return border;
}

/// 4 by 4 by 4 boxes but for the middles of the sides and the inside. On top, along the plane between two of them.
Border boxes(std::size_t depth)
{
    std::string text = "x. \"box.obj\"\ns 0.25 0.25 0.25\n";
    std::string names;
    std::map<std::array<int, 3>, std::uint32_t> number;
    for (int i = 0; i < 64; ++i) {
        const std::array cell{i % 4, i / 4 % 4, i / 16};
        if (std::ranges::count_if(cell, [](int x) { return x == 1 || x == 2; }) < 2) {
            const std::size_t n = number.size();
            number[cell] = static_cast<std::uint32_t>(n);
            text += std::format("v{} {} {} {}\nm{}. (v{}, #, s)\n", n, 0.75 * cell[0], 0.75 * cell[1], 0.75 * cell[2],
                                n, n);
            names += std::format("{}m{}", n ? ", " : "", n);
        }
    }
    text += std::format("z<x>. [{}] x\n<$>. z 300\n", names);
    Border border{sceneOf(text, boxObj({0, 0, 0}, {3, 3, 3})),
                  {number.at({0, 3, 0})},
                  number.at({1, 3, 0}),
                  {3, 3, 1.5}};
    while (border.path.size() + 4 < depth) {
        border.path.push_back(number.at({3, 3, static_cast<int>(border.path.size() % 3)}));
    }
    for (const int z : {1, 2, 1, 3}) {
        border.path.push_back(number.at({3, 3, z}));
    }
    return border;
}

}

/// What is on the other side of a border, far down.
class TestBorderPicture : public DrawingTest
{
    Q_OBJECT

private Q_SLOTS:
    void bothSidesLookTheSameAtAnyDepth_data();
    void bothSidesLookTheSameAtAnyDepth();

private:
    [[nodiscard]] Picture pictureOf(const Border &border, bool isSelected);

    /// From five levels down; by whether it is of a point, and whether something is selected.
    std::map<std::pair<bool, bool>, Picture> m_nearTop;
};

Picture TestBorderPicture::pictureOf(const Border &border, bool isSelected)
{
    Anchor anchor(border.scene);
    bool isThere = anchor.enter({0, 0});
    for (const std::uint32_t map : border.path) {
        isThere = isThere && anchor.enter({0, map});
    }
    Camera camera;
    camera.position = border.place + glm::dvec3(0.2, 4, -0.8);
    camera.worldFromCamera = rotationLooking(border.place - camera.position, {0, 0, 1});
    View view = plainView(camera);
    view.surroundings = anchor.surroundings();
    if (isSelected) {
        view.appearance.colours.selection = Selection{0, {{0, border.across}}};
    }
    return isThere ? draw(border.scene, view) : Picture{};
}

void TestBorderPicture::bothSidesLookTheSameAtAnyDepth_data()
{
    QTest::addColumn<bool>("isPoint");
    QTest::addColumn<int>("depth");
    for (const int depth : {40, 200, 280}) {
        QTest::addRow("point, %d", depth) << true << depth;
        QTest::addRow("plane, %d", depth) << false << depth;
    }
}

/// As from five levels down, where all of the whole is at hand; a selection of the other side too.
void TestBorderPicture::bothSidesLookTheSameAtAnyDepth()
{
    QFETCH(const bool, isPoint);
    QFETCH(const int, depth);
    const auto border = isPoint ? tetrahedra : boxes;
    Picture plain;
    for (const bool isSelected : {false, true}) {
        Picture &expected = m_nearTop[{isPoint, isSelected}];
        if (expected.pixels.empty()) {
            expected = pictureOf(border(5), isSelected);
        }
        const Picture found = pictureOf(border(static_cast<std::size_t>(depth)), isSelected);
        const auto isSeen = [&](std::size_t i) { return !isBackground(pixel(found, i)); };
        const auto isRight = [&](std::size_t i) { return i % width >= width / 2; };
        const double left = share(found, [&](std::size_t i) { return isSeen(i) && !isRight(i); });
        const double right = share(found, [&](std::size_t i) { return isSeen(i) && isRight(i); });
        QVERIFY2(left > 0.03 && right > 0.03, qPrintable(QStringLiteral("%1 %2").arg(left).arg(right)));
        const double off = shareOfDifferent(expected, found);
        QVERIFY2(off < 0.002, qPrintable(QString::number(off)));
        if (isSelected) {
            const double marked = shareOfDifferent(plain, found);
            QVERIFY2(std::abs(marked - right) < 0.01, qPrintable(QStringLiteral("%1 %2").arg(marked).arg(right)));
        }
        plain = found;
    }
}

ROMANESCO_TEST(TestBorderPicture)
#include "testborderpicture.moc"
