// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#include <QDialog>
#include <QPushButton>

#include "app/window/differenceview.h"
#include "app/window/documentstrip.h"
#include "documentsample.h"

using namespace romanesco;
using namespace romanesco::test;

namespace {

struct Sample : Folders, DocumentSample {
    DocumentStrip strip{document};

    [[nodiscard]] QStringList buttons() const
    {
        QStringList words;
        for (const QPushButton *button : strip.findChildren<QPushButton *>()) {
            if (!button->isHidden()) {
                words += button->text().remove(u'&');
            }
        }
        return strip.isHidden() ? QStringList() : words;
    }
    void click(const QString &words) const
    {
        for (QPushButton *button : strip.findChildren<QPushButton *>()) {
            if (button->text().remove(u'&') == words && !button->isHidden()) {
                button->click();
                return;
            }
        }
        qFatal("no such button");
    }
    /// Changed by both.
    QString conflict()
    {
        const QString path = write(QStringLiteral("a.fdo"), "old\n");
        static_cast<void>(document.open(path));
        type(QStringLiteral("mine "));
        static_cast<void>(replace(QStringLiteral("a.fdo"), "theirs\n"));
        document.checkFile();
        return path;
    }
};

const QStringList choices{QStringLiteral("Reload"), QStringLiteral("Keep Mine"), QStringLiteral("Show Differences")};

}

class TestDocumentStrip : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void itIsSilentWhileAllIsWell()
    {
        Sample sample;
        QVERIFY(sample.strip.isHidden());
        QVERIFY(sample.document.open(sample.write(QStringLiteral("a.fdo"), "old\n")).has_value());
        sample.type(QStringLiteral("x"));
        QVERIFY(sample.strip.isHidden());
    }

    void ofTwoChangesOneCanBeChosen()
    {
        {
            Sample sample;
            static_cast<void>(sample.conflict());
            QTRY_COMPARE(sample.buttons(), choices);
            QVERIFY(sample.strip.text().contains(QStringLiteral("a.fdo")));
            sample.click(QStringLiteral("Reload"));
            QVERIFY(sample.strip.isHidden());
            QCOMPARE(sample.text(), QByteArray("theirs\n"));
        }
        Sample sample;
        const QString path = sample.conflict();
        QTRY_COMPARE(sample.buttons(), choices);
        sample.click(QStringLiteral("Show Differences"));
        const auto dialogs = QApplication::topLevelWidgets();
        const auto found = std::ranges::find_if(dialogs, [](QWidget *w) { return w->findChild<DifferenceView *>(); });
        QVERIFY(found != dialogs.end() && !(*found)->isModal());
        QCOMPARE((*found)->findChild<DifferenceView *>()->toPlainText(),
                 QStringLiteral("line 1\n− theirs\n+ mine old\n  "));
        sample.click(QStringLiteral("Keep Mine"));
        QVERIFY(sample.strip.isHidden());
        QVERIFY(sample.document.saveAs(path).has_value());
        QCOMPARE(Folders::read(path), QByteArray("mine old\n"));
    }

    void whatIsGoneIsTold()
    {
        Sample sample;
        const QString path = sample.write(QStringLiteral("a.fdo"), "old\n");
        QVERIFY(sample.document.open(path).has_value());
        QVERIFY(QFile::remove(path));
        sample.document.checkFile();
        QTRY_VERIFY(sample.strip.text().contains(QStringLiteral("no longer on the disk")));
        QVERIFY(sample.buttons().isEmpty());
        QVERIFY(QDir().mkdir(path));
        sample.document.checkFile();
        QTRY_VERIFY(sample.strip.text().contains(QStringLiteral("it is a directory")));
        QVERIFY(QDir().rmdir(path));
        QVERIFY(sample.document.saveAs(path).has_value());
        QVERIFY(sample.strip.isHidden());
    }

    void whatIsOpenElsewhereCanBeEditedAnyway()
    {
        Sample sample;
        DocumentSample other;
        const QString path = sample.write(QStringLiteral("a.fdo"), "old\n");
        QVERIFY(other.document.open(path).has_value());
        QVERIFY(sample.document.open(path).has_value());
        QCOMPARE(sample.buttons(), QStringList{QStringLiteral("Edit Anyway")});
        QVERIFY(sample.strip.text().contains(QStringLiteral("another window")));
        sample.click(QStringLiteral("Edit Anyway"));
        QVERIFY(sample.strip.isHidden() && !sample.editor.isReadOnly());
    }
};

QTEST_MAIN(TestDocumentStrip)
#include "testdocumentstrip.moc"
