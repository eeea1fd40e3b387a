// The text format that rpg_e2vid reads: a line `width height`, then one line `t x y p` per event. Here t is
// in seconds with nine decimals; p is 1 for ON, 0 for OFF. (`events.txt` of the rpg data sets is the same
// without the first line.)
#include <cstdlib>

#include "client/formats/common/units.h"
#include "client/formats/text/text_writer.h"

namespace saccade::client {
namespace {

void appendLine(std::string& text, const Event& event) {
  if (event.t_ns < 0) text += '-';
  appendNumber(text, std::abs(event.t_ns / kNsPerSecond));
  text += '.';
  appendNumber(text, std::abs(event.t_ns % kNsPerSecond), 9);
  for (const int value : {int{event.x}, int{event.y}, int{event.p}}) {
    text += ' ';
    appendNumber(text, value);
  }
  text += '\n';
}

std::unique_ptr<Writer> make(const std::string& path, const v1::Recording& about) {
  const std::string size = std::to_string(about.width()) + " " + std::to_string(about.height()) + "\n";
  return std::make_unique<TextWriter>(path, size, appendLine);
}

}  // namespace

extern const WriterInfo kTxtWriter{
    "txt", ".txt", "a line \"width height\", then t[s] x y p, as rpg_e2vid reads it", make, true};

}  // namespace saccade::client
