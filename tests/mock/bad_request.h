// Requests for streams that a server has to refuse, each with what it must say.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "mock/test_server.h"

namespace saccade {

struct BadRequest {
  v1::OpenStream request;
  std::function<void(v1::OpenStream&)> spoil;
  v1::Code code;
  std::string field, told;  // `told` is part of the message
};

inline void expectRefused(TestServer& server, const std::vector<BadRequest>& all) {
  for (BadRequest bad : all) {
    bad.spoil(bad.request);
    SCOPED_TRACE(bad.request.ShortDebugString());
    const v1::Status status = server.client().tryOpen(bad.request);
    EXPECT_EQ(status.code(), bad.code) << status.message();
    EXPECT_EQ(status.field(), bad.field) << status.message();
    EXPECT_NE(status.message().find(bad.told), std::string::npos) << status.message();
  }
}

}  // namespace saccade
