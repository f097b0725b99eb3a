// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#include "points.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <format>
#include <utility>

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

#include "core/base/systemerror.h"
#include "core/scene/scenecollider.h"
#include "core/text/unicode.h"
#include "input.h"
#include "output.h"

namespace romanesco::cli {

namespace {

/// Whether there is something to read, or the end; not once cancelled.
bool waitFor(int descriptor)
{
    pollfd waiting{descriptor, POLLIN, 0};
    while (!isCancelled()) {
        if (::poll(&waiting, 1, 100) > 0) {
            return true;
        }
    }
    return false;
}

}

std::expected<PointReader, std::string> PointReader::open(const QString &file)
{
    const std::string name = shownName(file);
    if (file == QLatin1String("-")) {
        return PointReader(STDIN_FILENO, name);
    }
    const int descriptor = ::open(pathOf(file).c_str(), O_RDONLY | O_CLOEXEC);
    return descriptor < 0 ? std::expected<PointReader, std::string>(std::unexpect, systemReason(errno))
                          : PointReader(descriptor, name);
}

PointReader::PointReader(int descriptor, std::string name)
    : m_descriptor(descriptor)
    , m_name(std::move(name))
{
}

PointReader::PointReader(PointReader &&other) noexcept
    : m_descriptor(std::exchange(other.m_descriptor, -1))
    , m_name(std::move(other.m_name))
    , m_bytes(std::move(other.m_bytes))
    , m_taken(other.m_taken)
    , m_isAtEnd(other.m_isAtEnd)
    , m_line(other.m_line)
{
}

PointReader::~PointReader()
{
    if (m_descriptor > STDIN_FILENO) {
        ::close(m_descriptor);
    }
}

bool PointReader::isEmpty() const
{
    return !m_isAtEnd && m_bytes.find('\n', m_taken) == std::string::npos;
}

std::expected<void, std::string> PointReader::fill()
{
    m_bytes.erase(0, m_taken);
    m_taken = 0;
    std::array<char, readBytes> piece;
    if (!waitFor(m_descriptor)) {
        m_isAtEnd = true;
        return {};
    }
    const ssize_t got = ::read(m_descriptor, piece.data(), piece.size());
    if (got < 0 && errno != EINTR) {
        return std::unexpected(std::format("romanesco: cannot read {}: {}", m_name, systemReason(errno)));
    }
    m_isAtEnd = got == 0;
    m_bytes.append(piece.data(), static_cast<std::size_t>(std::max<ssize_t>(got, 0)));
    return {};
}

/// Without its end; none after the last.
std::expected<std::optional<std::string_view>, std::string> PointReader::nextLine()
{
    while (isEmpty() && m_bytes.size() - m_taken < mostLineBytes) {
        if (const auto filled = fill(); !filled) {
            return std::unexpected(filled.error());
        }
    }
    if (isCancelled() || m_taken == m_bytes.size()) {
        return std::nullopt;
    }
    ++m_line;
    const std::size_t end = std::min(m_bytes.find('\n', m_taken), m_bytes.size());
    if (end - m_taken >= mostLineBytes) {
        return std::unexpected(
            slip({1, std::format("the line is longer than {} bytes; a point is three numbers, x y z", mostLineBytes)}));
    }
    const std::string_view line = std::string_view(m_bytes).substr(m_taken, end - m_taken);
    m_taken = std::min(end + 1, m_bytes.size());
    return line;
}

std::expected<std::optional<glm::dvec3>, std::string> PointReader::next()
{
    while (true) {
        const auto found = nextLine();
        if (!found || !*found) {
            return found ? std::expected<std::optional<glm::dvec3>, std::string>() : std::unexpected(found.error());
        }
        std::string_view line = **found;
        if (m_line == 1 && line.starts_with(byteOrderMark)) {
            line.remove_prefix(byteOrderMark.size());
        }
        const auto point = pointOf(line, SceneCollider::farthest);
        if (!point) {
            return std::unexpected(slip(point.error()));
        }
        if (*point) {
            return *point;
        }
    }
}

std::string PointReader::slip(const PointSlip &slip) const
{
    return std::format("{}:{}:{}: error: {}", m_name, m_line, slip.column, slip.words);
}

}
