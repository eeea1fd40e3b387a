#include "client/commands/terminal_screen.h"

#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <stdexcept>

#include "client/terminal/console.h"

namespace saccade::client {
namespace {

constexpr const char* kEnter = "\x1b[?1049h\x1b[?25l\x1b[2J";  // second screen, no cursor, cleared
constexpr const char* kLeave = "\x1b[0m\x1b[?25h\x1b[?1049l";

}  // namespace

TerminalScreen::TerminalScreen() {
  if (isatty(STDOUT_FILENO) == 0)
    throw std::invalid_argument(
        "standard output is not a terminal; `saccade record --preview` makes a picture");
  show(kEnter);
}

TerminalScreen::~TerminalScreen() {
  show(kLeave);
}

TerminalScreen::Size TerminalScreen::size() const {
  winsize size{};
  if (ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) != 0 || size.ws_col == 0 || size.ws_row == 0) return {80, 24};
  return {size.ws_col, size.ws_row};
}

void TerminalScreen::show(const std::string& text) const {
  std::fwrite(text.data(), 1, text.size(), stdout);
  std::fflush(stdout);
}

void TerminalScreen::clear() const {
  show("\x1b[2J");
}

void TerminalScreen::showStatus(const std::string& text) const {
  const Size now = size();
  const std::string cut = printable(text).substr(0, static_cast<std::size_t>(std::max(now.columns, 0)));
  show("\x1b[" + std::to_string(now.rows) + ";1H" + cut + "\x1b[K");
}

}  // namespace saccade::client
