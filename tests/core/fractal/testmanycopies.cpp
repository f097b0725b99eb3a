// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include <QTest>

#include "core/fractal/copies.h"
#include "tests/core/fractal/samples.h"
#include "tests/testmain.h"

namespace romanesco::test {

class TestManyCopies : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void appendixBOfDepthSix();
};

void TestManyCopies::appendixBOfDepthSix()
{
    const Sample appendix = sample(QStringLiteral("appendix-b"), 6);
    CopyWalk copies(appendix.graph);
    quint64 count = 0;
    while (copies.next()) {
        ++count;
    }
    QCOMPARE(count, quint64(172'855'881));
}

}

ROMANESCO_TEST(romanesco::test::TestManyCopies)

#include "testmanycopies.moc"
