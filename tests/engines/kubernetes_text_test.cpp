#include <gtest/gtest.h>

#include <stdexcept>

#include "engines/planned_set.h"
#include "farm/engines/kubernetes.h"
#include "farm/engines/manifest_text.h"

namespace saccade::farm {
namespace {

KubernetesOptions onVolume() {
  return {.image = "example.org/saccade:1", .claim = "sets"};
}

std::string nameOf(const std::string& name, std::uint32_t shards = 20) {
  return jobName(PlannedSet(shards, "set", name).set());
}

TEST(JobName, IsALabelOfDns) {
  EXPECT_EQ(nameOf("indoor"), "indoor-01234567");
  EXPECT_EQ(nameOf("__Indoor_FLOW"), "indoor-flow-01234567");
  EXPECT_EQ(nameOf("___"), "dataset-01234567");
  EXPECT_EQ(nameOf("a; rm -rf /\n"), "a--rm--rf-01234567");
  EXPECT_EQ(nameOf(std::string(64, 'x')).size() + std::string("-19").size(), 63u);
  EXPECT_EQ(nameOf(std::string(64, 'x'), 100000).size() + std::string("-99999").size(), 62u);
}

TEST(Literal, IsNotExpandedByKubernetes) {
  EXPECT_EQ(literal("$x ${x} 5$"), "\"$x ${x} 5$\"");
  EXPECT_EQ(literal("$(x) $$"), "\"$$(x) $$$\"");
  EXPECT_EQ(literalBlock("a $(b)\n\nc\n", 2), "|\n  a $$(b)\n\n  c");
}

TEST(KubernetesManifest, TakesNoPathOutOfTheVolume) {
  const PlannedSet planned(3);
  const auto textOf = [&](const std::string& path) {
    KubernetesOptions options = onVolume();
    options.path = path;
    return kubernetesManifest(planned.set(), options);
  };
  EXPECT_NE(textOf("a b/c; d").find("subPath: \"a b/c; d\"\n"), std::string::npos);
  EXPECT_EQ(textOf(".").find("subPath"), std::string::npos);
  for (const char* path : {"/sets", "..", "a/../../b", "a\nb", "\xff"})
    EXPECT_THROW(textOf(path), std::invalid_argument) << path;
}

TEST(KubernetesManifest, NamesTheFolderOnTheVolumeAsItIsNamedHere) {
  const PlannedSet planned(3, "in; $(x) \"door\"");
  const std::string line = "subPath: \"in; $(x) \\\"door\\\"\"\n";
  EXPECT_NE(kubernetesManifest(planned.set(), onVolume()).find(line), std::string::npos);
  EXPECT_NE(kubernetesManifest(DataSet(planned.path() + "/"), onVolume()).find(line), std::string::npos);
  EXPECT_THROW(kubernetesManifest(PlannedSet(3, "a\nb").set(), onVolume()), std::invalid_argument);
}

TEST(KubernetesManifest, RefusesNamesOfNoObject) {
  const PlannedSet planned(3);
  for (const char* name : {"A", "a_b", "-a", "a-", "a..b", "a\nb", "a;b"}) {
    KubernetesOptions options = onVolume();
    options.claim = name;
    EXPECT_THROW(kubernetesManifest(planned.set(), options), std::invalid_argument) << name;
    options.claim = "", options.bucket = {.place = "s3:sets", .secret = name, .image = "rclone"};
    EXPECT_THROW(kubernetesManifest(planned.set(), options), std::invalid_argument) << name;
  }
}

TEST(KubernetesManifest, RefusesBucketsThatRcloneWouldNotKnow) {
  const PlannedSet planned(3);
  KubernetesOptions options{.image = "i", .bucket = {.secret = "rclone", .image = "rclone"}};
  for (const char* place : {"", "sets", "-x:y", "s3:a\nb"}) {
    options.bucket.place = place;
    EXPECT_THROW(kubernetesManifest(planned.set(), options), std::invalid_argument) << place;
  }
  options.bucket.place = "s3:sets/$(x) \"y\"";
  EXPECT_NE(kubernetesManifest(planned.set(), options).find("value: \"s3:sets/$$(x) \\\"y\\\"\"\n"),
            std::string::npos);
}

TEST(KubernetesManifest, KeepsParallelismAndFailuresWithinTheShards) {
  KubernetesOptions options = onVolume();
  options.engine.parallel = 8, options.max_failed = 50;
  const std::string text = kubernetesManifest(PlannedSet(3).set(), options);
  for (const char* line :
       {"completions: 3\n", "parallelism: 3\n", "maxFailedIndexes: 3\n", "backoffLimitPerIndex: 3\n"})
    EXPECT_NE(text.find(line), text.npos) << line;
}

}  // namespace
}  // namespace saccade::farm
