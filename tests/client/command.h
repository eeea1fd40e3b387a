// Runs the `saccade` command as a user does: alone, and with a server.
#pragma once

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

#include "scratch_folder.h"

namespace saccade::test {

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

inline Result finish(Child& child) {
  std::string output = child.readAll();
  return {child.exitCode(), std::move(output)};
}

inline Result run(const std::string& arguments) {
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

inline std::string textOf(const std::string& file) {
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

inline bool holds(const Result& result, const std::string& text) {
  return result.output.find(text) != std::string::npos;
}
class CommandAndServer : public testing::Test {
 protected:
  Server server_;
  const ScratchFolder folder_;
};
}  // namespace saccade::test
