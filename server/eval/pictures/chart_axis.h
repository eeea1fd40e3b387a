// An axis of a chart: maps values to pixels.
#pragma once

#include <initializer_list>
#include <limits>
#include <vector>

namespace saccade::eval {

enum class Scale { kLog, kLinear };  // kLog: of finite values > 0

class ChartAxis {
 public:
  // Runs from pixel `first` to pixel `last`.
  ChartAxis(Scale scale, double first, double last) : scale_(scale), first_(first), last_(last) {}

  void include(double v);  // widens the axis so that it holds v
  double operator()(double v) const;
  // Steps of 1, 2, 5 times a power of ten. A logarithmic axis of many decades has only powers of ten; one
  // that would have two ticks has 1 to 9.
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
