// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#include "commandline.h"

#include <algorithm>
#include <array>

namespace romanesco::cli {

namespace {

constexpr std::array commands = {
    Command{"check", "FILE… [--json]", "tell all that is wrong or odd in files", runCheck},
    Command{"closest", "FILE --points PTS [--collider KIND] [--tolerance EPS] [--within R] …",
            "find the nearest point of the surface from each of many points", runClosest},
    Command{"export", "FILE -o OUT.obj [--depth N] [--digits N] [--weld] …",
            "write all copies as a mesh: .obj, .ply, .stl or .glb", runExport},
    Command{"format", "FILE… [--check]", "tidy the layout of files, in place", runFormat},
    Command{"info", "FILE [--depth N] [--json]", "print the numbers of a fractal or a scene", runInfo},
    Command{"measure", "FILE [--timestep] [--json] [--html OUT.html] [--radius R] …",
            "measure what each way to search costs, and how far off it is", runMeasure},
    Command{"render", "FILE -o OUT.png [--size WxH] [--camera LINE] [--turntable N] …",
            "draw a picture, or a full turn of them, without a display", runRender},
    Command{"simulate", "SCENE.sdo --seconds S [--dt DT] [--collider KIND] [--shrink RATE] …",
            "let the balls of a scene fall, and print where they are at each step", runSimulate},
};

}

const Command *findCommand(const QString &name)
{
    const auto found = std::ranges::find_if(commands, [&](const Command &c) { return name == QLatin1String(c.name); });
    return found == commands.end() ? nullptr : &*found;
}

QString helpText()
{
    QString text = QStringLiteral("romanesco [FILE…]\n"
                                  "    edit fractals (.fdo) and scenes (.sdo) and look at meshes (.obj) in a window\n");
    for (const Command &command : commands) {
        text += QStringLiteral("romanesco %1 %2\n    %3\n")
                    .arg(QString::fromUtf8(command.name), QString::fromUtf8(command.synopsis),
                         QString::fromUtf8(command.summary));
    }
    text +=
        QStringLiteral("romanesco COMMAND --help\n    all options of a command\n"
                       "romanesco --version\n\n"
                       "Exit status: 0 done, 1 the input has errors, 2 wrong usage, 3 the work could not be done.\n");
    return text;
}

}
