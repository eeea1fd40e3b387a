// Exposure, gain, gamma and rounding of frames.
#include <gtest/gtest.h>

#include <cmath>

#include "app/interval_of.h"
#include "truth/truth_run.h"

namespace saccade {
namespace {

TruthConfig config(FrameIndex every, FrameIndex exposure_frames) {
  TruthConfig c{.name = "frame", .frames = FrameSelection(every), .width = kWidth, .height = kHeight};
  c.frame_rate_hz = 1e9 / kPacketTimeNs;
  c.exposure_frames = exposure_frames;
  c.gamma = 1;
  return c;
}

// Frame t has the intensity t * `slope`.
TruthSamples expose(const TruthConfig& config, double slope, const char* channel = "frame") {
  const auto source = findTruth(channel)->make(config);
  TruthSamples all;
  for (FrameIndex t = 1; t <= 8; ++t) {
    const StillView view(intervalOf(t, static_cast<float>(slope * static_cast<double>(t)), 0));
    for (TruthSample& sample : source->sample(view.interval())) all.push_back(std::move(sample));
  }
  return all;
}

template <class Number>
Number pixelOf(const TruthSample& sample) {
  const auto numbers = test::elementsOf<Number>(sample);
  EXPECT_EQ(numbers.size(), std::size_t{kWidth} * kHeight);
  for (const Number n : numbers) EXPECT_EQ(n, numbers.front());
  return numbers.front();
}

TEST(ExposedFrame, RoundsClipsAndScales) {
  TruthConfig c = config(1, 1);
  EXPECT_EQ(pixelOf<std::uint8_t>(expose(c, 0.5).front()), 128);  // 127.5
  EXPECT_EQ(pixelOf<std::uint8_t>(expose(c, 0.001).front()), 0);  // 0.255
  EXPECT_EQ(pixelOf<std::uint8_t>(expose(c, 0.003).front()), 1);  // 0.765
  EXPECT_EQ(pixelOf<std::uint8_t>(expose(c, 3).front()), 255);
  EXPECT_EQ(pixelOf<std::uint16_t>(expose(c, 0.5, "frame16").front()), 32768);
  EXPECT_EQ(pixelOf<std::uint16_t>(expose(c, 3, "frame16").front()), 65535);
  c.gain = 0.5;
  EXPECT_EQ(pixelOf<std::uint8_t>(expose(c, 0.4).front()), 51);
  c.gamma = 2;
  EXPECT_EQ(pixelOf<std::uint8_t>(expose(c, 0.32).front()), 102);  // sqrt(0.16) * 255
}

TEST(ExposedFrame, IsTheMeanOfTheFramesInItsExposure) {
  const TruthSamples frames = expose(config(4, 3), 0.1);
  ASSERT_EQ(frames.size(), 2u);
  EXPECT_EQ(pixelOf<std::uint8_t>(frames[0]), std::lround(255 * 0.3));  // of frames 2, 3 and 4
  EXPECT_EQ(pixelOf<std::uint8_t>(frames[1]), std::lround(255 * 0.7));  // of frames 6, 7 and 8
  EXPECT_EQ(frames[1].t_ns, 8 * kPacketTimeNs);
  EXPECT_EQ(frames[1].exposure_begin_ns, 5 * kPacketTimeNs);
  EXPECT_EQ(frames[1].exposure_end_ns, 8 * kPacketTimeNs);
}

// A frame of two intervals, of a quarter and of three.
TEST(ExposedFrame, WeighsIntervalsByTheirLengths) {
  TruthConfig c = config(1, 1);
  c.frame_rate_hz /= 4;
  const auto source = findTruth("frame")->make(c);
  const auto sampleOf = [&](std::int64_t t0, std::int64_t t1, float intensity) {
    auto change = intervalOf(1, intensity, 0);
    change->t0 = TimeNs(t0 * kPacketTimeNs), change->t1 = TimeNs(t1 * kPacketTimeNs);
    const StillView view(std::move(change));
    FeedInterval interval = view.interval();
    interval.frame = 1, interval.ends_frame = t1 == 4;
    return source->sample(interval);
  };
  EXPECT_TRUE(sampleOf(0, 1, 0.4f).empty());
  const TruthSamples frames = sampleOf(1, 4, 0.8f);
  ASSERT_EQ(frames.size(), 1u);
  EXPECT_EQ(pixelOf<std::uint8_t>(frames[0]), std::lround(255 * 0.7));
  EXPECT_EQ(frames[0].exposure_begin_ns, 0);
  EXPECT_EQ(frames[0].t_ns, 4 * kPacketTimeNs);
}

TEST(ExposedFrame, IsLeftOutWhereItWouldOverlap) {
  const TruthSamples frames = expose(config(1, 3), 0.1);
  ASSERT_EQ(frames.size(), 2u);
  EXPECT_EQ(frames[0].exposure_begin_ns, 0);
  EXPECT_EQ(frames[0].t_ns, 3 * kPacketTimeNs);
  EXPECT_EQ(frames[1].exposure_begin_ns, 3 * kPacketTimeNs);
  EXPECT_EQ(frames[1].t_ns, 6 * kPacketTimeNs);
}

}  // namespace
}  // namespace saccade
