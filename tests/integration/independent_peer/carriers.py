"""How a message travels in other carriers than datagrams (PROTOCOL.md 2.1): writing alone, for the known answers."""

import mavlink

TUNNEL_CARRIER, SERIAL_CARRIER = 2, 3
PAYLOAD_TYPE, PAYLOAD, PART = 0xDEA1, 128, 125


def cobs(message):
    """Consistent overhead byte stuffing and the zero at the end; one more in front of what is no record."""
    out = bytearray([0] if message[0] & 0x0C >= 0x08 else [])
    for i, run in enumerate(runs := message.split(b"\0")):
        while len(run) > 254 or (len(run) == 254 and i + 1 < len(runs)):
            out += bytes([255]) + run[:254]
            run = run[254:]
        out += bytes([len(run) + 1]) + run
    return bytes(out) + b"\0"


def payloads(message, number):
    """The message itself, or its parts under that number."""
    if len(message) <= PAYLOAD:
        return [message]
    parts = [message[at:at + PART] for at in range(0, len(message), PART)]
    return [bytes([0x80 | 4 * (i + 1 == len(parts)) | i]) + number.to_bytes(2, "little") + part
            for i, part in enumerate(parts)]


def tunnel(source, target, sequence, payload):
    """The frame of MAVLink 2 with its trailing zeros cut, and what must not be shortened by that behind a byte of ones."""
    padding = b"\xff" if len(payload) == 127 and payload[0] & 0x08 else b""
    content = (PAYLOAD_TYPE.to_bytes(2, "little") + bytes(target) + bytes([len(payload)]) + payload + padding).rstrip(b"\0")
    head = bytes([len(content), 0, 0, sequence, *source]) + mavlink.TUNNEL.to_bytes(3, "little")
    return mavlink.frame(head, content)
