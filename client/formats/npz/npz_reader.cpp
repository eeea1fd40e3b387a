// NumPy's .npz: four arrays t, x, y and p of equal lengths, or an array of structures or of rows of four
// numbers. Numbers are of any width, stored or compressed. There may be labels in source and artefact,
// objects in object, and single numbers width and height. A cut file cannot be read, because its directory
// stands at the end.
#include <algorithm>
#include <utility>

#include "client/formats/common/column_reader.h"
#include "client/formats/npz/npy_column.h"

namespace saccade::client {
namespace {

constexpr std::string_view kMember = ".npy";
constexpr zip_int64_t kMostMembers = 1000;  // that are looked at

class NpzFile : public ArrayFile {
 public:
  explicit NpzFile(const std::string& path) : path_(path), archive_(openZip(path)) {}

  std::vector<std::string> names() const override;
  bool has(const std::string& name) const override {
    return zip_name_locate(archive_.get(), (name + std::string(kMember)).c_str(), 0) >= 0;
  }
  ArrayForm form(const std::string& name) const override;
  std::unique_ptr<NumberColumn> open(const ColumnPlace& place) const override;
  std::uint32_t sideOf(const std::string& name) const;

 private:
  const std::string path_;
  const ZipArchive archive_;
};

std::vector<std::string> NpzFile::names() const {
  std::vector<std::string> names;
  for (zip_int64_t i = 0; i < std::min(kMostMembers, zip_get_num_entries(archive_.get(), 0)); ++i) {
    const char* entry = zip_get_name(archive_.get(), static_cast<zip_uint64_t>(i), 0);
    const std::string name = entry ? entry : "";
    if (name.ends_with(kMember)) names.push_back(name.substr(0, name.size() - kMember.size()));
  }
  return names;
}

ArrayForm NpzFile::form(const std::string& name) const {
  ArrayForm form;
  try {
    const NpyStream stream(path_, archive_, name);
    form.columns = stream.header().columns;
    if (!stream.header().structured()) return form;
    for (const NpyField& field : stream.header().fields) form.fields.push_back(field.name);
  } catch (const FileFault&) {  // not of numbers, such as Python's objects
  }
  return form;
}

std::unique_ptr<NumberColumn> NpzFile::open(const ColumnPlace& place) const {
  auto column = std::make_unique<NpyColumn>(path_, archive_, place);
  if (column->single()) throw FileFault(path_, place.array + ".npy is a single number");
  return column;
}

std::uint32_t NpzFile::sideOf(const std::string& name) const {
  if (!has(name)) return 0;
  NpyColumn number(path_, archive_, {name});
  if (!number.single()) throw FileFault(path_, name + ".npy is not a single number");
  std::vector<std::int64_t> pixels;
  number.read(1, pixels);
  return toSide(path_, name, pixels[0]);
}

// The truth channels, with an array NAME_t beside each, after `names`.
std::string otherNames(const NpzFile& file, std::string names) {
  constexpr std::string_view kTimes = "_t";
  bool first = true;
  for (const std::string& name : file.names()) {
    if (!name.ends_with(kTimes)) continue;
    if (!names.empty()) names += ", ";
    if (std::exchange(first, false)) names += "truth ";
    names += name.substr(0, name.size() - kTimes.size());
  }
  return names;
}

std::unique_ptr<Reader> makeBy(const std::string& path, const ColumnOptions& options) {
  auto file = std::make_unique<NpzFile>(path);
  const FoundColumns columns = findColumns(path, *file, options, {kTxyp, kXytp, kXypt});
  const LabelColumns labels{file->has("source"), file->has("artefact")};
  ArrayFacts facts;
  facts.size = {file->sideOf("width"), file->sideOf("height")};
  if (labels.both()) facts.source = "source", facts.artefact = "artefact";
  if (file->has("object")) facts.object = "object";
  facts.left_out = otherNames(*file, labels.alone());
  return std::make_unique<ColumnReader>(path, std::move(file), columns, options.unit, facts);
}

std::unique_ptr<Reader> make(const std::string& path) {
  return makeBy(path, {});
}

}  // namespace

extern const ReaderInfo kNpzReader{".npz", "NumPy arrays t, x, y, p, or a table of them", make, makeBy};

}  // namespace saccade::client
