// `t x y p` as the event-camera data sets of rpg have it: seconds with nine decimals, no heading.
#include "client/writers/text_writer.h"

namespace saccade::client {
namespace {

constexpr std::int64_t kNsPerSecond = 1'000'000'000;

void appendLine(std::string& text, const Event& event) {
  appendNumber(text, event.t_ns / kNsPerSecond);
  text += '.';
  appendNumber(text, event.t_ns % kNsPerSecond, 9);
  for (const int value : {int{event.x}, int{event.y}, int{event.p}}) {
    text += ' ';
    appendNumber(text, value);
  }
  text += '\n';
}

std::unique_ptr<Writer> make(const std::string& path) {
  return std::make_unique<TextWriter>(path, "", appendLine);
}

}  // namespace

const WriterInfo kTxtWriter{".txt", "t[s] x y p, as rpg's data sets", make};

}  // namespace saccade::client
