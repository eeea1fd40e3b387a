// The newest event of each pixel; it fades with stream time.
#pragma once

#include <cstdint>
#include <vector>

#include "saccade/wire/event.h"

namespace saccade::client {

class TimeSurface {
 public:
  TimeSurface(int width, int height, double decay_s);

  void add(const Events& events);  // in time order, within the image

  // The weight at stream time `now_ns` of the newest event of a square of pixels: exp(-age / decay). It is
  // negative for OFF, and 0 without an event. The square has its first pixel at x, y, and may exceed the
  // image.
  float weight(int x, int y, int side, std::int64_t now_ns) const;

  int width() const { return width_; }
  int height() const { return height_; }

 private:
  const int width_, height_;
  const double decay_ns_;
  struct Newest {
    std::int64_t t_ns = INT64_MIN;  // no event yet
    bool on = false;
  };
  std::vector<Newest> newest_;  // by pixel, row by row from the top
};

}  // namespace saccade::client
