// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#include "output.h"

#include <atomic>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <print>

#include <QFile>

#include <unistd.h>

#include "core/base/atomicfile.h"
#include "core/base/systemerror.h"

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
    const std::string_view all(bytes.data(), static_cast<std::size_t>(bytes.size()));
    const auto written = file == QLatin1String("-") ? StandardOutput().write(all)
                                                    : romanesco::writeWhole(QFile::encodeName(file).toStdString(), all);
    if (!written) {
        complain(QStringLiteral("cannot write %1: %2").arg(file, QString::fromStdString(written.error())));
    }
    return written.has_value();
}

std::expected<void, std::string> StandardOutput::write(std::string_view bytes)
{
    // what stdio may still hold goes first, and it would not tell the reason of an error
    std::fflush(stdout);
    while (!bytes.empty()) {
        const ssize_t written = ::write(STDOUT_FILENO, bytes.data(), bytes.size());
        if (written < 0 && errno != EINTR) {
            return std::unexpected(systemReason(errno));
        }
        bytes.remove_prefix(written < 0 ? 0 : static_cast<std::size_t>(written));
    }
    return {};
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

CancelWatch::CancelWatch()
    : m_thread([stop = m_stop](const std::stop_token &end) mutable {
        while (!end.stop_requested() && !isCancelled()) {
            std::this_thread::sleep_for(std::chrono::milliseconds(10));
        }
        if (isCancelled()) {
            stop.request_stop();
        }
    })
{
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
