// saccade-farm kubernetes
#include <memory>

#include "farm/commands/commands.h"
#include "farm/commands/engine_command.h"
#include "farm/engines/kubernetes.h"
#include "farm/recipe/recipe.h"

namespace saccade::farm {
namespace {

void addPlaceOptions(CLI::App& command, KubernetesOptions& options) {
  CLI::Option* claim =
      command.add_option("--claim", options.claim, "PersistentVolumeClaim whose volume has the data set");
  command
      .add_option("--path", options.path, "of the data set on the volume; otherwise the name of its folder")
      ->needs(claim);
  CLI::Option* bucket =
      command.add_option("--bucket", options.bucket.place, "of the data set for rclone: REMOTE:PATH")
          ->excludes(claim);
  CLI::Option* secret = command.add_option("--rclone-secret", options.bucket.secret,
                                           "Secret whose key rclone.conf says what REMOTE is");
  bucket->needs(secret), secret->needs(bucket);
  command.add_option("--rclone-image", options.bucket.image, "image that has rclone")
      ->needs(bucket)
      ->capture_default_str();
  command.add_option("--disk", options.bucket.disk_gib, "disk of a pod for the files of a shard, in GiB")
      ->needs(bucket)
      ->check(CLI::Range(1, 1 << 20))
      ->capture_default_str();
}

void writeKubernetes(const EngineCommand& common, KubernetesOptions& options) {
  if (options.claim.empty() && options.bucket.place.empty())
    throw CLI::RequiredError("--claim or --bucket, where the data set is,");
  const DataSet set(common.folder);
  options.engine = engineOf(common, false);
  writeEngine(common, kubernetesManifest(set, options));
}

}  // namespace

void addKubernetesCommand(CLI::App& app, int& status) {
  CLI::App* command =
      app.add_subcommand("kubernetes", "write an Indexed Job for Kubernetes: kubectl apply -f FILE");
  const auto common = std::make_shared<EngineCommand>();
  const auto options = std::make_shared<KubernetesOptions>();
  options->bucket.image = "docker.io/rclone/rclone:1";
  common->engine.parallel = 8;
  addCommonOptions(*command, *common);
  addParallelOption(*command, *common);
  command->add_option("--image", options->image, "image of deploy/Dockerfile")->required();
  addPlaceOptions(*command, *options);
  command
      ->add_option("--max-failed", options->max_failed,
                   "shards that may fail before all end; otherwise all may")
      ->check(CLI::Range(0, static_cast<int>(kMostShards)));
  command->add_option("--user", options->user, "number of the user and the group that own the data set")
      ->check(CLI::Range(std::int64_t{1}, std::int64_t{2147483647}))
      ->capture_default_str();
  command->footer(
      "--scenes, --meshes and --bakes are folders in the container. Its own scenes are there without them.");
  command->callback([=, &status] { writeKubernetes(*common, *options), status = 0; });
}

}  // namespace saccade::farm
