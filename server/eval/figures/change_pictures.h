// Methods side by side as the paper's Figure 6 shows them: a column for each method, and rows for the change
// of intensity, the change of brightness and the events of one frame.
#pragma once

#include <string>
#include <vector>

#include "eval/bench/score.h"
#include "eval/pictures/picture_grid.h"

namespace saccade::eval {

class ChangePictures {
 public:
  // The colours have the scale of the reference: red brighter, blue darker.
  ChangePictures(const IntensityChange& reference, float bias, double threshold);

  // Adds a column, with its figures below the pictures. Without a score it is the reference's own.
  void add(const std::string& name, const IntensityChange& change, const Score* score);
  std::string draw() const;  // SVG

 private:
  float bias_;
  double threshold_;
  float scale_dI_, scale_dL_;
  std::vector<std::string> names_;
  std::vector<std::vector<GridPicture>> rows_{3};
};

}  // namespace saccade::eval
