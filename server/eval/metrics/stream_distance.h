// How far two streams of events are from each other, window by window of time.
#pragma once

#include <cstdint>
#include <vector>

#include "frame/image.h"
#include "saccade/wire/event.h"

namespace saccade::eval {

// Sums over windows of [PECS, Han et al. 2024, event_loss.py]
//
//   chamfer   mean over A of d(a, B), plus mean over B of d(b, A); d is the distance to the nearest event
//   gaussian  the same with 1 - exp(-d^2 / 0.4) for d
//
// PECS scales x, y and polarity of each stream to 0 to 100, and its times to 0 to 1000. It takes their least
// and largest values, here those of each window. So both hide a shift, and a change of size or speed.
// `chamfer_px` takes x and y in pixels, a millisecond as a pixel, and the other polarity 100 pixels away.
class StreamDistance {
 public:
  StreamDistance(int width, int height) : a_(width, height), b_(width, height), apart_(width, height) {}

  // The events of one window, of both streams, within the image.
  void add(const Events& a, const Events& b);

  // NaN where no window has events of both.
  double chamfer() const { return scaled_.mean(); }
  double gaussian() const { return gaussian_.mean(); }
  double chamferPx() const { return px_.mean(); }
  // Events in windows where the other stream has none: they are in no mean above.
  std::uint64_t alone() const { return alone_; }

  // Mean over pixels and polarities of |n_a - n_b|, over the mean n_b. 0 without any events; infinite where
  // only A has some.
  double countError() const;

  // ON less OFF events of each pixel.
  const ImageF& balanceOfA() const { return a_; }
  const ImageF& balanceOfB() const { return b_; }
  // Events of A less those of B, of both polarities.
  const ImageF& difference() const { return apart_; }

 private:
  struct Means {
    double a = 0, b = 0;  // sums over the events of A and B
    std::uint64_t of_a = 0, of_b = 0;
    double mean() const { return a / static_cast<double>(of_a) + b / static_cast<double>(of_b); }
  };
  void count(const Events& events, ImageF& balance, int sign);

  Means scaled_, gaussian_, px_;
  std::uint64_t alone_ = 0;
  ImageF a_, b_, apart_;
  ImageF on_apart_{a_.width(), a_.height()};
  std::uint64_t events_of_b_ = 0;
};

}  // namespace saccade::eval
