"""One live epoch: its keys, what was sealed under it, and which counters of the peer were seen (PROTOCOL.md 6)."""

from keys import AGENT, STATION

WINDOW = 2048
HARD_LIMIT = (1 << 24) - 1


class Window:
    """Which counters were received: each at most once, and none older than 2048 behind the newest."""

    def __init__(self):
        self.next = 0  # one past the newest
        self.received = 0
        self._seen = set()

    def fresh(self, counter):
        return counter not in self._seen and counter + WINDOW > self.next - 1

    def take(self, counter):
        """True when it is the newest so far."""
        newest = counter >= self.next
        self._seen.add(counter)
        self.received += 1
        if newest:
            self.next = counter + 1
            if len(self._seen) > 4 * WINDOW:
                self._seen = {seen for seen in self._seen if seen + WINDOW > counter}
        return newest


class Epoch:
    def __init__(self, keys, role):
        self.number, self.suite, self.keys = keys.number, keys.suite, keys
        self._seal = keys.directions[role]
        self._open = keys.directions[AGENT if role == STATION else STATION]
        self._role = role
        self.sealed = 0
        self.window = Window()
        self.final_count = None  # how many records the peer sealed under it, once the peer told

    def complete(self):
        return self.final_count is not None and self.window.received >= self.final_count

    def lost(self):
        return max(self.window.next, self.final_count or 0) - self.window.received

    def seal(self, connection, plaintext, carrier):
        if self.sealed >= HARD_LIMIT:
            raise OverflowError("epoch exhausted")
        counter, self.sealed = self.sealed, self.sealed + 1
        head = record_head(self.number, connection, counter)
        return head + self._seal.seal(counter, head + bytes([self.suite, self._role, carrier]), plaintext)

    def open(self, datagram, carrier):
        """The plaintext; WrongTag when it is not authentic. Moves nothing: see window."""
        peer = AGENT if self._role == STATION else STATION
        associated = datagram[:6] + bytes([self.suite, peer, carrier])
        return self._open.open(record_counter(datagram), associated, datagram[6:])


def record_head(epoch, connection, counter):
    return bytes([0x50 | epoch & 3]) + connection.to_bytes(2, "little") + counter.to_bytes(3, "little")


def record_counter(datagram):
    return int.from_bytes(datagram[3:6], "little")
