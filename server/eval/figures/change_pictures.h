// Draws methods side by side, as Figure 6 of the paper does, a column for each. Rows are the picture, the
// change of intensity, the change of brightness and the events of one frame.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "eval/bench/score.h"
#include "eval/pictures/picture_grid.h"

namespace saccade::eval {

class ChangePictures {
 public:
  // The reference sets the scale of the colours.
  ChangePictures(const IntensityChange& reference, float bias, double threshold);

  // Adds a column with its scores below the pictures.
  void addMethod(const std::string& name, const IntensityChange& change, const Score& score);
  void addReference(const std::string& name, const IntensityChange& change,
                    double error);  // of dI, relative L1
  std::string draw() const;         // SVG

 private:
  using Captions = std::array<std::string, 3>;
  void add(const std::string& name, const IntensityChange& change, const Captions& captions);

  float bias_;
  double threshold_;
  float exposure_, scale_dI_, scale_dL_;
  std::vector<std::string> names_;
  std::vector<std::vector<GridPicture>> rows_{4};
};

}  // namespace saccade::eval
