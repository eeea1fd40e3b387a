// The rows of the paper's Figure 6: change of intensity, of brightness, and events, a column for each method.
#pragma once

#include <string>
#include <vector>

#include "eval/metrics/frame_errors.h"
#include "eval/page.h"

namespace saccade {

class Figure6 {
 public:
  // The scale of the colours is that of the reference.
  Figure6(const IntensityChange& reference, float bias, double threshold);

  // Adds a column. Without errors it is the reference's own.
  void add(const std::string& name, const IntensityChange& change, const FrameErrors* errors);
  void write(Page& page) const;

 private:
  float bias_;
  double threshold_;
  float scale_dI_, scale_dL_;
  std::vector<std::string> names_;
  std::vector<std::vector<Page::Cell>> rows_{3};
};

}  // namespace saccade
