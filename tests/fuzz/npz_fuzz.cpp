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

// `values` under a header of another type or shape.
std::string array(const std::string& descr, const std::string& by_columns, const std::string& shape,
                  const std::string& values) {
  std::string header = npyHeader("<u2", shape);
  std::string text =
      "{'descr': " + descr + ", 'fortran_order': " + by_columns + ", 'shape': " + shape + ", }";
  text.resize(header.size() - 11, ' ');
  return header.replace(10, text.size(), text) + values;
}

template <class T>
std::string bytesOf(const std::vector<T>& numbers) {
  return {reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(T)};
}

const std::string kFields = "[('x','<u2'),('y','<u2'),('','|V4'),('t','<i8'),('p','|b1')]";

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
                {"artefact", column("<i2", 2)}}),
       archive({{"events", array(kFields, "False", "(2,)", std::string(34, '\0'))}}),
       archive({{"events", array("'<f8'", "False", "(2, 4)", bytesOf<double>({0, 5, 7, 0, 0.5, 0, 2, 1}))}}),
       archive(
           {{"events", array("'<i4'", "True", "(2, 4)", bytesOf<std::int32_t>({0, 29, 5, 0, 7, 2, 0, 1}))}})},
      {"'descr': ",
       "'shape': ",
       "(3,)",
       "()",
       "(3, 3)",
       "(999999999999999999,)",
       "(999999999999999999, 4)",
       "True",
       "[('t', '<i8')]",
       "<i8",
       ">u2",
       "|b1",
       "<f8",
       "t.npy",
       "x.npy",
       "PK\1\2",
       "PK\3\4",
       "PK\5\6",
       "PK\6\6",
       "PK\6\7",
       "\x93NUMPY",
       "\xff\xff\xff\xff"},
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
