// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include <QTest>

#include "tests/core/physics/shots.h"
#include "tests/testmain.h"

namespace romanesco::test {

/// Some of the shots of TestManyShots.
class TestShots : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void noneGoesThrough_data();
    void noneGoesThrough();
};

void TestShots::noneGoesThrough_data()
{
    addTargets();
}

void TestShots::noneGoesThrough()
{
    QFETCH(const std::vector<SceneItem>, items);
    shoot(items, 300, 1);
}

}

ROMANESCO_TEST(romanesco::test::TestShots)

#include "testshots.moc"
