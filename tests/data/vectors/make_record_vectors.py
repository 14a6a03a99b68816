#!/usr/bin/env python3
"""Writes record_ciphers.txt: sealed records of every suite, computed from their description alone.

A second implementation of core/crypto/record_cipher.h with Python's hashlib and the cryptography package (48.0 was used).
It shares no line with the C++ one; run it again only when the description changes.
"""
import hashlib
import hmac
from pathlib import Path

from cryptography.hazmat.primitives.ciphers import Cipher, algorithms, modes
from cryptography.hazmat.primitives.ciphers.aead import AESGCM, ChaCha20Poly1305

def sha256_mac(key, message):
    return hmac.new(key, message, hashlib.sha256).digest()


def derive(secret, suite, use, length):
    """HKDF-Expand for at most one block of output."""
    return sha256_mac(secret, f"skyseal v1 record {suite} {use}".encode() + b"\x01")[:length]


def nonce_of(iv, counter):
    return bytes(a ^ b for a, b in zip(iv, b"\0" * 4 + counter.to_bytes(8, "big")))


def rc4(key, data):
    box = list(range(256))
    j = 0
    for i in range(256):
        j = (j + box[i] + key[i % len(key)]) % 256
        box[i], box[j] = box[j], box[i]
    out = bytearray()
    i = j = 0
    for byte in b"\0" * 768 + data:
        i = (i + 1) % 256
        j = (j + box[i]) % 256
        box[i], box[j] = box[j], box[i]
        out.append(byte ^ box[(box[i] + box[j]) % 256])
    return bytes(out[768:])


def encrypt(cipher, data):
    encryptor = cipher.encryptor()
    return encryptor.update(data) + encryptor.finalize()


def aes_ctr(key, iv, counter, plaintext):
    return encrypt(Cipher(algorithms.AES(key), modes.CTR(nonce_of(iv[:12], counter) + b"\0" * 4)), plaintext)


def aes_cbc(key, iv, counter, plaintext):
    record_iv = encrypt(Cipher(algorithms.AES(iv), modes.ECB()), b"\0" * 8 + counter.to_bytes(8, "big"))
    padding = 16 - len(plaintext) % 16
    return encrypt(Cipher(algorithms.AES(key), modes.CBC(record_iv)), plaintext + bytes([padding]) * padding)


def chacha20(key, iv, counter, plaintext):
    return encrypt(Cipher(algorithms.ChaCha20(key, b"\0" * 4 + nonce_of(iv[:12], counter)), None), plaintext)


def rc4_per_record(key, iv, counter, plaintext):
    return rc4(sha256_mac(key, counter.to_bytes(8, "little")), plaintext)


AEADS = {"chacha20-poly1305": ChaCha20Poly1305, "aes-256-gcm": AESGCM}
CIPHERS = {"aes-256-ctr": aes_ctr, "aes-256-cbc": aes_cbc, "chacha20": chacha20, "rc4": rc4_per_record}


def seal(suite, secret, counter, associated, plaintext):
    key = derive(secret, suite, "key", 32)
    iv = derive(secret, suite, "iv", 32)
    if suite in AEADS:
        return AEADS[suite](key).encrypt(nonce_of(iv[:12], counter), plaintext, associated)
    body = CIPHERS[suite](key, iv, counter, plaintext)
    head = counter.to_bytes(8, "little") + len(associated).to_bytes(4, "little")
    return body + sha256_mac(derive(secret, suite, "mac", 32), head + associated + body)[:16]


def main():
    lines = ["# Sealed records of every suite, written by make_record_vectors.py beside this file.",
             '# One vector a paragraph, "name = value"; bytes are in hex, a value of "" is empty.']
    secret = bytes(range(32))
    for suite in [*AEADS, *CIPHERS]:
        for counter, length in [(0, 0), (1, 9), (255, 16), (65536, 28), (0xFFFFFF, 64), (0x0102030405060708, 255)]:
            associated = bytes((counter + i) % 256 for i in range(length % 13))
            plaintext = bytes((7 * i + length) % 256 for i in range(length))
            sealed = seal(suite, secret, counter, associated, plaintext)
            lines += ["", f"suite = {suite}", f"secret = {secret.hex()}", f"counter = {counter:016x}",
                      f'aad = {associated.hex() or chr(34) * 2}', f'plaintext = {plaintext.hex() or chr(34) * 2}',
                      f"sealed = {sealed.hex()}"]
    Path(__file__).with_name("record_ciphers.txt").write_text("\n".join(lines) + "\n")


if __name__ == "__main__":
    main()
