// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#include <QLabel>

#include "app/window/mainwindow.h"
#include "app/window/messagestrip.h"
#include "app/window/problemsview.h"
#include "app/window/viewportpane.h"
#include "editor/fdoeditor.h"
#include "glapplication.h"

using namespace romanesco;

/// On a platform without OpenGL (Qt's "offscreen") the picture is missing, and nothing else.
class TestWithoutGl : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void theReasonStandsInPlaceOfThePicture();
    void theTextIsChecked();
};

void TestWithoutGl::theReasonStandsInPlaceOfThePicture()
{
    MainWindow window;
    window.openExample();
    window.show();
    const auto &pane = *window.findChild<ViewportPane *>();
    const auto hasReason = [&] {
        const auto labels = pane.findChildren<QLabel *>();
        return std::ranges::any_of(labels, [](const QLabel *label) {
            return label->isVisible() && label->text().contains(QStringLiteral("OpenGL"));
        });
    };
    QVERIFY(QTest::qWaitFor(hasReason));
}

void TestWithoutGl::theTextIsChecked()
{
    MainWindow window;
    window.openExample();
    window.show();
    auto &editor = *window.findChild<FdoEditor *>();
    const auto &problems = *window.findChild<ProblemsView *>();
    QTest::keyClicks(&editor, QStringLiteral("x"));
    QVERIFY(QTest::qWaitFor([&] { return problems.topLevelItemCount() > 0; }, 20'000));
    QVERIFY(QTest::qWaitFor([&] { return window.findChild<ViewportPane *>()->strip().isVisible(); }));
}

int main(int argc, char **argv)
{
    return romanesco::test::runWithGl<TestWithoutGl>(argc, argv);
}
#include "testwithoutgl.moc"
