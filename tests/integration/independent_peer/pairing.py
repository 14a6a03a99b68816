"""The messages by which two devices that do not know each other exchange their keys: Noise XXpsk3 and sealed words."""

from dataclasses import dataclass

from cryptography.exceptions import InvalidTag
from cryptography.hazmat.primitives.ciphers.aead import ChaCha20Poly1305
from noise import Handshake
from suites import hkdf_expand, hkdf_extract

CALL, FIRST, ANSWER, SEALED = 0x5C, 0x5D, 0x5E, 0x5F
LENGTH, THIRD_LENGTH, WORD_LENGTH = 127, 96, 22
WANTS_PSK, HAS_PASSPHRASE = 1, 2
PILOT, OBSERVER = 0, 1
NONE, YES, NO = range(3)
ALL_IS_SAID = 3


@dataclass
class About:
    flags: int
    role: int
    name: str

    def pack(self):
        return bytes([self.flags, self.role]) + self.name.encode().ljust(24, b"\0")

    @staticmethod
    def unpack(data):
        return About(data[0], data[1], data[2:].rstrip(b"\0").decode())


def call(token):
    return (bytes([CALL]) + token).ljust(LENGTH, b"\0")


def handshake(initiator, static, number, token, passphrase_key=bytes(32), ephemeral=None):
    prologue = b"skyseal pairing v1\x01" + _id(number) + token
    return Handshake("XXpsk3", initiator, prologue, static, psk=passphrase_key, ephemeral=ephemeral)


def write_first(noise, number, token):
    return bytes([FIRST]) + _id(number) + token + noise.write_message(bytes(58))


def read_first(noise, datagram):
    noise.read_message(datagram[21:])


def write_answer(noise, number, about):
    return bytes([ANSWER]) + _id(number) + noise.write_message(about.pack())


def read_answer(noise, datagram):
    return About.unpack(noise.read_message(datagram[5:]))


def write_third(noise, number, about):
    return bytes([SEALED]) + _id(number) + b"\0" + noise.write_message(about.pack())


def read_third(noise, datagram):
    return About.unpack(noise.read_message(datagram[6:]))


def preshared_key(noise):
    """What the pair shares from now on, when both ends want it."""
    return hkdf_expand(hkdf_extract(noise.h, b"".join(noise.split())), b"skyseal v1 pairing preshared key", 32)


def word(key, number, mine, heard):
    """`key` is k1 for the station's words, k2 for the agent's."""
    nonce = 0x80 | mine << 2 | heard
    head = bytes([SEALED]) + _id(number) + bytes([nonce])
    return head + ChaCha20Poly1305(key).encrypt(bytes(4) + nonce.to_bytes(8, "little"), b"", head)


def hear(key, datagram):
    """(what its person decided, what it heard of ours); None for what is not authentic."""
    nonce = datagram[5]
    try:
        ChaCha20Poly1305(key).decrypt(bytes(4) + nonce.to_bytes(8, "little"), datagram[6:], datagram[:6])
    except InvalidTag:
        return None
    return nonce >> 2 & 3, nonce & 3


def _id(number):
    return number.to_bytes(4, "little")
