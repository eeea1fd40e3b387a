// How far the log brightness of each pixel goes in an interval, up and down.
#pragma once

#include "events/pieces.h"
#include "frame/image.h"

namespace saccade {

class PathLengths {
 public:
  PathLengths(int width, int height) : sum_(width, height) {}

  void clear() { sum_.fill(0); }
  void add(const Pieces& pieces);
  // Replaces the changes of the last pieces by the lengths of the whole paths.
  void complete(ImageF& dL) const;

 private:
  ImageF sum_;
};

}  // namespace saccade
