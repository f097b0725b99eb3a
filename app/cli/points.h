// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <cstdint>
#include <expected>
#include <optional>
#include <string>
#include <string_view>

#include <QString>
#include <glm/vec3.hpp>

#include "core/formats/pointline.h"

namespace romanesco::cli {

/// Reads a file of points, a line each (pointOf()), as it goes: some 70 KB are held, however long it is. Ctrl-C ends it, after catchCancel(), also
/// while it waits for a pipe.
class PointReader
{
public:
    /// `-` is stdin; pipes and devices can be read too. The error completes "cannot read …: ".
    [[nodiscard]] static std::expected<PointReader, std::string> open(const QString &file);

    PointReader(PointReader &&other) noexcept;
    PointReader &operator=(PointReader &&) = delete;
    ~PointReader();

    /// Whether next() will have to read first, which may wait.
    [[nodiscard]] bool isEmpty() const;

    /// The next point, or none at the end, and once cancelled. The error is a line for people, `FILE:LINE:COL: error: …` or
    /// about the file as a whole; after it nothing more can be read.
    [[nodiscard]] std::expected<std::optional<glm::dvec3>, std::string> next();

private:
    /// Of a line, its end included: far more than three numbers take.
    static constexpr std::size_t mostLineBytes = 4'096;
    static constexpr std::size_t readBytes = 65'536;

    PointReader(int descriptor, std::string name);
    [[nodiscard]] std::expected<void, std::string> fill();
    [[nodiscard]] std::expected<std::optional<std::string_view>, std::string> nextLine();
    [[nodiscard]] std::string slip(const PointSlip &slip) const;

    int m_descriptor;
    std::string m_name;
    std::string m_bytes;
    /// Of m_bytes, what is taken.
    std::size_t m_taken = 0;
    bool m_isAtEnd = false;
    std::uint64_t m_line = 0;
};

}
