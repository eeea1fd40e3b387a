#include "events/brightness_pieces.h"

#include <algorithm>

#include "events/log_response.h"

namespace saccade {

void BrightnessPieces::begin(const IntensityChange& change, float bias, const ImageF& dL) {
  change_ = &change;
  bias_ = bias;
  corrected_ = false;
  taken_ = 0;
  I_.copyFrom(change.I_prev);
  from_.fill(0);
  slope_.copyFrom(dL);
}

void BrightnessPieces::correct(const ImageF& dL) {
  corrected_ = true;
  for (int y = 0; y < dL.height(); ++y) {
    const float* corrected = dL.row(y);
    float* __restrict slope = slope_.row(y);
    for (int x = 0; x < dL.width(); ++x) slope[x] = corrected[x] - slope[x];
  }
}

Pieces* BrightnessPieces::next() {
  if (taken_ == change_->updates.size()) return nullptr;
  take(change_->updates.data() + taken_,
       std::min<std::size_t>(Pieces::kMost, change_->updates.size() - taken_));
  taken_ += static_cast<std::size_t>(pieces_.count);
  return &pieces_;
}

void BrightnessPieces::take(const IntensityUpdate* updates, std::size_t count) {
  Pieces& p = pieces_;
  p.count = static_cast<int>(count);
  const auto width = static_cast<std::uint32_t>(I_.width());
  alignas(64) std::array<float, Pieces::kMost> before;
  // Updates of one time are sorted by pixel: most lie in the row of the one before.
  std::uint32_t y = updates[0].pixel / width;
  for (int i = 0; i < p.count; ++i) {
    const IntensityUpdate& update = updates[i];
    if (update.pixel - y * width >= width) y = update.pixel / width;
    const std::uint32_t x = update.pixel - y * width;
    float &I = I_.row(static_cast<int>(y))[x], &from = from_.row(static_cast<int>(y))[x];
    p.x[i] = static_cast<std::uint16_t>(x), p.y[i] = static_cast<std::uint16_t>(y);
    p.from[i] = from, p.to[i] = update.at;
    before[i] = I, p.I[i] = update.I;
    from = update.at;
    if (update.I - update.I == 0) I = update.I;
  }
  for (int i = 0; i < p.count; ++i) p.dL[i] = logResponse(before[i], p.I[i] - before[i], bias_);
  if (!corrected_) return;
  for (int i = 0; i < p.count; ++i) p.dL[i] += (p.to[i] - p.from[i]) * slope_.at(p.x[i], p.y[i]);
}

void BrightnessPieces::last(ImageF& dL) const {
  for (int y = 0; y < dL.height(); ++y) {
    const float *I_prev = change_->I_prev.row(y), *dI = change_->dI.row(y), *I = I_.row(y),
                *from = from_.row(y), *slope = slope_.row(y);
    const float bias = bias_, ramp = corrected_ ? 1 : 0;
    float* __restrict out = dL.row(y);
    for (int x = 0; x < dL.width(); ++x) {
      const float rest = logResponse(I[x], I_prev[x] + dI[x] - I[x], bias) + ramp * (1 - from[x]) * slope[x];
      out[x] = from[x] > 0 ? rest : out[x];
    }
  }
}

}  // namespace saccade
