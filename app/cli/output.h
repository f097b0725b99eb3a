// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <stop_token>
#include <thread>

#include <QByteArray>
#include <QString>

#include "core/base/bytesink.h"

namespace romanesco::cli {

/// "romanesco: …" on stderr.
void complain(const QString &words);

/// Writes a file whole or not at all (see AtomicFile). `-` is stdout. Complains and returns false where that fails.
[[nodiscard]] bool writeWhole(const QString &file, const QByteArray &bytes);

/// Standard output, for what is too long to be held.
class StandardOutput final : public ByteSink
{
public:
    [[nodiscard]] std::expected<void, std::string> write(std::string_view bytes) override;
};

/// From here on Ctrl-C only asks the command to stop, which looks at isCancelled().
void catchCancel();
[[nodiscard]] bool isCancelled();

/// A stop that Ctrl-C asks for, within some milliseconds. After catchCancel().
class CancelWatch
{
public:
    CancelWatch();
    [[nodiscard]] std::stop_token token() const { return m_stop.get_token(); }

private:
    std::stop_source m_stop;
    std::jthread m_thread;
};

/// One line on stderr that is written over and at last wiped, if stderr is a terminal and progress is wanted.
class Progress
{
public:
    explicit Progress(bool isQuiet);
    ~Progress();
    Progress(const Progress &) = delete;
    Progress &operator=(const Progress &) = delete;
    void show(const QString &words);

private:
    bool m_isShown;
};

}
