// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include <QTest>

#include "tests/core/physics/longer.h"
#include "tests/core/physics/shots.h"
#include "tests/testmain.h"

namespace romanesco::test {

/// Six times as many as one target gets: 1,800, and in the long programme more than a hundred thousand.
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
    shoot(items, 300 * times(), 1);
}

}

ROMANESCO_TEST(romanesco::test::TestShots)

#include "testshots.moc"
