<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1">
<context>
    <name>skyseal::ui::CountersTable</name>
    <message>
        <source>good</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Records whose seal verified</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>late</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Good, but after a newer one</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>lost</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sent, but never arrived</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>replayed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Seen before, refused</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>forged</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Seal did not verify, refused</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>malformed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No record at all, refused</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>plain</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Clear MAVLink of a sealed peer, refused</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>to us</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>to it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 %2</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>skyseal::ui::DiagnosticsPanel</name>
    <message>
        <source>Cost of the suite in use</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Time shown</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 min</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Freeze</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Freeze the charts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Decryption rate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>frames/s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Packet loss</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>% (to it dotted)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>CPU load</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>% of a core (suite dotted)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>open %1 ns, p99 %2 ns</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>skyseal::ui::EmptyState</name>
    <message>
        <source>Start the demo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add a link …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Waiting for the autopilot behind %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The link to the agent is sealed; the vehicle beside it has not spoken yet.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Replaying a log</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No vehicle in it so far.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing is connected</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add a link to the vehicle, or listen for one on UDP port 14550.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Waiting for a vehicle on %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Start an agent beside an autopilot:

skyseal-air --vehicle tcp:127.0.0.1:5760 \
        --ground udpout:127.0.0.1:14550 \
        --identity air.key --peers air.peers

or let any autopilot send plain MAVLink here.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>skyseal::ui::FieldModel</name>
    <message>
        <source>raw bytes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Field</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Value</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Type</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>skyseal::ui::HappeningLine</name>
    <message>
        <source>Link %1: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Found a %1, sealed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Found a %1, not sealed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Link to the vehicle lost</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Vehicle is back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Refused %1 clear frames from %2 that claim to be this sealed vehicle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recording %1: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mission sent</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mission read</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: failed, %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Parameter %1 is now %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Parameter %1 not written: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sealed link to %1 is up with %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sealed link ended: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The peer&apos;s address changed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Switch to %1 rolled back: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fresh keys for %1, epoch %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Switched from %1 to %2 in %3 ms</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Handshake refused: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Under attack: %1 forged and %2 replayed records refused</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>skyseal::ui::HelpDialog</name>
    <message>
        <source>Help</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Help page</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no help page &quot;%1&quot;.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>skyseal::ui::HoldButton</name>
    <message>
        <source>Hold for half a second to confirm; Escape aborts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hold to confirm (mouse, Space or Enter); Esc aborts</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>skyseal::ui::Horizon</name>
    <message>
        <source>Artificial horizon</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>roll %1°, pitch %2°, heading %3°</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no attitude</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>skyseal::ui::InspectorModel</name>
    <message>
        <source>%1 signed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Message</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Id</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Count</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>MAVLink</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>skyseal::ui::InspectorPanel</name>
    <message>
        <source>Filter by name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Filter of the message kinds</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Message kinds</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fields of the chosen message</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>skyseal::ui::KeyDialog</name>
    <message>
        <source>Own key</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Give this public key to the agent beside the vehicle. It is no secret, but make sure that it is this one that arrives there.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This station has no identity: it can only speak plain MAVLink.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Own public key</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fingerprint
%1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The key as a QR code</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Identity: %1
Known peers: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>none</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>skyseal::ui::LinkDialog</name>
    <message>
        <source>Connect</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>UDP, listen for vehicles</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>UDP, send to an address</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>TCP, connect to an address</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>TCP, listen for connections</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Serial radio</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recorded log</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Browse …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Browse for the log file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The link that this makes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Kind</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Host</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Port</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Device or file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Baud</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Device</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Replay a log</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Telemetry logs (*.tlog);;All files (*)</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>skyseal::ui::LinkModel</name>
    <message>
        <source>%1: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Link</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>State</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Here</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Received</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sent</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Bad frames</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>skyseal::ui::LinksPanel</name>
    <message>
        <source>Add …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add a link</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove the chosen link</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Links</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>skyseal::ui::LockFace</name>
    <message>
        <source>peer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sealed with %1 for %2
Peer %3 at %4
Fingerprint %5</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing sealed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No vehicle and no session yet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not sealed · plain MAVLink</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not sealed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Anyone on the way can read and change what is sent. Start skyseal-air beside the vehicle to seal the link.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>switching…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Switching to %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 forged or replayed in the last minute</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 refused</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>under attack, %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Under attack: %1. All of them were refused.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>epoch %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>skyseal::ui::LogsPanel</name>
    <message>
        <source>Record what is received and sent</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Replay a log …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Replay a log</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open the folder</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>File being recorded</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>size</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>frames</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>dropped</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Telemetry logs (*.tlog);;All files (*)</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>skyseal::ui::MainMenus</name>
    <message>
        <source>&amp;File</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Link</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Vehicle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Security</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>V&amp;iew</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Tools</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Settings …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Replay a log …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Replay a log</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Telemetry logs (*.tlog);;All files (*)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Connect …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Confirm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Arm …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Arm the motors? The propellers will turn.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Disarm …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Disarm the motors?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Take off …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take off to 10 m?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Land …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Land here?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Return to launch …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Return to launch and land there?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Start the mission …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fly the mission?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Mode</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change the mode to %1?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>S&amp;how</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Vehicle %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cipher suite</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Own key …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Follow the vehicle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Zoom &amp;in</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Zoom &amp;out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Clear the track</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Reset the arrangement</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>F&amp;ull screen</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Start the &amp;demo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;First steps</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Sealing a link</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;About Skyseal</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>About Skyseal</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Skyseal %1

A ground control station whose MAVLink link is sealed.
GPL-3.0-or-later; built with Qt %2, Qt Charts, libsodium and OpenSSL.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>skyseal::ui::MainWindow</name>
    <message>
        <source>Skyseal</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Status</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Flight</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Secure link</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Diagnostics</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Messages</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Inspector</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Parameters</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mission</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Logs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Links</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is in use by another program: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Port %1 is in use, probably by another ground station on this machine (%2).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Listen on %1 instead</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Vehicle %1 · %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Vehicle %1 · %2 · not sealed</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>skyseal::ui::MapView</name>
    <message>
        <source>N</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Map</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Arrow keys move it, plus and minus zoom, Home follows the vehicle</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>skyseal::ui::MarkedChartView</name>
    <message>
        <source>now</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>skyseal::ui::MessageModel</name>
    <message>
        <source>station</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Severity</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Message</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>skyseal::ui::MessagesPanel</name>
    <message>
        <source>Messages</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>station</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Filter</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Filter of the messages</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Least severity shown</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>all</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>notices and above</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>warnings and above</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>errors and above</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy the messages</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Clear</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Clear the messages</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>skyseal::ui::MissionModel</name>
    <message>
        <source>home</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 (now)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Command</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Latitude</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Longitude</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Altitude</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>skyseal::ui::MissionPanel</name>
    <message>
        <source>Read from the vehicle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Send a file …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save as …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Result of the last transfer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mission items</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Missions (*.waypoints *.txt);;All files (*)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reading …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Send a mission</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save the mission</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sending %1 items …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The vehicle has the mission</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not sent: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not read: %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>skyseal::ui::ParameterModel</name>
    <message>
        <source>written, read back %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not written: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no number</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>writing %1 …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Parameter</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Value</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Last change</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>skyseal::ui::ParametersPanel</name>
    <message>
        <source>Fetch</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fetch the parameters</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Filter by name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Filter of the parameters</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Parameters fetched</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Parameters</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not fetched</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>skyseal::ui::ProblemBanner</name>
    <message>
        <source>Solve the problem</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dismiss</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dismiss the problem</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>skyseal::ui::QtTimeSeriesChart</name>
    <message>
        <source>%1, %2</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>skyseal::ui::SecureLinkPanel</name>
    <message>
        <source>Session to show</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Peer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sealed since</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How to seal this link</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Result of the last switch</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fingerprint of the peer&apos;s key</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No sealed link</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The session starts by itself once a known agent announces itself.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not sealed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This vehicle speaks plain MAVLink: anyone on the way can read it and fly it. Start skyseal-air beside it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sealed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sealed, switching…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Under attack: %1 forged, %2 replayed in the last minute, all refused</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Under attack</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>unnamed peer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 ✓ · %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>epoch %1 · for %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fingerprint of %1
%2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>skyseal::ui::SettingsDialog</name>
    <message>
        <source>Settings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>View</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Colours</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>as the desktop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>light</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>dark</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>high contrast</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Units</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>metric (m, m/s)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>imperial (ft, mph)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Colours</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Units</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Station</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>MAVLink system id</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>MAVLink component id</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Link to open at start</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Record what is received and sent (.tlog)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Record</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Folder of the recordings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the application&apos;s own folder</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Browse …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Browse for the folder of the recordings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>MAVLink &amp;system</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>MAVLink c&amp;omponent</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Link at start</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Folder</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ids, link and folder take effect at the next start.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Security</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show sealed vehicles &amp;only</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show sealed vehicles only</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Allow &amp;insecure research suites (RC4)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Allow insecure research suites</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Plain MAVLink is then never shown and never answered. Takes effect at the next start.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>RC4 is broken: who records the link may read it. It is here to be measured against the others, is never chosen by itself, and works only when the vehicle&apos;s agent allows it as well. I understand that while it is in use the link is not confidential.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>skyseal::ui::StatusStrip</name>
    <message>
        <source>Vehicle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Armed state</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Flight mode</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>GPS</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Battery</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Link security</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Link quality</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>DISARMED</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>RTK fixed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 sat</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No vehicle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Vehicle %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>ARMED</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>HDOP %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>low</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No link</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Link OK %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Link lost</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lost</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Link poor %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 frames/s, %2 lost, latency %3, newest message %4 ago</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>skyseal::ui::Suite</name>
    <message>
        <source>plain, not sealed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 (insecure)</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>skyseal::ui::SuiteActions</name>
    <message>
        <source>the link is not sealed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no sealed link yet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>research is off</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not offered by it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not allowed here</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Now %1, after %2 ms</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stays with %1: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Session ended: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>switching…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>skyseal::ui::SuiteLegend</name>
    <message>
        <source>Legend</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>skyseal::ui::SuiteRow</name>
    <message>
        <source>%1 (%2)</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>skyseal::ui::TrafficBar</name>
    <message>
        <source>Links</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Received</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sent</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recording</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>recording %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 %2 (%3)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no link</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not recording</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>skyseal::ui::ValuesPanel</name>
    <message>
        <source>alt</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>speed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>climb</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>current</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>EKF</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>hdg</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>home</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>HDOP</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>throttle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Age of the values</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>good</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>bad</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Last heard %1 ago</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>skyseal::ui::VehicleActions</name>
    <message>
        <source>Arm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take off</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Land</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Return</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Set mode</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Flight mode to set</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take-off altitude</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Result of the last command</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not sent: hold the button to confirm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Disarm</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>skyseal::ui::VehicleCommands</name>
    <message>
        <source>%1: asked …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>skyseal::ui::Words</name>
    <message>
        <source>no GPS</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no fix</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>2D fix</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>3D fix</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>DGPS</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>RTK float</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>RTK fixed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>static</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>PPP</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>plane</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>quadrotor</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>coaxial helicopter</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>helicopter</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>antenna tracker</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>airship</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>rover</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>boat</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>submarine</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>hexarotor</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>octorotor</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>tricopter</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>VTOL</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>vehicle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>emergency</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>alert</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>critical</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>error</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>warning</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>notice</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>info</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>debug</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>switched</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not allowed at this end</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not allowed by the vehicle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the vehicle did not confirm in time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the other end&apos;s choice came first</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the session ended</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the other end restarted</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>closed by the other end</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>silent for too long</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>its keys were used up</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>its key is no longer a known peer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>closed here</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>an unknown key: nobody confirmed it here</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>made for another key: meant for somebody else, or an impostor</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a replayed handshake</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no cipher suite that both ends allow</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the offer of suites was tampered with</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>another version of the protocol</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>closed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>opening</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>listening</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>connected</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>waiting to try again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>finished</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>failed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>accepted</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>refused</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>refused: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no answer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no answer: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Arm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Disarm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take off to %1 m</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Land</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Return to launch</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mode %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fly to the point</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Speed %1 m/s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mission item %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Start the mission</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Restart the autopilot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Command %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
</TS>
