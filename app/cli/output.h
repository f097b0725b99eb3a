// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <QByteArray>
#include <QString>

namespace romanesco::cli {

/// "romanesco: …" on stderr.
void complain(const QString &words);

/// Writes a file whole or not at all: to a file beside it that takes its name at the end. `-` is stdout. Only regular
/// files are written over. Complains and returns false where that fails.
[[nodiscard]] bool writeWhole(const QString &file, const QByteArray &bytes);

/// From here on Ctrl-C only asks the command to stop, which looks at isCancelled().
void catchCancel();
[[nodiscard]] bool isCancelled();

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
