// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#include "output.h"

#include <atomic>
#include <csignal>
#include <cstdio>
#include <print>

#include <QFile>
#include <QFileInfo>
#include <QSaveFile>

#include <unistd.h>

namespace romanesco::cli {

namespace {

std::atomic<bool> cancelled = false;

}

void complain(const QString &words)
{
    std::println(stderr, "romanesco: {}", words.toStdString());
}

bool writeWhole(const QString &file, const QByteArray &bytes)
{
    const auto fail = [&](const QString &reason) {
        complain(QStringLiteral("cannot write %1: %2").arg(file, reason));
        return false;
    };
    if (file == QLatin1String("-")) {
        QFile output;
        const bool isWritten =
            output.open(stdout, QIODevice::WriteOnly) && output.write(bytes) == bytes.size() && output.flush();
        return isWritten || fail(output.errorString());
    }
    const QFileInfo info(file);
    if (info.exists() && !info.isFile()) {
        return fail(QStringLiteral("it is not a regular file"));
    }
    QSaveFile output(file);
    const bool isWritten = output.open(QIODevice::WriteOnly) && output.write(bytes) == bytes.size() && output.flush()
        && ::fsync(output.handle()) == 0 && output.commit();
    return isWritten || fail(output.errorString());
}

void catchCancel()
{
    struct sigaction action{};
    action.sa_handler = [](int) { cancelled = true; };
    ::sigaction(SIGINT, &action, nullptr);
    ::sigaction(SIGTERM, &action, nullptr);
}

bool isCancelled()
{
    return cancelled;
}

Progress::Progress(bool isQuiet)
    : m_isShown(!isQuiet && ::isatty(STDERR_FILENO))
{
}

Progress::~Progress()
{
    if (m_isShown) {
        std::print(stderr, "\r\033[K");
    }
}

void Progress::show(const QString &words)
{
    if (m_isShown) {
        std::print(stderr, "\r{}\033[K", words.toStdString());
    }
}

}
