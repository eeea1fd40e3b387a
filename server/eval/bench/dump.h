// The folders that `saccade-eval frames --dump` writes, with files for each frame. client/README.md describes
// them.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "eval/bench/reference.h"

namespace saccade::eval {

// All of these throw std::runtime_error, which names the file.

// The estimate of a method for the change into `frame`. Halves that a reference left there are removed.
void writeChange(const std::string& folder, int frame, const IntensityChange& change);
// The features of frame - 1, whose picture Iprev_N is.
void writeFeatures(const std::string& folder, int frame, const GBuffer& features);
// A reference, with its halves.
void writeReference(const std::string& folder, int frame, const ReferenceChange& truth);

// The frames with dI in both folders, sorted. Throws without one.
std::vector<int> commonFrames(const std::string& folder, const std::string& other);

// Only dI and I_prev are read.
IntensityChange readChange(const std::string& folder, int frame);
struct ChangeHalves {
  IntensityChange a, b;
};
std::optional<ChangeHalves> readHalves(const std::string& folder,
                                       int frame);  // none: a method's, or an older one

}  // namespace saccade::eval
