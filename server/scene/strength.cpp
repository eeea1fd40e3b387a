#include "scene/strength.h"

#include <algorithm>
#include <iterator>

#include "base/check.h"

namespace saccade {

Strength::Strength(std::vector<StrengthKey> keys) : keys_(std::move(keys)) {
  SACCADE_CHECK(!keys_.empty() && keys_.front().time >= TimeNs{0});
  SACCADE_CHECK(std::is_sorted(keys_.begin(), keys_.end(),
                               [](const StrengthKey& a, const StrengthKey& b) { return a.time < b.time; }));
}

Strength Strength::periodic(std::vector<StrengthKey> keys, TimeNs period) {
  Strength strength(std::move(keys));
  SACCADE_CHECK(period > TimeNs{0} && period >= strength.keys_.back().time);
  strength.period_ = period;
  return strength;
}

float Strength::at(TimeNs t) const {
  if (keys_.empty()) return 1;
  t %= period_;
  const auto after = std::upper_bound(keys_.begin(), keys_.end(), t,
                                      [](TimeNs time, const StrengthKey& key) { return time < key.time; });
  if (after == keys_.begin()) return keys_.front().factor;
  const StrengthKey& a = *std::prev(after);
  if (after == keys_.end()) return a.factor;
  const double share = seconds(t - a.time) / seconds(after->time - a.time);
  return static_cast<float>(a.factor + share * (static_cast<double>(after->factor) - a.factor));
}

}  // namespace saccade
