// Runs methods in a case of the stability suite.
#pragma once

#include <optional>

#include "eval/bench/bench.h"
#include "stability/cases.h"

namespace saccade::test {

inline constexpr int kStabilitySpp = 2;  // paths per pixel and frame, the same for all methods

struct StabilityForm {
  int reference_spp, repeats;
  std::string cache;  // folder of reference frames
};

class StabilityBench {
 public:
  // Renders the truth, if the case has one.
  StabilityBench(const StabilityCase& c, const StabilityForm& form, TilePool& pool);

  Figures measure(const MethodSpec& method) const;

 private:
  double drift(const Image<double>& L) const;

  const StabilityCase& case_;
  int repeats_;
  eval::Bench bench_;
  std::optional<eval::Bench> start_;  // its truth is that of frame 0, for the drift
};

}  // namespace saccade::test
