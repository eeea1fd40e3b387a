#include "scene/files/picture.h"

#include <sys/stat.h>

#include <cmath>

#include "scene/files/limits.h"
#include "scene/scratch.h"

namespace saccade {
namespace {

// Radiance HDR, one pixel: mantissas and the exponent they share.
std::string hdr(const std::string& rgbe) {
  return "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 1\n" + rgbe;
}

TEST(Picture, RadianceMayExceedOne) {
  const Scratch files;
  const std::string path =
      files.write("sun.hdr", hdr("\x80\x40\x20\x8a"));  // 128, 64, 32 times 2^(138 - 136)
  expectNear(loadPicture(path, PixelUse::kRadiance).pixels[0], {512, 256, 128}, 4);
  expectNear(loadPicture(path, PixelUse::kReflectance).pixels[0], {1, 1, 1}, 0);
}

TEST(Picture, SrgbIsMadeLinearForRadianceToo) {
  const Scratch files;
  const std::string path = files.write("a.ppm", "P3 1 1 255  255 128 0");
  const float half = static_cast<float>(std::pow((128 / 255.0 + 0.055) / 1.055, 2.4));
  expectNear(loadPicture(path, PixelUse::kRadiance).pixels[0], {1, half, 0}, 1e-6);
  expectNear(loadPicture(path, PixelUse::kRawReflectance).pixels[0], {1, 128 / 255.f, 0}, 1e-6);
}

// The header alone is read: nothing is set aside for the pixels.
TEST(Picture, ATooLargePictureIsAnErrorThatNamesTheLimit) {
  const Scratch files;
  const auto error = [&](const std::string& size) {
    const std::string path = files.write("large.ppm", "P6\n" + size + "\n255\n");
    return errorOf([&] { loadPicture(path, PixelUse::kReflectance); });
  };
  expectContains(error("16385 1"), "large.ppm: a picture of 16385 x 1; sides of 1 to 16384");
  expectContains(error("16384 16384"), "at most 134217728 pixels");
  expectContains(error("16384 8192"), "large.ppm: ");  // within the limits, but without its pixels
}

TEST(Picture, AFifoIsNotWaitedFor) {
  const Scratch files;
  ASSERT_EQ(mkfifo(files.path("a.png").c_str(), 0600), 0);
  expectContains(errorOf([&] { loadPicture(files.path("a.png"), PixelUse::kReflectance); }),
                 "a.png: cannot be read: is not a plain file");
}

// The 1.5 GiB that its pixels would take are not asked for.
TEST(Picture, AHeaderWithoutPixelsIsToldBeforeMemoryIsTaken) {
  const Scratch files;
  const std::string path = files.write("a.hdr", "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 8192 +X 16384\n");
  expectContains(errorOf([&] { loadPicture(path, PixelUse::kRadiance); }),
                 "a.hdr: a picture of 16384 x 8192 cannot be in a file of ");
}

}  // namespace
}  // namespace saccade
