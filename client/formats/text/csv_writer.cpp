// CSV: the heading `t,x,y,p`, then one line per event; times in whole microseconds, p is 1 ON, 0 OFF. Objects
// are a fifth column, `object`.
#include "client/formats/common/units.h"
#include "client/formats/text/text_writer.h"

namespace saccade::client {
namespace {

void appendColumns(std::string& text, const Event& event) {
  appendNumber(text, event.t_ns / kNsPerUs);
  for (const int value : {int{event.x}, int{event.y}, int{event.p}}) {
    text += ',';
    appendNumber(text, value);
  }
}

void appendLine(std::string& text, const Event& event) {
  appendColumns(text, event);
  text += '\n';
}

void appendObjectLine(std::string& text, const Event& event) {
  appendColumns(text, event);
  text += ',';
  appendNumber(text, event.object);
  text += '\n';
}

std::unique_ptr<Writer> make(const std::string& path, const v1::Recording& about) {
  if (about.object_ids()) return std::make_unique<TextWriter>(path, "t,x,y,p,object\n", appendObjectLine);
  return std::make_unique<TextWriter>(path, "t,x,y,p\n", appendLine);
}

}  // namespace

extern const WriterInfo kCsvWriter{.name = "csv",
                                   .extension = ".csv",
                                   .description = "t,x,y,p with a heading, t in microseconds",
                                   .make = make,
                                   .pipe = true,
                                   .objects = true};

}  // namespace saccade::client
