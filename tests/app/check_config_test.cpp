// saccaded --check-config finds what a start would.
#include <gtest/gtest.h>

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <fstream>

#include "base/instruction_set.h"
#include "client/scratch_folder.h"
#include "mock/mock_keys.h"
#include "mock/server_process.h"

namespace saccade {
namespace {

struct Said {
  int status;
  std::string text;
};

class CheckConfig : public testing::Test {
 protected:
  std::string touch(const std::string& name, const std::string& text = "") const {
    std::ofstream(folder_.at(name)) << text;
    return folder_.at(name);
  }
  // With free ports, where the flags give no others.
  static Said run(std::vector<std::string> flags) {
    for (const std::string socket : {"--control", "--data", "--broadcast"})
      if (std::count(flags.begin(), flags.end(), socket) == 0)
        flags.insert(flags.end(), {socket, "tcp://127.0.0.1:0"});
    if (std::count(flags.begin(), flags.end(), "--http") == 0) flags.insert(flags.end(), {"--http", "off"});
    flags.insert(flags.begin(), SACCADED);
    Process server(flags);
    std::string text;
    for (std::string line = server.lineWith(""); !line.empty(); line = server.lineWith("")) {
      text += line;
      if (line.find("ready: ") != std::string::npos) server.signal(SIGTERM);  // it has started
    }
    return {server.finish(), text};
  }
  static Said check(std::vector<std::string> flags) {
    flags.emplace_back("--check-config");
    return run(flags);
  }
  // The check and the start both refuse the flags, with these words.
  static void expectFault(const std::vector<std::string>& flags, const std::vector<std::string>& words) {
    const Said checked = check(flags), started = run(flags);
    EXPECT_EQ(checked.status, 2) << checked.text;
    EXPECT_NE(started.status, 0) << flags[1] << started.text;
    for (const std::string& word : words) {
      EXPECT_NE(checked.text.find(word), std::string::npos) << word << " is not in: " << checked.text;
      EXPECT_NE(started.text.find(word), std::string::npos) << word << " is not in: " << started.text;
    }
  }
  const ScratchFolder folder_;
};

TEST_F(CheckConfig, WhatCanStartIsValid) {
  const Said said = check({"--http", "http://127.0.0.1:0", "--bakes", folder_.at("new/bakes")});
  EXPECT_EQ(said.status, 0) << said.text;
  EXPECT_EQ(said.text, "the configuration is valid\n");
  EXPECT_FALSE(std::filesystem::exists(folder_.at("new")));
}

TEST_F(CheckConfig, APortMustBeFree) {
  ServerProcess other({"--http", "http://127.0.0.1:0"});
  for (const std::string socket : {"--control", "--data", "--broadcast"})
    expectFault({socket, other.control()}, {other.control() + ": Address already in use"});
  expectFault({"--http", other.http()}, {other.http() + ": Address already in use"});
}

TEST_F(CheckConfig, TwoSocketsNeedTwoAddresses) {
  const std::string address = "tcp://127.0.0.1:5770";
  expectFault({"--control", address, "--data", address}, {"--data: " + address, "--control, too"});
  expectFault({"--data", "ipc://a.sock", "--broadcast", "ipc://a.sock"}, {"--broadcast: ", "--data, too"});
}

TEST_F(CheckConfig, AnAddressMustBeOfItsKind) {
  for (const std::string wrong : {"http://127.0.0.1:5770", "pgm://eth0:5", "5770"})
    expectFault({"--control", wrong}, {"--control: '" + wrong + "' is not an endpoint such as tcp://"});
  expectFault({"--control", "tcp://127.0.0.1:99999"}, {"tcp://127.0.0.1:99999"});
  expectFault({"--http", "5773"}, {"--http: '5773' is neither off nor an address"});
}

// ZeroMQ removes the file of an ipc address before it listens there.
TEST_F(CheckConfig, AnIpcAddressTakesNoFileOfOthers) {
  const std::string file = touch("thesis", "kept"), socket = "ipc://" + folder_.at("socket");
  expectFault({"--control", "ipc://" + file}, {file + " is a file and not a socket"});
  EXPECT_EQ(std::filesystem::file_size(file), 4u);
  ServerProcess other({"--control", socket});
  expectFault({"--control", socket}, {socket + ": another server listens there"});
  EXPECT_EQ(MockClient(other.control()).server().threads(), 1u);
}

TEST_F(CheckConfig, FoldersMustBeFolders) {
  const std::string file = touch("file"), none = folder_.at("none");
  for (const std::string option : {"--scenes", "--meshes"}) {
    expectFault({option, none}, {option + ": ", none});
    expectFault({option, file}, {option + ": ", file});
  }
  expectFault({"--bakes", file}, {"--bakes: '" + file + "' is not a folder"});
  expectFault({"--bakes", file + "/bakes"}, {"--bakes: '" + file + "' is not a folder"});
}

TEST_F(CheckConfig, KeysMustBeOfTheRightKind) {
  const MockKeys keys = makeMockKeys();
  const std::string secret = touch("a.key", keys.secret), list = touch("a.pub", keys.public_key);
  EXPECT_EQ(check({"--secret-key", secret, "--client-keys", list}).status, 0);
  expectFault({"--secret-key", list, "--client-keys", list},
              {"--secret-key: ", "is a public key by its name"});
  expectFault({"--secret-key", secret, "--client-keys", secret}, {"--client-keys: ", "is a secret key"});
  expectFault({"--secret-key", secret, "--client-keys", folder_.at("")},
              {"--client-keys: ", "cannot be read"});
  expectFault({"--secret-key", touch("b.key", "short"), "--client-keys", list}, {"--secret-key: ", "b.key"});
}

TEST_F(CheckConfig, TablesMustParse) {
  for (const std::string option : {"--accuracy", "--simplification"})
    expectFault({option, touch("table.csv", "nonsense\n")}, {folder_.at("table.csv") + ":1: "});
}

TEST_F(CheckConfig, TheProcessorMustHaveTheInstructions) {
  if (widestInstructionSet() == InstructionSet::kAvx512) GTEST_SKIP() << "this one has all";
  expectFault({"--instructions", "avx512"}, {"--instructions: this processor has no avx512"});
}

}  // namespace
}  // namespace saccade
