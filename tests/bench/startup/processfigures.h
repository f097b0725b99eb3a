// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <sys/types.h>

namespace romanesco::bench {

/// Seconds that all threads of a process have worked; Linux tells them in hundredths.
[[nodiscard]] double cpuSeconds(pid_t process);

/// What of its memory is there, in MiB: all pages, and those that no other process has.
struct Memory {
    double resident = 0.0;
    double own = 0.0;
};
[[nodiscard]] Memory memoryOf(pid_t process);

}
