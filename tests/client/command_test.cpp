// The `saccade` command, run as a user runs it: alone, and with a server.
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>

namespace saccade {
namespace {

namespace fs = std::filesystem;

bool readLine(std::FILE* pipe, std::string& line) {
  char buffer[4096];
  line = std::fgets(buffer, sizeof(buffer), pipe) ? buffer : "";
  return !line.empty();
}

struct Result {
  int code;
  std::string output;  // stdout and stderr
};

Result run(const std::string& arguments) {
  std::FILE* pipe = popen((SACCADE_COMMAND " " + arguments + " 2>&1").c_str(), "r");
  std::string output;
  for (std::string line; readLine(pipe, line);) output += line;
  return {WEXITSTATUS(pclose(pipe)), output};
}

// saccaded on free ports, until the end of the test.
class Server {
 public:
  Server() {
    const std::string ports =
        " --control tcp://127.0.0.1:* --data tcp://127.0.0.1:* --broadcast tcp://127.0.0.1:*";
    pipe_ = popen(("echo $$; exec " SACCADE_SERVER + ports + " 2>&1").c_str(), "r");
    std::string line;
    if (readLine(pipe_, line)) pid_ = std::stoi(line);
    const std::string mark = "ready: control ";
    while (readLine(pipe_, line)) {
      const std::size_t at = line.find(mark);
      if (at == std::string::npos) continue;
      control_ = line.substr(at + mark.size(), line.find(' ', at + mark.size()) - at - mark.size());
      return;
    }
    ADD_FAILURE() << "saccaded did not get ready";
  }
  ~Server() {
    kill(pid_, SIGTERM);
    std::string line;
    while (readLine(pipe_, line)) continue;
    pclose(pipe_);
  }
  std::string option() const { return " --control '" + control_ + "' "; }

 private:
  std::FILE* pipe_;
  pid_t pid_ = 0;
  std::string control_;
};

bool holds(const Result& result, const std::string& text) {
  return result.output.find(text) != std::string::npos;
}

TEST(Command, WrongUsageIsCode2) {
  for (const char* line :
       {"", "fly", "record", "record cornell-box --trajectory right -o a.xyz",
        "record cornell-box --trajectory right -o a.csv --size 3", "list --control nonsense"}) {
    EXPECT_EQ(run(line).code, 2) << line;
  }
  EXPECT_EQ(run("--help").code, 0);
}

TEST(Command, NobodyAnswersIsCode1AndSaysWhatToDo) {
  const Result result = run("info --wait 0.05 --control tcp://127.0.0.1:1");
  EXPECT_EQ(result.code, 1);
  EXPECT_TRUE(holds(result, "no saccaded answers at tcp://127.0.0.1:1: start it with")) << result.output;
  EXPECT_EQ(std::count(result.output.begin(), result.output.end(), '\n'), 1);
}

class CommandAndServer : public testing::Test {
 protected:
  CommandAndServer() {
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  ~CommandAndServer() override { fs::remove_all(folder_); }

  Server server_;
  const fs::path folder_ = fs::path(testing::TempDir()) / "saccade_command_test";
};

TEST_F(CommandAndServer, TellsWhatThereIs) {
  const Result info = run("info --wait 30" + server_.option());
  EXPECT_EQ(info.code, 0);
  EXPECT_TRUE(holds(info, "event_svgf") && holds(info, "alpha")) << info.output;
  const Result list = run("list" + server_.option());
  EXPECT_EQ(list.code, 0);
  EXPECT_TRUE(holds(list, "cornell-box") && holds(list, "right")) << list.output;
}

TEST_F(CommandAndServer, RecordsASensorPerThreshold) {
  const std::string file = folder_ / "a.csv", picture = folder_ / "a.png";
  const Result result =
      run("record cornell-box --trajectory right --size 32x24 --duration 0.06 --threshold 0.2 "
          "--threshold 0.4 -o " +
          file + " --preview " + picture + server_.option());
  ASSERT_EQ(result.code, 0) << result.output;
  EXPECT_TRUE(holds(result, "wrote " + (folder_ / "a-0.csv").string())) << result.output;
  EXPECT_TRUE(holds(result, "trace ")) << result.output;
  EXPECT_GT(fs::file_size(folder_ / "a-0.csv"), fs::file_size(folder_ / "a-1.csv"));
  EXPECT_GT(fs::file_size(picture), 100u);
}

TEST_F(CommandAndServer, RefusalsNameWhatIsValid) {
  const Result scene = run("record nowhere --trajectory right -o a.csv" + server_.option());
  EXPECT_EQ(scene.code, 2);
  EXPECT_TRUE(holds(scene, "scene:") && holds(scene, "cornell-box")) << scene.output;
  const Result threshold = run(
      "record cornell-box --trajectory right --threshold 0.2 --threshold nan -o a.csv" + server_.option());
  EXPECT_EQ(threshold.code, 2);
  EXPECT_TRUE(holds(threshold, "sensors[1].threshold")) << threshold.output;
}

}  // namespace
}  // namespace saccade
