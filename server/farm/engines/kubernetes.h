// An Indexed Job for Kubernetes: a pod for each shard. Its data set lies on a volume, or in a bucket.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "farm/dataset/data_set.h"
#include "farm/engines/engine_options.h"

namespace saccade::farm {

// A bucket, or another store that rclone knows.
struct Bucket {
  std::string place = {};   // of the data set, "REMOTE:PATH"
  std::string secret = {};  // name of a Secret with the key rclone.conf, which says what REMOTE is
  std::string image = {};   // that has rclone
  int disk_gib = 10;        // for the files of a shard while a pod is at it
};

struct KubernetesOptions {
  EngineOptions engine = {};
  std::string image = {};  // of deploy/Dockerfile
  std::int64_t user = 65532;
  std::optional<int> max_failed = {};    // shards that may fail before all end; unset: all may
  std::string claim = {};                // name of a PersistentVolumeClaim; empty: `bucket` has the data set
  std::optional<std::string> path = {};  // of the data set on the volume; unset: the name of its folder
  Bucket bucket = {};
};

// The manifest, in YAML. Throws std::invalid_argument where a name or a path is none.
std::string kubernetesManifest(const DataSet& set, const KubernetesOptions& options);

// A name for objects: a DNS label whose pods, which add "-INDEX", are named by DNS labels too.
std::string jobName(const DataSet& set);

}  // namespace saccade::farm
