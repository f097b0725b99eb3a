// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#include <chrono>
#include <cstring>
#include <map>
#include <random>

#include <csignal>
#include <unistd.h>

#include <QApplication>
#include <QProcess>
#include <QTimer>

#include "app/window/journal.h"
#include "app/window/recovery.h"
#include "core/text/textjournal.h"
#include "documentsample.h"

using namespace romanesco;
using namespace romanesco::test;

namespace {

/// What was on the screen from then on.
struct Shown {
    std::int64_t nanoseconds;
    std::uint64_t checksum;
};

std::int64_t now()
{
    return std::chrono::steady_clock::now().time_since_epoch().count(); // the system's, the same in all processes
}

/// The child: types until it is killed, and says each text before anybody writes it down.
class Typist : public QObject
{
public:
    Typist(const QString &file, unsigned seed)
        : m_file(file)
        , m_random(seed)
    {
        connect(&m_sample.document, &Document::textChanged, this, &Typist::say); // before the journal
        m_journal.emplace(m_sample.document, m_session);
        if (seed % 3 != 0 && !m_sample.document.open(file)) {
            qFatal("cannot open the file");
        }
        say();
        connect(&m_timer, &QTimer::timeout, this, &Typist::act);
        m_timer.start(1);
    }

private:
    void say()
    {
        const Shown shown{now(), checksum(m_sample.document.text().bytes())};
        if (::write(STDOUT_FILENO, &shown, sizeof shown) != sizeof shown) {
            qFatal("nobody listens");
        }
    }

    void act()
    {
        FdoEditor &editor = m_sample.editor;
        QTextCursor cursor = editor.textCursor();
        switch (m_random() % 40) {
        case 0:
            cursor.insertText(QString(5'000, u'x') + u'\n');
            break;
        case 1:
            editor.undo();
            break;
        case 2:
            editor.redo();
            break;
        case 3:
            cursor.setPosition(int(m_random() % static_cast<unsigned>(editor.document()->characterCount())));
            editor.setTextCursor(cursor);
            break;
        case 4:
            cursor.setPosition(int(m_random() % static_cast<unsigned>(editor.document()->characterCount())),
                               QTextCursor::KeepAnchor);
            cursor.removeSelectedText();
            break;
        case 5:
            if (m_random() % 4 == 0) {
                m_sample.document.startSaving(m_file);
            }
            break;
        default:
            cursor.insertText(m_random() % 10 ? QStringLiteral("ä%1 ").arg(m_random() % 100) : QStringLiteral("\n"));
        }
    }

    QString m_file;
    std::mt19937 m_random;
    DocumentSample m_sample;
    JournalSession m_session;
    std::optional<Journal> m_journal;
    QTimer m_timer;
};

std::vector<Shown> shownIn(const QByteArray &bytes)
{
    std::vector<Shown> all(static_cast<std::size_t>(bytes.size()) / sizeof(Shown));
    std::memcpy(all.data(), bytes.constData(), all.size() * sizeof(Shown));
    return all;
}

}

/// A process that edits is killed at any moment, and its text is found again.
class TestJournalKills : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void nothingOlderThanASecondIsLost()
    {
        const int kills = std::max(qEnvironmentVariableIntValue("ROMANESCO_TEST_KILLS"), 6);
        std::mt19937 random(1);
        int found = 0;
        std::int64_t oldest = 0;
        for (int i = 0; i < kills; ++i) {
            const Folders folders;
            const QString file = folders.write(QStringLiteral("a.fdo"), "old\n");
            QProcess child;
            child.setProcessChannelMode(QProcess::SeparateChannels);
            child.start(QCoreApplication::applicationFilePath(), {QStringLiteral("--type"), file, QString::number(i)});
            QVERIFY(child.waitForReadyRead(60'000));
            QTest::qWait(int(random() % 1'200));
            const std::int64_t killed = now();
            ::kill(static_cast<pid_t>(child.processId()), SIGKILL);
            QVERIFY(child.waitForFinished());
            const std::vector<Shown> shown = shownIn(child.readAllStandardOutput());
            QVERIFY2(!shown.empty(), child.readAllStandardError().constData());

            // What was not saved is in the journal, all else in the file.
            const ResourceFiles files;
            const Recovery recovery = Recovery::search(files);
            QVERIFY(recovery.texts().size() <= 1);
            found += recovery.texts().empty() ? 0 : 1;
            QByteArray kept = Folders::read(file);
            if (i % 3 == 0 && kept == "old\n") {
                kept.clear(); // a new text, of which nothing was saved
            }
            const std::string text = recovery.texts().empty() ? kept.toStdString() : recovery.texts().front().text;
            // The last time it was shown, and until when.
            std::int64_t until = 0;
            for (std::size_t k = 0; k < shown.size(); ++k) {
                if (shown[k].checksum == checksum(text)) {
                    until = k + 1 < shown.size() ? shown[k + 1].nanoseconds : killed;
                }
            }
            QVERIFY2(until > killed - 1'000'000'000,
                     qPrintable(QStringLiteral("run %1: %2 ms before").arg(i).arg((killed - until) / 1'000'000)));
            oldest = std::max(oldest, killed - until);
        }
        qInfo("%d kills, %d journals, the oldest text was %.1f ms old", kills, found, double(oldest) / 1e6);
        QVERIFY(found > kills / 2);
    }
};

int main(int argc, char **argv)
{
    const QApplication application(argc, argv);
    const QStringList arguments = QCoreApplication::arguments();
    if (arguments.size() == 4 && arguments[1] == QLatin1String("--type")) {
        const Typist typist(arguments[2], arguments[3].toUInt());
        return QApplication::exec();
    }
    TestJournalKills test;
    return QTest::qExec(&test, argc, argv);
}

#include "testjournalkills.moc"
