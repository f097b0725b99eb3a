// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#include <QAction>
#include <QImage>
#include <QLineEdit>
#include <QProcess>
#include <QProgressBar>
#include <QPushButton>
#include <QSignalSpy>
#include <QSpinBox>
#include <QStatusBar>

#include "app/window/turntabledialog.h"
#include "pictures.h"
#include "windowsample.h"

using namespace romanesco;
using Sample = romanesco::test::WindowSample;

namespace {

TurntableDialog *open(Sample &sample)
{
    for (QAction *action : sample.window.findChildren<QAction *>()) {
        if (action->text().remove(u'&') == QStringLiteral("Save Turntable…")) {
            action->trigger();
        }
    }
    return sample.window.findChild<TurntableDialog *>();
}

QPushButton &buttonOf(const TurntableDialog &dialog, const QString &words)
{
    for (QPushButton *button : dialog.findChildren<QPushButton *>()) {
        if (button->text().remove(u'&') == words) {
            return *button;
        }
    }
    qFatal("no button %s", qPrintable(words));
}

void fill(TurntableDialog &dialog, const QString &folder, int count, QSize size)
{
    const auto fields = dialog.findChildren<QLineEdit *>(Qt::FindChildrenRecursively);
    for (QLineEdit *field : fields) {
        if (field->accessibleName() == QStringLiteral("Folder for the pictures")) {
            field->setText(folder);
        }
    }
    const auto boxes = dialog.findChildren<QSpinBox *>();
    for (QSpinBox *box : boxes) {
        box->setValue(box->accessibleName() == QStringLiteral("Width")        ? size.width()
                          : box->accessibleName() == QStringLiteral("Height") ? size.height()
                                                                              : count);
    }
}

QStringList filesIn(const QString &folder)
{
    return QDir(folder).entryList({QStringLiteral("*.png")}, QDir::Files, QDir::Name);
}

}

/// Pictures of a full turn, from the window.
class TestTurntableDialog : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void aTurnIsWritten();
    void cancellingKeepsWhatIsWhole();
    void whatWouldBeReplacedIsSaid();
    void whatIsInTheWayIsSaid();
};

void TestTurntableDialog::aTurnIsWritten()
{
    Sample sample;
    QVERIFY(sample.waitForPicture());
    TurntableDialog *dialog = open(sample);
    QVERIFY(dialog);
    const QString folder = sample.folder.path();
    fill(*dialog, folder, 4, {160, 120});
    QSignalSpy saved(dialog, &TurntableDialog::saved);
    buttonOf(*dialog, QStringLiteral("Save")).click();
    QVERIFY(dialog->isDrawing());
    QVERIFY(saved.wait(120'000));
    QCOMPARE(saved.last()[0].toInt(), 4);
    const QStringList files = filesIn(folder);
    QCOMPARE(files.size(), 4);
    QVERIFY(files.first().endsWith(QStringLiteral("-0000.png")));
    std::vector<QImage> pictures;
    for (const QString &file : files) {
        pictures.emplace_back(folder + u'/' + file);
        QCOMPARE(pictures.back().size(), QSize(160, 120));
    }
    // seen from four sides, and the first as it is seen in the window
    QVERIFY(romanesco::test::shareOfDifferent(pictures[0], pictures[1]) > 0.02);
    QVERIFY(romanesco::test::shareOfDifferent(pictures[0], pictures[2]) > 0.02);
    QVERIFY(sample.window.findChild<QStatusBar *>()->currentMessage().contains(QStringLiteral("4 pictures")));
    QVERIFY(sample.waitForPicture()); // the window still draws
}

void TestTurntableDialog::cancellingKeepsWhatIsWhole()
{
    Sample sample;
    QVERIFY(sample.waitForPicture());
    TurntableDialog *dialog = open(sample);
    fill(*dialog, sample.folder.path(), 10'000, {320, 240});
    buttonOf(*dialog, QStringLiteral("Save")).click();
    QVERIFY(QTest::qWaitFor([&] { return dialog->findChild<QProgressBar *>()->value() > 0; }, 120'000));
    buttonOf(*dialog, QStringLiteral("Cancel")).click();
    QVERIFY(QTest::qWaitFor([&] { return !dialog->isDrawing(); }, 120'000));
    QVERIFY(dialog->isVisible());
    const QStringList files = filesIn(sample.folder.path());
    QVERIFY(!files.isEmpty() && files.size() < 10'000);
    for (const QString &file : files) {
        QCOMPARE(QImage(sample.path(file)).size(), QSize(320, 240));
    }
    QCOMPARE(QDir(sample.folder.path()).entryList(QDir::Files | QDir::Hidden).size(), files.size()); // no parts
    // Esc stops, and closes.
    buttonOf(*dialog, QStringLiteral("Replace")).click();
    QVERIFY(dialog->isDrawing());
    QTest::keyClick(dialog, Qt::Key_Escape);
    QVERIFY(QTest::qWaitFor([&] { return !sample.window.findChild<TurntableDialog *>(); }, 120'000));
}

void TestTurntableDialog::whatWouldBeReplacedIsSaid()
{
    Sample sample;
    QVERIFY(sample.waitForPicture());
    TurntableDialog *dialog = open(sample);
    fill(*dialog, sample.folder.path(), 3, {160, 120});
    const QString name = dialog->findChildren<QLineEdit *>().at(1)->text();
    QVERIFY(name.contains(QStringLiteral("%04d")));
    const QString second = QString(name).replace(QStringLiteral("%04d"), QStringLiteral("0001"));
    (void)sample.write(second, "mine");
    fill(*dialog, sample.folder.path(), 2, {160, 120});
    QVERIFY(buttonOf(*dialog, QStringLiteral("Replace")).isEnabled());
    fill(*dialog, sample.folder.path(), 1, {160, 120});
    QVERIFY(buttonOf(*dialog, QStringLiteral("Save")).isEnabled());
}

void TestTurntableDialog::whatIsInTheWayIsSaid()
{
    Sample sample;
    QVERIFY(sample.waitForPicture());
    TurntableDialog *dialog = open(sample);
    fill(*dialog, sample.path(QStringLiteral("nowhere")), 3, {160, 120});
    QVERIFY(!buttonOf(*dialog, QStringLiteral("Save")).isEnabled());
    fill(*dialog, sample.folder.path(), 3, {160, 120});
    QVERIFY(buttonOf(*dialog, QStringLiteral("Save")).isEnabled());
    for (const char *name : {"a.png", "%d%d.png", "%x.png", "b/%d.png"}) {
        dialog->findChildren<QLineEdit *>().at(1)->setText(QString::fromLatin1(name));
        QVERIFY2(!buttonOf(*dialog, QStringLiteral("Save")).isEnabled(), name);
    }
    dialog->findChildren<QLineEdit *>().at(1)->setText(QStringLiteral("%d.png"));
    QVERIFY(buttonOf(*dialog, QStringLiteral("Save")).isEnabled());
}

int main(int argc, char **argv)
{
    return romanesco::test::runWithGl<TestTurntableDialog>(argc, argv);
}
#include "testturntabledialog.moc"
