#include "eval/tasks/intensity_filter.h"

#include <cmath>

#include "eval/metrics/for_each_pixel.h"

namespace saccade::eval {

IntensityFilter::IntensityFilter(const ImageF& L_frame, double t_s, double alpha)
    : alpha_(alpha),
      L_frame_(L_frame.width(), L_frame.height()),
      L_(L_frame.width(), L_frame.height()),
      since_(L_frame.width(), L_frame.height()) {
  L_frame_.copyFrom(L_frame), L_.copyFrom(L_frame);
  since_.fill(t_s);
}

void IntensityFilter::setFrame(const ImageF& L_frame, double t_s) {
  forEachPixel(L_, [&](int x, int y) {
    L_.at(x, y) = static_cast<float>(at(x, y, t_s));
    since_.at(x, y) = t_s;
  });
  L_frame_.copyFrom(L_frame);
}

void IntensityFilter::add(const Event& e, double threshold) {
  const double t_s = 1e-9 * static_cast<double>(e.t_ns);
  L_.at(e.x, e.y) = static_cast<float>(at(e.x, e.y, t_s) + (e.p == 1 ? threshold : -threshold));
  since_.at(e.x, e.y) = t_s;
}

double IntensityFilter::at(int x, int y, double t_s) const {
  const double frame = L_frame_.at(x, y);
  return frame + (L_.at(x, y) - frame) * std::exp(-alpha_ * (t_s - since_.at(x, y)));
}

}  // namespace saccade::eval
