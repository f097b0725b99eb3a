// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "ourframes.h"

namespace romanesco::bench {

void OurFrames::begin(const View &view)
{
    if (m_target.width != view.width || m_target.height != view.height) {
        m_target = orEnd(makeTarget(view.width, view.height, GL_RGBA8, false));
    }
    m_renderer->begin(view);
}

void OurFrames::finish()
{
    while (!m_renderer->step(std::chrono::milliseconds(1'000))) {
        // goes on
    }
    if (!m_renderer->error().empty()) {
        orEnd<int>(std::unexpected(m_renderer->error()));
    }
    m_renderer->present(m_target.framebuffer, m_target.width, m_target.height);
    glFinish();
}

void OurFrames::draw(const View &view)
{
    begin(view);
    finish();
}

}
