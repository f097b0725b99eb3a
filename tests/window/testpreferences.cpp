// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QSpinBox>

#include "app/window/preferencesdialog.h"
#include "app/window/texttabs.h"
#include "windowsample.h"

using namespace romanesco;
using Sample = romanesco::test::WindowSample;
using Choice = Preferences::Appearance;

namespace {

int lightness(const QWidget &widget, QPalette::ColorRole role)
{
    return widget.palette().color(role).lightness();
}

/// What most of a widget's picture is coloured in.
QColor ground(QWidget &widget)
{
    const QImage picture = widget.grab().toImage();
    QHash<QRgb, int> counts;
    for (int y = 0; y < picture.height(); y += 3) {
        for (int x = 0; x < picture.width(); x += 3) {
            ++counts[picture.pixel(x, y)];
        }
    }
    const auto most = std::max_element(counts.begin(), counts.end());
    return most.key();
}

}

/// What is chosen once, in its dialog by keys.
class TestPreferences : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void init() { Preferences().write(); }
    void whatIsWrittenIsRead();
    void nonsenseIsAsIfItWereNot_data();
    void nonsenseIsAsIfItWereNot();
    void lightAndDarkAreFollowedByAll();
    void theFontIsThatOfAllTexts();
    void longLinesAreWrappedOrNot();
    void whatWasOpenIsReopenedOrNot();

private:
    static PreferencesDialog *opened(Sample &sample)
    {
        if (!sample.waitUntilActive()) {
            return nullptr;
        }
        QTest::keyClick(&sample.editor, Qt::Key_Comma, Qt::ControlModifier);
        return sample.window.findChild<PreferencesDialog *>();
    }
    static QComboBox *box(const PreferencesDialog &dialog, int index)
    {
        return dialog.findChildren<QComboBox *>()[index];
    }
};

void TestPreferences::whatIsWrittenIsRead()
{
    const Preferences written{Choice::Dark, QStringLiteral("Größe & Co"), 17, false, false};
    written.write();
    QCOMPARE(Preferences::read(), written);
    Preferences().write();
    QCOMPARE(Preferences::read(), Preferences());
}

void TestPreferences::nonsenseIsAsIfItWereNot_data()
{
    QTest::addColumn<QByteArray>("file");
    QTest::newRow("empty") << QByteArray();
    QTest::newRow("other words") << QByteArray("appearance=purple\n[font]\nsize=large\n");
    QTest::newRow("beyond") << QByteArray("appearance=\n[font]\nsize=900\n");
    QTest::newRow("no file of ours") << QByteArray("\x89PNG\r\n\x1a\n\0\0", 10);
}

void TestPreferences::nonsenseIsAsIfItWereNot()
{
    QFETCH(const QByteArray, file);
    QFile settings(qEnvironmentVariable("XDG_CONFIG_HOME") + QStringLiteral("/romanesco/settings.ini"));
    QVERIFY(settings.open(QIODevice::WriteOnly) && settings.write(file) == file.size());
    settings.close();
    QCOMPARE(Preferences::read(), Preferences());
}

void TestPreferences::lightAndDarkAreFollowedByAll()
{
    Sample sample;
    PreferencesDialog *dialog = opened(sample);
    QVERIFY(dialog && dialog->isVisible());
    QComboBox *appearance = box(*dialog, 0);
    MessageStrip strip(MessageStrip::Closing::ByUser);
    strip.say(QStringLiteral("a word"), true);
    const int system = lightness(sample.editor, QPalette::Base);

    appearance->setFocus();
    QTest::keyClick(appearance, Qt::Key_End);
    QCOMPARE(Preferences::read().appearance, Choice::Dark);
    QVERIFY(QTest::qWaitFor([&] { return lightness(sample.editor, QPalette::Base) < 80; }));
    QVERIFY(ground(sample.editor).lightness() < 80);
    QVERIFY(sample.editor.colour(KSyntaxHighlighting::Theme::CurrentLine).lightness() < 80);
    QVERIFY(lightness(strip, QPalette::Window) < 80);
    QVERIFY(lightness(strip, QPalette::WindowText) > 176);

    QTest::keyClick(appearance, Qt::Key_Up);
    QCOMPARE(Preferences::read().appearance, Choice::Light);
    QVERIFY(QTest::qWaitFor([&] { return lightness(sample.editor, QPalette::Base) > 176; }));
    QVERIFY(ground(sample.editor).lightness() > 176);
    QVERIFY(sample.editor.colour(KSyntaxHighlighting::Theme::CurrentLine).lightness() > 176);
    QVERIFY(lightness(strip, QPalette::Window) > 176);
    QVERIFY(lightness(strip, QPalette::WindowText) < 80);

    QTest::keyClick(appearance, Qt::Key_Up);
    QCOMPARE(Preferences::read().appearance, Choice::System);
    QVERIFY(QTest::qWaitFor([&] { return lightness(sample.editor, QPalette::Base) == system; }));
}

void TestPreferences::theFontIsThatOfAllTexts()
{
    Sample sample;
    const QFont usual = sample.editor.font();
    sample.editor.zoomBy(1);
    PreferencesDialog *dialog = opened(sample);
    QVERIFY(dialog);
    QSpinBox *size = dialog->findChild<QSpinBox *>();
    QCOMPARE(size->text(), size->specialValueText());
    size->setFocus();
    size->selectAll();
    QTest::keyClicks(size, QStringLiteral("20"));
    QTest::keyClick(size, Qt::Key_Tab);
    QCOMPARE(Preferences::read().fontSize, 20);
    // It is still larger by one.
    QCOMPARE(sample.editor.font().pointSizeF(), 21.0);
    QTest::keyClick(dialog, Qt::Key_Escape);
    sample.editor.insertPlainText(QStringLiteral("#"));
    QTest::keyClick(&sample.editor, Qt::Key_N, Qt::ControlModifier);
    QVERIFY(&sample.visibleEditor() != &sample.editor);
    QCOMPARE(sample.visibleEditor().font().pointSizeF(), 20.0);

    const Sample next;
    QCOMPARE(next.editor.font().pointSizeF(), 20.0);
    QCOMPARE(next.editor.font().family(), usual.family());
}

void TestPreferences::longLinesAreWrappedOrNot()
{
    Sample sample;
    QCOMPARE(sample.editor.lineWrapMode(), QPlainTextEdit::WidgetWidth);
    PreferencesDialog *dialog = opened(sample);
    QVERIFY(dialog);
    QTest::keyClick(dialog->findChildren<QCheckBox *>()[0], Qt::Key_Space);
    QCOMPARE(sample.editor.lineWrapMode(), QPlainTextEdit::NoWrap);
    QVERIFY(!Preferences::read().wrapsLines);
}

void TestPreferences::whatWasOpenIsReopenedOrNot()
{
    Sample sample;
    QVERIFY(sample.window.openFile(sample.write(QStringLiteral("a.fdo"), "# mine\n")));
    sample.window.findChild<TextTabs *>()->remember();
    QVERIFY(MainWindow().openSession());
    PreferencesDialog *dialog = opened(sample);
    QVERIFY(dialog);
    QTest::keyClick(dialog->findChildren<QCheckBox *>()[1], Qt::Key_Space);
    QVERIFY(!MainWindow().openSession());
}

int main(int argc, char **argv)
{
    return romanesco::test::runWithGl<TestPreferences>(argc, argv);
}
#include "testpreferences.moc"
