#include "farm/engines/kubernetes.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <stdexcept>

#include "farm/engines/bucket.h"
#include "farm/engines/manifest_text.h"
#include "farm/engines/text.h"

namespace saccade::farm {
namespace {

constexpr std::size_t kMostLabelLetters = 63;
constexpr std::size_t kDigestLetters = 8;  // of the recipe, in names: those of two data sets differ

constexpr const char* kJob = R"text(# Makes the data set @PLAIN_NAME@: kubectl apply -f THIS_FILE
apiVersion: batch/v1
kind: Job
metadata:
  name: @JOB@
  labels: &labels
    app.kubernetes.io/name: saccade-farm
    app.kubernetes.io/instance: @JOB@
spec:
  completionMode: Indexed
  completions: @SHARDS@
  parallelism: @PARALLEL@
  backoffLimitPerIndex: @RETRIES@
  maxFailedIndexes: @MAX_FAILED@
  podFailurePolicy:
    rules:
      - action: Ignore  # a pod that was evicted is no try
        onPodConditions:
          - type: DisruptionTarget
            status: "True"
      - action: FailIndex  # what no other try can mend
        onExitCodes:
          containerName: worker
          operator: In
          values: [2, 78]
  template:
    metadata:
      labels: *labels
    spec:
      restartPolicy: Never
      terminationGracePeriodSeconds: @GRACE@
      automountServiceAccountToken: false
      enableServiceLinks: false
      securityContext:
        runAsNonRoot: true
        runAsUser: @USER@
        runAsGroup: @USER@
        fsGroup: @USER@
        fsGroupChangePolicy: OnRootMismatch
        seccompProfile:
          type: RuntimeDefault@INIT@
      containers:
        - name: worker
          image: @IMAGE@@COMMAND@
          resources:
            requests: &resources
              cpu: @CPUS@
              memory: @MEMORY@Mi@DISK@
            limits: *resources
          securityContext:
            allowPrivilegeEscalation: false
            readOnlyRootFilesystem: true
            capabilities:
              drop: [ALL]
          volumeMounts:@MOUNTS@
            - name: scratch
              mountPath: /tmp
      volumes:@VOLUMES@
        - name: scratch
          emptyDir: {}
)text";

constexpr const char* kCommand = R"text(
          command: [saccade-farm]
          args: [run, /dataset, --shard, "$(JOB_COMPLETION_INDEX)/@SHARDS@"@RENDER@])text";

constexpr const char* kMounts = R"text(
            - name: dataset
              mountPath: /dataset@SUB_PATH@)text";

constexpr const char* kVolumes = R"text(
        - name: dataset
          persistentVolumeClaim:
            claimName: @CLAIM@)text";

std::string label(std::string text) {
  for (char& c : text)
    c = std::isalnum(static_cast<unsigned char>(c)) ? static_cast<char>(std::tolower(c)) : '-';
  const std::size_t first = text.find_first_not_of('-');
  return first == text.npos ? "" : text.substr(first, text.find_last_not_of('-') - first + 1);
}

std::string literals(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) {
    checkPlain(word, "an option of run");
    text += ", " + literal(word);
  }
  return text;
}

// The line of the mount that says where on the volume the data set is.
std::string subPath(const DataSet& set, const KubernetesOptions& options) {
  const std::string path = options.path.value_or(folderOf(set).filename());
  if (path.empty() || path == ".") return "";
  checkPlain(path, "--path");
  const std::filesystem::path parts(path);
  if (parts.is_absolute() || std::ranges::find(parts, "..") != parts.end())
    throw std::invalid_argument("--path: '" + path + "' is not a folder within the volume");
  return "\n              subPath: " + quoted(path);
}

std::string diskLine(const KubernetesOptions& options) {
  if (!options.claim.empty()) return "";
  return "\n              ephemeral-storage: " + std::to_string(options.bucket.disk_gib) + "Gi";
}

using Values = std::map<std::string, std::string>;

// The parts that differ between volume and bucket.
Values placeOf(const DataSet& set, const KubernetesOptions& options) {
  if (options.claim.empty()) {
    checkBucket(options.bucket);
    return {{"INIT", bucketInit(options.bucket)},
            {"COMMAND", bucketCommand(set, options)},
            {"MOUNTS", bucketMounts()},
            {"VOLUMES", bucketVolumes(options.bucket)},
            {"GRACE", "120"}};  // for the last upload
  }
  checkObjectName(options.claim, "--claim");
  const Values shards{{"SHARDS", std::to_string(set.plan().shards())},
                      {"RENDER", literals(options.engine.render)}};
  return {{"INIT", ""},
          {"COMMAND", filled(kCommand, shards)},
          {"MOUNTS", filled(kMounts, {{"SUB_PATH", subPath(set, options)}})},
          {"VOLUMES", filled(kVolumes, {{"CLAIM", quoted(options.claim)}})},
          {"GRACE", "30"}};
}

}  // namespace

std::string jobName(const DataSet& set) {
  const std::string digest = label(set.plan().recipe_digest().substr(0, kDigestLetters));
  const std::size_t most = kMostLabelLetters - digest.size() - 2 - std::to_string(set.plan().shards()).size();
  const std::string name = label(label(set.plan().name()).substr(0, most));
  return label((name.empty() ? "dataset" : name) + "-" + digest);
}

std::string kubernetesManifest(const DataSet& set, const KubernetesOptions& options) {
  checkPlain(options.image, "--image");
  const std::uint32_t shards = set.plan().shards();
  const auto parallel = static_cast<std::uint32_t>(options.engine.parallel);
  const auto failed = static_cast<std::uint32_t>(options.max_failed.value_or(static_cast<int>(shards)));
  Values values{{"PLAIN_NAME", plainName(set)},
                {"JOB", quoted(jobName(set))},
                {"SHARDS", std::to_string(shards)},
                {"PARALLEL", std::to_string(parallel > 0 ? std::min(parallel, shards) : shards)},
                {"RETRIES", std::to_string(options.engine.retries)},
                {"MAX_FAILED", std::to_string(std::min(failed, shards))},
                {"USER", std::to_string(options.user)},
                {"IMAGE", quoted(options.image)},
                {"CPUS", std::to_string(options.engine.cpus)},
                {"MEMORY", std::to_string(options.engine.memory_mib)},
                {"DISK", diskLine(options)}};
  values.merge(placeOf(set, options));
  return filled(kJob, values);
}

}  // namespace saccade::farm
