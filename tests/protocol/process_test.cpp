// The program itself: its flags, its `ready` line, its end.
#include <gtest/gtest.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>

#include "log/log.h"
#include "mock/accuracy_file.h"
#include "mock/mock_service_manager.h"
#include "mock/needs_libzmq.h"
#include "mock/process.h"
#include "mock/remote_subscriber.h"
#include "mock/test_server.h"
#include "mock/wait_until.h"

namespace saccade {
namespace {

const std::vector<std::string> kServer{SACCADED,
                                       "--control",
                                       "tcp://127.0.0.1:0",
                                       "--data",
                                       "tcp://127.0.0.1:*",
                                       "--broadcast",
                                       "tcp://127.0.0.1:*",
                                       "--http",
                                       "off",
                                       "--threads",
                                       "1"};

std::string controlEndpoint(const std::string& ready_line) {
  const auto from = ready_line.find("tcp://");
  return ready_line.substr(from, ready_line.find(' ', from) - from);
}

TEST(Process, EndsItsStreamsOnSigterm) {
  Process server(kServer);
  MockClient client(controlEndpoint(server.lineWith("ready")));
  v1::OpenStream request = tinyRequest();
  request.mutable_timing()->set_duration_s(0);
  const auto stream = client.open(request);
  client.open(request);  // nobody will ever attach to this one
  MockSubscriber subscriber(client.server().data_endpoint());
  subscriber.attach(stream);
  subscriber.giveCredit(1 << 20);
  const auto first = subscriber.receive();
  ASSERT_TRUE(first);
  server.signal(SIGTERM);
  auto packets = subscriber.receiveAll(1)[0];
  packets.insert(packets.begin(), *first);
  checkPackets(packets);
  EXPECT_EQ(server.finish(), 0);
}

// A full pipe must hold up the log alone.
TEST(Process, GoesOnWhenNobodyReadsItsLog) {
  std::vector<std::string> command = kServer;
  command.insert(command.end(), {"--log-level", "debug"});  // a line for each frame
  Process server(command);
  MockClient client(controlEndpoint(server.lineWith("ready")));
  v1::OpenStream request = tinyRequest();
  request.mutable_view()->set_width(1);
  request.mutable_view()->set_height(1);
  request.mutable_timing()->set_duration_s(4);
  const auto stream = client.open(request);
  MockSubscriber subscriber(client.server().data_endpoint());
  subscriber.attach(stream);
  subscriber.giveCredit(1 << 20);
  const auto packets = subscriber.receiveAll(1)[0];
  EXPECT_EQ(packets.back().header.frame(), 2000u);  // 100 bytes each: more than a pipe holds
  client.close(stream);
  server.signal(SIGTERM);
  EXPECT_NE(server.lineWith("frame 1999"), "");
  EXPECT_EQ(server.finish(), 0);
}

TEST(Process, EndsInTimeThoughNobodyReadsItsLog) {
  std::vector<std::string> command = kServer;
  command.insert(command.end(), {"--log-level", "debug"});
  Process server(command, 4096);
  MockClient client(controlEndpoint(server.lineWith("ready")));
  v1::OpenStream request = tinyRequest();
  request.mutable_timing()->set_duration_s(0.4);  // 200 frames, a line each
  const auto stream = client.open(request);
  MockSubscriber subscriber(client.server().data_endpoint());
  subscriber.attach(stream);
  subscriber.giveCredit(1 << 20);
  subscriber.receiveAll(1);
  client.close(stream);
  server.signal(SIGTERM);
  ASSERT_TRUE(waitUntil([&] { return !server.running(); }, kLogTimeout + std::chrono::seconds(4)));
  EXPECT_EQ(server.finish(), 0);
}

TEST(Process, GoesOnWhenTheReaderOfItsLogHasGone) {
  Process server(kServer);
  MockClient client(controlEndpoint(server.lineWith("ready")));
  server.closeOutput();
  for (int i = 0; i < 3; ++i) client.close(client.open(tinyRequest()));  // each writes lines
  server.signal(SIGTERM);
  EXPECT_EQ(server.finish(), 0);
}

TEST(Process, GoesOnWhenAClientIsKilledOrStandsStill) {
  RemoteSubscriber killed, stopped;
  Process server(kServer);
  const std::string ready = server.lineWith("ready");
  EXPECT_EQ(ready.find("::ffff:"), std::string::npos) << ready;
  MockClient client(controlEndpoint(ready));
  const std::string data = client.server().data_endpoint();
  v1::OpenStream request = tinyRequest();
  request.mutable_timing()->set_duration_s(0);
  killed.attach(data, client.open(request), 1 << 20);
  request.set_delivery(v1::DELIVERY_LIVE);
  stopped.attach(data, client.open(request), 1 << 20);
  killed.signal(SIGKILL);
  stopped.signal(SIGSTOP);

  const auto stream = client.open(tinyRequest());
  MockSubscriber subscriber(data);
  subscriber.attach(stream);
  subscriber.giveCredit(1 << 20);
  checkPackets(subscriber.receiveAll(1)[0]);
  server.signal(SIGTERM);
  EXPECT_EQ(server.finish(), 0);
}

// saccaded with a cache folder of its own, where the default table of accuracy is looked for.
class ProcessAndCache : public testing::Test {
 protected:
  ProcessAndCache() { setenv("XDG_CACHE_HOME", cache_.c_str(), 1); }
  ~ProcessAndCache() override { std::filesystem::remove_all(cache_); }
  const std::string cache_ = testing::TempDir() + "process_test_" + std::to_string(getpid());
  const std::string default_folder_ = cache_ + "/saccade/chart";
};

TEST_F(ProcessAndCache, SaysWhetherItHasBudgets) {
  EXPECT_NE(Process(kServer).lineWith("budgets").find("saccade-eval chart --quick"), std::string::npos);
  const AccuracyFile by_default(default_folder_), named(cache_ + "/named");
  EXPECT_NE(Process(kServer).lineWith("budgets").find(by_default.path()), std::string::npos);
  auto command = kServer;
  command.insert(command.end(), {"--accuracy", named.path()});
  EXPECT_NE(Process(command).lineWith("budgets").find(named.path()), std::string::npos);
}

TEST_F(ProcessAndCache, AFaultyTableEndsItOnlyWhereItWasAskedFor) {
  const AccuracyFile by_default(default_folder_), named(cache_ + "/named");
  for (const AccuracyFile* file : {&by_default, &named}) std::ofstream(file->path()) << "nonsense\n";
  Process warned(kServer);
  EXPECT_NE(warned.lineWith("warn").find(by_default.path() + ":1: "), std::string::npos);
  EXPECT_NE(warned.lineWith("ready"), "");
  auto command = kServer;
  command.insert(command.end(), {"--accuracy", named.path()});
  Process refused(command);
  EXPECT_NE(refused.lineWith("critical").find(named.path() + ":1: "), std::string::npos);
  EXPECT_EQ(refused.finish(), 1);
}

// As systemd sees a service of Type=notify with a watchdog.
TEST(Process, TellsTheServiceManagerHowItIs) {
  const MockServiceManager manager;
  Process server(kServer);
  EXPECT_EQ(manager.next(), "READY=1");
  EXPECT_EQ(manager.next(), "WATCHDOG=1");
  EXPECT_EQ(manager.next(), "WATCHDOG=1");
  server.signal(SIGTERM);
  std::string last = manager.next();
  while (last == "WATCHDOG=1") last = manager.next();
  EXPECT_EQ(last, "STOPPING=1");
  EXPECT_EQ(server.finish(), 0);
}

TEST(Process, ReadsItsKeysAgainOnSighup) {
  const std::string secret = testing::TempDir() + "process_test.key",
                    list = testing::TempDir() + "process_test.keys";
  const MockKeys own = makeMockKeys(), client = makeMockKeys(own.public_key);
  std::ofstream(secret) << own.secret;
  std::ofstream(list) << "# nobody yet\n";
  auto command = kServer;
  command.insert(command.end(), {"--secret-key", secret, "--client-keys", list});
  Process server(command);
  const std::string endpoint = controlEndpoint(server.lineWith("ready"));
  EXPECT_EQ(handshake(endpoint, client), ZMQ_EVENT_HANDSHAKE_FAILED_AUTH);
  const std::string refused = server.lineWith("refused a connection");  // and not that of the server's probe
  EXPECT_NE(refused.find("from 127.0.0.1: its key " + client.public_key + " is not on the list"),
            std::string::npos)
      << refused;
  std::ofstream(list) << client.public_key << " alice\n";
  server.signal(SIGHUP);
  EXPECT_NE(server.lineWith("1 clients may connect"), "");
  MockClient alice(endpoint, client);
  EXPECT_EQ(alice.server().threads(), 1u);
  v1::OpenStream wrong = tinyRequest();
  wrong.set_scene("nowhere");
  alice.tryOpen(wrong);
  EXPECT_NE(server.lineWith("client alice: refused: scene: no scene is named 'nowhere'"), "");
  server.signal(SIGTERM);
  EXPECT_EQ(server.finish(), 0);
}

// 300 requests that are refused cause 50 lines at once, and then five a second.
TEST(Process, AClientDoesNotFillTheLog) {
  auto command = kServer;
  command.insert(command.end(), {"--log-format", "json"});
  Process server(command);
  MockClient client(controlEndpoint(server.lineWith("ready")));
  v1::OpenStream wrong = tinyRequest();
  wrong.set_scene("no such scene");
  const auto begin = std::chrono::steady_clock::now();
  for (int i = 0; i < 300; ++i) EXPECT_EQ(client.tryOpen(wrong).code(), v1::CODE_NOT_FOUND);
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
  server.signal(SIGTERM);
  const std::string rest = server.rest();
  int lines = 0;
  for (auto at = rest.find("no such scene"); at != std::string::npos; at = rest.find("no such scene", at + 1))
    ++lines;
  EXPECT_GE(lines, 50);
  EXPECT_LE(lines, 52 + 5 * took.count());
  EXPECT_EQ(rest.find("{\"time\":\""), 0u);
}

TEST(Process, AnOpenAddressWithoutKeysIsRefusedAndSaysWhy) {
  NEEDS_PATCHED_LIBZMQ();
  Process server({SACCADED, "--check-config", "--control", "tcp://0.0.0.0:0"});
  EXPECT_NE(server.lineWith("--control").find("--insecure"), std::string::npos);
  EXPECT_EQ(server.finish(), 2);
}

TEST(Process, RefusesWhatItCannotDo) {
  auto command = kServer;
  command.back() = "-1";
  EXPECT_EQ(Process(command).finish(), 2);
  command = kServer;
  command[2] = "nonsense";
  EXPECT_EQ(Process(command).finish(), 2);
  command[2] = "ipc:///no/such/folder/socket";
  EXPECT_EQ(Process(command).finish(), 1);
  EXPECT_EQ(Process({SACCADED, "--help"}).finish(), 0);
}

}  // namespace
}  // namespace saccade
