// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "depthlooks.h"

#include <algorithm>
#include <utility>

#include <epoxy/gl.h>

namespace romanesco {

namespace {

/// A look costs as much as drawing a share of the pixels in triangles; at least some.
constexpr std::uint64_t pixelsToTriangle = 16;
constexpr std::uint64_t leastTriangles = 10'000;

/// Fewer copies left out for each that is drawn are not worth a look.
constexpr std::uint64_t leastShare = 32;

}

std::size_t DepthLooks::memoryUse() const
{
    return m_depths.drawn.memoryUse() + m_depths.before.memoryUse();
}

void DepthLooks::setSize(int width, int height)
{
    if (width != m_width || height != m_height) {
        forget();
        m_width = width;
        m_height = height;
    }
}

void DepthLooks::forget()
{
    m_depths.before.clear();
    m_isFirst = true;
    m_isDense = true;
}

void DepthLooks::begin()
{
    m_depths.drawn.clear();
    m_depths.looks = 0;
    m_sent = m_lookedAt = 0;
    m_hiddenThen = m_instancesThen = 0;
    m_period = m_isDense ? leastPeriod() : std::max(m_period, leastPeriod());
    m_wasInDoubt = false;
}

std::uint64_t DepthLooks::leastPeriod() const
{
    const auto pixels = static_cast<std::uint64_t>(m_width) * static_cast<std::uint64_t>(m_height);
    return std::max(leastTriangles, pixels / pixelsToTriangle);
}

void DepthLooks::lookIfDue(const SceneCut &cut, unsigned framebuffer)
{
    if (cut.isInDoubt() && !m_wasInDoubt) {
        m_period = leastPeriod() / 4;
    }
    m_wasInDoubt = cut.isInDoubt();
    if (m_sent < m_lookedAt + m_period) {
        return;
    }
    const std::uint64_t hidden = cut.hiddenCount() - m_hiddenThen;
    const std::uint64_t drawn = cut.instanceCount() - m_instancesThen;
    const bool isWorthIt = (m_isDense && m_depths.drawn.isEmpty()) || hidden * leastShare > drawn;
    m_period = isWorthIt ? leastPeriod() : std::min(2 * m_period, 64 * leastPeriod());
    m_lookedAt = m_sent;
    m_hiddenThen = cut.hiddenCount();
    m_instancesThen = cut.instanceCount();
    ++m_depths.looks;
    look(framebuffer, m_depths.drawn);
}

void DepthLooks::finish(const SceneCut &cut, unsigned framebuffer)
{
    const bool isUnknown = std::exchange(m_isFirst, false) && m_depths.looks < 2;
    m_isDense = isUnknown || cut.hiddenCount() * leastShare > cut.instanceCount();
    if (m_isDense) {
        look(framebuffer, m_depths.before);
    } else {
        m_depths.before.clear();
    }
}

void DepthLooks::look(unsigned framebuffer, DepthPyramid &pyramid)
{
    std::vector<float> pixels = pyramid.takeDepths();
    pixels.resize(static_cast<std::size_t>(m_width) * static_cast<std::size_t>(m_height));
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glPixelStorei(GL_PACK_ALIGNMENT, 4);
    glReadPixels(0, 0, m_width, m_height, GL_DEPTH_COMPONENT, GL_FLOAT, pixels.data());
    pyramid.build(std::move(pixels), m_width, m_height);
}

}
