"""As much MAVLink as the peer needs: to cut a record into frames, and to make a heartbeat (MAVLink guide, serialization)."""

V1, V2 = 0xFE, 0xFD
SIGNED = 0x01
HEARTBEAT, COMMAND_LONG, TUNNEL = 0, 76, 385

# Of a message: CRC_EXTRA, and where target_system and target_component stand.
FACTS = {HEARTBEAT: (50, ()), COMMAND_LONG: (152, (30, 31)), TUNNEL: (147, (2, 3))}


def frames(data):
    """(system, component, sequence, message id) of each frame in a record. ValueError when it holds anything else."""
    at = 0
    while at < len(data):
        head = data[at:at + 10]
        if head[0] == V2 and len(head) == 10:
            length = 12 + head[1] + (13 if head[2] & SIGNED else 0)
            found = head[5], head[6], head[4], int.from_bytes(head[7:10], "little")
        elif head[0] == V1 and len(head) >= 6:
            length, found = 8 + head[1], (head[3], head[4], head[2], head[5])
        else:
            raise ValueError("no frame here")
        if at + length > len(data):
            raise ValueError("frame cut short")
        yield found
        at += length


def crc(data):
    value = 0xFFFF
    for byte in data:
        byte ^= value & 0xFF
        byte = (byte ^ byte << 4) & 0xFF
        value = (value >> 8) ^ (byte << 8) ^ (byte << 3) ^ (byte >> 4)
    return value & 0xFFFF


def heartbeat(system, component, sequence):
    """A fixed-wing vehicle of ArduPilot, standing by."""
    payload = (0).to_bytes(4, "little") + bytes([1, 3, 0x51, 3, 3])
    return frame(bytes([len(payload), 0, 0, sequence & 0xFF, system, component, HEARTBEAT, 0, 0]), payload)


def frame(head, payload):
    """A frame of MAVLink 2 with its checksum; `head` without the magic."""
    extra, _ = FACTS[int.from_bytes(head[6:9], "little")]
    return bytes([V2]) + head + payload + crc(head + payload + bytes([extra])).to_bytes(2, "little")
