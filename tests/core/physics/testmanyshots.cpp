// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include <QTest>

#include "tests/core/physics/shots.h"
#include "tests/testmain.h"

namespace romanesco::test {

class TestManyShots : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void noneOfAHundredThousandGoesThrough_data();
    void noneOfAHundredThousandGoesThrough();
};

void TestManyShots::noneOfAHundredThousandGoesThrough_data()
{
    addTargets();
}

void TestManyShots::noneOfAHundredThousandGoesThrough()
{
    QFETCH(const std::vector<SceneItem>, items);
    shoot(items, 17'000, 2);
}

}

ROMANESCO_TEST(romanesco::test::TestManyShots)

#include "testmanyshots.moc"
