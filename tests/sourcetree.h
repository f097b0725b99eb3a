// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <QString>

namespace romanesco::test {

/// A path in the source tree, given from its top. A function of one source, so that what else is compiled is the same in
/// every clone, and a compiler cache knows it.
QString sourcePath(const char *fromTop);

}
