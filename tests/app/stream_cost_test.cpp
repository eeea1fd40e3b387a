#include "app/admission/stream_cost.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "app/request/request_memory.h"
#include "frame/image.h"

namespace saccade {
namespace {

constexpr double kBytes = 1 << 20;  // of a MiB
constexpr double kWidth = 32, kHeight = 24;

ResolvedStream withObjects(int objects, const std::string& method = "irradiance_cache") {
  ResolvedStream stream;
  stream.feed.camera = pinhole(45, static_cast<int>(kWidth), static_cast<int>(kHeight));
  stream.feed.method = method;
  std::string bad;
  EXPECT_EQ(resolveParams(*findMethod(method), {}, stream.feed.params, bad), "");
  for (int i = 0; i < objects; ++i) stream.request.add_objects()->set_name("object" + std::to_string(i));
  stream.objects.resize(static_cast<std::size_t>(objects));
  return stream;
}

double bytesOf(const ResolvedStream& stream) {
  return kBytes * feedMemory(stream, {});
}

// The number of a pixel's object, in two frames, and what the cache of light keeps of changes.
TEST(StreamCost, CountsWhatAMovingFeedAdds) {
  const double pixels = (kWidth + 2 * ImageF::kBorder) * (kHeight + 2 * ImageF::kBorder);
  EXPECT_GE(bytesOf(withObjects(1, "event_svgf")) - bytesOf(withObjects(0, "event_svgf")), 2 * 4 * pixels);
  EXPECT_GE(bytesOf(withObjects(1)) - bytesOf(withObjects(1, "event_svgf")),
            bytesOf(withObjects(0)) - bytesOf(withObjects(0, "event_svgf")) + 1200 * kWidth * kHeight);
  EXPECT_GT(bytesOf(withObjects(2)), bytesOf(withObjects(1)));
}

TEST(StreamCost, CountsLampsInBothFramesAndTheScenesOwnPaths) {
  ResolvedStream stream = withObjects(2);
  const double before = bytesOf(stream);
  stream.shape_bytes = 3e6;
  EXPECT_NEAR(bytesOf(stream) - before, 2 * 3e6, 1);
  stream.objects[1].own_poses = 10'000;
  EXPECT_NEAR(bytesOf(stream) - before, 2 * 3e6 + 10'000 * 250, 1);
  stream.T_body_camera.resize(2), stream.further = {stream.feed};  // each view has a feed
  EXPECT_NEAR(bytesOf(stream), 2 * (before + 2 * 3e6 + 10'000 * 250), 2);
}

// Updates of two intervals and of tiles, log brightness at both ends, and objects at all times of an
// interval.
TEST(StreamCost, CountsWhatRefinementAdds) {
  for (const int objects : {0, 2}) {
    ResolvedStream stream = withObjects(objects);
    stream.shape_bytes = 1e4;
    const double before = bytesOf(stream);
    stream.feed.refinement.emplace();
    const double updates = 12 * stream.feed.refinement->most_updates;
    EXPECT_GE(bytesOf(stream) - before,
              kWidth * kHeight * (2 * 4 + 3 * updates) + (objects > 0 ? 32 * stream.shape_bytes : 0));
  }
}

// As pathMemory() of so many keyframes, of the camera and each object.
TEST(StreamCost, CountsThePathOfEachSteeredObject) {
  const auto steering = [](int objects) {
    ResolvedStream stream = withObjects(objects);
    stream.request.mutable_timing()->set_steerable(true);
    stream.frames = 1000;
    double sum = 0;
    for (const Share& share : sharesOf(stream, {}))
      if (share.limit == Limit::kMemory && share.field == "timing") sum += share.amount;
    return sum;
  };
  EXPECT_DOUBLE_EQ(steering(0), steeringMemory(1000));
  EXPECT_DOUBLE_EQ(steering(3), 4 * steeringMemory(1000));
}

}  // namespace
}  // namespace saccade
