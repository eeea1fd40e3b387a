// A program that a test runs. It is killed where it has not ended by itself.
#pragma once

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

namespace saccade {

class Process {
 public:
  // `pipe_bytes`: of output that it may leave unread. A program whose output nobody reads would stand still.
  explicit Process(const std::vector<std::string>& command, int pipe_bytes = 1 << 20) {
    std::vector<char*> argv;
    for (const auto& word : command) argv.push_back(const_cast<char*>(word.c_str()));
    argv.push_back(nullptr);
    int pipe_ends[2];
    if (pipe2(pipe_ends, O_CLOEXEC) != 0) std::abort();
    fcntl(pipe_ends[0], F_SETPIPE_SZ, pipe_bytes);
    pid_ = fork();
    if (pid_ == 0) {
      std::signal(SIGPIPE, SIG_DFL);  // whatever the test was started by has set
      dup2(pipe_ends[1], STDOUT_FILENO);
      dup2(pipe_ends[1], STDERR_FILENO);
      execv(argv[0], argv.data());
      _exit(127);
    }
    ::close(pipe_ends[1]);
    output_ = fdopen(pipe_ends[0], "r");
  }
  ~Process() {
    if (pid_ > 0) kill(pid_, SIGKILL);
    finish();
    if (output_) fclose(output_);
  }
  void closeOutput() {
    fclose(output_);
    output_ = nullptr;
  }

  // The next line of output with `word` in it; empty at the end of the output.
  std::string lineWith(const std::string& word) {
    char line[4096];
    while (fgets(line, sizeof line, output_)) {
      if (std::string(line).find(word) != std::string::npos) return line;
    }
    return {};
  }
  // All output that is left.
  std::string rest() {
    std::string text;
    char line[4096];
    while (fgets(line, sizeof line, output_)) text += line;
    return text;
  }
  pid_t pid() const { return pid_; }
  void signal(int number) { kill(pid_, number); }
  bool running() const {
    siginfo_t end{};
    return waitid(P_PID, static_cast<id_t>(pid_), &end, WEXITED | WNOHANG | WNOWAIT) == 0 && end.si_pid == 0;
  }
  int finish() {  // exit status; -1 if a signal ended it
    if (pid_ > 0) waitpid(pid_, &status_, 0);
    pid_ = 0;
    return WIFEXITED(status_) ? WEXITSTATUS(status_) : -1;
  }

 private:
  pid_t pid_;
  int status_ = 0;
  FILE* output_;
};

}  // namespace saccade
