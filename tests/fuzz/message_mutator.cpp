#include "fuzz/message_mutator.h"

#include <bit>
#include <limits>

namespace saccade {
namespace {

using google::protobuf::FieldDescriptor;
using google::protobuf::Message;
using google::protobuf::Reflection;

std::uint64_t oddInteger(Draws& draw) {
  constexpr std::uint64_t kOdd[] = {0, 1, 2, ~0ull, 1ull << 31, (1ull << 31) - 1, ~0ull >> 1, 1ull << 63};
  return draw.oneIn(3) ? draw.bits() >> draw.below(64) : kOdd[draw.below(std::size(kOdd))];
}

double oddNumber(Draws& draw) {
  using Limits = std::numeric_limits<double>;
  constexpr double kOdd[] = {0,
                             -0.,
                             1,
                             -1,
                             0.1,
                             1e-3,
                             1e-9,
                             1e3,
                             1e7,
                             1e9,
                             -1e9,
                             1e-300,
                             1e300,
                             Limits::max(),
                             Limits::denorm_min(),
                             Limits::infinity(),
                             -Limits::infinity(),
                             Limits::quiet_NaN()};
  return draw.oneIn(3) ? std::bit_cast<double>(draw.bits()) : kOdd[draw.below(std::size(kOdd))];
}

std::string oddText(const std::vector<std::string>& words, Draws& draw) {
  std::string text = words[draw.below(words.size())];
  if (draw.oneIn(4)) text.insert(draw.below(text.size() + 1), words[draw.below(words.size())]);
  if (draw.oneIn(4)) text.resize(draw.below(text.size() + 1));
  if (draw.oneIn(8) && !text.empty()) text[draw.below(text.size())] = static_cast<char>(draw.bits());
  return text;
}

// A value for a field that is none of messages.
class Value {
 public:
  Value(Message& message, const FieldDescriptor& field) : message_(message), field_(field) {}

  void put(const std::vector<std::string>& words, Draws& draw) {
    switch (field_.cpp_type()) {
      case FieldDescriptor::CPPTYPE_INT32:
        return put<std::int32_t>(oddInteger(draw), &Reflection::SetInt32, &Reflection::AddInt32);
      case FieldDescriptor::CPPTYPE_INT64:
        return put<std::int64_t>(oddInteger(draw), &Reflection::SetInt64, &Reflection::AddInt64);
      case FieldDescriptor::CPPTYPE_UINT32:
        return put<std::uint32_t>(oddInteger(draw), &Reflection::SetUInt32, &Reflection::AddUInt32);
      case FieldDescriptor::CPPTYPE_UINT64:
        return put<std::uint64_t>(oddInteger(draw), &Reflection::SetUInt64, &Reflection::AddUInt64);
      case FieldDescriptor::CPPTYPE_DOUBLE:
        return put<double>(oddNumber(draw), &Reflection::SetDouble, &Reflection::AddDouble);
      case FieldDescriptor::CPPTYPE_BOOL:
        return put<bool>(draw.oneIn(2), &Reflection::SetBool, &Reflection::AddBool);
      case FieldDescriptor::CPPTYPE_ENUM:  // and one more than there are
        return put<int>(draw.below(field_.enum_type()->value_count() + 1), &Reflection::SetEnumValue,
                        &Reflection::AddEnumValue);
      case FieldDescriptor::CPPTYPE_STRING:
        return put<std::string>(oddText(words, draw), &Reflection::SetString, &Reflection::AddString);
      default:
        SACCADE_CHECK(!"a type that the schema has not had so far");
    }
  }

 private:
  template <class T, class Given>
  void put(const Given& value, void (Reflection::*set)(Message*, const FieldDescriptor*, T) const,
           void (Reflection::*add)(Message*, const FieldDescriptor*, T) const) {
    (message_.GetReflection()->*(field_.is_repeated() ? add : set))(&message_, &field_,
                                                                    static_cast<T>(value));
  }
  Message& message_;
  const FieldDescriptor& field_;
};

void shuffleRepeated(Message& message, const FieldDescriptor& field, int count, Draws& draw) {
  const Reflection& reflection = *message.GetReflection();
  const auto any = [&] { return static_cast<int>(draw.below(static_cast<std::size_t>(count))); };
  reflection.SwapElements(&message, &field, any(), any());
  if (draw.oneIn(2)) reflection.RemoveLast(&message, &field);
}

// The message of a field to go on in: a new one, or one that is there.
Message& inner(Message& message, const FieldDescriptor& field, int count, Draws& draw) {
  const Reflection& reflection = *message.GetReflection();
  if (!field.is_repeated()) return *reflection.MutableMessage(&message, &field);
  if (count == 0 || draw.oneIn(4)) return *reflection.AddMessage(&message, &field);
  return *reflection.MutableRepeatedMessage(&message, &field,
                                            static_cast<int>(draw.below(static_cast<std::size_t>(count))));
}

}  // namespace

void mutateMessage(Message& message, const std::vector<std::string>& words, Draws& draw) {
  const auto& type = *message.GetDescriptor();
  if (type.field_count() == 0) return;
  const Reflection& reflection = *message.GetReflection();
  std::vector<const FieldDescriptor*> set;
  reflection.ListFields(message, &set);
  // Mostly what is there: of a oneof anything else would take the place of it.
  const bool any = set.empty() || draw.oneIn(3);
  const FieldDescriptor& field =
      any ? *type.field(static_cast<int>(draw.below(static_cast<std::size_t>(type.field_count()))))
          : *set[draw.below(set.size())];
  const int count = field.is_repeated() ? reflection.FieldSize(message, &field) : 0;
  if (!any && draw.oneIn(12)) return reflection.ClearField(&message, &field);
  if (count > 0 && draw.oneIn(4)) return shuffleRepeated(message, field, count, draw);
  if (field.cpp_type() != FieldDescriptor::CPPTYPE_MESSAGE) return Value(message, field).put(words, draw);
  mutateMessage(inner(message, field, count, draw), words, draw);
}

}  // namespace saccade
