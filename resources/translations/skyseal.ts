<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1">
<context>
    <name>ArmedQuestions</name>
    <message>
        <source>Replay a log</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Vehicles %1 are armed. Replay a log?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Vehicle %1 is armed. Replay a log?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No vehicle can be commanded until you go back to the live picture.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Replay</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Quit Skyseal</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Vehicles %1 are armed. Quit?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Vehicle %1 is armed. Quit?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>While Skyseal is closed, no vehicle can be commanded from here, and failsafes may trigger.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Quit</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Metric</name>
    <message>
        <source>Packets transmitted</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>MAVLink frames that the station received from the vehicle during the run, without duplicates of clear frames</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>packets per second</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rate in bytes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>MAVLink bytes received per second, after opening</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Frames lost</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>share of the vehicle&apos;s frames missing by MAVLink sequence numbers, 0 to 1; empty where jitter reorders the frames of the saturated load by more than 8 bits can number</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Records lost, to the station</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>share of the agent&apos;s records missing by their counters, 0 to 1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Records lost, to the agent</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the same in the other direction, as counted by the agent and reported over the sealed link</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>CPU load, station</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>CPU time of the station&apos;s I/O thread (receive, open, parse, send), percent of one core</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>CPU load, station&apos;s process</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>all threads of the measuring program</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Share of the measurement in the CPU load, station</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>CPU time in which the station&apos;s I/O thread made and handed out snapshots, probes and time lines, by its own clock, percent of its CPU time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Snapshots during the run, station</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>snapshots that the station&apos;s I/O thread built from the first probe of the run on: 1, which is the last probe, or those of a window as well</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>CPU load of the suite, station</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>time inside seal and open, clocked around each call, percent of one core</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>CPU load, agent</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>CPU time of the agent&apos;s process, by the kernel&apos;s clock of it over the whole run for all arms alike; where the agent runs on another machine, between its reports over the sealed link, and empty in plain MAVLink, which has no reports</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>CPU load of the suite, agent</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>time inside seal and open at the agent, reported over the sealed link, percent of one core</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>CPU time per frame, station</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>CPU time of the I/O thread divided by frames</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>CPU time per frame, agent</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>CPU load of the agent divided by the frame rate of the run</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Opening a record, median</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>clocked around each call, including look-up and replay window; exact to 1/32</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Opening a record, 99th percentile</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the same</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sealing a record, median</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>clocked around each call, at the station</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sealing a record, 99th percentile</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Opening a record, agent</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>mean, clocked around each call at the agent, reported over the sealed link</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sealing a record, agent</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Memory, station</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>resident set of the measuring program at the end of the run; one process runs all suites, so the value does not belong to one suite</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Memory, agent</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>resident set of the agent at the end of the run, from /proc for all arms alike; where the agent runs on another machine, as reported over the sealed link; one process runs all suites, so the value does not belong to one suite</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Bytes on the wire</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>UDP payload of both directions during the run</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Bytes on the wire, to the station</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>UDP payload per second</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Use of the line, to the station</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>bytes that the impaired line carried to the station, announcements of the agent included and duplicates of the relay left out, percent of its rate; empty without a limited rate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wire cost of a frame</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>bytes to the station, including 28 of IPv4 and UDP headers for each datagram, divided by frames</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Overhead on the wire</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>UDP payload to the station beyond the MAVLink bytes in it, percent of these</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Frames in a datagram</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>MAVLink frames divided by the datagrams to the station, each of which is a record in the sealed framing; the fewer, the more records and wake-ups a frame costs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Latency</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>round trip of TIMESYNC to the vehicle, mean of the run</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Memory of a session</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>heap of a session at one end, including its keyed ciphers; measured once for each suite with separate sessions of this program</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Power of the machine</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>mean over the run, by the kernel&apos;s energy counters of the processor or the sensor of the supply: with all programs on it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Power above idle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the same, less the power of the idle machine before and after the launch of the programs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Energy per frame</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the energy above idle divided by frames received by the station; all programs of the sweep</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Time of the live switch</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>from the first order of the run to the confirmation by the other end, including orders that were not confirmed in time; empty if the suite of the run was in use already</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wake-ups, station</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>voluntary context switches of the station&apos;s I/O thread per second</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Involuntary context switches, station</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>of the station&apos;s I/O thread per second: another program took its core</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wake-ups, agent</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>voluntary context switches of the agent&apos;s main thread per second, on the same machine only</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Involuntary context switches, agent</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>of the agent&apos;s main thread per second, on the same machine only</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>CPU load, simulator</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>CPU time of the simulator that the sweep started, percent of one core</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>CPU load, relay</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>CPU time of the relay of an impaired link, percent of one core</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>CPU load, autopilot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>CPU time of the autopilot beside which the sweep ran, percent of one core; empty if its process was not found on this machine</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Missed sends of the paced load</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>frames that the generator of a paced load did not send, since it was 20 ms late on its schedule or its queue was full; exact to a tenth of a second at the ends of the run; empty under other loads</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>CPU load, other programs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>CPU time of this machine that was used neither by the measuring program, nor by programs that the sweep started or the autopilot, percent of one core; exact to the ticks of the kernel&apos;s clock on each core</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Time taken by the hypervisor</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>time in which a virtual core had work and was not run, percent of one core</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Frequency of the cores</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>mean over the cores and over the two ends of the run, as the kernel states it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change of the frequency of the cores</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>difference between the two ends of the run, percent of their mean</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Load average per core, at the start</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>load average of the last minute at the start of the run, divided by the number of cores; the sweep&apos;s own programs are part of it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Load average per core, at the end</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the same at the end of the run</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Power of the idle machine</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>mean of five seconds before the programs of the launch started and five after they ended</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change of the power of the idle machine</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>difference between the two, percent of their mean</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Throttlings of the processor</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>how often the processor slowed down during the run, hot or short of power: the kernel&apos;s counters of cores and packages, or one where the firmware says so at an end of the run</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>QObject</name>
    <message>
        <source>Known peers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Remember it in the desktop keyring</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remember it in the desktop keyring (%1)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Anyone logged in as you, and any program you run, can then use the key without the passphrase.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Reason</name>
    <message>
        <source>the passphrase does not open it, or the file was changed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>there is no peer named &quot;%1&quot; any more</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cannot be read: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>holds no public key of Skyseal</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the folder cannot be made</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the passphrase was not given</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the station is not running</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>is not a recording</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cannot be written: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cannot be created: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>less than %1 MiB are free there</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>is not a counter file of Skyseal, or is damaged</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the disk does not answer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>is not a regular file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>belongs to another user (number %1), who can change it, refused</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>can be read by other users (mode %1), refused; run: chmod 600</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>can be changed by other users (mode %1), refused; run: chmod 600</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>is too large to be a file of this kind</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>is a symbolic link, refused for a secret; name the file itself</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>exists already and is not overwritten</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cannot be locked: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>is still locked by another program after %1 ms, try again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the system ID %1 is bound to &quot;%2&quot; already; each vehicle needs its own</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the peer &quot;%1&quot; is known with another key</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>character %1 is not valid UTF-8</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>character %1 is %2, a blank</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>character %1 is %2, a control or format character</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is not a list of system IDs: numbers from 1 to 255 with commas between them, or &quot;any&quot;</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a peer needs a name, a role, system IDs and a public key, here are %1 fields</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is not a role: pilot or observer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is not a pre-shared key: psk=FILE</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is not a peer&apos;s name: 1 to 32 letters, digits, &quot;-&quot;, &quot;_&quot; or &quot;.&quot;; one beyond ASCII counts as 2 to 4</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is not a peer&apos;s name: it must not begin with &quot;-&quot;</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is not a peer&apos;s name: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>0 is not a system ID: numbers from 1 to 255</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 cannot be noted: the path of a pre-shared key must not have blanks</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>does not exist; keys pair and keys peers add create it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a list has at most %1 peers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>there is a peer named &quot;%1&quot; already</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the peer &quot;%1&quot; has the same key already</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>there is no peer named &quot;%1&quot;</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>this is not a public key: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it does not begin with &quot;skyseal:&quot;</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>48 characters follow &quot;skyseal:&quot;, here %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>its check does not fit, so some character is wrong</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>is not a sealed key file of Skyseal: it does not begin with &quot;%1&quot;</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>is truncated: a sealed key has four lines</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;argon2id PASSES KIB SALT&quot; is expected here</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>asks for %1 passes over %2 KiB, which is outside of what is accepted (1 to 16 passes, 8192 to 1048576 KiB)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a public key is expected here</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>has a truncated key</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>has a damaged key</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>has more behind the key</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>holds &quot;%1&quot;, not &quot;%2&quot;</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>is not a key file of Skyseal: it does not begin with &quot;%1&quot;</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>has more than one key</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>has a damaged key: its check does not fit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>is truncated: it has no key</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>needs %1 MiB of memory for its passphrase, more than this machine gives</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>is sealed with a passphrase, and none is given</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1; %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 (pre-shared key of &quot;%2&quot;)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no error</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>port %1 is in use by another program</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is not an address of this machine</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the host name &quot;%1&quot; is not known</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 refuses the connection (nothing listens there)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 cannot be reached</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 does not answer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 closed the connection</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no permission to open %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>there is no device %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the device %1 is in use by another program</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cannot read %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>end of %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is not supported here</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 failed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a link URL is at most 4096 characters long</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a link URL cannot hold control characters</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a link URL starts with %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the baud rate is a number from 300 to 12000000</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the device is missing, as in %1:/dev/ttyUSB0:57600</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the file is missing, as in %1:flight.%1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the IPv6 address lacks its closing bracket</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>an IPv6 address must be in brackets, as in [::1]:14550</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the port is missing, as in %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>an IPv6 address with a zone (%) is not supported</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not an IPv6 address</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the host is missing, as in %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not an IPv4 address</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a host name or address</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the port &quot;%1&quot; is not a number from %2 to 65535</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it is not a file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>permission denied</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the coordinates are not in WGS84, but in &quot;%1&quot;</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>more than %1 objects are within one another</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>this is not an object</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>this is not an array</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a type of GeoJSON</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>this is not a position: [longitude, latitude]</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>this is not an array of positions</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>this is not an array of lines</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the file has more than %1 values</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the file has no JSON object</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a document type declaration is not permitted</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>more than %1 elements are within one another</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the file begins with the element &quot;%1&quot;, not with &quot;kml&quot;</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a geometry is within another one</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a position: longitude,latitude</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a geometry has more coordinates than one of its kind can have</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the file has more than %1 positions</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the longitude %1 is not within -180 and 180</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the latitude %1 is not within -90 and 90</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a .kmz is a zip file; unpack it, and add the .kml that is in it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the name ends neither in .kml nor in .geojson or .json</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>this is not a file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the file is larger than %1 MB</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>expected the text of the item before the condition</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>longer than %1 bytes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a control character: this is not a text file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>an item longer than %1 bytes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>more than %1 items</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no items</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not a mission file: the first line must be &quot;QGC WPL 110&quot;</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>an item has 12 columns, this line has %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a mission has at most %1 items</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>more than %1 parameters</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>contains no parameters</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>nothing was sent: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not supported</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no vehicle with system ID %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no answer to %1 attempts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cancelled</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1; the agent may know this station as an observer, or the commands reach it too late: it drops both</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no answer yet, and not sent again: this program was suspended for %1 s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>too many commands are waiting for answers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>replaced by a newer command</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>sent %1 times; the vehicle does not confirm it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>acknowledged; no heartbeat since</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>acknowledged, but the vehicle reports armed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>acknowledged, but the vehicle reports disarmed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it needs the mode %1, the vehicle went to %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it needs the mode %1, the vehicle stays in %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>acknowledged, but the vehicle reports the mode %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>acknowledged, but the vehicle reports mission item %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the modes of this kind of vehicle are not known</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the vehicle has no mode &apos;%1&apos;; it has %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the altitude of a take-off must be above 0 m</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>this kind of vehicle does not fly</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>take-off needs the mode GUIDED, the vehicle is in %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>take-off needs an armed vehicle, it is disarmed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>take-off needs a known position</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>this kind of vehicle has no mode to land in</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>this kind of vehicle has no mode to return in</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>this kind of vehicle has no mode to loiter in</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the location is not on the globe</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>going to a location needs the mode GUIDED, the vehicle is in %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>going to a location needs a known home altitude</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the altitude is not a number</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>changing the altitude needs a known position</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>changing the altitude needs a known home altitude</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>pointing at a location needs a known home altitude</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>moving home needs a known home altitude</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the speed must be above 0 m/s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>another mission transfer is under way</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>item %1 is not on the globe</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the vehicle does not send item %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the vehicle stopped requesting items</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the vehicle ended the upload early</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a name of up to 16 characters and a number are needed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the vehicle does not send its parameters</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>only %1 of %2 parameters came</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the vehicle keeps %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>another file transfer is under way</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a path of up to %1 bytes is needed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a file has at most %1 bytes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the file is larger than %1 bytes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the folder has more than %1 entries</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the checksums of both ends differ</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the vehicle does not send the checksum</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>without a checksum, the part that is kept cannot be used</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the vehicle does not report the size of the file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the size of the file does not match the part that is kept</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the file changed while it was read</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the vehicle does not send byte %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the vehicle does not accept byte %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>another request for logs is under way</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the vehicle has no such log</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the vehicle still has logs, or does not answer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the vehicle does not list its logs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the vehicle does not list its logs while it is armed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the vehicle does not send byte %1 and following</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the log is larger than %1 bytes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the log does not match the part that is kept</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the log changed while it was read</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>result %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>accepted</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>temporarily rejected</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>denied</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>failed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>in progress</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>accepted as COMMAND_LONG only</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>accepted as COMMAND_INT only</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>coordinate frame not supported</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>this station is not in control</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the vehicle reports an error</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>command not supported</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no space left on the vehicle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>an item is invalid</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>parameter 1 is invalid</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>parameter 2 is invalid</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>parameter 3 is invalid</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>parameter 4 is invalid</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>x (latitude) is invalid</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>y (longitude) is invalid</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>z (altitude) is invalid</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>an item arrived out of sequence</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not accepting missions from this station</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the vehicle reports a failure</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the vehicle refuses the size</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the vehicle has closed the file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>too many files are open on the vehicle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>end of file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not supported by the vehicle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the file exists</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the file is protected</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no such file or folder</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the vehicle reports error %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the vehicle reports error code %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>other programs used %1 % of a core</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the hypervisor took %1 % of a core</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the station&apos;s I/O thread had to give up its core %1 times a second</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the agent had to give up its core %1 times a second</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the frequency of the cores differed by %1 % between begin and end</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the load average at the start was %1 per core</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the load average at the end was %1 per core</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the power of the idle machine differed by %1 % before and after</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the processor was throttled %1 times</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the measurement itself took %1 % of the CPU time of the station&apos;s I/O thread</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the simulator (which makes the load) used %1 % of a core</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>up to %1 % under the %2 load</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A run is the difference of two readings, taken by the thread that is measured. Of its CPU time, taking and publishing readings was %1 (meter_cpu)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>up to %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 (1 run)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 (%2 runs)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 of %2 runs were disturbed, so that their figures are noisier and may be wrong: %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>was not found beside this program or in PATH</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 could not be started: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it was killed or crashed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>exit status %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 ended by itself: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 ended by itself: %2 (%3)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the generator of the load did not count its sends</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the generator missed %1 % of its sends</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 % of the line&apos;s rate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 % of the station&apos;s core</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 % of the agent&apos;s core</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not saturated: nothing reached %1 % (%2)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the other end does not allow plain MAVLink</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the other end does not allow inline framing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the vehicle&apos;s payloads could not be decrypted; is its key another one?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This sweep is incomplete: it %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>another suite came into use during the run</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the link fell silent</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the vehicle fell silent during the run</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the session did not last through the run</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the other end did not take this suite</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the switch was not confirmed in time, %1 times</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>another switch took the place of this one, %1 times</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the station ended</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no sealed session with a vehicle came up</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no vehicle was heard in plain MAVLink; do both ends allow it?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>only the sweep&apos;s own simulator encrypts payloads with a bare cipher</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>given up after %1 runs in a row that failed; the last one: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>was given up or cancelled after its last run</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>ended after %1 of %2 runs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 (%2 load, link %3): %4</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 (%2 load): %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>1 of 1 run failed: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 of %2 runs failed: %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 of %2 runs are not valid and left out of every comparison; the first of them, %3 (%4 load): %5</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>this is not JSON: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>this is not XML: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a field&apos;s name (%1)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>one of &gt;= &lt;= &gt; &lt; == !=</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>== or !=, since %1 is a text</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a value to compare %1 with</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a number to compare %1 with</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the end of the condition</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>nothing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the end of the step</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>expected %1, found %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>step %1: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no PNG and PDF: skyseal-figures is not installed; report.html and the SVG files have the same content</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>PNG and PDF could not be drawn by %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the folder cannot be created</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a key is 32 bytes, or 64 hex digits</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 hex digits are expected as nonce</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the library refuses the cipher</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a system ID and a public key in hex are expected</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>sysid=&apos;%1&apos;: a system ID from 1 to 255 is expected</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>from=&apos;%1&apos;: ADDRESS/PREFIX is expected</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>name=&apos;%1&apos;: a name of printable characters is expected</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&apos;%1&apos;: write, from, sysid or name is expected</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is given twice</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&apos;%1&apos;: OPTION=VALUE is expected</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&apos;%1&apos;: clients are served over UDP or TCP</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>from=: &apos;%1&apos; serves the host of its URL alone; from= is for links that listen</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>write=&apos;%1&apos;: none, all, or mission, param, command, ftp and rc are expected</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>natural</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>saturated</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>pps%1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>none</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 inline</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 bare</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 sealed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 (A/A)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, %2 load, %3 % for each run</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>values change with the order of the runs within a launch, so that the warm-up was too short or the machine drifts: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>this build is %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the machine was busy with other work: load average %1 on %2 cores at the start; the figures are noisier and may be wrong</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not optimised: the figures of this build are not meaningful</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>optimised by %1 alone, as for tests: the figures are higher than those of a release</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it contains no MAVLink frame</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a position has two or three numbers, not %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;%1&quot; has %2 numbers; a position has two or three, with decimal points</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;%1&quot; has a decimal comma; numbers in files have a point</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a number</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a whole number from 0 to %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a latitude from -90 to 90</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a longitude from -180 to 180</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>version %1 of mission files is not known, only 110 and 120</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>this is a plan in JSON; mission files begin with &quot;QGC WPL 110&quot;</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>item %1 stands where item %2 is expected</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the file has no items after its first line</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a name and a value, or QGroundControl&apos;s five columns, are expected, not &quot;%1&quot;</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a name of at most 16 letters, digits and signs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a component from 1 to 255</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a type of parameters</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not a parameter file: %1 lines before this one cannot be read</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 occurs again; this line counts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>item %1, %2: %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>parameters 5 and 6 are too large for the mission protocol</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the mission protocol carries parameters 5 and 6 of this command as whole numbers only</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>this vehicle keeps its home position as item 0, which the mission lacked: it was inserted, and the items moved up by one</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>this vehicle keeps its home position as item 0, so that it does not fly to the first waypoint of the mission</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>item 0 looks like the home position of an ArduPilot mission: this vehicle flies to it as its first waypoint</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the first item is the home position of a mission, which has no place in a list of this kind: it was left out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>another component turned out to be the autopilot; request it again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>an item has 12 columns, this line has %1 or more</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the only item is the home position of a mission; to remove what the vehicle has, clear its list</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the autopilot does not say that the mission protocol reaches its fence: it could take this for its mission</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the autopilot does not say that the mission protocol reaches its rally points: it could take this for its mission</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the autopilot does not answer what it can do (AUTOPILOT_VERSION): it could take this for its mission</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>changed by another station</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>changed by another station: %1 items instead of %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a transfer to the vehicle was not completed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>what the vehicle has was %1; read it again, or overwrite it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the vehicle has other items than those that were edited: another station changed them; they were read again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the vehicle speaks MAVLink 1, which knows missions only; fences and rally points need MAVLink 2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>only %1 of %2 parameters came: %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>of component %1 only %2 of %3 parameters came</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 does not fit the parameter, which takes %2 to %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 does not fit the parameter, which takes whole numbers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>this vehicle takes whole numbers as floats, which cannot hold %1; the nearest is %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the vehicle has no such parameter</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the vehicle refuses the value: it is out of range</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the vehicle denies the permission</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the vehicle has no such component</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the parameter is read-only</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the vehicle does not support the type of the parameter</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the vehicle has the parameter with another type</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the vehicle cannot read the parameter</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the vehicle refuses it with error %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 % of the frames came from another vehicle, which the costs contain</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the vehicle was not ready for it, and is in %1 now</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the mode %1 was not entered: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the vehicle was not armed: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1; the vehicle is armed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a mission needs an armed vehicle to start, it is disarmed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a plane without vertical take-off takes off in the mode TAKEOFF, or in a mission</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the vehicle is in the air; only an emergency stop ends its motors</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a plane without vertical take-off lands in a mission, or by hand</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>this kind of vehicle flies no missions</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Sweep</name>
    <message>
        <source>nothing is connected</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the link is not sealed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the link is silent</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>missing on this machine</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not in this build</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the settings require sealing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no sealed link yet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the agent does not allow it (skyseal-air --allow-plain)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not while the vehicle is armed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>none</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>inline</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>bare, insecure</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>sealed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 (A/A)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>natural load</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>saturated load</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>clean link</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>about %1 s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>about %1 min %2 s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 baud</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 % loss</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 % duplicates</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 % reordered</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 % corrupted</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 ms delay</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>up to %1 ms jitter</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no impairment</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>other links would be measured as well: keep only one sealed link open</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the connected link is measured as it is</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the load of a connected vehicle cannot be changed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the autopilot sets its own rates</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 (%2 to %3)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ratios to plain MAVLink</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ratios to %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>load of %1 frames/s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>frames/s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not in this framing</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>skyseal::app::Application</name>
    <message>
        <source>No sealed links: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Enter the passphrase</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The list of peers cannot be used; the previous list stays in force: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ignored entries in the list of peers: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The system does not report changes to the list of peers; it is checked once a second</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Restart the demo</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>skyseal::app::Demo</name>
    <message>
        <source>it was killed or crashed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>exit status %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The demo needs %1, which was not found beside this program or in PATH.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The demo&apos;s %1 exited: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The demo&apos;s %1 could not be started: %2</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>skyseal::app::DesktopKeyring</name>
    <message>
        <source>there is no desktop session</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The keyring did not store the passphrase: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The keyring did not delete the passphrase: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no keyring is running in this desktop session</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>skyseal::app::NoMemory</name>
    <message>
        <source>not included in this build</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>skyseal::app::SweepController</name>
    <message>
        <source>skyseal-sim, skyseal-air or skyseal-cli is not installed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the station is not running</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>skyseal::app::WindowPairing</name>
    <message>
        <source>the station is not running</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>skyseal::engine::AgentEventText</name>
    <message>
        <source>Ground side: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Vehicle side: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>message %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>one request</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 requests</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>one frame</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 frames</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Refused %1 from %2, which is an observer: %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Refused %1 from %2, which sends requests too often: %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Refused %1 from %2, received too late: %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The vehicle signs its messages with the key of this agent</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>most recently %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A device on the vehicle side uses system ID %1 of a ground station and is ignored; an autopilot needs a different ID</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Handshake counters can be stored again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Handshake counters cannot be stored: %1. The links stay up. If this agent restarts now, it will answer replayed handshakes, but they cannot establish a session</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Refused %1 from %2, which is not permitted to use that system ID: %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Refused %1 without a signature on the vehicle side. If the vehicle sent them, set up its signing: skyseal-air --signing setup</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Refused %1 on the vehicle side, not signed with the key of this agent</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Refused %1 on the vehicle side with an old signature: a replay, or the vehicle lost its signing time, which recovers automatically</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Did not forward %1 from stations: MAVLink 1 cannot be signed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Did not forward %1 from stations: only this agent may change the vehicle&apos;s signing key</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Did not forward %1 from stations: the vehicle cannot track more signing senders until it restarts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The signing timestamp cannot be stored: %1. Signing continues</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>skyseal::engine::EventText</name>
    <message>
        <source>Link to the vehicle lost</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Link to the vehicle recovered</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The agent %1 at %2 has answered or is no longer heard</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The agent %1 at %2 announces itself but does not answer: does it know this station&apos;s key? %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not recording to %1: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fence</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rally points</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mission</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 sent</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 read</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 cleared</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 not sent: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 not read: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 not cleared: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Parameters read</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Parameter %1 is %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Parameter %1 not read: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>List of logs read</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>List of logs not read: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Log %1 read</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Log %1 not read: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Logs erased</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Logs not erased: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Folder %1 listed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>File %1 read</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>File %1 written</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>File %1 removed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Folder %1 not listed: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>File %1 not read: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>File %1 not written: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>File %1 not removed: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Parameters not read: %1</source>
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
        <source>Sealed link to %1 at %2 is up with %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sealed link to %1 ended: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The address of %1 changed to %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Switching from %1 to %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Switch to %1 rolled back: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Switched from %1 to %2, epoch %3, in %4</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Refused a handshake from %1: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 (key %2)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Under attack: refused %1 forged and %2 replayed records that claim to come from %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Link %1: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Link %1: listening on %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Link %1: replay finished</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Vehicle %1: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the peer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 cannot determine the delay of commands and ignores any that may be older than %2 s: it ignored %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Messages to %1 were withheld or delayed in transit and overtaken by others: it ignored %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Commands reach %2 up to %1 s late, and it ignores any that are older than %3 s: it ignored %4</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>one message</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 messages</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>one plain frame</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 plain frames</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>one frame</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 frames</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dropped %1 because this program did not keep up</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>one event</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 events</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>New keys for %1, epoch %2, in %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Command: %1</source>
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
        <source>no answer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Client %1 at %2 connected, read-only</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Client %1 at %2 connected, may write: %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Client %1 at %2 disconnected</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Further events: %1 connected and disconnected, %2 denied</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>one client</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 clients</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Denied %1 from client %2 at %3, most recently %4</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keys of %1 not changed: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>An agent at %1 announces itself with an unknown key</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The companion computer of %1 can store handshake counters again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The companion computer of %1 cannot store handshake counters; its disk may be full, read-only or broken. The link stays up. If that computer restarts now, it will answer replayed handshakes, but they cannot establish a session</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Found: %1, sealed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Found: %1, not sealed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Refused %1 from %2 with the system ID of this sealed vehicle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This vehicle, at %1, is waiting for approval: it is not sealed and may be impersonating %2, which has not been heard</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Refused %1 from %2, which may not send as this vehicle. If %2 is its agent, bind the system ID to %2 in the list of peers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Refused %1 from %2, which sends as this vehicle although its system ID belongs to %3. If %2 is a new agent of the same vehicle, remove %3 from the list of peers or bind the system ID to %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Handshake counters can be stored again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Handshake counters cannot be stored: %1. The links stay up. If this station restarts now, agents will refuse its first handshake and return the correct counter</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1. To show vehicle %2, bind its system ID to %3 in the list of peers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A vehicle at %1 is not shown: it has the system ID %2, which is this station&apos;s own. Change one of the two</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Found: %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>skyseal::engine::Number</name>
    <message>
        <source>0.5</source>
        <comment>with this language&apos;s decimal point</comment>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>skyseal::engine::PairingText</name>
    <message>
        <source>timed out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cancelled</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the vehicle was armed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>refused here</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the other end refused</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the pairing was interrupted; start again at both ends</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>three wrong passphrases: they differ, or an attacker is guessing; start again at both ends</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not paired: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Paired with %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Another device tried to pair at the same time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The passphrases of the two ends differ, or only one end has one, or the link is very poor. Start again with the same passphrase at both ends</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>skyseal::engine::StateText</name>
    <message>
        <source>plain, not sealed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 (insecure)</source>
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
        <source>waiting to retry</source>
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
        <source>its keys are in use twice, as if the machine at one end had been copied</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>its keys were used up</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>its key is no longer among the known peers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>closed here</source>
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
        <source>not allowed by the other end</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the other end did not confirm in time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the session ended</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>its key is not among the known peers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it was made for a different key: a wrong destination, or an impersonation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>there is no cipher suite that both ends allow</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>its offer of suites was modified in transit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it uses another version of the protocol</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>all handshake counters of this station&apos;s key are used up; it needs a new key</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 or %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the other end&apos;s request took precedence</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>its counter was used before: a replay, or the station lost its counter file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>this end&apos;s counter file was lost or restored; it continues from the number that the other end remembers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>there are too many handshakes; only senders that prove their address are answered</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>skyseal::engine::SystemText</name>
    <message>
        <source>ground station</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>companion computer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>gimbal</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>ADS-B receiver</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>camera</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>charging station</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>FLARM receiver</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>servo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>remote ID</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>battery</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>parachute</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>logger</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>on-screen display</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>inertial sensor</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>GPS receiver</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>winch</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>light</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>gripper</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>radio</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>autopilot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>component</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Other systems behind %1: %2</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>skyseal::link::LinkType</name>
    <message>
        <source>UDP, listen for vehicles</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Receives datagrams on a local port; each sender is a peer.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>UDP, send to an address</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sends datagrams to one host and receives its answers.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>TCP, connect to an address</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Connects to one server and reconnects when the connection is lost.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>TCP, listen for connections</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Accepts connections on a local port; each client is a peer.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Serial radio</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Opens a serial device: 8 data bits, no parity, 1 stop bit, no flow control.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recorded log</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Replays a telemetry log at the recorded pace, with pauses of at most five seconds; nothing is sent.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>skyseal::ui::ActionBar</name>
    <message>
        <source>Arm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Actions</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take off</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Start mission</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pause</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Land</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>RTL</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Returns to launch and lands there.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Result of the last command</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the vehicle&apos;s modes have changed</source>
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
    <message>
        <source>veh. %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>vehicle %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>another vehicle is selected</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the vehicle has been armed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the vehicle has been disarmed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not sent: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stops and holds the present position; a plane circles it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Starts or continues the mission.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Checklist and pre-arm checks…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Arm and
take off</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Arm and take off</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Arms the motors, and takes off at once.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Arm and start
mission</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Arm and
start</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Arm and start mission</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Arms the motors, and starts the mission at once.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>In its present mode the vehicle takes off as soon as it is armed.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>skyseal::ui::ActionPermits</name>
    <message>
        <source>the vehicle is disarmed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not now: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the mission last read is empty: read it again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the vehicle is armed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the vehicle is already flying</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the vehicle was flying when it was last heard</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the vehicle is not heard</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>skyseal::ui::AddWaypointDialog</name>
    <message>
        <source>%1
Hold the button for half a second. The waypoint is put before the last item of the mission, and the whole mission is sent to the vehicle.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1
Hold the button for half a second. The waypoint becomes the last item of the mission, and the whole mission is sent to the vehicle.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add to the mission</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add and send</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>skyseal::ui::AircraftText</name>
    <message>
        <source>altitude unknown</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 · near</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>skyseal::ui::AlertList</name>
    <message>
        <source>Link lost %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing has been received from the vehicle since. The last received values are shown.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Failsafe</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Emergency</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Flight terminated</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Aircraft near: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Battery very low: %1 %</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Battery low: %1 %</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>One forged frame</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 forged frames</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>One replayed frame</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 replayed frames</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not recording: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Counters not stored: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: its disk may be full</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: keys in use twice</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unknown agent at %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Switched to %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keys not changed: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not switched to %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The agent</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 (%2 times)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Vehicle %1: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The autopilot reports an abnormal state. The Messages panel may show the reason.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As reported by the vehicle.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mode %1 → %2, not by this station</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The mode changed without a command from this station. The autopilot, the RC transmitter or another station changed it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Within %1 of the vehicle, and less than %2 above or below it or at an unknown altitude. The map shows it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All were refused. Counted since the link came up, as the Secure link panel does.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1. To pair with it, choose Pair or open Security → Keys and peers</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>skyseal::ui::AlertRow</name>
    <message>
        <source>Dismiss the alert</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Alarm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Warning</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Information</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 since %2: %3. %4</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dismiss: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dismiss (Esc)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dismiss until it recurs or gets worse (Esc)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pair…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pair with the agent</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>skyseal::ui::AlertStack</name>
    <message>
        <source>Alerts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>and %1 more</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>skyseal::ui::AllowPlain</name>
    <message>
        <source>Allow plain MAVLink for vehicle %1…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Plain MAVLink</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Allow plain MAVLink</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Accept plain MAVLink from vehicle %1?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It currently sends from %2. If you allow it, any sender of plain MAVLink that claims to be vehicle %1, from any address, is shown and commanded as that vehicle until this program ends or a sealed link to the vehicle is up. Anyone on the path can read and change the traffic.

If this should be the vehicle of %3, choose Cancel: its sealed link is broken or blocked.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>skyseal::ui::AltitudeBox</name>
    <message>
        <source>Take-off altitude</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Above home, %1 to %2%3</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>skyseal::ui::AltitudeDialog</name>
    <message>
        <source>%1 · vehicle %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Altitude above home</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Altitude above home</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not now: vehicle %1 is no longer selected</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>skyseal::ui::ChangeAltitudeDialog</name>
    <message>
        <source>Change altitude</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hold the button for half a second. The vehicle leaves its mission, and climbs or descends where it is.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>skyseal::ui::ChangePassphraseDialog</name>
    <message>
        <source>Change the passphrase</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Set a passphrase</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>New passphrase</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ne&amp;w passphrase</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Seal</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Working…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The passphrase encrypts the private key in its file. Without one, anyone who copies the file has the key. Skyseal asks for it at each start. A lost passphrase cannot be recovered.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Current passphrase</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;No passphrase: anyone who has the file has the key</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Current passphrase</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Repeat the &amp;new passphrase</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The two new passphrases differ.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Repeat the new passphrase</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>skyseal::ui::ChangedKeyWarning</name>
    <message>
        <source>Fingerprint of the new key</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>new</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The key of %1 has changed. Either a new key was generated there, or another device is impersonating %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Previous fingerprint</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>I have checked the new fingerprint on the device itself: &amp;replace the key</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>previous</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>skyseal::ui::ChartBuilder</name>
    <message>
        <source>no link</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>skyseal::ui::ChartExport</name>
    <message>
        <source>Skyseal diagnostics</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 cannot be written as a picture: %2</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>skyseal::ui::ChartMarks</name>
    <message>
        <source>link lost</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>new keys, epoch %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>link recovered</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 forged, replayed or plain, refused</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>skyseal::ui::ChartText</name>
    <message>
        <source>now</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>! %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>→ %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>skyseal::ui::ChartView</name>
    <message>
        <source>nothing measured yet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: mean %2 %3, from %4 to %5, %6 samples</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>skyseal::ui::ChecklistBox</name>
    <message>
        <source>Checklist</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose a file…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose the file of the checklist</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No checklist</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Use no checklist for this vehicle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Checklist of vehicle %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 · not yet: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No checklist without a vehicle.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Checklist %1 cannot be read</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Checklist %1: %2 of %3 done</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Text files (*.txt);;All files (*)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 · automatic: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No checklist for vehicle %1. A checklist is a text file; see Help → First steps.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>skyseal::ui::ClientModel</name>
    <message>
        <source>reads</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>reads and writes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>reads, writes %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Station</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rights</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Forwarded</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Refused</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 not permitted, %2 over the rate limit, %3 with a system ID that it may not use</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>skyseal::ui::CommandAge</name>
    <message>
        <source>%1 s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Commands are ignored: their delay is unknown, and the limit is %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The delay of commands is unknown</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Commands are ignored: they arrive up to %1 late, and the limit is %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Commands arrive up to %1 late</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Commands arrive within %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Commands ignored, delay unknown</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Delay of commands unknown</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Commands ignored, %1 late</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Commands %1 late</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The agent ignores commands that are older than %1, or that were overtaken by newer messages by %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The agent ignores commands that were overtaken by newer messages by %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>skyseal::ui::CommandPalette</name>
    <message>
        <source>Find a command</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Parts of a name, such as &quot;rtl&quot; or &quot;map source&quot;</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Command</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Commands</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No command matches</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>skyseal::ui::CommandPermits</name>
    <message>
        <source>no vehicle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it is not sealed, and plain MAVLink is not allowed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing can be sent: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a replay is shown</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A replay is shown</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A vehicle is connected: the demo would end its link</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A link is sealed: the demo would end it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the vehicle is disarmed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>its position is not known</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>this kind of vehicle does not fly</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>skyseal::ui::ConfirmCommand</name>
    <message>
        <source>Vehicle %1: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Confirm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>and %1 more</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not done on the checklist:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Arm with an incomplete checklist?</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>skyseal::ui::Coordinates</name>
    <message>
        <source>north</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>south</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 %2 %3 mE %4 mN</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>N</source>
        <comment>north</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>E</source>
        <comment>east</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>S</source>
        <comment>south</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>W</source>
        <comment>west</comment>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>skyseal::ui::CountersTable</name>
    <message>
        <source>good</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>late</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>lost</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>replayed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>forged</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>malformed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>plain</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>refused</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 replayed, %2 forged, %3 malformed, %4 plain</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Records with a valid authentication tag</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Valid, but received after a newer record</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sent, but not received</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Received before, refused</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Authentication tag invalid, refused</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not a valid record, refused</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Plain MAVLink that claims to come from a sealed peer, refused</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>from vehicle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>to vehicle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>stale</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Valid, but too late to command or to be shown</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>skyseal::ui::DiagnosticsPanel</name>
    <message>
        <source>Suites compared</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Comma-separated values (*.csv)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save the picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pictures (*.png *.svg)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 dashed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 dotted</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 + bars</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save the samples shown</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The bars show only “%1”.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The solid line is “%1”.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Charts of the diagnostics</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Connect to a vehicle to see the throughput, losses, latency and cost of its link.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cost of watching</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>CPU time of the link thread for the snapshots that this window shows and for these measurements, over the last second. The lines “link” and “process” contain it. A sweep measures without them, or states their share.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>CPU of the link thread: %1 % of a core, of it watching: %2 %</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>skyseal::ui::DiagnosticsTools</name>
    <message>
        <source>%1 s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 min</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Over time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Suites overlaid</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Table</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sweep</source>
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
        <source>Save</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save the measurements</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Picture as PNG or SVG…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Samples shown, as &amp;CSV…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>View of the measurements</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Over time; all suites on one axis, by time in use; means as numbers; or the results of a sweep</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Quantities shown</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Time range</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Freezes the charts, not the measurement (Space). Drag over a chart or turn the wheel to zoom; a double click, Home or Esc returns to live.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The view &quot;Sweep&quot; is shown</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shorter time range</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Longer time range</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose the view</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose the quantities</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>skyseal::ui::DisabledShortcuts</name>
    <message>
        <source>%1: %2</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>skyseal::ui::EdgeArrow</name>
    <message>
        <source>Vehicle %1 · %2</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>skyseal::ui::EmergencyStop</name>
    <message>
        <source>Unlock</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Emergency stop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unlock the emergency stop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stops the motors at once. A vehicle in the air falls. Hold for one second.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unlocks the emergency stop for %1 s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Locked: unlock it first</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Go to the lock of the emergency stop</source>
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
        <source>Add a link…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Waiting for the autopilot behind %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Replaying a log</source>
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
        <source>or let any autopilot send plain MAVLink here: it is shown, but not sealed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The agent %1 does not answer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Allow plain MAVLink</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Vehicle %1 is not sealed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Command to run beside the autopilot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keys and peers…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open keys and peers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It sends plain MAVLink from %1 and may be impersonating %2, which is a known peer but has not been heard yet. Its telemetry is not shown and nothing is sent to it until you allow plain MAVLink.

If it is the vehicle of %2, start the agent beside it instead, so that its link is sealed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It is reachable at %1, but it does not answer the handshake. Does it know this station&apos;s key?

Its list of peers must contain the key with the fingerprint
%2

It also does not answer if it permits none of the suites that this station offers.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>An unknown agent</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It announces itself from %1 with a key that is not in this station&apos;s list of peers. An announcement does not contain the fingerprint.

If the agent is yours, pair the two: choose Pair in Keys and peers here and, while the vehicle is disarmed, run beside the agent:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No vehicle in the log so far.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This station cannot use its key</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1

No link is sealed until this is resolved. Plain MAVLink is shown, but not sealed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The link to the agent is sealed; nothing has been received from its vehicle yet.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Start an agent, skyseal-air, beside an autopilot. If it has no key yet, the first line creates one; then pair the two in Security → Keys and peers:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Opening this station&apos;s key…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Its passphrase is being checked. Sealed links can start after that.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>skyseal::ui::EmptyText</name>
    <message>
        <source>Nothing matches the filter.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>skyseal::ui::FencePainter</name>
    <message>
        <source>Stay inside</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keep out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fence return</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rally %1</source>
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
    <name>skyseal::ui::FlightTarget</name>
    <message>
        <source>Target of vehicle %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Target</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>skyseal::ui::GatewaySection</name>
    <message>
        <source>Serve other stations</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Address for other stations</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stations connect to this TCP port</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stations send to this UDP port</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A station or a MAVSDK program listens on this UDP port</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rights of other stations</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Read only</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Read and write</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>State of the gateway</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Connected stations</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>off</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no station is connected</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>one station</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 stations</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, open to other computers; %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1; %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lets QGroundControl, Mission Planner, MAVProxy and MAVSDK programs use the sealed link through this window</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>One address, or several separated by spaces. Each may have options, e.g. udpout:127.0.0.1:14540,write=mission,param: write= narrows the rights chosen here. Other options: from=ADDRESS/PREFIX, sysid=ID and name=NAME</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Telemetry, parameters and missions can be read; commands, changes, files and logs are refused</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>They can command vehicles, like this station; while they are connected, their heartbeats keep the vehicle&apos;s GCS failsafe from triggering</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>May write</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What other stations may write</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What stations may write at the addresses beside, while &quot;Read and write&quot; is chosen</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>arm, fly and stop the vehicles</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>change missions, fences and rally points</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>change parameters</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>change files and logs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Other stations can do as this window: %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What other stations can do</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change the address for other stations</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change the rights of other stations</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;Read and write&quot; is not chosen</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Others may command</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Others may write</source>
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
        <source>&amp;Back</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>skyseal::ui::HelpPage</name>
    <message>
        <source>There is no help page &quot;%1&quot;.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Help page</source>
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
    <message>
        <source>Hold for %1 s to confirm; Escape aborts</source>
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
    <message>
        <source>roll</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>hdg</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>pitch</source>
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
    <message>
        <source>ID</source>
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
        <source>Message types</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fields of the selected message</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Filter message types</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Each type of message is listed here once it arrives.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Find a message type</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select a type of message to see its fields.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>skyseal::ui::KeysDialog</name>
    <message>
        <source>Keys and peers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Add…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add a peer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Pair…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pair with an agent</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Edit…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Edit the selected peer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Revoke…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Revoke the selected peer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Known peers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Its session ends at once, and it can no longer connect.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It can no longer connect.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Revoke %1?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Revoke</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No peers yet.

Add the public key of the agent beside your vehicle; skyseal-cli keys show prints it there. The agent also needs the key of this station.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No peers yet.

Pair with the agent of your vehicle, or add its public key, which skyseal-cli keys show prints there.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Vehicles %1 are armed. Revoke %2?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Vehicle %1 is armed. Revoke %2?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>They cannot be commanded from here then, and failsafes may trigger.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It cannot be commanded from here then, and failsafes may trigger.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>skyseal::ui::Language</name>
    <message>
        <source>en</source>
        <comment>code of this language, as in the name of this file</comment>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>skyseal::ui::LimitWatch</name>
    <message>
        <source>The low limit is %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The high limit is %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 low: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 high: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 Passed %2 times.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>skyseal::ui::LinkConditions</name>
    <message>
        <source>Clea&amp;n</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Packets lost</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> %</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Delay</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> ms</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Jitter: additional delay, up to this value</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Line rate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> baud</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>In both directions</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;loss</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;delay</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;jitter</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>r&amp;ate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Link between the agent and the station</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Link · %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Other:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Another link</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;57,600 baud radio</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;115,200 baud radio</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no limit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;921,600 baud line</source>
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
        <source>Browse…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Browse for the log file</source>
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
    <message>
        <source>Sealed, or plain MAVLink</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the published key</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the published nonce</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Browse for the key file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>P&amp;rotection</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>K&amp;ey file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Nonce</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Key of the stream</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the published counter, %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>C&amp;ounter</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>INSECURE: MAVSec 2019, ChaCha20, receive only</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>INSECURE: MAVSec 2019, AES-256-CTR, receive only</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>URL of the link</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1
INSECURE: anyone can read, change and forge this stream. Nothing is sent.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The nonce must have %1 hex digits</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The counter must be a number from 0 to 4294967295</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A link stays open until Skyseal closes. The one to open at start is in File → Settings.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Skyseal itself listens there, with %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Skyseal itself sends there, with %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Skyseal already listens there, with %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>skyseal::ui::LinkEnded</name>
    <message>
        <source>the agent</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Revoked · %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Session lost · %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Session ended · %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The session with %1 ended %2 ago: %3.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>New session · %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The sweep changes the protection of the link, which needs a new handshake.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 was silent for too long; the session ended %2 ago.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Waiting: the session is re-established automatically when the agent is heard again. The last received values are shown. Plain MAVLink with the vehicle&apos;s system ID is still refused.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is no longer a known peer: its session ended %2 ago and cannot be re-established. The last received values are shown. Pair it again to continue.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>skyseal::ui::LinkEventText</name>
    <message>
        <source>one unreadable line about ciphers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 unreadable lines about ciphers</source>
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
    <message>
        <source>%1 · MAVSec 2019, INSECURE, receive only</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Local</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remote</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>skyseal::ui::LinkPopover</name>
    <message>
        <source>Secure link</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open secure link</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>skyseal::ui::LinksPanel</name>
    <message>
        <source>Add…</source>
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
        <source>Remove the selected link</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Links</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove the link</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Vehicle %1 on this link is armed. Remove the link?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Vehicles %1 on this link are armed. Remove the link?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Without this link, its vehicles cannot be commanded from here, and failsafes may trigger.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No links: add one to hear a vehicle.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select a link first</source>
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
        <source>switching…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Switching to %1</source>
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
        <source>epoch %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 does not answer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No answer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Revoked</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No session</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>changing keys…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not sealed · vehicle %1 needs approval</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not sealed · needs approval</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Anyone on the path can read and change the traffic. Start skyseal-air beside the vehicle to seal the link.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No sealed links: this station cannot use its key</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not sealed · sweep running</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The sweep is measuring plain MAVLink, with your consent: anyone on the path can read and change the traffic. The sweep seals the link again afterwards.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>New keys are being negotiated</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No sealed links yet: this station&apos;s key is being opened</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Under attack: %1 forged or replayed records since the link came up. All of them were refused.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Under attack: %1 spoofed frames of this vehicle since the link came up. All of them were refused.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Vehicle %1 at %2 may be impersonating %3, which has not been heard yet. Its telemetry is not shown and nothing is sent to it until you allow it: Security → Allow plain MAVLink.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>skyseal::ui::LogsPanel</name>
    <message>
        <source>Record received and sent frames</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Replay a log…</source>
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
        <source>End the demo before you replay a log</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Skyseal: demo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>End the demo before you add a link</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Menus</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Flight actions</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Place on the map</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Alerts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Replay and demo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Problem</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Last run</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>skyseal::ui::MapAlerts</name>
    <message>
        <source>Go to the a&amp;lerts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No alerts</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>skyseal::ui::MapMenu</name>
    <message>
        <source>Change &amp;altitude…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Measure from here</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Copy coordinates</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The mode changes from %1 to %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Go here…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Set &amp;home here…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the altitude of home is not known</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, %2 from the vehicle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add &amp;to the mission…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the mission has not been read: Plan, Read from the vehicle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Point camera here…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Point the camera at this location?
%1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The target is at the altitude of home. A copter whose camera cannot pan yaws instead.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Stop pointing camera…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stop pointing the camera at a location?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Go to this location?
%1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Go to this location at %1 above home?
%2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Set home to this location?
%1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>RTL will fly there. The altitude of home stays the same; the ground elevation there is not known.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pa&amp;use…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stop and hold the present position?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Target</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the mission is outdated (%1): Plan, Read again</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>skyseal::ui::MapPainter</name>
    <message>
        <source>N</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Map: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>altitude</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>speed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>link quality</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>skyseal::ui::MapRotation</name>
    <message>
        <source>&amp;Rotate the map with the vehicle</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>skyseal::ui::MapSourceDialog</name>
    <message>
        <source>Map source</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A tile &amp;server</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A tile server</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Address of the tiles</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Attribution</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Address</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A&amp;ttribution</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Browse…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No file is chosen</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;No imagery: lines of latitude and longitude</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No imagery</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>© map data; required by most servers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Maximum zoom level</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ma&amp;ximum zoom level</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The server learns which areas you view and when, and thus where you fly, and the address of this computer. With http://, anyone on the path learns it too. Nothing is requested until you press OK; received tiles are kept on this computer.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tiles will be requested from %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A &amp;file on this computer (MBTiles or GeoPackage)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A file of map tiles</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>File of map tiles</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Browse for a file of map tiles</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Map tiles (*.mbtiles *.gpkg);;All files (*)</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>skyseal::ui::MapView</name>
    <message>
        <source>Map</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1. Enter sets a point at the centre of the map, Backspace removes the last, Escape ends</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Arrow keys move the map, plus and minus zoom, Home follows the vehicle, Menu opens the commands for the centre</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The vehicle is beyond the map, %1 from its centre.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A click centres the map on it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A click or %1 centres the map on it.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>skyseal::ui::MbtilesWriter</name>
    <message>
        <source>%1 cannot be written: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 cannot be written</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 cannot be replaced</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>skyseal::ui::MeasurePainter</name>
    <message>
        <source>Click or Enter sets a point, Backspace removes the last, Esc ends</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>skyseal::ui::MeasureTool</name>
    <message>
        <source>M&amp;easure on the map</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Measure: set the first point</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Measure: set the next point</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 in one leg</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 in %2 legs</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>skyseal::ui::MenuBarFocus</name>
    <message>
        <source>Open the first menu</source>
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
    <message>
        <source>Replay: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Filter messages</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Minimum severity shown</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1. To accept it, choose Security → Allow plain MAVLink</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1. To pair with it, open Security → Keys and peers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Messages of vehicles and of the station are listed here.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Find a message</source>
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
    <message>
        <source>%1 MSL</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 above ground</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>skyseal::ui::MissionPainter</name>
    <message>
        <source>outdated</source>
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
        <source>Send a file…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save as…</source>
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
        <source>Send a mission</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save the mission</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sending %1 items…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not sent: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>another vehicle is selected</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sending one item…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The vehicle has no mission. Send a file to write one.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Send a mission to vehicle %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The mission, and the fence and rally points if the vehicle has them</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There are no items to save</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 cannot be read: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The vehicle is armed. Replace its mission?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Vehicle %1 is armed. Replace its mission?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>While it flies its mission, it turns to the new one at once.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Replace the mission</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No vehicle. Its mission is listed here once it has been read.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The mission has not been read yet: choose Read from the vehicle.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Read again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Replace the mission of another station?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Replace the mission of another station on vehicle %1?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The mission of the vehicle was %1. Read it to see what it is.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The vehicle is armed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mission outdated: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fence outdated: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rally points outdated: %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>skyseal::ui::ModeChooser</name>
    <message>
        <source>Set mode</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Flight mode to set</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The modes of this vehicle are not known</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>skyseal::ui::OneWay</name>
    <message>
        <source>Replay</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The values come from a recorded log. They are not live, and nothing can be sent.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it is a replay</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not sealed, receive only</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This stream is protected as in the published MAVSec code, which is insecure: anyone on the path can change it. Nothing is sent.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>its link is receive-only</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>skyseal::ui::OverlayColor</name>
    <message>
        <source>Blue</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Orange</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Red</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Green</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Purple</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Grey</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>skyseal::ui::OverlayDialog</name>
    <message>
        <source>Overlays</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>State</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Colour of the selected file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Remove</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove the selected file from the map</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Read a&amp;gain</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Read the selected file again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Orange</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Add…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add KML or GeoJSON files</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Close</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Colour</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add overlays</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>KML and GeoJSON (*.kml *.geojson *.json);;All files (*)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There are %1 files, and no more can be added. Remove one first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No overlays. Add… draws the points, lines and areas of KML and GeoJSON files over the map. They are for display only: the vehicle does not know about them.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>skyseal::ui::OverlayModel</name>
    <message>
        <source>Reading…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not shown: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Changed since it was added</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>File</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Colour</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shapes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>State</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shown as last read: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 not drawn: no position, or an unsupported kind</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>skyseal::ui::OwnKeyBox</name>
    <message>
        <source>This station</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Own fingerprint</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Own public key</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The public key as a QR code</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Copy the public key</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>E&amp;xport…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export the public key to a file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>copied</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>sealed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No key is in use: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The other end needs this public key. It is not secret, but compare its fingerprint there with this one:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, sealed with a passphrase</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change the pa&amp;ssphrase…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Set a pa&amp;ssphrase…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export the public key</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Public keys (*.pub);;All files (*)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>written to %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no longer sealed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, not sealed: anyone who copies the file has the key</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This station has no key: it can use only plain MAVLink. Create one with
skyseal-cli keys new --out FILE
and start with --identity FILE.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>skyseal::ui::PairingDialog</name>
    <message>
        <source>Pair with an agent</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Passphrase of this pairing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>none; or the same as at the agent</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Passphrase</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>They &amp;differ</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Try a&amp;gain</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Close</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 s left</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Start pairing at the agent, while the vehicle is disarmed:

    skyseal-air --pair --identity FILE

Waiting for the agent…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Confirmed here. The pairing must now be confirmed at the agent as well.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Only an agent with the same passphrase is shown: skyseal-air --pair --pair-passphrase.
Then there is no code to compare. It is valid for this pairing only.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Fingerprints</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The complete fingerprints of both keys. They need not be compared: the code covers them.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The agent&apos;s side has confirmed. Confirm here as well.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The agent&apos;s side has confirmed. Does the agent show this code?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Confirm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The codes are the &amp;same</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Refuse</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>An agent that knows the passphrase has answered. Is it the right one?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>An agent has answered. Does it show this code?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1. The link is sealed as soon as both ends are connected.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the codes differ. If both were codes of this pairing, an attacker is between this station and the agent (man in the middle).</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>skyseal::ui::PairingQuestionForm</name>
    <message>
        <source>Code</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fingerprint of this station</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fingerprint of the agent</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Vehicle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This station</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The agent</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>system ID %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>skyseal::ui::ParameterModel</name>
    <message>
        <source>not written: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>writing %1…</source>
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
    <message>
        <source>&quot;%1&quot; is not a number</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not written: not a finite number</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not written: %1 is not between %2 and %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not written: %1 is not a whole number</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Value · vehicle %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>written, read back as %1</source>
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
    <message>
        <source>Result of the last fetch</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Requested, but the vehicle has been silent for %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fetched</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not fetched: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Requested…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Filter parameters</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Parameters are listed here once they are fetched.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Find a parameter</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>waits for your confirmation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Write a parameter</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The vehicle is armed. Change %1?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Vehicle %1 is armed. Change %2?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: from %2 to %3. The change takes effect at once.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Write %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not written: not confirmed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fetched; %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>skyseal::ui::PassphraseDialog</name>
    <message>
        <source>Passphrase</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Passphrase of this station&apos;s key:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wrong passphrase.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Continue without sealed links</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The remembered passphrase does not open this key.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>skyseal::ui::PeerDialog</name>
    <message>
        <source>Peer %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add a peer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Public key</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From a &amp;file…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fingerprint</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>any; or e.g. 1,2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Public key</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Systems</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Public key of a peer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Public keys (*.pub);;All files (*)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Replace the key</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Paste the public key that skyseal-cli keys show prints at the other end.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Enter a name.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Confirm that the key is replaced, or choose another name.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>MAVLink system IDs</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>skyseal::ui::PeerModel</name>
    <message>
        <source>%1
with a pre-shared key</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>any</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>connected</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Systems</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Last seen</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fingerprint</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>skyseal::ui::PlanReader</name>
    <message>
        <source>Reading the fence…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reading the rally points…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reading the mission…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>fence: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>rally points: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>mission items: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Read: %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>skyseal::ui::PreArmButton</name>
    <message>
        <source>Opens the list of failures and the checklist.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 open on the checklist. Opens the checklist and the list of failures.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>skyseal::ui::PreArmDialog</name>
    <message>
        <source>Check now</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Run the pre-arm checks now</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Close</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pre-arm checks</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pre-arm checks · vehicle %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The vehicle is armed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pre-arm failures, with what to do</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This autopilot runs its checks automatically</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Makes the vehicle run its checks now and report failures</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>skyseal::ui::PreArmText</name>
    <message>
        <source>Press the vehicle&apos;s safety switch until its light stays on.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Calibrate the radio: move each stick and switch to both ends.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Switch on the transmitter and check its receiver.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Calibrate the compass away from metal.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move the vehicle away from metal, cables and magnets.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Place the vehicle inside its fence, or correct the fence.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wait for more satellites, under an open sky.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wait for a 3D fix under an open sky; check the GPS cable.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wait for the GPS and the EKF, or set a mode that needs no position.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keep the vehicle still until its estimate has settled.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shield the barometer from wind and light; restart the vehicle.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Check the power supply of the autopilot.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Charge or change the battery; check BATT_ARM_VOLT.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Send a mission that suits this vehicle.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wait until the terrain data have been loaded.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Place the vehicle on level ground.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Check the motor and frame parameters, and the ESCs.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Check the power and the cables of the ESCs.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pre-arm: unknown</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pre-arm: ok</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pre-arm: armed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pre-arm: not ok</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No vehicle is connected.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The vehicle is silent, so the state of its checks is not known.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The vehicle is armed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Set a mode that allows arming, such as LOITER or GUIDED.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Set a mode that allows arming, such as Hold or Position.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lower the throttle stick fully.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move the vehicle away from metal, cables and magnets; calibrate the compass if the failure persists.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wait for the GPS and the EKF, or disable the fence.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keep the vehicle still; restart it if the failure persists.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keep the vehicle still; calibrate the accelerometers if the failure persists.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Check that the SD card is inserted and has free space.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Restart the autopilot, and do not fly until the cause is known.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wait until the vehicle has detected the landing.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Correct the parameter named in the message.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pre-arm: 1 failure</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pre-arm: %1 failures</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The vehicle does not report whether its checks pass, and has not reported a failure.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The vehicle reports that all checks pass.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The vehicle reports that a check fails, but not which one. It repeats its failures every 30 s.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The vehicle will not arm. A failure is removed when it has not been repeated for 40 s.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Look up the message in the autopilot&apos;s documentation.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>skyseal::ui::Preflight</name>
    <message>
        <source>the checklist, which cannot be read</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 cannot be read: %2</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>skyseal::ui::ProblemBanner</name>
    <message>
        <source>Resolve the problem</source>
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
    <name>skyseal::ui::ProblemReports</name>
    <message>
        <source>%1 is in use by another program: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Listen on %1 instead</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>skyseal::ui::ProfilePanel</name>
    <message>
        <source>No vehicle. The altitudes of its mission are drawn here once it has been read.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The vehicle has no mission. Send a file in the panel Mission to write one.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The mission has not been read yet: choose Read from the vehicle in the panel Mission.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>skyseal::ui::ProfileView</name>
    <message>
        <source>Altitude profile of the mission</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 · highest %2 above home</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>skyseal::ui::QtTimeSeriesChart</name>
    <message>
        <source>%1, %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>skyseal::ui::Quantities</name>
    <message>
        <source>Decryption rate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>frames/s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Bytes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>kB/s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>received</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wire overhead</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Packet loss, channel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Packet loss, MAVLink</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Latency</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>ms</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>TIMESYNC</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>channel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>% of a core</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>process</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>link</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>suite</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>µs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>p50</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>p99</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>next p50</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Memory</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>MB resident</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Memory of a session</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>kB</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>W</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not readable here</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Overview</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rates</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Link</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cost</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>CPU</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Opening a record</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sealing a record</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>MAVLink frames that were decrypted and accepted, over the last second.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Bytes of the frames that were decrypted, and of the received datagrams (without UDP and IP headers).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>decrypted</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Bytes of the channel&apos;s datagrams beyond the frames in them: headers, tags, handshakes and reports. At a few frames a second it is large, because the reports stay the same. 0 on a plain link.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>from vehicle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>to vehicle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Records that were lost, by their counters, over the last second; the agent reports its direction once a second. On a plain link: the loss of MAVLink frames.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Frames that were lost, by the sequence numbers of each sender, over the last second; frames to the vehicle are counted by its agent and reported once a second. Loss between autopilot and agent counts here and not in the channel.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Round trip: to the autopilot by TIMESYNC, smoothed, and to the agent by the channel&apos;s reports.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Resident memory of the whole process. It does not depend on the suite.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Heap of one end&apos;s session under the suite in use, with its keyed ciphers. Measured once for each suite, with a session inside this program.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Power of the machine</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From the datagram to the decrypted frames: look-up, replay window, tag, decryption. The first record after the thread slept finds cold caches and takes several microseconds with any suite; at telemetry rates that is nearly every record. “next” is for the records that follow in the same wake-up, which show more of the cipher itself.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From the frames to the record that is sent, with the cold caches of a thread that was asleep.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From the kernel&apos;s energy counters or the power supply&apos;s sensor, over the last second: the whole machine, not this program alone (%1).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>CPU time over the last second: of the process with its window, of the link thread, and of the suite in seal and open (sum of the elapsed times of the calls). The cost of watching (the snapshots for this window, and these measurements) is part of “link” and stated below the charts; drawing the charts is part of “process” only.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>skyseal::ui::RecordedLink</name>
    <message>
        <source>Replay · protection not recorded</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Replay</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Replay · was not sealed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Was not sealed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Was sealed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How the link was protected is not noted beside the recording.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The link was plain MAVLink, not sealed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The link was sealed, with one of %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The link was sealed by %1, with %2.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>skyseal::ui::RecordingModel</name>
    <message>
        <source>reading…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cannot be read: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no vehicle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Date</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Vehicle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Length</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Size</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>File</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>and others</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No cipher suite is noted beside this recording</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ciphers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>plain MAVLink</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>skyseal::ui::RecordingsDialog</name>
    <message>
        <source>Recordings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Replay</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Replay the selected recording</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Replay a log</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Other file…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Replay another file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Close</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 of %2 read in %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 recordings in %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Telemetry logs (*.tlog);;All files (*)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Searching %1…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No recordings in %1. Enable recording in File → Settings, or choose &quot;Other file&quot; to replay another log.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>One recording in %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>skyseal::ui::RegionDialog</name>
    <message>
        <source>Choose a tile server as the map source first</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fetch the area in view</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>area.mbtiles</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>File</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Browse…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Browse for the file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Progress</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Fetch</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fetch</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Close</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>to</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>F&amp;ile</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No file is chosen</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%L1 tiles</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fetch the area into</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>MBTiles (*.mbtiles)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%L1 of %L2 tiles, %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> of about %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>; %L1 failed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not fetched: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cancelled; no file was written</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: %2, without %L3 tiles that failed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From zoom level</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>To zoom level</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Use as map source</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Use the file as the map source</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Zoom &amp;levels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tiles are fetched two at a time. Check that the server permits it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The first zoom level is greater than the last</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%L1 tiles: at most %L2 can be fetched at a time. Zoom in, or choose fewer zoom levels</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>skyseal::ui::RegionFetch</name>
    <message>
        <source>the server has no tiles there</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>skyseal::ui::ReplayBar</name>
    <message>
        <source>Speed of the replay</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Position and length of the replay</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pause</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Play</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pause the replay</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Play the replay</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 (Space, while the focus is in this bar)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recorded %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Beside the recording: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Back 10 s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Forward 10 s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Slower</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Faster</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Previous event</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Next event</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>skyseal::ui::ReplayTimeline</name>
    <message>
        <source>Position of the replay</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The recording is being read</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 nothing recorded for %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> (vehicle %1)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 armed until %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 mode %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>and %1 more</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 switched to %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 sealed with %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> (link to %1)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 vehicle %2 in plain MAVLink</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>skyseal::ui::RescueBar</name>
    <message>
        <source>Replay the recording of the last run</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open the links of the last run again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dismiss</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The last run ended unexpectedly at about %1. Its recording was kept.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Re&amp;play its recording</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Open its links</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dis&amp;miss</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>skyseal::ui::RightsMenu</name>
    <message>
        <source>&amp;Everything</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Also messages of no class, and of other dialects</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Missions, fences and rally points</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not the choice of the item to fly next</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Parameters</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Commands and flight modes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>They command vehicles like this station</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Files and logs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Sticks and manual control</source>
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
        <source>Not sealed</source>
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
    <message>
        <source>Keys and peers…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open keys and peers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 does not answer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Under attack, all refused</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sealed, changing keys…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not sealed, needs approval</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sealed, no data received</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sealed, commands are ignored</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sealed, commands are late</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1. %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No sealed links</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This station cannot use its key: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The session starts automatically when a known agent announces itself.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not sealed, sweep running</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It continues automatically when the agent is heard again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sealed, disk error at the agent</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sealed, disk error on this computer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Opening the key…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The passphrase of this station&apos;s key is being checked. Sealed links can start after that.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 forged, %2 replayed in this session</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 spoofed frames in this session</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1. If it is yours, pair the two.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Anyone on the path can read and change the traffic. This station cannot seal the link, because it cannot use its key: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1.</source>
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
        <source>Link to open at start</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Record received and sent frames (.tlog)</source>
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
        <source>Browse…</source>
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
        <source>Allow &amp;insecure research suites (%1)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Allow insecure research suites</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Weakest suite</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Any sealed suite</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 or stronger</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Only %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Weakest suite</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>desktop default</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Plain MAVLink is then neither shown nor answered. Takes effect at the next start.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Research suites (%1) are broken: anyone who records the link may be able to read it. They are provided for comparison, are never chosen automatically, and work only when the vehicle&apos;s agent allows them as well. While one is in use, the link is not confidential.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Coordinates</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>decimal degrees</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>degrees, minutes, seconds</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>UTM (metres in a zone)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>MGRS (grid reference)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Coordi&amp;nates</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Speak &amp;alerts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Speak alerts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This build of Skyseal has no speech: it lacks speech-dispatcher.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Language</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>same as the desktop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lan&amp;guage</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The language takes effect at the next start.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>MAVLink system ID</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>MAVLink component ID</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>IDs, link and folder take effect at the next start.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>aviation (ft, kt, NM)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Touch-sized controls</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Touch-sized controls</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Buttons, menus and lists are large enough for fingers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the default folder</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>System ID %1 is a vehicle&apos;s: choose another one.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Why the system ID cannot be chosen</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>skyseal::ui::ShortcutDialog</name>
    <message>
        <source>Find an action</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Actions and their shortcuts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Result</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shortcut of the selected action</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Re&amp;place</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take the shortcut from the other action</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;None</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove the shortcut of the selected action</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Default</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Default shortcut for the selected action</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keyboard shortcuts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Parts of a name, a menu or keys, such as &quot;zoom&quot; or &quot;ctrl+k&quot;</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reset &amp;all…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reset all shortcuts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Close</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shortcut of &quot;%1&quot;: press the keys, or Backspace for none</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No action has these words.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is that of &quot;%2&quot;; it would lose it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;%1&quot; has no shortcut now.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is now that of &quot;%2&quot;.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Give every action its default shortcut?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reset all</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Every action has its default shortcut.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>skyseal::ui::ShortcutModel</name>
    <message>
        <source>none</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Action</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shortcut</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Default</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Menu or panel</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>skyseal::ui::ShortcutRules</name>
    <message>
        <source>it must be pressed at once.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>this key is not known.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Space and Enter press buttons.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tab moves between controls.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Esc closes and cancels.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the arrows move in the map, in lists and in texts.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Alt with a letter opens menus and presses buttons.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it opens the menu at the pointer.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it edits texts.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>without Ctrl or Alt, texts, lists and the map need it. F1 to F35 are free.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 cannot be a shortcut: %2</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>skyseal::ui::SourceBar</name>
    <message>
        <source>REPLAY: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>End the demo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Back to live</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>REPLAY: %1 · %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>REPLAY: %1 · finished</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Live: vehicle %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>ARMED</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>disarmed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>lost for %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Live: no vehicle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>DEMO: a simulated copter takes off and flies by itself until you command it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All data are simulated. Your first command ends the flight of the demo. End the demo, here or in the menu Tools, returns to your links.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>skyseal::ui::SourceModel</name>
    <message>
        <source>Value</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Kind</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>skyseal::ui::StateText</name>
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
        <source>Battery %1 (avionics)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Battery %1 (payload)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Battery %1</source>
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
        <source>Arm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Disarm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Land</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mode %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mission item %1</source>
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
    <message>
        <source>Emergency stop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Go here</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Set home here</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pre-arm checks</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>RTL</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Point camera here</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stop pointing camera</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Start mission</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take off to %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change altitude to %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Speed %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pause</source>
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
        <source>%1 of the frames arrived
%2 latency
%3 since the newest message
%4 frames/s, %5 lost</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Other stations</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shared</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1
A click opens the links.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lowest in the last minute: %1 %</source>
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
        <source>research suites are off</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not allowed here</source>
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
    <message>
        <source>weaker than allowed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>changing…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change keys &amp;now</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a sweep is running</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not offered by the agent</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>New keys for the suite in use, without interrupting the link</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sealed with %1: %2, chosen last, is weaker</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sealed with %1: %2, chosen last, is not permitted now</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a replay is shown</source>
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
    <name>skyseal::ui::SuiteTableModel</name>
    <message>
        <source>%1
%2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>from %1 to %2, %3 samples</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Suite</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>In use</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>skyseal::ui::SweepDialog</name>
    <message>
        <source>Run a sweep</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Run</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Warning</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Measure on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The connected link</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The &amp;connected link, to %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The &amp;connected link · %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sealed: whole frames in records</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sealed framing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Inline framing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Natural load</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Saturated load</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Length of each run</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Runs for each suite</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Seed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The same seed gives the same order of runs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>One suite twice, to see the noise (A/A)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Measure the noise</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Each run</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Re&amp;peats</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Seed of the order</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Inline: payloads sealed in place</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Saturated load: as much as the link carries</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>One run, %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 runs, %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Summary</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The suites change on the live link. At the end the current suite is restored.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Suites, framing and load</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Natural load: the streams that a station requests</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Inline is the framing that the MAVSec paper measured: payloads are encrypted in place, headers stay clear. It needs a cipher with an HMAC, and the agent must allow it (skyseal-air --allow-inline).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Duration</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose a link, a suite, a framing that the suite supports, and a load.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>You consent to plain MAVLink: during these runs telemetry and commands are sent in clear, and anyone can command the vehicle.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Link to the autopilot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Suites and impairments change on the sweep&apos;s own link; the autopilot is not commanded. Flights: skyseal-cli sweep --vehicle URL --fly SCRIPT.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A separate simulated &amp;vehicle, on this machine</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A separate simulated vehicle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A running &amp;autopilot, with a separate agent</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A running autopilot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The noise can be measured only with 2 or more repeats.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The link to the autopilot must be a URL, such as tcp:127.0.0.1:5760.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>skyseal::ui::SweepPage</name>
    <message>
        <source>The sweep</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Run a sweep…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Run a sweep</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cancel the sweep</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save the sweep&apos;s files</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Load and link</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Measurement in the bars</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>One run in %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 runs in %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Incomplete, %1 of %2 runs: %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>; %1 failed: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>; %1 not valid: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Writing the files…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not saved: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Saved in %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Saved in %1; %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not measured yet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not measured</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Starting…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Run %1 of %2, %3 left: %4, %5</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Runs completed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No sweep yet. A sweep measures the cost of each suite in turn.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stopping: restoring the suite of the link…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Bars of the sweep</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ratios or means</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Results of the sweep</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Means</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Warnings and the measurement&apos;s own share</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Warnings of the sweep</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not compared</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>skyseal::ui::SweepPresenter</name>
    <message>
        <source>Choose the folder in which the sweep&apos;s folder is created</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cipher sweep</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The vehicle is armed. Measure on its link?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The sweep switches the suite of the link by which the vehicle is commanded before each run.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Measure</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>skyseal::ui::SweepTableModel</name>
    <message>
        <source>%1 (A/A)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>from %1 to %2 in %3 runs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Suite</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Framing</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>skyseal::ui::TakeOffDialog</name>
    <message>
        <source>Take off</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hold the button for half a second. The propellers speed up and the vehicle climbs.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hold the button for half a second. The vehicle is armed, and takes off at once.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Arm and take off</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>skyseal::ui::TileFile</name>
    <message>
        <source>%1 cannot be opened: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 cannot be shown: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>out of memory</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it is neither an MBTiles nor a GeoPackage file (%1)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it has vector tiles; only images (PNG, JPEG, WebP) can be shown</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it has no map tiles (%1)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it has no map tiles in Web Mercator (EPSG:3857)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>its tiles are not those of the usual grid, %1 pixels wide</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a tile is larger than %1 kB</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the file takes too long to search</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>skyseal::ui::TileImage</name>
    <message>
        <source>a tile is larger than %1 kB</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a tile is neither PNG, JPEG nor WebP</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a tile cannot be read as %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a tile has %1×%2 pixels, more than %3</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>skyseal::ui::TileTemplate</name>
    <message>
        <source>The address must begin with https:// or http:// and name a server</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The address must contain {z}, {x} and {y}, where the server expects zoom level, column and row</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Only the placeholders {z}, {x} and {y} (or {-y}) are supported</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The server name must not contain placeholders</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>openstreetmap.org does not permit fetching areas for later use; choose a server that does</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>skyseal::ui::TileWorker</name>
    <message>
        <source>the source of the map was changed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a tile is larger than %1 kB</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the server does not answer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the map has no tile server</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no tile could be downloaded: %1</source>
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
    <name>skyseal::ui::ValueCell</name>
    <message>
        <source>▼ low</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>▲ high</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>skyseal::ui::ValueChoice</name>
    <message>
        <source>&quot;%1&quot; is not a number</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>there is no value &quot;%1&quot;</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;decimals&quot; is not a number from 0 to %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;low&quot; is not below &quot;high&quot;</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;line&quot; is neither true nor false</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not JSON: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not a list</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>more than %1 values</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>value %1: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;caption&quot; is not text of at most %1 characters</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;unit&quot; is not text of at most %1 characters</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>skyseal::ui::ValueReading</name>
    <message>
        <source>bad</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>good</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>yes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>since first heard</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The vehicle was already flying when this station first heard it. The time counts from then: the flight itself is longer.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>skyseal::ui::ValueSource</name>
    <message>
        <source>derived by the station: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 elements</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>system</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Flight mode</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>mode</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Armed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>armed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Roll, right wing down positive</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>roll</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pitch, nose up positive</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>pitch</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Yaw</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>yaw</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Latitude</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>lat</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Longitude</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>lon</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Altitude above home</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>alt</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ground speed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>speed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Battery voltage</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>battery</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Battery, remaining</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>GPS fix</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>GPS</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Satellites in use</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>satellites</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>EKF, the estimate of attitude and position</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>EKF</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Time since the last heartbeat</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>heartbeat</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Altitude above mean sea level</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>alt MSL</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Climb rate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>climb</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Heading</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>hdg</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Airspeed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>airspeed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Throttle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>throttle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Battery current</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>current</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>HDOP of the GPS</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>HDOP</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Distance to home</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>home</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Flight time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Current mission item</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>item</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>mode no.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>State of the system (MAV_STATE)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>state</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>CPU load of the autopilot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>CPU</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>vibration</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Round-trip time of the link</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>latency</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Time since the last message</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>age</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Link lost</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>lost</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Firmware</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>firmware</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>MAVLink system ID</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Flight mode number</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Vibration, worst axis</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Signal of the radio, in its units</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>signal</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Signal of the radio at the vehicle, in its units</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>signal there</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Noise of the radio, in its units</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>noise</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Noise of the radio at the vehicle, in its units</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>noise there</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Free part of the radio&apos;s transmit buffer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>buffer</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>skyseal::ui::ValuesEditor</name>
    <message>
        <source>Edit values</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Chosen values</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Values, in the order of the grid</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Remove</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Up</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Down</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The selected value</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Source</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Caption</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Element of the array</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Decimals</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>automatic</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Low limit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>High limit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>L&amp;ine of the last minute</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Line of the last minute</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Caption</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Element</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Deci&amp;mals</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Low below</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;High above</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no limit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All values</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Find a value</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Parts of a name, such as &quot;roll&quot; or &quot;battery volt&quot;</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Find</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Add</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Use for the &amp;selected value</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A&amp;pply</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>OK</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, shown in %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing is selected. Find a value below and add it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>▲ &quot;%1&quot; is not a number</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>▲ The low limit must be below the high one</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No more than %1 values</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Adds the value that is selected below</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Problem</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Matching values</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Defaul&amp;ts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Restores the default values; takes effect with Apply or OK</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>U&amp;nit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>none</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The unit of the message&apos;s definition, in the chosen system of units</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No value has these words in its name.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>skyseal::ui::ValuesGrid</name>
    <message>
        <source>Edit values…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Problem with the stored values</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No values are chosen.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No values</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Age of the values</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Edit values</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Last heard %1 ago</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose the values shown here, their limits and their lines</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The stored values cannot be read (%1). These are the defaults.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>skyseal::ui::VehicleCommands</name>
    <message>
        <source>%1: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: not sent: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: not sent: vehicle %2 is no longer selected</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: requested…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add to the mission</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the mission is not known</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the mission is outdated (%1): read it again</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>skyseal::ui::VehicleListModel</name>
    <message>
        <source>Vehicle %1, selected</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Vehicle %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Vehicle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Kind</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mode</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Armed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Battery</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Link</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Last frame</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lock</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Alerts</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>skyseal::ui::VehicleListRow</name>
    <message>
        <source>Vehicle %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Vehicle %1, agent %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 · low</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 V</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>lost</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 · poor</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Share of the frames that arrived within the last second</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&lt; 1 s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Since the newest frame</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sealed · %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Under attack · %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No alerts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>severe</source>
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
        <source>Armed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Disarmed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No frames received</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>skyseal::ui::VehicleMarker</name>
    <message>
        <source>Vehicle %1 · %2 s ago</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Vehicle %1 · not sealed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Vehicle %1 · sealed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Vehicle %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>skyseal::ui::VehicleName</name>
    <message>
        <source>%1, vehicle %2</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>skyseal::ui::VehiclesPanel</name>
    <message>
        <source>Vehicles</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Disarmed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 · low</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 · poor</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Last frame</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Number or words, such as &quot;rover armed&quot;</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Vehicles shown</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Connect…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add a link</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 of %2 · order kept under the pointer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No vehicle. A vehicle appears here as soon as it is heard.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No vehicle matches &quot;%1&quot;.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Filter vehicles</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Find a vehicle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove from the list</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove the lost vehicle from the list</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A replay is shown</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It appears again as soon as it is heard</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select a vehicle whose link is lost</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>skyseal::ui::WindowDialogs</name>
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
    <name>skyseal::ui::WindowDocks</name>
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
        <source>Altitude profile</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Vehicles</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Close the panel that has the focus</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Float or dock the panel that has the focus</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Panels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No panel has the focus</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>skyseal::ui::WindowMenus</name>
    <message>
        <source>&amp;File</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Settings…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Replay a log…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Link</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Connect…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change the mode to %1?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Vehicle %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Vehicle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Arm…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Arm the motors? The propellers will turn.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Disarm…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Disarm the motors?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Take off…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Land…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Land here?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Return to launch (RTL)…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Return to launch and land there?</source>
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
        <source>S&amp;how</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No vehicle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Vehicle %1 at %2…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cipher suite</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Allow &amp;plain MAVLink</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No vehicle is waiting for approval</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Keys and peers…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Security</source>
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
        <source>&amp;Reset the layout</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>F&amp;ull screen</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>V&amp;iew</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Run a s&amp;weep…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Start the &amp;demo</source>
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
        <source>&amp;First steps</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Sealing a link</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Diagnostics</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;About Skyseal</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;End the demo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Map source…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fetch the &amp;area in view…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The &amp;map</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Change altitude…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Find a command…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Edit values…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Values</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>O&amp;verlays…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Keyboard shortcuts…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Start mission…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The demo is running</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No demo is running</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Fly workspace</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Plan workspace</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ve&amp;hicle workspace</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Lab workspace</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Cipher suite</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Link &amp;quality</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Altitude</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Speed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Track colours</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Pause…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stop and hold the present position?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Arm the motors? In its present mode the vehicle takes off at once.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Arm the motors and fly the mission? The propellers will turn.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>skyseal::ui::WorkspaceTabs</name>
    <message>
        <source>Workspaces</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Workspace %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Workspace %1 (%2)</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>skyseal::ui::Workspaces</name>
    <message>
        <source>Fly</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Plan</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Vehicle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lab</source>
        <translation type="unfinished"></translation>
    </message>
</context>
</TS>
