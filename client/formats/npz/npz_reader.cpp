// NumPy's .npz: arrays t (microseconds), x, y and p (0 or 1, or bool) of equal lengths. They are whole
// numbers of any width, stored or compressed. There may be labels in source and artefact, and single numbers
// width and height. A cut file cannot be read, because its directory stands at the end.
#include <algorithm>
#include <initializer_list>
#include <optional>
#include <utility>

#include "client/formats/common/event_columns.h"
#include "client/formats/npz/npy_column.h"

namespace saccade::client {
namespace {

bool has(const ZipArchive& archive, const std::string& name) {
  return zip_name_locate(archive.get(), (name + ".npy").c_str(), 0) >= 0;
}

std::uint32_t sideOf(const std::string& path, const ZipArchive& archive, const std::string& name) {
  if (!has(archive, name)) return 0;
  NpyColumn number(path, archive, name);
  if (!number.single()) throw FileFault(path, name + ".npy is not a single number");
  std::vector<std::int64_t> pixels;
  number.read(1, pixels);
  return toSide(path, name, pixels[0]);
}

// The truth channels, with an array NAME_t beside each, after `names`.
std::string otherNames(const ZipArchive& archive, std::string names) {
  constexpr std::string_view kTimes = "_t.npy";
  bool first = true;
  for (zip_int64_t i = 0; i < zip_get_num_entries(archive.get(), 0); ++i) {
    const char* entry = zip_get_name(archive.get(), static_cast<zip_uint64_t>(i), 0);
    const std::string name = entry ? entry : "";
    if (!name.ends_with(kTimes)) continue;
    if (!names.empty()) names += ", ";
    if (std::exchange(first, false)) names += "truth ";
    names += name.substr(0, name.size() - kTimes.size());
  }
  return names;
}

class NpzReader : public Reader {
 public:
  explicit NpzReader(const std::string& path)
      : path_(path),
        archive_(openZip(path)),
        size_{sideOf(path, archive_, "width"), sideOf(path, archive_, "height")},
        t_(path, archive_, "t"),
        x_(path, archive_, "x"),
        y_(path, archive_, "y"),
        p_(path, archive_, "p"),
        label_columns_{has(archive_, "source"), has(archive_, "artefact")} {
    if (labels()) source_.emplace(path, archive_, "source"), artefact_.emplace(path, archive_, "artefact");
    checkLengths({&t_, &x_, &y_, &p_}, "t, x, y and p");
    if (labels()) checkLengths({&t_, &*source_, &*artefact_}, "t, source and artefact");
  }

  ImageSize size() const override { return size_; }
  bool labels() const override { return label_columns_.both(); }
  std::string leftOut() const override { return otherNames(archive_, label_columns_.alone()); }

  bool read(Events& events) override {
    const std::uint64_t count = std::min(kColumnBatch, t_.size() - done_);
    events.clear();
    if (count == 0) return false;
    t_.read(count, columns_.t_us), x_.read(count, columns_.x);
    y_.read(count, columns_.y), p_.read(count, columns_.p);
    if (labels()) source_->read(count, columns_.source), artefact_->read(count, columns_.artefact);
    columns_.toEvents(path_, done_, events);
    done_ += count;
    return true;
  }

 private:
  void checkLengths(std::initializer_list<const NpyColumn*> columns, const std::string& names) const {
    for (const NpyColumn* column : columns) {
      if (column->single() || column->size() != t_.size())
        throw FileFault(path_, names + " are not arrays of equal lengths");
    }
  }

  const std::string path_;
  const ZipArchive archive_;
  const ImageSize size_;
  NpyColumn t_, x_, y_, p_;
  const LabelColumns label_columns_;
  std::optional<NpyColumn> source_, artefact_;  // of labelled events
  EventColumns columns_;
  std::uint64_t done_ = 0;  // events
};

std::unique_ptr<Reader> make(const std::string& path) {
  return std::make_unique<NpzReader>(path);
}

}  // namespace

extern const ReaderInfo kNpzReader{".npz", "arrays t[us], x, y, p of NumPy", make};

}  // namespace saccade::client
