#include "farm/engines/snakemake.h"

#include <stdexcept>

#include "farm/engines/text.h"

namespace saccade::farm {
namespace {

constexpr const char* kSnakefile = R"text(# Makes the data set @NAME@:
#   snakemake --snakefile THIS_FILE --cores all --keep-going
PROGRAM = @PROGRAM@
DATASET = @DATASET@
RENDER = [@RENDER@]
SHARDS = @SHARDS@


rule all:
    input:
        lambda wildcards: [f"{DATASET}/shards/{shard:0@DIGITS@d}/index.jsonl" for shard in range(SHARDS)]


rule shard:
    output:
        DATASET + "/shards/{shard}/index.jsonl"
    wildcard_constraints:
        shard="[0-9]+"
    params:
        part=lambda wildcards: f"{int(wildcards.shard)}/{SHARDS}"
    threads: @CPUS@
    resources:
        mem_mb=@MEMORY@
    retries: @RETRIES@
    shell:
        "{PROGRAM:q} run {DATASET:q} --shard {params.part} --cpus {threads} {RENDER:q}"
)text";

std::string listed(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) {
    checkPlain(word, "an option of run");
    text += (text.empty() ? "" : ", ") + quoted(word);
  }
  return text;
}

}  // namespace

std::string snakefile(const DataSet& set, const EngineOptions& options) {
  const std::string folder = folderOf(set);
  checkPlain(folder, "the data set's folder");
  if (folder.find_first_of("{}") != folder.npos)
    throw std::invalid_argument("the data set's folder: '" + folder +
                                "' has braces, which Snakemake would fill in");
  checkPlain(options.program, "--program");
  return filled(kSnakefile, {{"NAME", plainName(set)},
                             {"PROGRAM", quoted(options.program)},
                             {"DATASET", quoted(folder)},
                             {"RENDER", listed(options.render)},
                             {"SHARDS", std::to_string(set.plan().shards())},
                             {"DIGITS", std::to_string(shardDigits(set))},
                             {"CPUS", std::to_string(options.cpus)},
                             {"MEMORY", std::to_string(options.memory_mib)},
                             {"RETRIES", std::to_string(options.retries)}});
}

}  // namespace saccade::farm
