// Writes files of events and reads them back, for the tests of formats.
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "client/formats/common/reader.h"
#include "client/formats/common/writer.h"
#include "scratch_folder.h"

namespace saccade::client {

class FormatTest : public testing::Test {
 protected:
  std::string at(const std::string& name) const { return folder_.at(name); }

  static v1::Recording aboutOf(std::uint32_t width, std::uint32_t height) {
    v1::Recording about;
    about.set_width(width);
    about.set_height(height);
    return about;
  }

  // Writes the batches; the stream ends at `until_ns`.
  void write(const WriterInfo& format, const std::string& file, const std::vector<Events>& batches,
             std::int64_t until_ns, const v1::Recording& about) const {
    const auto writer = format.make(file, about);
    for (const Events& batch : batches) {
      if (!batch.empty()) writer->write(batch, batch.back().t_ns);
    }
    writer->write({}, until_ns);
    writer->finish();
  }

  // The fault of a file; "none" if all of it can be read.
  static std::string faultOf(const ReaderInfo& format, const std::string& file) {
    try {
      readBack(*format.make(file));
    } catch (const FileFault& fault) {
      return fault.what();
    }
    return "none";
  }

  static Events readBack(Reader& reader) {
    Events all;
    for (Events batch; reader.read(batch);) all.insert(all.end(), batch.begin(), batch.end());
    return all;
  }

  const ScratchFolder folder_;
};

}  // namespace saccade::client
