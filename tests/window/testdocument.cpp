// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#include <QDir>
#include <QFile>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include "app/window/document.h"
#include "app/window/resourcefiles.h"
#include "editor/fdoeditor.h"

using namespace romanesco;

namespace {

struct Sample {
    QTemporaryDir folder;
    ResourceFiles files;
    FdoEditor editor;
    Document document{editor, files};
    QSignalSpy changes{&document, &Document::textChanged};

    [[nodiscard]] QString path(const QString &name) const { return folder.filePath(name); }
    [[nodiscard]] QString write(const QString &name, const QByteArray &bytes) const
    {
        QFile file(path(name));
        if (!file.open(QIODevice::WriteOnly) || file.write(bytes) != bytes.size()) {
            qFatal("cannot write %s", qPrintable(file.fileName()));
        }
        return file.fileName();
    }
    [[nodiscard]] static QByteArray read(const QString &path)
    {
        QFile file(path);
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray("(cannot be read)");
    }
};

}

class TestDocument : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void savingKeepsTheFormOfTheFile();
    void savingUnchangedKeepsEveryByte();
    void savingKeepsTheUndoHistory();
    void whatCannotBeSavedStaysModified();
    void whatCannotBeOpenedLeavesTheTextAlone_data();
    void whatCannotBeOpenedLeavesTheTextAlone();
    void examplesOpenButHaveNoFileOfTheirOwn();
    void aTextThatWouldLoseCharactersIsReadOnly();
    void onlyCharactersAreChanges();
    void aNewTextIsEmpty();
};

void TestDocument::savingKeepsTheFormOfTheFile()
{
    Sample sample;
    const QString path = sample.write(QStringLiteral("a.fdo"), "\xEF\xBB\xBF# \xC3\xA4\r\n<$>. x");
    QVERIFY(sample.document.open(path).has_value());
    sample.editor.insertPlainText(QStringLiteral("# new\n"));
    QVERIFY(sample.document.isModified());
    QVERIFY(sample.document.saveAs(path).has_value());
    QVERIFY(!sample.document.isModified());
    QCOMPARE(Sample::read(path), QByteArray("\xEF\xBB\xBF# new\r\n# \xC3\xA4\r\n<$>. x"));
}

void TestDocument::savingUnchangedKeepsEveryByte()
{
    Sample sample;
    const QByteArray bytes("a\r\nb\n\rc\xC2\xA0\n\n");
    const QString path = sample.write(QStringLiteral("a.fdo"), bytes);
    QVERIFY(sample.document.open(path).has_value());
    QVERIFY(sample.document.saveAs(path).has_value());
    QCOMPARE(Sample::read(path), bytes);
}

void TestDocument::savingKeepsTheUndoHistory()
{
    Sample sample;
    const QString path = sample.write(QStringLiteral("a.fdo"), "old\n");
    QVERIFY(sample.document.open(path).has_value());
    sample.editor.insertPlainText(QStringLiteral("x"));
    QVERIFY(sample.document.saveAs(path).has_value());
    sample.editor.undo();
    QCOMPARE(sample.document.text().bytes(), std::string("old\n"));
    QVERIFY(sample.document.isModified());
}

void TestDocument::whatCannotBeSavedStaysModified()
{
    Sample sample;
    sample.document.startNew();
    sample.editor.insertPlainText(QStringLiteral("x"));
    const auto saved = sample.document.saveAs(sample.path(QStringLiteral("no/such/folder/a.fdo")));
    QVERIFY(!saved.has_value());
    QVERIFY(!saved.error().isEmpty());
    QVERIFY(sample.document.isModified());
    QCOMPARE(sample.document.path(), QString());
}

void TestDocument::whatCannotBeOpenedLeavesTheTextAlone_data()
{
    QTest::addColumn<QString>("name");
    QTest::newRow("missing") << QStringLiteral("missing.fdo");
    QTest::newRow("not UTF-8") << QStringLiteral("latin.fdo");
    QTest::newRow("a folder") << QStringLiteral(".");
    QTest::newRow("missing example") << QStringLiteral(":/examples/missing.fdo");
}

void TestDocument::whatCannotBeOpenedLeavesTheTextAlone()
{
    QFETCH(const QString, name);
    Sample sample;
    const QByteArray latin("# gr\xF6\xDF"
                           "er\n");
    const QString latinPath = sample.write(QStringLiteral("latin.fdo"), latin);
    QVERIFY(sample.document.open(sample.write(QStringLiteral("good.fdo"), "good\n")).has_value());
    sample.editor.insertPlainText(QStringLiteral("x"));

    const auto opened = sample.document.open(name.startsWith(u':') ? name : sample.path(name));
    QVERIFY(!opened.has_value());
    QVERIFY(!opened.error().isEmpty());
    QCOMPARE(sample.document.text().bytes(), std::string("xgood\n"));
    QCOMPARE(sample.document.name(), QStringLiteral("good.fdo"));
    QVERIFY(sample.document.isModified());
    QCOMPARE(Sample::read(latinPath), latin);
}

void TestDocument::examplesOpenButHaveNoFileOfTheirOwn()
{
    Sample sample;
    QVERIFY(sample.document.open(QStringLiteral(":/examples/romanesco.fdo")).has_value());
    QVERIFY(sample.document.isExample());
    QVERIFY(!sample.document.hasOwnFile());
    QCOMPARE(sample.document.name(), QStringLiteral("romanesco.fdo"));
    QVERIFY(sample.files.read(sample.document.scenePath().parent_path() / "bud.obj").has_value());
}

void TestDocument::aTextThatWouldLoseCharactersIsReadOnly()
{
    Sample sample;
    QVERIFY(sample.document
                .open(sample.write(QStringLiteral("a.fdo"),
                                   "a\xE2\x80\xA9"
                                   "b\n"))
                .has_value());
    QVERIFY(sample.editor.isReadOnly());
    QVERIFY(!sample.document.hasOwnFile());
    // Not even where somebody asks for its own name.
    const QByteArray before = Sample::read(sample.document.path());
    QVERIFY(!sample.document.saveAs(sample.document.path()).has_value());
    QCOMPARE(Sample::read(sample.document.path()), before);
    QVERIFY(sample.document.open(sample.write(QStringLiteral("b.fdo"), "b\n")).has_value());
    QVERIFY(!sample.editor.isReadOnly());
}

void TestDocument::onlyCharactersAreChanges()
{
    Sample sample;
    QVERIFY(sample.document.open(QStringLiteral(":/examples/tree.fdo")).has_value());
    QCOMPARE(sample.changes.count(), 1);
    QCoreApplication::processEvents();
    sample.editor.setFileName(QStringLiteral("a.obj"));
    QCoreApplication::processEvents();
    QCOMPARE(sample.changes.count(), 1);
    sample.editor.insertPlainText(QStringLiteral("x"));
    QCOMPARE(sample.changes.count(), 2);
}

void TestDocument::aNewTextIsEmpty()
{
    Sample sample;
    QVERIFY(sample.document.open(QStringLiteral(":/examples/tree.fdo")).has_value());
    sample.document.startNew();
    QCOMPARE(sample.document.text().bytes(), std::string());
    QVERIFY(!sample.document.hasOwnFile());
    QVERIFY(!sample.document.isModified());
}

QTEST_MAIN(TestDocument)
#include "testdocument.moc"
