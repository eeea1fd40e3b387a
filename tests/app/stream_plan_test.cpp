// From a request to packets in one process, without a socket.
#include "app/sequence/stream_plan.h"

#include <gtest/gtest.h>
#include <link.h>

#include <string>
#include <vector>

#include "app/request/refusal.h"
#include "app/request/resolve_trajectory.h"
#include "app/sequence/channel.h"
#include "app/sequence/stream_rig.h"

namespace saccade {
namespace {

v1::OpenStream request() {
  v1::OpenStream r;
  r.set_scene("cornell-box");
  r.mutable_view()->set_width(32), r.mutable_view()->set_height(24);
  r.mutable_trajectory()->set_name("right");
  r.mutable_timing()->set_frame_rate_hz(1000), r.mutable_timing()->set_duration_s(0.01);
  r.add_sensors()->set_threshold(0.1);
  return r;
}

struct StreamPlanTest : testing::Test {
  StreamPlan plan(const v1::OpenStream& request) {
    return planStream(request, scenes.library(), tables, limits);
  }

  const Limits limits;
  const MeasuredTables tables{openAccuracySource(""), openSimplificationSource("")};
  SceneCache scenes{std::string(SACCADE_SOURCE_DIR) + "/scenes"};
};

TEST_F(StreamPlanTest, LeadsToTheEventsOfEachInterval) {
  StreamPlan of = plan(request());
  loadScenes(of, scenes, {});
  TilePool pool(2);
  Rig rig =
      makeRig(of.scene, resolveTrajectory(of.resolved, *of.whole, scenes.library()), of.resolved, {pool});
  const auto channels = makeChannels(of.resolved, "one", 1);
  ASSERT_EQ(channels.size(), 1u);
  std::uint64_t events = 0;
  std::int64_t until = 0;
  for (FrameIndex i = 0; i < of.resolved.frames; ++i) {
    channels[0]->process(rig.step({pool}).front(), true);
    for (const Packet& packet : channels[0]->takePackets()) {
      PacketContent content;
      ASSERT_EQ(decodePacket(packet.header, *packet.payload, content), "");
      EXPECT_GE(packet.header.t0_ns(), until);
      until = packet.header.t1_ns(), events += content.events.size();
    }
  }
  EXPECT_EQ(until, 10'000'000);
  EXPECT_GT(events, 0u);
  EXPECT_EQ(events, channels[0]->items());
}

TEST_F(StreamPlanTest, RefusesAsAServerDoes) {
  v1::OpenStream unknown = request(), large = request();
  unknown.set_scene("nowhere");
  large.mutable_method()->set_spp(1'000'000);
  EXPECT_THROW(plan(unknown), Refusal);
  EXPECT_THROW(plan(large), Refusal);
}

// Of the libraries of this program, which links what a batch needs.
TEST(RequestLibrary, LinksNoTransport) {
  std::vector<std::string> loaded;
  const auto add = [](dl_phdr_info* info, std::size_t, void* to) {
    static_cast<std::vector<std::string>*>(to)->push_back(info->dlpi_name);
    return 0;
  };
  dl_iterate_phdr(add, &loaded);
  ASSERT_GT(loaded.size(), 3u);
  for (const std::string& library : loaded)
    for (const char* transport : {"zmq", "microhttpd", "wslay"})
      EXPECT_EQ(library.find(transport), std::string::npos) << library;
}

}  // namespace
}  // namespace saccade
