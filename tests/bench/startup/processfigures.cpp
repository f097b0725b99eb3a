// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "processfigures.h"

#include <fstream>
#include <sstream>
#include <string>

#include <unistd.h>

namespace romanesco::bench {

namespace {

std::ifstream fileOf(pid_t process, const char *name)
{
    return std::ifstream("/proc/" + std::to_string(process) + '/' + name);
}

}

double cpuSeconds(pid_t process)
{
    std::ifstream file = fileOf(process, "stat");
    std::string line;
    std::getline(file, line);
    const auto name = line.rfind(')'); // a program's name may hold anything
    if (name == std::string::npos) {
        return 0.0;
    }
    std::istringstream fields(line.substr(name + 1));
    std::string passed;
    for (int i = 3; i <= 13; ++i) {
        fields >> passed;
    }
    double user = 0.0;
    double system = 0.0;
    fields >> user >> system;
    return (user + system) / static_cast<double>(sysconf(_SC_CLK_TCK));
}

Memory memoryOf(pid_t process)
{
    std::ifstream file = fileOf(process, "smaps_rollup");
    Memory memory;
    std::string line;
    while (std::getline(file, line)) {
        std::istringstream fields(line);
        std::string name;
        double kilobytes = 0.0;
        fields >> name >> kilobytes;
        if (name == "Rss:") {
            memory.resident = kilobytes / 1024.0;
        } else if (name == "Private_Clean:" || name == "Private_Dirty:") {
            memory.own += kilobytes / 1024.0;
        }
    }
    return memory;
}

}
