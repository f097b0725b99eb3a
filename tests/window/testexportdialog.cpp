// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#include <QComboBox>

#include "app/window/exportwords.h"
#include "exportsample.h"

using namespace romanesco;
using namespace romanesco::test;
using Sample = romanesco::test::ExportSample;

namespace {

/// The lines of a text that start so.
qsizetype lines(const QByteArray &text, const QByteArray &start)
{
    return text.count('\n' + start);
}

}

/// What the dialog offers and forecasts, and what is written then.
class TestExportDialog : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void initTestCase() { QLocale::setDefault(QLocale(QLocale::English, QLocale::UnitedStates)); }
    void eachFormatIsWritten_data();
    void eachFormatIsWritten();
    void theEndingChoosesTheFormat();
    void theFormatChoosesTheEnding_data();
    void theFormatChoosesTheEnding();
    void onlyAnObjHasDigitsAndGroups();
    void choicesReachTheFile();
    void theForecastComesTrue_data();
    void theForecastComesTrue();
    void theForecastFollowsTheChoices();
    void sizesAndTimesAreTold_data();
    void sizesAndTimesAreTold();
    void tooManyFacesCannotBeStarted_data();
    void tooManyFacesCannotBeStarted();
    void whatTheSceneIsMadeFromStays();
    void anOldFileIsReplacedOnlyKnowingly();
    void keysAreEnough();
};

void TestExportDialog::eachFormatIsWritten_data()
{
    QTest::addColumn<QString>("name");
    QTest::addColumn<QByteArray>("start");
    QTest::newRow("obj") << "out.obj" << QByteArray("# Romanesco: dust.fdo, depth 3, 8 faces\n");
    QTest::newRow("ply") << "out.ply" << QByteArray("ply\n");
    QTest::newRow("stl") << "OUT.STL" << QByteArray("Romanesco");
    QTest::newRow("glb") << "out.glb" << QByteArray("glTF");
    // the format is that which is chosen, where the name does not tell
    QTest::newRow("none") << "out.txt" << QByteArray("# Romanesco: dust.fdo, depth 3, 8 faces\n");
}

void TestExportDialog::eachFormatIsWritten()
{
    QFETCH(const QString, name);
    QFETCH(const QByteArray, start);
    Sample sample(3, name);
    QVERIFY(sample.waitForEstimate());
    sample.button(QStringLiteral("Export")).click();
    QVERIFY(sample.waitForEnd());
    QVERIFY2(sample.dialog->isHidden(), qPrintable(sample.trouble()));
    const QByteArray bytes = Folders::read(sample.path);
    QVERIFY2(bytes.startsWith(start), bytes.first(20));
    QCOMPARE(sample.exported, QStringList({sample.path, QString::number(bytes.size()), QString()}));
    QCOMPARE(sample.written(), QStringList{name});
}

void TestExportDialog::theEndingChoosesTheFormat()
{
    Sample sample(3);
    QCOMPARE(sample.dialog->options().format, ExportFormat::Obj);
    sample.file().setText(QStringLiteral("other.PLY"));
    QCOMPARE(sample.dialog->options().format, ExportFormat::Ply);
    QCOMPARE(sample.dialog->path(), sample.folders.path(QStringLiteral("other.PLY")));
    sample.file().setText(QStringLiteral("other"));
    QCOMPARE(sample.dialog->options().format, ExportFormat::Ply);
    sample.file().setText(QStringLiteral("/other.glb"));
    QCOMPARE(sample.dialog->options().format, ExportFormat::Glb);
    QCOMPARE(sample.dialog->path(), QStringLiteral("/other.glb"));
}

void TestExportDialog::theFormatChoosesTheEnding_data()
{
    QTest::addColumn<QString>("typed");
    QTest::addColumn<QString>("becomes");
    QTest::newRow("known") << "tree.obj" << "tree.stl";
    QTest::newRow("upper") << "tree.OBJ" << "tree.stl";
    QTest::newRow("other") << "tree.v2" << "tree.v2.stl";
    QTest::newRow("none") << "tree" << "tree.stl";
    QTest::newRow("two") << "tree.obj.ply" << "tree.obj.stl";
    QTest::newRow("empty") << "" << "";
}

void TestExportDialog::theFormatChoosesTheEnding()
{
    QFETCH(const QString, typed);
    Sample sample(3);
    sample.file().setText(typed);
    QComboBox &formats = sample.the<QComboBox>();
    formats.setCurrentIndex(formats.findText(QStringLiteral("STL"), Qt::MatchStartsWith));
    QTEST(sample.file().text(), "becomes");
    QCOMPARE(sample.dialog->options().format, ExportFormat::Stl);
}

void TestExportDialog::onlyAnObjHasDigitsAndGroups()
{
    Sample sample(3);
    sample.box(QStringLiteral("group")).setChecked(true);
    sample.the<QSpinBox>().setValue(4);
    QCOMPARE(sample.dialog->options().digits, std::optional(4));
    QVERIFY(sample.dialog->options().isGrouped);
    sample.file().setText(QStringLiteral("a.stl"));
    QVERIFY(!sample.box(QStringLiteral("group")).isEnabled());
    QVERIFY(!sample.the<QSpinBox>().isEnabled());
    QCOMPARE(sample.dialog->options().digits, std::nullopt);
    QVERIFY(!sample.dialog->options().isGrouped);
    sample.the<QSpinBox>().setValue(0);
    sample.file().setText(QStringLiteral("a.obj"));
    QCOMPARE(sample.dialog->options().digits, std::nullopt);
}

void TestExportDialog::choicesReachTheFile()
{
    Sample sample(3);
    sample.box(QStringLiteral("group")).setChecked(true);
    sample.box(QStringLiteral("coincide")).setChecked(true);
    sample.the<QSpinBox>().setValue(2);
    QVERIFY(sample.waitForEstimate());
    sample.button(QStringLiteral("Export")).click();
    QVERIFY(sample.waitForEnd());
    const QByteArray bytes = Folders::read(sample.path);
    QCOMPARE(lines(bytes, "f "), 8);
    QCOMPARE(lines(bytes, "g dust"), 2);
    QVERIFY2(bytes.contains("\nv 0.064 0 0\n"), bytes); // 0.4 cubed
    QVERIFY2(!bytes.contains("0.06400"), bytes);
    // a triangle is open on each side
    QVERIFY2(sample.exported.at(2).contains(QStringLiteral("24 edges are open")), qPrintable(sample.exported.at(2)));
}

void TestExportDialog::theForecastComesTrue_data()
{
    QTest::addColumn<QString>("name");
    for (const char *name : {"out.obj", "out.ply", "out.stl", "out.glb"}) {
        QTest::newRow(name) << QString::fromLatin1(name);
    }
}

void TestExportDialog::theForecastComesTrue()
{
    QFETCH(const QString, name);
    Sample sample(18, name);
    QVERIFY(sample.waitForEstimate());
    QVERIFY2(sample.words().contains(QStringLiteral("262,144 faces")), qPrintable(sample.words()));
    const QRegularExpression size(QStringLiteral("about ([0-9.]+) MB"));
    const QRegularExpressionMatch match = size.match(sample.words());
    QVERIFY2(match.hasMatch(), qPrintable(sample.words()));
    QVERIFY(sample.words().contains(QRegularExpression(QStringLiteral("in (about|less than) .*second"))));
    QVERIFY(sample.words().contains(QRegularExpression(QStringLiteral("The disk has [0-9.]+ .B free"))));
    sample.button(QStringLiteral("Export")).click();
    QVERIFY(sample.waitForEnd());
    const double megabytes = static_cast<double>(Folders::read(sample.path).size()) / 1e6;
    QVERIFY2(std::abs(match.captured(1).toDouble() / megabytes - 1.0) < 0.03, qPrintable(match.captured()));
}

void TestExportDialog::theForecastFollowsTheChoices()
{
    Sample sample(16);
    QVERIFY(sample.waitForEstimate());
    const QString first = sample.words();
    sample.the<QSpinBox>().setValue(2);
    QVERIFY(!sample.dialog->isEstimated());
    QVERIFY(sample.waitForEstimate());
    const QString rounded = sample.words();
    QVERIFY(rounded != first);
    sample.box(QStringLiteral("coincide")).setChecked(true);
    QVERIFY(sample.waitForEstimate());
    QVERIFY2(sample.words().contains(QStringLiteral("65,536 faces before welding")), qPrintable(sample.words()));
}

void TestExportDialog::sizesAndTimesAreTold_data()
{
    QTest::addColumn<QString>("told");
    QTest::addColumn<QString>("words");
    QTest::newRow("bytes") << sizeText(Count(12)) << "12 bytes";
    QTest::newRow("kB") << sizeText(Count(12'340)) << "12.3 kB";
    QTest::newRow("GB") << sizeText(Count(12'340'000'000)) << "12.3 GB";
    QTest::newRow("beyond") << sizeText(power(Count(10), 40)) << "1.00 × 10⁴⁰ bytes";
    QTest::newRow("at once") << durationText(0.0) << "less than a second";
    QTest::newRow("a second") << durationText(1.4) << "a second";
    QTest::newRow("seconds") << durationText(89.4) << "89 seconds";
    QTest::newRow("minutes") << durationText(91.0) << "2 minutes";
    QTest::newRow("hours") << durationText(7'300.0) << "2 hours";
}

void TestExportDialog::sizesAndTimesAreTold()
{
    QFETCH(const QString, told);
    QTEST(told, "words");
}

void TestExportDialog::tooManyFacesCannotBeStarted_data()
{
    QTest::addColumn<int>("depth");
    QTest::addColumn<QString>("name");
    QTest::addColumn<QString>("words");
    QTest::newRow("disk") << 133 << "out.obj" << "bytes free on the disk";
    QTest::newRow("format") << 133 << "out.stl" << "4294967295 faces";
    // nothing is known of a disk
    QTest::newRow("anywhere") << 133 << "missing/folder/out.obj" << "too many faces";
}

void TestExportDialog::tooManyFacesCannotBeStarted()
{
    QFETCH(const QString, words);
    QFETCH(const QString, name);
    QFETCH(const int, depth);
    Sample sample(depth, name);
    // even by one who is faster than the forecast
    sample.button(QStringLiteral("Export")).click();
    QVERIFY(sample.waitForEstimate());
    QVERIFY2(sample.words().contains(QStringLiteral("1.08 × 10⁴⁰ faces")), qPrintable(sample.words()));
    QVERIFY2(sample.trouble().contains(words), qPrintable(sample.trouble()));
    QVERIFY(!sample.button(QStringLiteral("Export")).isEnabled());
    QVERIFY(!sample.dialog->isExporting());
    QCOMPARE(sample.written(), QStringList());
}

void TestExportDialog::whatTheSceneIsMadeFromStays()
{
    Sample sample(3, QStringLiteral("triangle.obj"));
    QVERIFY(sample.waitForEstimate());
    QVERIFY2(sample.trouble().contains(QStringLiteral("made from")), qPrintable(sample.trouble()));
    QVERIFY(!sample.button(QStringLiteral("Replace")).isEnabled());
    sample.file().setText(QStringLiteral("other.obj"));
    QVERIFY(sample.waitForEstimate());
    QVERIFY(sample.trouble().isEmpty());
    QVERIFY(sample.button(QStringLiteral("Export")).isEnabled());
}

void TestExportDialog::anOldFileIsReplacedOnlyKnowingly()
{
    Sample sample(3, QStringLiteral("other.obj"));
    std::ignore = sample.folders.write(QStringLiteral("out.obj"), "old");
    sample.file().setText(QStringLiteral("out.obj"));
    // before anything could be told
    QTest::keyClick(sample.dialog.get(), Qt::Key_Return);
    QVERIFY(sample.waitForEstimate());
    QVERIFY(!sample.dialog->isExporting());
    QCOMPARE(Folders::read(sample.folders.path(QStringLiteral("out.obj"))), QByteArray("old"));
    QVERIFY2(sample.words().contains(QStringLiteral("will be replaced")), qPrintable(sample.words()));
    QTest::keyClick(sample.dialog.get(), Qt::Key_Return);
    QVERIFY(sample.waitForEnd());
    QVERIFY(Folders::read(sample.folders.path(QStringLiteral("out.obj"))).startsWith("# Romanesco"));
}

/// A name, a format and two choices, and Enter before the forecast is there.
void TestExportDialog::keysAreEnough()
{
    Sample sample(3);
    QVERIFY(QTest::qWaitForWindowActive(sample.dialog.get()));
    const auto type = [&](const QString &text) { QTest::keyClicks(QApplication::focusWidget(), text); };
    const auto press = [&](Qt::Key key, Qt::KeyboardModifiers with = Qt::NoModifier) {
        QTest::keyClick(QApplication::focusWidget(), key, with);
    };
    press(Qt::Key_I, Qt::AltModifier);
    QCOMPARE(QApplication::focusWidget(), &sample.file());
    press(Qt::Key_A, Qt::ControlModifier);
    type(QStringLiteral("keys.ply"));
    press(Qt::Key_F, Qt::AltModifier);
    QCOMPARE(QApplication::focusWidget(), &sample.the<QComboBox>());
    press(Qt::Key_Up);
    QCOMPARE(sample.file().text(), QStringLiteral("keys.obj"));
    press(Qt::Key_D, Qt::AltModifier);
    type(QStringLiteral("5"));
    press(Qt::Key_M, Qt::AltModifier);
    QTRY_VERIFY(sample.dialog->options().isWelded); // the key shows the button as pressed for an instant
    press(Qt::Key_Return);
    QVERIFY(QTest::qWaitFor([&] { return sample.dialog->isHidden(); }, 10'000));
    QCOMPARE(sample.dialog->options().digits, std::optional(5));
    QCOMPARE(lines(Folders::read(sample.folders.path(QStringLiteral("keys.obj"))), "f "), 8);
}

QTEST_MAIN(TestExportDialog)
#include "testexportdialog.moc"
