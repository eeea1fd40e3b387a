// Draws the events of a stream on a terminal, as they come.
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>

#include "client/commands/terminal_screen.h"
#include "client/drawing/time_surface.h"
#include "saccade/subscription.h"

namespace saccade::client {

class LiveView {
 public:
  // `decay_s`: see TimeSurface.
  LiveView(const TerminalScreen& screen, const v1::View& view, double decay_s);

  void see(const DecodedPacket& batch);  // every batch, in order
  // Draws the image and a line of figures, 20 times a second. Squares of pixels become one where the terminal
  // is smaller than the image.
  void drawIfDue(const Losses& losses);

 private:
  using Clock = std::chrono::steady_clock;
  std::string status(const Losses& losses) const;

  const TerminalScreen& screen_;
  TimeSurface surface_;
  TerminalScreen::Size size_{0, 0};  // at the last drawing
  std::optional<std::int64_t> begin_ns_;
  std::int64_t now_ns_ = 0;  // stream time
  std::uint64_t events_ = 0;
  const Clock::time_point start_ = Clock::now();
  Clock::time_point drawn_ = start_;
};

// The largest image that the terminal shows pixel by pixel.
v1::View viewOf(const TerminalScreen::Size& terminal);

}  // namespace saccade::client
