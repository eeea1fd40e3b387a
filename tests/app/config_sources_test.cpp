#include "app/config/config_sources.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <stdexcept>

namespace saccade {
namespace {

class Sources : public testing::Test {
 protected:
  Sources() {
    app_.add_option("--data", data_)->capture_default_str();
    app_.add_option("--log-level", level_)->check(CLI::IsMember({"info", "debug"}))->capture_default_str();
    app_.add_option("--threads", threads_)->check(CLI::Range(0, 8))->capture_default_str();
    app_.add_flag("--insecure", insecure_);
    app_.add_option("--accuracy", accuracy_)->check(CLI::ExistingFile)->capture_default_str();
  }
  ~Sources() override {
    for (const char* name : {"SACCADE_DATA", "SACCADE_LOG_LEVEL", "SACCADE_THREADS", "SACCADE_INSECURE"}) {
      unsetenv(name);
    }
  }

  ConfigSources apply(const std::string& flags = {}, const std::string& file_text = {}) {
    std::ofstream(file_) << file_text;
    app_.parse(flags);
    return ConfigSources(app_, file_);
  }
  // Messages about the faulty file or environment.
  std::string fault(const std::string& file_text) {
    try {
      apply({}, file_text);
    } catch (const std::runtime_error& fault) {
      return fault.what();
    }
    return {};
  }

  CLI::App app_;
  const std::string file_ =
      testing::TempDir() + testing::UnitTest::GetInstance()->current_test_info()->name() + ".toml";
  std::string data_ = "a", level_ = "info", accuracy_;
  int threads_ = 0;
  bool insecure_ = false;
};

TEST_F(Sources, AFlagBeatsTheEnvironmentBeatsTheFileBeatsTheDefault) {
  setenv("SACCADE_THREADS", "2", 1);
  setenv("SACCADE_LOG_LEVEL", "debug", 1);
  const auto sources = apply("--threads 1", "threads = 3\nlog-level = \"info\"\ninsecure = true\n");
  EXPECT_EQ(threads_, 1);
  EXPECT_EQ(level_, "debug");
  EXPECT_TRUE(insecure_);
  EXPECT_EQ(data_, "a");
  EXPECT_EQ(sources.describe(),
            "data = \"a\"  # default\n"
            "log-level = \"debug\"  # SACCADE_LOG_LEVEL\n"
            "threads = 1  # flag\n"
            "insecure = true  # " +
                file_ + ":3\n# accuracy = \"\"  # default\n");
}

TEST_F(Sources, AnEmptyVariableSaysNothing) {
  setenv("SACCADE_DATA", "", 1);
  apply({}, "data = \"b\"\n");
  EXPECT_EQ(data_, "b");
}

TEST_F(Sources, AFlagMayBeFalseInTheFile) {
  EXPECT_EQ(apply({}, "insecure = false\n").describe().find("insecure = true"), std::string::npos);
  EXPECT_FALSE(insecure_);
}

TEST_F(Sources, TheDescriptionIsAFileWithTheSameConfiguration) {
  const std::string text = apply("--data 'tcp://[::1]:7 # \"x\"' --threads 4 --insecure").describe();
  const std::string data = data_;
  data_ = "a", threads_ = 0, insecure_ = false;
  apply({}, text);
  EXPECT_EQ(data_, data);
  EXPECT_EQ(threads_, 4);
  EXPECT_TRUE(insecure_);
}

TEST_F(Sources, ALineEndStaysInTheDescription) {
  setenv("SACCADE_DATA", "\nb\n", 1);
  const std::string text = apply().describe();
  unsetenv("SACCADE_DATA");
  apply({}, text);
  EXPECT_EQ(data_, "\nb\n") << text;
}

TEST_F(Sources, AnUnknownKeyIsAnErrorThatNamesTheNearest) {
  EXPECT_EQ(fault("data = \"b\"\nthread = 2\n"), file_ + ":2: there is no 'thread'; did you mean 'threads'?");
  EXPECT_EQ(fault("help = true\n").find(file_ + ":1: there is no 'help'"), 0);
}

TEST_F(Sources, AFaultNamesItsPlace) {
  EXPECT_EQ(fault("\nthreads = 9\n").find(file_ + ":2: --threads: "), 0);
  EXPECT_EQ(fault("data = \"b\"\nthreads = \n").find(file_ + ":2: "), 0);
  EXPECT_EQ(fault("data = [1]\n").find(file_ + ":1: 'data' must be"), 0);
  EXPECT_EQ(fault("data = \"b\"\ndata = \"c\"\n").find(file_ + ":2: "), 0);
  setenv("SACCADE_LOG_LEVEL", "loud", 1);
  EXPECT_EQ(fault("").find("SACCADE_LOG_LEVEL: --log-level: "), 0) << fault("");
}

TEST_F(Sources, ATextWithoutQuotesIsToldToWantThem) {
  for (const char* value : {"tcp://127.0.0.1:1", "debug", "info", "/usr/share", "127.0.0.1:1"}) {
    EXPECT_NE(fault(std::string("data = ") + value + "\n").find("strings need quotes"), std::string::npos)
        << value;
  }
  for (const char* line : {"data = \"a", "data = ", "data = \"b\"\ndata = \"c\""}) {
    EXPECT_EQ(fault(std::string(line) + "\n").find("strings need quotes"), std::string::npos) << line;
  }
}

TEST_F(Sources, AMisspeltVariableIsWarnedAbout) {
  setenv("SACCADE_THREAD", "2", 1);
  constexpr const char* kOfOthers[] = {"SACCADE_CLIENT_KEY", "SACCADE_FULL", "SACCADE_OUT"};
  for (const char* name : kOfOthers) setenv(name, "1", 1);
  const auto warnings = apply().warnings();
  unsetenv("SACCADE_THREAD");
  for (const char* name : kOfOthers) unsetenv(name);
  const std::string warning = "no option is set by SACCADE_THREAD; did you mean SACCADE_THREADS?";
  EXPECT_EQ(std::count(warnings.begin(), warnings.end(), warning), 1);
  for (const std::string& other : warnings)
    for (const char* name : kOfOthers)
      EXPECT_EQ(other.find("by " + std::string(name) + ";"), std::string::npos) << other;
}

TEST_F(Sources, AFileThatIsNotThereIsAnError) {
  app_.parse("");
  EXPECT_THROW(ConfigSources(app_, file_ + ".none"), std::runtime_error);
}

}  // namespace
}  // namespace saccade
