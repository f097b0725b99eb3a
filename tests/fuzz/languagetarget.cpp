// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "core/formats/fdoreader.h"
#include "core/formats/sdoreader.h"
#include "core/language/completion.h"
#include "core/language/formatter.h"
#include "core/language/hover.h"
#include "core/language/navigation.h"
#include "core/language/origin.h"
#include "core/language/placement.h"
#include "core/language/renumbering.h"
#include "core/language/stability.h"
#include "core/language/structure.h"
#include "core/language/writtenplace.h"
#include "tests/fuzz/properties.h"
#include "tests/fuzz/target.h"

using namespace romanesco;

namespace {

std::vector<std::string> xMesh()
{
    return {"x.obj"};
}

void requireInside(SourceRange range, std::string_view text)
{
    require(range.begin <= range.end && range.end <= text.size());
}

void requireInside(const TextEdits &edits, std::string_view text)
{
    std::size_t at = 0;
    for (const TextEdit &edit : edits) {
        requireInside(edit.range, text);
        require(edit.range.begin >= at);
        at = edit.range.end;
    }
}

void requireSame(const Diagnostics &before, const Diagnostics &after)
{
    require(before.size() == after.size());
    for (std::size_t i = 0; i < before.size(); ++i) {
        require(before[i].code == after[i].code);
    }
}

/// A tidy text is tidy, and says what it said.
template<typename Syntax>
std::string tidied(const Syntax &syntax)
{
    const TextEdits edits = formatting(syntax);
    requireInside(edits, syntax.text());
    std::string text = applied(syntax.text(), edits);
    const Syntax again(text);
    require(formatting(again).empty());
    requireSame(syntax.diagnostics(), again.diagnostics());
    return text;
}

void lookAround(const FdoDocument &document, std::size_t offset)
{
    const std::string &text = document.syntax.text();
    if (const auto found = hover(document, offset)) {
        requireInside(found->range, text);
    }
    if (const auto target = definition(document, offset)) {
        requireInside(target->range, text);
    }
    for (const Occurrence &use : uses(document, offset)) {
        requireInside(use.range, text);
    }
    if (const auto edits = rename(document, offset, "renamed")) {
        requireInside(*edits, text);
        // what a line with an error says may hang on the name
        require(hasErrors(document.model.diagnostics)
                || !hasErrors(resolveFdo(FdoSyntax(applied(text, *edits))).diagnostics));
    }
    for (const Completion &way : complete(document, offset, xMesh)) {
        requireInside(way.edit.range, text);
    }
}

void requireChangeable(const WrittenPlace &place, const std::string &text)
{
    for (const auto &vector : place.vectors) {
        if (vector) {
            requireInside(vector->range, text);
            require(!vector->with(vector->value()).empty());
        }
    }
}

void useAsFractal(const std::string &text)
{
    const FdoDocument document(text);
    const FdoDocument tidy(tidied(document.syntax));
    requireSame(document.model.diagnostics, tidy.model.diagnostics);
    for (const Inlay &inlay : inlays(document, 0, document.syntax.lineCount())) {
        requireInside({inlay.offset, inlay.offset}, text);
    }
    requireInside(withDepth(document, 7), text);
    requireInside(renumbering(tidy, document).edits, text);
    for (std::size_t i = 0; i <= 8; ++i) {
        lookAround(document, text.size() * i / 8);
    }
    const FdoResult result = describeFdo(document.syntax, document.model);
    const FdoResult same = describeFdo(tidy.syntax, tidy.model);
    require(result.description.has_value() == same.description.has_value());
    if (result.description) {
        require(result.description->sets.size() == same.description->sets.size());
        for (std::size_t i = 0; i < result.description->sets.size(); ++i) {
            require(result.description->sets[i].maps == same.description->sets[i].maps);
        }
        requireSound(stabilityHints(document, *result.description), text);
        for (Position position = 0; position < std::min<Position>(result.description->levels.levelCount(), 9);
             ++position) {
            for (const OriginStep &step : origin(document, *result.description, {{position, 0}})) {
                requireInside(step.use, text);
                if (const auto place = placeOfUse(document, step.use.begin)) {
                    requireChangeable(*place, text);
                }
                require(useAt(document, *result.description, step.use.begin).has_value());
            }
        }
    }
}

void useAsScene(const std::string &text)
{
    const SdoSyntax syntax(text);
    const std::vector<FileToPlace> files{{"a.obj", false}, {"b.fdo", true}};
    const TextEdits added = withPlacedFiles(syntax, files);
    requireInside(added, text);
    require(hasErrors(syntax.diagnostics()) || !hasErrors(SdoSyntax(applied(text, added)).diagnostics()));
    for (std::size_t item = 0; item < 3; ++item) {
        if (const auto place = placeOfItem(syntax, item)) {
            requireChangeable(*place, text);
        }
    }
    (void)tidied(syntax);
    for (std::size_t i = 0; i <= 8; ++i) {
        const std::size_t offset = text.size() * i / 8;
        if (const auto found = hover(syntax, offset)) {
            requireInside(found->range, text);
        }
        for (const Completion &way : complete(syntax, offset, xMesh)) {
            requireInside(way.edit.range, text);
        }
    }
}

}

int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size)
{
    const std::string text(reinterpret_cast<const char *>(data), size);
    useAsFractal(text);
    useAsScene(text);
    for (const FoldingRange &range : foldingRanges(LineMap(text))) {
        require(range.first < range.last);
    }
    return 0;
}
