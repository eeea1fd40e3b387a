// `saccade view` in a terminal.
#include <pty.h>
#include <unistd.h>

#include "client/command.h"

namespace saccade {
namespace {

using namespace test;

// A program in a terminal of 40x12 letters.
class TerminalChild {
 public:
  explicit TerminalChild(const std::string& command) {
    winsize size{.ws_row = 12, .ws_col = 40, .ws_xpixel = 0, .ws_ypixel = 0};
    pid_ = forkpty(&terminal_, nullptr, nullptr, &size);
    if (pid_ == 0) execl("/bin/sh", "sh", "-c", ("exec " + command).c_str(), nullptr);
  }
  ~TerminalChild() { close(terminal_); }
  void signal(int number) const { kill(pid_, number); }

  // Reads until `mark` has been shown, or to the end.
  const std::string& readUntil(const std::string& mark) {
    char buffer[4096];
    while (shown_.find(mark) == std::string::npos) {
      const ssize_t count = read(terminal_, buffer, sizeof(buffer));
      if (count <= 0) break;
      shown_.append(buffer, static_cast<std::size_t>(count));
    }
    return shown_;
  }
  int exitCode() const {
    int status = 0;
    waitpid(pid_, &status, 0);
    return WEXITSTATUS(status);
  }

 private:
  int terminal_ = -1;
  pid_t pid_ = -1;
  std::string shown_;
};

TEST_F(CommandAndServer, ShowsEventsUntilCtrlCAndGivesTheTerminalBack) {
  TerminalChild view(SACCADE_COMMAND " view cornell-box --motion orbit" + server_.option());
  view.readUntil("38;2;255;89;64m");  // the colour of an ON event that is new
  view.signal(SIGINT);
  const std::string shown = view.readUntil("\x1b[?1049l");
  EXPECT_EQ(view.exitCode(), 0);
  EXPECT_EQ(shown.find("\x1b[?1049h"), 0u);
  EXPECT_NE(shown.find("x real time, "), std::string::npos) << "no figures";
  EXPECT_NE(shown.find("\x1b[12;1H"), std::string::npos) << "not in the last line";
  EXPECT_NE(shown.find("\x1b[?1049l"), std::string::npos) << "the terminal is not given back";
}

TEST_F(CommandAndServer, EveryViewOfARigHasTheTerminalsSize) {
  TerminalChild view(SACCADE_COMMAND
                     " view cornell-box --motion orbit --duration 0.02 --further-view 0.1,0,0" +
                     server_.option());
  const std::string shown = view.readUntil("\x1b[?1049l");
  EXPECT_EQ(view.exitCode(), 0) << shown;
}

TEST(View, NeedsATerminalAndOneSensor) {
  const Server server;
  const Result piped = run("view cornell-box --motion orbit" + server.option());
  EXPECT_EQ(piped.code, 2);
  EXPECT_TRUE(holds(piped, "standard output is not a terminal")) << piped.output;
  const Result wrong = run("view cornell-box --size 40" + server.option());
  EXPECT_EQ(wrong.code, 2);
  EXPECT_TRUE(holds(wrong, "--size")) << wrong.output;
  const Result two = run("view cornell-box --motion orbit --threshold 0.1,0.2" + server.option());
  EXPECT_EQ(two.code, 2);
  EXPECT_TRUE(holds(two, "a view shows the events of one sensor")) << two.output;
}

}  // namespace
}  // namespace saccade
