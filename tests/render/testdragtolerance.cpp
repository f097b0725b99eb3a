// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "render/dragtolerance.h"
#include <cmath>

#include <QTest>

#include "tests/testmain.h"

using namespace romanesco;

/// Pictures on machines that are made up: milliseconds for each tolerance.
class TestDragTolerance : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void picturesComeInTime_data()
    {
        QTest::addColumn<double>("atOnePixel");
        QTest::addColumn<double>("power");
        QTest::addColumn<double>("least");
        for (const double atOnePixel : {0.1, 20.0, 500.0, 5'000.0, 40'000.0}) {
            for (const double power : {1.0, 2.0, 2.7}) {
                QTest::addRow("%g ms, power %g", atOnePixel, power) << atOnePixel << power << 2.0;
            }
        }
    }

    void picturesComeInTime()
    {
        QFETCH(const double, atOnePixel);
        QFETCH(const double, power);
        QFETCH(const double, least);
        const auto costOf = [&](double pixels) { return least + atOnePixel / std::pow(pixels, power); };
        DragTolerance tolerance;
        double last = 0.0;
        for (int picture = 0; picture < 20; ++picture) {
            for (int tries = 0; tolerance.givesUp(costOf(tolerance.pixels())); ++tries) {
                QVERIFY(tries < 10);
            }
            last = costOf(tolerance.pixels());
            tolerance.finished(last);
        }
        const bool canBeInTime = costOf(DragTolerance::coarsest) < 0.5 * DragTolerance::budgetMilliseconds;
        if (canBeInTime) {
            QVERIFY(costOf(tolerance.pixels()) <= DragTolerance::budgetMilliseconds);
        } else {
            QCOMPARE(tolerance.pixels(), DragTolerance::coarsest);
        }
        // No coarser than it need be.
        QVERIFY(tolerance.pixels() == DragTolerance::finest
                || costOf(tolerance.pixels() / 2.0) > 0.5 * DragTolerance::budgetMilliseconds);
    }

    void aTimeThatHardlyVariesChangesNothing()
    {
        DragTolerance tolerance;
        const double before = tolerance.pixels();
        tolerance.finished(0.75 * DragTolerance::budgetMilliseconds);
        tolerance.finished(0.9 * DragTolerance::budgetMilliseconds);
        QCOMPARE(tolerance.pixels(), before);
        tolerance.finished(0.0);
        QVERIFY(tolerance.pixels() < before);
    }

    /// However far off a picture was: the next may be another.
    void oneStepIsAFactorOfTwoAtMost()
    {
        DragTolerance slow;
        slow.finished(1e6);
        QCOMPARE(slow.pixels(), 2.0 * DragTolerance::first);
        DragTolerance fast;
        fast.finished(0.0);
        QCOMPARE(fast.pixels(), DragTolerance::first / 2.0);
        for (int picture = 0; picture < 10; ++picture) {
            slow.finished(1e6);
            fast.finished(0.0);
        }
        QCOMPARE(slow.pixels(), DragTolerance::coarsest);
        QCOMPARE(fast.pixels(), DragTolerance::finest);
    }

    void onlyWhatIsLateIsGivenUp()
    {
        DragTolerance tolerance;
        QVERIFY(!tolerance.givesUp(DragTolerance::mostMilliseconds));
        QCOMPARE(tolerance.pixels(), DragTolerance::first);
        QVERIFY(tolerance.givesUp(DragTolerance::mostMilliseconds + 1.0));
        QVERIFY(tolerance.pixels() > DragTolerance::first);
        // At the coarsest it takes as long as it takes.
        for (int tries = 0; tolerance.pixels() < DragTolerance::coarsest; ++tries) {
            QVERIFY(tries < 10 && tolerance.givesUp(1e6));
        }
        QVERIFY(!tolerance.givesUp(1e6));
    }
};

ROMANESCO_TEST(TestDragTolerance)
#include "testdragtolerance.moc"
