// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include <QTest>
#include <QTextBlock>
#include <QTextDocument>

#include "editor/textsnapshot.h"

using namespace romanesco;

class TestTextSnapshot : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void everyCharacterIsFoundAgain_data();
    void everyCharacterIsFoundAgain();
    void insideACharacterIsTheCharacter();
    void beyondTheEndIsTheEnd();
    void linesAreThoseOfTheDocument();
    void noBreakSpacesStay();
    void aSnapshotStaysAsItWas();
};

void TestTextSnapshot::everyCharacterIsFoundAgain_data()
{
    QTest::addColumn<QString>("text");
    QTest::newRow("nothing") << QString();
    QTest::newRow("ascii") << QStringLiteral("v 1 1 -2\n<$>. x\n");
    QTest::newRow("two bytes") << QStringLiteral("# größer\nbäume 0 1 0");
    QTest::newRow("three bytes") << QStringLiteral("木 0 1 0\n\n木木. x");
    QTest::newRow("four bytes, two units") << QStringLiteral("# 🌲🌲 x\n🌲");
    QTest::newRow("only line ends") << QStringLiteral("\n\n\n");
}

void TestTextSnapshot::everyCharacterIsFoundAgain()
{
    QFETCH(const QString, text);
    QTextDocument document;
    document.setPlainText(text);
    const TextSnapshot snapshot(document);
    QCOMPARE(QString::fromStdString(snapshot.bytes()), text);

    std::size_t offset = 0;
    for (qsizetype at = 0; at < text.size(); ++at) {
        QCOMPARE(snapshot.position(offset), int(at));
        QCOMPARE(snapshot.offset(int(at)), offset);
        const qsizetype units = text[at].isHighSurrogate() ? 2 : 1;
        offset += static_cast<std::size_t>(text.sliced(at, units).toUtf8().size());
        at += units - 1;
    }
    QCOMPARE(snapshot.position(offset), int(text.size()));
    QCOMPARE(snapshot.offset(int(text.size())), offset);
}

void TestTextSnapshot::insideACharacterIsTheCharacter()
{
    QTextDocument document;
    document.setPlainText(QStringLiteral("a🌲ä"));
    const TextSnapshot snapshot(document);
    for (const std::size_t inside : {2u, 3u, 4u}) {
        QCOMPARE(snapshot.position(inside), 1);
    }
    QCOMPARE(snapshot.position(6), 3);
    QCOMPARE(snapshot.offset(2), 1u); // between the two units
}

void TestTextSnapshot::beyondTheEndIsTheEnd()
{
    QTextDocument document;
    document.setPlainText(QStringLiteral("ä\nb"));
    QCOMPARE(TextSnapshot(document).position(1'000), 3);
    QCOMPARE(TextSnapshot().position(1), 0);
    QCOMPARE(TextSnapshot(document).offset(1'000), 4u);
    QCOMPARE(TextSnapshot().offset(1), 0u);
    QCOMPARE(TextSnapshot(document).offset(-1), 0u);
}

void TestTextSnapshot::linesAreThoseOfTheDocument()
{
    QTextDocument document;
    document.setPlainText(QStringLiteral("ä\n\nb🌲\n"));
    const TextSnapshot snapshot(document);
    QCOMPARE(snapshot.lineCount(), std::size_t(4));
    for (QTextBlock block = document.begin(); block.isValid(); block = block.next()) {
        QCOMPARE(std::string(snapshot.line(std::size_t(block.blockNumber()))), block.text().toStdString());
    }
    QCOMPARE(TextSnapshot().lineCount(), std::size_t(1));
    QVERIFY(TextSnapshot().line(0).empty());
}

void TestTextSnapshot::noBreakSpacesStay()
{
    QTextDocument document;
    document.setPlainText(QStringLiteral("v\u00a01 2 3"));
    QCOMPARE(QString::fromStdString(TextSnapshot(document).bytes()), QStringLiteral("v\u00a01 2 3"));
}

void TestTextSnapshot::aSnapshotStaysAsItWas()
{
    QTextDocument document;
    document.setPlainText(QStringLiteral("x. \"a.obj\""));
    const TextSnapshot snapshot(document);
    document.setPlainText(QStringLiteral("y"));
    QCOMPARE(snapshot.bytes(), std::string("x. \"a.obj\""));
}

QTEST_MAIN(TestTextSnapshot)
#include "testtextsnapshot.moc"
