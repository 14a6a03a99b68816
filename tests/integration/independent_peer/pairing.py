"""The messages by which two devices that do not know each other exchange their keys: CPace, openings, and sealed words."""

import hashlib
from dataclasses import dataclass, field

from cryptography.exceptions import InvalidTag
from cryptography.hazmat.primitives.ciphers.aead import ChaCha20Poly1305
from keys import AGENT, STATION
from ristretto import Cpace
from suites import hkdf_expand, hkdf_extract

CALL, FIRST, ANSWER, SEALED = 0x5C, 0x5D, 0x5E, 0x5F
LENGTH, ANSWER_LENGTH, OPENING_LENGTH, WORD_LENGTH = 127, 69, 95, 22
NONE, YES, NO = range(3)
ALL_IS_SAID = 3
SIDES = {STATION: b"station", AGENT: b"agent"}


class Refused(Exception):
    """A message that does not belong to this pairing."""


@dataclass
class Opening:
    """What an end says about itself."""

    key: bytes
    system: int
    name: str
    nonce: bytes

    def pack(self):
        return self.key + bytes([self.system]) + self.name.encode().ljust(24, b"\0") + self.nonce

    @staticmethod
    def unpack(data):
        return Opening(data[:32], data[32], data[33:57].rstrip(b"\0").decode(), data[57:])

    def commitment(self):
        return hashlib.blake2b(b"skyseal v1 pairing commitment" + self.pack(), digest_size=32).digest()


def call(token):
    return (bytes([CALL]) + token).ljust(LENGTH, b"\0")


def request():
    return call(b"")


@dataclass
class Pairing:
    """One end's handshake."""

    side: int
    static: object  # KeyPair
    number: int
    token: bytes
    mine: Opening
    scalar: bytes
    passphrase: bytes = b""
    theirs: Opening = None
    first: bytes = None
    answer: bytes = None
    openings: dict = field(default_factory=dict)  # by side, as sent

    def __post_init__(self):
        session = self.token + _id(self.number)
        self.cpace = Cpace(self.passphrase, b"skyseal pairing v1\x01", session, self.scalar)

    def write_first(self):
        self.first = (bytes([FIRST]) + _id(self.number) + self.token + self.cpace.share).ljust(LENGTH, b"\0")
        return self.first

    def read_first(self, datagram):
        self.first = datagram
        self._agree(datagram[21:53], (datagram[21:53], b""), (self.cpace.share, self.mine.commitment()))

    def write_answer(self):
        self.answer = bytes([ANSWER]) + _id(self.number) + self.cpace.share + self.mine.commitment()
        return self.answer

    def read_answer(self, datagram):
        self.answer = datagram
        self._agree(datagram[5:37], (self.cpace.share, b""), (datagram[5:37], datagram[37:69]))

    def _agree(self, theirs, initiator, responder):
        isk = self.cpace.key(theirs, initiator, responder)
        if isk is None:
            raise Refused("the share is invalid")
        self.root = hkdf_extract(b"skyseal pairing v1", isk)

    def _opening_cipher(self, side):
        return ChaCha20Poly1305(hkdf_expand(self.root, b"skyseal v1 pairing opening " + SIDES[side], 32))

    def write_opening(self):
        head = bytes([SEALED]) + _id(self.number) + b"\0"
        self.openings[self.side] = head + self._opening_cipher(self.side).encrypt(bytes(12), self.mine.pack(), head)
        return self.openings[self.side]

    def read_opening(self, datagram):
        other = AGENT if self.side == STATION else STATION
        try:
            opened = self._opening_cipher(other).decrypt(bytes(12), datagram[6:], datagram[:6])
        except InvalidTag as error:
            raise Refused("another passphrase, or changed on its way") from error
        theirs = Opening.unpack(opened)
        if other == AGENT and theirs.commitment() != self.answer[37:]:
            raise Refused("not what was committed to")
        self.openings[other], self.theirs = datagram, theirs
        return theirs

    def code(self):
        station, agent = (self.mine, self.theirs) if self.side == STATION else (self.theirs, self.mine)
        text = b"skyseal v1 pairing code" + self.first + self.answer + station.nonce + agent.nonce
        number = int.from_bytes(hashlib.blake2b(text, digest_size=32).digest()[:8], "little") % 10**6
        return f"{number // 1000:03} {number % 1000:03}"

    def _derived(self, use):
        secret = hkdf_extract(self.root, self.static.dh(self.theirs.key))
        context = hashlib.blake2b(self.openings[STATION] + self.openings[AGENT], digest_size=32).digest()
        return hkdf_expand(secret, b"skyseal v1 pairing " + use + context, 32)

    def preshared_key(self):
        return self._derived(b"preshared key")

    def word_key(self, side):
        return self._derived(b"words " + SIDES[side])


def word(key, number, mine, heard):
    nonce = 0x80 | mine << 2 | heard
    head = bytes([SEALED]) + _id(number) + bytes([nonce])
    return head + ChaCha20Poly1305(key).encrypt(bytes(4) + nonce.to_bytes(8, "little"), b"", head)


def hear(key, datagram):
    """(decision of the sender, what it heard of ours); None for what is not authentic."""
    nonce = datagram[5]
    try:
        ChaCha20Poly1305(key).decrypt(bytes(4) + nonce.to_bytes(8, "little"), datagram[6:], datagram[:6])
    except InvalidTag:
        return None
    return nonce >> 2 & 3, nonce & 3


def _id(number):
    return number.to_bytes(4, "little")
