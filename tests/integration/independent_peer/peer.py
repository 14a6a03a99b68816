#!/usr/bin/python3
"""An independent peer of the sealed channel, written from core/channel/PROTOCOL.md and public specifications alone.

    peer.py --new-key FILE                             make a key, print the public one
    peer.py --check PROTOCOL.md                        recompute the document's known answers
    peer.py --station|--agent --key FILE --peer KEY    one end of the channel on a UDP socket of the loopback

An end speaks JSON on its standard output, one event a line, and takes commands on its standard input:
`propose N`, `roam` (go on from another port), `beat N` (send N heartbeats), `status`, `close`, `quit`.
"""

import argparse
import json
import os
import selectors
import socket
import sys
import time

import known_answers
from agent import Agent
from flood import Flood
from key_text import from_text, to_text
from mavlink import frames, heartbeat
from noise import KeyPair
from station import Station
from wire import NO_PSK

TICK = 0.02


class End:
    """Station or agent on a socket, with counters of what arrived."""

    def __init__(self, arguments):
        self._selector = selectors.DefaultSelector()
        self._socket = None
        self._open_socket(arguments.port)
        static = KeyPair(bytes.fromhex(open(arguments.key).read()))
        known = [(from_text(arguments.peer), bytes.fromhex(arguments.psk) if arguments.psk else NO_PSK)]
        suites, flags = [int(number) for number in arguments.suites.split(",")], int(arguments.research)
        self._address = (255, 190) if arguments.station else (1, 1)
        if arguments.station:
            self._end = Station(static, known, suites, flags, DurableCounter(arguments.key + ".counter"))
            self._other = self._end.agents[0]
        else:
            to = [("127.0.0.1", int(port)) for port in arguments.announce.split(",")]
            self._end = Agent(static, known, suites, flags, to, arguments.suspicious)
            self._other = self._end.peers[0]
        self._flood = Flood(arguments.flood, known[0][0]) if arguments.flood else None
        self._frames = {}  # suite: frames delivered under it
        self._next_sequence = {}
        self._gaps = self._strange = self._beats = 0
        self._input = b""
        self._running = True

    def run(self):
        self._selector.register(sys.stdin.fileno(), selectors.EVENT_READ, self._read_commands)
        os.set_blocking(sys.stdin.fileno(), False)
        say(event="listening", port=self._socket.getsockname()[1])
        while self._running:
            for key, _ in self._selector.select(TICK):
                key.data()
            if self._flood:
                self._flood.tick(time.monotonic())
            self._end.tick(time.monotonic())
            self._flush()

    def _open_socket(self, port):
        """From now on everything goes out here; a socket of before is read on, for what is still on its way to it."""
        one = self._socket = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        one.setblocking(False)
        one.bind(("127.0.0.1", port))
        self._selector.register(one, selectors.EVENT_READ, lambda: self._read_socket(one))

    def _read_socket(self, one):
        while True:
            try:
                datagram, address = one.recvfrom(2048)
            except (BlockingIOError, ConnectionError):
                return
            now = time.monotonic()
            if self._flood:
                self._flood.aim(address, now)
            if self._flood is None or self._flood.is_on():
                self._end.receive(datagram, address, now)
                self._flush()

    def _flush(self):
        if self._flood and self._end.out:
            self._flood.tick(time.monotonic())  # ahead of what was computed, also if this program was held up meanwhile
        for datagram, address in self._end.out:
            try:
                self._socket.sendto(datagram, address)
            except (BlockingIOError, ConnectionError):
                pass
        for event in self._end.events:
            say(**event)
        session = self._other.session
        for plaintext in self._end.plaintexts:
            self._count(plaintext, session.switch.current.suite if session else 0)
        self._end.out.clear(), self._end.events.clear(), self._end.plaintexts.clear()

    def _count(self, plaintext, suite):
        try:
            for system, component, sequence, _ in frames(plaintext):
                expected = self._next_sequence.get((system, component), sequence)
                self._gaps += sequence != expected
                self._next_sequence[system, component] = (sequence + 1) & 0xFF
                self._frames[suite] = self._frames.get(suite, 0) + 1
        except ValueError:
            self._strange += 1

    def _read_commands(self):
        data = os.read(sys.stdin.fileno(), 4096)
        self._running = bool(data)
        *lines, self._input = (self._input + data).split(b"\n")
        for line in lines:
            self._obey(*line.decode().split())

    def _obey(self, command, number="1"):
        session, now = self._other.session, time.monotonic()
        if command == "quit":
            self._running = False
        elif command == "status":
            self._say_status(session)
        elif session is None:
            say(event="error", why="no session")
        elif command == "propose":
            session.wish(int(number))
        elif command == "roam":
            self._open_socket(0)
            session.ask()
        elif command == "close":
            self._end.close(self._other)
        elif command == "beat":
            for _ in range(int(number)):
                self._end.send(self._other, heartbeat(*self._address, self._beats))
                self._beats += 1
        self._end.tick(now)

    def _say_status(self, session):
        status = {"event": "status", "frames": self._frames, "gaps": self._gaps, "strange": self._strange}
        if session:
            status |= {"counts": session.totals(), "peer": session.peer_report, "epoch": session.switch.current.number,
                       "suite": session.switch.current.suite, "round_trip": session.round_trip.smoothed}
        say(**status)


class DurableCounter:
    """Greater with every next(), over restarts: written down before it is used."""

    def __init__(self, path):
        self._path = path
        self.last = int(open(path).read()) if os.path.exists(path) else 0

    def next(self):
        self.skip_to(self.last + 1)
        return self.last

    def skip_to(self, number):
        with open(self._path + ".new", "w") as file:
            file.write(str(number))
        os.replace(self._path + ".new", self._path)
        self.last = number


def say(**event):
    print(json.dumps(event), flush=True)


def make_key(path):
    pair = KeyPair()
    with os.fdopen(os.open(path, os.O_WRONLY | os.O_CREAT | os.O_EXCL, 0o600), "w") as file:
        file.write(pair.private.hex())
    print(to_text(pair.public))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    what = parser.add_mutually_exclusive_group(required=True)
    what.add_argument("--new-key", metavar="FILE")
    what.add_argument("--check", metavar="PROTOCOL.md")
    what.add_argument("--station", action="store_true")
    what.add_argument("--agent", action="store_true")
    parser.add_argument("--key", metavar="FILE")
    parser.add_argument("--peer", metavar="KEY", help="the other end's public key")
    parser.add_argument("--psk", metavar="HEX", help="the pair's pre-shared key")
    parser.add_argument("--port", type=int, default=0)
    parser.add_argument("--announce", metavar="PORTS", default="", help="where the agent's stations listen")
    parser.add_argument("--suites", metavar="NUMBERS", default="1,2,3,4,5,6", help="best first")
    parser.add_argument("--suspicious", action="store_true", help="agent: ask every station for a cookie")
    parser.add_argument("--flood", type=float, metavar="RATE",
                        help="station: first put the agent under load by so many made-up first messages a second")
    parser.add_argument("--research", action="store_true", help="agree to research suites")
    arguments = parser.parse_args()
    if arguments.new_key:
        make_key(arguments.new_key)
    elif arguments.check:
        sys.exit(known_answers.check(arguments.check))
    else:
        End(arguments).run()


if __name__ == "__main__":
    main()
