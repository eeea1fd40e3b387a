// The program's report on its machine before it serves.
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "mock/mock_keys.h"
#include "mock/process.h"

namespace saccade {
namespace {

// libzmq ended the program where it could open no more.
TEST(Start, NeedsSomeFiles) {
  Process server({"/bin/sh", "-c", "ulimit -n 24 && exec \"$@\"", "sh", SACCADED, "--http", "off"});
  EXPECT_NE(server.lineWith("saccaded may open 24 files, and needs 64"), "");
  EXPECT_EQ(server.finish(), 1);
}

TEST(Start, WarnsAboutASecretKeyThatAllMayRead) {
  namespace fs = std::filesystem;
  const fs::path folder = testing::TempDir() + "open_key_" + std::to_string(getpid());
  const MockKeys keys = makeMockKeys();
  fs::create_directories(folder);
  const std::string key = folder / "server.key", clients = folder / "clients";
  std::ofstream(key) << keys.secret << "\n";
  std::ofstream(clients) << keys.public_key << "\n";
  fs::permissions(key, fs::perms(0644));
  Process server({SACCADED, "--control", "tcp://127.0.0.1:*", "--data", "tcp://127.0.0.1:*", "--broadcast",
                  "tcp://127.0.0.1:*", "--http", "off", "--secret-key", key, "--client-keys", clients});
  EXPECT_NE(server.lineWith("every user of this machine can read the secret key " + key), "");
  EXPECT_NE(server.lineWith("ready"), "");
  fs::remove_all(folder);
}

}  // namespace
}  // namespace saccade
