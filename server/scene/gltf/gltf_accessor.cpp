#include "scene/gltf/gltf_accessor.h"

#include <algorithm>
#include <array>
#include <cstring>

#include "base/names.h"
#include "scene/files/limits.h"

namespace saccade {
namespace {

// `norm`: of its largest whole number, 0 for floats.
struct Component {
  std::size_t code, bytes;
  double norm;
};
constexpr std::array<Component, 6> kComponents{{{5120, 1, 127},
                                                {5121, 1, 255},
                                                {5122, 2, 32767},
                                                {5123, 2, 65535},
                                                {5125, 4, 4294967295.0},
                                                {5126, 4, 0}}};

Component componentOf(const JsonNode& accessor) {
  const JsonNode node = accessor.at("componentType");
  for (const Component& row : kComponents)
    if (row.code == node.size()) return row;
  throw node.error("is not a type of numbers; there are: 5120, 5121, 5122, 5123, 5125, 5126");
}

std::size_t typeSize(const JsonNode& accessor) {
  static const std::vector<std::string> types{"SCALAR", "VEC2", "VEC3", "VEC4", "MAT4"};
  const JsonNode node = accessor.at("type");
  const auto found = std::ranges::find(types, node.text());
  if (found == types.end()) throw node.error("is not one of " + joinNames(types));
  return found + 1 == types.end() ? 16 : static_cast<std::size_t>(found - types.begin()) + 1;
}

template <class T>
double valueAt(const char* at) {
  T value;
  std::memcpy(&value, at, sizeof value);
  return static_cast<double>(value);
}

double valueOf(const Component& c, const char* at) {
  switch (c.code) {
    case 5120:
      return valueAt<std::int8_t>(at);
    case 5121:
      return valueAt<std::uint8_t>(at);
    case 5122:
      return valueAt<std::int16_t>(at);
    case 5123:
      return valueAt<std::uint16_t>(at);
    case 5125:
      return valueAt<std::uint32_t>(at);
    default:
      return valueAt<float>(at);
  }
}

// Elements that lie in a view.
class Elements {
 public:
  Elements(const JsonNode& at, const GltfBuffers& buffers, const Component& component, std::size_t size,
           std::size_t count)
      : component_(component), size_(size) {
    const auto [bytes, stride] = buffers.view(at.at("bufferView").size());
    const std::size_t offset = at.size("byteOffset", 0), element = component.bytes * size;
    stride_ = stride > 0 ? stride : element;
    if (stride_ < element) throw at.error("its elements are longer than the byteStride of its view");
    const std::size_t room = offset <= bytes.size() ? bytes.size() - offset : 0;
    if (count > 0 && (room < element || (count - 1) > (room - element) / stride_))
      throw at.error("has " + std::to_string(count) + " elements, and reaches beyond the end of its view");
    begin_ = bytes.data() + std::min(offset, bytes.size());
  }

  double at(std::size_t element, std::size_t number) const {
    return valueOf(component_, begin_ + element * stride_ + number * component_.bytes);
  }
  std::size_t size() const { return size_; }

 private:
  const Component component_;
  const std::size_t size_;
  std::size_t stride_;
  const char* begin_;
};

// An accessor without a view holds zeros, but where it is sparse.
template <class T, class Convert>
std::vector<T> readDense(const JsonNode& accessor, const GltfBuffers& buffers, const Component& component,
                         std::size_t size, std::size_t count, Convert convert) {
  if (!accessor.find("bufferView")) {
    if (count * size * sizeof(T) > kMaxMeshBytesPerByte * buffers.bytes())
      throw accessor.error("has " + std::to_string(count) + " elements without bytes");
    return std::vector<T>(count * size);
  }
  const Elements elements(accessor, buffers, component, size, count);
  std::vector<T> values(count * size);
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t k = 0; k < size; ++k) values[i * size + k] = convert(elements.at(i, k));
  return values;
}

template <class T, class Convert>
void setSparse(const JsonNode& sparse, const GltfBuffers& buffers, const Component& component,
               std::size_t count, std::size_t size, Convert convert, std::vector<T>& values) {
  const std::size_t changes = sparse.at("count").size();
  const JsonNode places = sparse.at("indices");
  const Elements indices(places, buffers, componentOf(places), 1, changes);
  const Elements changed(sparse.at("values"), buffers, component, size, changes);
  for (std::size_t i = 0; i < changes; ++i) {
    const double place = indices.at(i, 0);
    if (!(place >= 0 && place < static_cast<double>(count)))
      throw places.error("an index is beyond the elements of the accessor");
    for (std::size_t k = 0; k < size; ++k)
      values[static_cast<std::size_t>(place) * size + k] = convert(changed.at(i, k));
  }
}

template <class T, class Convert>
std::vector<T> read(const JsonNode& accessor, const GltfBuffers& buffers, const Component& component,
                    std::size_t size, Convert convert) {
  const std::size_t count = accessor.at("count").size();
  if (typeSize(accessor) != size)
    throw accessor.error("is of type " + accessor.at("type").text() + ", where " + std::to_string(size) +
                         " numbers are needed");
  std::vector<T> values = readDense<T>(accessor, buffers, component, size, count, convert);
  if (const auto sparse = accessor.find("sparse"))
    setSparse(*sparse, buffers, component, count, size, convert, values);
  return values;
}

}  // namespace

std::size_t accessorCount(const JsonNode& root, std::size_t i) {
  const JsonNode count = root.entry("accessors", i).at("count");
  if (count.size() > 3 * kMaxTriangles)
    throw count.error("is more than " + std::to_string(3 * kMaxTriangles));
  return count.size();
}

std::vector<float> readFloats(const JsonNode& root, const GltfBuffers& buffers, std::size_t i,
                              std::size_t components) {
  const JsonNode accessor = root.entry("accessors", i);
  accessorCount(root, i);
  const Component component = componentOf(accessor);
  const bool fraction = component.norm > 0 && accessor.flag("normalized", false);
  const double scale = fraction ? 1 / component.norm : 1;
  return read<float>(accessor, buffers, component, components, [&](double value) {
    return static_cast<float>(fraction ? std::max(value * scale, -1.0) : value);
  });
}

std::vector<std::uint32_t> readIndices(const JsonNode& root, const GltfBuffers& buffers, std::size_t i,
                                       std::size_t vertices) {
  const JsonNode accessor = root.entry("accessors", i);
  accessorCount(root, i);
  return read<std::uint32_t>(accessor, buffers, componentOf(accessor), 1, [&](double value) {
    if (!(value >= 0 && value < static_cast<double>(vertices)))
      throw accessor.error("an index is beyond the " + std::to_string(vertices) + " vertices");
    return static_cast<std::uint32_t>(value);
  });
}

}  // namespace saccade
