// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <expected>
#include <filesystem>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include <QObject>

#include "core/base/filelock.h"
#include "core/base/newestjob.h"
#include "core/text/textjournal.h"
#include "editor/textsnapshot.h"

namespace romanesco {

class Document;

/// The journals of one process: files SESSION.NUMBER.GENERATION (see TextJournal) in a folder, and SESSION.lock, which is
/// locked as long as the process lives. Calls may come from any thread.
class JournalSession
{
public:
    /// Called when the first text is written, and again as long as it fails; makes the folder.
    using FindFolder = std::function<std::expected<std::filesystem::path, std::string>()>;

    /// In the data folder.
    JournalSession();
    explicit JournalSession(FindFolder findFolder);

    /// The folder, and a name in it that no other journal has.
    [[nodiscard]] std::expected<std::unique_ptr<TextJournal>, std::string> newJournal();

private:
    std::mutex m_mutex;
    FindFolder m_findFolder;
    std::string m_name;
    unsigned m_count = 0;
    std::optional<FileLock> m_lock;
};

/// Writes what is typed into a document to a journal, at once and in the background, as long as the document is modified:
/// whatever ends the process, Recovery finds the text again. Once it is saved, undone or closed, nothing is kept.
class Journal : public QObject
{
    Q_OBJECT
public:
    /// Both must outlive it.
    Journal(Document &document, JournalSession &session, QObject *parent = nullptr);
    /// The text is saved or given up: nothing stays.
    ~Journal() override;

    /// Whether all that was typed is handed over to the system, or became so within the time.
    [[nodiscard]] bool waitUntilWritten(std::chrono::milliseconds most) const;

    /// Why the text is not safe now; empty while it is.
    [[nodiscard]] const QString &trouble() const { return m_trouble; }

Q_SIGNALS:
    /// A phrase; once for as long as it lasts, and empty when it is over.
    void troubleChanged(const QString &reason);

private:
    struct Entry {
        std::uint64_t number = 0;
        /// Nothing where there is nothing to lose.
        bool isKept = false;
        std::string path;
        std::uint64_t onDisk = 0;
        TextSnapshot text;
    };
    void post();
    void write(const Entry &entry);
    [[nodiscard]] std::expected<void, std::string> put(const Entry &entry);
    void settle(const std::stop_token &stop);
    [[nodiscard]] std::expected<void, std::string> settled() const;
    void say(const std::expected<void, std::string> &result);

    Document &m_document;
    JournalSession &m_session;
    QString m_trouble;
    std::uint64_t m_posted = 0;

    mutable std::mutex m_mutex;
    mutable std::condition_variable m_advanced;
    std::uint64_t m_written = 0;
    bool m_isWritten = true;
    /// Made by the writer; the other threads use it then.
    std::shared_ptr<TextJournal> m_file;
    std::chrono::steady_clock::time_point m_settled;
    std::expected<void, std::string> m_settleResult;

    /// Last: they use the rest. The disk may take its time, what is typed meanwhile need not wait for it.
    NewestJob<int> m_settler;
    NewestJob<Entry> m_writer;
};

}
