"""From a finished handshake to the keys of each epoch (PROTOCOL.md 5)."""

from suites import DirectionKeys, hkdf_expand, hkdf_extract

STATION, AGENT = 0, 1
NO_NONCE = bytes(16)


class EpochKeys:
    """The keys of one epoch, and the chain that leads to the next one."""

    def __init__(self, chain, number, suite, proposal_nonce=NO_NONCE, answer_nonce=NO_NONCE):
        context = number.to_bytes(4, "little") + bytes([suite]) + proposal_nonce + answer_nonce
        self.number, self.suite = number, suite
        self.secrets = {STATION: hkdf_expand(chain, b"skyseal v1 epoch initiator" + context, 32),
                        AGENT: hkdf_expand(chain, b"skyseal v1 epoch responder" + context, 32)}
        self.next_chain = hkdf_expand(chain, b"skyseal v1 epoch next" + context, 32)
        self.directions = {side: DirectionKeys(suite, secret) for side, secret in self.secrets.items()}


def first_chain(handshake_hash, k1, k2):
    return hkdf_extract(handshake_hash, k1 + k2)
