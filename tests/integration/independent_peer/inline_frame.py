"""A MAVLink 2 frame sealed where it stands (PROTOCOL.md 12): the header and the targets clear, the rest encrypted."""

import hmac

from mavlink import FACTS, frame
from suites import WrongTag

FLAGS = 0x81
TRAILER = 13
NOWHERE = 255


def _clear(message, payload):
    """The offsets of the clear bytes that this payload has, in rising order."""
    return sorted(offset for offset in FACTS[message][1] if offset < len(payload))


def _split(payload, clear):
    hidden = bytes(byte for at, byte in enumerate(payload) if at not in clear)
    return hidden, bytes(payload[at] for at in clear)


def _join(hidden, clear, targets):
    rest = iter(hidden)
    return bytes(targets[clear.index(at)] if at in clear else next(rest) for at in range(len(hidden) + len(clear)))


def _associated(header, place, clear, targets):
    offsets = (clear + [NOWHERE] * 2)[:2]
    epoch, suite, direction, carrier = place
    return header + bytes([epoch & 0xFF, *offsets]) + targets.ljust(2, b"\0") + bytes([suite, direction, carrier])


def seal(plain, keys, place, counter):
    """`place` is (epoch, suite, direction, carrier); `plain` a whole frame without flags."""
    header = plain[:2] + bytes([FLAGS]) + plain[3:10]
    payload = plain[10:-2]
    clear = _clear(int.from_bytes(header[7:10], "little"), payload)
    hidden, targets = _split(payload, clear)
    ciphertext = keys.encrypt(counter, hidden)
    tag = keys.tag(counter, _associated(header, place, clear, targets), ciphertext)
    sealed = frame(header[1:], _join(ciphertext, clear, targets))
    return sealed + bytes([place[0] & 0xFF]) + counter.to_bytes(4, "little") + tag


def open_frame(sealed, keys, place):
    """The plain frame. WrongTag when it is not authentic; its form was checked before."""
    header, payload, trailer = sealed[:10], sealed[10:-2 - TRAILER], sealed[-TRAILER:]
    counter = int.from_bytes(trailer[1:5], "little")
    clear = _clear(int.from_bytes(header[7:10], "little"), payload)
    ciphertext, targets = _split(payload, clear)
    if not hmac.compare_digest(trailer[5:], keys.tag(counter, _associated(header, place, clear, targets), ciphertext)):
        raise WrongTag
    return frame(header[1:2] + b"\0" + header[3:], _join(keys.decrypt(counter, ciphertext), clear, targets))
