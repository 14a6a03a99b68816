"""How late a station's frames arrive, as its agent judges it (PROTOCOL.md 6.1)."""

OVERTAKEN, AGE = 1.0, 5.0  # the agent's limits, seconds
DRIFT, KEEP_BEST = 2048, 60.0


def stamp(clock):
    """The bytes in front of a station's frames, for its session clock in microseconds."""
    units = clock >> 10
    return bytes([0x80 | units & 0x3F, units >> 6 & 0xFF, units >> 14 & 0xFF])


def split(plaintext):
    """(stamp in microseconds or None, frames)"""
    if len(plaintext) < 3 or plaintext[0] >> 6 != 2:
        return None, plaintext
    return (plaintext[0] & 0x3F | plaintext[1] << 6 | plaintext[2] << 14) << 10, plaintext[3:]


def _difference(a, b):
    return ((a - b + (1 << 31)) % (1 << 32) - (1 << 31)) / 1e6


class Freshness:
    def __init__(self, now):
        self._best = now, now, 0  # when it was found; the peer's clock showed the stamp at the second, or later
        self._arrivals = []  # (time, position) of those that were the newest
        self.age, self.stale = 0.0, 0

    def arrived(self, now, position):
        if not self._arrivals or position > self._arrivals[-1][1]:
            self._arrivals.append((now, position))
        while len(self._arrivals) > 1 and self._arrivals[1][0] <= now - OVERTAKEN:
            del self._arrivals[0]

    def answered(self, now, sample, held, peer_stamp):
        """A report of the peer echoed one of ours: `sample` seconds for the way there and back."""
        mark = now, now - sample - held / DRIFT, peer_stamp
        before = self._age(self._best, now, peer_stamp)
        if before < 0 or self._age(mark, now, peer_stamp) < before or now >= self._best[0] + KEEP_BEST:
            self._best = mark

    def may_command(self, now, position, peer_stamp, closing):
        """Judges frames, and counts those that may not."""
        fresh = not closing and not self._overtaken(now, position) and peer_stamp is not None
        if fresh:
            self.age = self._age(self._best, now, peer_stamp)
            fresh = 0 <= self.age <= AGE
        self.stale += not fresh
        return fresh

    def _overtaken(self, now, position):
        return any(time <= now - OVERTAKEN and newest > position for time, newest in self._arrivals)

    @staticmethod
    def _age(mark, now, peer_stamp):
        passed = _difference(peer_stamp, mark[2])
        return now - mark[1] - passed + abs(passed) / DRIFT
