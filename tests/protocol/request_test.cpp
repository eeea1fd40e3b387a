// Bad requests are answered with the field at fault, and the server goes on.
#include <gtest/gtest.h>

#include <chrono>
#include <functional>
#include <limits>

#include "base/quantile.h"
#include "mock/test_server.h"

namespace saccade {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN(),
                 kInf = std::numeric_limits<double>::infinity();

v1::Motion& pan(v1::OpenStream& r) {
  v1::Motion& motion = *r.mutable_trajectory()->mutable_motion();
  motion.set_kind(v1::MOTION_KIND_PAN);
  motion.set_speed(15);
  return motion;
}

v1::Motion& roam(v1::OpenStream& r) {
  v1::Motion& motion = pan(r);
  motion.set_kind(v1::MOTION_KIND_ROAM);
  return motion;
}

// The second of two good keys.
v1::Keyframe& secondKey(v1::OpenStream& r) {
  v1::Keyframes& keyframes = *r.mutable_trajectory()->mutable_keyframes();
  for (const double time_s : {0.0, 0.5}) {
    keyframes.add_keys()->set_time_s(time_s);
    keyframes.mutable_keys()->rbegin()->mutable_rotation()->set_w(1);
  }
  return *keyframes.mutable_keys(1);
}

v1::OpenStream& setIntrinsics(v1::OpenStream& r, double f) {
  v1::Intrinsics& k = *r.mutable_view()->mutable_intrinsics();
  k.set_fx(f), k.set_fy(f), k.set_cx(16), k.set_cy(12);
  return r;
}

void setLens(v1::OpenStream& r, v1::DistortionModel model, std::initializer_list<double> coefficients) {
  v1::Distortion& lens = *r.mutable_view()->mutable_distortion();
  lens.set_model(model);
  for (const double k : coefficients) lens.add_coefficients(k);
}

struct SpoiltRequest {
  std::string field;
  std::function<void(v1::OpenStream&)> spoil;
  v1::Code code = v1::CODE_INVALID_ARGUMENT;
  std::string told = {};  // what the message must contain
};

// clang-format off
const std::vector<SpoiltRequest> kSpoiltRequests{
    {"scene", [](auto& r) { r.set_scene("no-such-scene"); }, v1::CODE_NOT_FOUND, "cornell-box"},
    {"scene", [](auto& r) { r.set_scene("../scenes/cornell-box"); }, v1::CODE_NOT_FOUND},
    {"scene", [](auto& r) { r.set_scene("/etc"); }, v1::CODE_NOT_FOUND},
    {"scene", [](auto& r) { r.clear_scene(); }, v1::CODE_NOT_FOUND},
    {"view.width", [](auto& r) { r.clear_view(); }},
    {"view.height", [](auto& r) { r.mutable_view()->set_height(0); }},
    {"view.width", [](auto& r) { r.mutable_view()->set_width(100000); }},
    {"view", [](auto& r) { r.mutable_view()->set_width(4096); r.mutable_view()->set_height(4096); }},
    {"view.fov_x_deg", [](auto& r) { r.mutable_view()->set_fov_x_deg(180); }, v1::CODE_INVALID_ARGUMENT,
     "180 is outside [1, 170]"},
    {"view.fov_x_deg", [](auto& r) { r.mutable_view()->set_fov_x_deg(kNan); }},
    {"view.intrinsics", [](auto& r) { setIntrinsics(r, 20).mutable_view()->set_fov_x_deg(40); }, v1::CODE_INVALID_ARGUMENT,
     "not both"},
    {"view.intrinsics.fx", [](auto& r) { setIntrinsics(r, 0); }, v1::CODE_INVALID_ARGUMENT, "[1, "},
    {"view.intrinsics.fy", [](auto& r) { setIntrinsics(r, 20).mutable_view()->mutable_intrinsics()->set_fy(kNan); }},
    {"view.intrinsics.cx", [](auto& r) { setIntrinsics(r, 20).mutable_view()->mutable_intrinsics()->set_cx(1e5); }},
    {"view.intrinsics.cy", [](auto& r) { setIntrinsics(r, 20).mutable_view()->mutable_intrinsics()->set_cy(-kInf); }},
    {"view.distortion.model", [](auto& r) { setLens(r, v1::DISTORTION_MODEL_UNSPECIFIED, {0, 0, 0, 0}); },
     v1::CODE_INVALID_ARGUMENT, "EQUIDISTANT"},
    {"view.distortion.model", [](auto& r) { setLens(r, v1::DistortionModel(9), {0, 0, 0, 0}); }},
    {"view.distortion.coefficients", [](auto& r) { setLens(r, v1::DISTORTION_MODEL_RADTAN, {0.1}); },
     v1::CODE_INVALID_ARGUMENT, "k1, k2, p1, p2"},
    {"view.distortion.coefficients", [](auto& r) { setLens(r, v1::DISTORTION_MODEL_EQUIDISTANT, {0, 0, 0, 0, 0}); }},
    {"view.distortion.coefficients", [](auto& r) { setLens(r, v1::DISTORTION_MODEL_RADTAN, {0, 0, 0, 0, 0, 0}); }},
    {"view.distortion.coefficients[1]", [](auto& r) { setLens(r, v1::DISTORTION_MODEL_RADTAN, {0, kNan, 0, 0}); }},
    {"view.distortion", [](auto& r) { setLens(setIntrinsics(r, 20), v1::DISTORTION_MODEL_RADTAN, {-0.9, 0, 0, 0}); },
     v1::CODE_INVALID_ARGUMENT, "folds back"},
    {"view.distortion", [](auto& r) { setLens(setIntrinsics(r, 8), v1::DISTORTION_MODEL_EQUIDISTANT, {0, 0, 0, 0}); },
     v1::CODE_INVALID_ARGUMENT, "85 degrees"},
    {"view.distortion", [](auto& r) { setLens(r, v1::DISTORTION_MODEL_RADTAN, {-900, 0, 0, 0}); }},
    {"trajectory", [](auto& r) { r.clear_trajectory(); }},
    {"trajectory.name", [](auto& r) { r.mutable_trajectory()->set_name("../x"); }, v1::CODE_NOT_FOUND, "right"},
    {"trajectory.csv", [](auto& r) { r.mutable_trajectory()->set_csv(""); }},
    {"trajectory.csv", [](auto& r) { r.mutable_trajectory()->set_csv("0 0 0 0 0 0 0 1\n1 2 3\n"); },
     v1::CODE_INVALID_ARGUMENT, "line 2: a line of 3"},
    {"trajectory.csv", [](auto& r) { r.mutable_trajectory()->set_csv(std::string((8 << 20) + 1, '#')); }},
    {"trajectory.motion.kind", [](auto& r) { pan(r).clear_kind(); }, v1::CODE_INVALID_ARGUMENT, "pedestal"},
    {"trajectory.motion.kind", [](auto& r) { pan(r).set_kind(v1::MotionKind(99)); }, v1::CODE_INVALID_ARGUMENT,
     "MOTION_KIND_ORBIT"},
    {"trajectory.motion", [](auto& r) { pan(r).clear_speed(); }, v1::CODE_INVALID_ARGUMENT, "px_per_frame"},
    {"trajectory.motion.speed", [](auto& r) { pan(r).set_speed(0); }},
    {"trajectory.motion.speed", [](auto& r) { pan(r).set_speed(kNan); }},
    {"trajectory.motion.speed", [](auto& r) { pan(r).set_speed(-2e6); }},
    {"trajectory.motion.speed", [](auto& r) { auto& m = pan(r); m.set_kind(v1::MOTION_KIND_SHAKE); m.set_speed(-15); }},
    {"trajectory.motion.px_per_frame", [](auto& r) { pan(r).set_px_per_frame(kInf); }},
    {"trajectory.motion.turn_s", [](auto& r) { pan(r).set_turn_s(-1); }},
    {"trajectory.motion.turn_s", [](auto& r) { pan(r).set_turn_s(1e-4); }},
    {"trajectory.motion.turn_s", [](auto& r) { pan(r).set_turn_s(kNan); }},
    {"trajectory.motion.speed", [](auto& r) { auto& m = pan(r); m.set_kind(v1::MOTION_KIND_RANDOM); m.set_speed(-15); }},
    {"trajectory.motion.speed", [](auto& r) { roam(r).set_speed(-15); }},
    {"trajectory.motion.clearance", [](auto& r) { roam(r).set_clearance(0); }, v1::CODE_INVALID_ARGUMENT, "[1e-06, 1000000]"},
    {"trajectory.motion.clearance", [](auto& r) { roam(r).set_clearance(kNan); }},
    {"trajectory.motion.clearance", [](auto& r) { pan(r).set_clearance(0.1); }, v1::CODE_INVALID_ARGUMENT, "roam does"},
    {"trajectory.motion.start.position.y", [](auto& r) { pan(r).mutable_start()->mutable_position()->set_y(kNan); }},
    {"trajectory.motion.start.position.z", [](auto& r) { pan(r).mutable_start()->mutable_position()->set_z(-1e10); },
     v1::CODE_INVALID_ARGUMENT, "[-1000000000, 1000000000]"},
    {"trajectory.motion.start.rotation", [](auto& r) { pan(r).mutable_start()->mutable_rotation(); }},
    {"trajectory.motion.start.rotation", [](auto& r) { pan(r).mutable_start()->mutable_rotation()->set_w(kInf); }},
    {"trajectory.keyframes.keys", [](auto& r) { r.mutable_trajectory()->mutable_keyframes(); },
     v1::CODE_INVALID_ARGUMENT, "100000"},
    {"trajectory.keyframes.keys",
     [](auto& r) { auto& k = *r.mutable_trajectory()->mutable_keyframes(); while (k.keys_size() <= 100'000) k.add_keys(); },
     v1::CODE_INVALID_ARGUMENT, "100000"},
    {"trajectory.keyframes.interpolation",
     [](auto& r) { secondKey(r); r.mutable_trajectory()->mutable_keyframes()->set_interpolation(v1::Interpolation(7)); },
     v1::CODE_INVALID_ARGUMENT, "INTERPOLATION_CUBIC"},
    {"trajectory.keyframes.keys[1].time_s", [](auto& r) { secondKey(r).set_time_s(kNan); }},
    {"trajectory.keyframes.keys[1].time_s", [](auto& r) { secondKey(r).set_time_s(2e9); }},
    {"trajectory.keyframes.keys[1].time_s", [](auto& r) { secondKey(r).set_time_s(4e-10); }, v1::CODE_INVALID_ARGUMENT,
     "not later"},
    {"trajectory.keyframes.keys[1].position.x", [](auto& r) { secondKey(r).mutable_position()->set_x(kInf); }},
    {"trajectory.keyframes.keys[1].position.y", [](auto& r) { secondKey(r).mutable_position()->set_y(kNan); }},
    {"trajectory.keyframes.keys[1].position.z", [](auto& r) { secondKey(r).mutable_position()->set_z(-1e10); }},
    {"trajectory.keyframes.keys[1].rotation", [](auto& r) { secondKey(r).clear_rotation(); }},
    {"trajectory.keyframes.keys[1].rotation", [](auto& r) { secondKey(r).mutable_rotation()->set_y(kNan); }},
    {"trajectory.keyframes.keys[1].rotation", [](auto& r) { secondKey(r).mutable_rotation()->set_w(kInf); }},
    {"timing.frame_rate_hz", [](auto& r) { r.mutable_timing()->set_frame_rate_hz(kNan); }},
    {"timing.frame_rate_hz", [](auto& r) { r.mutable_timing()->set_frame_rate_hz(1e9); }},
    {"timing.duration_s", [](auto& r) { r.mutable_timing()->set_duration_s(-1); }},
    {"timing.duration_s", [](auto& r) { r.mutable_timing()->set_duration_s(kInf); }},
    {"timing.duration_s", [](auto& r) { r.mutable_timing()->set_duration_s(1e-4); }, v1::CODE_INVALID_ARGUMENT,
     "0.002"},
    {"timing.clock", [](auto& r) { r.mutable_timing()->set_clock(v1::Clock(77)); },
     v1::CODE_INVALID_ARGUMENT, "CLOCK_PACED"},
    {"timing.speed", [](auto& r) { r.mutable_timing()->set_speed(-1); }},
    {"timing.speed", [](auto& r) { r.mutable_timing()->set_speed(1e-300); }},
    {"method.name", [](auto& r) { r.mutable_method()->set_name("magic"); }, v1::CODE_INVALID_ARGUMENT, "event_svgf"},
    {"method.params[\"beta\"]", [](auto& r) { (*r.mutable_method()->mutable_params())["beta"] = 1; },
     v1::CODE_INVALID_ARGUMENT, "tau"},
    {"method.params[\"tau\"]", [](auto& r) { (*r.mutable_method()->mutable_params())["tau"] = kNan; },
     v1::CODE_INVALID_ARGUMENT, "nan is outside ["},
    {"method.spp", [](auto& r) { r.mutable_method()->set_name("event_svgf"), r.mutable_method()->set_spp(3); },
     v1::CODE_INVALID_ARGUMENT, "even"},
    {"method.spp", [](auto& r) { r.mutable_method()->set_spp(1 << 20); }},
    {"quality.bounces", [](auto& r) { r.mutable_quality()->set_bounces(65); }},
    {"delivery", [](auto& r) { r.set_delivery(v1::Delivery(99)); }, v1::CODE_INVALID_ARGUMENT, "DELIVERY_LIVE"},
    {"sensors", [](auto& r) { r.clear_sensors(); }},
    {"sensors", [](auto& r) { for (int i = 0; i < 64; ++i) r.add_sensors(); }},
    {"sensors[0].threshold", [](auto& r) { r.mutable_sensors(0)->set_threshold(0); }},
    {"sensors[0].threshold", [](auto& r) { r.mutable_sensors(0)->set_threshold(-0.1); }},
    {"sensors[1].threshold", [](auto& r) { r.add_sensors()->set_threshold(kNan); }},
    {"sensors[0].threshold_off", [](auto& r) { r.mutable_sensors(0)->set_threshold_off(kInf); }},
    {"sensors[0].bias", [](auto& r) { r.mutable_sensors(0)->set_bias(0); }},
    {"sensors[0].refractory_s", [](auto& r) { r.mutable_sensors(0)->set_refractory_s(kInf); }},
    {"sensors[0].refractory_s", [](auto& r) { r.mutable_sensors(0)->set_refractory_s(-1); }},
    {"sensors[0].max_events_per_pixel_frame",
     [](auto& r) { r.mutable_sensors(0)->set_max_events_per_pixel_frame(4000000000u); }},
    {"sensors[0].model", [](auto& r) { r.mutable_sensors(0)->set_model(v1::EventModel(9)); },
     v1::CODE_INVALID_ARGUMENT, "EVENT_MODEL_PROBABILISTIC"},
    {"sensors[0].start_level",
     [](auto& r) { r.mutable_sensors(0)->set_start_level(v1::StartLevel(9)); },
     v1::CODE_INVALID_ARGUMENT, "START_LEVEL_ZERO"},
    {"sensors[0].reconstruction",
     [](auto& r) { r.mutable_sensors(0)->set_reconstruction(v1::Reconstruction(9)); },
     v1::CODE_INVALID_ARGUMENT, "RECONSTRUCTION_KALMAN"},
    {"sensors[0].cutoff_hz", [](auto& r) { r.mutable_sensors(0)->set_cutoff_hz(0); }},
};
// clang-format on

TEST(Request, ABadWishIsRefusedWithItsField) {
  TestServer server;
  std::vector<double> took_ms;
  for (const SpoiltRequest& bad : kSpoiltRequests) {
    v1::OpenStream request = tinyRequest();
    bad.spoil(request);
    SCOPED_TRACE(bad.field);
    const auto began = std::chrono::steady_clock::now();
    const v1::Status status = server.client().tryOpen(request);
    const std::chrono::duration<double, std::milli> took = std::chrono::steady_clock::now() - began;
    took_ms.push_back(took.count());
    EXPECT_EQ(status.code(), bad.code) << status.message();
    EXPECT_EQ(status.field(), bad.field) << status.message();
    EXPECT_FALSE(status.message().empty());
    EXPECT_NE(status.message().find(bad.told), std::string::npos) << status.message();
  }
  EXPECT_LT(quantile(took_ms, 0.5), 10);
  checkPackets(server.run(tinyRequest())[0]);  // the server goes on
}

TEST(Request, AnUnreadableRequestIsAnsweredToo) {
  TestServer server;
  EXPECT_EQ(server.client().callRaw("\xff\xff").status().code(), v1::CODE_INVALID_ARGUMENT);
  EXPECT_EQ(server.client().callRaw("").status().field(), "protocol_version");
  EXPECT_EQ(server.client().call({}).status().field(), "call");
  v1::Request request;
  request.set_request_id(9);
  request.set_protocol_version(2);
  request.mutable_server_info();
  const v1::Reply reply = server.client().callRaw(request.SerializeAsString());
  EXPECT_EQ(reply.request_id(), 9u);
  EXPECT_EQ(reply.status().code(), v1::CODE_UNIMPLEMENTED);
  EXPECT_NE(reply.status().message().find("protocol_version is 2"), std::string::npos);
  EXPECT_NE(reply.status().message().find("this server knows 1"), std::string::npos);
  EXPECT_EQ(server.client().server().protocol_version(), 1u);
}

void addUnknownField(google::protobuf::Message& message) {
  constexpr int kOfTheFuture = 10'000;
  message.GetReflection()->MutableUnknownFields(&message)->AddVarint(kOfTheFuture, 1);
}

// Requests of a newer client: more than this server knows, in a version that it does.
TEST(Request, FieldsOfTheFutureArePassedOver) {
  TestServer server;
  v1::Request open;
  *open.mutable_open_stream() = tinyRequest();
  for (google::protobuf::Message* message : std::initializer_list<google::protobuf::Message*>{
           &open, open.mutable_open_stream(), open.mutable_open_stream()->mutable_sensors(0)}) {
    addUnknownField(*message);
  }
  const v1::Reply reply = server.client().call(open);
  ASSERT_EQ(reply.status().code(), v1::CODE_OK) << reply.status().message();
  v1::DataRequest attach;
  attach.mutable_attach()->set_stream_id(reply.open_stream().stream_id());
  attach.mutable_attach()->set_token(reply.open_stream().token());
  addUnknownField(*attach.mutable_attach());
  MockSubscriber subscriber = server.dataSubscriber();
  subscriber.sendRaw(attach.SerializeAsString());
  subscriber.giveCredit(1 << 20);
  checkPackets(subscriber.receiveAll(1)[0]);

  v1::DataRequest unknown;
  addUnknownField(unknown);
  subscriber.sendRaw(unknown.SerializeAsString());
  const auto answer = subscriber.receive();
  ASSERT_TRUE(answer);
  EXPECT_EQ(answer->header.kind(), v1::KIND_ERROR);
  EXPECT_NE(answer->payload.find("this server knows"), std::string::npos) << answer->payload;
}

TEST(Request, TheServersLimitsAreNamed) {
  TestServer server;
  v1::OpenStream request = tinyRequest();
  request.mutable_view()->set_width(2);
  request.mutable_view()->set_height(2);
  for (int i = 0; i < 64; ++i) server.client().open(request);
  const v1::Status status = server.client().tryOpen(request);
  EXPECT_EQ(status.code(), v1::CODE_RESOURCE_EXHAUSTED);
  EXPECT_NE(status.message().find("64"), std::string::npos);
}

TEST(Request, AViewTooLargeForItsManySensorsIsRefused) {
  TestServer server;
  v1::OpenStream request = tinyRequest();
  request.mutable_view()->set_width(2048);
  request.mutable_view()->set_height(2048);
  while (request.sensors_size() < 64) request.add_sensors();
  const v1::Status status = server.client().tryOpen(request);
  EXPECT_EQ(status.code(), v1::CODE_RESOURCE_EXHAUSTED);
  EXPECT_EQ(status.field(), "view");
  EXPECT_NE(status.message().find("4096 MiB"), std::string::npos) << status.message();
}

TEST(Request, ABadWishIsAnsweredWhileOthersAreServed) {
  TestServer server;
  v1::OpenStream request = tinyRequest();
  request.mutable_timing()->set_duration_s(0.2);
  const auto stream = server.client().open(request);
  MockSubscriber subscriber = server.dataSubscriber();
  subscriber.attach(stream);
  subscriber.giveCredit(1 << 20);
  for (const SpoiltRequest& bad : kSpoiltRequests) {
    v1::OpenStream spoilt = tinyRequest();
    bad.spoil(spoilt);
    EXPECT_NE(server.client().tryOpen(spoilt).code(), v1::CODE_OK);
  }
  EXPECT_EQ(checkPackets(subscriber.receiveAll(1)[0]).end_ns, 200'000'000);
}

}  // namespace
}  // namespace saccade
