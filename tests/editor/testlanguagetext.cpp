// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include <QPlainTextEdit>
#include <QTest>
#include <QTextBlock>

#include "editor/documentbytes.h"
#include "editor/languagetext.h"

using namespace romanesco;

/// What an editor's text says, however it is edited.
class TestLanguageText : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void theNameTellsTheLanguage_data();
    void theNameTellsTheLanguage();
    void whatIsTypedIsRead();
    void anotherNameReadsTheTextAnew();
    void aByteOrderMarkAndLineEndsAreNoPartOfIt();
    void sectionsFollowTheText();
};

void TestLanguageText::theNameTellsTheLanguage_data()
{
    QTest::addColumn<QString>("name");
    QTest::addColumn<bool>("isFdo");
    QTest::addColumn<bool>("isSdo");
    QTest::newRow("fractal") << "tree.fdo" << true << false;
    QTest::newRow("scene") << "wood.sdo" << false << true;
    QTest::newRow("mesh") << "x.obj" << false << false;
    QTest::newRow("none") << "" << false << false;
    QTest::newRow("inside") << "tree.fdo.txt" << false << false;
}

void TestLanguageText::theNameTellsTheLanguage()
{
    QFETCH(const QString, name);
    QTextDocument document;
    LanguageText text(document);
    text.setFileName(name);
    QTEST(text.fdo() != nullptr, "isFdo");
    QTEST(text.sdo() != nullptr, "isSdo");
}

void TestLanguageText::whatIsTypedIsRead()
{
    QPlainTextEdit editor;
    LanguageText text(*editor.document());
    text.setFileName(QStringLiteral("a.fdo"));
    QCOMPARE(text.fdo()->model.vectors.size(), 0u);
    QTest::keyClicks(&editor, QStringLiteral("v 1 2 3"));
    QCOMPARE(text.fdo()->model.vectors.size(), 1u);
    QTest::keyClick(&editor, Qt::Key_Return);
    QTest::keyClicks(&editor, QStringLiteral("v 4 5 6"));
    QCOMPARE(text.fdo()->model.vectors.size(), 2u);
    QCOMPARE(text.snapshot().bytes(), std::string("v 1 2 3\nv 4 5 6"));
    editor.undo();
    QCOMPARE(text.fdo()->model.vectors.size(), 1u);
}

void TestLanguageText::anotherNameReadsTheTextAnew()
{
    QTextDocument document(QStringLiteral("o \"x.obj\" #"));
    LanguageText text(document);
    text.setFileName(QStringLiteral("a.fdo"));
    QVERIFY(text.fdo()->syntax.line(0).isBad);
    text.setFileName(QStringLiteral("a.sdo"));
    QVERIFY(!text.sdo()->line(0).isBad);
}

void TestLanguageText::aByteOrderMarkAndLineEndsAreNoPartOfIt()
{
    QTextDocument document;
    LanguageText text(document);
    text.setFileName(QStringLiteral("a.fdo"));
    QVERIFY(loadBytes(document, "\xEF\xBB\xBF# \xF0\x9F\x8C\xB2\r\nv 1 2 3\r\n"));
    QCOMPARE(text.snapshot().bytes(), std::string("# \xF0\x9F\x8C\xB2\nv 1 2 3\n"));
    QCOMPARE(text.fdo()->model.vectors.size(), 1u);
    // The tree is two units and four bytes.
    QCOMPARE(text.offset(document.findBlockByNumber(1).position()), 7u);
    QCOMPARE(text.position(7), 5);
}

void TestLanguageText::sectionsFollowTheText()
{
    QPlainTextEdit editor(QStringLiteral("# a\nv 1 2 3"));
    LanguageText text(*editor.document());
    QVERIFY(text.foldings().empty());
    text.setFileName(QStringLiteral("a.fdo"));
    QCOMPARE(text.foldings(), (std::vector<FoldingRange>{{0, 1}}));
    editor.appendPlainText(QStringLiteral("\n# b\nv 4 5 6"));
    QCOMPARE(text.foldings(), (std::vector<FoldingRange>{{0, 1}, {3, 4}}));
}

QTEST_MAIN(TestLanguageText)
#include "testlanguagetext.moc"
