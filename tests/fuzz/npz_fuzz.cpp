#include "client/formats/common/reader.h"
#include "client/formats/npz/npz_column.h"
#include "fuzz/fuzz_target.h"
#include "fuzz/memory_file.h"

namespace saccade {
namespace {

const client::ReaderInfo& kNpzReader = client::readerFor("a.npz");

using namespace client;

std::string archive(const std::vector<std::pair<std::string, std::string>>& arrays) {
  std::string bytes;
  std::vector<ZipMember> members;
  for (const auto& [name, array] : arrays) {
    members.push_back(zipMember(name + ".npy", array));
    members.back().offset = bytes.size();
    bytes += zipHeader(members.back()) + array;
  }
  return bytes + zipDirectory(members, bytes.size());
}

std::string column(const std::string& type, std::size_t bytes) {
  std::string values(3 * bytes, '\0');
  values[bytes] = values[2 * bytes] = 1;
  return npyHeader(type, "(3,)") + values;
}

}  // namespace

const FuzzTarget& fuzzTarget() {
  static const FuzzTarget target{
      {archive({{"t", column("<i8", 8)},
                {"x", column("<u2", 2)},
                {"y", column("|i1", 1)},
                {"p", column("|b1", 1)},
                {"width", npyHeader("<i4", "()") + std::string("\4\0\0\0", 4)},
                {"height", npyHeader("|u1", "()") + "\3"}}),
       archive({{"t", column("<u4", 4)},
                {"x", column("<i2", 2)},
                {"y", column("<u8", 8)},
                {"p", column("|u1", 1)},
                {"source", column("|u1", 1)},
                {"artefact", column("<i2", 2)}})},
      {"'descr': ", "'shape': ", "(3,)", "()", "(3, 3)", "(999999999999999999,)", "<i8", ">u2", "|b1", "<f8",
       "t.npy", "x.npy", "PK\1\2", "PK\3\4", "PK\5\6", "PK\6\6", "PK\6\7", "\x93NUMPY", "\xff\xff\xff\xff"},
      [](std::string_view bytes) {
        const MemoryFile file(bytes);
        return accepts<FileFault>([&] {
          const auto reader = kNpzReader.make(file.path());
          reader->size();
          for (Events events; reader->read(events);) SACCADE_CHECK(events.size() <= 1 << 16);
        });
      },
      nullptr,
      20000};
  return target;
}

}  // namespace saccade
