// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <memory>
#include <string>
#include <vector>

#include <QString>

#include "core/formats/fdoreader.h"
#include "core/fractal/address.h"
#include "core/language/fdodocument.h"
#include "core/scene/scene.h"
#include "render/appearance.h"

namespace romanesco {

/// A sound .fdo text as it is read. Immutable, shared between threads.
struct FdoReading {
    FdoDocument document;
    FractalDescription description;

    /// Null where the text is not sound.
    [[nodiscard]] static std::shared_ptr<const FdoReading> of(const std::string &text);
};

/// A step of the way to a copy, as the text calls it: "sponge[1] box.7".
struct AddressStep {
    QString words;
    /// Of the text that was asked with; nothing for a step in another file.
    std::optional<SourceRange> use = {};
    /// The depth for which the step would be the last, where it is one of the iterations that the depth counts.
    std::optional<std::uint64_t> pass = {};
};

/// The steps of a copy of a scene; of one that no text says more of, just how many there are. reading is of the text that
/// the scene is of, which may have another depth than `text`, as the editor has it: places are of that. Null for an .sdo.
/// Cost: about a microsecond for each step, and comparing the texts.
[[nodiscard]] std::vector<AddressStep> addressSteps(const Scene &scene, const Selection &selection,
                                                    const FdoReading *reading, const std::string &text);

/// The steps of an address in an item, the same way.
[[nodiscard]] std::vector<AddressStep> addressSteps(const Scene &scene, std::size_t item, const Address &address,
                                                    const FdoReading *reading, const std::string &text);

/// In one line: "sponge[1] box.7 › sponge[2] box.19"; of many steps the first and the last, and how many there are.
[[nodiscard]] QString addressWords(const std::vector<AddressStep> &steps);

/// What the cursor stands at in `text`: the map that a use stands for, in the sets of the reading.
[[nodiscard]] std::optional<Step> mapAt(const FdoReading &reading, const std::string &text, std::size_t offset);

}
