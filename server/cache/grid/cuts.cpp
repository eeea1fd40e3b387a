#include "cache/grid/cuts.h"

#include <algorithm>
#include <utility>

namespace saccade {

void Cuts::keep(const std::vector<bool>& kept, const std::vector<std::uint32_t>& moved) {
  Cuts next;
  next.resize(static_cast<std::size_t>(std::count(kept.begin(), kept.end(), true)));
  forEach([&](const Cut& cut) {
    if (!kept[cut.vertices[0]]) return;
    Cut at{cut.planes};
    for (std::uint32_t side = 0; side < cut.planes.sides(); ++side)
      at.vertices[side] = moved[cut.vertices[side]];
    next.add(at);
  });
  *this = std::move(next);
}

}  // namespace saccade
