// A scene's light that was computed ahead, as feeds share it.
#pragma once

#include <functional>
#include <string>

#include "feed/baker.h"

namespace saccade {

struct Bake {
  std::shared_ptr<const BakedLight> light;
  std::uint64_t digest = 0;  // of what its file holds
  // As the Baker has them.
  double known = 0;
  int passes = 0;
  std::size_t poses = 0;
  bool full = false;
};

// Takes the bake of a plan from its file in `folder`, or makes it and keeps it there. A bake that was stopped
// goes on where its file ends. A file that cannot be used is set aside, and `warn` is told so. Calls
// `after_pass` after each pass; what it throws stops the bake, and the file then has that pass. Throws
// std::runtime_error where no file can be written.
Bake bake(std::shared_ptr<const RenderScene> scene, const BakePlan& plan, const std::string& folder,
          const PoolHandle& pool, const std::function<void(const Baker&)>& after_pass,
          const std::function<void(const std::string&)>& warn);

}  // namespace saccade
