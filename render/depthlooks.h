// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <cstdint>

#include "scenecut.h"

namespace romanesco {

/// Looks now and then at the depth that is drawn, so that what lies behind need not be: often where that leaves out much,
/// seldom where it does not. Each look waits for the card, and reads all pixels.
class DepthLooks
{
public:
    [[nodiscard]] const Depths &depths() const { return m_depths; }
    [[nodiscard]] std::size_t memoryUse() const;

    /// Of the next pictures, in pixels.
    void setSize(int width, int height);
    /// Nothing was drawn before.
    void forget();
    /// No picture of this size was completed yet.
    [[nodiscard]] bool isFirst() const { return m_isFirst; }

    /// An empty picture. What was drawn before stays as a guess.
    void begin();
    /// Before the cut is asked for copies.
    void lookIfDue(const SceneCut &cut, unsigned framebuffer);
    /// So many triangles were drawn into the framebuffer.
    void sent(std::uint64_t triangles) { m_sent += triangles; }
    /// The picture is complete, and the guess for the next.
    void finish(const SceneCut &cut, unsigned framebuffer);

private:
    void look(unsigned framebuffer, DepthPyramid &pyramid);
    [[nodiscard]] std::uint64_t leastPeriod() const;

    int m_width = 0;
    int m_height = 0;
    bool m_isFirst = true;
    /// The last picture left out much; who does not know supposes so.
    bool m_isDense = true;
    Depths m_depths;
    /// Triangles: of this picture, at the last look, and from look to look.
    std::uint64_t m_sent = 0;
    std::uint64_t m_lookedAt = 0;
    std::uint64_t m_period = 0;
    /// Of the cut, at the last look.
    std::uint64_t m_hiddenThen = 0;
    std::uint64_t m_instancesThen = 0;
    bool m_wasInDoubt = false;
};

}
