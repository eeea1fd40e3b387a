// Scores the reconstruction of intensity against the frames of the reference.
#include <cmath>

#include "eval/metrics/for_each_pixel.h"
#include "eval/tasks/correlation.h"
#include "eval/tasks/intensity_filter.h"
#include "eval/tasks/task.h"

namespace saccade::eval {
namespace {

constexpr std::size_t kFrameEvery = 10;  // a camera's frame each so many frames of the feed

// Feeds the events before each frame's end to the filter, and calls use(frame, estimate) with its picture
// there.
template <class Use>
void forEachFrame(const TaskInput& input, IntensityFilter& filter, Use use) {
  ImageF picture(input.truth.camera.width, input.truth.camera.height);
  auto next = input.events.begin();
  for (std::size_t f = 0; f < input.truth.frames.size(); ++f) {
    const TimeNs end = input.truth.frames[f].t1;
    for (; next != input.events.end() && next->t_ns < end.count(); ++next) filter.add(*next, input.threshold);
    forEachPixel(picture,
                 [&](int x, int y) { picture.at(x, y) = static_cast<float>(filter.at(x, y, seconds(end))); });
    use(f, picture);
  }
}

// 1 - the mean correlation over the frames that have one.
class Correlations {
 public:
  void add(const ImageF& estimate, const ImageF& truth) {
    const double r = correlation(estimate, truth);
    if (std::isfinite(r)) sum_ += r, ++count_;
  }
  TaskScore score() const {
    return count_ == 0 ? TaskScore{} : TaskScore{1 - sum_ / static_cast<double>(count_), count_};
  }

 private:
  double sum_ = 0;
  std::size_t count_ = 0;
};

// From the high-pass of the true brightness at a frame's start to that at its end: brightness is straight in
// time between them.
void highPass(const TruthFrame& frame, const ImageF& L_prev, ImageF& high) {
  const double angle = kCrossover * seconds(frame.t1 - frame.t0), decay = std::exp(-angle);
  const double kept = (1 - decay) / angle;
  forEachPixel(high, [&](int x, int y) {
    const double rise = double(frame.L.at(x, y)) - L_prev.at(x, y);
    high.at(x, y) = static_cast<float>(decay * high.at(x, y) + kept * rise);
  });
}

}  // namespace

// Events alone, against the same high-pass of the reference's brightness.
TaskScore scoreHighPass(const TaskInput& input) {
  const ImageF& start = input.truth.L_start;
  ImageF high(start.width(), start.height());
  IntensityFilter filter(high, seconds(input.truth.frames.front().t0));
  Correlations correlations;
  forEachFrame(input, filter, [&](std::size_t f, const ImageF& estimate) {
    highPass(input.truth.frames[f], f == 0 ? start : input.truth.frames[f - 1].L, high);
    correlations.add(estimate, high);
  });
  return correlations.score();
}

// With a frame of the method at the start, and then every kFrameEvery frames.
TaskScore scoreComplementary(const TaskInput& input) {
  IntensityFilter filter(logPicture(input.changes.front()->I_prev, input.bias),
                         seconds(input.truth.frames.front().t0));
  Correlations correlations;
  forEachFrame(input, filter, [&](std::size_t f, const ImageF& estimate) {
    correlations.add(estimate, input.truth.frames[f].L);
    if ((f + 1) % kFrameEvery == 0)
      filter.setFrame(logPicture(input.changes[f]->I_now, input.bias), seconds(input.truth.frames[f].t1));
  });
  return correlations.score();
}

}  // namespace saccade::eval
