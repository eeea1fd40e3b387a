#include "farm/engines/bucket.h"

#include <stdexcept>

#include "farm/engines/manifest_text.h"
#include "farm/engines/text.h"

namespace saccade::farm {
namespace {

// Of what is made already it fetches only what says so. A sequence's sequence.json is sent after the other
// files of the sequence, so what is in the bucket is whole, wherever an upload is cut.
constexpr const char* kBucketScript = R"text(set -u
printf -v shard '%0@DIGITS@d' "$JOB_COMPLETION_INDEX"
here=shards/$shard
cd /dataset || exit 75
/tools/rclone copy "$BUCKET" . --include /plan.json --include '/recipe/**' --include "/plan/$shard.jsonl" \
  --include "/$here/*/sequence.json" --include "/failed/$shard/*" || exit 75
mkdir -p "$here" "failed/$shard"

finished() { find "$here" -mindepth 2 -type f | sort; }
send() { /tools/rclone copy --files-from-raw "$1" . "$BUCKET"; }
upload() {
  finished >/tmp/now
  comm -13 /tmp/sent /tmp/now >/tmp/new
  grep -v '/sequence\.json$' /tmp/new >/tmp/first
  grep '/sequence\.json$' /tmp/new >/tmp/last
  send /tmp/first && send /tmp/last && /tools/rclone sync "failed/$shard" "$BUCKET/failed/$shard" &&
    mv /tmp/now /tmp/sent
}
upload_all() {
  upload && if [ -e "$here/index.jsonl" ]; then echo "$here/index.jsonl" >/tmp/index && send /tmp/index; fi
}

finished >/tmp/sent
saccade-farm run . --shard "$JOB_COMPLETION_INDEX/@SHARDS@"@RENDER@ &
worker=$!
trap 'kill -TERM "$worker" 2>/dev/null' TERM
while kill -0 "$worker" 2>/dev/null; do
  sleep "${UPLOAD_EVERY_S:-60}" &
  nap=$!
  wait -n "$worker" "$nap"
  kill "$nap" 2>/dev/null
  ! kill -0 "$worker" 2>/dev/null || upload
done
wait "$worker"
code=$?
upload_all || exit 75
exit "$code"
)text";

constexpr const char* kBucketCommand = R"text(
          command: [bash, -c]
          args:
            - @SCRIPT@
          env:
            - name: BUCKET
              value: @PLACE@
            - name: RCLONE_CONFIG
              value: /etc/rclone/rclone.conf)text";

constexpr const char* kInit = R"text(
      initContainers:
        - name: tools
          image: @IMAGE@
          command: [cp, /usr/local/bin/rclone, /etc/ssl/certs/ca-certificates.crt, /tools/]
          securityContext:
            allowPrivilegeEscalation: false
            readOnlyRootFilesystem: true
            capabilities:
              drop: [ALL]
          volumeMounts:
            - name: tools
              mountPath: /tools)text";

constexpr const char* kBucketMounts = R"text(
            - name: dataset
              mountPath: /dataset
            - name: tools
              mountPath: /tools
              readOnly: true
            - name: rclone
              mountPath: /etc/rclone
              readOnly: true)text";

constexpr const char* kBucketVolumes = R"text(
        - name: dataset
          emptyDir:
            sizeLimit: @DISK@Gi
        - name: tools
          emptyDir: {}
        - name: rclone
          secret:
            secretName: @SECRET@)text";

}  // namespace

void checkBucket(const Bucket& bucket) {
  checkPlain(bucket.place, "--bucket");
  checkPlain(bucket.image, "--rclone-image");
  checkObjectName(bucket.secret, "--rclone-secret");
  if (bucket.place.find(':') == bucket.place.npos || bucket.place[0] == '-')
    throw std::invalid_argument("--bucket: '" + bucket.place +
                                "' is not REMOTE:PATH, such as s3:sets/indoor");
}

std::string bucketInit(const Bucket& bucket) {
  return filled(kInit, {{"IMAGE", quoted(bucket.image)}});
}

std::string bucketCommand(const DataSet& set, const KubernetesOptions& of) {
  for (const std::string& word : of.engine.render) checkPlain(word, "an option of run");
  const std::string script = filled(kBucketScript, {{"DIGITS", std::to_string(shardDigits(set))},
                                                    {"SHARDS", std::to_string(set.plan().shards())},
                                                    {"RENDER", shellWords(of.engine.render)}});
  return filled(kBucketCommand, {{"SCRIPT", literalBlock(script, 14)}, {"PLACE", literal(of.bucket.place)}});
}

std::string bucketMounts() {
  return kBucketMounts;
}

std::string bucketVolumes(const Bucket& bucket) {
  return filled(kBucketVolumes,
                {{"DISK", std::to_string(bucket.disk_gib)}, {"SECRET", quoted(bucket.secret)}});
}

}  // namespace saccade::farm
