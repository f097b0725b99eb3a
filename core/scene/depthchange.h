// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <atomic>
#include <string>

#include "core/base/file.h"
#include "scene.h"

namespace romanesco {

/// Files as they are, but each .fdo text with another depth (see FractalDescription::Depth).
class DepthChange final : public FileAccess
{
public:
    /// For a picture that goes on wherever a view leads: views end before that, at some hundred thousand levels.
    static constexpr const char *endless = "1000000";

    /// digits are a whole number, or empty for no change; files must outlive it.
    DepthChange(const FileAccess &files, std::string digits);

    /// An .fdo text with the other depth, or as it is where it says none or has errors.
    [[nodiscard]] std::string changed(std::string text) const;

    [[nodiscard]] std::expected<std::string, std::string> read(const std::filesystem::path &path) const override;
    [[nodiscard]] std::expected<void, std::string> check(const std::filesystem::path &path) const override;

    /// Whether there is a change to make and no text yet had a depth.
    [[nodiscard]] bool isInVain() const { return !m_digits.empty() && !m_hasChanged; }

private:
    const FileAccess &m_files;
    std::string m_digits;
    mutable std::atomic<bool> m_hasChanged = false;
};

/// Whether every fractal comes closer and closer to a shape as its depth grows, as its maps shrink what they repeat. Others
/// have no picture without end.
[[nodiscard]] bool isConvergent(const Scene &scene);

}
