// Frames that `saccade events` reads. The pictures are written by OpenImageIO.
#include "client/frames/frame_source.h"

#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>

#include <array>
#include <fstream>
#include <stdexcept>

#include "client/frames/natural_order.h"
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
  // Red, green, blue and alpha as the file has them.
  std::string withAlpha(const std::string& name, OIIO::TypeDesc type, const std::vector<float>& values) {
    const std::string path = folder_.at(name);
    OIIO::ImageSpec spec(static_cast<int>(values.size()) / 4, 1, 4, type);
    spec.attribute("oiio:UnassociatedAlpha", 1);
    const auto out = OIIO::ImageOutput::create(path);
    EXPECT_TRUE(out->open(path, spec) && out->write_image(OIIO::TypeDesc::FLOAT, values.data()) &&
                out->close());
    return path;
  }
  std::string text(const std::string& name, const std::string& bytes) {
    std::ofstream(folder_.at(name), std::ios::binary) << bytes;
    return folder_.at(name);
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

// White under alpha is the light alpha. Half of the largest number is .21404 on the curve.
TEST_F(Frames, ColoursAreDecodedBeforeAlphaLiesOnThem) {
  const std::vector<float> white{1, 1, 1, 1, 1, 1, 1, 0.2f, 0.5, 0.5, 0.5, 0.2f, 1, 1, 1, 0};
  const std::string file = withAlpha("a.png", OIIO::TypeDesc::UINT16, white);
  const IntensityFrame srgb = *openPictures({file, file}, std::nullopt)->next(),
                       linear = *openPictures({file, file}, Transfer::kLinear)->next();
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_NEAR(srgb[i], (std::array{1.0, 0.2, 0.2 * 0.21404, 0.0})[i], 2e-5);
    EXPECT_NEAR(linear[i], (std::array{1.0, 0.2, 0.2 * 0.5, 0.0})[i], 2e-5);
  }
}

// OpenEXR holds light that has been multiplied. Where it is said to be coded, its colours are .5 under .5.
TEST_F(Frames, ColoursThatAlphaHasMultipliedAreNotMultipliedAgain) {
  const std::string file = picture("a.exr", OIIO::TypeDesc::FLOAT, 4, {0.25, 0.25, 0.25, 0.5, 3, 3, 3, 0});
  const IntensityFrame linear = *openPictures({file, file}, std::nullopt)->next();
  EXPECT_NEAR(linear[0], 0.25, 1e-6);
  EXPECT_NEAR(linear[1], 3, 1e-6);
  EXPECT_NEAR(openPictures({file, file}, Transfer::kSrgb)->next()->front(), 0.5 * 0.21404, 2e-5);
}

TEST_F(Frames, AFileOfSeveralPicturesIsRefused) {
  const std::string path = folder_.at("a.tif");
  const std::vector<OIIO::ImageSpec> pages(2, OIIO::ImageSpec(2, 1, 1, OIIO::TypeDesc::UINT8));
  const auto out = OIIO::ImageOutput::create(path);
  ASSERT_TRUE(out->open(path, 2, pages.data()));
  const std::array<std::uint8_t, 2> grey{1, 2};
  EXPECT_TRUE(out->write_image(OIIO::TypeDesc::UINT8, grey.data()));
  EXPECT_TRUE(out->open(path, pages[1], OIIO::ImageOutput::AppendSubimage));
  EXPECT_TRUE(out->write_image(OIIO::TypeDesc::UINT8, grey.data()) && out->close());
  EXPECT_NE(faultOf<std::runtime_error>([&] {
              openPictures({path, path}, std::nullopt);
            }).find("ffmpeg -i"),
            std::string::npos);
}

TEST_F(Frames, AHeaderTellsTheSizeBeforePixelsAreRead) {
  for (const char* size : {"20000 20000", "65535 65535", "4096 513", "4097 1"}) {
    const std::string file = text("a.pgm", std::string("P5 ") + size + " 255\n");
    const std::string fault = faultOf<std::runtime_error>([&] { openPictures({file, file}, std::nullopt); });
    EXPECT_NE(fault.find("a.pgm: a frame has 1 to 4096 pixels on each side and at most 2097152 in all"),
              fault.npos)
        << fault;
  }
  EXPECT_NE(faultOf<std::invalid_argument>([&] {
              openRawFrames({"-"}, 100000, 100000, Transfer::kLinear);
            }).find("100000x100000"),
            std::string::npos);
  EXPECT_NE(faultOf<std::invalid_argument>([&] {
              openRawFrames({"-"}, 4294967295, 1, Transfer::kLinear);
            }).find("4294967295x1"),
            std::string::npos);
  EXPECT_NE(
      faultOf<std::invalid_argument>([&] { openRawFrames({"-"}, 0, 5, Transfer::kLinear); }).find("0x5"),
      std::string::npos);
}

TEST(NaturalOrder, NumbersInNamesCountAsNumbers) {
  const std::vector<std::string> names{"a",      "a0.png",   "a1.png",  "a1b.png",
                                       "a2.png", "a02b.png", "a10.png", "a123456789012345678901234567890.png",
                                       "b1c10",  "b2c1"};
  for (std::size_t i = 0; i < names.size(); ++i)
    for (std::size_t j = 0; j < names.size(); ++j)
      EXPECT_EQ(naturalLess(names[i], names[j]), i < j) << names[i] << " " << names[j];
  EXPECT_TRUE(naturalLess("a01", "a1") && !naturalLess("a1", "a01"));
  EXPECT_TRUE(numberFalls("f/12.png", "f/2.png"));
  EXPECT_FALSE(numberFalls("f/2.png", "f/12.png") || numberFalls("g/9.png", "f/1.png") ||
               numberFalls("a1", "a01"));
}

TEST_F(Frames, AFolderGivesItsPicturesInTheOrderOfTheirNumbers) {
  for (const int i : {2, 1, 3, 11, 10})
    picture("f" + std::to_string(i) + ".exr", OIIO::TypeDesc::FLOAT, 1, {float(i), 0});
  std::ofstream(folder_.at("times.csv")) << "t\n";
  const auto frames = openPictures({folder_.at("")}, std::nullopt);
  EXPECT_EQ(frames->frames(), 5u);
  for (const int i : {1, 2, 3, 10, 11}) EXPECT_EQ(frames->next()->front(), i);
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
