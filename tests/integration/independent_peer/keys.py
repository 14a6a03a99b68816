"""From a finished handshake to the keys of each epoch (PROTOCOL.md 5)."""

from suites import DirectionKeys, hkdf_expand, hkdf_extract

STATION, AGENT = 0, 1
NO_KEY = bytes(32)


class EpochKeys:
    """The keys of one epoch, and the chain that leads to the next one."""

    def __init__(self, chain, number, suite, proposer=NO_KEY, answerer=NO_KEY):
        context = number.to_bytes(4, "little") + bytes([suite]) + proposer + answerer
        self.chain = chain
        self.number, self.suite = number, suite
        self.secrets = {STATION: hkdf_expand(chain, b"skyseal v1 epoch initiator" + context, 32),
                        AGENT: hkdf_expand(chain, b"skyseal v1 epoch responder" + context, 32)}
        self.next = hkdf_expand(chain, b"skyseal v1 epoch next" + context, 32)
        self.directions = {side: DirectionKeys(suite, secret) for side, secret in self.secrets.items()}

    def switched(self, suite, own, proposer, answerer):
        """The keys of the next epoch. `own` is the key pair of this end; NoiseError if the other key is weak."""
        shared = own.dh(answerer if own.public == proposer else proposer)
        return EpochKeys(hkdf_extract(self.next, shared), self.number + 1, suite, proposer, answerer)


def first_chain(handshake_hash, k1, k2):
    return hkdf_extract(handshake_hash, k1 + k2)
