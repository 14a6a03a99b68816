"""The first byte, and the datagrams before a session: announcement, first message, answer, cookie, number.

PROTOCOL.md 2 to 4.
"""

import hashlib
import hmac
import os
from dataclasses import dataclass

from cryptography.exceptions import InvalidTag
from cryptography.hazmat.primitives.ciphers.aead import ChaCha20Poly1305
from noise import Handshake
from suites import NAMES, RESEARCH

ANNOUNCEMENT, FIRST, ANSWER, COOKIE = 0x58, 0x59, 0x5A, 0x5B
ANNOUNCEMENT_LENGTH = FIRST_LENGTH = 127
ANSWER_LENGTH = 77
COOKIE_LENGTH, NUMBER_LENGTH = 127, 72
GREATEST_COUNTER = (1 << 40) - 1
MOST_BELIEVED = GREATEST_COUNTER // 2
PROLOGUE_DATAGRAMS = b"skyseal channel v1\x01"
NO_PSK = bytes(32)
FLAG_RESEARCH, FLAG_PLAIN = 1, 2


def kind(byte):
    """record, bare record, handshake or pairing as 0 to 3; None for what is not version 1 of the channel."""
    return (byte >> 2) & 3 if byte >> 4 == 0x5 else None


def _blake(data, length, key=b""):
    return hashlib.blake2b(data, digest_size=length, key=key).digest()


def announcement(agent_public, nonce=None):
    head = bytes([ANNOUNCEMENT]) + (nonce or os.urandom(16))
    return (head + _announcement_mac(agent_public, head)).ljust(ANNOUNCEMENT_LENGTH, b"\0")


def announces(datagram, agent_public):
    return (len(datagram) == ANNOUNCEMENT_LENGTH and datagram[0] == ANNOUNCEMENT
            and hmac.compare_digest(datagram[17:33], _announcement_mac(agent_public, datagram[:17])))


def _announcement_mac(agent_public, head):
    return _blake(head, 16, _blake(b"skyseal v1 announcement" + agent_public, 32))


def mac1(addressee_public, before):
    return _blake(before, 16, _blake(b"skyseal v1 mac1" + addressee_public, 32))


def mac1_is_right(addressee_public, datagram):
    return hmac.compare_digest(mac1(addressee_public, datagram[:-16]), datagram[-16:])


def pack_suites(suites):
    halves = [half for number in suites for half in ([number] if number < 15 else [15, number & 15, number >> 4])]
    assert len(halves) <= 12
    halves += [0] * (12 - len(halves))
    return bytes(low | high << 4 for low, high in zip(halves[::2], halves[1::2]))


def unpack_numbers(data):
    halves, numbers = iter([half for byte in data for half in (byte & 15, byte >> 4)]), []
    for half in halves:
        if half < 15:
            numbers.append(half)
            continue
        low, high = next(halves, None), next(halves, None)
        if high is not None and low + 16 * high >= 15:
            numbers.append(low + 16 * high)
    return [number for number in dict.fromkeys(numbers) if number]


def unpack_suites(data):
    return [number for number in unpack_numbers(data) if number in NAMES]


@dataclass
class Offer:
    """What one end says of itself within the handshake."""
    flags: int
    connection: int
    suites: list

    def pack(self):
        return bytes([self.flags]) + self.connection.to_bytes(2, "little") + pack_suites(self.suites)

    @staticmethod
    def unpack(data):
        return Offer(data[0], int.from_bytes(data[1:3], "little"), unpack_suites(data[3:9]))


def permitted(station, agent):
    """Suites that both offer, in the station's order."""
    research = station.flags & agent.flags & FLAG_RESEARCH
    return [suite for suite in station.suites if suite in agent.suites and (research or suite not in RESEARCH)]


def choose(station, agent):
    return next((suite for suite in permitted(station, agent) if suite not in RESEARCH), None)


def station_handshake(static, agent_public, psk=NO_PSK, ephemeral=None, prologue=PROLOGUE_DATAGRAMS):
    return Handshake("IKpsk2", True, prologue, static, agent_public, psk, ephemeral)


def agent_handshake(static, ephemeral=None, prologue=PROLOGUE_DATAGRAMS):
    return Handshake("IKpsk2", False, prologue, static, ephemeral=ephemeral)


def write_first(handshake, agent_public, offer, counter):
    message = bytes([FIRST]) + handshake.write_message(offer.pack() + counter.to_bytes(5, "little"))
    return message + mac1(agent_public, message)


def read_first(handshake, datagram):
    """(offer, counter); NoiseError when it does not open. mac1 was checked before."""
    payload = handshake.read_message(datagram[1:-16])
    return Offer.unpack(payload), int.from_bytes(payload[9:14], "little")


def write_answer(handshake, station_public, station_connection, offer, chosen):
    message = bytes([ANSWER]) + station_connection.to_bytes(2, "little")
    message += handshake.write_message(offer.pack() + bytes([chosen]))
    return message + mac1(station_public, message)


def read_answer(handshake, datagram):
    """(offer, chosen suite); NoiseError when it does not open. mac1 was checked before."""
    payload = handshake.read_message(datagram[3:-16])
    return Offer.unpack(payload), payload[9]


def write_number(handshake, station_public, station_connection, remembered):
    """The greatest counter that the agent remembers, for a station that lost its own."""
    message = bytes([COOKIE]) + station_connection.to_bytes(2, "little")
    message += handshake.write_message(min(remembered, GREATEST_COUNTER).to_bytes(5, "little"))
    return message + mac1(station_public, message)


def read_number(handshake, datagram):
    """The number; NoiseError when it does not open. mac1 was checked before."""
    return int.from_bytes(handshake.read_message(datagram[3:-16]), "little")


def _cookie_cipher(agent_public, nonce, mac):
    return ChaCha20Poly1305(_blake(nonce + mac, 32, _blake(b"skyseal v1 cookie" + agent_public, 32)))


def cookie_message(agent_public, cookie, first, nonce=None):
    """A cookie in answer to a first message whose mac1 is right."""
    nonce = nonce or os.urandom(16)
    sealed = _cookie_cipher(agent_public, nonce, first[-16:]).encrypt(bytes(12), cookie, b"")
    return (bytes([COOKIE]) + nonce + sealed).ljust(COOKIE_LENGTH, b"\0")


def open_cookie(agent_public, datagram, first):
    """The cookie that answers this first message; None when it answers another."""
    if any(datagram[49:]):
        return None
    try:
        return _cookie_cipher(agent_public, datagram[1:17], first[-16:]).decrypt(bytes(12), datagram[17:49], b"")
    except InvalidTag:
        return None


def under_cookie(first, cookie):
    """The same first message with a MAC under the cookie in place of mac1."""
    return first[:-16] + _blake(first[:-16], 16, cookie)
