"""A public key as people pass it on, and its fingerprint (PROTOCOL.md 1)."""

import base64
import hashlib

PREFIX = "skyseal:"


def _digest(label, public):
    return hashlib.blake2b(label + public, digest_size=32).digest()


def to_text(public):
    return PREFIX + base64.urlsafe_b64encode(public + _digest(b"skyseal public key v1", public)[:4]).decode()


def from_text(text):
    data = base64.urlsafe_b64decode(text.removeprefix(PREFIX))
    if not text.startswith(PREFIX) or len(data) != 36 or to_text(data[:32]) != text:
        raise ValueError("not a public key: " + text)
    return data[:32]


def fingerprint(public):
    digits = _digest(b"skyseal fingerprint v1", public).hex()
    return " ".join(digits[at:at + 4] for at in range(0, 64, 4))
