#!/usr/bin/env python3
"""Writes sealed.key: a sealed private key made without any code of the project, after the comment of core/keys/sealed_key.h.

Needs python3-cryptography 44 or newer (Argon2id). The secret is the bytes 00 … 1f, the salt a0 … af."""
import base64
import hashlib

from cryptography.hazmat.primitives.asymmetric.x25519 import X25519PrivateKey
from cryptography.hazmat.primitives.ciphers.aead import ChaCha20Poly1305
from cryptography.hazmat.primitives.kdf.argon2 import Argon2id

PASSPHRASE = "correct horse battery staple".encode()
PASSES, KIB = 2, 8192
secret = bytes(range(32))
salt = bytes(range(0xA0, 0xB0))


def url64(data):
    return base64.urlsafe_b64encode(data).rstrip(b"=").decode()


public = X25519PrivateKey.from_private_bytes(secret).public_key().public_bytes_raw()
check = hashlib.blake2b(b"skyseal public key v1" + public, digest_size=32).digest()[:4]
header = "skyseal-sealed-key-v1\n"
clear = f"argon2id {PASSES} {KIB} {salt.hex()}\nskyseal:{url64(public + check)}\n"
key = Argon2id(salt=salt, length=32, iterations=PASSES, lanes=1, memory_cost=KIB).derive(PASSPHRASE)
sealed = ChaCha20Poly1305(key).encrypt(bytes(12), secret, (header + clear).encode())
with open("sealed.key", "w") as out:
    out.write(header + "# made by make_sealed_key.py\n" + clear + url64(sealed) + "\n")
