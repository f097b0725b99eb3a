// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include <cmath>

#include "core/formats/sdoreader.h"
#include "tests/fuzz/properties.h"
#include "tests/fuzz/target.h"

using namespace romanesco;

int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size)
{
    const std::string_view text(reinterpret_cast<const char *>(data), size);
    const SdoResult result = readSdo(text);
    requireSound(result.diagnostics, text);
    require(result.description.has_value() != hasErrors(result.diagnostics));
    if (result.description) {
        for (const SceneDescription::Item &item : result.description->items) {
            require(item.pathRange.length() == item.path.size() + 2);
            require(item.restitution >= 0.0 && item.restitution <= 1.0);
            require(!std::isnan(item.worldFromModel.linear[0].x));
        }
    }
    return 0;
}
