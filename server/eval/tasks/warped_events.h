// The image of warped events [G18]. Its variance tells how well a motion explains the events.
//
// [G18] Gallego, Rebecq, Scaramuzza, A unifying contrast maximization framework for event cameras, CVPR 2018.
#pragma once

#include <span>

#include "base/vec.h"
#include "eval/bench/interrupt.h"
#include "frame/image.h"
#include "saccade/wire/event.h"

namespace saccade::eval {

class WarpedEvents {
 public:
  WarpedEvents(int width, int height) : image_(width, height), rows_(width, height) {}

  void clear() { image_.fill(0); }
  // Shares `amount` among the four pixels around a position. Outside the picture it is left out.
  void add(Vec2 position, float amount = 1);
  // By the binomial filter 1 4 6 4 1 along both axes, of standard deviation 1 pixel: the epsilon of [G18].
  void blur();
  float at(Vec2 position) const;  // between pixels; 0 outside the picture
  double variance() const;        // over the pixels: f of [G18]

 private:
  bool holds(Vec2 p) const {
    return p.x >= 0 && p.y >= 0 && p.x <= static_cast<float>(image_.width() - 1) &&
           p.y <= static_cast<float>(image_.height() - 1);
  }

  ImageF image_, rows_;
};

// Of the events without polarity, where `warp` moves them, blurred. Each counts as weight(event): b_k of
// [G18]. Throws Interrupted.
template <class Warp, class Weight>
double contrastOf(std::span<const Event> events, const Warp& warp, WarpedEvents& image,
                  const Weight& weight) {
  if (interrupted()) throw Interrupted{};
  image.clear();
  for (const Event& e : events) image.add(warp(e), weight(e));
  image.blur();
  return image.variance();
}
// Each counts as 1.
template <class Warp>
double contrastOf(std::span<const Event> events, const Warp& warp, WarpedEvents& image) {
  return contrastOf(events, warp, image, [](const Event&) { return 1.f; });
}

}  // namespace saccade::eval
