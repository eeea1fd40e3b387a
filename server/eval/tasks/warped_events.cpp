#include "eval/tasks/warped_events.h"

#include "eval/metrics/for_each_pixel.h"

namespace saccade::eval {
namespace {

// The pixel before a position, and the shares of it and of the next one along each axis.
struct Corner {
  explicit Corner(Vec2 p) : x(static_cast<int>(p.x)), y(static_cast<int>(p.y)) {
    right = p.x - static_cast<float>(x), down = p.y - static_cast<float>(y);
  }
  int x, y;
  float right, down;
};

}  // namespace

void WarpedEvents::add(Vec2 position, float amount) {
  if (!holds(position)) return;
  const Corner c(position);
  image_.at(c.x, c.y) += amount * (1 - c.right) * (1 - c.down);
  image_.at(c.x + 1, c.y) += amount * c.right * (1 - c.down);
  image_.at(c.x, c.y + 1) += amount * (1 - c.right) * c.down;
  image_.at(c.x + 1, c.y + 1) += amount * c.right * c.down;
}

void WarpedEvents::blur() {
  const auto filtered = [](float a, float b, float c, float d, float e) {
    return (a + e + 4 * (b + d) + 6 * c) / 16;
  };
  forEachPixel(image_, [&](int x, int y) {
    const float* p = image_.row(y) + x;
    rows_.at(x, y) = filtered(p[-2], p[-1], p[0], p[1], p[2]);
  });
  forEachPixel(image_, [&](int x, int y) {
    image_.at(x, y) = filtered(rows_.at(x, y - 2), rows_.at(x, y - 1), rows_.at(x, y), rows_.at(x, y + 1),
                               rows_.at(x, y + 2));
  });
}

float WarpedEvents::at(Vec2 position) const {
  if (!holds(position)) return 0;
  const Corner c(position);
  const float above = (1 - c.right) * image_.at(c.x, c.y) + c.right * image_.at(c.x + 1, c.y);
  const float below = (1 - c.right) * image_.at(c.x, c.y + 1) + c.right * image_.at(c.x + 1, c.y + 1);
  return (1 - c.down) * above + c.down * below;
}

double WarpedEvents::variance() const {
  double sum = 0, squares = 0;
  forEachPixel(image_, [&](int x, int y) {
    const double value = image_.at(x, y);
    sum += value, squares += value * value;
  });
  const double n = static_cast<double>(image_.width()) * image_.height(), mean = sum / n;
  return squares / n - mean * mean;
}

}  // namespace saccade::eval
