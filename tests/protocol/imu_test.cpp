// The truth channel imu of a stream.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstring>

#include "mock/bad_request.h"
#include "mock/events_of.h"

namespace saccade {
namespace {

v1::OpenStream withImu() {
  v1::OpenStream request = tinyRequest();
  request.add_truth()->set_name("imu");
  return request;
}

TruthSamples rowsOf(TestServer& server, const v1::OpenStream& request) {
  return samplesOf(server.run(request)[1]);
}

std::array<double, 6> numbersOf(const TruthSample& row) {
  std::array<double, 6> numbers{};
  EXPECT_EQ(row.elements.size(), sizeof numbers);
  std::memcpy(numbers.data(), row.elements.data(), sizeof numbers);
  return numbers;
}

// The camera of the Cornell box is upright: its y is down.
TEST(ImuStream, ACameraThatStandsMeasuresGravity) {
  TestServer server;
  v1::OpenStream request = withImu();
  request.mutable_trajectory()->set_name("still");
  const TruthSamples rows = rowsOf(server, request);
  ASSERT_EQ(rows.size(), 8u);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    EXPECT_EQ(rows[i].t_ns, 5'000'000 * static_cast<std::int64_t>(i + 1));
    const auto numbers = numbersOf(rows[i]);
    const std::array expected{0.0, -9.81, 0.0, 0.0, 0.0, 0.0};
    for (std::size_t k = 0; k < expected.size(); ++k) EXPECT_NEAR(numbers[k], expected[k], 1e-6);
  }
}

TEST(ImuStream, TheSeedAndTheChannelChangeTheNoise) {
  TestServer one(1), two(2);
  v1::OpenStream request = withImu();
  request.mutable_truth(0)->mutable_imu()->set_rate_hz(300);
  request.mutable_truth(0)->mutable_imu()->set_gyroscope_noise(0.1);
  const TruthSamples rows = rowsOf(one, request);
  ASSERT_EQ(rows.size(), 12u);
  EXPECT_EQ(rows[0].t_ns, 3'333'000);
  EXPECT_EQ(rowsOf(two, request), rows);
  request.mutable_truth(0)->mutable_imu()->set_seed(1);
  EXPECT_NE(rowsOf(one, request), rows);
}

TEST(ImuStream, FillsInTheDefaults) {
  TestServer server;
  const v1::Imu imu = server.client().open(withImu()).resolved().truth(0).imu();
  EXPECT_EQ(imu.rate_hz(), 200);
  EXPECT_EQ(imu.metres_per_unit(), 1);
  EXPECT_EQ(imu.gravity().y(), -9.81);
  EXPECT_TRUE(imu.has_seed());
}

TEST(ImuStream, IsRefusedByField) {
  TestServer server;
  using Open = v1::OpenStream;
  constexpr auto kInvalid = v1::CODE_INVALID_ARGUMENT;
  const Open good = withImu();
  const auto imu = [](Open& r) { return r.mutable_truth(0)->mutable_imu(); };
  expectRefused(
      server,
      {{good, [&](Open& r) { imu(r)->set_rate_hz(2e4); }, kInvalid, "truth[0].imu.rate_hz", "20000"},
       {good, [&](Open& r) { imu(r)->set_rate_hz(std::nan("")); }, kInvalid, "truth[0].imu.rate_hz", "nan"},
       {good, [&](Open& r) { imu(r)->set_metres_per_unit(0); }, kInvalid, "truth[0].imu.metres_per_unit",
        "0"},
       {good, [&](Open& r) { imu(r)->mutable_gravity()->set_z(2000); }, kInvalid, "truth[0].imu.gravity.z",
        "2000"},
       {good, [&](Open& r) { imu(r)->set_accelerometer_noise(-1); }, kInvalid,
        "truth[0].imu.accelerometer_noise", "-1"},
       {good, [&](Open& r) { imu(r)->set_gyroscope_noise(-1); }, kInvalid, "truth[0].imu.gyroscope_noise",
        "-1"},
       {good, [&](Open& r) { imu(r)->set_accelerometer_walk(-1); }, kInvalid,
        "truth[0].imu.accelerometer_walk", "-1"},
       {good, [&](Open& r) { imu(r)->set_gyroscope_walk(-1); }, kInvalid, "truth[0].imu.gyroscope_walk",
        "-1"},
       {good,
        [&](Open& r) {
          imu(r);
          r.mutable_truth(0)->set_name("pose");
        },
        kInvalid, "truth[0].imu", "only"}});
}

}  // namespace
}  // namespace saccade
