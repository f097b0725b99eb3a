// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#include "journal.h"

#include <utility>

#include <QFile>
#include <QUuid>

#include "document.h"
#include "userfolders.h"

namespace romanesco {

namespace {

/// What a machine that loses its power takes with it. More often would keep disks awake.
constexpr std::chrono::seconds settlePause(5);

}

JournalSession::JournalSession()
    : JournalSession([] { return dataFolder("journals"); })
{
}

JournalSession::JournalSession(FindFolder findFolder)
    : m_findFolder(std::move(findFolder))
    , m_name(QUuid::createUuid().toString(QUuid::Id128).toStdString())
{
}

std::expected<std::unique_ptr<TextJournal>, std::string> JournalSession::newJournal()
{
    const std::lock_guard guard(m_mutex);
    const auto folder = m_findFolder();
    if (!folder) {
        return std::unexpected(folder.error());
    }
    if (!m_lock) {
        auto lock = FileLock::take(*folder / (m_name + ".lock"));
        // Where there are no locks, a journal that seems to be given up is better than none.
        if (lock) {
            m_lock = std::move(*lock);
        }
    }
    return std::make_unique<TextJournal>(*folder, m_name + '.' + std::to_string(++m_count));
}

Journal::Journal(Document &document, JournalSession &session, QObject *parent)
    : QObject(parent)
    , m_document(document)
    , m_session(session)
    , m_settled(std::chrono::steady_clock::now())
    , m_settler([this](int, const std::stop_token &stop) { settle(stop); })
    , m_writer([this](const Entry &entry, const std::stop_token &) { write(entry); })
{
    connect(&document, &Document::textChanged, this, &Journal::post);
    connect(&document, &Document::modifiedChanged, this, &Journal::post);
    connect(&document, &Document::nameChanged, this, &Journal::post);
    connect(&document, &Document::saved, this, &Journal::post);
    post();
}

Journal::~Journal()
{
    // The writer drops what waits and ends before the file does.
    disconnect(&m_document, nullptr, this, nullptr);
    m_posted += 1;
    m_writer.post(Entry{m_posted, false, {}, 0, {}});
    static_cast<void>(waitUntilWritten(std::chrono::seconds(10)));
}

void Journal::post()
{
    // Nothing was ever to be kept, and nothing is.
    if (m_posted == 0 && !m_document.isModified()) {
        return;
    }
    m_writer.post(Entry{++m_posted, m_document.isModified(), QFile::encodeName(m_document.path()).toStdString(),
                        m_document.checksumOnDisk(), m_document.text()});
}

bool Journal::waitUntilWritten(std::chrono::milliseconds most) const
{
    std::unique_lock lock(m_mutex);
    return m_advanced.wait_for(lock, most, [this] { return m_written >= m_posted; }) && m_isWritten;
}

/// On the writer's thread.
void Journal::write(const Entry &entry)
{
    bool isWritten = true;
    if (entry.isKept) {
        const auto result = put(entry);
        isWritten = result.has_value();
        say(result ? settled() : result);
        m_settler.post(0);
    } else {
        if (m_file) {
            m_file->remove();
        }
        say({}); // nothing is in danger
    }
    {
        const std::lock_guard lock(m_mutex);
        m_written = entry.number;
        m_isWritten = isWritten;
    }
    m_advanced.notify_all();
}

std::expected<void, std::string> Journal::put(const Entry &entry)
{
    if (!m_file) {
        auto file = m_session.newJournal();
        if (!file) {
            return std::unexpected(file.error());
        }
        const std::lock_guard lock(m_mutex);
        m_file = std::move(*file);
    }
    return m_file->put({entry.path, entry.onDisk, entry.text.bytes()});
}

/// On the settler's thread. A newer one takes its place while it waits.
void Journal::settle(const std::stop_token &stop)
{
    std::unique_lock lock(m_mutex);
    std::condition_variable_any sleep;
    sleep.wait_until(lock, stop, m_settled + settlePause, [] { return false; });
    const std::shared_ptr<TextJournal> file = m_file;
    if (stop.stop_requested() || !file) {
        return;
    }
    lock.unlock();
    const auto result = file->settle();
    if (!result) {
        say(result);
    }
    lock.lock();
    m_settleResult = result;
    m_settled = std::chrono::steady_clock::now();
}

std::expected<void, std::string> Journal::settled() const
{
    const std::lock_guard lock(m_mutex);
    return m_settleResult;
}

void Journal::say(const std::expected<void, std::string> &result)
{
    const QString trouble = result ? QString() : QString::fromStdString(result.error());
    QMetaObject::invokeMethod(
        this,
        [this, trouble] {
            if (trouble != m_trouble) {
                m_trouble = trouble;
                Q_EMIT troubleChanged(trouble);
            }
        },
        Qt::QueuedConnection);
}

}
