// The axes of a chart: from values to places on the page.
#pragma once

#include <initializer_list>
#include <limits>
#include <vector>

namespace saccade::eval {

enum class Scale { kLog, kLinear };  // kLog: of finite values > 0

class ChartAxis {
 public:
  // From `first` to `last` on the page.
  ChartAxis(Scale scale, double first, double last) : scale_(scale), first_(first), last_(last) {}

  void include(double v);  // widens the axis so that it holds v
  double operator()(double v) const;
  // In whole steps of 1, 2, 5 times a power of ten. A logarithmic axis of many decades has whole powers
  // alone, one that would have only two ticks all of 1 to 9.
  std::vector<double> ticks() const;

 private:
  double low() const;  // of the axis, a margin beyond the values
  double high() const;
  std::vector<double> linearTicks() const;
  std::vector<double> logTicks() const;
  std::vector<double> logTicks(std::initializer_list<double> steps) const;

  Scale scale_;
  double first_, last_;
  double min_ = std::numeric_limits<double>::infinity(), max_ = -min_;
};

}  // namespace saccade::eval
