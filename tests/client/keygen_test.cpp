#include "client/commands/keygen.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <stdexcept>
#include <zmq.hpp>

#include "saccade/wire/curve_key.h"
#include "scratch_folder.h"

namespace saccade::client {
namespace {

TEST(Keygen, WritesAPairOfWhichOneIsSecret) {
  const ScratchFolder folder;
  const std::string name = folder.at("alice");
  writeKeyPair(name);
  char public_key[41];
  ASSERT_EQ(zmq_curve_public(public_key, readCurveKey(name + ".key").c_str()), 0);
  EXPECT_EQ(readCurveKey(name + ".pub"), public_key);
  struct stat status;
  ASSERT_EQ(stat((name + ".key").c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 0777u, 0600u);
}

TEST(Keygen, ASecretKeyThatAllMayReadIsWarnedAbout) {
  const ScratchFolder folder;
  const std::string file = folder.at("alice.key");
  writeKeyPair(folder.at("alice"));
  EXPECT_EQ(warningOfOpenKey(file), "");
  ASSERT_EQ(chmod(file.c_str(), 0640), 0);  // of a group that an operator made for it
  EXPECT_EQ(warningOfOpenKey(file), "");
  ASSERT_EQ(chmod(file.c_str(), 0644), 0);
  EXPECT_NE(warningOfOpenKey(file).find(file), std::string::npos);
}

TEST(Keygen, OverwritesNothing) {
  const ScratchFolder folder;
  const std::string name = folder.at("alice");
  writeKeyPair(name);
  const std::string before = readCurveKey(name + ".key");
  EXPECT_THROW(writeKeyPair(name), std::runtime_error);
  EXPECT_EQ(readCurveKey(name + ".key"), before);
  EXPECT_THROW(readCurveKey(folder.at("none")), std::invalid_argument);
}

}  // namespace
}  // namespace saccade::client
