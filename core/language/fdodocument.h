// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <string>
#include <utility>

#include "core/formats/fdomodel.h"

namespace romanesco {

/// An .fdo text as an editor holds it: what every line says and what every name means, kept up to date with the text.
/// What the services of this folder are asked about.
struct FdoDocument {
    FdoSyntax syntax;
    FdoModel model;

    FdoDocument() = default;
    explicit FdoDocument(std::string text) { setText(std::move(text)); }

    /// After a small change, even in a text of 100,000 lines, this takes some milliseconds.
    void setText(std::string text)
    {
        syntax.setText(std::move(text));
        model = resolveFdo(syntax);
    }
};

}
