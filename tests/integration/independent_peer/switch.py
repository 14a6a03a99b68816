"""The live switch between epochs, as proposer and as answerer (PROTOCOL.md 8)."""

import os
from dataclasses import dataclass

from control import Accept, Confirm, Confirmed, Propose, Refuse
from epoch import Epoch
from keys import STATION, EpochKeys
from noise import KeyPair, NoiseError

PROPOSE_EVERY = 0.1
PATIENCE = 5.0
CONFIRM_LATER_EVERY = 1.0
LINGER = 3.0


@dataclass
class Proposal:
    message: Propose
    pair: KeyPair
    since: float
    next_copy: float


class Switch:
    """Owns the previous, current and next epoch. `send` takes a control message, `tell` takes an event."""

    def __init__(self, role, chain, suite, permitted, round_trip, send, tell):
        self.previous, self.current, self.next = None, Epoch(EpochKeys(chain, 0, suite), role), None
        self._role, self._permitted, self._round_trip = role, permitted, round_trip
        self._send, self._tell = send, tell
        self._own = None
        self._last_id = 0
        self._peer_id = -1
        self._answered = None  # (proposal, the answer that every copy of it gets)
        self._prepared_since = None
        self._confirming = None  # (since, next copy): committed as proposer, not confirmed yet
        self._settled = True
        self._sealed_before = 0
        self._peer_follows_since = None  # the first record of the peer under the current epoch
        self.lost_under_dead_epochs = 0
        self.random = os.urandom

    def epochs(self):
        return [epoch for epoch in (self.previous, self.current, self.next) if epoch]

    def by_bits(self, bits):
        return next((epoch for epoch in self.epochs() if epoch.number & 3 == bits), None)

    def idle(self, now):
        """Whether a new proposal may be made or accepted."""
        if not self._settled or self._own:
            return False
        return self._previous_can_be_spared(now)

    def _previous_can_be_spared(self, now):
        if self.previous is None or self.previous.complete():
            return True
        follows = self._peer_follows_since
        return self._round_trip.known() and follows is not None and now - follows > self._round_trip.generous()

    def propose(self, suite, now):
        if not self.idle(now):
            return False
        self._last_id += 1
        pair = KeyPair(self.random(32))
        self._own = Proposal(Propose(self._last_id, self.current.number + 1, suite, pair.public), pair, now, now)
        return True

    def tick(self, now):
        if self._own and now - self._own.since > PATIENCE:
            self._own = None
            self._tell({"event": "switch-failed", "why": "unanswered"})
        if self._own and now >= self._own.next_copy:
            self._send(self._own.message)
            self._own.next_copy = now + max(PROPOSE_EVERY, self._round_trip.smoothed)
        if self._confirming and now >= self._confirming[1]:
            self._send_confirm(now)
        if self._prepared_since is not None and now - self._prepared_since > PATIENCE:
            self._prepared_since = None
            self._settled = True  # the keys stay
            self._tell({"event": "switch-failed", "why": "not taken up"})
        if self.previous and self._peer_follows_since is not None:
            if now - self._peer_follows_since > max(LINGER, self._round_trip.generous()):
                self._forget_previous()

    def opened_under(self, epoch, now):
        """An authentic record came in under this epoch; its control message, if it is one, comes after this."""
        if epoch is self.next:
            self._commit(self.next, "peer", now)
        if epoch is self.current and self._peer_follows_since is None:
            self._peer_follows_since = now

    def take(self, message, now):
        {Propose: self._take_propose, Accept: self._take_accept, Refuse: self._take_refuse,
         Confirm: self._take_confirm, Confirmed: self._take_confirmed}[type(message)](message, now)

    def _take_propose(self, message, now):
        if message.id < self._peer_id or message.epoch != self.current.number + 1:
            return
        self._peer_id = message.id
        if self._answered and self._answered[0] == message:
            self._send(self._answered[1])
            return
        if self._own:
            if self._role == STATION:
                return
            self._own = None
            self._tell({"event": "switch-failed", "why": "superseded"})
        newer_than_prepared = self.next is not None
        if not newer_than_prepared and not self.idle(now):
            return
        if message.suite not in self._permitted:
            answer = Refuse(message.id)
        else:
            pair = KeyPair(self.random(32))
            try:
                keys = self.current.keys.switched(message.suite, pair, message.key, pair.public)
            except NoiseError:
                return
            self.next = Epoch(keys, self._role)
            self._prepared_since, self._settled = now, False
            answer = Accept(message.id, pair.public)
        self._answered = (message, answer)
        self._send(answer)

    def _take_accept(self, message, now):
        if not self._own or message.id != self._own.message.id:
            return
        proposal, pair = self._own.message, self._own.pair
        try:
            keys = self.current.keys.switched(proposal.suite, pair, pair.public, message.key)
        except NoiseError:
            return
        self._own = None
        self._commit(Epoch(keys, self._role), "own", now)
        self._confirming = (now, now)
        self._send_confirm(now)

    def _take_refuse(self, message, _now):
        if self._own and message.id == self._own.message.id:
            self._own = None
            self._tell({"event": "switch-failed", "why": "refused"})

    def _forget_previous(self):
        if self.previous:
            self.lost_under_dead_epochs += self.previous.lost()
        self.previous = None

    def _commit(self, epoch, whose, _now):
        self._forget_previous()
        self.previous, self.current, self.next = self.current, epoch, None
        self._sealed_before = self.previous.sealed
        self._answered = self._prepared_since = self._peer_follows_since = None
        self._settled = False
        self._tell({"event": "switched", "epoch": epoch.number, "suite": epoch.suite, "proposal": whose})

    def _send_confirm(self, now):
        since, _ = self._confirming
        pause = max(PROPOSE_EVERY, self._round_trip.smoothed) if now - since < PATIENCE else CONFIRM_LATER_EVERY
        self._confirming = (since, now + pause)
        self._send(Confirm(self.current.number, self._sealed_before))

    def _take_confirm(self, message, _now):
        if message.epoch != self.current.number:
            return
        self._take_final_count(message)
        self._send(Confirmed(self.current.number, self._sealed_before))

    def _take_confirmed(self, message, _now):
        if message.epoch == self.current.number and self._confirming:
            self._confirming = None
            self._take_final_count(message)

    def _take_final_count(self, message):
        if self.previous:
            self.previous.final_count = message.count
        if not self._settled:
            self._settled = True
            self._tell({"event": "settled", "epoch": self.current.number})
