#include "eval/pictures/chart_axis.h"

#include <algorithm>
#include <cmath>

#include "base/check.h"

namespace saccade::eval {
namespace {

constexpr double kLogMargin = 1.15, kLinearMargin = 0.03;  // a factor; a share of the span
constexpr double kManyDecades = 5;
constexpr int kLinearSteps = 6;  // at most so many
constexpr std::size_t kFewTicks = 3;

}  // namespace

void ChartAxis::include(double v) {
  SACCADE_CHECK(std::isfinite(v) && (scale_ == Scale::kLinear || v > 0));
  min_ = std::min(min_, v), max_ = std::max(max_, v);
}

double ChartAxis::low() const {
  if (scale_ == Scale::kLog) return min_ / kLogMargin;
  return max_ > min_ ? min_ - kLinearMargin * (max_ - min_) : min_ - 1;
}

double ChartAxis::high() const {
  if (scale_ == Scale::kLog) return max_ * kLogMargin;
  return max_ > min_ ? max_ + kLinearMargin * (max_ - min_) : max_ + 1;
}

double ChartAxis::operator()(double v) const {
  const auto scaled = [this](double value) { return scale_ == Scale::kLog ? std::log(value) : value; };
  const double share = (scaled(v) - scaled(low())) / (scaled(high()) - scaled(low()));
  return first_ + (last_ - first_) * share;
}

std::vector<double> ChartAxis::ticks() const {
  return scale_ == Scale::kLog ? logTicks() : linearTicks();
}

std::vector<double> ChartAxis::logTicks() const {
  if (high() > low() * std::pow(10, kManyDecades)) return logTicks({1});
  const std::vector<double> coarse = logTicks({1, 2, 5});
  return coarse.size() < kFewTicks ? logTicks({1, 2, 3, 4, 5, 6, 7, 8, 9}) : coarse;
}

std::vector<double> ChartAxis::logTicks(std::initializer_list<double> steps) const {
  std::vector<double> values;
  for (double decade = std::pow(10, std::floor(std::log10(min_))); decade <= max_ * 10; decade *= 10) {
    for (const double step : steps) {
      if (decade * step >= low() && decade * step <= high()) values.push_back(decade * step);
    }
  }
  return values;
}

std::vector<double> ChartAxis::linearTicks() const {
  const double span = high() - low(), decade = std::pow(10, std::floor(std::log10(span / kLinearSteps)));
  double step = decade;
  for (double s : {2.0, 5.0, 10.0}) {
    if (span / step > kLinearSteps) step = decade * s;
  }
  std::vector<double> values;
  for (auto k = std::llround(std::ceil(low() / step)); static_cast<double>(k) * step <= high(); ++k)
    values.push_back(static_cast<double>(k) * step);
  return values;
}

}  // namespace saccade::eval
