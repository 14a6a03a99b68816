"""The suites: how one record is sealed and opened under the keys of one direction of one epoch (PROTOCOL.md 5)."""

import hashlib
import hmac

from cryptography.exceptions import InvalidTag
from cryptography.hazmat.primitives import padding
from cryptography.hazmat.primitives.ciphers import Cipher, algorithms, modes
from cryptography.hazmat.primitives.ciphers.aead import AESGCM, ChaCha20Poly1305

try:  # where newer releases of the library keep it
    from cryptography.hazmat.decrepit.ciphers.algorithms import ARC4
except ImportError:
    from cryptography.hazmat.primitives.ciphers.algorithms import ARC4

NAMES = {
    1: "chacha20-poly1305",
    2: "aes-256-gcm",
    3: "aes-256-ctr",
    4: "aes-256-cbc",
    5: "chacha20",
    6: "rc4",
}
RESEARCH = {6}
TAG_LENGTH = 16


class WrongTag(Exception):
    """A record that is not authentic."""


def hkdf_extract(salt, material):
    return hmac.new(salt, material, hashlib.sha256).digest()


def hkdf_expand(secret, info, length):
    output, last, number = b"", b"", 1
    while len(output) < length:
        last = hmac.new(secret, last + info + bytes([number]), hashlib.sha256).digest()
        output += last
        number += 1
    return output[:length]


class DirectionKeys:
    """What seals, and opens, the records of one direction of one epoch."""

    def __init__(self, suite, secret, framing="record"):
        def key(use, length):
            return hkdf_expand(secret, f"skyseal v1 {framing} {NAMES[suite]} {use}".encode(), length)

        self._suite = suite
        self.key = key("key", 32)
        self.iv = b"" if suite == 6 else key("iv", 32 if suite == 4 else 12)
        self.mac = b"" if suite in (1, 2) else key("mac", 32)

    def seal(self, counter, associated, plaintext):
        if self._suite in (1, 2):
            return self._aead().encrypt(self._nonce(counter), plaintext, associated)
        if self._suite == 4:
            padder = padding.PKCS7(128).padder()
            plaintext = padder.update(plaintext) + padder.finalize()
        encryptor = self._cipher(counter).encryptor()
        ciphertext = encryptor.update(self._lead() + plaintext)[len(self._lead()):] + encryptor.finalize()
        return ciphertext + self._tag(counter, associated, ciphertext)

    def open(self, counter, associated, sealed):
        if self._suite in (1, 2):
            try:
                return self._aead().decrypt(self._nonce(counter), sealed, associated)
            except InvalidTag as error:
                raise WrongTag from error
        ciphertext, tag = sealed[:-TAG_LENGTH], sealed[-TAG_LENGTH:]
        if not hmac.compare_digest(tag, self._tag(counter, associated, ciphertext)):
            raise WrongTag
        decryptor = self._cipher(counter).decryptor()
        plaintext = decryptor.update(self._lead() + ciphertext)[len(self._lead()):] + decryptor.finalize()
        if self._suite == 4:
            unpadder = padding.PKCS7(128).unpadder()
            plaintext = unpadder.update(plaintext) + unpadder.finalize()
        return plaintext

    def _aead(self):
        return ChaCha20Poly1305(self.key) if self._suite == 1 else AESGCM(self.key)

    def _nonce(self, counter):
        return bytes(a ^ b for a, b in zip(self.iv, bytes(4) + counter.to_bytes(8, "big")))

    def _cipher(self, counter):
        if self._suite == 3:
            return Cipher(algorithms.AES(self.key), modes.CTR(self._nonce(counter) + bytes(4)))
        if self._suite == 4:
            return Cipher(algorithms.AES(self.key), modes.CBC(self._block_iv(counter)))
        if self._suite == 5:  # this library takes the block number, 4 bytes, before the nonce of RFC 8439
            return Cipher(algorithms.ChaCha20(self.key, bytes(4) + self._nonce(counter)), mode=None)
        record_key = hmac.new(self.key, counter.to_bytes(8, "little"), hashlib.sha256).digest()
        return Cipher(ARC4(record_key), mode=None)

    def _block_iv(self, counter):
        return _one_block(self.iv, bytes(8) + counter.to_bytes(8, "big"))

    def _lead(self):
        return bytes(768) if self._suite == 6 else b""

    def _tag(self, counter, associated, ciphertext):
        data = counter.to_bytes(8, "little") + len(associated).to_bytes(4, "little") + associated + ciphertext
        return hmac.new(self.mac, data, hashlib.sha256).digest()[:TAG_LENGTH]


def _one_block(key, block):
    return Cipher(algorithms.AES(key), modes.ECB()).encryptor().update(block)


class InlineKeys(DirectionKeys):
    """The same ciphers where the length must not change (PROTOCOL.md 12): suites 3 to 6, tags of 8 bytes."""

    TAG_LENGTH = 8

    def __init__(self, suite, secret):
        super().__init__(suite, secret, "inline")

    def encrypt(self, counter, plaintext):
        if self._suite != 4:
            encryptor = self._cipher(counter).encryptor()
            return encryptor.update(self._lead() + plaintext)[len(self._lead()):]
        if len(plaintext) < 16:
            return bytes(a ^ b for a, b in zip(plaintext, _one_block(self.key, self._block_iv(counter))))
        last = len(plaintext) % 16
        padded = plaintext + bytes(-len(plaintext) % 16)
        blocks = self._cipher(counter).encryptor().update(padded)
        return blocks[:len(blocks) - 32 + last] + blocks[-16:] if last else blocks

    def decrypt(self, counter, ciphertext):
        if self._suite != 4:
            decryptor = self._cipher(counter).decryptor()
            return decryptor.update(self._lead() + ciphertext)[len(self._lead()):]
        if len(ciphertext) < 16:
            return self.encrypt(counter, ciphertext)
        last = len(ciphertext) % 16
        if last:  # what fell away of the last block but one stands behind the zeros in the decrypted last block
            tail = Cipher(algorithms.AES(self.key), modes.ECB()).decryptor().update(ciphertext[-16:])
            ciphertext = ciphertext[:-16] + tail[last:] + ciphertext[-16:]
        plaintext = self._cipher(counter).decryptor().update(ciphertext)
        return plaintext[:len(plaintext) - 16 + last] if last else plaintext

    def tag(self, counter, associated, ciphertext):
        return self._tag(counter, associated, ciphertext)[:self.TAG_LENGTH]
