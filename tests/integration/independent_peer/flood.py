"""First messages of stations that nobody knows, sent from a socket of their own to put an agent under load."""

import os
import socket

import wire
from noise import KeyPair

AHEAD = 60  # so many go out before the station itself may start


class Flood:
    def __init__(self, rate, agent_public):
        self._rate, self._agent_public = rate, agent_public
        self._target = self._since = None
        self._sent = 0
        self._socket = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self._socket.setblocking(False)

    def aim(self, address, now):
        if self._target is None:
            self._target, self._since = address, now

    def tick(self, now):
        while self._target and self._sent < (now - self._since) * self._rate:
            self._sent += 1
            handshake = wire.station_handshake(KeyPair(), self._agent_public)
            offer = wire.Offer(0, int.from_bytes(os.urandom(2), "little"), [1])
            self._socket.sendto(wire.write_first(handshake, self._agent_public, offer, 1), self._target)

    def is_on(self):
        return self._sent >= AHEAD
