// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "core/formats/fdoreader.h"
#include "tests/fuzz/properties.h"
#include "tests/fuzz/target.h"

using namespace romanesco;

namespace {

/// Every place in the text that a description speaks of lies in the text, and its levels name sets that are there.
void requireSound(const FractalDescription &description, std::string_view text)
{
    const auto isInside = [&](SourceRange range) { return range.begin <= range.end && range.end <= text.size(); };
    require(isInside(description.meshRange));
    for (LevelSequence::Slot slot = 0; slot < description.levels.slotCount(); ++slot) {
        require(description.levels.set(slot) < description.sets.size());
        const TransformSet &set = description.sets[description.levels.set(slot)];
        require(isInside(set.range) && set.size() > 0 && set.uses.size() == set.maps.size());
        for (const SourceRange use : set.uses) {
            require(isInside(use));
        }
    }
    require(!description.depth || isInside(description.depth->range));
}

}

int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size)
{
    const std::string_view text(reinterpret_cast<const char *>(data), size);
    const FdoResult result = readFdo(text);
    requireSound(result.diagnostics, text);
    require(result.description || hasErrors(result.diagnostics));
    if (result.description) {
        requireSound(*result.description, text);
    }
    return 0;
}
