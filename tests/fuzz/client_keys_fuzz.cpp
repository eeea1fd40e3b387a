#include "fuzz/fuzz_target.h"
#include "saccade/wire/curve_key.h"
#include "scene/scratch.h"
#include "stream/client_keys.h"

namespace saccade {
namespace {

const std::string kKey = "Yne@$w-vo<fVvi]a<NY6T1ed:M$fCG*[IaLV{hID";  // of ZeroMQ RFC 32

// The list of clients, and a key file.
bool read(std::string_view bytes) {
  static const Scratch files;
  const std::string path = files.write("keys", std::string(bytes));
  const bool listed = accepts<std::runtime_error>([&] {
    const ClientKeys clients(path);
    for (const std::string& no_key : {std::string(), std::string("#"), kKey.substr(1)})
      SACCADE_CHECK(!clients.allow(no_key));
  });
  const bool one = accepts<std::invalid_argument>([&] { SACCADE_CHECK(isCurveKey(readCurveKey(path))); });
  SACCADE_CHECK(listed || !one);
  return listed;
}

}  // namespace

const FuzzTarget& fuzzTarget() {
  static const FuzzTarget target{
      {kKey, kKey + " alice admin # of the lab\n\n# bob is gone\n"},
      {kKey, " ", "\n", "\r\n", "\t", "# ", "#", "admin", std::string(1, '\0'), "\xff"},
      read,
      nullptr,
      2000};
  return target;
}

}  // namespace saccade
