// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#include <csignal>

#include <sys/resource.h>
#include <sys/stat.h>

#include <QAction>
#include <QClipboard>
#include <QFileDialog>
#include <QGuiApplication>
#include <QLineEdit>
#include <QStandardPaths>

#include "app/window/picture.h"
#include "tests/window/documentsample.h"

using namespace romanesco;
using namespace romanesco::test;

namespace {

QImage sample()
{
    QImage picture(40, 30, QImage::Format_ARGB32_Premultiplied);
    for (int y = 0; y < picture.height(); ++y) {
        for (int x = 0; x < picture.width(); ++x) {
            picture.setPixelColor(x, y, QColor(6 * x, 8 * y, 40));
        }
    }
    return picture;
}

/// A window with its actions.
struct Sample {
    Folders folders;
    QImage picture = sample();
    QWidget window;
    PictureActions actions{window, [this] { return picture; },
                           [this] { return folders.path(QStringLiteral("tree.fdo")); }};
    QSignalSpy saved{&actions, &PictureActions::saved};
    QSignalSpy copied{&actions, &PictureActions::copied};
    QSignalSpy failed{&actions, &PictureActions::failed};

    Sample()
    {
        window.addActions({actions.save(), actions.copy()});
        window.show();
        window.activateWindow();
    }
    [[nodiscard]] QFileDialog *dialog() const { return window.findChild<QFileDialog *>(); }
};

}

class TestPicture : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void aPictureIsSavedAsItIs();
    void whatShowsThroughIsSaved();
    void whatCannotBeWrittenIsSaid_data();
    void whatCannotBeWrittenIsSaid();
    void anOldPictureStaysWhereItFails();
    void aFreeNameIsProposed();
    void theKeySaves();
    void theKeyCopies();
    void withoutAPictureNothingIsAsked();
};

void TestPicture::aPictureIsSavedAsItIs()
{
    const Folders folders;
    const QString path = folders.path(QStringLiteral("a.png"));
    QVERIFY(savePicture(sample(), path));
    QVERIFY(Folders::read(path).startsWith("\x89PNG\r\n"));
    QCOMPARE(QImage(path).convertToFormat(QImage::Format_RGB32), sample().convertToFormat(QImage::Format_RGB32));
    QCOMPARE(folders.names(), QStringList{QStringLiteral("a.png")});
}

/// A buffer of OpenGL may be transparent where the screen shows no such thing.
void TestPicture::whatShowsThroughIsSaved()
{
    const Folders folders;
    QImage picture(4, 4, QImage::Format_RGBA8888_Premultiplied);
    for (int y = 0; y < picture.height(); ++y) {
        for (int x = 0; x < picture.width(); ++x) {
            uchar *pixel = picture.scanLine(y) + 4 * x;
            pixel[0] = 90;
            pixel[1] = 60;
            pixel[2] = 30;
            pixel[3] = 128;
        }
    }
    const QString path = folders.path(QStringLiteral("a.png"));
    QVERIFY(savePicture(picture, path));
    QVERIFY(!QImage(path).hasAlphaChannel());
    QCOMPARE(QImage(path).pixelColor(2, 2), QColor(90, 60, 30));
}

void TestPicture::whatCannotBeWrittenIsSaid_data()
{
    QTest::addColumn<QString>("name");
    QTest::addColumn<QString>("reason");
    QTest::newRow("pipe") << "pipe" << "it is not a regular file";
    QTest::newRow("device") << "device" << "it is not a regular file";
    QTest::newRow("folder") << "folder" << "it is a directory";
    QTest::newRow("no folder") << "missing/a.png" << "no such folder";
}

void TestPicture::whatCannotBeWrittenIsSaid()
{
    QFETCH(const QString, name);
    QFETCH(const QString, reason);
    const Folders folders;
    QCOMPARE(::mkfifo(QFile::encodeName(folders.path(QStringLiteral("pipe"))).constData(), 0600), 0);
    // by a link, so that no fault can harm the device itself
    QVERIFY(QFile::link(QStringLiteral("/dev/full"), folders.path(QStringLiteral("device"))));
    QVERIFY(QDir(folders.own.path()).mkdir(QStringLiteral("folder")));
    const QString path = QDir(folders.own.path()).absoluteFilePath(name);
    const auto written = savePicture(sample(), path);
    QVERIFY(!written);
    QCOMPARE(written.error(), QStringLiteral("“%1” was not written: %2.").arg(path, reason));
}

/// The disk is full, or as near as a test comes to that, in the middle of the file.
void TestPicture::anOldPictureStaysWhereItFails()
{
    const Folders folders;
    const QString path = folders.write(QStringLiteral("a.png"), "old");
    std::signal(SIGXFSZ, SIG_IGN);
    rlimit old{};
    QCOMPARE(::getrlimit(RLIMIT_FSIZE, &old), 0);
    const rlimit small{50, old.rlim_max};
    QCOMPARE(::setrlimit(RLIMIT_FSIZE, &small), 0);
    const auto written = savePicture(sample(), path);
    QCOMPARE(::setrlimit(RLIMIT_FSIZE, &old), 0);
    QVERIFY(!written);
    QVERIFY2(written.error().contains(QStringLiteral("larger than a file may be")), qPrintable(written.error()));
    QCOMPARE(Folders::read(path), QByteArray("old"));
    QCOMPARE(folders.names(), QStringList{QStringLiteral("a.png")});
}

void TestPicture::aFreeNameIsProposed()
{
    const Folders folders;
    const QString text = folders.path(QStringLiteral("tree.of.life.fdo"));
    QCOMPARE(proposedPicture(text), folders.path(QStringLiteral("tree.of.life-1.png")));
    std::ignore = folders.write(QStringLiteral("tree.of.life-1.png"), "taken");
    QCOMPARE(proposedPicture(text), folders.path(QStringLiteral("tree.of.life-2.png")));
    const QDir pictures(QStandardPaths::writableLocation(QStandardPaths::PicturesLocation));
    QCOMPARE(QFileInfo(proposedPicture(QStringLiteral(":/examples/menger.fdo"))).dir(), pictures);
    QVERIFY(proposedPicture(QStringLiteral(":/examples/menger.fdo")).contains(QStringLiteral("/menger-")));
    QVERIFY(proposedPicture({}).contains(QStringLiteral("/untitled-")));
}

void TestPicture::theKeySaves()
{
    Sample sample;
    QVERIFY(QTest::qWaitForWindowActive(&sample.window));
    QTest::keyClick(&sample.window, Qt::Key_P, Qt::ControlModifier | Qt::ShiftModifier);
    QFileDialog *dialog = sample.dialog();
    QVERIFY(dialog);
    QCOMPARE(dialog->selectedFiles(), QStringList{sample.folders.path(QStringLiteral("tree-1.png"))});
    // what was to be seen when the key was pressed
    const QImage then = sample.picture;
    sample.picture.fill(Qt::red);
    QTest::keyClick(dialog, Qt::Key_Return);
    QTRY_COMPARE(sample.saved.count(), 1);
    QCOMPARE(sample.saved.first().first().toString(), sample.folders.path(QStringLiteral("tree-1.png")));
    QCOMPARE(sample.failed.count(), 0);
    QCOMPARE(QImage(sample.saved.first().first().toString()).convertToFormat(QImage::Format_RGB32),
             then.convertToFormat(QImage::Format_RGB32));
}

void TestPicture::theKeyCopies()
{
    Sample sample;
    QVERIFY(QTest::qWaitForWindowActive(&sample.window));
    QTest::keyClick(&sample.window, Qt::Key_C, Qt::ControlModifier | Qt::ShiftModifier);
    QCOMPARE(sample.copied.count(), 1);
    QCOMPARE(QGuiApplication::clipboard()->image().convertToFormat(QImage::Format_RGB32),
             sample.picture.convertToFormat(QImage::Format_RGB32));
}

void TestPicture::withoutAPictureNothingIsAsked()
{
    Sample sample;
    sample.picture = QImage();
    sample.actions.save()->trigger();
    sample.actions.copy()->trigger();
    QVERIFY(!sample.dialog());
    QCOMPARE(sample.failed.count(), 2);
    QCOMPARE(sample.copied.count(), 0);
}

QTEST_MAIN(TestPicture)
#include "testpicture.moc"
