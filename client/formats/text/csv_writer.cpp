// CSV: the heading `t,x,y,p`, then one line per event; times in whole microseconds, p is 1 ON, 0 OFF.
#include "client/formats/common/units.h"
#include "client/formats/text/text_writer.h"

namespace saccade::client {
namespace {

void appendLine(std::string& text, const Event& event) {
  appendNumber(text, event.t_ns / kNsPerUs);
  for (const int value : {int{event.x}, int{event.y}, int{event.p}}) {
    text += ',';
    appendNumber(text, value);
  }
  text += '\n';
}

std::unique_ptr<Writer> make(const std::string& path, const v1::Recording&) {
  return std::make_unique<TextWriter>(path, "t,x,y,p\n", appendLine);
}

}  // namespace

extern const WriterInfo kCsvWriter{"csv", ".csv", "t,x,y,p with a heading, t in microseconds", make, true};

}  // namespace saccade::client
