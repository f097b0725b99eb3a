// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include <QDir>
#include <QRegularExpression>
#include <QTest>

#include "core/scene/sceneloader.h"
#include "tests/sourcetree.h"
#include "tests/testmain.h"

namespace romanesco::test {

/// The texts that the documentation shows, as who copies them would read them: beside the examples' meshes.
class TestGuide : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void itsTextsAreFreeOfRemarks_data();
    void itsTextsAreFreeOfRemarks();
};

void TestGuide::itsTextsAreFreeOfRemarks_data()
{
    QTest::addColumn<QString>("kind");
    QTest::addColumn<QString>("text");
    const QDir docs(test::sourcePath("docs"));
    const QRegularExpression fence(QStringLiteral("^```(fdo|sdo)\\n(.*?)^```$"),
                                   QRegularExpression::MultilineOption
                                       | QRegularExpression::DotMatchesEverythingOption);
    for (const QString &name : docs.entryList({QStringLiteral("*.md")})) {
        QFile page(docs.filePath(name));
        QVERIFY(page.open(QIODevice::ReadOnly));
        const QString words = QString::fromUtf8(page.readAll());
        for (const auto &found : fence.globalMatch(words)) {
            const auto line = words.first(found.capturedStart()).count(u'\n') + 1;
            QTest::addRow("%s:%lld", qPrintable(name), static_cast<long long>(line))
                << found.captured(1) << found.captured(2);
        }
    }
}

void TestGuide::itsTextsAreFreeOfRemarks()
{
    QFETCH(const QString, kind);
    QFETCH(const QString, text);
    const DiskFiles files;
    const std::string path = test::sourcePath("resources/examples/guide.").toStdString() + kind.toStdString();
    const SceneResult result = SceneLoader(files).load(path, text.toStdString());
    for (const Diagnostic &remark : result.diagnostics) {
        QFAIL(remark.message().c_str());
    }
    QVERIFY(result.scene);
    QVERIFY(!result.scene->items.empty());
}

}

ROMANESCO_TEST(romanesco::test::TestGuide)

#include "testguide.moc"
