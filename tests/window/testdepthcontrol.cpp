// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#include <QLineEdit>
#include <QSignalSpy>
#include <QSlider>
#include <QTest>

#include "app/window/depthcontrol.h"
#include "app/window/wholenumberbox.h"

using namespace romanesco;

namespace {

struct Sample {
    DepthControl control{QStringLiteral("Depth")};
    QSlider &slider = *control.findChild<QSlider *>();
    WholeNumberBox &box = *control.findChild<WholeNumberBox *>();
    QLineEdit &field = *box.findChild<QLineEdit *>();
    QSignalSpy edited{&control, &DepthControl::depthEdited};
};

}

class TestDepthControl : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void showingADepthIsNoEdit();
    void nothingDisables();
    void theSliderReachesBeyondTheDepth_data();
    void theSliderReachesBeyondTheDepth();
    void theSliderEdits();
    void underTheHandTheSliderKeepsItsRange();
    void theBoxTakesAnyDepth();
    void theBoxRefusesWhatIsNoDepth_data();
    void theBoxRefusesWhatIsNoDepth();
    void steppingStopsAtTheEnds();
    void whatIsBeingTypedStays();
};

void TestDepthControl::showingADepthIsNoEdit()
{
    Sample sample;
    sample.control.setDepth(7);
    QCOMPARE(sample.slider.value(), 7);
    QCOMPARE(sample.box.value(), 7u);
    QCOMPARE(sample.edited.count(), 0);
}

void TestDepthControl::nothingDisables()
{
    Sample sample;
    QVERIFY(!sample.control.isEnabled());
    sample.control.setDepth(0);
    QVERIFY(sample.control.isEnabled());
    sample.control.setDepth(std::nullopt);
    QVERIFY(!sample.control.isEnabled());
}

void TestDepthControl::theSliderReachesBeyondTheDepth_data()
{
    QTest::addColumn<qulonglong>("depth");
    QTest::addColumn<int>("reach");
    QTest::addColumn<int>("value");
    QTest::newRow("none") << 0ull << 12 << 0;
    QTest::newRow("small") << 5ull << 12 << 5;
    QTest::newRow("middle") << 20ull << 40 << 20;
    QTest::newRow("large") << 100ull << 120 << 100;
    QTest::newRow("beyond") << 1'000ull << 120 << 120;
    QTest::newRow("greatest") << 0x7fff'ffff'ffff'ffffull << 120 << 120;
}

void TestDepthControl::theSliderReachesBeyondTheDepth()
{
    QFETCH(const qulonglong, depth);
    Sample sample;
    sample.control.setDepth(depth);
    QTEST(sample.slider.maximum(), "reach");
    QTEST(sample.slider.value(), "value");
    QCOMPARE(sample.box.value(), depth);
}

void TestDepthControl::theSliderEdits()
{
    Sample sample;
    sample.control.setDepth(7);
    sample.slider.setValue(9);
    QCOMPARE(sample.edited.count(), 1);
    QCOMPARE(sample.edited.first().first().toULongLong(), 9u);
    QCOMPARE(sample.box.value(), 9u);
}

void TestDepthControl::underTheHandTheSliderKeepsItsRange()
{
    Sample sample;
    sample.control.setDepth(7);
    const int reach = sample.slider.maximum();
    sample.slider.setSliderDown(true);
    sample.slider.setValue(12);
    sample.control.setDepth(12);
    QCOMPARE(sample.slider.maximum(), reach);
    sample.slider.setSliderDown(false);
    sample.control.setDepth(12);
    QCOMPARE(sample.slider.maximum(), 24);
}

void TestDepthControl::theBoxTakesAnyDepth()
{
    Sample sample;
    sample.control.setDepth(7);
    sample.field.selectAll();
    QTest::keyClicks(&sample.box, QStringLiteral("9223372036854775807"));
    QCOMPARE(sample.edited.count(), 0);
    QTest::keyClick(&sample.box, Qt::Key_Return);
    QCOMPARE(sample.edited.count(), 1);
    QCOMPARE(sample.edited.first().first().toULongLong(), 0x7fff'ffff'ffff'ffffull);
}

void TestDepthControl::theBoxRefusesWhatIsNoDepth_data()
{
    QTest::addColumn<QString>("typed");
    QTest::addColumn<QString>("left");
    QTest::newRow("letters") << QStringLiteral("x") << QString();
    QTest::newRow("negative") << QStringLiteral("-3") << QStringLiteral("3");
    QTest::newRow("fraction") << QStringLiteral("1.5") << QStringLiteral("15");
    QTest::newRow("too large") << QStringLiteral("9223372036854775808") << QStringLiteral("922337203685477580");
}

void TestDepthControl::theBoxRefusesWhatIsNoDepth()
{
    QFETCH(const QString, typed);
    Sample sample;
    sample.control.setDepth(7);
    sample.field.clear();
    QTest::keyClicks(&sample.box, typed);
    QTEST(sample.field.text(), "left");
}

void TestDepthControl::steppingStopsAtTheEnds()
{
    Sample sample;
    sample.control.setDepth(1);
    QTest::keyClick(&sample.box, Qt::Key_Down);
    QTest::keyClick(&sample.box, Qt::Key_Down);
    QCOMPARE(sample.box.value(), 0u);
    QCOMPARE(sample.edited.count(), 1);
    sample.control.setDepth(WholeNumberBox::maximum);
    QTest::keyClick(&sample.box, Qt::Key_Up);
    QCOMPARE(sample.box.value(), WholeNumberBox::maximum);
    QTest::keyClick(&sample.box, Qt::Key_Down);
    QCOMPARE(sample.box.value(), WholeNumberBox::maximum - 1);
}

void TestDepthControl::whatIsBeingTypedStays()
{
    Sample sample;
    sample.control.setDepth(7);
    sample.field.selectAll();
    QTest::keyClicks(&sample.box, QStringLiteral("1"));
    sample.control.setDepth(8);
    QCOMPARE(sample.field.text(), QStringLiteral("1"));
}

QTEST_MAIN(TestDepthControl)
#include "testdepthcontrol.moc"
