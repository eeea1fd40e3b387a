// The `saccade` command, run as a user runs it: alone, and with a server.
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <thread>

#include "mock/accuracy_file.h"
#include "scratch_folder.h"

namespace saccade {
namespace {

namespace fs = std::filesystem;

// A program that is running, its stdout and stderr in one pipe.
class Child {
 public:
  explicit Child(const std::string& command)
      : pipe_(popen(("echo $$; exec " + command + " 2>&1").c_str(), "r")) {
    pid_ = std::stoi(readLine());
  }
  void signal(int number) const { kill(pid_, number); }
  // Empty at the end.
  std::string readLine() {
    char buffer[4096];
    return std::fgets(buffer, sizeof(buffer), pipe_) ? buffer : "";
  }
  std::string readAll() {
    std::string all;
    for (std::string line = readLine(); !line.empty(); line = readLine()) all += line;
    return all;
  }
  int exitCode() { return WEXITSTATUS(pclose(pipe_)); }

 private:
  std::FILE* pipe_;
  pid_t pid_;
};

struct Result {
  int code;
  std::string output;
};

Result finish(Child& child) {
  std::string output = child.readAll();
  return {child.exitCode(), std::move(output)};
}

Result run(const std::string& arguments) {
  Child child(SACCADE_COMMAND " " + arguments);
  return finish(child);
}

// saccaded on free ports, until the end of the test.
class Server {
 public:
  explicit Server(const std::string& flags = {})
      : child_(SACCADE_SERVER
               " --control tcp://127.0.0.1:* --data tcp://127.0.0.1:* --broadcast tcp://127.0.0.1:* --http "
               "off " +
               flags) {
    const std::string mark = "ready: control ";
    std::string line = child_.readLine();
    while (!line.empty() && line.find(mark) == std::string::npos) line = child_.readLine();
    if (line.empty()) throw std::runtime_error("saccaded did not get ready");
    line.erase(0, line.find(mark) + mark.size());
    control_ = line.substr(0, line.find(' '));
  }
  ~Server() {
    stop();
    finish(child_);
  }
  void stop() const { child_.signal(SIGTERM); }
  std::string option() const { return " --control '" + control_ + "' "; }

 private:
  Child child_;
  std::string control_;
};

std::string textOf(const std::string& file) {
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

bool holds(const Result& result, const std::string& text) {
  return result.output.find(text) != std::string::npos;
}

TEST(Command, WrongUsageIsCode2) {
  for (const char* line :
       {"", "fly", "record", "record cornell-box --trajectory right -o a.xyz",
        "record cornell-box --trajectory right -o a.csv --size 3", "record cornell-box -o a.csv",
        "record cornell-box --motion pan -o a.csv", "list --control nonsense"}) {
    EXPECT_EQ(run(line).code, 2) << line;
  }
  EXPECT_EQ(run("--help").code, 0);
}

TEST(Command, WrongUsageIsToldInOneLine) {
  for (const char* line :
       {"", "record", "recrod cornell-box", "record cornell-box --trajectory right -o a.csv --frob",
        "record cornell-box --trajectory right -o a.csv --delivery pigeon",
        "record cornell-box --trajectory none.csv -o a.csv"}) {
    const Result result = run(line);
    EXPECT_EQ(result.output.find("saccade: "), 0u) << result.output;
    EXPECT_EQ(std::count(result.output.begin(), result.output.end(), '\n'), 1) << result.output;
  }
}

TEST(Command, WithoutAServerTheCodeIs1AndTheMessageSaysWhatToDo) {
  const Result result = run("info --wait 0.05 --control tcp://127.0.0.1:1");
  EXPECT_EQ(result.code, 1);
  EXPECT_TRUE(holds(result, "no saccaded answers at tcp://127.0.0.1:1: start it with")) << result.output;
  EXPECT_EQ(std::count(result.output.begin(), result.output.end(), '\n'), 1);
}

class CommandAndServer : public testing::Test {
 protected:
  Server server_;
  const ScratchFolder folder_;
};

TEST_F(CommandAndServer, ListsScenesAndMethods) {
  const Result info = run("info --wait 30" + server_.option());
  EXPECT_EQ(info.code, 0);
  EXPECT_TRUE(holds(info, "event_svgf") && holds(info, "alpha") && holds(info, "budgets")) << info.output;
  const Result list = run("list" + server_.option());
  EXPECT_EQ(list.code, 0);
  EXPECT_TRUE(holds(list, "cornell-box") && holds(list, "right")) << list.output;
}

TEST_F(CommandAndServer, RecordsASensorPerThreshold) {
  const std::string file = folder_.at("a.csv"), picture = folder_.at("a.png");
  const Result result =
      run("record cornell-box --trajectory right --size 32x24 --duration 0.06 --threshold 0.2 "
          "--threshold 0.4 -o " +
          file + " --preview " + picture + server_.option());
  ASSERT_EQ(result.code, 0) << result.output;
  EXPECT_TRUE(holds(result, "wrote " + folder_.at("a-0.csv"))) << result.output;
  EXPECT_TRUE(holds(result, "trace ")) << result.output;
  EXPECT_TRUE(holds(result, "the picture moves by 0.0") && holds(result, "pixels per frame"))
      << result.output;
  EXPECT_GT(fs::file_size(folder_.at("a-0.csv")), fs::file_size(folder_.at("a-1.csv")));
  EXPECT_GT(fs::file_size(picture), 100u);
}

TEST(CommandAndKeys, RecordsFromAServerThatWantsThem) {
  const ScratchFolder folder;
  const std::string server = folder.at("server"), alice = folder.at("alice"), file = folder.at("a.csv");
  ASSERT_EQ(run("keygen " + server).code, 0);
  ASSERT_EQ(run("keygen " + alice).code, 0);
  fs::copy_file(alice + ".pub", folder.at("clients"));
  const Server daemon("--secret-key " + server + ".key --client-keys " + folder.at("clients"));
  const std::string keys = " --secret-key " + alice + ".key --server-key " + server + ".pub ";
  const std::string record = "record cornell-box --trajectory right --size 32x24 --duration 0.01 -o " + file;
  const Result without = run("info --wait 0.2 " + daemon.option());
  EXPECT_EQ(without.code, 1);
  EXPECT_TRUE(holds(without, "it wants keys: give --secret-key and --server-key")) << without.output;
  EXPECT_EQ(run("info --secret-key " + alice + ".key" + daemon.option()).code, 2);
  EXPECT_EQ(run(record + keys + daemon.option()).code, 0);
  EXPECT_TRUE(fs::exists(file));
}

TEST(CommandAndBudget, TellsTheChoiceAndTheExpectedQuality) {
  const ScratchFolder folder;
  const AccuracyFile table(folder.at("chart"));
  const Server server("--accuracy " + table.path());
  const Result info = run("info" + server.option());
  EXPECT_TRUE(holds(info, "--budget-ms, --max-false-rate) for: cornell-box\n")) << info.output;
  EXPECT_TRUE(holds(info, table.settings())) << info.output;
  const std::string record =
      "record cornell-box --trajectory right --size 32x24 --duration 0.01 --threshold 0.1 -o " +
      folder.at("a.csv") + server.option();
  const Result chosen = run(record + "--budget-ms 4 --method svgf");
  EXPECT_EQ(chosen.code, 0);
  EXPECT_TRUE(holds(chosen, "chosen: svgf:as_falcor=1 at 1 spp\n")) << chosen.output;
  EXPECT_TRUE(holds(chosen, "3 CPU ms per frame, 0.1 false and 0.12 missed events")) << chosen.output;
  EXPECT_TRUE(holds(chosen, table.settings())) << chosen.output;
  const Result refused = run(record + "--max-false-rate 0.001 --force");
  EXPECT_EQ(refused.code, 2);
  EXPECT_TRUE(holds(refused, "quality.max_false_rate: the lowest rate here")) << refused.output;
}

TEST_F(CommandAndServer, RefusalsNameWhatIsValid) {
  const Result scene = run("record nowhere --trajectory right -o a.csv" + server_.option());
  EXPECT_EQ(scene.code, 2);
  EXPECT_TRUE(holds(scene, "scene:") && holds(scene, "cornell-box")) << scene.output;
  const Result threshold = run(
      "record cornell-box --trajectory right --threshold 0.2 --threshold nan -o a.csv" + server_.option());
  EXPECT_EQ(threshold.code, 2);
  EXPECT_TRUE(holds(threshold, "sensors[1].threshold")) << threshold.output;
  const Result output =
      run("record cornell-box --trajectory right -o " + folder_.at("none/a.csv") + server_.option());
  EXPECT_EQ(output.code, 2);
  EXPECT_TRUE(holds(output, "--output: ") && holds(output, "none/a.csv")) << output.output;
}

TEST_F(CommandAndServer, AnExistingFileIsKeptUnlessForced) {
  const std::string record = "record cornell-box --trajectory right --size 32x24 --duration 0.01 -o " +
                             folder_.at("a.csv") + server_.option();
  ASSERT_EQ(run(record).code, 0);
  const Result again = run(record);
  EXPECT_EQ(again.code, 2);
  EXPECT_TRUE(holds(again, "exists; --force replaces it")) << again.output;
  EXPECT_EQ(run(record + "--force").code, 0);
}

TEST_F(CommandAndServer, StandardOutputHoldsTheEventsAlone) {
  const std::string record = "record cornell-box --trajectory right --size 32x24 --duration 0.02 -o ";
  const std::string file = folder_.at("a.csv"), piped = folder_.at("b.csv");
  ASSERT_EQ(run(record + file + server_.option()).code, 0);
  Child child("sh -c \"" SACCADE_COMMAND " " + record + "- " + server_.option() + " >" + piped + "\"");
  const Result result = finish(child);
  EXPECT_EQ(result.code, 0) << result.output;
  EXPECT_TRUE(holds(result, "wrote to standard output")) << result.output;
  EXPECT_EQ(textOf(piped), textOf(file));
}

TEST_F(CommandAndServer, AFastPictureGetsTheRateThatWouldDo) {
  const Result fast = run("record cornell-box --trajectory right --size 64x48 --rate 50 --duration 0.04 -o " +
                          folder_.at("a.csv") + server_.option());
  EXPECT_EQ(fast.code, 0);
  const std::string mark = "above half a pixel per frame events are less accurate; --rate ";
  ASSERT_TRUE(holds(fast, mark)) << fast.output;
  const std::string rate = fast.output.substr(fast.output.find(mark) + mark.size(), 4);
  const Result slow = run("record cornell-box --trajectory right --size 64x48 --duration 0.04 --rate " +
                          rate.substr(0, rate.find(' ')) + " -o " + folder_.at("b.csv") + server_.option());
  EXPECT_EQ(slow.code, 0);
  EXPECT_FALSE(holds(slow, "above half a pixel")) << slow.output;
}

TEST_F(CommandAndServer, AFaultyTrajectoryIsNamedOnceByItsFile) {
  const std::string file = folder_.at("nan.csv");
  std::ofstream(file) << "0 0 0 0 0 0 0 1\n1 0 0 nan 0 0 0 1\n";
  const Result result =
      run("record cornell-box --trajectory " + file + " -o " + folder_.at("a.csv") + server_.option());
  EXPECT_EQ(result.code, 2);
  EXPECT_EQ(result.output, "saccade: " + file + ": line 2: 'nan' is not a finite number\n");
}

// A recording that events have come to: before that a server that stops would not know of its receiver.
class Interrupted : public CommandAndServer {
 protected:
  Child startRecord(const std::string& duration) {
    Child child(SACCADE_COMMAND
                " record cornell-box --trajectory right --size 32x24 --retry-time 0 --duration " +
                duration + " -o " + file_ + server_.option());
    const auto deadline = std::chrono::steady_clock::now() + std::chrono::minutes(1);
    while (!begun() && std::chrono::steady_clock::now() < deadline) std::this_thread::yield();
    return child;
  }
  const std::string file_ = folder_.at("a.csv"), partial_ = folder_.at("a.csv.partial");

 private:
  bool begun() const { return fs::exists(partial_) && fs::file_size(partial_) > kHeading.size(); }
  static constexpr std::string_view kHeading = "t_us,x,y,p\n";
};

TEST_F(Interrupted, CtrlCKeepsTheEventsThatCame) {
  Child record = startRecord("1000");
  record.signal(SIGINT);
  const Result result = finish(record);
  EXPECT_EQ(result.code, 1);
  EXPECT_TRUE(holds(result, "interrupted") && holds(result, partial_)) << result.output;
  EXPECT_TRUE(fs::exists(partial_) && !fs::exists(file_));
}

TEST_F(Interrupted, CtrlCIsTheEndOfAnEndlessStream) {
  Child record = startRecord("0");
  record.signal(SIGINT);
  const Result result = finish(record);
  EXPECT_EQ(result.code, 0) << result.output;
  EXPECT_TRUE(fs::exists(file_) && !fs::exists(partial_));
}

TEST_F(Interrupted, AServerThatStopsLeavesNoWholeFile) {
  Child record = startRecord("1000");
  server_.stop();
  const Result result = finish(record);
  EXPECT_EQ(result.code, 1);
  EXPECT_TRUE(holds(result, "the server has stopped and ended the stream at frame")) << result.output;
  EXPECT_TRUE(fs::exists(partial_) && !fs::exists(file_));
}

}  // namespace
}  // namespace saccade
