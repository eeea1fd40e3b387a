#include "render/lights/lamp_picks.h"

#include <algorithm>
#include <functional>

namespace saccade {
namespace {

constexpr float kLeastShare = 0.01f;  // of all weights, of a lamp that gets a ray of its own

}  // namespace

std::span<const LampPicks::Pick> LampPicks::choose(float u) {
  picked_ = 0;
  const Least least = count_ > kStrongest ? leastOfStrongest() : Least{0, 0};
  std::size_t others = 0, equal = 0;
  for (std::size_t i = 0; i < count_; ++i) {
    const Weighted lamp = all_[i];
    if (lamp.weight > least.weight || (lamp.weight == least.weight && equal++ < least.count))
      picks_[picked_++] = {lamp.lamp, 1};
    else
      all_[others++] = lamp;
  }
  if (others > 0) chooseOthers(std::span(all_).first(others), u);
  return std::span(picks_).first(picked_);
}

LampPicks::Least LampPicks::leastOfStrongest() {
  float total = 0;
  for (std::size_t i = 0; i < count_; ++i) total += sorted_[i] = all_[i].weight;
  const float matters = kLeastShare * total;
  const auto all_end = sorted_.begin() + static_cast<std::ptrdiff_t>(count_);
  const auto matter = std::count_if(sorted_.begin(), all_end, [&](float w) { return w >= matters; });
  if (static_cast<std::size_t>(matter) <= kStrongest) return {matters, kStrongest};
  const auto end = sorted_.begin() + kStrongest;
  std::nth_element(sorted_.begin(), end - 1, all_end, std::greater<>());
  const float least = end[-1];
  return {least, static_cast<std::size_t>(std::count(sorted_.begin(), end, least))};
}

// One of each of several equal parts of their running sum, in order of lamps: nothing but a change of weights
// moves it.
void LampPicks::chooseOthers(std::span<const Weighted> others, float u) {
  float sum = 0, total = 0;
  for (const Weighted& lamp : others) sum += lamp.weight;
  for (std::size_t i = 0; i < count_; ++i) total += sorted_[i];
  const int parts = sum < 0.02f * total ? 1 : sum < 0.5f * total ? 4 : static_cast<int>(kMostOthers);
  const float part = sum / static_cast<float>(parts);
  float up_to = 0;
  int next = 0;
  for (std::size_t i = 0; i < others.size() && next < parts; ++i) {
    const bool last = i + 1 == others.size();
    up_to += others[i].weight;
    const int before = next;
    while (next < parts && (last || (static_cast<float>(next) + u) * part < up_to)) ++next;
    if (next > before)
      picks_[picked_++] = {others[i].lamp, static_cast<float>(next - before) * part / others[i].weight};
  }
}

}  // namespace saccade
