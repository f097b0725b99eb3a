// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "core/collide/writtenout.h"

#include <set>

#include <QTest>

#include "tests/core/collide/bruteforce.h"
#include "tests/core/fractal/samples.h"
#include "tests/testmain.h"

namespace romanesco::test {

class TestWrittenOut : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void everyFaceOfEveryWordIsThereOnce();
    void verticesThatNoFaceUsesAreLeftOut();
    void tooManyFacesAreRefused();
    void stoppingIsHeard();
};

void TestWrittenOut::everyFaceOfEveryWordIsThereOnce()
{
    std::mt19937_64 random(seed(62));
    for (int round = 0; round < 100; ++round) {
        const RandomFractal sample = randomFractalWithMesh(random, 0.8);
        const AffineMap place = randomMap(random, 2);
        const Mesh all = writtenOut(sample.graph, sample.mesh, place, 1'000'000).value();
        const auto words = naive::allPicks(sample.fractal.levels());
        QCOMPARE(all.faces.size(), words.size() * sample.mesh.faces.size());
        QCOMPARE(faceCount(sample.graph, sample.mesh, 1'000'000).value(), all.faces.size());

        naive::Fractal moved = sample.fractal;
        moved.maps.push_back(place);
        const auto rounded = [](double x, double y, double z) {
            return std::array{std::lround(x * 1e8), std::lround(y * 1e8), std::lround(z * 1e8)};
        };
        std::multiset<std::array<long, 3>> expected;
        for (naive::Picks picks : words) {
            picks.insert(picks.begin(), static_cast<int>(moved.maps.size()) - 1);
            for (const Mesh::Face &face : sample.mesh.faces) {
                truth::Vector<Wide> sum{};
                for (const std::uint32_t corner : face) {
                    const auto vertex = placed(picks, moved.maps, sample.mesh.vertices[corner]);
                    for (std::size_t axis = 0; axis < 3; ++axis) {
                        sum[axis] += vertex[axis];
                    }
                }
                expected.insert(
                    rounded(static_cast<double>(sum[0]), static_cast<double>(sum[1]), static_cast<double>(sum[2])));
            }
        }
        std::multiset<std::array<long, 3>> found;
        for (const Mesh::Face &face : all.faces) {
            const glm::dvec3 sum = all.vertices.at(face[0]) + all.vertices.at(face[1]) + all.vertices.at(face[2]);
            found.insert(rounded(sum.x, sum.y, sum.z));
        }
        // rounding may have parted a few that are half way
        std::size_t missing = 0;
        for (const auto &sum : expected) {
            missing += found.contains(sum) ? 0 : 1;
        }
        QVERIFY(missing <= 2);
    }
}

void TestWrittenOut::verticesThatNoFaceUsesAreLeftOut()
{
    const Mesh mesh{{{9, 9, 9}, {0, 0, 0}, {9, 9, 9}, {1, 0, 0}, {0, 1, 0}}, {{1, 3, 4}, {4, 3, 1}}};
    const Mesh all = writtenOut(FractalGraph::ofMesh(boundingSphere(mesh)), mesh, {}, 2).value();
    QCOMPARE(all.vertices.size(), 3u);
    QVERIFY(all.vertices.at(all.faces.at(1)[1]) == glm::dvec3(1, 0, 0));
}

void TestWrittenOut::tooManyFacesAreRefused()
{
    const Sample menger = sample(QStringLiteral("menger"), 2);
    QCOMPARE(writtenOut(menger.graph, menger.mesh, {}, 4'800).value().faces.size(), 4'800u);
    QCOMPARE(writtenOut(menger.graph, menger.mesh, {}, 4'799).error(),
             std::string("400 copies of 12 faces are too many (at most 4799 faces)"));
}

void TestWrittenOut::stoppingIsHeard()
{
    std::stop_source stop;
    stop.request_stop();
    const Sample menger = sample(QStringLiteral("menger"), 5);
    QCOMPARE(writtenOut(menger.graph, menger.mesh, {}, 100'000'000, stop.get_token()).error(),
             std::string("cancelled"));
}

}

ROMANESCO_TEST(romanesco::test::TestWrittenOut)

#include "testwrittenout.moc"
