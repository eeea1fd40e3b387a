// The module: all that knows OpenImageIO.
#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <array>
#include <stdexcept>
#include <string_view>

#include "pictures/module.h"

namespace saccade::pictures {
namespace {

using OIIO::ImageInput;
using OIIO::ImageOutput;
using OIIO::ImageSpec;
using OIIO::TypeDesc;

constexpr std::string_view kNotePrefix = "saccade:";

struct NumberType {
  Number number;
  TypeDesc::BASETYPE type;
};
constexpr std::array kNumberTypes{
    NumberType{Number::kU8, TypeDesc::UINT8},   NumberType{Number::kU16, TypeDesc::UINT16},
    NumberType{Number::kU32, TypeDesc::UINT32}, NumberType{Number::kF16, TypeDesc::HALF},
    NumberType{Number::kF32, TypeDesc::FLOAT},  NumberType{Number::kF64, TypeDesc::DOUBLE},
};

Number numberOf(const TypeDesc& type) {
  for (const auto& [number, known] : kNumberTypes)
    if (type.basetype == known) return number;
  return Number::kOtherWhole;
}

TypeDesc typeOf(Number number) {
  for (const auto& [known, type] : kNumberTypes)
    if (number == known) return type;
  throw std::logic_error("pictures have no such numbers");
}

Shape shapeOf(const ImageSpec& spec) {
  Shape shape{spec.width, spec.height, spec.channelnames, numberOf(spec.format), spec.alpha_channel};
  shape.multiplied = shape.alpha >= 0 && spec.get_int_attribute("oiio:UnassociatedAlpha") == 0;
  for (const auto& attribute : spec.extra_attribs) {
    const std::string name = attribute.name().string();
    if (name.starts_with(kNotePrefix)) shape.notes[name.substr(kNotePrefix.size())] = attribute.get_int();
  }
  return shape;
}

ImageSpec specOf(const Shape& shape) {
  const Number number = shape.number == Number::kF64 ? Number::kF32 : shape.number;
  ImageSpec spec(shape.width, shape.height, static_cast<int>(shape.channels.size()), typeOf(number));
  spec.channelnames = shape.channels;
  spec.alpha_channel = shape.alpha;
  spec.attribute("oiio:UnassociatedAlpha", 1);        // a fourth channel changes no other
  spec.attribute("DateTime", "1980:01:01 00:00:00");  // none is known: equal pictures have equal bytes
  for (const auto& [name, value] : shape.notes) spec.attribute(std::string(kNotePrefix) + name, value);
  return spec;
}

[[noreturn]] void fail(const std::string& path, const std::string& reason) {
  throw std::runtime_error(path + ": " + reason);
}

// Whether the frames of a video or the pages of a scan are in one file. Parts of OpenEXR are layers of a
// picture.
bool holdsSeveral(ImageInput& input) {
  const std::string_view format = input.format_name();
  if (format != "gif" && format != "tiff") return false;
  const bool several = input.seek_subimage(1, 0);
  if (!several) input.geterror();  // clears it
  input.seek_subimage(0, 0);
  return several;
}

// By the first bytes; empty of another format.
std::string formatOf(std::string_view bytes) {
  if (bytes.starts_with("\x89PNG")) return "png";
  if (bytes.starts_with("\xff\xd8")) return "jpg";
  return bytes.starts_with("RIFF") && bytes.substr(0, 12).ends_with("WEBP") ? "webp" : "";
}

class File final : public Input {
 public:
  // Of a picture of this format in `memory`, if there is one.
  explicit File(const std::string& path, std::unique_ptr<OIIO::Filesystem::IOMemReader> memory = nullptr,
                const std::string& format = {})
      : path_(path), memory_(std::move(memory)) {
    ImageSpec config;
    config.attribute("oiio:UnassociatedAlpha", 1);  // otherwise OpenImageIO multiplies colours by alpha
    OIIO::Filesystem::IOProxy* proxy = memory_.get();
    if (memory_) config.attribute("oiio:ioproxy", TypeDesc::PTR, &proxy);
    input_ = ImageInput::open(format.empty() ? path : "memory." + format, &config);
    if (!input_) fail(path, OIIO::geterror());
    const ImageSpec& spec = input_->spec();
    if (spec.depth != 1 || spec.deep) fail(path, "is not flat: its pixels have depth");
    shape_ = shapeOf(spec);
    shape_.several = holdsSeveral(*input_);
  }

  void read(int first, int count, float* to, std::size_t pixel_bytes) override {
    const auto stride = static_cast<OIIO::stride_t>(pixel_bytes);
    if (!input_->read_image(0, 0, first, first + count, TypeDesc::FLOAT, to, stride))
      fail(path_, input_->geterror());
  }

 private:
  const std::string path_;
  std::unique_ptr<OIIO::Filesystem::IOMemReader> memory_;
  std::unique_ptr<ImageInput> input_;
};

void put(ImageOutput* output, const std::string& path, const Shape& shape, const void* numbers) {
  if (!output) fail(path, OIIO::geterror());
  const bool done = output->open(path, specOf(shape)) && output->write_image(typeOf(shape.number), numbers) &&
                    output->close();
  if (!done) fail(path, output->geterror());
}

class OpenImageIo final : public Library {
 public:
  bool canRead(const std::string& path) const override {
    const auto input = ImageInput::create(path);
    if (!input) OIIO::geterror();  // clears it
    return input && std::string_view(input->format_name()) != "FFmpeg movie";
  }

  std::unique_ptr<Input> open(const std::string& path) const override { return std::make_unique<File>(path); }

  std::unique_ptr<Input> openBytes(std::string_view bytes, const std::string& name) const override {
    const std::string format = formatOf(bytes);
    if (format.empty()) fail(name, "is not a PNG, JPEG or WebP picture");
    auto memory =
        std::make_unique<OIIO::Filesystem::IOMemReader>(const_cast<char*>(bytes.data()), bytes.size());
    return std::make_unique<File>(name, std::move(memory), format);
  }

  void write(const std::string& path, const Shape& shape, const void* numbers) const override {
    put(ImageOutput::create(path).get(), path, shape, numbers);
  }

  std::string encodePng(const Shape& shape, const void* numbers) const override {
    std::vector<unsigned char> bytes;
    OIIO::Filesystem::IOVecOutput memory(bytes);
    const auto output = ImageOutput::create("png");
    if (output) output->set_ioproxy(&memory);
    put(output.get(), "memory.png", shape, numbers);
    return {bytes.begin(), bytes.end()};
  }
};

}  // namespace

const Library* saccadePictures2() {
  static const OpenImageIo library;
  return &library;
}

}  // namespace saccade::pictures
