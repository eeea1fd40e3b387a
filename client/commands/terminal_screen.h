// The terminal's second screen: what was on the first comes back at the end.
#pragma once

#include <string>

namespace saccade::client {

class TerminalScreen {
 public:
  struct Size {
    int columns, rows;  // letters
    friend bool operator==(const Size&, const Size&) = default;
  };

  // Throws std::invalid_argument if standard output is no terminal.
  TerminalScreen();
  ~TerminalScreen();
  TerminalScreen(const TerminalScreen&) = delete;
  TerminalScreen& operator=(const TerminalScreen&) = delete;

  Size size() const;  // at present: the user may change it
  void show(const std::string& text) const;
  void clear() const;
  // Writes the last line of the screen; a longer text is cut off.
  void showStatus(const std::string& text) const;
};

}  // namespace saccade::client
