#include "app/request/refusal.h"
#include "app/request/resolve_trajectory.h"
#include "fuzz/fuzz_target.h"
#include "fuzz/message_mutator.h"
#include "fuzz/path_check.h"

namespace saccade {
namespace {

bool read(std::string_view bytes) {
  ResolvedStream stream;
  v1::Keyframes& keyframes = *stream.request.mutable_trajectory()->mutable_keyframes();
  if (!keyframes.ParseFromArray(bytes.data(), static_cast<int>(bytes.size()))) return false;
  return accepts<Refusal>([&] {
    checkTrajectory(stream, {});
    checkPath(*stream.given_path, TimeNs{0});
  });
}

}  // namespace

const FuzzTarget& fuzzTarget() {
  static const FuzzTarget target{
      {bytesOf<v1::Keyframes>("keys { rotation { w: 1 } }"),
       bytesOf<v1::Keyframes>(
           "interpolation: INTERPOLATION_CUBIC keys { time_s: -1 position { x: 1 } rotation { w: 1 } } "
           "keys { position { y: 2 } rotation { x: 1 } } keys { time_s: 0.5 rotation { z: -3 w: 4 } }")},
      {"\x09", "\x12", "\x1a", "\x12\x00", "\x08\x02"},
      read,
      [](const std::string& bytes, Draws& draw) { return mutateBytesOf<v1::Keyframes>(bytes, {""}, draw); },
      10000};
  return target;
}

}  // namespace saccade
