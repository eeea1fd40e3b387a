#include "client/formats/npz/npz_truth.h"

#include "client/formats/common/little_endian.h"
#include "client/formats/common/units.h"

namespace saccade::client {
namespace {

const char* typeOf(v1::Element element) {
  switch (element) {
    case v1::ELEMENT_U8:
      return "|u1";
    case v1::ELEMENT_U16:
      return "<u2";
    case v1::ELEMENT_U32:
      return "<u4";
    case v1::ELEMENT_F64:
      return "<f8";
    default:
      return "<f4";
  }
}

std::string shapeOf(const v1::RecordedTruth& channel) {
  const std::string planes = std::to_string(planesOf(channel));
  if (!isPicture(channel)) return planes;
  return std::to_string(channel.height()) + ", " + std::to_string(channel.width()) + ", " + planes;
}

}  // namespace

NpzTruth::NpzTruth(const std::string& path, const v1::RecordedTruth& channel)
    : channel_(channel),
      t_(path, channel.name() + "_t", "<i8", 8, Z_DEFAULT_STRATEGY),
      data_(path, channel.name(), typeOf(channel.info().element()), sampleBytes(channel), Z_DEFAULT_STRATEGY,
            shapeOf(channel)) {
  if (isPicture(channel))
    exposure_.emplace(path, channel.name() + "_exposure", "<i8", 16, Z_DEFAULT_STRATEGY, "2");
}

void NpzTruth::write(const TruthSamples& samples) {
  std::string times, data, exposures;
  for (const TruthSample& sample : samples) {
    appendBytes<std::int64_t>(times, sample.t_ns / kNsPerUs);
    appendBytes<std::int64_t>(exposures, sample.exposure_begin_ns / kNsPerUs);
    appendBytes<std::int64_t>(exposures, sample.exposure_end_ns / kNsPerUs);
    data += interleaved(channel_, sample.elements);
  }
  t_.spool(times);
  data_.spool(data);
  if (exposure_) exposure_->spool(exposures);
  for (NpzColumn* column : columns()) column->keep();
}

std::vector<NpzColumn*> NpzTruth::columns() {
  std::vector<NpzColumn*> columns{&data_, &t_};
  if (exposure_) columns.push_back(&*exposure_);
  return columns;
}

}  // namespace saccade::client
