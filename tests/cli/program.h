// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <QFile>
#include <QProcess>
#include <QTest>

#include "tests/sourcetree.h"

/// Runs the program itself.
namespace romanesco::test {

struct Outcome {
    int status = -1;
    bool isCrash = false;
    QByteArray out;
    QByteArray err;
};

inline Outcome outcomeOf(QProcess &process)
{
    process.waitForFinished(120'000);
    return {process.exitCode(), process.exitStatus() == QProcess::CrashExit, process.readAllStandardOutput(),
            process.readAllStandardError()};
}

inline Outcome run(const QStringList &arguments, const QByteArray &input = {},
                   const QProcessEnvironment &environment = QProcessEnvironment::systemEnvironment())
{
    QProcess process;
    process.setProcessEnvironment(environment);
    process.start(QStringLiteral(ROMANESCO_PROGRAM), arguments);
    process.write(input);
    process.closeWriteChannel();
    return outcomeOf(process);
}

inline void write(const QString &path, const QByteArray &bytes)
{
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly));
    QCOMPARE(file.write(bytes), bytes.size());
}

inline QByteArray bytesOf(const QString &path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray("cannot be read");
}

inline const QString examples = test::sourcePath("resources/examples/");
inline const QByteArray triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

}
