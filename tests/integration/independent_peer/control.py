"""The control messages inside records (PROTOCOL.md 7): bytes to values and back."""

from dataclasses import dataclass, field

PROPOSE, ACCEPT, REFUSE, CONFIRM, CONFIRMED, REPORT, CLOSE = range(1, 8)
LENGTHS = {PROPOSE: 42, ACCEPT: 37, REFUSE: 5, CONFIRM: 9, CONFIRMED: 9, CLOSE: 1}
REPORT_NUMBERS = ("good", "late", "lost", "replayed", "forged", "malformed", "plaintext_dropped", "opened_bytes",
                  "sent_records", "sent_bytes")
FRAME_NUMBERS = ("frames_taken", "frames_lost")  # behind the others, where a flag says so
COST_NUMBERS = ("cpu_us", "resident_bytes", "opened", "open_ns", "sealed", "seal_ns")  # likewise
FRESHNESS_NUMBERS = ("stale", "age_us", "overtaken_limit_ms", "age_limit_ms")  # likewise, of an agent
ANSWER_AT_ONCE, COUNTS_FRAMES, ASKS_COSTS, TELLS_COSTS, TELLS_FRESHNESS, CANNOT_STORE, RECEIVES_NOTHING = (
    1, 2, 4, 8, 16, 32, 64)


class Malformed(Exception):
    pass


def _u32(value):
    return (value & 0xFFFFFFFF).to_bytes(4, "little")


def _read_u32(data, at):
    return int.from_bytes(data[at:at + 4], "little")


@dataclass
class Propose:
    id: int
    epoch: int
    suite: int
    key: bytes

    def pack(self):
        return bytes([PROPOSE]) + _u32(self.id) + _u32(self.epoch) + bytes([self.suite]) + self.key


@dataclass
class Accept:
    id: int
    key: bytes

    def pack(self):
        return bytes([ACCEPT]) + _u32(self.id) + self.key


@dataclass
class Refuse:
    id: int

    def pack(self):
        return bytes([REFUSE]) + _u32(self.id)


@dataclass
class Confirm:
    epoch: int
    count: int

    def pack(self):
        return bytes([CONFIRM]) + _u32(self.epoch) + _u32(self.count)


@dataclass
class Confirmed:
    epoch: int
    count: int

    def pack(self):
        return bytes([CONFIRMED]) + _u32(self.epoch) + _u32(self.count)


@dataclass
class Report:
    flags: int
    stamp: int
    echo: int
    held: int
    numbers: dict = field(default_factory=dict)

    def pack(self):
        head = bytes([REPORT, self.flags]) + _u32(self.stamp) + _u32(self.echo) + _u32(self.held)
        return head + b"".join(leb128(self.numbers.get(name, 0)) for name in _names(self.flags))


@dataclass
class Close:
    def pack(self):
        return bytes([CLOSE])


def leb128(value):
    out = bytearray()
    while value > 0x7F:
        out.append(value & 0x7F | 0x80)
        value >>= 7
    out.append(value)
    return bytes(out)


def _read_leb128(data, at):
    value = shift = 0
    while True:
        if at >= len(data) or shift > 63:
            raise Malformed("number cut short or too long")
        value |= (data[at] & 0x7F) << shift
        at, shift = at + 1, shift + 7
        if not data[at - 1] & 0x80:
            return value, at


def unpack(data):
    """The message as one of the classes above. Malformed for an unknown type or a wrong length."""
    kind = data[0]
    if kind == REPORT:
        return _unpack_report(data)
    if LENGTHS.get(kind) != len(data):
        raise Malformed("unknown type or wrong length")
    if kind == PROPOSE:
        return Propose(_read_u32(data, 1), _read_u32(data, 5), data[9], data[10:42])
    if kind == ACCEPT:
        return Accept(_read_u32(data, 1), data[5:37])
    if kind == REFUSE:
        return Refuse(_read_u32(data, 1))
    if kind == CLOSE:
        return Close()
    return (Confirm if kind == CONFIRM else Confirmed)(_read_u32(data, 1), _read_u32(data, 5))


def _names(flags):
    return (REPORT_NUMBERS + (FRAME_NUMBERS if flags & COUNTS_FRAMES else ())
            + (FRESHNESS_NUMBERS if flags & TELLS_FRESHNESS else ())
            + (COST_NUMBERS if flags & TELLS_COSTS else ()))


def _unpack_report(data):
    if len(data) < 14 or data[1] > 127:
        raise Malformed("short report, or unknown flags")
    report, at = Report(data[1], _read_u32(data, 2), _read_u32(data, 6), _read_u32(data, 10)), 14
    for name in _names(report.flags):
        report.numbers[name], at = _read_leb128(data, at)
    if at != len(data):
        raise Malformed("long report")
    return report
