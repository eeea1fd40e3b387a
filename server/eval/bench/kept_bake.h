// Bakes as the commands make them.
#pragma once

#include "feed/bake.h"

namespace saccade::eval {

// Takes the bake from its file in `folder`, or makes it, with progress on stderr under the name `what`.
// Throws Interrupted; the next call then goes on.
Bake keptBake(std::shared_ptr<const RenderScene> scene, const BakePlan& plan, const std::string& folder,
              const std::string& what, TilePool& pool);

// The light that it has for the first `frames` intervals of a feed, to the relative error `error`.
std::shared_ptr<const BakedLight> keptLight(std::shared_ptr<const RenderScene> scene, const Trajectory& path,
                                            const FeedConfig& feed, int frames, double error,
                                            const std::string& folder, const std::string& what,
                                            TilePool& pool);

}  // namespace saccade::eval
