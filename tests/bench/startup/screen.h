// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <memory>

namespace romanesco::bench {

/// What a display of X11 shows, which nothing but the measured program draws on.
class Screen
{
public:
    /// Of the variable DISPLAY; exits with a message where there is none.
    Screen();
    ~Screen();

    /// Some of what is on the screen, looked at on a grid.
    struct Look {
        /// Something else than the root's black.
        bool isPainted = false;
        /// The colour of a surface under the head light, in as many places as a fractal covers.
        bool hasFractal = false;
    };
    [[nodiscard]] Look look() const;

private:
    struct Connection;
    std::unique_ptr<Connection> m_connection;
};

}
