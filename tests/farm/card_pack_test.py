"""saccade-farm card, pack and verify, with the standard readers of what they write: json and tarfile.

card_pack_test.py SACCADE-FARM
"""
import collections
import json
import pathlib
import re
import subprocess
import sys
import tarfile
import tempfile
import unittest

FARM = sys.argv[1]
SCENES = pathlib.Path(__file__).resolve().parents[2] / "scenes"

RECIPE = """
name = "tiny"
seed = 3
sequences = 5
shards = 2
splits = { train = 0.6, test = 0.4 }
[draw]
contrast = { uniform = [0.1, 0.3] }
[record]
output = ["events.h5", "events.raw"]
scene = { each = ["cornell-box", "textured-cornell-box"] }
threshold = "{contrast}"
motion = "right"
size = "16x12"
rate = 200
duration = 0.05
truth = "depth"
"""

# Croissant 1.0: what a data set and each resource must have.
REQUIRED = {"@context", "@type", "conformsTo", "description", "license", "name", "url", "creator", "datePublished",
            "distribution"}
FOR_HUBS = ["--url", "https://example.org/tiny", "--creator", "Nobody", "--published", "2026-01-02"]


def farm(*words, expect=0):
    done = subprocess.run([FARM, *map(str, words)], capture_output=True, text=True, check=False)
    assert done.returncode == expect, (words, done.returncode, done.stdout, done.stderr)
    return done.stdout + done.stderr


class CardAndPack(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.place = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.place.cleanup)
        recipe = pathlib.Path(cls.place.name, "recipe.toml")
        recipe.write_text(RECIPE, encoding="utf-8")
        cls.set = pathlib.Path(cls.place.name, "tiny")
        farm("plan", recipe, "-o", cls.set, "--no-estimate", "--scenes", SCENES)
        farm("run", cls.set, "--scenes", SCENES)

    def sequences(self):
        lines = [line for file in sorted(self.set.glob("shards/*/index.jsonl")) for line in file.read_text().splitlines()]
        return [json.loads(line) for line in lines]

    def test_pack_writes_what_tarfile_reads(self):
        farm("pack", self.set)
        found = {}
        for path in sorted(self.set.glob("webdataset/*.tar")):
            split, shard = re.fullmatch(r"(train|test)-(\d{5})\.tar", path.name).groups()
            with tarfile.open(path) as tar:
                members = tar.getmembers()
                for member in members:
                    self.assertEqual((member.mtime, member.uid, member.gid, member.mode, member.uname),
                                     (0, 0, 0, 0o644, ""))
                    found[member.name] = tar.extractfile(member).read()
            keys = [member.name.partition(".")[0] for member in members]
            runs = [key for key, before in zip(keys, [None, *keys]) if key != before]
            self.assertEqual(runs, sorted(set(keys)), "members of a sequence stand together")
            for key in runs:
                about = json.loads(found[f"{key}.sequence.json"])
                self.assertEqual((int(about["number"]), about["split"], about["shard"]), (int(key), split, int(shard)))
        wanted = {}
        for folder in self.set.glob("shards/*/[0-9]*"):
            for file in folder.rglob("*"):
                if file.is_file():
                    name = ".".join([folder.name, *file.relative_to(folder).parts])
                    wanted[name] = file.read_bytes()
        self.assertTrue(any(name.endswith(".truth.depth.000000.exr") for name in wanted))
        self.assertEqual(sorted(found), sorted(wanted))
        self.assertEqual(found, wanted)

    def test_the_card_is_croissant(self):
        farm("card", self.set, "--scenes", SCENES, *FOR_HUBS)
        card = json.loads((self.set / "croissant.json").read_text(encoding="utf-8"))
        self.assertEqual(REQUIRED - set(card), set())
        self.assertEqual(card["@type"], "sc:Dataset")
        self.assertEqual(card["conformsTo"], "http://mlcommons.org/croissant/1.0")
        kinds = collections.Counter(item["@type"] for item in card["distribution"])
        self.assertEqual(kinds, {"cr:FileObject": 2, "cr:FileSet": 3})
        for item in card["distribution"]:
            if item["@type"] == "cr:FileObject":
                file = self.set / item["contentUrl"]
                digest = subprocess.run(["sha256sum", file], capture_output=True, text=True, check=True).stdout.split()[0]
                self.assertEqual((item["sha256"], item["contentSize"]), (digest, f"{file.stat().st_size} B"))
            else:
                self.assertTrue(list(self.set.glob(item["includes"])), item["includes"])

    def test_records_of_the_card_are_in_the_index(self):
        farm("card", self.set, "--scenes", SCENES, *FOR_HUBS)
        card = json.loads((self.set / "croissant.json").read_text(encoding="utf-8"))
        ids = [item["@id"] for item in card["distribution"]]
        splits, sequences = card["recordSet"]
        ids += [field["@id"] for field in splits["field"] + sequences["field"]]
        self.assertEqual(len(ids), len(set(ids)))
        self.assertEqual([row["splits/name"] for row in splits["data"]], ["train", "test"])
        for field in sequences["field"]:
            self.assertIn(field["source"]["fileSet"]["@id"], ids)
            for sequence in self.sequences():
                column = sequence[field["source"]["extract"]["column"]]
                path = field["source"].get("transform", {}).get("jsonPath", "")
                name = re.fullmatch(r"(?:\$(?:\.(\w+)|\['([\w-]+)'\]))?", path)
                for part in column if field.get("repeated") else [column]:
                    self.assertIsNotNone(part[name[1] or name[2]] if path else part)

    def test_cards_have_no_time_and_no_place(self):
        cards = []
        for name in ("README.md", "croissant.json", "card/sequences.png") * 2:
            if name == "README.md":
                farm("card", self.set, "--scenes", SCENES)
            cards.append((self.set / name).read_bytes())
        self.assertEqual(cards[:3], cards[3:])
        self.assertEqual(cards[2][:8], b"\x89PNG\r\n\x1a\n")
        self.assertNotIn(self.place.name.encode(), b"".join(cards))
        page = cards[0].decode()
        events = sum(int(sequence["recordings"][0]["events"]) for sequence in self.sequences())
        self.assertIn(f"| all | 5 | {events:,} | 0.25 s |", page)
        self.assertNotIn("not known", page)
        self.assertIn("--url", farm("card", self.set, "--scenes", SCENES))
        self.assertIn("not a date", farm("card", self.set, "--scenes", SCENES, "--published", "today", expect=2))

    def test_verify_passes_over_what_is_made_of_the_data_set(self):
        farm("card", self.set, "--scenes", SCENES)
        farm("pack", self.set)
        self.assertIn("5 sequences are as they should be", farm("verify", self.set))
        stray = self.set / "shards" / "stray"
        stray.touch()
        self.addCleanup(stray.unlink)
        self.assertIn("foreign: shards/stray", farm("verify", self.set, expect=1))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
