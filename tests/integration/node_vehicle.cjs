// A vehicle that the npm package node-mavlink speaks for, so that our MAVLink is judged by code that is not ours.
//   node node_vehicle.cjs PORT [SIGNING-KEY-HEX]
// Sends heartbeat, attitude, position and battery of system 42 to 127.0.0.1:PORT and prints, one JSON object a line, each
// message that comes back and whether its signature matches.
'use strict';
const dgram = require('dgram');
const { PassThrough } = require('stream');
const { MavLinkProtocolV2, MavLinkPacketSplitter, MavLinkPacketParser, minimal, common, ardupilotmega, standard } = require('node-mavlink');

const port = Number(process.argv[2]);
const key = process.argv[3] ? Buffer.from(process.argv[3], 'hex') : null;
const registry = { ...minimal.REGISTRY, ...standard.REGISTRY, ...common.REGISTRY, ...ardupilotmega.REGISTRY };
const protocol = new MavLinkProtocolV2(42, 1, key ? 1 : 0);
const socket = dgram.createSocket('udp4');
let sequence = 0;
let signingTime = Date.now();

function send(message) {
  let frame = protocol.serialize(message, sequence++ & 255);
  if (key) {
    signingTime = Math.max(signingTime + 1, Date.now());
    frame = protocol.sign(frame, 1, key, signingTime);
  }
  socket.send(frame, port, '127.0.0.1');
}

const start = Date.now();
function attitude() {
  const message = new common.Attitude();
  Object.assign(message, { timeBootMs: Date.now() - start, roll: 0.25, pitch: -0.125, yaw: 1.5, rollspeed: 0, pitchspeed: 0, yawspeed: 0 });
  return message;
}
function position() {
  const message = new common.GlobalPositionInt();
  Object.assign(message, { timeBootMs: Date.now() - start, lat: 473977420, lon: 85455940, alt: 510000, relativeAlt: 12500, vx: 300, vy: 400, vz: -50, hdg: 9000 });
  return message;
}
function heartbeat() {
  const message = new minimal.Heartbeat();
  Object.assign(message, { type: 2, autopilot: 3, baseMode: 209, customMode: 4, systemStatus: 4, mavlinkVersion: 3 });
  return message;
}

setInterval(() => send(heartbeat()), 500);
setInterval(() => { send(attitude()); send(position()); }, 50);

const input = new PassThrough();
socket.on('message', datagram => input.write(datagram));
input.pipe(new MavLinkPacketSplitter()).pipe(new MavLinkPacketParser()).on('data', packet => {
  const type = registry[packet.header.msgid];
  const data = type ? packet.protocol.data(packet.payload, type) : {};
  const fields = JSON.parse(JSON.stringify(data, (_, value) => typeof value === 'bigint' ? value.toString() : value));
  console.log(JSON.stringify({ event: 'message', id: packet.header.msgid, sysid: packet.header.sysid, compid: packet.header.compid,
    signed: packet.signature !== null, matches: key && packet.signature ? packet.signature.matches(key) : null, fields }));
  if (packet.header.msgid === 76) {
    const answer = new common.CommandAck();
    Object.assign(answer, { command: data.command, result: 0, progress: 0, resultParam2: 0, targetSystem: packet.header.sysid, targetComponent: packet.header.compid });
    send(answer);
  }
});
