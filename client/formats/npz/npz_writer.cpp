// NumPy's .npz: arrays t (i64 microseconds), x, y (u16) and p (u8) of equal lengths, and numbers width and
// height. This is the layout of evutils, and SpikingJelly reads it. Labels are arrays source and artefact
// (u8), as in Event, and objects an array object (u32). Truth channels have arrays beside them. See
// numpy.lib.format, and zip_archive.h.
//
// An array is one piece of the file and says its length first. So each column waits in a spool file for the
// end of the events. A part of the disk is taken at the start and given back at the end. So there is room to
// finish a file when the disk is full. A kill leaves an empty file.
#include <zlib.h>

#include <cstring>
#include <deque>
#include <optional>

#include "client/formats/common/units.h"
#include "client/formats/common/writer.h"
#include "client/formats/npz/npz_column.h"
#include "client/formats/npz/npz_truth.h"

namespace saccade::client {
namespace {

constexpr std::size_t kBlock = 1 << 16;  // events that are compressed together, at least
constexpr std::uint64_t kReserve =
    4 << 20;  // bytes: more than a block, what a spool file moves, and the headers

template <class T, class Take>
std::string bytesOf(const Events& events, Take take) {
  std::string bytes(events.size() * sizeof(T), '\0');
  char* at = bytes.data();
  for (const Event& event : events) {
    const T value = take(event);
    std::memcpy(at, &value, sizeof value);
    at += sizeof value;
  }
  return bytes;
}

std::string numberBytes(std::int64_t value) {
  return npyHeader("<i8", "()") + std::string(reinterpret_cast<const char*>(&value), sizeof value);
}

class NpzWriter : public Writer {
 public:
  NpzWriter(const std::string& path, const v1::Recording& about)
      : file_(path),
        t_(path, "t", "<i8", 8, Z_DEFAULT_STRATEGY),
        x_(path, "x", "<u2", 2, Z_RLE),
        y_(path, "y", "<u2", 2, Z_RLE),
        p_(path, "p", "|u1", 1, Z_RLE),
        width_(numberBytes(about.width())),
        height_(numberBytes(about.height())) {
    if (about.labels()) {
      source_.emplace(path, "source", "|u1", 1, Z_RLE);
      artefact_.emplace(path, "artefact", "|u1", 1, Z_RLE);
    }
    if (about.object_ids()) object_.emplace(path, "object", "<u4", 4, Z_RLE);
    for (const v1::RecordedTruth& channel : about.truth()) truth_.emplace_back(path, channel);
    reserve_.emplace(path).allocate(kReserve);
  }

  void write(const Events& events, std::int64_t) override {
    const std::size_t before = waiting_.size();
    waiting_.insert(waiting_.end(), events.begin(), events.end());
    if (waiting_.size() < kBlock) return;
    try {
      spool();
    } catch (...) {
      waiting_.resize(before);
      throw;
    }
  }

  void writeTruth(int channel, const TruthSamples& samples) override { truth_.at(channel).write(samples); }

  void finish() override {
    reserve_.reset();
    if (!waiting_.empty()) spool();
    std::vector<NpzColumn*> columns = eventColumns();
    for (NpzTruth& truth : truth_) {
      for (NpzColumn* column : truth.columns()) columns.push_back(column);
    }
    for (const NpzColumn* column : columns) place(column->member());
    place(zipMember("width.npy", width_));
    place(zipMember("height.npy", height_));
    std::size_t member = members_.size();  // from the end to the start, as the spool files move their bytes
    file_.overwrite(end_, zipDirectory(members_, end_));
    for (const std::string* number : {&height_, &width_}) {
      --member;
      file_.overwrite(members_[member].offset, zipHeader(members_[member]) + *number);
    }
    for (; !columns.empty(); columns.pop_back()) columns.back()->moveTo(file_, members_[--member]);
    file_.close();
  }

 private:
  std::vector<NpzColumn*> eventColumns() {
    std::vector<NpzColumn*> columns{&t_, &x_, &y_, &p_};
    if (source_) columns.insert(columns.end(), {&*source_, &*artefact_});
    if (object_) columns.push_back(&*object_);
    return columns;
  }

  void spool() {
    t_.spool(bytesOf<std::int64_t>(waiting_, [](const Event& event) { return event.t_ns / kNsPerUs; }));
    x_.spool(bytesOf<std::uint16_t>(waiting_, [](const Event& event) { return event.x; }));
    y_.spool(bytesOf<std::uint16_t>(waiting_, [](const Event& event) { return event.y; }));
    p_.spool(bytesOf<std::uint8_t>(waiting_, [](const Event& event) { return event.p; }));
    if (source_) {
      source_->spool(bytesOf<std::uint8_t>(waiting_, [](const Event& event) { return event.source; }));
      artefact_->spool(bytesOf<std::uint8_t>(waiting_, [](const Event& event) { return event.artefact; }));
    }
    if (object_)
      object_->spool(bytesOf<std::uint32_t>(waiting_, [](const Event& event) { return event.object; }));
    for (NpzColumn* column : eventColumns()) column->keep();
    waiting_.clear();
  }

  void place(ZipMember member) {
    member.offset = end_;
    end_ += zipHeader(member).size() + member.packed;
    members_.push_back(std::move(member));
  }

  OutputFile file_;
  NpzColumn t_, x_, y_, p_;
  std::optional<NpzColumn> source_, artefact_;  // of labelled events
  std::optional<NpzColumn> object_;             // of events with objects
  std::deque<NpzTruth> truth_;                  // by channel
  const std::string width_, height_;
  std::optional<SpoolFile> reserve_;
  Events waiting_;
  std::vector<ZipMember> members_;
  std::uint64_t end_ = 0;  // of the last member
};

std::unique_ptr<Writer> make(const std::string& path, const v1::Recording& about) {
  return std::make_unique<NpzWriter>(path, about);
}

}  // namespace

extern const WriterInfo kNpzWriter{.name = "npz",
                                   .extension = ".npz",
                                   .description = "arrays t[us], x, y, p of NumPy",
                                   .make = make,
                                   .truth = holdsAllTruth,
                                   .labels = true,
                                   .objects = true};

}  // namespace saccade::client
