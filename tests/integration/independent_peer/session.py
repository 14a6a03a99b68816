"""One session: records in and out, reports, the switch, the close (PROTOCOL.md 6 to 9). No socket, no clock of its own."""

from collections import Counter
from dataclasses import dataclass

import control
import freshness
from epoch import record_counter
from freshness import AGE, OVERTAKEN, Freshness
from keys import STATION, first_chain
from round_trip import RoundTrip
from suites import WrongTag
from switch import Switch

DATAGRAMS = 0x01
LONGEST, SHORTEST = 1200, 22
REPORT_EVERY, REPORT_EARLY = 1.0, 0.25
CLOSE_LINGER = 3.0
QUIET = 1.5
FORGET = 600.0
ANSWER_NOW = 1


@dataclass
class Ids:
    own: int  # what the peer puts into its records
    peer: int  # what goes into ours


class Session:
    """Fed with datagrams and the time; what it wants to send, tell and deliver it appends to out, events and plaintexts."""

    def __init__(self, role, handshake, ids, suite, permitted, now):
        self.out, self.events, self.plaintexts = [], [], []
        self.ids, self.role, self.permitted = ids, role, permitted
        self.counts = Counter()
        self.round_trip = RoundTrip()
        self.last_heard = now
        self.heard_any = False
        self.ended = None
        self._closing_until = self._wished = None
        self.peer_report = {}
        self._next_report = now
        self._newest_stamp = self._newest_stamp_at = None
        chain = first_chain(handshake.h, *handshake.split())
        self.switch = Switch(role, chain, suite, permitted, self.round_trip, self._send_control, self.events.append)
        self._now = self._began = now
        self.freshness = Freshness(now)

    def send(self, frames):
        self._seal(freshness.stamp(self._stamp(self._now)) + frames if self.role == STATION else frames)

    def _seal(self, plaintext):
        datagram = self.switch.current.seal(self.ids.peer, plaintext, DATAGRAMS)
        self.counts["sent_records"] += 1
        self.counts["sent_bytes"] += len(datagram)
        self.out.append(datagram)

    def wish(self, suite):
        """Proposes a switch as soon as one may be proposed."""
        self._wished = suite

    def ask(self):
        """A report that asks for an answer, to find out whether the peer still has this session."""
        self._send_report(self._now, ask=True)

    def close(self):
        self._send_control(control.Close())
        self.ended = "closed here"

    def tick(self, now):
        self._now = now
        if self.ended:
            return
        if now - self.last_heard > FORGET:
            self.ended = "timed out"
        if self._closing_until is not None and (now > self._closing_until or self.lost() == 0):
            self.ended = "peer closed"
        if self.ended or self._closing_until is not None:
            return
        if self._wished is not None and self.switch.propose(self._wished, now):
            self._wished = None
        self.switch.tick(now)
        if now >= self._next_report:
            self._send_report(now, ask=not self.round_trip.known())

    def receive(self, datagram, now):
        """(authentic, whether it moves the address). The caller found the session by the connection id."""
        self._now = now
        if not SHORTEST <= len(datagram) <= LONGEST:
            self.counts["malformed"] += 1
            return False, False
        epoch = self.switch.by_bits(datagram[0] & 3)
        counter = record_counter(datagram)
        if epoch is None or not epoch.window.fresh(counter):
            self.counts["replayed"] += 1
            return False, False
        try:
            plaintext = epoch.open(datagram, DATAGRAMS)
        except WrongTag:
            self.counts["forged"] += 1
            return False, False
        newest = epoch.window.take(counter)
        self.counts["good"] += 1
        self.counts["late"] += not newest
        self.last_heard, self.heard_any = now, True
        self.switch.opened_under(epoch, now)
        position = epoch.number << 24 | counter
        self.freshness.arrived(now, position)
        moves = newest and epoch is self.switch.current
        if plaintext and plaintext[0] < 0x10:
            self._take_control(plaintext, now)
        elif plaintext:
            peer_stamp, frames = freshness.split(plaintext)
            self.counts["opened_bytes"] += len(frames)
            if self.role == STATION or self.freshness.may_command(now, position, peer_stamp, self._closing_until is not None):
                self.plaintexts.append(frames)
        return True, moves

    def totals(self):
        """What this end received and sent, by the names of a report."""
        return {name: self.counts[name] for name in control.REPORT_NUMBERS} | {"lost": self.lost()}

    def lost(self):
        return self.switch.lost_under_dead_epochs + sum(epoch.lost() for epoch in self.switch.epochs())

    def _take_control(self, plaintext, now):
        try:
            message = control.unpack(plaintext)
        except control.Malformed:
            self.counts["malformed"] += 1
            return
        if isinstance(message, control.Report):
            self._take_report(message, now)
        elif isinstance(message, control.Close):
            if self._closing_until is None:
                self._closing_until = now + max(CLOSE_LINGER, self.round_trip.generous())
        else:
            self.switch.take(message, now)

    def _take_report(self, report, now):
        newer = self._newest_stamp is None or 0 < (report.stamp - self._newest_stamp) & 0xFFFFFFFF < 1 << 31
        if newer:
            self._newest_stamp, self._newest_stamp_at = report.stamp, now
            self.peer_report = report.numbers
            if report.echo:
                sample = (self._stamp(now) - report.echo - report.held) & 0xFFFFFFFF
                if sample < 1 << 31:
                    self.round_trip.take(sample / 1e6)
                    self.freshness.answered(now, sample / 1e6, report.held / 1e6, report.stamp)
        if report.flags & ANSWER_NOW:
            self._send_report(now, ask=False)

    def _send_report(self, now, ask):
        self._next_report = now + (REPORT_EARLY if not self.round_trip.known() else REPORT_EVERY)
        held = 0 if self._newest_stamp is None else round((now - self._newest_stamp_at) * 1e6)
        flags = ANSWER_NOW if ask else 0
        numbers = self.totals()
        if self.role != STATION:
            flags |= control.TELLS_FRESHNESS | (control.RECEIVES_NOTHING if now - self.last_heard >= QUIET else 0)
            numbers |= {"stale": self.freshness.stale, "age_us": max(0, round(self.freshness.age * 1e6)),
                        "overtaken_limit_ms": round(1000 * OVERTAKEN), "age_limit_ms": round(1000 * AGE)}
        self._send_control(control.Report(flags, self._stamp(now), self._newest_stamp or 0, held, numbers))

    def _stamp(self, now):
        return int((now - self._began) * 1e6) & 0xFFFFFFFF | 1  # never 0

    def _send_control(self, message):
        self._seal(message.pack())
