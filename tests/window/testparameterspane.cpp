// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#include <QApplication>
#include <QLabel>
#include <QSlider>
#include <QTest>
#include <QToolButton>

#include "app/window/parameterspane.h"
#include "editor/fdoeditor.h"
#include "editor/pinnednumbers.h"

using namespace romanesco;

namespace {

struct Sample {
    FdoEditor editor;
    ParametersPane pane;

    explicit Sample(const QString &text)
    {
        editor.setFileName(QStringLiteral("a.fdo"));
        editor.setPlainText(text);
        pane.follow(editor);
    }
    [[nodiscard]] QList<QSlider *> sliders() const
    {
        // Not those of scroll bars.
        return pane.widget()->findChildren<QSlider *>();
    }
    [[nodiscard]] QStringList names() const
    {
        QStringList found;
        for (const QSlider *slider : sliders()) {
            found << slider->accessibleName();
        }
        return found;
    }
    void type(const QString &before, const QString &after)
    {
        editor.setTextCursor(editor.document()->find(before));
        editor.insertPlainText(after);
        pane.update();
    }
};

const QString text = QStringLiteral("x. \"a.obj\"\nt.p. (p, #, #)\nz<x>. [t.1] x\ny<x>. [t.1] z 3\n<$>. y 12\n");

}

/// A slider for each number of iterations.
class TestParametersPane : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void eachNumberHasASlider();
    void aDragIsOneStepBack();
    void slidersFollowTheText();
    void whatCannotBeEditedDoesNotMove();
    void anotherTextHasItsOwn();
    void pinnedNumbersHaveSlidersToo();
    void aDragOfAPinIsOneStepBack();
};

void TestParametersPane::eachNumberHasASlider()
{
    const Sample sample(text);
    QCOMPARE(sample.names(), QStringList({QStringLiteral("z"), QStringLiteral("y")}));
    QCOMPARE(sample.sliders()[0]->value(), 3);
    QCOMPARE(sample.sliders()[1]->value(), 12);
    const Sample scene(QStringLiteral("x. \"a.obj\"\n"));
    QVERIFY(scene.names().isEmpty());
}

void TestParametersPane::aDragIsOneStepBack()
{
    Sample sample(text);
    QSlider *slider = sample.sliders()[0];
    slider->setSliderDown(true);
    for (const int value : {4, 11, 7}) {
        slider->setValue(value);
        sample.pane.update(); // as the preview asks for
        QCOMPARE(sample.sliders()[0], slider);
    }
    slider->setSliderDown(false);
    QVERIFY(sample.editor.toPlainText().contains(QStringLiteral("z 7\n<$>. y 12")));
    sample.editor.undo();
    QCOMPARE(sample.editor.toPlainText(), text);
    sample.pane.update();
    QCOMPARE(sample.sliders()[0]->value(), 3);
}

void TestParametersPane::slidersFollowTheText()
{
    Sample sample(text);
    sample.type(QStringLiteral("12"), QStringLiteral("5"));
    QCOMPARE(sample.sliders()[1]->value(), 5);
    // Above, so that all that follows moves.
    sample.type(QStringLiteral("x. "), QStringLiteral("# more\nx. "));
    sample.sliders()[1]->setValue(6);
    QVERIFY(sample.editor.toPlainText().endsWith(QStringLiteral("<$>. y 6\n")));
    sample.type(QStringLiteral(" z 3"), QStringLiteral(" x"));
    QCOMPARE(sample.names(), QStringList({QStringLiteral("y")}));
    sample.sliders()[0]->setValue(4);
    QVERIFY(sample.editor.toPlainText().endsWith(QStringLiteral("<$>. y 4\n")));
}

void TestParametersPane::whatCannotBeEditedDoesNotMove()
{
    Sample sample(text);
    sample.editor.setReadOnly(true);
    sample.pane.update();
    QVERIFY(!sample.sliders()[0]->isEnabled());
}

void TestParametersPane::anotherTextHasItsOwn()
{
    Sample sample(text);
    FdoEditor other;
    other.setFileName(QStringLiteral("b.fdo"));
    other.setPlainText(QStringLiteral("x. \"a.obj\"\nt.p. (p, #, #)\nw<x>. [t.1] x\n<$>. w 2\n"));
    sample.pane.follow(other);
    QCOMPARE(sample.names(), QStringList({QStringLiteral("w")}));
    sample.sliders()[0]->setValue(9);
    QVERIFY(other.toPlainText().endsWith(QStringLiteral("w 9\n")));
    QCOMPARE(sample.editor.toPlainText(), text);
}

void TestParametersPane::pinnedNumbersHaveSlidersToo()
{
    Sample sample(QStringLiteral("half 0.50 1 2\n") + text);
    QVERIFY(sample.editor.pinnedNumbers().pin(5));
    QCOMPARE(sample.names(), QStringList({QStringLiteral("z"), QStringLiteral("y"), QStringLiteral("half (line 1)")}));
    QSlider *slider = sample.sliders()[2];
    QTest::keyClick(slider, Qt::Key_Right);
    QTest::keyClick(slider, Qt::Key_Right);
    QVERIFY(sample.editor.toPlainText().startsWith(QStringLiteral("half 0.52 1 2\n")));
    QCOMPARE(slider->value(), 0);
    // Further rows come between them.
    sample.type(QStringLiteral("half"), QStringLiteral("# more\nhalf"));
    QCOMPARE(sample.names().last(), QStringLiteral("half (line 2)"));
    auto *unpin = sample.pane.widget()->findChild<QToolButton *>();
    QVERIFY(unpin);
    QTest::mouseClick(unpin, Qt::LeftButton);
    QCOMPARE(sample.names(), QStringList({QStringLiteral("z"), QStringLiteral("y")}));
}

void TestParametersPane::aDragOfAPinIsOneStepBack()
{
    const QString before = QStringLiteral("half 0.50 1 2\n") + text;
    Sample sample(before);
    QVERIFY(sample.editor.pinnedNumbers().pin(5));
    QSlider *slider = sample.sliders()[2];
    slider->setSliderDown(true);
    for (const int steps : {4, 60, 7}) {
        slider->setSliderPosition(steps);
        sample.pane.update(); // as the preview asks for
        QCOMPARE(slider->value(), steps);
    }
    slider->setSliderDown(false);
    QVERIFY(sample.editor.toPlainText().startsWith(QStringLiteral("half 0.57 1 2\n")));
    QCOMPARE(slider->value(), 0);
    sample.editor.undo();
    QCOMPARE(sample.editor.toPlainText(), before);
    // Of another text they are not.
    FdoEditor other;
    sample.pane.follow(other);
    QVERIFY(sample.names().isEmpty());
    sample.pane.follow(sample.editor);
    QCOMPARE(sample.names().size(), 3);
}

QTEST_MAIN(TestParametersPane)
#include "testparameterspane.moc"
