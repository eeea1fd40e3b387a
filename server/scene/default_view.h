// A camera and a light for files that have none.
#pragma once

#include "scene/scene.h"

namespace saccade {

bool isLit(const Scene& scene);  // whether anything in it gives light

// Gives a scene what its file lacks, and tells of it in Scene::unread.
//
// Where it has no camera among Scene::paths, a camera with a horizontal field of view of 45 degrees and
// 640 x 480 pixels. It looks at the scene's shapes from the front, the right and above, so near that all of
// them are just in view. Up is +y, and front +z.
//
// Where nothing gives light, a radiance of 0.5 from all sides, and a sun of irradiance 3 from the left, above
// and before the scene. A white surface that faces the sun has a radiance of about 1.5.
void addDefaults(Scene& scene);

}  // namespace saccade
