// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#include <QApplication>
#include <QDockWidget>
#include <QMainWindow>
#include <QTest>

#include "app/window/windowstyle.h"

using namespace romanesco;

namespace {

/// Counts what it is asked for.
class CountingStyle : public QProxyStyle
{
public:
    [[nodiscard]] QIcon standardIcon(StandardPixmap icon, const QStyleOption *option,
                                     const QWidget *widget) const override
    {
        ++asked;
        return QProxyStyle::standardIcon(icon, option, widget);
    }

    mutable int asked = 0;
};

}

class TestWindowStyle : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void docksAskTheSystemOnce();
    void otherColoursAreAskedForAnew();
};

void TestWindowStyle::docksAskTheSystemOnce()
{
    auto *counting = new CountingStyle;
    auto *style = new WindowStyle(counting);
    QApplication::setStyle(style);
    QMainWindow window;
    for (int i = 0; i < 5; ++i) {
        window.addDockWidget(Qt::BottomDockWidgetArea, new QDockWidget(QString::number(i), &window));
    }
    window.show();
    QVERIFY(QTest::qWaitForWindowExposed(&window));
    QVERIFY2(counting->asked <= 4, qPrintable(QString::number(counting->asked)));
    QVERIFY(!style->standardIcon(QStyle::SP_TitleBarCloseButton, nullptr, nullptr).isNull());
}

void TestWindowStyle::otherColoursAreAskedForAnew()
{
    auto *counting = new CountingStyle;
    WindowStyle style(counting);
    const auto ask = [&] { (void)style.standardIcon(QStyle::SP_TitleBarCloseButton, nullptr, nullptr); };
    ask();
    ask();
    QCOMPARE(counting->asked, 1);
    QPalette palette;
    style.polish(palette);
    ask();
    QCOMPARE(counting->asked, 2);
}

QTEST_MAIN(TestWindowStyle)
#include "testwindowstyle.moc"
