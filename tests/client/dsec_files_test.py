"""Files .h5 and two other programs: h5py, and h5wasm where npm is."""
import json
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import event_columns
import npm_packages

try:
    import h5py
    import numpy as np
except ImportError as fault:
    event_columns.skip(fault)

BLOSC = 32001
SACCADE, _, NPM = sys.argv[1:4]
convert = event_columns.Converter(SACCADE)


def columns(file):
    return {c: file["events"][c][:] for c in event_columns.COLUMNS}


def window(file, begin_us, end_us):
    """The events of [begin_us, end_us), found as the definition of ms_to_idx allows it: without a search in all of t."""
    t, index = file["events/t"], file["ms_to_idx"]
    first, last = int(index[begin_us // 1000]), int(index[-(-end_us // 1000)])
    near = t[first:last]
    return first + int((near < begin_us).sum()), first + int((near < end_us).sum())


class Dsec(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)
        self.h5 = self.folder / "a.h5"

    def write(self, events=None, **changes):
        """A file of h5py in the layout of DSEC; `changes` replace entries, or leave them out where None."""
        events = events or event_columns.random_events(1000)
        entries = {"events/x": events["x"].astype("u2"), "events/y": events["y"].astype("u2"),
                   "events/p": events["p"].astype("u1"), "events/t": events["t"].astype("u4"),
                   "t_offset": np.int64(0)}
        entries.update({name.replace("__", "/"): value for name, value in changes.items()})
        with h5py.File(self.h5, "w") as file:
            for name, value in entries.items():
                if value is not None:
                    file[name] = value

    def fault(self):
        code, errors = convert.run(self.h5, self.folder / "out.csv", "--size", "1280x720")
        self.assertEqual(code, 1, errors)
        self.assertIn(f"{self.h5}: ", errors)
        self.assertEqual(errors.count("\n"), 1, errors)  # nothing of HDF5's own
        return errors

    def test_h5py_reads_the_layout_of_dsec(self):
        events = event_columns.random_events(140_000)
        convert.from_events(events, self.folder, self.h5)
        with h5py.File(self.h5) as file:
            event_columns.assert_equal(columns(file), events)
            types = {name: file[name].dtype for name in ["events/x", "events/y", "events/p", "events/t", "ms_to_idx"]}
            self.assertEqual(types, {"events/x": "u2", "events/y": "u2", "events/p": "u1", "events/t": "u4",
                                     "ms_to_idx": "u8"})
            self.assertEqual((file["t_offset"].dtype, file["t_offset"][()]), (np.int64, 0))
            self.assertEqual((file.attrs["width"], file.attrs["height"]), event_columns.SIZE)
            self.assertEqual((file["events/width"][()], file["events/height"][()]), event_columns.SIZE)
            t = file["events/t"]
            self.assertEqual((t.chunks, t.compression, t.compression_opts, t.shuffle), ((131072,), "gzip", 1, True))

    def test_ms_to_idx_is_the_first_event_of_each_millisecond(self):
        for count in [0, 1, 5, 140_000]:
            events = event_columns.random_events(count, gap_us=700 if count < 10 else 20)
            convert.from_events(events, self.folder, self.h5)
            end_us = events["t"][-1] + 1 if count else 0
            with h5py.File(self.h5) as file:
                index = file["ms_to_idx"][:]
                self.assertEqual(len(index), end_us // 1000 + 2)
                np.testing.assert_array_equal(index, np.searchsorted(events["t"], 1000 * np.arange(len(index))))

    def test_windows_are_found_as_eventslicer_finds_them(self):
        events = event_columns.random_events(140_000, seed=2)
        convert.from_events(events, self.folder, self.h5)
        rng = np.random.default_rng(3)
        with h5py.File(self.h5) as file:
            for _ in range(200):
                begin, end = np.sort(rng.integers(0, events["t"][-1] + 2, 2))
                self.assertEqual(window(file, begin, end), tuple(np.searchsorted(events["t"], [begin, end])))

    def test_times_from_an_epoch(self):
        events = event_columns.random_events(1000)
        events["t"] += 1_700_000_000_123_456
        convert.from_events(events, self.folder, self.h5)
        with h5py.File(self.h5) as file:
            offset = file["t_offset"][()]
            np.testing.assert_array_equal(file["events/t"][:].astype(np.int64) + offset, events["t"])
            index = file["ms_to_idx"][:]
            np.testing.assert_array_equal(index,
                                          np.searchsorted(file["events/t"][:], 1000 * np.arange(len(index))))
        event_columns.assert_equal(convert.to_events(self.h5, self.folder), events)

    def test_blosc(self):
        if not h5py.h5z.filter_avail(BLOSC):
            self.skipTest("hdf5-filter-plugin-blosc-serial is not installed")
        events = event_columns.random_events(140_000)
        convert.from_events(events, self.folder, self.h5, "--format", "dsec-blosc")
        with h5py.File(self.h5) as file:
            event_columns.assert_equal(columns(file), events)
            settings = file["events/t"].id.get_create_plist().get_filter(0)
            self.assertEqual((settings[0], settings[2][4:]), (BLOSC, (1, 1, 5)))
        event_columns.assert_equal(convert.to_events(self.h5, self.folder), events)

    def test_blosc_without_the_plugin_names_the_package(self):
        event_columns.write_csv(self.folder / "in.csv", event_columns.random_events(3))
        no_plugins = {"HDF5_PLUGIN_PATH": str(self.folder)}
        attempts = [["--format", "dsec-blosc", "--size", "1280x720", self.folder / "in.csv", self.folder / "b.h5"]]
        if h5py.h5z.filter_avail(BLOSC):
            self.write(events__x=None)
            with h5py.File(self.h5, "a") as file:
                file.create_dataset("events/x", data=np.zeros(1000, "u2"), compression=BLOSC)
            attempts.append([self.h5, self.folder / "out.csv", "--size", "1280x720"])
        for arguments in attempts:
            done = subprocess.run([SACCADE, "convert", *arguments], env=no_plugins, capture_output=True, text=True,
                                  check=False)
            self.assertIn("install hdf5-filter-plugin-blosc-serial", done.stderr)

    def test_files_of_h5py_are_read(self):
        events = event_columns.random_events(140_000)
        moved = {**events, "t": events["t"] + 58_000_000_123}
        self.write(events, t_offset=np.int64(58_000_000_123))
        event_columns.assert_equal(convert.to_events(self.h5, self.folder), moved)
        self.write(events, t_offset=None)
        event_columns.assert_equal(convert.to_events(self.h5, self.folder), events)
        for t_type in ["u4", "u8", "i8"]:
            self.write(events, events__t=events["t"].astype(t_type), events__p=events["p"].astype(bool),
                       events__x=events["x"].astype("i4"), events__y=events["y"].astype(">u2"))
            event_columns.assert_equal(convert.to_events(self.h5, self.folder), events)

    def test_chunks_of_any_size_are_read(self):
        events = event_columns.random_events(140_000)
        for chunk in [1000, 100_000, 4_000_000]:
            with h5py.File(self.h5, "w") as file:
                for name in event_columns.COLUMNS:
                    file.create_dataset("events/" + name, data=events[name], chunks=(chunk,), maxshape=(None,),
                                        compression="gzip")
            event_columns.assert_equal(convert.to_events(self.h5, self.folder), events)

    def test_the_size_of_the_image_is_read(self):
        for attributes, scalars in [({"width": 640, "height": 480}, {}), ({}, {"width": 640, "height": 480})]:
            self.write(event_columns.random_events(0), **{"events__" + k: np.int32(v) for k, v in scalars.items()})
            with h5py.File(self.h5, "a") as file:
                file.attrs.update(attributes)
            convert(self.h5, self.folder / "out.txt")
            self.assertEqual((self.folder / "out.txt").read_text(), "640 480\n")

    def read(self, *options):
        code, errors = convert.run(self.h5, self.folder / "out.csv", "--size", "1280x720", *options)
        self.assertEqual(code, 0, errors)
        return event_columns.read_csv(self.folder / "out.csv"), errors

    def test_layouts_of_others_are_read(self):
        events = event_columns.random_events(140_000)
        t, x, y, p = (events[name] for name in event_columns.COLUMNS)
        metavision = np.zeros(len(t), np.dtype({"names": ["x", "y", "p", "t"], "formats": ["<u2", "<u2", "<i2", "<i8"],
                                                "offsets": [0, 2, 4, 8], "itemsize": 16}))
        for name in event_columns.COLUMNS:
            metavision[name] = events[name]
        whole = "read t as microseconds (it has whole numbers), columns "
        seconds = "read t as seconds (it has a decimal point), columns "
        for said, entries in [
                (whole + "t x y p of events", {"events": np.stack([t, x, y, p], 1).astype("u4")}),  # v2e
                (seconds + "events/ts events/xs events/ys events/ps",
                 {"events/xs": x, "events/ys": y, "events/ts": t / 1e6, "events/ps": p > 0}),
                (whole + "t x y p of CD/events", {"CD/events": metavision}),
                (seconds + "t x y p", {"x": x, "y": y, "t": t / 1e6, "p": (2 * p - 1).astype("i1")}),
        ]:
            with h5py.File(self.h5, "w") as file:
                for name, values in entries.items():
                    file.create_dataset(name, data=values, chunks=True, compression="gzip")
            read, errors = self.read()
            event_columns.assert_equal(read, events)
            self.assertIn(said + ", size 1280x720 from --size", errors)

    def test_the_other_extension_is_read(self):
        events = event_columns.random_events(1000)
        self.write(events)
        other = self.h5.rename(self.folder / "a.hdf5")
        event_columns.assert_equal(convert.to_events(other, self.folder), events)

    def test_metavision_tells_the_size(self):
        events = np.zeros(0, [("x", "<u2"), ("y", "<u2"), ("p", "<i2"), ("t", "<i8")])
        for geometry in ["640x480", np.bytes_("640x480")]:
            with h5py.File(self.h5, "w") as file:
                file["CD/events"] = events
                file.attrs["geometry"] = geometry
            convert(self.h5, self.folder / "out.txt")
            self.assertEqual((self.folder / "out.txt").read_text(), "640 480\n")

    def test_a_codec_that_is_not_there_is_named(self):
        with h5py.File(self.h5, "w") as file:
            types = h5py.h5t.py_create(np.dtype([("x", "<u2"), ("y", "<u2"), ("p", "<i2"), ("t", "<i8")]))
            settings = h5py.h5p.create(h5py.h5p.DATASET_CREATE)
            settings.set_chunk((100,))
            settings.set_filter(0x8ECF, h5py.h5z.FLAG_OPTIONAL)
            h5py.h5d.create(file.create_group("CD").id, b"events", types, h5py.h5s.create_simple((100,)), settings)
        self.assertIn("CD/events needs filter 36559", self.fault())
        self.assertIn("install the plugin hdf5_ecf of Prophesee", self.fault())

    def test_layouts_of_several_cameras_are_named(self):
        events = event_columns.random_events(1000)
        names = [f"prophesee/left/{name}" for name in event_columns.COLUMNS]
        with h5py.File(self.h5, "w") as file:
            file.update({name: values for name, values in zip(names, events.values())})
        self.assertIn("has the layout of M3ED; --columns names the datasets of a camera: " + ",".join(names), self.fault())
        event_columns.assert_equal(self.read("--columns", ",".join(names))[0], events)
        self.write(events__t=None)
        self.assertIn("has no arrays t, x, y and p, and no table of them; its arrays are events/p events/x events/y",
                      self.fault())

    def test_columns_that_are_none_of_events_are_refused(self):
        for fault, changes in {
                "events/t is not one column of numbers": {"events__t": np.zeros((1000, 1))},
                "events/x is not one column of numbers": {"events__x": np.zeros((1000, 1), "u2")},
                "unequal lengths": {"events__y": np.zeros(999, "u2")},
                "t_offset is not a single whole number": {"t_offset": np.zeros(2, "i8")},
                "p 2; t is within 292 years, x and y are 0 to 65535, p is 0 or 1": {"events__p": np.full(1000, 2, "u1")},
                "event 1000 has t 9223372036854775807": {"events__t": np.r_[np.zeros(999, "u8"), np.uint64(2**64 - 1)]},
        }.items():
            self.write(**changes)
            self.assertIn(fault, self.fault())

    def test_columns_without_their_data_are_refused(self):
        for chunks in [None, (100,)]:
            self.write(events__t=None)
            with h5py.File(self.h5, "a") as file:
                file.create_dataset("events/t", shape=(1000,), dtype="u4", chunks=chunks)
            self.assertIn("events/t has 0 of its 1000 values", self.fault())
        self.write(events__t=None)
        with h5py.File(self.h5, "a") as file:
            layout = h5py.VirtualLayout(shape=(1000,), dtype="u4")
            layout[:] = h5py.VirtualSource("other.h5", "t", shape=(1000,))
            file.create_virtual_dataset("events/t", layout)
        self.assertIn("events/t is in other files", self.fault())
        self.write(events__t=None)
        with h5py.File(self.h5, "a") as file:
            file.create_dataset("events/t", shape=(1000,), dtype="u4", external=[("/etc/passwd", 0, 4000)])
        self.assertIn("events/t is in another file", self.fault())

    def test_h5wasm_reads_the_same(self):
        reason = npm_packages.missing(NPM, ["h5wasm@0.10.3"])
        if reason:
            self.skipTest(reason)
        events = event_columns.random_events(140_000)
        convert.from_events(events, self.folder, self.h5)
        module = Path(NPM, "node_modules", "h5wasm", "dist", "node", "hdf5_hl.js")
        read = json.loads(npm_packages.run(NPM, Path(__file__).with_name("read_h5.mjs"), module, self.h5))
        event_columns.assert_equal(read, events)
        self.assertEqual([read["width"], read["height"]], list(event_columns.SIZE))
        np.testing.assert_array_equal(read["ms_to_idx"],
                                      np.searchsorted(events["t"], 1000 * np.arange(events["t"][-1] // 1000 + 2)))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
