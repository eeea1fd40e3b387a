"""A client whose key the server refuses learns so, in both networks."""
import asyncio
import os
import pathlib
import tempfile
import unittest

import zmq

import saccade
import saccade.aio
from saccaded import Server


class RefusedKey(unittest.TestCase):
    def setUp(self):
        place = tempfile.TemporaryDirectory()
        self.addCleanup(place.cleanup)
        self.folder = pathlib.Path(place.name)
        for owner in ("server", "alice", "bob"):
            public, secret = zmq.curve_keypair()
            (self.folder / f"{owner}.pub").write_bytes(public + b"\n")
            (self.folder / f"{owner}.key").write_bytes(secret + b"\n")
            os.chmod(self.folder / f"{owner}.key", 0o600)
        flags = ["--secret-key", str(self.folder / "server.key"), "--client-keys", str(self.folder / "alice.pub")]
        self.server = Server(*flags)
        self.addCleanup(self.server.stop)

    def keys(self, owner):
        return {"secret_key": self.folder / f"{owner}.key", "server_key": self.folder / "server.pub"}

    def test_is_told(self):
        with saccade.connect(self.server.address, **self.keys("alice")) as client:
            self.assertEqual(client.info().threads, 1)
        with saccade.connect(self.server.address, **self.keys("bob")) as client:
            for _ in range(2):
                with self.assertRaisesRegex(saccade.PermissionDenied, "the server refuses your key: it is not on"):
                    client.info()

    def test_is_told_to_asyncio(self):
        async def ask():
            async with saccade.aio.connect(self.server.address, **self.keys("bob")) as client:
                await client.info()
        with self.assertRaisesRegex(saccade.PermissionDenied, "the server refuses your key"):
            asyncio.run(ask())


if __name__ == "__main__":
    unittest.main()
