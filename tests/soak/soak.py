"""soak.py FOLDER_OF_PROGRAMS OUT MINUTES keys|open: see run."""
import collections, csv, itertools, pathlib, random, re, signal, subprocess, sys, threading, time, urllib.request
import numpy as np

import hostile, visitors
from saccade.v1 import control_pb2 as c
from stream_client import CREDIT, Link, Refused, Stream, Tally

BIN, OUT, SECONDS = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2]), float(sys.argv[3]) * 60
KEYS = sys.argv[4] == "keys"
LEASE_S, SAMPLE_S, RELOAD_S, WARM_UP = 5, 5, 60, 0.2
LARGEST_SLOPE = 1.0  # MB in 10 minutes
LONGEST_S = 1  # of /healthz
WINDOW = 12  # samples: what visitors take for a moment is not kept
MOST = 16  # visitors and guests at once: where the machine is slow, they stay longer
FREE = "tcp://127.0.0.1:*"


class Server:
    def __init__(self):
        names = ("server", "client", "hostile") if KEYS else ()
        for name in names:
            for end in (".key", ".pub"): (OUT / (name + end)).unlink(missing_ok=True)
            subprocess.run([BIN / "saccade", "keygen", OUT / name], check=True, stdout=subprocess.DEVNULL)
        (OUT / "clients").write_text("".join(f"{(OUT / name).with_suffix('.pub').read_text().strip()} {name}\n" for name in names[1:]))
        keys = ["--secret-key", OUT / "server.key", "--client-keys", OUT / "clients"] if KEYS else []
        self.process = subprocess.Popen(
            [BIN / "saccaded", "--control", FREE, "--data", FREE, "--broadcast", FREE, "--http", "http://127.0.0.1:0",
             "--lease", str(LEASE_S), "--limit-queue", "0.0625", *keys],
            stdout=subprocess.PIPE, text=True)
        ready = next(filter(None, (re.search(r"ready: control (\S+) .* http (\S+),", line) for line in self.process.stdout)))
        self.control, self.http = ready.groups()
        threading.Thread(target=self.drain, daemon=True).start()

    def link(self, name):
        keys = ((OUT / f"{name}.key").read_bytes().strip(), (OUT / "server.pub").read_bytes().strip()) if KEYS else ()
        return Link(self.control, self.http, *keys)

    def drain(self):
        with open(OUT / "saccaded.log", "w") as log:
            for line in self.process.stdout: log.write(line)

    def page(self, path):
        return urllib.request.urlopen(self.http + path, timeout=30).read().decode()

    def health_s(self):
        begin = time.monotonic()
        self.page("/healthz")
        return time.monotonic() - begin

    def metrics(self):
        text = self.page("/metrics")
        sums = collections.Counter()
        for name, value in re.findall(r"^(\w+)(?:\{.*\})? (\S+)$", text, re.M): sums[name] += float(value)
        return sums


class Crowd:
    """Visitors, one a second, and guests who stay to the end. What each has received is added up by its kind."""

    def __init__(self, link, hostile_link):
        self.link, self.hostile_link = link, hostile_link
        self.random, self.lock, self.over = random.Random(1), threading.Lock(), False
        kinds = visitors.KINDS, hostile.ANYWHERE + ([] if KEYS else hostile.WITHOUT_KEYS)
        self.turns = [itertools.cycle(self.random.sample(some, len(some))) for some in kinds]
        self.means_harm = False
        self.tallies, self.visits, self.failures, self.threads = (
            collections.defaultdict(Tally), collections.Counter(), [], [])

    def run(self, name, what):
        def body():
            try:
                tally = what()
            except Exception as fault:
                limit = getattr(fault.args[0] if fault.args else None, "limit", "")
                if limit:
                    with self.lock: self.visits[f"refused, limit {limit}"] += 1
                    return
                with self.lock: self.failures.append(f"{name}: {fault}")
                return
            with self.lock:
                self.tallies[name] += tally
                self.visits[name] += 1
        self.threads.append(threading.Thread(target=body))
        self.threads[-1].start()

    def visit(self):
        self.threads = [t for t in self.threads if t.is_alive()]
        if len(self.threads) >= MOST:
            self.visits["turned away"] += 1
            return
        kind, seed = next(self.turns[self.means_harm]), self.random.getrandbits(32)
        if self.means_harm: self.run(f"hostile {kind.__name__}", lambda: hostile.visit(kind, self.hostile_link, seed))
        else: self.run(kind.__name__, lambda: kind(self.link, seed))
        self.means_harm = not self.means_harm

    def stay(self, name, request):
        def body():
            stream = self.persist(request)
            if stream.broadcast: self.hostile_link.known_topics = list(stream.opened.topics)
            else: stream.give(CREDIT)
            stream.receive_until(lambda: self.over)
            if stream.ended: raise AssertionError("the stream was ended by somebody else")
            stream.close()
            return stream.tally
        self.run(name, body)

    def persist(self, request):
        """A guest who is refused for want of CPU time asks again."""
        while True:
            try:
                return Stream(self.link, request)
            except Refused as refusal:
                if self.over or not getattr(refusal.args[0], "limit", ""): raise
            time.sleep(1)

    def leave(self):
        self.over = True
        for thread in self.threads: thread.join()


def progress(text):
    print(f"\r{text:<100}", end="", file=sys.stderr, flush=True)


def soak(server, crowd):
    paced = dict(clock=c.CLOCK_PACED, duration_s=0)
    shared = visitors.request(c.DELIVERY_LIVE, 3, **paced)
    crowd.stay("shared live feed", shared)
    crowd.stay("endless broadcast", visitors.request(c.DELIVERY_BROADCAST, 4, **paced))
    crowd.stay("endless lossless", visitors.request(c.DELIVERY_LOSSLESS, 5, **paced))
    begin, samples = time.monotonic(), []
    next_sample = next_reload = 0
    while (now := time.monotonic() - begin) < SECONDS:
        crowd.visit()
        if now >= next_reload:
            if next_reload == RELOAD_S: crowd.stay("late joiner of it", shared)
            server.process.send_signal(signal.SIGHUP)
            next_reload += RELOAD_S
        if now >= next_sample:
            m = server.metrics()
            samples.append((now, m["process_resident_memory_bytes"] / 1e6, m["process_open_fds"], m["saccade_streams"],
                            server.health_s()))
            progress("%4.0f of %.0f s: %.1f MB, %d descriptors, %d streams, healthy in %.3f s" % (now, SECONDS, *samples[-1][1:]))
            next_sample += SAMPLE_S
        time.sleep(max(0, 1 - (time.monotonic() - begin - now)))  # the pace of the visitors
    progress("")
    return np.array(samples)


def report(samples, crowd, last):
    with open(OUT / "soak.csv", "w", newline="") as file:
        csv.writer(file).writerows([("seconds", "resident_mb", "descriptors", "streams", "health_s"), *samples.tolist()])
    t, mb, fds, streams, health = samples[int(len(samples) * WARM_UP):].T
    begins = range(0, max(1, len(mb) - WINDOW + 1), WINDOW)
    lows = [(t[i] / 600, mb[i:i + WINDOW].min()) for i in begins]
    slope = np.polyfit(*zip(*lows), 1)[0] if len(lows) > 2 else 0.0
    total = Tally()
    for name in sorted(crowd.visits):
        print(f"{name} x{crowd.visits[name]}" + (f": {crowd.tallies[name]}" if crowd.tallies[name].packets else ""))
        total += crowd.tallies[name]
    print(f"all: {total}")
    print(f"server: {last['saccade_sent_packets_total']:.0f} packets sent, {last['saccade_dropped_packets_total']:.0f} dropped")
    print(f"memory: {mb.min():.1f} to {mb.max():.1f} MB, slope of what stays {slope:+.2f} MB in 10 minutes (at most {LARGEST_SLOPE}, from {len(lows)} windows)")
    print(f"/healthz: median {np.median(health):.3f} s, longest {health.max():.3f} s (at most {LONGEST_S})")
    print(f"descriptors: {fds.min():.0f} to {fds.max():.0f}; streams: {streams.min():.0f} to {streams.max():.0f}")
    for failure in crowd.failures: print("FAILED:", failure)
    return slope <= LARGEST_SLOPE and health.max() <= LONGEST_S and total.lost == total.faults == 0 and not crowd.failures


def settled(server):
    """What is left once all are gone and every lease is over."""
    deadline = time.monotonic() + 10 * LEASE_S
    while (m := server.metrics())["saccade_streams"] > 0 and time.monotonic() < deadline: pass
    return m


server = Server()
crowd = Crowd(server.link("client"), server.link("hostile"))
samples = soak(server, crowd)
crowd.leave()
last = settled(server)
server.process.terminate()
status = server.process.wait(timeout=60)
good = report(samples, crowd, last)
print(f"at the end: {last['saccade_streams']:.0f} streams, {last['process_open_fds']:.0f} descriptors, exit status {status}")
sys.exit(0 if good and status == 0 and last["saccade_streams"] == 0 else 1)
