// Streams whose light the server computes ahead.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <thread>

#include "mock/bad_request.h"

namespace saccade {
namespace {

v1::OpenStream baked(double error = 0.3) {
  v1::OpenStream request = tinyRequest();
  request.mutable_method()->set_name("irradiance_cache");
  request.mutable_method()->set_spp(1);
  request.mutable_quality()->set_bake_error(error);
  return request;
}

struct BakedStreams : testing::Test {
  BakedStreams() { std::filesystem::remove_all(folder); }
  Config config(int threads = 1) const {
    Config config = testConfig();
    config.threads = threads;
    config.bakes = folder;
    return config;
  }
  static std::string bytesOf(TestServer& server, const v1::OpenStream& request) {
    std::string bytes;
    for (const auto& [sensor, of_sensor] : server.run(request)) bytes += comparableBytes(of_sensor);
    return bytes;
  }
  std::ptrdiff_t files() const { return std::distance(std::filesystem::directory_iterator(folder), {}); }

  const std::string folder =
      testing::TempDir() + "saccade-" + testing::UnitTest::GetInstance()->current_test_info()->name();
};

TEST_F(BakedStreams, TheReplySaysWhichBakeItIs) {
  TestServer server(config());
  const v1::StreamOpened opened = server.client().open(baked());
  EXPECT_NE(opened.bake_digest(), 0u);
  EXPECT_EQ(opened.resolved().quality().bake_error(), 0.3);
  EXPECT_EQ(files(), 1);
  EXPECT_EQ(server.client().open(baked()).bake_digest(), opened.bake_digest());
  EXPECT_EQ(files(), 1);
  EXPECT_NE(server.client().open(baked(0.2)).bake_digest(), opened.bake_digest());
  EXPECT_EQ(files(), 2);
  v1::OpenStream without = baked();
  without.mutable_quality()->clear_bake_error();
  EXPECT_EQ(server.client().open(without).bake_digest(), 0u);
}

TEST_F(BakedStreams, GiveTheSameBytesWhoeverMadeTheBake) {
  std::string bytes;
  {
    TestServer one(config(1));
    bytes = bytesOf(one, baked());
    EXPECT_EQ(bytes, bytesOf(one, baked()));
  }
  TestServer other(config(3));  // takes it from the file
  EXPECT_EQ(bytes, bytesOf(other, baked()));
  std::filesystem::remove_all(folder);
  TestServer maker(config(3));
  EXPECT_EQ(bytes, bytesOf(maker, baked()));
  v1::OpenStream without = baked();
  without.mutable_quality()->clear_bake_error();
  EXPECT_NE(bytes, bytesOf(maker, without));
}

TEST_F(BakedStreams, RefusesWhatCannotBe) {
  TestServer server(config());
  const auto nothing = [](v1::OpenStream&) {};
  expectRefused(server, {{baked(0), nothing, v1::CODE_INVALID_ARGUMENT, "quality.bake_error", "outside"},
                         {baked(), [](v1::OpenStream& r) { r.mutable_method()->set_name("svgf"); },
                          v1::CODE_INVALID_ARGUMENT, "quality.bake_error", "svgf has no use"}});
  TestServer keeps_none(testConfig());
  expectRefused(keeps_none,
                {{baked(), nothing, v1::CODE_UNAVAILABLE, "quality.bake_error", "keeps no bakes"}});
}

TEST_F(BakedStreams, KeepToTheirMemory) {
  Config small = config();
  small.limits[Limit::kBakes] = 512;
  TestServer server(small);
  const v1::StreamOpened opened = server.client().open(baked());
  EXPECT_EQ(server.client().tryOpen(baked()).code(), v1::CODE_OK);  // shares it
  const v1::Status status = server.client().tryOpen(baked(0.2));
  EXPECT_EQ(status.code(), v1::CODE_RESOURCE_EXHAUSTED);
  EXPECT_EQ(status.limit(), "bakes");
}

TEST_F(BakedStreams, OldFilesGoWhereOthersNeedTheirPlace) {
  Config small = config();
  small.limits[Limit::kBakeFiles] = 512;  // what one may need
  TestServer server(small);
  server.client().open(baked());
  EXPECT_EQ(files(), 1);
  server.client().open(baked(0.2));
  EXPECT_EQ(files(), 1);
}

TEST_F(BakedStreams, ADamagedFileIsMadeAnew) {
  std::uint64_t digest = 0;
  {
    TestServer server(config());
    digest = server.client().open(baked()).bake_digest();
  }
  const auto file = *std::filesystem::directory_iterator(folder);
  std::filesystem::resize_file(file.path(), 100);
  TestServer server(config());
  EXPECT_EQ(server.client().open(baked()).bake_digest(), digest);
  EXPECT_EQ(files(), 2);  // the damaged one stays for the operator, who is told
}

TEST_F(BakedStreams, WhatAKilledServerHasLeftIsRemoved) {
  std::filesystem::create_directories(folder);
  std::ofstream(folder + "/0123456789abcdef.bake.aBcDeF") << "half";
  TestServer server(config());
  server.client().open(baked());
  EXPECT_EQ(files(), 1);
}

// The reason is the operator's; clients are not told the folder.
TEST_F(BakedStreams, AFolderThatCannotBeWrittenIsARefusal) {
  std::ofstream{folder} << "no folder";
  TestServer server(config());
  const v1::Status status = server.client().tryOpen(baked());
  EXPECT_EQ(status.code(), v1::CODE_UNAVAILABLE);
  EXPECT_EQ(status.field(), "quality.bake_error");
  EXPECT_EQ(status.message().find(folder), std::string::npos);
}

}  // namespace
}  // namespace saccade
