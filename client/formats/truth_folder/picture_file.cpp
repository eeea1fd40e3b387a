#include "client/formats/truth_folder/picture_file.h"

#include "client/formats/common/truth_layout.h"
#include "pictures/library.h"

namespace saccade::client {
namespace {

pictures::Number numberOf(v1::Element element) {
  switch (element) {
    case v1::ELEMENT_U8:
      return pictures::Number::kU8;
    case v1::ELEMENT_U16:
      return pictures::Number::kU16;
    case v1::ELEMENT_U32:
      return pictures::Number::kU32;
    case v1::ELEMENT_F64:
      return pictures::Number::kF64;
    default:
      return pictures::Number::kF32;
  }
}

pictures::Shape shapeOf(const v1::RecordedTruth& channel) {
  return {static_cast<int>(channel.width()),
          static_cast<int>(channel.height()),
          {channel.info().planes().begin(), channel.info().planes().end()},
          numberOf(channel.info().element())};
}

}  // namespace

const char* pictureExtension(const v1::RecordedTruth& channel) {
  const v1::Element element = channel.info().element();
  return element == v1::ELEMENT_U8 || element == v1::ELEMENT_U16 ? ".png" : ".exr";
}

void writePicture(const std::string& path, const v1::RecordedTruth& channel, const std::string& elements) {
  pictures::library().write(path, shapeOf(channel), interleaved(channel, elements).data());
}

}  // namespace saccade::client
