// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <epoxy/gl.h>

#include "core/scene/anchor.h"
#include "glresources.h"
#include "projector.h"

namespace romanesco {

/// What all programs of a pass are told: how places are mapped to the screen, and the lights (see pass.glsl, lighting.glsl).
class PassUniforms
{
public:
    void make();
    void set(const Projector &projector, const Surroundings &surroundings, bool isLit, unsigned number);
    /// For the draws that follow.
    void bind() const;

private:
    void setLights(const Projector &projector, const Surroundings &surroundings);

    GlBuffer m_pass;
    GlBuffer m_lights;
};

}
