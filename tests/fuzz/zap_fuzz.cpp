#include "fuzz/fuzz_target.h"
#include "fuzz/inputs.pb.h"
#include "fuzz/message_mutator.h"
#include "scene/scratch.h"
#include "stream/zap_handler.h"

namespace saccade {
namespace {

const std::string kKey(32, '\0');                                      // in bytes, as libzmq hands it on
const std::string kText = "0000000000000000000000000000000000000000";  // and in Z85

std::string request(const std::string& mechanism, const std::string& key) {
  fuzz::ZapRequest zap;
  for (const std::string& part : {std::string("1.0"), std::string("7"), std::string("saccade"),
                                  std::string("127.0.0.1"), std::string("id"), mechanism, key}) {
    zap.add_parts(part);
  }
  return zap.SerializeAsString();
}

bool read(std::string_view bytes) {
  static const Scratch files;
  static const ClientKeys clients(files.write("clients", kText + " alice\n"));
  fuzz::ZapRequest zap;
  if (!zap.ParseFromArray(bytes.data(), static_cast<int>(bytes.size()))) return false;
  const std::vector<std::string> parts(zap.parts().begin(), zap.parts().end());
  const auto answer = answerZap(parts, clients);
  SACCADE_CHECK(answer.size() == 6 && answer[0] == "1.0" && answer[1] == (parts.size() > 1 ? parts[1] : ""));
  const bool in = answer[2] == "200";
  SACCADE_CHECK(in ? answer[4] == kText && parts.at(5) == "CURVE" && parts.at(6) == kKey
                   : answer[2] == "400");
  return in;
}

}  // namespace

const FuzzTarget& fuzzTarget() {
  static const std::vector<std::string> words{"", "1.0", "2.0", "CURVE", "NULL", "PLAIN", kKey, kText};
  static const FuzzTarget target{
      {request("CURVE", kKey)}, words, read, [](const std::string& bytes, Draws& draw) {
        return mutateBytesOf<fuzz::ZapRequest>(bytes, words, draw);
      }};
  return target;
}

}  // namespace saccade
