#include "cache/cuts.h"

#include <algorithm>
#include <utility>

namespace saccade {

void Cuts::keep(const std::vector<bool>& kept, const std::vector<std::uint32_t>& moved) {
  Cuts next;
  next.resize(static_cast<std::size_t>(std::count(kept.begin(), kept.end(), true)));
  forEach([&](std::uint32_t v, Cut cut) {
    cut.other = moved[cut.other];
    if (kept[v]) next.add(moved[v], cut);
  });
  *this = std::move(next);
}

}  // namespace saccade
