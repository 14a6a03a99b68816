"""The Noise Protocol Framework, revision 34, for the pattern that Skyseal uses.

Written from the specification (sections 5 and 9) with X25519, ChaCha20-Poly1305 and BLAKE2b. Names are the specification's.
"""

import copy
import hashlib
import hmac

from cryptography.exceptions import InvalidTag
from cryptography.hazmat.primitives.asymmetric.x25519 import X25519PrivateKey, X25519PublicKey
from cryptography.hazmat.primitives.ciphers.aead import ChaCha20Poly1305
from cryptography.hazmat.primitives.serialization import Encoding, NoEncryption, PrivateFormat, PublicFormat

DH_LENGTH = 32
TAG_LENGTH = 16

# (the responder's static key is known beforehand, the tokens of each message)
PATTERNS = {
    "IKpsk2": (True, (("e", "es", "s", "ss"), ("e", "ee", "se", "psk"))),
}


class NoiseError(Exception):
    """A handshake message that does not open."""


class KeyPair:
    def __init__(self, private=None):
        key = X25519PrivateKey.from_private_bytes(private) if private else X25519PrivateKey.generate()
        self._key = key
        self.private = key.private_bytes(Encoding.Raw, PrivateFormat.Raw, NoEncryption())
        self.public = key.public_key().public_bytes(Encoding.Raw, PublicFormat.Raw)

    def dh(self, public):
        try:
            return self._key.exchange(X25519PublicKey.from_public_bytes(public))
        except ValueError as error:  # the result is zero: a point of small order
            raise NoiseError("weak public key") from error


def _hmac(key, data):
    return hmac.new(key, data, hashlib.blake2b).digest()


def _hkdf(chaining_key, material, outputs):
    temp = _hmac(chaining_key, material)
    result, last = [], b""
    for number in range(1, outputs + 1):
        last = _hmac(temp, last + bytes([number]))
        result.append(last)
    return result


class SymmetricState:
    def __init__(self, protocol_name):
        name = protocol_name.encode()
        self.h = name.ljust(64, b"\0") if len(name) <= 64 else hashlib.blake2b(name).digest()
        self.ck = self.h
        self.k = None
        self.n = 0

    def mix_hash(self, data):
        self.h = hashlib.blake2b(self.h + data).digest()

    def mix_key(self, material):
        self.ck, k = _hkdf(self.ck, material, 2)
        self.k, self.n = k[:32], 0

    def mix_key_and_hash(self, material):
        self.ck, h, k = _hkdf(self.ck, material, 3)
        self.mix_hash(h)
        self.k, self.n = k[:32], 0

    def _nonce(self):
        nonce = bytes(4) + self.n.to_bytes(8, "little")
        self.n += 1
        return nonce

    def encrypt_and_hash(self, plaintext):
        ciphertext = ChaCha20Poly1305(self.k).encrypt(self._nonce(), plaintext, self.h) if self.k else plaintext
        self.mix_hash(ciphertext)
        return ciphertext

    def decrypt_and_hash(self, ciphertext):
        try:
            plaintext = ChaCha20Poly1305(self.k).decrypt(self._nonce(), ciphertext, self.h) if self.k else ciphertext
        except InvalidTag as error:
            raise NoiseError("wrong tag") from error
        self.mix_hash(ciphertext)
        return plaintext

    def split(self):
        k1, k2 = _hkdf(self.ck, b"", 2)
        return k1[:32], k2[:32]


class Handshake:
    """One handshake: write_message and read_message take turns; then h and split() hold the result.

    `ephemeral` fixes the ephemeral key pair, for known-answer examples only.
    """

    def __init__(self, pattern, initiator, prologue, static, remote_static=None, psk=None, ephemeral=None):
        responder_known, self._messages = PATTERNS[pattern]
        self._initiator, self._psk = initiator, psk
        self._s, self._rs = static, remote_static
        self._e, self._re = ephemeral, None
        self._index = 0
        self._state = SymmetricState("Noise_" + pattern + "_25519_ChaChaPoly_BLAKE2b")
        self._state.mix_hash(prologue)
        if responder_known:
            self._state.mix_hash(remote_static if initiator else static.public)

    @property
    def remote_static(self):
        return self._rs

    @property
    def h(self):
        return self._state.h

    def set_psk(self, psk):
        """For the responder of IKpsk2, which learns whose secret it needs from the first message."""
        self._psk = psk

    def copy(self):
        """A handshake in the same state, to try a message on that may be wrong."""
        twin = copy.copy(self)
        twin._state = copy.copy(self._state)
        return twin

    def split(self):
        assert self._index == len(self._messages)
        return self._state.split()

    def _mix_dh(self, token):
        initiators, responders = token  # "es": the initiator's ephemeral, the responder's static
        own, remote = (initiators, responders) if self._initiator else (responders, initiators)
        pair = self._e if own == "e" else self._s
        self._state.mix_key(pair.dh(self._re if remote == "e" else self._rs))

    def write_message(self, payload):
        message = b""
        for token in self._messages[self._index]:
            if token == "e":
                self._e = self._e or KeyPair()
                message += self._e.public
                self._state.mix_hash(self._e.public)
                self._state.mix_key(self._e.public)  # since there is a psk (section 9.2)
            elif token == "s":
                message += self._state.encrypt_and_hash(self._s.public)
            elif token == "psk":
                self._state.mix_key_and_hash(self._psk)
            else:
                self._mix_dh(token)
        self._index += 1
        return message + self._state.encrypt_and_hash(payload)

    def read_message(self, message):
        for token in self._messages[self._index]:
            if token == "e":
                self._re, message = message[:DH_LENGTH], message[DH_LENGTH:]
                self._state.mix_hash(self._re)
                self._state.mix_key(self._re)
            elif token == "s":
                length = DH_LENGTH + (TAG_LENGTH if self._state.k else 0)
                self._rs = self._state.decrypt_and_hash(message[:length])
                message = message[length:]
            elif token == "psk":
                self._state.mix_key_and_hash(self._psk)
            else:
                self._mix_dh(token)
        self._index += 1
        return self._state.decrypt_and_hash(message)
