// Pictures of masks: what is clear, their alpha says where they have one.
#include <OpenImageIO/imageio.h>

#include <cmath>

#include "scene/mitsuba_scratch.h"

namespace saccade {
namespace {

using Bytes = std::vector<unsigned char>;

// A row of pixels of so many channels, as they are: colours are not multiplied by alpha.
void writePicture(const std::string& path, int channels, const Bytes& bytes) {
  const int pixels = static_cast<int>(bytes.size()) / channels;
  OIIO::ImageSpec spec(pixels, 1, channels, OIIO::TypeDesc::UINT8);
  spec.attribute("oiio:UnassociatedAlpha", 1);
  auto out = OIIO::ImageOutput::create(path);
  ASSERT_TRUE(out->open(path, spec) && out->write_image(OIIO::TypeDesc::UINT8, bytes.data()) && out->close());
}

// The colour of each pixel of a picture that a mask takes for its opacity.
std::vector<Rgb> opacities(int channels, const Bytes& bytes, const std::string& raw = "false") {
  const Scratch files;
  writePicture(files.path("leaf.png"), channels, bytes);
  const Scene scene =
      loadBody(files,
               "<shape type='rectangle'><bsdf type='mask'><texture name='opacity' type='bitmap'>"
               "<string name='filename' value='leaf.png'/><boolean name='raw' value='" +
                   raw +
                   "'/></texture><bsdf type='diffuse'><texture name='reflectance' type='bitmap'>"
                   "<string name='filename' value='leaf.png'/></texture></bsdf></bsdf></shape>");
  EXPECT_NE(scene.materials[0].opacity.texture, scene.materials[0].reflectance.texture);
  return scene.textures.at(static_cast<std::size_t>(scene.materials[0].opacity.texture)).pixels();
}

float linear(double byte) {
  return static_cast<float>(std::pow((byte / 255 + 0.055) / 1.055, 2.4));
}

// White where it is clear, as pictures of leaves are.
TEST(MaskPicture, TakesTheAlphaOfAPictureThatHasOne) {
  for (const char* raw : {"false", "true"}) {
    const std::vector<Rgb> found = opacities(4, {255, 255, 255, 0, 90, 120, 40, 255, 90, 120, 40, 51}, raw);
    ASSERT_EQ(found.size(), 3u);
    expectNear(found[0], {0, 0, 0}, 1e-6);
    expectNear(found[1], {1, 1, 1}, 1e-6);
    expectNear(found[2], {0.2f, 0.2f, 0.2f}, 1e-6);
  }
  expectNear(opacities(2, {255, 51})[0], {0.2f, 0.2f, 0.2f}, 1e-6);
}

TEST(MaskPicture, TakesTheColoursOfAnyOther) {
  const Rgb half{linear(128), linear(128), linear(128)};
  expectNear(opacities(3, {128, 128, 128, 255, 255, 255})[0], half, 1e-6);
  expectNear(opacities(1, {128, 255})[0], half, 1e-6);
  expectNear(opacities(4, {128, 128, 128, 255, 0, 0, 0, 255})[0], half, 1e-6);  // opaque all over
  expectNear(opacities(3, {128, 128, 128}, "true")[0], {128 / 255.f, 128 / 255.f, 128 / 255.f}, 1e-6);
}

}  // namespace
}  // namespace saccade
