// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#include "preferences.h"

#include <QApplication>
#include <QDir>
#include <QFontDatabase>
#include <QPalette>
#include <QSettings>
#include <QStyleHints>

namespace romanesco {

namespace {

using Appearance = Preferences::Appearance;

QString configFile()
{
    QString folder = qEnvironmentVariable("XDG_CONFIG_HOME");
    if (!QDir::isAbsolutePath(folder)) { // as the standard asks
        folder = QDir::home().filePath(QStringLiteral(".config"));
    }
    return folder + QStringLiteral("/romanesco/settings.ini");
}

QString nameOf(Appearance appearance)
{
    switch (appearance) {
    case Appearance::System:
        break;
    case Appearance::Light:
        return QStringLiteral("light");
    case Appearance::Dark:
        return QStringLiteral("dark");
    }
    return QStringLiteral("system");
}

Appearance appearanceNamed(const QString &name)
{
    for (const Appearance appearance : {Appearance::Light, Appearance::Dark}) {
        if (name == nameOf(appearance)) {
            return appearance;
        }
    }
    return Appearance::System;
}

/// Neutral, with one accent: what a palette is made of.
struct Tones {
    QColor window;
    QColor base;
    QColor button;
    QColor ink;
    QColor quiet;
    QColor accent;
    QColor link;
};

constexpr QColor onAccent(0xff, 0xff, 0xff);

QPalette paletteOf(const Tones &tones)
{
    QPalette palette(tones.button, tones.window);
    using enum QPalette::ColorRole;
    for (const QPalette::ColorRole role : {WindowText, Text, ButtonText, ToolTipText}) {
        palette.setColor(role, tones.ink);
        palette.setColor(QPalette::Disabled, role, tones.quiet);
    }
    palette.setColor(Base, tones.base);
    palette.setColor(AlternateBase, tones.window);
    palette.setColor(ToolTipBase, tones.button);
    palette.setColor(PlaceholderText, tones.quiet);
    palette.setColor(Highlight, tones.accent);
    palette.setColor(HighlightedText, onAccent);
    palette.setColor(Link, tones.link);
    palette.setColor(LinkVisited, tones.link);
    return palette;
}

QPalette ownPalette(bool isDark)
{
    return isDark ? paletteOf({QColor(0x2a, 0x2b, 0x2e), QColor(0x1e, 0x1f, 0x22), QColor(0x36, 0x38, 0x3c),
                               QColor(0xe6, 0xe6, 0xe6), QColor(0x8c, 0x8f, 0x94), QColor(0x2f, 0x6f, 0xb0),
                               QColor(0x7a, 0xb4, 0xf0)})
                  : paletteOf({QColor(0xef, 0xf0, 0xf1), QColor(0xff, 0xff, 0xff), QColor(0xf7, 0xf7, 0xf8),
                               QColor(0x1f, 0x20, 0x22), QColor(0x7a, 0x7d, 0x82), QColor(0x2f, 0x6f, 0xb0),
                               QColor(0x1d, 0x5c, 0x9e)});
}

void askSystem([[maybe_unused]] Appearance appearance)
{
#if QT_VERSION >= QT_VERSION_CHECK(6, 8, 0)
    QStyleHints &hints = *QGuiApplication::styleHints();
    if (appearance == Appearance::System) {
        hints.unsetColorScheme();
    } else {
        hints.setColorScheme(appearance == Appearance::Dark ? Qt::ColorScheme::Dark : Qt::ColorScheme::Light);
    }
#endif
}

}

Preferences Preferences::read()
{
    const QSettings file(configFile(), QSettings::IniFormat);
    Preferences read;
    read.appearance = appearanceNamed(file.value("appearance").toString());
    read.fontFamily = file.value("font/family").toString();
    const int size = file.value("font/size").toInt();
    read.fontSize = size >= leastFontSize && size <= greatestFontSize ? size : 0;
    read.wrapsLines = file.value("wrap", read.wrapsLines).toBool();
    read.reopensTexts = file.value("reopen", read.reopensTexts).toBool();
    return read;
}

void Preferences::write() const
{
    QSettings file(configFile(), QSettings::IniFormat);
    file.setValue("appearance", nameOf(appearance));
    file.setValue("font/family", fontFamily);
    file.setValue("font/size", fontSize);
    file.setValue("wrap", wrapsLines);
    file.setValue("reopen", reopensTexts);
}

QFont Preferences::editorFont() const
{
    QFont font = QFontDatabase::systemFont(QFontDatabase::FixedFont);
    if (QFontDatabase::hasFamily(fontFamily)) {
        font.setFamily(fontFamily);
    }
    if (fontSize > 0) {
        font.setPointSize(fontSize);
    }
    return font;
}

void applyAppearance(Appearance appearance)
{
    QApplication::setPalette(QPalette());
    askSystem(appearance);
    const bool isDark = QApplication::palette().color(QPalette::Base).lightness() < 128;
    const bool wantsDark = appearance == Appearance::Dark;
    if (appearance != Appearance::System && isDark != wantsDark) {
        QApplication::setPalette(ownPalette(wantsDark));
    }
}

}
