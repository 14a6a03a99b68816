"""The round trip, measured by the reports' stamps and smoothed as RFC 6298 says (PROTOCOL.md 7 and 8)."""

from collections import deque


class RoundTrip:
    def __init__(self):
        self.samples = 0
        self.smoothed = self._deviation = 0.0  # seconds
        self._late = deque(maxlen=16)

    def take(self, sample):
        if self.samples == 0:
            self.smoothed, self._deviation = sample, sample / 2
        else:
            self._deviation += (abs(self.smoothed - sample) - self._deviation) / 4
            self.smoothed += (sample - self.smoothed) / 8
        self.samples += 1
        self._late.append(sample)

    def known(self):
        """Enough samples to rely on generous()."""
        return self.samples >= 3

    def generous(self):
        return max([3 * self.smoothed, self.smoothed + 4 * self._deviation, *self._late])
