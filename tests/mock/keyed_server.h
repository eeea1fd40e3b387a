// The begin of a test of a server with keys: its configuration, and two clients on its list.
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "mock/test_server.h"

namespace saccade {

class KeyedServer : public testing::Test {
 protected:
  KeyedServer() {
    std::filesystem::create_directories(folder_);
    std::ofstream(config_.secret_key = folder_ + "/server.key") << server_.secret << "\n";
    config_.client_keys = folder_ + "/clients";
    allow({alice_, bob_});
  }
  ~KeyedServer() override { std::filesystem::remove_all(folder_); }

  void allow(const std::vector<MockKeys>& clients) const {
    std::ofstream list(config_.client_keys);
    for (const auto& client : clients) list << client.public_key << "\n";
  }
  std::vector<std::string> seen(MockClient& client) const {
    std::vector<std::string> ids;
    const v1::StreamList list = client.streams();
    for (const auto& stream : list.streams()) ids.push_back(stream.stream_id());
    return ids;
  }

  const MockKeys server_ = makeMockKeys();
  const MockKeys alice_ = makeMockKeys(server_.public_key), bob_ = makeMockKeys(server_.public_key);
  const std::string folder_ = testing::TempDir() + "keyed_server_" + std::to_string(getpid());
  Config config_ = testConfig();
};

}  // namespace saccade
