// A camera and a light for files of one model.
#pragma once

#include "scene/scene.h"

namespace saccade {

// A scene without a camera is seen as a whole, from its front (+z) and a little from the right and above. A
// scene without any light stands under an even sky of radiance 1. Scene::unread tells of both.
void addDefaults(Scene& scene);

}  // namespace saccade
