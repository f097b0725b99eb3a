// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "flattened.h"
#include "ourframes.h"
#include "pictureerror.h"
#include "renderworkloads.h"

namespace romanesco::bench {

/// How long a fractal takes to be seen, in milliseconds: from its text to what can be drawn, from there to the first
/// picture, and the processor time of both on all cores.
struct Start {
    double load = 0.0;
    double first = 0.0;
    double cpu = 0.0;
};

/// A subject with what is made of it, each when it is first asked for. One thread.
class RenderBench
{
public:
    /// Both must outlive it.
    RenderBench(OurFrames &frames, const GlProgram &flattenedProgram, Subject subject);

    [[nodiscard]] const Subject &subject() const { return m_subject; }
    /// At the size of the subject. Shows our frames the scene.
    [[nodiscard]] View view(Place place, double tolerance);

    [[nodiscard]] const Start &ourStart();

    struct Beside {
        std::unique_ptr<Flattened> flattened;
        Start start;
        std::size_t copies = 0;
    };
    /// What the dissertation's way makes of it. Precondition: it has room for all copies.
    [[nodiscard]] Beside &beside();

    [[nodiscard]] bool isCompared(Place place) const;
    /// Off the reference: ours at a tolerance, or the flattened picture without one. Precondition: it is compared there.
    [[nodiscard]] const PictureError &errorAt(Place place, std::optional<int> tolerance);
    /// The flattened picture off ours of all copies.
    [[nodiscard]] const PictureError &difference(Place place);

private:
    [[nodiscard]] const std::shared_ptr<const Scene> &scene();
    [[nodiscard]] View viewAt(Place place, const PictureSize &size, double tolerance);
    [[nodiscard]] Picture drawn(const View &view);
    [[nodiscard]] const Picture &flattenedPicture(Place place, const PictureSize &size);
    [[nodiscard]] const Picture &reference(Place place);

    OurFrames &m_frames;
    const GlProgram &m_flattenedProgram;
    Subject m_subject;
    FractalText m_text;
    std::shared_ptr<const Scene> m_scene;
    std::optional<Start> m_start;
    Beside m_beside;
    std::map<Place, Picture> m_references;
    std::map<std::pair<Place, int>, Picture> m_flattenedPictures;
    std::map<std::pair<Place, std::optional<int>>, PictureError> m_errors;
    std::map<Place, PictureError> m_differences;
};

}
