#include "eval/figures/brightness_curves.h"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "client/scratch_folder.h"
#include "eval/planes.h"

namespace saccade::eval {
namespace {

using test::plane;

// One frame with a row of pixels in these regions.
Truth truthOf(const std::vector<std::uint32_t>& regions) {
  const ReferenceFrame frame(static_cast<int>(regions.size()), 1);
  Truth truth{{frame, frame}, RegionMap(static_cast<int>(regions.size()), 1)};
  std::copy(regions.begin(), regions.end(), truth.regions.row(0));
  return truth;
}

template <class... Planes>
BrightnessSequence brightness(ImageF start, Planes... dL) {
  BrightnessSequence L{std::move(start), {}};
  (L.dL.push_back(std::move(dL)), ...);
  return L;
}

// The spans are 0.3, 0.1, 0.9, 0.2 and 0.4 over two frames. Of n sorted spans, the one of rank 0.75 (n - 1)
// counts.
TEST(TypicalPixel, ShowsASmoothSurfaceAndMuchOfItsLight) {
  using namespace region;
  const auto L = brightness(plane({0, 0, 0, 0, 0}), plane({-0.3f, 0.1f, 0.5f, -0.1f, 0.4f}),
                            plane({0.1f, 0, 0.4f, -0.1f, -0.1f}));
  std::vector<Truth> truth;
  truth.push_back(truthOf({kSmooth, kSmooth, kSmooth, kSmooth, kSmooth}));
  truth.push_back(truthOf({kSmooth, kSmooth, kChanged, kSmooth, kSmooth}));
  EXPECT_EQ(typicalPixel(truth, L).x, 0);
  truth.push_back(truthOf({kCurved, kCurved, kCurved, kCurved, kCurved}));
  EXPECT_EQ(typicalPixel(truth, L).x, 4) << "none is smooth: of all";
}

TEST(WriteBrightness, MakesAColumnForEachCurve) {
  ScratchFolder folder;
  FigureOptions o;
  o.number = 7, o.output = folder.at("");
  std::vector<BrightnessCurve> curves;
  curves.push_back({"truth", LineStyle::kReference, brightness(plane({1, 2}), plane({0.5f, -1}))});
  curves.push_back({"ours", LineStyle::kLine, brightness(plane({1, 2}), plane({0.25f, 1}))});
  writeBrightness(o, "room", curves, {1, 0}, 4);
  std::ostringstream csv;
  csv << std::ifstream(folder.at("figure7_room_time.csv")).rdbuf();
  EXPECT_EQ(csv.str(), "seconds,truth,ours\n0,2,2\n0.25,1,3\n");
  for (const char* name : {"figure7_room_spectrum.csv", "figure7_room.svg"})
    EXPECT_TRUE(std::filesystem::exists(folder.at(name))) << name;
}

}  // namespace
}  // namespace saccade::eval
