// Loops over the pixels of planes, which must have one size.
#pragma once

#include "base/check.h"
#include "frame/image.h"

namespace saccade::eval {

template <class A, class B>
void checkSameSize(const Image<A>& a, const Image<B>& b) {
  SACCADE_CHECK(a.width() == b.width() && a.height() == b.height());
}

// visit(x, y) for every pixel of a plane like `image`, row by row.
template <class T, class Visit>
void forEachPixel(const Image<T>& image, Visit visit) {
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) visit(x, y);
  }
}

}  // namespace saccade::eval
