#include "client/writers/picture_file.h"

#include <OpenImageIO/imageio.h>

#include <stdexcept>

#include "client/writers/truth_layout.h"

namespace saccade::client {
namespace {

OIIO::TypeDesc typeOf(v1::Element element) {
  switch (element) {
    case v1::ELEMENT_U8:
      return OIIO::TypeDesc::UINT8;
    case v1::ELEMENT_U16:
      return OIIO::TypeDesc::UINT16;
    case v1::ELEMENT_U32:
      return OIIO::TypeDesc::UINT32;
    case v1::ELEMENT_F64:
      return OIIO::TypeDesc::DOUBLE;
    default:
      return OIIO::TypeDesc::FLOAT;
  }
}

OIIO::ImageSpec specOf(const v1::RecordedTruth& channel) {
  const OIIO::TypeDesc type = typeOf(channel.info().element());
  OIIO::ImageSpec spec(static_cast<int>(channel.width()), static_cast<int>(channel.height()),
                       channel.info().planes_size(),
                       type == OIIO::TypeDesc::DOUBLE ? OIIO::TypeDesc::FLOAT : type);
  spec.channelnames.assign(channel.info().planes().begin(), channel.info().planes().end());
  spec.alpha_channel = -1;
  spec.attribute("oiio:UnassociatedAlpha", 1);        // a fourth plane changes no other
  spec.attribute("DateTime", "1980:01:01 00:00:00");  // none is known: a sample has the same bytes always
  return spec;
}

}  // namespace

const char* pictureExtension(const v1::RecordedTruth& channel) {
  const v1::Element element = channel.info().element();
  return element == v1::ELEMENT_U8 || element == v1::ELEMENT_U16 ? ".png" : ".exr";
}

void writePicture(const std::string& path, const v1::RecordedTruth& channel, const std::string& elements) {
  const auto file = OIIO::ImageOutput::create(path);
  const std::string pixels = interleaved(channel, elements);
  const bool done = file && file->open(path, specOf(channel)) &&
                    file->write_image(typeOf(channel.info().element()), pixels.data()) && file->close();
  if (!done) throw std::runtime_error(path + ": " + (file ? file->geterror() : OIIO::geterror()));
}

}  // namespace saccade::client
