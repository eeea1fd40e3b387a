// Frames that `saccade events` reads. The pictures are written by OpenImageIO.
#include "client/frames/frame_source.h"

#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>

#include <array>
#include <fstream>

#include "scratch_folder.h"

namespace saccade::client {
namespace {

class Frames : public testing::Test {
 protected:
  std::string picture(const std::string& name, OIIO::TypeDesc type, int channels, std::vector<float> values,
                      int width = 2) {
    const std::string path = folder_.at(name);
    const auto out = OIIO::ImageOutput::create(path);
    const int height = static_cast<int>(values.size()) / channels / width;
    EXPECT_TRUE(out->open(path, OIIO::ImageSpec(width, height, channels, type)));
    EXPECT_TRUE(out->write_image(OIIO::TypeDesc::FLOAT, values.data()));
    EXPECT_TRUE(out->close());
    return path;
  }
  std::string raw(const std::string& name, const std::vector<float>& values, std::size_t bytes) {
    const std::string path = folder_.at(name);
    std::ofstream(path, std::ios::binary)
        .write(reinterpret_cast<const char*>(values.data()), static_cast<std::streamsize>(bytes));
    return path;
  }
  const ScratchFolder folder_;
};

template <class Fault>
std::string faultOf(const auto& act) {
  try {
    act();
  } catch (const Fault& fault) {
    return fault.what();
  }
  return {};
}

TEST_F(Frames, ColoursBecomeLuminance) {
  const std::vector<float> colours{1, 0, 0, 0, 1, 0, 0, 0, 1, 2, 2, 2};
  const std::string file = picture("a.exr", OIIO::TypeDesc::FLOAT, 3, colours);
  const auto frames = openPictures({file, file}, std::nullopt);
  EXPECT_EQ(frames->frames(), 2u);
  EXPECT_EQ(frames->width(), 2);
  EXPECT_EQ(frames->height(), 2);
  const IntensityFrame light = *frames->next();
  for (std::size_t i = 0; i < 4; ++i)
    EXPECT_NEAR(light[i], (std::array{0.2126, 0.7152, 0.0722, 2.0})[i], 1e-6);
  EXPECT_EQ(*frames->next(), light);
  EXPECT_FALSE(frames->next());
}

// Half of the largest number is .5 on the curve of sRGB: ((.5 + .055) / 1.055)^2.4 = .21404.
TEST_F(Frames, WholeNumbersAreSrgbUnlessTheUserSaysOtherwise) {
  const std::string file = picture("a.png", OIIO::TypeDesc::UINT16, 1, {0, 0.5, 1, 0.02});
  const auto first = [&](std::optional<Transfer> transfer) {
    return *openPictures({file, file}, transfer)->next();
  };
  const IntensityFrame srgb = first(std::nullopt), linear = first(Transfer::kLinear);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_NEAR(srgb[i], (std::array{0.0, 0.21404, 1.0, 0.02 / 12.92})[i], 2e-5);
    EXPECT_NEAR(linear[i], (std::array{0.0, 0.5, 1.0, 0.02})[i], 2e-5);
  }
}

TEST_F(Frames, AlphaIsNoLight) {
  const std::string file = picture("a.png", OIIO::TypeDesc::UINT8, 2, {1, 1, 0, 1});
  EXPECT_EQ(*openPictures({file, file}, std::nullopt)->next(), (IntensityFrame{1, 0}));
}

TEST_F(Frames, AFolderGivesItsPicturesInTheOrderOfTheirNames) {
  for (const int i : {2, 1, 3}) picture(std::to_string(i) + ".exr", OIIO::TypeDesc::FLOAT, 1, {float(i), 0});
  std::ofstream(folder_.at("times.csv")) << "t\n";
  const auto frames = openPictures({folder_.at("")}, std::nullopt);
  EXPECT_EQ(frames->frames(), 3u);
  for (int i = 1; i <= 3; ++i) EXPECT_EQ(frames->next()->front(), i);
}

TEST_F(Frames, PicturesOfOtherSizesAreRefused) {
  const std::string small = picture("a.exr", OIIO::TypeDesc::FLOAT, 1, {1, 1}),
                    large = picture("b.exr", OIIO::TypeDesc::FLOAT, 1, {1, 1, 1}, 3);
  const auto frames = openPictures({small, large}, std::nullopt);
  frames->next();
  EXPECT_NE(faultOf<std::runtime_error>([&] {
              frames->next();
            }).find("b.exr: has 3x1 pixels, but the first frame has 2x1"),
            std::string::npos);
  EXPECT_EQ(faultOf<std::invalid_argument>([&] { openPictures({small}, std::nullopt); }),
            "events need at least two frames");
  EXPECT_EQ(faultOf<std::invalid_argument>([&] {
              openPictures({"none.exr", small}, std::nullopt);
            }),
            "there is no file 'none.exr'");
}

TEST_F(Frames, RawFilesFollowEachOther) {
  const std::string two = raw("a", {1, 2, 3, 4}, 16), one = raw("b", {5, 6}, 8), torn = raw("c", {7, 8}, 6);
  const auto frames = openRawFrames({two, one, torn}, 2, 1, Transfer::kLinear);
  EXPECT_EQ(*frames->next(), (IntensityFrame{1, 2}));
  EXPECT_EQ(*frames->next(), (IntensityFrame{3, 4}));
  EXPECT_EQ(*frames->next(), (IntensityFrame{5, 6}));
  EXPECT_NE(faultOf<std::runtime_error>([&] { frames->next(); }).find("ends within a frame"),
            std::string::npos);
  EXPECT_NEAR(openRawFrames({raw("d", {0.5}, 4)}, 1, 1, Transfer::kSrgb)->next()->front(), 0.21404, 1e-5);
}

}  // namespace
}  // namespace saccade::client
