// A ground station that the npm package node-mavlink speaks for: a TCP client of the gateway, by code that is not ours.
//   node node_station.cjs PORT fly|read
// Reads the parameters; then "fly" uploads a mission, reads it back, arms, takes off and lands, and "read" tries a few of these.
// Prints one JSON object a line; the last one has the event "done".
'use strict';
const net = require('net');
const { MavLinkProtocolV2, MavLinkPacketSplitter, MavLinkPacketParser, minimal, common, ardupilotmega, standard } = require('node-mavlink');

const [port, purpose] = [Number(process.argv[2]), process.argv[3]];
const registry = { ...minimal.REGISTRY, ...standard.REGISTRY, ...common.REGISTRY, ...ardupilotmega.REGISTRY };
const protocol = new MavLinkProtocolV2(255, 190);
const socket = net.connect(port, '127.0.0.1');
const state = { parameters: new Map(), total: -1, acks: [], texts: [], frames: 0, lost: 0, armed: null, mode: null, height: null,
  sequence: null, asked: null, missionResult: null, missionCount: null, items: new Map() };
let sequence = 0;

const report = (event, more = {}) => console.log(JSON.stringify({ event, ...more }));
const send = (type, fields) => socket.write(protocol.serialize(Object.assign(new type(), fields), sequence++ & 255));
const target = { targetSystem: 1, targetComponent: 1 };
const command = (number, ...parameters) => send(common.CommandLong, { ...target, command: number, confirmation: 0,
  ...Object.fromEntries([0, 1, 2, 3, 4, 5, 6].map(i => [`_param${i + 1}`, parameters[i] ?? 0])) });

/// Repeats an action until its outcome is there.
async function achieve(outcome, action) {
  for (let i = 0; !outcome(); ++i) {
    if (i % 40 === 0) action();
    await new Promise(resolve => setTimeout(resolve, 50));
  }
}

const handlers = {
  0: (_, data) => { state.armed = (data.baseMode & 128) !== 0; state.mode = data.customMode; },
  22: (_, data) => { state.total = data.paramCount; state.parameters.set(data.paramIndex, [data.paramId, data.paramValue]); },
  33: (_, data) => { state.height = data.relativeAlt / 1000; },
  40: (_, data) => { state.asked = data.seq; answerItem(data.seq); },
  44: (_, data) => { state.missionCount = data.count; },
  47: (_, data) => { state.missionResult = data.type; },
  51: (_, data) => { state.asked = data.seq; answerItem(data.seq); },
  73: (_, data) => { state.items.set(data.seq, [data.command, data.x, data.y, data.z]); },
  77: (_, data) => { state.acks.push([data.command, data.result]); },
  253: (_, data) => { state.texts.push(data.text); },
};

socket.pipe(new MavLinkPacketSplitter()).pipe(new MavLinkPacketParser()).on('data', packet => {
  if (packet.header.sysid !== 1 || packet.header.compid !== 1) return;
  ++state.frames;
  if (state.sequence !== null) state.lost += (packet.header.seq - state.sequence - 1) & 255;
  state.sequence = packet.header.seq;
  const type = registry[packet.header.msgid];
  if (type && handlers[packet.header.msgid]) handlers[packet.header.msgid](packet, packet.protocol.data(packet.payload, type));
});

// Home, a take-off and a waypoint: command, latitude, longitude (1e-7 degrees), altitude (m).
const plan = [[16, -353632610, 1491652300, 584], [22, -353632610, 1491652300, 20], [16, -353620000, 1491653000, 20]];
function answerItem(seq) {
  if (seq >= plan.length) return;
  const [number, x, y, z] = plan[seq];
  send(common.MissionItemInt, { ...target, seq, frame: seq === 0 ? 0 : 3, command: number, current: 0, autocontinue: 1,
    param1: 0, param2: 0, param3: 0, param4: 0, x, y, z, missionType: 0 });
}

async function readParameters() {
  await achieve(() => state.total > 0, () => send(common.ParamRequestList, target));
  await achieve(() => state.parameters.size >= state.total, () => {
    for (let i = 0; i < state.total; ++i)
      if (state.frames > state.total && !state.parameters.has(i)) send(common.ParamRequestRead, { ...target, paramId: '', paramIndex: i });
  });
  report('parameters', { total: state.total, read: state.parameters.size });
}

async function fly() {
  await achieve(() => state.missionResult !== null, () => { if (state.asked === null) send(common.MissionCount, { ...target, count: plan.length, missionType: 0 }); });
  await achieve(() => state.missionCount !== null, () => send(common.MissionRequestList, { ...target, missionType: 0 }));
  for (let seq = 0; seq < state.missionCount; ++seq)
    await achieve(() => state.items.has(seq), () => send(common.MissionRequestInt, { ...target, seq, missionType: 0 }));
  const same = plan.every((item, seq) => seq === 0 || JSON.stringify(item) === JSON.stringify(state.items.get(seq)));
  report('mission', { result: state.missionResult, count: state.missionCount, same });
  await achieve(() => state.mode === 4, () => command(176, 1, 4)); // GUIDED
  await achieve(() => state.armed, () => command(400, 1));
  await achieve(() => state.height > 8, () => command(22, 0, 0, 0, 0, 0, 0, 10));
  report('flying', { height: state.height });
  await achieve(() => state.mode === 9, () => command(176, 1, 9)); // LAND
  await achieve(() => !state.armed, () => {});
}

async function read() {
  const denied = number => () => state.acks.some(([command, result]) => command === number && result === 2);
  await achieve(denied(400), () => command(400, 1, 21196)); // arm, by force
  await achieve(denied(176), () => command(176, 1, 4));
  const [name, value] = state.parameters.get(0);
  send(common.ParamSet, { ...target, paramId: name, paramValue: value + 1, paramType: 9 });
  state.parameters.delete(0);
  await achieve(() => state.parameters.has(0), () => send(common.ParamRequestRead, { ...target, paramId: '', paramIndex: 0 }));
  report('unchanged', { same: state.parameters.get(0)[1] === value });
}

socket.on('connect', async () => {
  const heartbeat = () => send(minimal.Heartbeat, { type: 6, autopilot: 8, baseMode: 0, customMode: 0, systemStatus: 4, mavlinkVersion: 3 });
  heartbeat();
  setInterval(heartbeat, 1000);
  await readParameters();
  await (purpose === 'fly' ? fly() : read());
  report('done', { frames: state.frames, lost: state.lost, armed: state.armed, acks: state.acks, texts: state.texts });
});
