// Text files of events, as a user has them and says of them.
#include "client/formats/common/column_names.h"
#include "client/formats/common/reader.h"
#include "fuzz/fuzz_target.h"
#include "fuzz/memory_file.h"

namespace saccade {
namespace {

using namespace client;

const ReaderInfo& kTextReader = readerFor("a.csv");

bool readAll(const std::string& path, const ColumnOptions& options) {
  return accepts<FileFault>([&] {
    const auto reader = kTextReader.makeBy(path, options);
    SACCADE_CHECK(reader->size().width <= 65536 && reader->size().height <= 65536);
    for (Events events; reader->read(events);) {
      SACCADE_CHECK(events.size() <= 1 << 16);
      for (const Event& event : events) SACCADE_CHECK(event.p <= 1 && event.t_ns % 1000 == 0);
    }
  });
}

}  // namespace

const FuzzTarget& fuzzTarget() {
  static const FuzzTarget target{
      {"t,x,y,p\n29,5,7,0\n35,0,2,1\n", "x y pol t[ns]\n5 7 -1 29000\n0 2 1 35499\n",
       "%geometry:1280,720\n5,7,0,29\n0,2,1,35\n300,1,0,99\n", "346 260\n0.000029 5 7 0\n3.5e-05 0 2 1\n",
       "# t x y p\n0.5 5 7 False\n1.25 0 2 True\n", "t;x;y;p;label\n0.000029;5;7;0;9\n0.000035;0;2;1;9\n"},
      {"t_us",
       "timestamp",
       "time (s)",
       "polarity",
       "%geometry:",
       "#",
       ",",
       ";",
       "\t",
       ".",
       "e9",
       "e-9",
       "-",
       "nan",
       "inf",
       "True",
       "4294967295",
       "9223372036854775807",
       "-9223372036854775808",
       "1e18",
       "65536",
       "\r\n",
       "\n",
       "\xef\xbb\xbf"},
      [](std::string_view bytes) {
        const MemoryFile file(bytes);
        const bool plain = readAll(file.path(), {});
        for (const TimeUnit unit : {TimeUnit::kS, TimeUnit::kNs}) readAll(file.path(), {{}, unit});
        return plain;
      }};
  return target;
}

}  // namespace saccade
