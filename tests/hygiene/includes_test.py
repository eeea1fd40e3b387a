"""Rooms, and folders within a room, include only those before them in the flow of data."""
import unittest

import house

ROOMS = {
    "base": "",
    "frame": "base",
    "pictures": "",
    "scene": "pictures base",
    "wire": "",
    "render": "cache scene frame base",
    "filter": "frame base",
    "cache": "frame base",
    "methods": "cache filter frame base",
    "events": "frame wire base",
    "truth": "base frame scene render feed wire",
    "reply": "wire base",
    "log": "base",
    "stream": "reply log wire base",
    "ops": "log base",
    "web": "wire base client log ops",
    "feed": "base frame scene render filter cache methods",
    "tables": "base scene wire render methods",
    "app": "base frame scene wire reply render filter cache methods feed tables events truth log stream ops web client",
    "farm": "base frame scene wire render methods feed tables events truth app client pictures",
    "eval": "pictures base frame scene wire render filter cache methods feed tables events client",
    "client": "wire pictures",
}
# Each folder of a room, with those of the same room that it may include.
FOLDERS = {
    "scene/files": "",
    "scene/camera": "scene/files",
    "scene/deformation": "scene/camera",
    "scene": "scene/files scene/camera scene/deformation",
    "scene/roam": "scene/camera",
    "scene/motion": "scene scene/files scene/camera",
    "scene/mesh": "scene scene/files",
    "scene/sky": "scene scene/files",
    "scene/mitsuba": "scene scene/files scene/camera scene/mesh scene/sky",
    "scene/model": "scene scene/files scene/camera scene/mesh scene/sky",
    "scene/gltf": "scene scene/files scene/camera scene/deformation scene/mesh scene/motion scene/sky",
    "scene/library": "scene scene/files scene/camera scene/gltf scene/mitsuba scene/model scene/motion scene/sky",
    "cache/lattice": "",
    "cache/grid": "cache/lattice",
    "cache/bake": "cache/lattice cache/grid",
    "client/saccade": "",
    "client/frames": "",
    "client/formats/common": "client/saccade",
    "client/calibration": "client/saccade client/formats/common",
    "client/formats/aedat4": "client/formats/common",
    "client/formats/evt": "client/formats/common client/formats/text",
    "client/formats/hdf5": "client/formats/common",
    "client/formats/npz": "client/formats/common",
    "client/formats/ros": "client/saccade client/formats/common client/formats/evt client/calibration",
    "client/formats/text": "client/formats/common",
    "client/formats/truth_folder": "client/formats/common",
    "client/formats": "client/formats/common",
    "client/recording": "client/saccade client/formats/common client/formats/truth_folder",
    "client/poses": "client/formats/common client/formats/text client/calibration",
    "client/dv": "client/formats/common client/formats/aedat4",
    "client/terminal": "client/saccade",
    "client/drawing": "",
    "client/options": "client/saccade client/formats/common client/formats/truth_folder client/calibration client/recording client/poses",
    "client/commands": "client/saccade client/frames client/formats/common client/formats/truth_folder client/calibration client/recording client/poses client/dv client/terminal client/drawing client/options",
    "client": "client/saccade client/terminal client/options client/commands",
    "render/bsdf": "",
    "render/sampling": "",
    "render/features": "render/bsdf",
    "render/surface": "render/bsdf",
    "render/lights": "render/bsdf render/surface",
    "render/world": "render/bsdf render/surface render/lights",
    "render/camera": "render/bsdf render/surface render/lights render/world",
    "render/primary": "render/bsdf render/surface render/lights render/world render/camera",
    "render/paths": "render/bsdf render/surface render/lights render/world render/camera render/primary render/sampling",
    "render/kernels": "render/primary render/paths",
    "render/tiles": "render/surface render/lights render/world render/camera render/primary render/sampling render/paths",
    "render": "render/surface render/lights render/world render/camera render/primary render/paths render/tiles render/features",
    "app/request": "",
    "app/admission": "app/request",
    "app/config": "app/admission",
    "app/stores": "app/request app/admission",
    "app/sequence": "app/request app/admission app/stores",
    "app/feeds": "app/request app/admission app/sequence",
    "app/streams": "app/request app/admission app/stores app/sequence app/feeds",
    "app": "app/request app/admission app/config app/stores app/feeds app/streams",
    "eval/metrics": "",
    "eval/pictures": "eval/metrics",
    "eval/bench": "eval/metrics eval/pictures",
    "eval/sensor": "",
    "eval/tasks": "eval/metrics eval/pictures eval/bench",
    "eval/figures": "eval/metrics eval/pictures eval/bench eval/sensor",
    "eval/files": "eval/metrics",
    "eval/commands": "eval/files eval/metrics eval/pictures eval/bench eval/sensor eval/tasks eval/figures",
    "eval": "eval/commands",
    "farm/recipe": "",
    "farm/dataset": "farm/recipe",
    "farm/worker": "farm/recipe farm/dataset",
    "farm/plan": "farm/recipe farm/dataset farm/worker",
    "farm/report": "farm/recipe farm/dataset farm/worker",
    "farm/card": "farm/recipe farm/dataset",
    "farm/pack": "farm/dataset",
    "farm/engines": "farm/dataset",
    "farm/commands": "farm/recipe farm/dataset farm/worker farm/plan farm/report farm/card farm/pack farm/engines",
    "farm": "farm/commands",
}
# Folders of those rooms that no other folder includes.
WITHOUT_ORDER = {"client/example"}
# Folders from a request to packets, which a batch uses without a socket; and what they may not include, not
# even by other headers.
WITHOUT_SOCKETS = ["server/app/request/", "server/app/admission/", "server/app/stores/", "server/app/sequence/"]
SOCKETS = ("zmq", "microhttpd", "wslay/", "server/stream/", "server/ops/", "server/web/", "client/")
# Headers of libraries, with the only places that may include them.
OUTSIDE = {
    "OpenImageIO/": ["server/pictures/open_image_io.cpp", "tests/"],
    "embree": ["server/render/world/embree_query.h"],
    "render/world/embree_query.h": ["server/render/world/embree_"],
    "zmq": ["server/stream/", "server/web/", "client/", "tests/"],
    "prometheus/": ["server/app/metrics.cpp"],
    "microhttpd": ["server/ops/http_"],
    "wslay/": ["server/web/web_socket.cpp"],
    "nettle/": ["server/web/web_handshake.cpp", "server/scene/gltf/gltf_uri.cpp"],
    "nlohmann/": ["server/scene/gltf/"],
    "draco/": ["server/scene/gltf/draco_mesh.cpp", "tests/"],
    "meshoptimizer": ["server/scene/gltf/meshopt_view.cpp", "tests/"],
    "toml++/": ["server/app/config/config_file.cpp", "server/scene/files/toml_file.h", "server/farm/recipe/toml_", "server/farm/recipe/recipe_reader.cpp"],
}


def room_of(path):
    """The room a file stands in; None for tests."""
    top, *rest = path.split("/")
    if top == "server":
        return rest[0] if len(rest) > 1 else "app"  # main.cpp knows what app knows
    return {"client": "client", "proto": "wire"}.get(top)


def room_included(included):
    """The room of a header by the name that sources include it by."""
    first, *rest = included.split("/")
    if first != "saccade":
        return first
    return "wire" if rest[0] in {"wire", "v1"} else "client"


def folder_of(included):
    folder = included.rpartition("/")[0]
    return "client/saccade" if folder == "saccade" else folder


def fault(path, included):
    """What is wrong with this file including that one, or None."""
    for prefix, places in OUTSIDE.items():
        if included.startswith(prefix) and not any(path.startswith(place) for place in places):
            return f"{path} includes {included}, which only {', '.join(places)} may"
    room, other = room_of(path), room_included(included)
    if room and other in ROOMS and other != room and other not in ROOMS[room].split():
        return f"{path} includes {included}: {room} may include {ROOMS[room] or 'no other room'}"
    own, folder = path.removeprefix("server/").rpartition("/")[0], folder_of(included)
    if own in FOLDERS and own != folder and folder in FOLDERS and other == room:
        if folder not in FOLDERS[own].split():
            return f"{path} includes {included}: {own} may include {FOLDERS[own] or 'no other folder of its room'}"
    return None


class Includes(unittest.TestCase):
    def test_the_rule_itself(self):
        self.assertIsNone(fault("server/render/renderer.cpp", "frame/frame.h"))
        self.assertIsNone(fault("server/main.cpp", "app/app.h"))
        self.assertIsNone(fault("tests/stream/a_test.cpp", "zmq.hpp"))
        self.assertIn("filter may include", fault("server/filter/atrous.cpp", "render/renderer.h"))
        self.assertIn("eval may include", fault("server/eval/bench/bench.cpp", "app/streams/stream_sink.h"))
        self.assertIn("scene may include", fault("server/scene/scene.cpp", "scene/mitsuba/mitsuba_bsdf.h"))
        self.assertIsNone(fault("server/scene/mitsuba/mitsuba_bsdf.cpp", "scene/scene.h"))
        self.assertIn("only server/render/world/embree_query.h", fault("server/render/lights/lights.cpp", "embree4/rtcore.h"))
        self.assertIn("only server/render/world/embree_", fault("server/render/lights/lights.cpp", "render/world/embree_query.h"))
        self.assertIn("which only", fault("server/app/app.cpp", "zmq.hpp"))
        self.assertIn("client may include wire", fault("client/main.cpp", "base/units.h"))

    def test_every_file_keeps_it(self):
        paths = [p.as_posix() for p in house.files(house.SOURCES)]
        self.assertTrue({room_of(p) for p in paths} >= {"base", "frame", "events", "wire"}, "files were not found")
        faults = [f for p in paths for _, i in house.includes(p) if (f := fault(p, i))]
        self.assertEqual(faults, [])

    def test_requests_become_packets_without_sockets(self):
        todo = [p.as_posix() for p in house.files(house.SOURCES) if p.as_posix().startswith(tuple(WITHOUT_SOCKETS))]
        reached = set(todo)
        self.assertGreater(len(todo), 50)
        while todo:
            for _, included in house.includes(todo.pop()):
                own = next((f for root in ("server/", "proto/", "client/") if (house.ROOT / (f := root + included)).is_file()), None)
                self.assertFalse((own or included).startswith(SOCKETS), included)
                if own and own not in reached:
                    reached.add(own)
                    todo.append(own)

    def test_every_folder_of_the_server_is_a_room(self):
        rooms = {p.name for p in (house.ROOT / "server").iterdir() if p.is_dir()}
        self.assertEqual(rooms - set(ROOMS), set())

    def test_every_folder_of_a_room_with_folders_is_named(self):
        rooms = {name.split("/")[0] for name in FOLDERS}
        folders = {p.parent.as_posix().removeprefix("server/") for p in house.files(house.SOURCES)}
        inside = {folder for folder in folders if folder.split("/")[0] in rooms}
        self.assertEqual(inside - set(FOLDERS) - WITHOUT_ORDER, set())


if __name__ == "__main__":
    unittest.main()
