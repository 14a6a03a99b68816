"""The agent: announces itself and answers first messages (PROTOCOL.md 3, 4 and 9). No socket, no clock of its own."""

import hashlib
import os
import random
from dataclasses import dataclass

import wire
from keys import AGENT
from noise import NoiseError
from session import Ids, Session

ANNOUNCE_EVERY = 0.5
QUIET = 1.5
UNCONFIRMED_LIFE = 10.0
RATE, BURST = 50.0, 20.0
LEFT_FOR_COOKIES = 10.0
NUMBER_EVERY = 0.2


@dataclass
class Unconfirmed:
    """A session that was answered and waits for the station's first record."""
    first: bytes
    answer: bytes
    counter: int
    session: Session
    address: tuple
    since: float


class Peer:
    """A station that the agent knows."""

    def __init__(self, public, psk):
        self.public, self.psk = public, psk
        self.counter = 0  # of the newest confirmed first message
        self.unconfirmed = None
        self.session = None
        self.address = None


class Agent:
    """`out` collects (datagram, address), `events` dicts for the owner, `plaintexts` what the sessions delivered."""

    def __init__(self, static, stations, suites, flags, announce_to, suspicious=False):
        self.out, self.events, self.plaintexts = [], [], []
        self.peers = [Peer(public, psk) for public, psk in stations]
        self._static, self._suites, self._flags, self._announce_to = static, suites, flags, announce_to
        self._next_announcement = 0.0
        self._tokens, self._tokens_at = BURST, None
        self._number_told = 0.0
        self._suspicious = suspicious  # asks for a cookie always, not under load alone
        self._cookie_secret = os.urandom(32)  # not replaced: this agent does not live for minutes
        self._last_connection = random.randrange(0x10000)

    def receive(self, datagram, address, now):
        kind = wire.kind(datagram[0]) if datagram else None
        if kind == 0:
            self._take_record(datagram, address, now)
        elif kind == 2 and datagram[0] == wire.FIRST and len(datagram) == wire.FIRST_LENGTH:
            self._take_first(datagram, address, now)

    def tick(self, now):
        for peer in self.peers:
            if peer.unconfirmed and now - peer.unconfirmed.since > UNCONFIRMED_LIFE:
                peer.unconfirmed = None
            if peer.session:
                peer.session.tick(now)
                self._collect(peer)
                if peer.session.ended:
                    self.events.append({"event": "ended", "why": peer.session.ended,
                                        "counts": peer.session.totals()})
                    peer.session = None
        if now >= self._next_announcement:
            self._next_announcement = now + ANNOUNCE_EVERY
            self._announce(now)

    def send(self, peer, plaintext):
        peer.session.send(plaintext)
        self._collect(peer)

    def close(self, peer):
        peer.session.close()
        self._collect(peer)

    def _announce(self, now):
        quiet = [peer for peer in self.peers if peer.session and now - peer.session.last_heard > QUIET]
        if quiet or not any(peer.session for peer in self.peers):
            targets = {*self._announce_to, *(peer.address for peer in quiet)}
            self.out += [(wire.announcement(self._static.public), target) for target in targets]

    def _take_first(self, datagram, address, now):
        has_cookie = not wire.mac1_is_right(self._static.public, datagram)
        if has_cookie and datagram != wire.under_cookie(datagram, self._cookie(address)):
            return self._refuse("WrongKey")
        for peer in self.peers:
            if peer.unconfirmed and peer.unconfirmed.first[:-16] == datagram[:-16]:
                self.out.append((peer.unconfirmed.answer, address))
                return None
        self._refill(now)
        if not has_cookie and (self._suspicious or self._tokens < LEFT_FOR_COOKIES + 1):
            self.events.append({"event": "cookie"})
            self.out.append((wire.cookie_message(self._static.public, self._cookie(address), datagram), address))
            return None
        if not self._may_compute():
            return None
        handshake = wire.agent_handshake(self._static)
        try:
            offer, counter = wire.read_first(handshake, datagram)
        except NoiseError:
            return self._refuse("WrongKey")
        peer = next((peer for peer in self.peers if peer.public == handshake.remote_static), None)
        if peer is None:
            return self._refuse("UnknownPeer")
        handshake.set_psk(peer.psk)
        if counter <= peer.counter and now - self._number_told >= NUMBER_EVERY:
            self._number_told = now
            number = wire.write_number(handshake, peer.public, offer.connection, peer.counter)
            self.out.append((number, address))
        if counter <= max(peer.counter, peer.unconfirmed.counter if peer.unconfirmed else 0):
            return self._refuse("ReplayedHandshake")
        if peer.session:
            peer.session.ask()
            self._collect(peer)
        own = wire.Offer(self._flags, self._new_connection(), self._suites)
        chosen = wire.choose(offer, own)
        if chosen is None:
            return self._refuse("NoCommonSuite")
        answer = wire.write_answer(handshake, peer.public, offer.connection, own, chosen)
        session = Session(AGENT, handshake, Ids(own.connection, offer.connection), chosen, wire.permitted(offer, own), now)
        peer.unconfirmed = Unconfirmed(datagram, answer, counter, session, address, now)
        self.out.append((answer, address))
        return None

    def _refuse(self, why):
        self.events.append({"event": "refused", "why": why})

    def _cookie(self, address):
        return hashlib.blake2b(repr(address).encode(), digest_size=16, key=self._cookie_secret).digest()

    def _refill(self, now):
        if self._tokens_at is not None:
            self._tokens = min(BURST, self._tokens + (now - self._tokens_at) * RATE)
        self._tokens_at = now

    def _may_compute(self):
        if self._tokens < 1:
            return False
        self._tokens -= 1
        return True

    def _take_record(self, datagram, address, now):
        connection = int.from_bytes(datagram[1:3], "little")
        for peer in self.peers:
            if peer.session and peer.session.ids.own == connection:
                _, moves = peer.session.receive(datagram, now)
                if moves and address != peer.address:
                    peer.address = address
                    self.events.append({"event": "moved"})
                self._collect(peer)
            elif peer.unconfirmed and peer.unconfirmed.session.ids.own == connection:
                self._confirm(peer, datagram, address, now)

    def _confirm(self, peer, datagram, address, now):
        waiting = peer.unconfirmed
        authentic, _ = waiting.session.receive(datagram, now)
        if not authentic:
            return
        if peer.session:
            self.events.append({"event": "ended", "why": "peer restarted", "counts": peer.session.totals()})
        peer.counter, peer.session, peer.address, peer.unconfirmed = waiting.counter, waiting.session, address, None
        self.events.append({"event": "session", "suite": peer.session.switch.current.suite,
                            "permitted": peer.session.permitted})
        self._collect(peer)

    def _collect(self, peer):
        session = peer.session
        self.out += [(datagram, peer.address) for datagram in session.out]
        self.events += session.events
        self.plaintexts += session.plaintexts
        session.out.clear(), session.events.clear(), session.plaintexts.clear()

    def _new_connection(self):
        self._last_connection = (self._last_connection + 1) & 0xFFFF
        return self._last_connection
