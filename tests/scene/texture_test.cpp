#include "scene/texture.h"

#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <cmath>

#include "base/hash_rng.h"
#include "scene/scratch.h"

namespace saccade {
namespace {

Texture randomTexture(int width, int height, double& mean) {
  std::vector<Rgb> pixels;
  mean = 0;
  for (int i = 0; i < width * height; ++i) {
    const float v = toUnit(mix64(static_cast<std::uint64_t>(i)));
    pixels.push_back({v, v, v});
    mean += v / (width * height);
  }
  return Texture(width, height, std::move(pixels));
}

// The mean of a bilinear picture over its pixel centres is the mean of its pixels.
double meanOfSamples(const Texture& t, int width, int height, float footprint) {
  double mean = 0;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      mean += t.sample({(x + 0.5f) / width, (y + 0.5f) / height}, footprint).x / (width * height);
  return mean;
}

TEST(Texture, EveryLevelKeepsTheMean) {
  for (const auto& [width, height] : {std::pair{16, 16}, {13, 7}, {1, 5}, {9, 2}}) {
    double mean = 0;
    const Texture t = randomTexture(width, height, mean);
    int w = width, h = height;
    for (float size = 1; w * h > 1; size *= 2, w = std::max(1, w / 2), h = std::max(1, h / 2))
      EXPECT_NEAR(meanOfSamples(t, w, h, size / static_cast<float>(std::max(width, height))), mean, 1e-6)
          << width << " x " << height << " at " << w << " x " << h;
    EXPECT_NEAR(t.sample({0.3f, 0.8f}, 1).x, mean, 1e-6);
    EXPECT_NEAR(t.sample({0.3f, 0.8f}, INFINITY).x, mean, 1e-6);
  }
}

Texture fourPixels() {  // 0 1 over 2 3
  return Texture(2, 2, {{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {3, 3, 3}});
}

TEST(Texture, PixelCentresGiveThePixelsWithTheFirstRowOnTop) {
  const Texture t = fourPixels();
  EXPECT_FLOAT_EQ(t.sample({0.25f, 0.75f}, 0).x, 0);
  EXPECT_FLOAT_EQ(t.sample({0.75f, 0.75f}, 0).x, 1);
  EXPECT_FLOAT_EQ(t.sample({0.25f, 0.25f}, 0).x, 2);
  EXPECT_FLOAT_EQ(t.sample({0.75f, 0.25f}, 0).x, 3);
}

// The row on top is 0 1, and then 1 0, or 1 1.
TEST(Texture, IsMirroredOrGoesOnBeyondItsEdges) {
  using Wrap = Texture::Wrap;
  Texture t = fourPixels();
  t.setWrap(Wrap::kMirror, Wrap::kRepeat);
  for (const auto& [u, value] : {std::pair{0.f, 0.f}, {1.f, 1.f}, {1.25f, 1.f}, {1.75f, 0.f}, {-0.75f, 1.f}})
    EXPECT_FLOAT_EQ(t.sample({u, 0.75f}, 0).x, value) << u;
  t.setWrap(Wrap::kClamp, Wrap::kClamp);
  for (const auto& [u, value] : {std::pair{-7.f, 0.f}, {0.f, 0.f}, {0.5f, 0.5f}, {1.f, 1.f}, {9.f, 1.f}})
    EXPECT_FLOAT_EQ(t.sample({u, 4}, 0).x, value) << u;
  EXPECT_FLOAT_EQ(t.sample({NAN, 4}, 0).x, 0);
}

TEST(Texture, IsBilinearBetweenThem) {
  const Texture t = fourPixels();
  EXPECT_FLOAT_EQ(t.sample({0.375f, 0.75f}, 0).x, 0.25f);
  EXPECT_FLOAT_EQ(t.sample({0.5f, 0.5f}, 0).x, 1.5f);
  EXPECT_FLOAT_EQ(t.sample({0.25f, 0.375f}, 0).x, 1.5f);  // three quarters of 2, a quarter of 0
}

TEST(Texture, Repeats) {
  const Texture t = fourPixels();
  EXPECT_FLOAT_EQ(t.sample({0, 0.75f}, 0).x, 0.5f);  // across the seam
  EXPECT_FLOAT_EQ(t.sample({3.375f, -6.25f}, 0).x, t.sample({0.375f, 0.75f}, 0).x);
  EXPECT_FLOAT_EQ(t.sample({-1e-9f, 0.75f}, 0).x, 0.5f);
}

TEST(Texture, IsLinearBetweenLevels) {
  const Texture t = fourPixels();  // level 1 is the mean, 1.5
  EXPECT_NEAR(t.sample({0.25f, 0.75f}, std::exp2(-0.75f)).x, 0.25f * 1.5f, 1e-6);
}

TEST(Texture, StaysFiniteForDegenerateCoordinates) {
  const Texture t = fourPixels();
  for (const float bad : {NAN, INFINITY, 1e30f})
    EXPECT_TRUE(std::isfinite(t.sample({bad, bad}, bad).x + t.sample({bad, 0}, 0).x));
}

TEST(Texture, KnowsWhetherItIsGrey) {
  EXPECT_TRUE(fourPixels().grey());
  EXPECT_FALSE(Texture(1, 1, {{0.5f, 0.5f, 0.4f}}).grey());
}

std::string writePicture(const Scratch& files, int channels, const std::vector<unsigned char>& bytes) {
  const std::string path = files.path("picture.png");
  auto out = OIIO::ImageOutput::create(path);
  const int pixels = static_cast<int>(bytes.size()) / channels;
  EXPECT_TRUE(out->open(path, OIIO::ImageSpec(pixels, 1, channels, OIIO::TypeDesc::UINT8)));
  EXPECT_TRUE(out->write_image(OIIO::TypeDesc::UINT8, bytes.data()));
  EXPECT_TRUE(out->close());
  return path;
}

TEST(LoadTexture, MakesSrgbLinearUnlessRaw) {
  const Scratch files;
  const std::string path = writePicture(files, 3, {255, 128, 0});
  const Rgb linear = loadTexture(path, PixelUse::kReflectance).sample({0.5f, 0.5f}, 0);
  expectNear(linear, {1, static_cast<float>(std::pow((128 / 255.0 + 0.055) / 1.055, 2.4)), 0}, 1e-6);
  expectNear(loadTexture(path, PixelUse::kRawReflectance).sample({0.5f, 0.5f}, 0), {1, 128 / 255.0f, 0},
             1e-6);
}

TEST(LoadTexture, SpreadsOneChannelAndLeavesOutAlpha) {
  const Scratch files;
  EXPECT_TRUE(loadTexture(writePicture(files, 1, {10, 200}), PixelUse::kRawReflectance).grey());
  const Rgb seen = loadTexture(writePicture(files, 4, {255, 255, 255, 51}), PixelUse::kRawReflectance)
                       .sample({0.5f, 0.5f}, 0);
  expectNear(seen, {1, 1, 1}, 1e-6);
}

TEST(LoadTexture, NamesAFileItCannotRead) {
  const Scratch files;
  expectContains(errorOf([&] { loadTexture(files.path("absent.png"), PixelUse::kReflectance); }),
                 "absent.png");
  const std::string faulty = files.write("faulty.png", "\x89PNG\r\n\x1a\n then nothing");
  expectContains(errorOf([&] { loadTexture(faulty, PixelUse::kReflectance); }), "faulty.png");
}

}  // namespace
}  // namespace saccade
