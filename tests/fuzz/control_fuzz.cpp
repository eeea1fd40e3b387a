// A request, as far as it goes before anything is rendered.
#include <future>

#include "app/admission/stream_cost.h"
#include "app/request/refusal.h"
#include "app/request/request_bounds.h"
#include "app/request/resolve.h"
#include "app/request/resolve_trajectory.h"
#include "app/service.h"
#include "fuzz/fuzz_target.h"
#include "fuzz/message_mutator.h"
#include "fuzz/path_check.h"
#include "stream/control_server.h"

namespace saccade {
namespace {

MeasuredTables measuredTables() {
  MeasuredTables tables;
  const MethodSpec svgf = parseMethod("svgf"), ours = parseMethod("event_svgf");
  tables.accuracy.table = {
      .settings = "size=64x48",
      .cpu = "",
      .width = 64,
      .height = 48,
      .frames = 21,
      .bounces = 3,
      .threshold = 0.2,
      .rows = {{"cornell-box", svgf, 2, 10, 0.1, 0.2}, {"cornell-box", ours, 4, 20, 0.05, 0.1}}};
  tables.simplification.table.rows = {
      {"cornell-box", {3, {}}, 20, 0, 0, 0, 0},
      {"cornell-box", {1, {SceneFeature::kTextures}}, 10, 0.1, 0.1, 0.05, 0.01}};
  return tables;
}

// All of a server but its sockets.
struct World {
  MeasuredTables tables = measuredTables();
  SceneCache scenes{SACCADE_SOURCE_DIR "/scenes"};
  SceneEntry entry = scenes.library().find("cornell-box").value();
  std::shared_ptr<const RenderScene> scene = scenes.get("cornell-box");
  TilePool pool{1};
  WakeFd data, broadcast;
  Totals totals;
  ClientLog log;
  SessionDirectory sessions;
  StreamRegistry streams{sessions, log, std::chrono::seconds(30)};
  ResourceQuota budget{Limits()};
  BakeStore bakes{"", Limits()};
  StreamOpener opener{
      {scenes, bakes, tables, pool, budget, streams, data, broadcast, totals, log, nullptr, 1}};
  Service service{scenes, budget, streams, opener, log, [] { return v1::ServerDescription(); }};
};

// A request for the resolved stream gets it.
void checkResolved(const ResolvedStream& stream, const World& world) {
  ResolvedStream again = resolve(stream.request, world.entry, world.tables);
  fitTo(world.scene->description(), again);
  SACCADE_CHECK(again.request.SerializeAsString().size() == stream.request.SerializeAsString().size());
  SACCADE_CHECK(again.feedKey() == stream.feedKey());
  SACCADE_CHECK(again.frames == stream.frames && again.sensors.size() == stream.sensors.size());
}

// As StreamMaker does it; every scene is the same one, that none has to be loaded.
v1::Status open(const v1::OpenStream& request, const World& world) {
  try {
    ResolvedStream stream = resolve(request, world.entry, world.tables);
    checkAlone(stream.request, world.budget.limits());
    fitTo(world.scene->description(), stream);
    checkResolved(stream, world);
    const Trajectory path = resolveTrajectory(stream, *world.scene, world.scenes.library());
    checkPath(path, frameTime(std::max<FrameIndex>(1, stream.frames), stream.feed.frame_rate_hz));
    return okStatus();
  } catch (...) {
    return statusOfException();
  }
}

v1::Status parseAndOpen(std::string_view bytes, const World& world) {
  try {
    return open(parseRequest(bytes).open_stream(), world);
  } catch (...) {
    return statusOfException();
  }
}

v1::Status answer(const RawRequest& request, World& world) {
  if (request.call == v1::Request::kOpenStream) return parseAndOpen(request.message.bytes, world);
  std::promise<v1::Status> status;
  world.service.handle(request, {}, [&](const v1::Reply& reply) { status.set_value(reply.status()); });
  return status.get_future().get();
}

bool read(std::string_view bytes) {
  static World world;
  RawRequest request;
  v1::Status status = readRequest({bytes}, request);
  if (status.code() == v1::CODE_OK) status = answer(request, world);
  SACCADE_CHECK(status.code() != v1::CODE_UNSPECIFIED && status.code() != v1::CODE_INTERNAL);
  SACCADE_CHECK(status.code() == v1::CODE_OK || !status.message().empty());
  SACCADE_CHECK(v1::Status().ParseFromString(status.SerializeAsString()));
  return status.code() == v1::CODE_OK;
}

const std::string kOpen =
    "protocol_version: 1 open_stream { scene: 'cornell-box' view { width: 32 height: 24 } "
    "timing { frame_rate_hz: 500 duration_s: 0.04 } sensors { threshold: 0.1 } ";

}  // namespace

const FuzzTarget& fuzzTarget() {
  static const std::vector<std::string> words{"",
                                              "cornell-box",
                                              "right",
                                              "shake",
                                              "svgf",
                                              "event_svgf",
                                              "pt_correlated",
                                              "alpha",
                                              "textures",
                                              "tall_block",
                                              "light",
                                              "specular",
                                              "0,0,0,0,0,0,0,1\n",
                                              "1 0 0 0 0 0 0 1\n",
                                              "99999999999999999999",
                                              "nan",
                                              "../",
                                              "\xc3\xa9",
                                              std::string(1, '\0')};
  static const FuzzTarget target{
      {bytesOf<v1::Request>("protocol_version: 1 list_scenes {}"),
       bytesOf<v1::Request>(kOpen +
                            "trajectory { name: 'right' } method { name: 'svgf' spp: 4 params { key: 'alpha' "
                            "value: 0.2 } } quality { bounces: 1 disabled_features: 'textures' } seed: 7 }"),
       bytesOf<v1::Request>(kOpen + "trajectory { motion { kind: MOTION_KIND_PAN speed: 5 turn_s: 0.1 } } "
                                    "quality { budget_ms: 30 } delivery: DELIVERY_LIVE }"),
       bytesOf<v1::Request>(kOpen +
                            "trajectory { keyframes { keys { rotation { w: 1 } } keys { time_s: 1 position "
                            "{ x: 1 } rotation { x: 1 } } } } quality { max_event_change: 0.1 } }"),
       bytesOf<v1::Request>(kOpen + "trajectory { name: 'still' } objects { name: 'tall_block' path { motion "
                                    "{ kind: OBJECT_MOTION_KIND_SPIN speed: 90 } } } objects { name: 'light' "
                                    "path { csv: '0 0 0 0 0 0 0 1\\n' } } }"),
       bytesOf<v1::Request>(kOpen + "trajectory { csv: '0 0 0 0 0 0 0 1\\n1 1 0 0 0 0 0 1\\n' } "
                                    "sensors { model: EVENT_MODEL_PROBABILISTIC refractory_s: 1e-3 "
                                    "reconstruction: RECONSTRUCTION_COMPLEMENTARY cutoff_hz: 2 } }")},
      words,
      read,
      [](const std::string& bytes, Draws& draw) { return mutateBytesOf<v1::Request>(bytes, words, draw); },
      5000};
  return target;
}

}  // namespace saccade
