// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "spelling.h"

#include <algorithm>
#include <vector>

namespace romanesco {

std::size_t slipsBetween(std::string_view one, std::string_view other)
{
    // Of the beginnings of `one`, by their length, and each beginning of `other`: this one, the last, the one before.
    std::vector<std::size_t> now(one.size() + 1);
    for (std::size_t i = 0; i < now.size(); ++i) {
        now[i] = i;
    }
    std::vector<std::size_t> last(now.size());
    std::vector<std::size_t> beforeLast(now.size());
    for (std::size_t j = 1; j <= other.size(); ++j) {
        beforeLast.swap(last);
        last.swap(now);
        now[0] = j;
        for (std::size_t i = 1; i <= one.size(); ++i) {
            const bool isSame = one[i - 1] == other[j - 1];
            now[i] = std::min({last[i] + 1, now[i - 1] + 1, last[i - 1] + (isSame ? 0 : 1)});
            if (i > 1 && j > 1 && one[i - 1] == other[j - 2] && one[i - 2] == other[j - 1]) {
                now[i] = std::min(now[i], beforeLast[i - 2] + 1);
            }
        }
    }
    return now[one.size()];
}

}
