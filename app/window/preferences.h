// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <QFont>
#include <QString>

namespace romanesco {

/// What a person chooses once, for all windows and texts: in $XDG_CONFIG_HOME/romanesco, by default in ~/.config.
struct Preferences {
    enum class Appearance { System, Light, Dark };

    Appearance appearance = Appearance::System;
    /// Of the texts; empty for the system's font of fixed width, which a family that is not there becomes too.
    QString fontFamily;
    /// In points; 0 for the system's.
    int fontSize = 0;
    /// Else long lines are scrolled.
    bool wrapsLines = true;
    /// What was open when the program ended is opened when it starts.
    bool reopensTexts = true;

    bool operator==(const Preferences &) const = default;

    static constexpr int leastFontSize = 6;
    static constexpr int greatestFontSize = 48;

    /// As they were written last; what makes no sense there is as if it were not.
    [[nodiscard]] static Preferences read();
    void write() const;

    [[nodiscard]] QFont editorFont() const;
};

/// Colours all windows as is asked for; where neither Qt nor the platform can, by a palette of our own.
void applyAppearance(Preferences::Appearance appearance);

}
