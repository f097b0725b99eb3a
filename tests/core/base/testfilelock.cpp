// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "core/base/filelock.h"

#include <atomic>
#include <filesystem>
#include <thread>
#include <vector>

#include <csignal>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include "tests/testmain.h"

namespace romanesco::test {

/// Locks between places of one process, and between processes.
class TestFileLock : public QObject
{
    Q_OBJECT

    QTemporaryDir m_folder;
    [[nodiscard]] std::filesystem::path path(const char *name) const
    {
        return m_folder.filePath(QLatin1String(name)).toStdString();
    }

private Q_SLOTS:
    void oneAtATimeHasIt()
    {
        auto first = FileLock::take(path("a"));
        QVERIFY(first.has_value());
        const auto second = FileLock::take(path("a"));
        QVERIFY(!second && second.error().isHeld);
        QVERIFY(FileLock::take(path("b")).has_value());
        FileLock moved = std::move(*first);
        QVERIFY(!FileLock::take(path("a")));
        first = FileLock::take(path("c"));
        QVERIFY(!FileLock::take(path("a")) && !FileLock::take(path("c")));
    }

    void givenBackItIsFreeAndItsFileIsGone()
    {
        {
            const auto lock = FileLock::take(path("d"));
            QVERIFY(std::filesystem::exists(path("d")));
        }
        QVERIFY(!std::filesystem::exists(path("d")));
        QVERIFY(FileLock::take(path("d")).has_value());
    }

    /// Whatever number the file of a lock might hold: only the process counts.
    void aProcessThatIsKilledHasItNoMore()
    {
        int pipe[2];
        QVERIFY(::pipe(pipe) == 0);
        const pid_t child = ::fork();
        if (child == 0) {
            ::alarm(30); // where the test fails before it ends it
            const auto lock = FileLock::take(path("e"));
            const char answer = lock ? 'y' : 'n';
            ::_exit(::write(pipe[1], &answer, 1) == 1 ? ::pause() : 1);
        }
        char answer = 0;
        QVERIFY(::read(pipe[0], &answer, 1) == 1 && answer == 'y');
        const auto held = FileLock::take(path("e"));
        QVERIFY(!held && held.error().isHeld);
        ::kill(child, SIGKILL);
        ::waitpid(child, nullptr, 0);
        QVERIFY(std::filesystem::exists(path("e")));
        QVERIFY(FileLock::take(path("e")).has_value());
        ::close(pipe[0]);
        ::close(pipe[1]);
    }

    void whatCannotBeLockedIsToldWithItsReason()
    {
        const auto nowhere = FileLock::take(path("no/such/folder"));
        QVERIFY(!nowhere && !nowhere.error().isHeld);
        QCOMPARE(nowhere.error().reason, "no such file");
        QVERIFY(!FileLock::take(m_folder.path().toStdString()));
        // Not what a link leads to.
        QVERIFY(QFile::link(m_folder.filePath(QStringLiteral("target")), m_folder.filePath(QStringLiteral("link"))));
        QVERIFY(!FileLock::take(path("link")));
        QVERIFY(!std::filesystem::exists(path("target")));
    }

    /// Its file comes and goes all the time.
    void neverHaveTwoThreadsIt()
    {
        std::atomic<int> holders = 0;
        std::atomic<int> taken = 0;
        std::atomic<bool> isBroken = false;
        std::vector<std::jthread> threads;
        for (int i = 0; i < 4; ++i) {
            threads.emplace_back([&] {
                while (taken < 2'000) {
                    if (const auto lock = FileLock::take(path("f"))) {
                        isBroken = isBroken || ++holders != 1;
                        ++taken;
                        std::this_thread::yield();
                        isBroken = isBroken || holders != 1;
                        --holders;
                    }
                }
            });
        }
        threads.clear();
        QVERIFY(!isBroken);
    }
};

}

ROMANESCO_TEST(romanesco::test::TestFileLock)

#include "testfilelock.moc"
