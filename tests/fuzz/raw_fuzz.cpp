#include "client/formats/common/event_check.h"
#include "fuzz/fuzz_target.h"
#include "fuzz/memory_file.h"

namespace saccade {
namespace {

const client::ReaderInfo& kRawReader = client::readerFor("a.raw");

using namespace std::string_literals;

// Reads the whole file, as `saccade convert` does.
void readAll(const std::string& path) {
  const auto reader = kRawReader.make(path);
  client::EventCheck check(path, reader->size());
  for (Events events; reader->read(events);) check.check(events);
}

}  // namespace

const FuzzTarget& fuzzTarget() {
  static const FuzzTarget target{
      // TIME_HIGH, TIME_LOW, row, an event, a vector, a trigger, TIME_HIGH, TIME_LOW, an event
      {"% evt 3.0\n% format EVT3;height=720;width=1280\n% "
       "end\n\0\x80\5\x60\2\0\1\x28\x10\x30\7\x40\1\x40\x80\x50"
       "\0\xa0\1\x80\0\x60\1\x20"s,
       // TIME_HIGH, two events, TIME_HIGH, an event
       "% evt 2.0\n% geometry 1280x720\n% end\n\0\0\0\x80\2\x08\x40\x11\1\x08\0\x02\1\0\0\x80\1\x08\0\x12"s},
      {"% ",
       "% end\n",
       "evt ",
       "format ",
       "geometry ",
       "EVT21",
       "-1",
       "0",
       "70000",
       ";",
       "=",
       "x",
       "\xff\x8f",
       "\0\x80"s,
       "\xff\x6f",
       "\xff\x37",
       "\xff\x4f",
       "\xff\x5f",
       "\xff\x07",
       "\xff\x2f",
       "\xff\xff\xff\x8f",
       "\0\0\0\x80"s,
       "\xff\xff\xff\x1f",
       "\xff\xff\xff\x9f"},
      [](std::string_view bytes) {
        const MemoryFile file(bytes);
        return accepts<client::FileFault>([&] { readAll(file.path()); });
      }};
  return target;
}

}  // namespace saccade
