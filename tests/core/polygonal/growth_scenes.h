// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstddef>

#include "core/polygonal/polygon_scene.h"

/// Scenes of any number of polygons, for measuring how the time to find edges grows.
namespace povpreview {

/// An open-plan office of about so many polygons: desks with chairs, screens and books, all of
/// boxes, under two lights, a mirror on the far wall. More polygons are more desks in a larger
/// room, seen from above, so that most of them are in the picture.
PolygonScene office_of(std::size_t polygons);

/// Hills of about so many triangles, flat or shaded smoothly, under a low sun.
PolygonScene hills_of(std::size_t polygons, bool smooth);

/// A smooth ball of about so many faces on a floor, by a lamp.
PolygonScene ball_of(std::size_t polygons);

}  // namespace povpreview
