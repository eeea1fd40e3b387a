// Bakes as the commands make them.
#pragma once

#include "feed/bake.h"

namespace saccade::eval {

// Takes the bake from its file in `folder`, or makes it, with progress on stderr under the name `what`.
// Throws Interrupted; the next call then goes on.
Bake keptBake(std::shared_ptr<const RenderScene> scene, const BakePlan& plan, const std::string& folder,
              const std::string& what, TilePool& pool);

}  // namespace saccade::eval
