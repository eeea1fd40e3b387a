// The flat lamps of a scene as columns of numbers, so that each lane can sample a lamp of its own.
#pragma once

#include <array>
#include <vector>

#include "base/vec.h"
#include "base/wide.h"
#include "render/lights/lamps.h"

namespace saccade {

class AnalyticLight;

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
    kPdf,            // per area, without a tree: of LightSet::kAll
    kPdfWithExtent,  // of LightSet::kWithExtent
    kClosedForm,
    kTriangle,
    kGeometry,
    kColumns
  };

  LightColumns(const Lamps& lamps, const AnalyticLight& analytic);

  bool allTriangles() const { return all_triangles_; }  // else at() of kTriangle tells

  // The lamp that Lamps::choose() finds without a tree.
  template <int W>
  [[gnu::always_inline]] Uints<W> choose(LightSet set, const Floats<W>& u) const {
    const Choice& of = choices_[static_cast<std::size_t>(set)];
    Floats<W> index = 0;  // the number of lamps whose running sum is not above u, by bisection
    for (std::size_t step = of.sums.size() / 2; step > 0; step /= 2) {
      const Floats<W> next = index + static_cast<float>(step);
      index = select(gather(of.sums.data(), toUints(next - 1.f)) <= u, next, index);
    }
    return toUints(stdx::min(index, Floats<W>(of.last)));
  }

  static Column pdfColumn(LightSet set) { return set == LightSet::kAll ? kPdf : kPdfWithExtent; }

  template <int W>
  [[gnu::always_inline]] Floats<W> at(Column column, const Uints<W>& light) const {
    return gather(columns_[column].data(), light);
  }
  template <int W>
  [[gnu::always_inline]] Vec3T<Floats<W>> vectorAt(Column x, const Uints<W>& light) const {
    return {at<W>(x, light), at<W>(Column(x + 1), light), at<W>(Column(x + 2), light)};
  }

 private:
  struct Choice {
    Choice() = default;
    explicit Choice(const LightChoice& of);
    std::vector<float> sums;  // filled up to a power of two
    float last = 0;
  };

  std::array<std::vector<float>, kColumns> columns_;
  std::array<Choice, kLightSets> choices_;
  bool all_triangles_ = true;
};

}  // namespace saccade
