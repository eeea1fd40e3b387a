// Files of pictures. OpenImageIO itself writes what Saccade cannot.
#include <OpenImageIO/deepdata.h>
#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>

#include <array>
#include <stdexcept>

#include "client/scratch_folder.h"
#include "pictures/library.h"

namespace saccade::pictures {
namespace {

std::vector<float> read(Input& file, int channels) {
  std::vector<float> numbers(file.shape().pixels() * channels);
  file.read(0, channels, numbers.data(), channels * sizeof(float));
  return numbers;
}

std::string faultOf(const auto& act) {
  try {
    act();
  } catch (const std::runtime_error& fault) {
    return fault.what();
  }
  return {};
}

// Written by OpenImageIO.
void write(const std::string& path, const OIIO::ImageSpec& spec, const std::vector<unsigned char>& numbers) {
  const auto file = OIIO::ImageOutput::create(path);
  ASSERT_TRUE(file->open(path, spec) && file->write_image(OIIO::TypeDesc::UINT8, numbers.data()) &&
              file->close());
}

class PictureLibrary : public testing::Test {
 protected:
  const ScratchFolder folder_;
};

TEST_F(PictureLibrary, WhatIsWrittenIsRead) {
  const std::vector<float> numbers{0.5f, -2, 1e6f, 0, 3, 7};
  const std::string path = folder_.at("a.exr");
  const Shape shape{.width = 3, .height = 1, .channels = {"near", "wide"}, .notes = {{"spp", 64}}};
  library().write(path, shape, numbers.data());
  const auto file = library().open(path);
  EXPECT_EQ(file->shape().width, 3);
  EXPECT_EQ(file->shape().height, 1);
  EXPECT_EQ(file->shape().channels, (std::vector<std::string>{"near", "wide"}));
  EXPECT_EQ(file->shape().number, Number::kF32);
  EXPECT_EQ(file->shape().notes, (std::map<std::string, int>{{"spp", 64}}));
  EXPECT_EQ(read(*file, 2), numbers);
}

TEST_F(PictureLibrary, ColoursAreNotMultipliedByAlpha) {
  const std::string path = folder_.at("a.png");
  OIIO::ImageSpec spec(1, 1, 4, OIIO::TypeDesc::UINT8);
  spec.attribute("oiio:UnassociatedAlpha", 1);
  write(path, spec, {255, 51, 0, 102});
  const auto file = library().open(path);
  EXPECT_EQ(file->shape().alpha, 3);
  EXPECT_EQ(file->shape().number, Number::kU8);
  const std::vector<float> numbers = read(*file, 4);
  for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(numbers[i], (std::array{1.0, 0.2, 0.0, 0.4})[i], 1e-6);
}

// A deep picture holds any number of samples in each pixel.
TEST_F(PictureLibrary, ADeepPictureIsRefused) {
  const std::string path = folder_.at("a.exr");
  OIIO::ImageSpec spec(1, 1, 1, OIIO::TypeDesc::FLOAT);
  spec.deep = true;
  OIIO::DeepData samples(spec);
  samples.set_samples(0, 2);
  const auto file = OIIO::ImageOutput::create(path);
  ASSERT_TRUE(file->open(path, spec) && file->write_deep_image(samples) && file->close());
  EXPECT_EQ(faultOf([&] { library().open(path); }), path + ": is not flat: its pixels have depth");
}

TEST_F(PictureLibrary, FaultsNameTheFile) {
  const std::string path = folder_.at("none/a.png");
  EXPECT_TRUE(faultOf([&] { library().open(path); }).starts_with(path + ": "));
  const unsigned char black = 0;
  EXPECT_TRUE(faultOf([&] {
                library().write(path, {1, 1, {"Y"}, Number::kU8}, &black);
              }).starts_with(path + ": "));
}

}  // namespace
}  // namespace saccade::pictures
