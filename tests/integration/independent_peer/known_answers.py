"""The known answers of PROTOCOL.md, read out of the document and computed anew.

A line there is `name = hex` or `name = "text"`; lines that hold nothing but hex continue the one before, and `| zeros N` ends a
value with N zeros. Names of inputs are those in INPUTS; every other name must come out of compute().
"""

import re

import carriers
import control
import freshness
import inline_frame
import key_text
import pairing
import wire
from epoch import record_head
from keys import AGENT, STATION, EpochKeys, first_chain
from mavlink import frame, heartbeat
from noise import KeyPair
from suites import NAMES, DirectionKeys, InlineKeys

HEADING = "Known answers"
INPUTS = ("station private", "agent private", "station ephemeral private", "agent ephemeral private", "pre-shared key",
          "announcement nonce", "cookie", "cookie nonce", "proposal private", "answer private", "direction secret",
          "inline secret", "pairing token", "pairing passphrase", "pairing nonce of the station", "pairing nonce of the agent",
          "pairing scalar of the station", "pairing scalar of the agent")


def read(path):
    """The examples of the document by name, as bytes; texts in ASCII."""
    text = open(path, encoding="utf-8").read()
    section = re.split(r"^## [0-9]+\. " + HEADING + r"$", text, flags=re.MULTILINE)[1].split("\n## ")[0]
    examples, name = {}, None
    for line in section.splitlines():
        if found := re.fullmatch(r'    ([a-z0-9][a-z0-9 ()-]*?) += "(.*)"', line):
            name = None
            examples[found[1]] = found[2].encode()
        elif found := re.fullmatch(r"    ([a-z0-9][a-z0-9 ()-]*?) += ([0-9a-f ]+)(?:\| zeros ([0-9]+))?", line):
            name = found[1]
            if name in examples:
                raise ValueError("twice in the document: " + name)
            examples[name] = bytes.fromhex(found[2]) + bytes(int(found[3] or 0))
        elif name and (found := re.fullmatch(r"     +([0-9a-f ]+)(?:\| zeros ([0-9]+))?", line)):
            examples[name] += bytes.fromhex(found[1]) + bytes(int(found[2] or 0))
        else:
            name = None
            if line.startswith("    "):
                raise ValueError("no example: " + line)
    return examples


def check(path):
    """0 when every example of the document is right and none is missing; what is wrong is printed."""
    examples = read(path)
    computed = compute({name: examples[name] for name in INPUTS})
    wrong = 0
    for name in sorted(examples.keys() | computed.keys() - set(INPUTS)):
        if name in INPUTS or examples.get(name) == computed.get(name):
            continue
        wrong += 1
        print(f"{name}\n  document {_shown(examples, name)}\n  computed {_shown(computed, name)}")
    print(f"{len(computed)} known answers, {wrong} wrong")
    return 1 if wrong else 0


def _shown(examples, name):
    return examples[name].hex() if name in examples else "nothing"


def compute(inputs):
    """Every example that follows from the inputs."""
    ends = [KeyPair(inputs[name + " private"]) for name in ("station", "agent")]
    out = _keys(*ends)
    out["announcement"] = wire.announcement(ends[1].public, inputs["announcement nonce"])
    handshake = _handshake(inputs, *ends, out)
    _cookie(inputs, ends[1].public, out)
    _epochs(inputs, handshake, out)
    _records(inputs, out)
    _carriers(inputs, out)
    _inline_frames(inputs, out)
    _control_messages(inputs, out)
    _pairing(inputs, *ends, out)
    return out


def _keys(station, agent):
    return {"station public": station.public,
            "agent public": agent.public,
            "agent public as text": key_text.to_text(agent.public).encode(),
            "agent fingerprint": key_text.fingerprint(agent.public).encode()}


def _handshake(inputs, station, agent, out):
    psk = inputs["pre-shared key"]
    stations = wire.Offer(wire.FLAG_RESEARCH, 0x1234, [1, 2, 3, 4, 5, 6])
    agents = wire.Offer(0, 0xABCD, [3, 2])
    initiator = wire.station_handshake(station, agent.public, psk, KeyPair(inputs["station ephemeral private"]))
    responder = wire.agent_handshake(agent, KeyPair(inputs["agent ephemeral private"]))
    first = wire.write_first(initiator, agent.public, stations, 7)
    assert wire.read_first(responder, first) == (stations, 7)
    responder.set_psk(psk)
    number = wire.write_number(responder.copy(), station.public, stations.connection, 41)
    assert wire.read_number(initiator.copy(), number) == 41
    out["number"] = number
    out["suite list"] = wire.pack_suites([2, 200, 1, 15])
    assert wire.unpack_numbers(out["suite list"]) == [2, 200, 1, 15]
    chosen = wire.choose(stations, agents)
    answer = wire.write_answer(responder, station.public, stations.connection, agents, chosen)
    assert wire.read_answer(initiator, answer) == (agents, chosen)
    assert initiator.split() == responder.split() and initiator.h == responder.h
    k1, k2 = initiator.split()
    out.update({"first payload": stations.pack() + (7).to_bytes(5, "little"), "first message": first,
                "answer payload": agents.pack() + bytes([chosen]), "answer": answer,
                "handshake hash": initiator.h, "k1": k1, "k2": k2})
    return initiator


def _cookie(inputs, agent_public, out):
    first, cookie = out["first message"], inputs["cookie"]
    out["cookie message"] = wire.cookie_message(agent_public, cookie, first, inputs["cookie nonce"])
    assert wire.open_cookie(agent_public, out["cookie message"], first) == cookie
    out["first message under the cookie"] = wire.under_cookie(first, cookie)


def _epochs(inputs, handshake, out):
    chain = first_chain(handshake.h, *handshake.split())
    zero = EpochKeys(chain, 0, 2)
    proposer, answerer = KeyPair(inputs["proposal private"]), KeyPair(inputs["answer private"])
    one = zero.switched(3, proposer, proposer.public, answerer.public)
    assert zero.switched(3, answerer, proposer.public, answerer.public).chain == one.chain
    out["proposal public"], out["answer public"] = proposer.public, answerer.public
    out["dh(1)"], out["next(0)"] = proposer.dh(answerer.public), zero.next
    out["chain(0)"], out["chain(1)"] = chain, one.chain
    for keys in (zero, one):
        out[f"station({keys.number})"], out[f"agent({keys.number})"] = keys.secrets[STATION], keys.secrets[AGENT]
    head = record_head(0, 0xABCD, 0)
    out["frame"] = heartbeat(255, 190, 0)
    out["record of the session"] = head + zero.directions[STATION].seal(0, head + bytes([2, STATION, 1]), out["frame"])


def _records(inputs, out):
    head = record_head(5, 0xABCD, 0x010203)
    for suite, name in NAMES.items():
        keys = DirectionKeys(suite, inputs["direction secret"])
        parts = {"key": keys.key, "iv": keys.iv, "mac": keys.mac}
        out.update({f"{name} {use}": part for use, part in parts.items() if part})
        out[name + " record"] = head + keys.seal(0x010203, head + bytes([suite, STATION, 1]), out["frame"])


def _carriers(inputs, out):
    keys, counter = DirectionKeys(1, inputs["direction secret"]), 0x010203
    head = bytes([0x55]) + counter.to_bytes(3, "little")
    out["serial record"] = head + keys.seal(counter, head + bytes([1, STATION, carriers.SERIAL_CARRIER]), out["frame"])
    out["serial frame"] = carriers.cobs(out["serial record"])
    out["serial announcement"] = carriers.cobs(out["announcement"])
    head = record_head(5, 0xABCD, counter)
    record = head + keys.seal(counter, head + bytes([1, STATION, carriers.TUNNEL_CARRIER]), out["frame"])
    out["tunnel record"], out["tunnel frame"] = record, carriers.tunnel((255, 190), (1, 191), 0, record)
    out["tunnel request"] = carriers.tunnel((255, 190), (0, 0), 0, pairing.request())
    parts = carriers.payloads(out["first message"] + out["answer"], 0x0102)
    out["tunnel part 0"], out["tunnel part 1"] = parts


def _inline_frames(inputs, out):
    payload = bytes.fromhex("0000803f") + bytes(24) + bytes.fromhex("90010101")  # COMPONENT_ARM_DISARM 1 for 1, 1; trimmed
    out["command"] = frame(bytes([len(payload), 0, 0, 7, 255, 190, 76, 0, 0]), payload)
    for suite in (3, 4, 5, 6):
        keys, place = InlineKeys(suite, inputs["inline secret"]), (1, suite, STATION, 1)
        for name in ("command", "frame"):
            sealed = inline_frame.seal(out[name], keys, place, 5)
            assert inline_frame.open_frame(sealed, keys, place) == out[name]
            out[f"{NAMES[suite]} inline {name}"] = sealed


def _control_messages(inputs, out):
    numbers = dict(zip(control.REPORT_NUMBERS, (1000, 3, 2, 1, 0, 0, 0, 30000, 40, 2000)))
    more = numbers | dict(zip(control.FRAME_NUMBERS + control.COST_NUMBERS,
                              (900, 1, 2500000, 14680064, 40, 60000, 1000, 1500000)))
    late = numbers | dict(zip(control.FRESHNESS_NUMBERS, (4, 2400000, 1000, 5000)))
    out.update({"propose": control.Propose(1, 1, 3, out["proposal public"]).pack(),
                "accept": control.Accept(1, out["answer public"]).pack(),
                "refuse": control.Refuse(1).pack(),
                "confirm": control.Confirm(1, 300).pack(),
                "confirmed": control.Confirmed(1, 1000).pack(),
                "report": control.Report(1, 1000001, 999001, 250, numbers).pack(),
                "report with costs": control.Report(14, 1000001, 999001, 250, more).pack(),
                "report of an agent": control.Report(16, 1000001, 999001, 250, late).pack(),
                "report of an agent that cannot store": control.Report(control.TELLS_FRESHNESS | control.CANNOT_STORE, 1000001,
                                                                        999001, 250, late).pack(),
                "report of an agent that hears nothing": control.Report(control.TELLS_FRESHNESS | control.RECEIVES_NOTHING, 1000001,
                                                                        999001, 250, late).pack(),
                "stamped frame": freshness.stamp(123456789) + out["frame"],
                "close": control.Close().pack()})
    assert all(control.unpack(out[name]).pack() == out[name] for name in ("propose", "report", "report with costs", "report of an agent",
                                                                               "confirmed"))


def _pairing(inputs, station, agent, out):
    number, token = 0x01020304, inputs["pairing token"]

    def end(side, who, static, system, name):
        mine = pairing.Opening(static.public, system, name, inputs["pairing nonce of the " + who])
        return pairing.Pairing(side, static, number, token, mine, inputs["pairing scalar of the " + who],
                               inputs["pairing passphrase"])

    ground = end(STATION, "station", station, 255, "ground")
    air = end(AGENT, "agent", agent, 1, "air-1")
    out["pairing call"] = pairing.call(token)
    out["pairing first"] = ground.write_first()
    air.read_first(out["pairing first"])
    out["pairing answer"] = air.write_answer()
    ground.read_answer(out["pairing answer"])
    out["pairing opening of the station"] = ground.write_opening()
    assert air.read_opening(out["pairing opening of the station"]) == ground.mine
    out["pairing opening of the agent"] = air.write_opening()
    assert ground.read_opening(out["pairing opening of the agent"]) == air.mine
    assert ground.code() == air.code() and ground.preshared_key() == air.preshared_key()
    out["pairing code"] = ground.code().encode()
    out["pairing pre-shared key"] = ground.preshared_key()
    out["pairing word of the station"] = pairing.word(ground.word_key(STATION), number, pairing.YES, pairing.NONE)
    out["pairing word of the agent"] = pairing.word(air.word_key(AGENT), number, pairing.NONE, pairing.YES)
    assert pairing.hear(ground.word_key(AGENT), out["pairing word of the agent"]) == (pairing.NONE, pairing.YES)

