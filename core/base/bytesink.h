// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <cassert>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <expected>
#include <memory>
#include <string>
#include <string_view>

namespace romanesco {

/// Where bytes go, in order: a file, a pipe, a counter.
class ByteSink
{
public:
    virtual ~ByteSink() = default;

    /// Takes all the bytes, or gives the reason why not ("disk full"). After an error nothing more is given to it.
    [[nodiscard]] virtual std::expected<void, std::string> write(std::string_view bytes) = 0;
};

/// Keeps nothing but the number of the bytes.
class CountingSink final : public ByteSink
{
public:
    [[nodiscard]] std::expected<void, std::string> write(std::string_view bytes) override
    {
        m_count += bytes.size();
        return {};
    }
    [[nodiscard]] std::uint64_t count() const { return m_count; }

private:
    std::uint64_t m_count = 0;
};

/// Gathers small pieces for a sink, so that a piece costs no call. Once the sink has failed all else is dropped; the
/// reason waits in flush(), which must be called at the end.
class BufferedOutput
{
public:
    /// The most that room() gives.
    static constexpr std::size_t mostRoom = 65'536;

    /// sink must outlive it.
    explicit BufferedOutput(ByteSink &sink)
        : m_sink(sink)
    {
    }

    /// Where the next `most` bytes may be written, which take() then takes up to `end`.
    [[nodiscard]] char *room(std::size_t most)
    {
        assert(most <= mostRoom && "larger pieces go through append()");
        if (capacity - m_used < most) {
            empty();
        }
        return m_bytes.get() + m_used;
    }
    void take(const char *end)
    {
        m_used = static_cast<std::size_t>(end - m_bytes.get());
        assert(m_used <= capacity && "more was written than there was room for");
    }

    void append(std::string_view bytes)
    {
        while (!bytes.empty()) {
            const std::string_view piece = bytes.substr(0, mostRoom);
            char *to = room(piece.size());
            std::memcpy(to, piece.data(), piece.size());
            take(to + piece.size());
            bytes.remove_prefix(piece.size());
        }
    }

    /// Whether the sink takes what it is given; looked at now and then, it saves work that leads nowhere.
    [[nodiscard]] bool isGood() const { return m_result.has_value(); }
    /// Bytes that came, wherever they are now.
    [[nodiscard]] std::uint64_t count() const { return m_emptied + m_used; }

    /// Everything to the sink. The error is the first that there was.
    [[nodiscard]] std::expected<void, std::string> flush()
    {
        empty();
        return m_result;
    }

private:
    static constexpr std::size_t capacity = 4 * mostRoom;

    void empty()
    {
        if (m_result && m_used > 0) {
            m_result = m_sink.write({m_bytes.get(), m_used});
        }
        m_emptied += m_used;
        m_used = 0;
    }

    ByteSink &m_sink;
    std::unique_ptr<char[]> m_bytes = std::make_unique_for_overwrite<char[]>(capacity);
    std::size_t m_used = 0;
    std::uint64_t m_emptied = 0;
    std::expected<void, std::string> m_result;
};

}
