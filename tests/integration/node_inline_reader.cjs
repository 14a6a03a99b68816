// Reads a MAVLink byte stream from standard input with the npm package node-mavlink and prints the frames that it found:
//   node node_inline_reader.cjs SIGNING-KEY-HEX < stream
// One JSON object: plain frames, frames with a valid signature, frames with unknown incompatibility flags (a reader must drop
// them; this package leaves that to its user), and all others.
'use strict';
const { PassThrough } = require('stream');
const { MavLinkPacketSplitter, MavLinkPacketParser } = require('node-mavlink');

const key = Buffer.from(process.argv[2], 'hex');
const seen = { event: 'seen', plain: 0, signed: 0, unknownFlags: 0, unknownFlagsSigned: 0, other: 0 };
const input = new PassThrough();
const parser = input.pipe(new MavLinkPacketSplitter()).pipe(new MavLinkPacketParser());
parser.on('data', (packet) => {
  const flags = packet.header.incompatibilityFlags;
  const matches = packet.signature !== null && packet.signature !== undefined && packet.signature.matches(key);
  if (flags & ~1) {
    seen.unknownFlags++;
    if (matches) seen.unknownFlagsSigned++;
  } else if (flags & 1) {
    matches ? seen.signed++ : seen.other++;
  } else {
    seen.plain++;
  }
});
parser.on('end', () => console.log(JSON.stringify(seen)));
process.stdin.on('data', (bytes) => input.write(bytes));
process.stdin.on('end', () => input.end());
