// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <cstddef>
#include <memory>

#include <glm/vec3.hpp>

#include "anchor.h"

namespace romanesco {

/// The dissertation's dynamic fractals (4.3.2 to 4.3.4), in the world's coordinates: each fractal stands, whole and at its
/// own depth, where the camera is near, so that there is always more to see; nothing is left of it elsewhere. One node for
/// each item with an extent. An item without maps stands where it is; a fractal is moved from its place M as follows. Of
/// M·t, for all maps t of one iteration, the one is taken whose origin is nearest to the camera, the first of several. If
/// the camera is nearer to that origin than some vertex of the base mesh there, it is the new M, and so on. The fractal
/// stands at the M of `trail` steps before the last, or where it began if there were fewer.
///
/// One iteration is what may be picked first: the maps of the outermost level, and while levels hold `#`, of those inside;
/// `#` itself is none. The same maps are taken at every step, however many levels the fractal has.
///
/// nearby is round the whole at the last M of the fractal that has become smallest, so that what is near the camera is not
/// cut off; or at an M as many steps after the one that is drawn as there are levels, if that is larger, since nothing that
/// is drawn is smaller. It is of the scene where none has moved.
///
/// Limits. A way ends where M would be a map of less than 1e-15 of its distance from the origin: the world's doubles do
/// not tell more. That is some 30 steps of a third, of which the last four are off by pixels; an Anchor goes on. It ends
/// too after 2,000 steps, and where the square of a size is no number or 0, which takes a camera at the origin, or maps
/// that do not shrink.
///
/// Cost: for each step the maps of one iteration, and the vertices up to the first that is far enough, which are all at
/// the step that is not made. Menger's sponge 30 steps in takes 11 us, a fractal of 35,000 vertices 0.2 ms.
[[nodiscard]] std::shared_ptr<const Surroundings> dynamicSurroundings(std::shared_ptr<const Scene> scene,
                                                                      const glm::dvec3 &camera, std::size_t trail);

}
