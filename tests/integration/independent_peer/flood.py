"""First messages of stations unknown to the agent, sent from a socket of their own to put the agent under load."""

import os
import socket

import wire
from noise import KeyPair

AHEAD = 60  # messages of the flood before the station sends its first one
POOL = 20  # different messages, made in advance: the flood must not depend on the speed of this program


class Flood:
    def __init__(self, rate, agent_public):
        self._rate = rate
        self._messages = [self._message(agent_public) for _ in range(POOL)]
        self._target = self._since = None
        self._sent = 0
        self._socket = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self._socket.setblocking(False)

    def aim(self, address, now):
        if self._target is None:
            self._target, self._since = address, now

    def tick(self, now):
        while self._target and self._sent < (now - self._since) * self._rate:
            self._socket.sendto(self._messages[self._sent % POOL], self._target)
            self._sent += 1

    def is_on(self):
        return self._sent >= AHEAD

    @staticmethod
    def _message(agent_public):
        handshake = wire.station_handshake(KeyPair(), agent_public)
        offer = wire.Offer(0, int.from_bytes(os.urandom(2), "little"), [1])
        return wire.write_first(handshake, agent_public, offer, 1)
