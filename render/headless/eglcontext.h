// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <expected>
#include <memory>
#include <string>

namespace romanesco {

/// An OpenGL 4.5 context without a window or a display, through EGL: a graphics card where one can be had, else Mesa's
/// software renderer. Current on the thread that created it, as long as it lives.
class EglContext
{
public:
    /// The error is a sentence that says what is missing.
    [[nodiscard]] static std::expected<std::unique_ptr<EglContext>, std::string> create();
    ~EglContext();
    EglContext(const EglContext &) = delete;
    EglContext &operator=(const EglContext &) = delete;

private:
    EglContext() = default;
    void *m_display = nullptr;
    void *m_context = nullptr;
};

}
