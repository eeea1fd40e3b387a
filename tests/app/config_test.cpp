// Messages of saccaded about its configuration, and its exit status.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>

#include "mock/process.h"

namespace saccade {
namespace {

struct Said {
  int status;
  std::string text;
};

Said ask(std::vector<std::string> flags) {
  flags.insert(flags.begin(), SACCADED);
  Process server(flags);
  const std::string text = server.rest();
  return {server.finish(), text};
}

// On free ports: others may have the usual ones.
Said check(std::vector<std::string> flags) {
  for (const std::string socket : {"--control", "--data", "--broadcast"})
    if (std::count(flags.begin(), flags.end(), socket) == 0)
      flags.insert(flags.end(), {socket, "tcp://127.0.0.1:0"});
  flags.insert(flags.end(), {"--http", "off", "--check-config"});
  return ask(flags);
}

TEST(Config, TheExampleIsValidAndSetsWhatItSays) {
  const std::string example = SACCADE_SOURCE_DIR "/deploy/saccaded.toml";
  const Said checked = check({"--config", example});
  EXPECT_EQ(checked.status, 0) << checked.text;
  const Said printed = ask({"--print-config", "--config", example});
  EXPECT_NE(printed.text.find("control = \"tcp://127.0.0.1:5770\"  # " + example), std::string::npos)
      << printed.text;
}

TEST(Config, TheFileMayBeNamedInTheEnvironment) {
  const std::string file = testing::TempDir() + "config_test.toml";
  std::ofstream(file) << "threads = 3\n";
  setenv("SACCADE_CONFIG", file.c_str(), 1);
  EXPECT_NE(ask({"--print-config"}).text.find("threads = 3  # " + file + ":1\n"), std::string::npos);
  unsetenv("SACCADE_CONFIG");
}

TEST(Config, AFaultEndsItNamingThePlace) {
  setenv("SACCADE_THREADS", "many", 1);
  const Said said = check({});
  unsetenv("SACCADE_THREADS");
  EXPECT_EQ(said.status, 2);
  EXPECT_EQ(said.text.find("saccaded: SACCADE_THREADS: "), 0) << said.text;
}

TEST(Config, APortAloneIsNoEndpoint) {
  const Said said = check({"--control", "6140"});
  EXPECT_EQ(said.status, 2);
  EXPECT_NE(said.text.find("--control: '6140' is not an endpoint such as tcp://127.0.0.1:5770"),
            std::string::npos)
      << said.text;
  EXPECT_EQ(check({"--control", "ipc://config_test.sock"}).status, 0);
}

TEST(Config, AMisspeltVariableIsWarnedAbout) {
  setenv("SACCADE_THREAD", "2", 1);
  const Said said = check({});
  unsetenv("SACCADE_THREAD");
  EXPECT_EQ(said.status, 0);
  EXPECT_NE(said.text.find("SACCADE_THREAD; did you mean SACCADE_THREADS?"), std::string::npos) << said.text;
}

// --insecure opens a server to all: a slip of the hand must not set it.
TEST(Config, AFlagIsTrueOrFalse) {
  for (const char* value : {"10", "1", "yes", "tru"}) {
    const Said said = check({std::string("--insecure=") + value});
    EXPECT_NE(said.status, 0) << value;
    EXPECT_NE(said.text.find("not in {true,false}"), std::string::npos) << said.text;
  }
  EXPECT_NE(ask({"--print-config", "--insecure"}).text.find("insecure = true"), std::string::npos);
}

}  // namespace
}  // namespace saccade
