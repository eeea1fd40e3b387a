// saccaded as a program of its own, on free ports of loopback, and what it takes of the machine.
#pragma once

#include <string>
#include <vector>

#include "mock/mock_client.h"
#include "mock/process.h"

namespace saccade {

#ifndef __has_feature  // as Clang says it
#define __has_feature(x) 0
#endif
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__) || __has_feature(thread_sanitizer) || \
    __has_feature(address_sanitizer)
inline constexpr bool kSanitized = true;
#else
inline constexpr bool kSanitized = false;
#endif

struct Usage {
  std::int64_t resident_bytes = 0;  // 0 where kSanitized: sanitizers keep what is freed
  int fds = 0, threads = 0;
};

class ServerProcess {
 public:
  // One thread that renders, and PACED streams are not measured, unless `flags` say otherwise. `before`: what
  // to run it under, such as
  // {"/bin/sh",
  // "-c", ...}. Throws std::runtime_error where it does not become ready.
  explicit ServerProcess(const std::vector<std::string>& flags = {},
                         const std::vector<std::string>& before = {});

  const std::string& control() const { return control_; }
  const std::string& data() const { return data_; }
  const std::string& broadcast() const { return broadcast_; }
  const std::string& http() const { return http_; }
  Usage usage() const;
  Process& process() { return process_; }

 private:
  std::string endpointAfter(const std::string& word);  // in the `ready` line

  Process process_;
  const std::string ready_, control_, data_, broadcast_, http_;
};

}  // namespace saccade
