#include "client/formats/hdf5/hdf5_truth.h"

#include "client/formats/common/units.h"

namespace saccade::client {
namespace {

constexpr hsize_t kRowsTogether = 1024;

hid_t typeOf(v1::Element element) {
  switch (element) {
    case v1::ELEMENT_F32:
      return H5T_IEEE_F32LE;
    case v1::ELEMENT_F64:
      return H5T_IEEE_F64LE;
    default:
      return unsignedType(bytesOf(element));
  }
}

std::vector<hsize_t> shapeOf(const v1::RecordedTruth& channel) {
  if (!isPicture(channel)) return {planesOf(channel)};
  return {channel.height(), channel.width(), planesOf(channel)};
}

Hdf5Handle makeGroup(hid_t file, const std::string& path) {
  const Hdf5Handle how(H5Pcreate(H5P_LINK_CREATE), H5Pclose);
  H5Pset_create_intermediate_group(how.id(), 1);
  Hdf5Handle group(H5Gcreate2(file, path.c_str(), how.id(), H5P_DEFAULT, H5P_DEFAULT), H5Gclose);
  checkHdf5(bool(group), path);
  return group;
}

}  // namespace

Hdf5Truth::Hdf5Truth(hid_t file, const std::string& path, const v1::RecordedTruth& channel,
                     const Hdf5Handle& filters)
    : channel_(channel),
      chunk_(isPicture(channel) ? 1 : kRowsTogether),
      group_(makeGroup(file, path)),
      t_(group_.id(), "t", H5T_STD_I64LE, {}, chunk_, filters),
      data_(group_.id(), "data", typeOf(channel.info().element()), shapeOf(channel), chunk_, filters) {
  const v1::TruthInfo& info = channel.info();
  writeAttribute(group_.id(), "unit", info.unit());
  writeAttribute(group_.id(), "description", info.description());
  writeAttribute(group_.id(), "planes", std::vector<std::string>(info.planes().begin(), info.planes().end()));
  if (!isPicture(channel)) return;
  exposure_begin_.emplace(group_.id(), "exposure_begin", H5T_STD_I64LE, std::vector<hsize_t>(), chunk_,
                          filters);
  exposure_end_.emplace(group_.id(), "exposure_end", H5T_STD_I64LE, std::vector<hsize_t>(), chunk_, filters);
}

void Hdf5Truth::write(const TruthSamples& samples) {
  for (const TruthSample& sample : samples) {
    times_us_.push_back(sample.t_ns / kNsPerUs);
    begins_us_.push_back(sample.exposure_begin_ns / kNsPerUs);
    ends_us_.push_back(sample.exposure_end_ns / kNsPerUs);
    bytes_ += interleaved(channel_, sample.elements);
    if (times_us_.size() == chunk_) flush();
  }
}

void Hdf5Truth::flush() {
  const hsize_t count = times_us_.size();
  if (count == 0) return;
  t_.append(times_us_.data(), count);
  data_.append(bytes_.data(), count);
  if (exposure_begin_) exposure_begin_->append(begins_us_.data(), count);
  if (exposure_end_) exposure_end_->append(ends_us_.data(), count);
  times_us_.clear(), begins_us_.clear(), ends_us_.clear(), bytes_.clear();
}

}  // namespace saccade::client
