#include "client/drawing/time_surface.h"

#include <algorithm>
#include <cmath>

namespace saccade::client {

TimeSurface::TimeSurface(int width, int height, double decay_s)
    : width_(width), height_(height), decay_ns_(decay_s * 1e9), newest_(std::size_t(width) * height) {}

void TimeSurface::add(const Events& events) {
  for (const Event& event : events)
    newest_[std::size_t(event.y) * width_ + event.x] = {event.t_ns, event.p == 1};
}

float TimeSurface::weight(int x, int y, int side, std::int64_t now_ns) const {
  Newest newest;
  for (int v = y; v < std::min(y + side, height_); ++v) {
    for (int u = x; u < std::min(x + side, width_); ++u) {
      const Newest& pixel = newest_[std::size_t(v) * width_ + u];
      if (pixel.t_ns > newest.t_ns) newest = pixel;
    }
  }
  if (newest.t_ns == INT64_MIN) return 0;
  const double weight = std::exp(static_cast<double>(newest.t_ns - now_ns) / decay_ns_);
  return static_cast<float>(newest.on ? weight : -weight);
}

}  // namespace saccade::client
