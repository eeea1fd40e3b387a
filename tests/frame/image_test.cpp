#include "frame/image.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <utility>

namespace saccade {
namespace {

TEST(Image, StartsAtZeroWithItsBorder) {
  const ImageF image(5, 3);
  for (int y = -ImageF::kBorder; y < 3 + ImageF::kBorder; ++y) {
    for (int x = -ImageF::kBorder; x < 5 + ImageF::kBorder; ++x)
      ASSERT_EQ(image.row(y)[x], 0) << x << ", " << y;
  }
}

template <class T>
void expectAlignedRows() {
  Image<T> image(33, 4);
  for (int y = 0; y < 4; ++y) EXPECT_EQ(reinterpret_cast<std::uintptr_t>(image.row(y)) % 64, 0u);
}

TEST(Image, RowsStartOnCacheLines) {
  expectAlignedRows<std::uint16_t>();
  expectAlignedRows<float>();
  expectAlignedRows<double>();
}

TEST(Image, FillsPixelsAndBorder) {
  ImageF image(4, 2);
  image.fill(7);
  const int last = ImageF::kBorder - 1;
  EXPECT_EQ(image.at(1, 1), 7);
  EXPECT_EQ(image.row(2 + last)[4 + last], 7);
  EXPECT_EQ(image.row(-ImageF::kBorder)[-ImageF::kBorder], 7);
}

TEST(Image, CopiesPixelsAndBorder) {
  ImageF from(4, 2), to(4, 2);
  from.fill(3);
  from.at(1, 1) = 5;
  to.copyFrom(from);
  from.fill(0);
  EXPECT_EQ(to.at(1, 1), 5);
  EXPECT_EQ(to.at(0, 0), 3);
  EXPECT_EQ(to.row(-ImageF::kBorder)[3 + ImageF::kBorder], 3);
}

TEST(Image, MovingKeepsTheMemory) {
  ImageF image(4, 2);
  const float* pixels = image.row(0);
  const ImageF moved = std::move(image);
  EXPECT_EQ(moved.row(0), pixels);
}

TEST(ImageDeathTest, SizesAndCopiesAreChecked) {
  EXPECT_DEATH(ImageF(0, 4), "logic fault");
  ImageF a(4, 2), b(2, 4);
  EXPECT_DEATH(a.copyFrom(b), "logic fault");
}

}  // namespace
}  // namespace saccade
