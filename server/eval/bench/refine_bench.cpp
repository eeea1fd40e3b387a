#include "eval/bench/refine_bench.h"

#include <cmath>

#include "base/log_ratio.h"

namespace saccade::eval {
namespace {

constexpr double kOff = 0.1;  // of the threshold

// Log brightness at each fine time of an interval.
using FinePlanes = std::vector<ImageF>;

class Brightness {
 public:
  explicit Brightness(double bias) : bias_(static_cast<float>(bias)) {}
  void at(const ImageF& I, ImageF& L) const {
    for (int y = 0; y < I.height(); ++y)
      for (int x = 0; x < I.width(); ++x) L.at(x, y) = of(I.at(x, y));
  }
  float of(float I) const { return logBrightness(I, bias_); }

 private:
  float bias_;
};

class RefineBench {
 public:
  explicit RefineBench(const RefineSetup& s)
      : setup_(s),
        brightness_(s.config.refinement->bias),
        refined_(feedOf(1, s.config.refinement)),
        truth_feed_(feedOf(1, everywhere(*s.config.refinement))),
        fine_(feedOf(s.pieces, {})),
        look_ups_(feedOf(s.pieces, never(*s.config.refinement))),
        halves_(feedOf(2, {})),
        sensors_(4, LineSensor(pixels(), s.config.refinement->threshold)) {
    for (int k = 0; k <= s.pieces; ++k) {
      truth_.emplace_back(s.config.camera.width, s.config.camera.height);
      drawn_.emplace_back(s.config.camera.width, s.config.camera.height);
    }
  }

  RefineResult run() {
    for (interval_ = 0; interval_ < setup_.intervals; ++interval_) {
      stepTruth();
      stepFine();
      stepHalves();
      stepRefined();
    }
    const double times = static_cast<double>(pixels()) * setup_.pieces * setup_.intervals;
    const std::vector<TimedEvent> truth = sensors_[0].events();
    result_.refined_events = scoreEvents(sensors_[1].events(), truth, setup_.pieces);
    result_.look_up_events = scoreEvents(sensors_[3].events(), truth, setup_.pieces);
    result_.halves_events = scoreEvents(sensors_[2].events(), truth, setup_.pieces);
    result_.events = static_cast<double>(truth.size()) / times;
    result_.updates /= times, result_.off /= times;
    result_.look_ups_off /= times, result_.halves_off /= times;
    return result_;
  }

 private:
  std::size_t pixels() const { return static_cast<std::size_t>(setup_.config.pixels()); }

  std::unique_ptr<Feed> feedOf(int frames, const std::optional<RefinementSettings>& refinement) {
    FeedConfig config = setup_.config;
    config.frame_rate_hz *= frames, config.refinement = refinement;
    return std::make_unique<Feed>(setup_.scene, setup_.path, config, pool_);
  }
  static RefinementSettings everywhere(RefinementSettings settings) {
    settings.threshold = 1e-9, settings.most_updates = 1e9;
    return settings;
  }
  // Its frames are those of refinement.
  static RefinementSettings never(RefinementSettings settings) {
    settings.finest_px = 1e9;
    return settings;
  }
  const IntensityChange& step(Feed& feed, double& seconds) {
    const IntensityChange& change = feed.step(pool_);
    seconds += std::chrono::duration<double>(feed.lastTimes().total()).count();
    return change;
  }

  void stepTruth() {
    draw(truth_feed_->step(pool_));
    std::swap(truth_, drawn_);
    forEachPixel([&](int x, int y, std::uint32_t pixel) {
      for (int k = 1; k <= setup_.pieces; ++k)
        sensors_[0].move(pixel, timeOf(k - 1), timeOf(k), L(truth_, k, x, y) - L(truth_, k - 1, x, y));
    });
  }

  void stepFine() {
    for (int k = 1; k <= setup_.pieces; ++k) {
      step(*fine_, result_.fine);
      const IntensityChange& change = step(*look_ups_, result_.look_ups);
      if (k == 1) brightness_.at(change.I_prev, drawn_[0]);
      brightness_.at(change.I_now, drawn_[static_cast<std::size_t>(k)]);
    }
    compare(3, result_.look_ups_off);
  }

  // Their events are those of the truth at the same times, so that the filter does not count.
  void stepHalves() {
    step(*halves_, result_.halves), step(*halves_, result_.halves);
    forEachPixel([&](int x, int y, std::uint32_t) {
      const int half = setup_.pieces / 2;
      for (int k = 0; k < setup_.pieces; ++k) {
        const int from = k / half * half;
        const float share = static_cast<float>(k - from) / static_cast<float>(half);
        drawn_[static_cast<std::size_t>(k)].at(x, y) =
            L(truth_, from, x, y) + share * (L(truth_, from + half, x, y) - L(truth_, from, x, y));
      }
      drawn_.back().at(x, y) = L(truth_, setup_.pieces, x, y);
    });
    compare(2, result_.halves_off);
  }

  void stepRefined() {
    const IntensityChange& change = step(*refined_, result_.refined);
    result_.samples += static_cast<double>(refined_->refined().samples);
    result_.unsplit += static_cast<double>(refined_->refined().unsplit);
    result_.updates += static_cast<double>(change.updates.size());
    draw(change);
    compare(1, result_.off);
  }

  // The lines of a change at all fine times.
  void draw(const IntensityChange& change) {
    struct End {
      float time = 0, L = 0;
    };
    std::vector<End> last(pixels());
    const auto lineTo = [&](std::uint32_t pixel, float time, float L) {
      const int x = static_cast<int>(pixel) % change.dI.width(),
                y = static_cast<int>(pixel) / change.dI.width();
      const End from = last[pixel];
      for (int k = static_cast<int>(std::ceil(from.time)); static_cast<float>(k) <= time; ++k)
        drawn_[static_cast<std::size_t>(k)].at(x, y) =
            from.L + (static_cast<float>(k) - from.time) / (time - from.time) * (L - from.L);
      last[pixel] = {time, L};
    };
    forEachPixel([&](int x, int y, std::uint32_t pixel) {
      last[pixel] = {0, brightness_.of(change.I_prev.at(x, y))};
    });
    for (const IntensityUpdate& u : change.updates)
      lineTo(u.pixel, u.at * static_cast<float>(setup_.pieces), brightness_.of(u.I));
    forEachPixel([&](int x, int y, std::uint32_t pixel) {
      lineTo(pixel, static_cast<float>(setup_.pieces),
             brightness_.of(change.I_prev.at(x, y) + change.dI.at(x, y)));
    });
  }

  // Feeds what is drawn to a sensor, and counts where it is wrong.
  void compare(std::size_t sensor, double& off) {
    const double most = kOff * setup_.config.refinement->threshold;
    forEachPixel([&](int x, int y, std::uint32_t pixel) {
      for (int k = 1; k <= setup_.pieces; ++k) {
        sensors_[sensor].move(pixel, timeOf(k - 1), timeOf(k), L(drawn_, k, x, y) - L(drawn_, k - 1, x, y));
        off += std::abs(L(drawn_, k, x, y) - L(truth_, k, x, y)) > most;
      }
    });
  }

  double timeOf(int k) const { return interval_ * setup_.pieces + k; }
  static double L(const FinePlanes& planes, int k, int x, int y) {
    return static_cast<double>(planes[static_cast<std::size_t>(k)].at(x, y));
  }
  void forEachPixel(const auto& f) const {
    const int width = setup_.config.camera.width;
    for (int y = 0; y < setup_.config.camera.height; ++y)
      for (int x = 0; x < width; ++x) f(x, y, static_cast<std::uint32_t>(y * width + x));
  }

  const RefineSetup& setup_;
  const Brightness brightness_;
  TilePool pool_{1};
  const std::unique_ptr<Feed> refined_, truth_feed_, fine_, look_ups_, halves_;
  std::vector<LineSensor> sensors_;  // of the truth, refined intervals, halves and look-ups
  FinePlanes truth_, drawn_;
  int interval_ = 0;
  RefineResult result_;
};

}  // namespace

RefineResult measureRefinement(const RefineSetup& setup) {
  return RefineBench(setup).run();
}

}  // namespace saccade::eval
