"""The group ristretto255 of RFC 9496 and CPace over it, suite CPACE-RISTR255-SHA512 of draft-irtf-cfrg-cpace.

Not constant-time: for the comparison with another implementation only.
"""

import hashlib

P = 2**255 - 19
ORDER = 2**252 + 27742317777372353535851937790883648493
D = -121665 * pow(121666, -1, P) % P
SQRT_M1 = pow(2, (P - 1) // 4, P)
IDENTITY = (0, 1, 1, 0)


def _is_negative(x):
    return x % P & 1


def _abs(x):
    return -x % P if _is_negative(x) else x % P


def _sqrt_ratio(u, v):
    """(True, sqrt(u / v)), or (False, sqrt(i * u / v)); RFC 9496, 4.2."""
    r = u * pow(v, 3, P) * pow(u * pow(v, 7, P), (P - 5) // 8, P) % P
    check = v * r * r % P
    if check in (-u % P, -u * SQRT_M1 % P):
        r = r * SQRT_M1 % P
    return check in (u % P, -u % P), _abs(r)


INVSQRT_A_MINUS_D = _sqrt_ratio(1, -1 - D)[1]
SQRT_AD_MINUS_ONE = P - _sqrt_ratio(-D - 1, 1)[1]  # the odd one of the two roots


def add(a, b):
    """The complete addition of twisted Edwards curves with a = -1, in extended coordinates."""
    x1, y1, z1, t1 = a
    x2, y2, z2, t2 = b
    e = (x1 + y1) * (x2 + y2) - x1 * x2 - y1 * y2
    h = y1 * y2 + x1 * x2
    f = z1 * z2 - D * t1 * t2
    g = z1 * z2 + D * t1 * t2
    return e * f % P, g * h % P, f * g % P, e * h % P


def multiply(scalar, point):
    out = IDENTITY
    for bit in bin(scalar)[2:]:
        out = add(out, out)
        if bit == "1":
            out = add(out, point)
    return out


def encode(point):
    """RFC 9496, 4.3.2."""
    x, y, z, t = point
    u1, u2 = (z + y) * (z - y) % P, x * y % P
    invsqrt = _sqrt_ratio(1, u1 * u2 * u2 % P)[1]
    den1, den2 = invsqrt * u1 % P, invsqrt * u2 % P
    z_inv = den1 * den2 * t % P
    if _is_negative(t * z_inv):
        x, y, den = y * SQRT_M1 % P, x * SQRT_M1 % P, den1 * INVSQRT_A_MINUS_D % P
    else:
        den = den2
    if _is_negative(x * z_inv):
        y = -y % P
    return _abs(den * (z - y)).to_bytes(32, "little")


def decode(data):
    """RFC 9496, 4.3.1. None for what encodes no element."""
    s = int.from_bytes(data, "little")
    if s >= P or _is_negative(s):
        return None
    u1, u2 = (1 - s * s) % P, (1 + s * s) % P
    v = (-D * u1 * u1 - u2 * u2) % P
    square, invsqrt = _sqrt_ratio(1, v * u2 * u2 % P)
    den_x = invsqrt * u2 % P
    den_y = invsqrt * den_x * v % P
    x, y = _abs(2 * s * den_x), u1 * den_y % P
    t = x * y % P
    return None if not square or _is_negative(t) or y == 0 else (x, y, 1, t)


def _map(data):
    """RFC 9496, 4.3.4."""
    t = int.from_bytes(data, "little") % 2**255 % P
    r = SQRT_M1 * t * t % P
    u = (r + 1) * (1 - D * D) % P
    v = (-1 - r * D) * (r + D) % P
    square, s = _sqrt_ratio(u, v)
    c = -1 % P
    if not square:
        s, c = -_abs(s * t) % P, r
    n = (c * (r - 1) * (D - 1) * (D - 1) - v) % P
    w0, w1, w2, w3 = 2 * s * v, n * SQRT_AD_MINUS_ONE, 1 - s * s, 1 + s * s
    return w0 * w3 % P, w2 * w1 % P, w1 * w3 % P, w0 * w2 % P


def from_hash(data):
    return add(_map(data[:32]), _map(data[32:]))


def _lv(*parts):
    out = b""
    for part in parts:
        rest = len(part)
        while rest > 0x7F:
            out += bytes([rest & 0x7F | 0x80])
            rest >>= 7
        out += bytes([rest]) + part
    return out


class Cpace:
    def __init__(self, passphrase, channel, session, scalar):
        self.session = session
        self.scalar = int.from_bytes(scalar, "little") % 2**252
        name = b"CPaceRistretto255"
        padding = bytes(max(0, 128 - 1 - len(_lv(passphrase)) - len(_lv(name))))
        digest = hashlib.sha512(_lv(name, passphrase, padding, channel, session)).digest()
        self.share = encode(multiply(self.scalar, from_hash(digest)))

    def key(self, theirs, initiator, responder):
        """`initiator` and `responder` are (share, associated data), `theirs` the other end's share. None for an invalid one."""
        point = decode(theirs)
        secret = encode(multiply(self.scalar, point)) if point else bytes(32)
        if secret == bytes(32):
            return None
        return hashlib.sha512(_lv(b"CPaceRistretto255_ISK", self.session, secret, *initiator, *responder)).digest()
