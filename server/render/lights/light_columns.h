// The flat lamps of a scene as columns of numbers, so that each lane can sample a lamp of its own.
#pragma once

#include <array>
#include <vector>

#include "base/vec.h"
#include "base/wide.h"

namespace saccade {

class AnalyticLight;
class Lights;

class LightColumns {
 public:
  // kClosedForm: AnalyticLight::holds().
  enum Column {
    kCornerX,
    kCornerY,
    kCornerZ,
    kEdge1X,
    kEdge1Y,
    kEdge1Z,
    kEdge2X,
    kEdge2Y,
    kEdge2Z,
    kNormalX,
    kNormalY,
    kNormalZ,
    kRed,
    kGreen,
    kBlue,
    kLuminance,
    kPdf,
    kClosedForm,
    kTriangle,
    kGeometry,
    kColumns
  };

  LightColumns(const Lights& lights, const AnalyticLight& analytic);

  bool allTriangles() const { return all_triangles_; }  // else at() of kTriangle tells

  // The light that Lights::at() chooses.
  template <int W>
  [[gnu::always_inline]] Uints<W> choose(const Floats<W>& u) const {
    Floats<W> index = 0;  // the number of lights whose running sum is not above u, by bisection
    for (std::size_t step = cdf_.size() / 2; step > 0; step /= 2) {
      const Floats<W> next = index + static_cast<float>(step);
      index = select(gather(cdf_.data(), toUints(next - 1.f)) <= u, next, index);
    }
    return toUints(stdx::min(index, Floats<W>(last_)));
  }

  template <int W>
  [[gnu::always_inline]] Floats<W> at(Column column, const Uints<W>& light) const {
    return gather(columns_[column].data(), light);
  }
  template <int W>
  [[gnu::always_inline]] Vec3T<Floats<W>> vectorAt(Column x, const Uints<W>& light) const {
    return {at<W>(x, light), at<W>(Column(x + 1), light), at<W>(Column(x + 2), light)};
  }

 private:
  std::array<std::vector<float>, kColumns> columns_;
  std::vector<float> cdf_;  // filled up to a power of two
  float last_;
  bool all_triangles_ = true;
};

}  // namespace saccade
