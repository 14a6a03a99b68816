"""The station: hears announcements, starts handshakes, holds sessions (PROTOCOL.md 3, 4 and 9). No socket, no clock."""

import random

import wire
from dataclasses import dataclass, field
from keys import STATION
from noise import NoiseError
from session import Ids, Session

QUIET, SILENT = 1.25, 2.5
RETRIES = (0.25, 0.5, 1.0, 2.0)
COPIES, RENEW_AFTER = 4, 5.0
ATTEMPT_LIFE = 10.0
PLACES = 4
CLOSEST_COPIES = 0.05
COOKIE_LIFE = 120.0


@dataclass
class Place:
    """An address where the agent may be. Until it is proven only announcements from there are answered, one for one."""
    address: tuple
    proven: bool = False
    last_copy: float = float("-inf")
    cookie: bytes = None
    cookie_until: float = 0.0
    cookies_turn: bool = False


@dataclass
class Attempt:
    """One try to reach one agent: the first message as it stands, and when its next copy is due."""
    handshake: object = None
    offer: object = None
    message: bytes = b""
    made: float = 0.0
    copies_of_this: int = 0
    uncookied: int = 0  # copies with mac1 that a cookie may still answer
    copies: int = 0
    next_copy: float = 0.0
    wanted_until: float = 0.0
    places: list = field(default_factory=list)

    def place(self, address):
        found = next((place for place in self.places if place.address == address), None)
        if found is None:
            if len(self.places) == PLACES:
                self.places.remove(next((place for place in self.places if not place.proven), self.places[0]))
            found = Place(address)
            self.places.append(found)
        return found


class Agent:
    """What the station holds about one agent that it knows."""

    def __init__(self, public, psk):
        self.public, self.psk = public, psk
        self.attempt = None
        self.session = None
        self.address = None


class Station:
    """`out` collects (datagram, address), `events` dicts for the owner, `plaintexts` what the sessions delivered."""

    def __init__(self, static, agents, suites, flags, counter):
        self.out, self.events, self.plaintexts = [], [], []
        self.agents = [Agent(public, psk) for public, psk in agents]
        self._static, self._suites, self._flags = static, suites, flags
        self._counter = counter  # next(): a number greater than any before; skip_to(): goes on above another
        self._last_connection = random.randrange(0x10000)

    def receive(self, datagram, address, now):
        kind = wire.kind(datagram[0]) if datagram else None
        if kind == 0:
            self._take_record(datagram, address, now)
        elif kind == 2 and datagram[0] == wire.ANNOUNCEMENT:
            self._take_announcement(datagram, address, now)
        elif kind == 2 and datagram[0] == wire.ANSWER and len(datagram) == wire.ANSWER_LENGTH:
            self._take_answer(datagram, address, now)
        elif kind == 2 and datagram[0] == wire.COOKIE and len(datagram) == wire.COOKIE_LENGTH:
            self._take_cookie(datagram, address, now)
        elif kind == 2 and datagram[0] == wire.COOKIE and len(datagram) == wire.NUMBER_LENGTH:
            self._take_number(datagram, address, now)

    def tick(self, now):
        for agent in self.agents:
            session, attempt = agent.session, agent.attempt
            if session:
                session.tick(now)
                self._collect(agent)
                if session.ended:
                    self.events.append({"event": "ended", "why": session.ended, "counts": session.totals()})
                    agent.session = None
                elif now - session.last_heard > SILENT:
                    agent.attempt = attempt = attempt or Attempt()
                    attempt.place(agent.address).proven = True
                    attempt.wanted_until = now + ATTEMPT_LIFE
            if attempt and now > attempt.wanted_until:
                agent.attempt = None
            elif attempt and now >= attempt.next_copy:
                self._send_copies(agent, now)

    def send(self, agent, plaintext):
        agent.session.send(plaintext)
        self._collect(agent)

    def close(self, agent):
        agent.session.close()
        self._collect(agent)

    def _take_announcement(self, datagram, address, now):
        agent = next((agent for agent in self.agents if wire.announces(datagram, agent.public)), None)
        if agent is None or (agent.session and now - agent.session.last_heard < QUIET):
            return
        attempt = agent.attempt = agent.attempt or Attempt(next_copy=now + RETRIES[0])
        attempt.wanted_until = now + ATTEMPT_LIFE
        place = attempt.place(address)
        if now - place.last_copy >= CLOSEST_COPIES:
            self._renew(agent, now)
            self._send_first(agent, place, now)

    def _send_copies(self, agent, now):
        attempt = agent.attempt
        attempt.next_copy = now + RETRIES[min(attempt.copies, len(RETRIES) - 1)] * random.uniform(0.75, 1.25)
        attempt.copies += 1
        places = [place for place in attempt.places if place.proven]
        if places:
            self._renew(agent, now)
        for place in places:
            self._send_first(agent, place, now)

    def _renew(self, agent, now):
        """A fresh first message, when there is none or the present one had its chances."""
        attempt = agent.attempt
        if attempt.message and (attempt.copies_of_this < COPIES or now - attempt.made < RENEW_AFTER):
            return
        self._make_first(agent, now)

    def _make_first(self, agent, now):
        attempt = agent.attempt
        attempt.handshake = wire.station_handshake(self._static, agent.public, agent.psk)
        attempt.offer = wire.Offer(self._flags, self._new_connection(), self._suites)
        attempt.message = wire.write_first(attempt.handshake, agent.public, attempt.offer, self._counter.next())
        attempt.made, attempt.copies_of_this, attempt.uncookied = now, 0, 0

    def _send_first(self, agent, place, now):
        message = agent.attempt.message
        has_cookie = place.cookie and now < place.cookie_until
        if has_cookie and place.cookies_turn:
            message = wire.under_cookie(message, place.cookie)
        else:
            agent.attempt.uncookied += 1
        place.cookies_turn = has_cookie and not place.cookies_turn
        place.last_copy = now
        agent.attempt.copies_of_this += 1
        self.out.append((message, place.address))

    def _take_cookie(self, datagram, address, now):
        for agent in self.agents:
            attempt = agent.attempt
            if not attempt or not attempt.uncookied:
                continue
            cookie = wire.open_cookie(agent.public, datagram, attempt.message)
            if cookie is None:
                continue
            attempt.uncookied -= 1
            place = attempt.place(address)
            place.cookie, place.cookie_until, place.cookies_turn = cookie, now + COOKIE_LIFE, True
            self.events.append({"event": "cookie"})
            self._send_first(agent, place, now)

    def _take_number(self, datagram, address, now):
        """The agent remembers a greater counter than ours."""
        for agent, handshake in self._attempts_that_read(datagram):
            try:
                number = wire.read_number(handshake, datagram)
            except NoiseError:
                continue
            if not self._counter.last <= number <= wire.MOST_BELIEVED:
                continue
            self._counter.skip_to(number)
            place = agent.attempt.place(address)
            place.proven = True
            self.events.append({"event": "number", "number": number})
            self._make_first(agent, now)
            self._send_first(agent, place, now)

    def _take_answer(self, datagram, address, now):
        for agent, handshake in self._attempts_that_read(datagram):
            try:
                offer, chosen = wire.read_answer(handshake, datagram)
            except NoiseError:
                continue
            if chosen != wire.choose(agent.attempt.offer, offer):
                self.events.append({"event": "wrong-choice", "suite": chosen})
                agent.attempt = None
                continue
            self._begin(agent, handshake, agent.attempt.offer, offer, chosen, address, now)

    def _attempts_that_read(self, datagram):
        """The attempts that a second Noise message may belong to, each with a copy of its handshake to try it on."""
        connection = int.from_bytes(datagram[1:3], "little")
        if not wire.mac1_is_right(self._static.public, datagram):
            return []
        return [(agent, agent.attempt.handshake.copy()) for agent in self.agents
                if agent.attempt and agent.attempt.offer and agent.attempt.offer.connection == connection]

    def _begin(self, agent, handshake, own, offer, chosen, address, now):
        if agent.session:
            self.events.append({"event": "ended", "why": "peer restarted", "counts": agent.session.totals()})
        agent.session = Session(STATION, handshake, Ids(own.connection, offer.connection), chosen,
                                wire.permitted(own, offer), now)
        agent.address, agent.attempt = address, None
        self.events.append({"event": "session", "suite": chosen, "permitted": agent.session.permitted})
        agent.session.tick(now)
        self._collect(agent)

    def _take_record(self, datagram, address, now):
        connection = int.from_bytes(datagram[1:3], "little")
        agent = next((agent for agent in self.agents if agent.session and agent.session.ids.own == connection), None)
        if agent is None:
            return
        authentic, moves = agent.session.receive(datagram, now)
        if authentic:
            agent.attempt = None
        if moves and address != agent.address:
            agent.address = address
            self.events.append({"event": "moved"})
        self._collect(agent)

    def _collect(self, agent):
        session = agent.session
        self.out += [(datagram, agent.address) for datagram in session.out]
        self.events += session.events
        self.plaintexts += session.plaintexts
        session.out.clear(), session.events.clear(), session.plaintexts.clear()

    def _new_connection(self):
        self._last_connection = (self._last_connection + 1) & 0xFFFF
        return self._last_connection
