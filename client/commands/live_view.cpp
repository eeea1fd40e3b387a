#include "client/commands/live_view.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "client/commands/half_blocks.h"
#include "client/formats/common/units.h"

namespace saccade::client {
namespace {

constexpr std::chrono::milliseconds kRedraw{50};
constexpr Colour kOn{1, 0.35f, 0.25f}, kOff{0.35f, 0.6f, 1};

RgbPicture draw(const TimeSurface& surface, const v1::View& room, std::int64_t now_ns) {
  const int columns = static_cast<int>(room.width()), rows = static_cast<int>(room.height());
  const int side = std::max((surface.width() + columns - 1) / columns, (surface.height() + rows - 1) / rows);
  RgbPicture picture{(surface.width() + side - 1) / side, (surface.height() + side - 1) / side, {}};
  for (int y = 0; y < picture.height; ++y) {
    for (int x = 0; x < picture.width; ++x) {
      const float weight = surface.weight(x * side, y * side, side, now_ns);
      for (const float value : weight > 0 ? kOn : kOff)
        picture.pixels.push_back(static_cast<std::uint8_t>(std::lround(255 * value * std::abs(weight))));
    }
  }
  return picture;
}

}  // namespace

v1::View viewOf(const TerminalScreen::Size& terminal) {
  v1::View view;
  view.set_width(static_cast<std::uint32_t>(std::max(terminal.columns, 1)));
  view.set_height(2 *
                  static_cast<std::uint32_t>(std::max(terminal.rows - 1, 1)));  // the last line has figures
  return view;
}

LiveView::LiveView(const TerminalScreen& screen, const v1::View& view, double decay_s)
    : screen_(screen), surface_(static_cast<int>(view.width()), static_cast<int>(view.height()), decay_s) {}

void LiveView::see(const DecodedPacket& batch) {
  if (batch.header.kind() == v1::KIND_HEARTBEAT) return;
  if (!begin_ns_) begin_ns_ = batch.header.t0_ns();
  surface_.add(batch.events);
  events_ += batch.events.size();
  now_ns_ = batch.header.t1_ns();
}

void LiveView::drawIfDue(const Losses& losses) {
  if (Clock::now() - drawn_ < kRedraw) return;
  drawn_ = Clock::now();
  const TerminalScreen::Size size = screen_.size();
  if (size != size_) screen_.clear();
  size_ = size;
  screen_.show(halfBlocks(draw(surface_, viewOf(size), now_ns_)));
  screen_.showStatus(status(losses));
}

std::string LiveView::status(const Losses& losses) const {
  const double wall_s = std::chrono::duration<double>(drawn_ - start_).count();
  const double stream_s = secondsOf(now_ns_ - begin_ns_.value_or(now_ns_));
  char text[160];
  std::snprintf(text, sizeof(text),
                "%.3f s, %.2gx real time, %.3g events/s, %llu packets lost; red ON, blue OFF; Ctrl-C ends",
                secondsOf(now_ns_), stream_s / wall_s,
                stream_s > 0 ? static_cast<double>(events_) / stream_s : 0.0,
                static_cast<unsigned long long>(losses.packets));
  return text;
}

}  // namespace saccade::client
