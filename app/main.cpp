// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <new>
#include <print>
#include <thread>

#include <QApplication>
#include <QFileInfo>
#include <QFontDatabase>
#include <QIcon>
#include <QOffscreenSurface>
#include <QStyle>
#include <QSurfaceFormat>

#include "cli/commandline.h"
#include "cli/output.h"
#include "editor/syntax.h"
#include "window/mainwindow.h"
#include "window/preferences.h"
#include "window/windowstyle.h"

namespace {

using namespace romanesco;

/// A platform that needs nothing and shows nothing: reached only where the ones before it fail.
constexpr auto lastPlatform = "minimal";

/// Qt aborts where it finds no display. A list of platforms that ends with one that always works lets the program say
/// what is wrong instead.
void choosePlatforms()
{
    QByteArray platforms = qgetenv("QT_QPA_PLATFORM");
    if (platforms.isEmpty()) {
        platforms = qEnvironmentVariableIsEmpty("WAYLAND_DISPLAY") ? "xcb" : "wayland;xcb";
    }
    qputenv("QT_QPA_PLATFORM", platforms + ';' + lastPlatform);
}

bool hasDisplay()
{
    return !qEnvironmentVariableIsEmpty("DISPLAY") || !qEnvironmentVariableIsEmpty("WAYLAND_DISPLAY")
        || !qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM");
}

/// The system's fonts and the definitions for highlighting.
void readForText()
{
    static_cast<void>(QFontDatabase::families());
    readSyntaxes();
}

/// The graphics driver, which the window needs as it is shown: before there is any text, while that is read for.
void loadDriver()
{
    QOffscreenSurface surface;
    surface.create();
}

/// Without files, what was open when it ended last, or the example.
int runEditor(int argc, char *argv[], const QStringList &files)
{
    constexpr auto noDisplay = "there is no display to open a window on (DISPLAY and WAYLAND_DISPLAY). "
                               "Without one, \"romanesco render FILE -o OUT.png\" draws a picture";
    if (!hasDisplay()) {
        cli::complain(QLatin1String(noDisplay));
        return cli::CannotDo;
    }
    choosePlatforms();
    QSurfaceFormat format = QSurfaceFormat::defaultFormat();
    format.setVersion(4, 5);
    format.setProfile(QSurfaceFormat::CoreProfile);
    format.setOption(QSurfaceFormat::ResetNotification);
    QSurfaceFormat::setDefaultFormat(format);
    QApplication application(argc, argv);
    if (QApplication::platformName() == QLatin1String(lastPlatform)) {
        cli::complain(QLatin1String(noDisplay));
        return cli::CannotDo;
    }

    QApplication::setStyle(new WindowStyle(QApplication::style()->name()));
    const std::jthread reading(readForText);
    loadDriver();
    QApplication::setWindowIcon(QIcon(QStringLiteral(":/icons/org.romanesco.Romanesco.svg")));
    applyAppearance(Preferences::read().appearance);
    MainWindow window;
    bool isAny = files.isEmpty() && window.openSession();
    for (const QString &file : files) {
        isAny = window.openFile(file) || isAny;
    }
    if (!isAny) {
        window.openExample();
    }
    window.show();
    window.offerLostTexts();
    return QApplication::exec();
}

/// What was printed may still be lost: the disk is full, or nobody reads.
int flushed(int status)
{
    if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0) {
        return status;
    }
    cli::complain(QStringLiteral("cannot write the output: %1").arg(QString::fromLocal8Bit(std::strerror(errno))));
    return cli::CannotDo;
}

int usageError(const QString &words)
{
    cli::complain(words + QStringLiteral("; \"romanesco --help\" lists what there is"));
    return cli::WrongUsage;
}

}

int main(int argc, char *argv[])
{
    QCoreApplication::setApplicationName(QStringLiteral("romanesco"));
    QCoreApplication::setApplicationVersion(QStringLiteral(ROMANESCO_VERSION));
    QGuiApplication::setApplicationDisplayName(QStringLiteral("Romanesco"));
    QGuiApplication::setDesktopFileName(QStringLiteral("org.romanesco.Romanesco"));

    // A file may be no larger than a limit of the user's: an error, not the end of the program.
    std::signal(SIGXFSZ, SIG_IGN);
    QStringList arguments;
    for (int i = 1; i < argc; ++i) {
        arguments << QFile::decodeName(argv[i]);
    }
    if (arguments.isEmpty()) {
        return runEditor(argc, argv, {});
    }
    const QString first = arguments.takeFirst();
    if (first == QLatin1String("--help") || first == QLatin1String("-h")) {
        std::print("{}", cli::helpText().toStdString());
        return flushed(cli::Done);
    }
    if (first == QLatin1String("--version")) {
        std::println("romanesco {}", ROMANESCO_VERSION);
        return flushed(cli::Done);
    }
    if (const cli::Command *command = cli::findCommand(first)) {
        try {
            return flushed(command->run(arguments));
        } catch (const std::bad_alloc &) {
            cli::complain(QStringLiteral("there is not enough memory for this"));
            return cli::CannotDo;
        }
    }
    if (first.startsWith(QLatin1Char('-'))) {
        return usageError(QStringLiteral("unknown option %1").arg(first));
    }
    const bool looksLikeFile = first.contains(QLatin1Char('.')) || first.contains(QLatin1Char('/'));
    if (!looksLikeFile && !QFileInfo::exists(first)) {
        return usageError(QStringLiteral("%1 is neither a command nor a file").arg(first));
    }
    return runEditor(argc, argv, QStringList(first) + arguments);
}
