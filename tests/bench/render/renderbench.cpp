// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "renderbench.h"

#include <algorithm>
#include <chrono>
#include <ctime>
#include <vector>

#include "core/base/file.h"
#include "core/formats/objreader.h"

namespace romanesco::bench {

namespace {

constexpr int referenceSamples = 64;
constexpr std::size_t mostStarts = 3;
constexpr double enoughMilliseconds = 3'000.0;

/// What goes by from its making on.
class Stopwatch
{
public:
    [[nodiscard]] double milliseconds() const
    {
        return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - m_begin).count();
    }
    /// Of the whole process: the card may be threads of it.
    [[nodiscard]] double cpuMilliseconds() const { return 1e3 * double(std::clock() - m_cpuBegin) / CLOCKS_PER_SEC; }

private:
    std::chrono::steady_clock::time_point m_begin = std::chrono::steady_clock::now();
    std::clock_t m_cpuBegin = std::clock();
};

double median(std::vector<double> values)
{
    std::ranges::sort(values);
    return values[values.size() / 2];
}

/// The median of some starts, of fewer where each takes long.
template<typename Load, typename Draw>
Start started(Load load, Draw draw)
{
    std::vector<double> loads;
    std::vector<double> firsts;
    std::vector<double> cpus;
    const Stopwatch all;
    while (loads.size() < mostStarts && (loads.empty() || all.milliseconds() < enoughMilliseconds)) {
        const Stopwatch watch;
        load();
        loads.push_back(watch.milliseconds());
        draw();
        firsts.push_back(watch.milliseconds() - loads.back());
        cpus.push_back(watch.cpuMilliseconds());
    }
    return {median(loads), median(firsts), median(cpus)};
}

}

RenderBench::RenderBench(OurFrames &frames, const GlProgram &flattenedProgram, Subject subject)
    : m_frames(frames)
    , m_flattenedProgram(flattenedProgram)
    , m_subject(std::move(subject))
    , m_text(fractalText(m_subject.name, m_subject.depth))
{
}

const std::shared_ptr<const Scene> &RenderBench::scene()
{
    if (!m_scene) {
        m_scene = m_text.scene();
    }
    return m_scene;
}

View RenderBench::viewAt(Place place, const PictureSize &size, double tolerance)
{
    m_frames.setScene(scene());
    return viewOf(m_subject.name, *m_scene, place, size, tolerance);
}

View RenderBench::view(Place place, double tolerance)
{
    return viewAt(place, m_subject.size, tolerance);
}

const Start &RenderBench::ourStart()
{
    if (!m_start) {
        const auto load = [this] {
            m_scene.reset();
            m_frames.begin(view(Place::Far, 1.0));
        };
        m_start = started(load, [this] { m_frames.finish(); });
    }
    return *m_start;
}

RenderBench::Beside &RenderBench::beside()
{
    if (m_beside.flattened) {
        return m_beside;
    }
    const View far = view(Place::Far, 0.0);
    const auto load = [this] {
        m_beside.flattened.reset();
        const FractalDescription description = m_text.description();
        const auto text = orEnd(DiskFiles().read(m_text.path.parent_path() / description.meshPath));
        const std::vector<glm::mat4> copies = concatenated(description);
        m_beside.copies = copies.size();
        m_beside.flattened = std::make_unique<Flattened>(m_flattenedProgram, readObj(text).mesh, copies);
    };
    m_beside.start = started(load, [&] { m_beside.flattened->draw(far); });
    return m_beside;
}

Picture RenderBench::drawn(const View &view)
{
    m_frames.draw(view);
    return m_frames.read();
}

const Picture &RenderBench::reference(Place place)
{
    Picture &known = m_references[place];
    if (known.pixels.empty()) {
        View view = viewAt(place, m_subject.comparedSize, m_subject.referenceTolerance);
        view.samples = referenceSamples;
        known = drawn(view);
    }
    return known;
}

const Picture &RenderBench::flattenedPicture(Place place, const PictureSize &size)
{
    Picture &known = m_flattenedPictures[{place, size.width}];
    if (known.pixels.empty()) {
        beside().flattened->draw(viewAt(place, size, 0.0));
        known = beside().flattened->read();
    }
    return known;
}

bool RenderBench::isCompared(Place place) const
{
    return std::ranges::contains(m_subject.comparedPlaces, place);
}

const PictureError &RenderBench::errorAt(Place place, std::optional<int> tolerance)
{
    const auto [known, isNew] = m_errors.try_emplace({place, tolerance});
    if (isNew) {
        const PictureSize &size = m_subject.comparedSize;
        const Picture picture = tolerance ? drawn(viewAt(place, size, *tolerance)) : flattenedPicture(place, size);
        known->second = errorOf(picture, reference(place));
    }
    return known->second;
}

const PictureError &RenderBench::difference(Place place)
{
    const auto [known, isNew] = m_differences.try_emplace(place);
    if (isNew) {
        known->second = errorOf(flattenedPicture(place, m_subject.size), drawn(view(place, 0.0)));
    }
    return known->second;
}

}
