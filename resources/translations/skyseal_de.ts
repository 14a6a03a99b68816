<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de_DE">
<context>
    <name>ArmedQuestions</name>
    <message>
        <source>Replay a log</source>
        <translation>Log wiedergeben</translation>
    </message>
    <message>
        <source>Vehicles %1 are armed. Replay a log?</source>
        <translation>Die Fahrzeuge %1 sind scharf. Ein Log wiedergeben?</translation>
    </message>
    <message>
        <source>Vehicle %1 is armed. Replay a log?</source>
        <translation>Fahrzeug %1 ist scharf. Ein Log wiedergeben?</translation>
    </message>
    <message>
        <source>No vehicle can be commanded until you go back to the live picture.</source>
        <translation>Kein Fahrzeug kann gesteuert werden, bis Sie zum Live-Bild zurückkehren.</translation>
    </message>
    <message>
        <source>Replay</source>
        <translation>Wiedergeben</translation>
    </message>
    <message>
        <source>Quit Skyseal</source>
        <translation>Skyseal beenden</translation>
    </message>
    <message>
        <source>Vehicles %1 are armed. Quit?</source>
        <translation>Die Fahrzeuge %1 sind scharf. Beenden?</translation>
    </message>
    <message>
        <source>Vehicle %1 is armed. Quit?</source>
        <translation>Fahrzeug %1 ist scharf. Beenden?</translation>
    </message>
    <message>
        <source>While Skyseal is closed, no vehicle can be commanded from here, and failsafes may trigger.</source>
        <translation>Solange Skyseal geschlossen ist, lässt sich kein Fahrzeug von hier steuern, und Failsafes können auslösen.</translation>
    </message>
    <message>
        <source>Quit</source>
        <translation>Beenden</translation>
    </message>
</context>
<context>
    <name>Metric</name>
    <message>
        <source>Packets transmitted</source>
        <translation>Übertragene Pakete</translation>
    </message>
    <message>
        <source>MAVLink frames that the station received from the vehicle during the run, without duplicates of clear frames</source>
        <translation>MAVLink-Frames, die die Station während des Laufs vom Fahrzeug empfing, ohne Duplikate offener Frames</translation>
    </message>
    <message>
        <source>Rate</source>
        <translation>Rate</translation>
    </message>
    <message>
        <source>packets per second</source>
        <translation>Pakete pro Sekunde</translation>
    </message>
    <message>
        <source>Rate in bytes</source>
        <translation>Rate in Bytes</translation>
    </message>
    <message>
        <source>MAVLink bytes received per second, after opening</source>
        <translation>empfangene MAVLink-Bytes pro Sekunde, nach dem Öffnen</translation>
    </message>
    <message>
        <source>Frames lost</source>
        <translation>Verlorene Frames</translation>
    </message>
    <message>
        <source>share of the vehicle&apos;s frames missing by MAVLink sequence numbers, 0 to 1; empty where jitter reorders the frames of the saturated load by more than 8 bits can number</source>
        <translation>Anteil der Frames des Fahrzeugs, die nach den Folgenummern von MAVLink fehlen, 0 bis 1; leer, wo Jitter die Frames der Volllast weiter vertauscht, als 8 Bit zählen können</translation>
    </message>
    <message>
        <source>Records lost, to the station</source>
        <translation>Verlorene Records, zur Station</translation>
    </message>
    <message>
        <source>share of the agent&apos;s records missing by their counters, 0 to 1</source>
        <translation>Anteil der Records des Agenten, die nach ihren Zählern fehlen, 0 bis 1</translation>
    </message>
    <message>
        <source>Records lost, to the agent</source>
        <translation>Verlorene Records, zum Agenten</translation>
    </message>
    <message>
        <source>the same in the other direction, as counted by the agent and reported over the sealed link</source>
        <translation>dasselbe in der Gegenrichtung, vom Agenten gezählt und über die versiegelte Verbindung gemeldet</translation>
    </message>
    <message>
        <source>CPU load, station</source>
        <translation>CPU-Last, Station</translation>
    </message>
    <message>
        <source>CPU time of the station&apos;s I/O thread (receive, open, parse, send), percent of one core</source>
        <translation>CPU-Zeit des E/A-Threads der Station (empfangen, öffnen, zerlegen, senden), Prozent eines Kerns</translation>
    </message>
    <message>
        <source>CPU load, station&apos;s process</source>
        <translation>CPU-Last, Prozess der Station</translation>
    </message>
    <message>
        <source>all threads of the measuring program</source>
        <translation>alle Threads des messenden Programms</translation>
    </message>
    <message>
        <source>Share of the measurement in the CPU load, station</source>
        <translation>Anteil der Messung an der CPU-Last, Station</translation>
    </message>
    <message>
        <source>CPU time in which the station&apos;s I/O thread made and handed out snapshots, probes and time lines, by its own clock, percent of its CPU time</source>
        <translation>CPU-Zeit, in der der E/A-Thread der Station Momentaufnahmen, Messpunkte und Zeitreihen erstellte und weitergab, nach seiner eigenen Uhr, Prozent seiner CPU-Zeit</translation>
    </message>
    <message>
        <source>Snapshots during the run, station</source>
        <translation>Momentaufnahmen während des Laufs, Station</translation>
    </message>
    <message>
        <source>snapshots that the station&apos;s I/O thread built from the first probe of the run on: 1, which is the last probe, or those of a window as well</source>
        <translation>Momentaufnahmen, die der E/A-Thread der Station ab dem ersten Messpunkt des Laufs erstellte: 1, nämlich der letzte Messpunkt, oder dazu die eines Fensters</translation>
    </message>
    <message>
        <source>CPU load of the suite, station</source>
        <translation>CPU-Last der Chiffre, Station</translation>
    </message>
    <message>
        <source>time inside seal and open, clocked around each call, percent of one core</source>
        <translation>Zeit im Versiegeln und Öffnen, um jeden Aufruf gemessen, Prozent eines Kerns</translation>
    </message>
    <message>
        <source>CPU load, agent</source>
        <translation>CPU-Last, Agent</translation>
    </message>
    <message>
        <source>CPU time of the agent&apos;s process, by the kernel&apos;s clock of it over the whole run for all arms alike; where the agent runs on another machine, between its reports over the sealed link, and empty in plain MAVLink, which has no reports</source>
        <translation>CPU-Zeit des Agentenprozesses, nach der Uhr des Kernels über den ganzen Lauf, für alle Varianten gleich; läuft der Agent auf einem anderen Rechner, zwischen seinen Meldungen über die versiegelte Verbindung, und leer bei ungeschütztem MAVLink, das keine Meldungen hat</translation>
    </message>
    <message>
        <source>CPU load of the suite, agent</source>
        <translation>CPU-Last der Chiffre, Agent</translation>
    </message>
    <message>
        <source>time inside seal and open at the agent, reported over the sealed link, percent of one core</source>
        <translation>Zeit im Versiegeln und Öffnen beim Agenten, über die versiegelte Verbindung gemeldet, Prozent eines Kerns</translation>
    </message>
    <message>
        <source>CPU time per frame, station</source>
        <translation>CPU-Zeit je Frame, Station</translation>
    </message>
    <message>
        <source>CPU time of the I/O thread divided by frames</source>
        <translation>CPU-Zeit des E/A-Threads geteilt durch die Frames</translation>
    </message>
    <message>
        <source>CPU time per frame, agent</source>
        <translation>CPU-Zeit je Frame, Agent</translation>
    </message>
    <message>
        <source>CPU load of the agent divided by the frame rate of the run</source>
        <translation>CPU-Last des Agenten geteilt durch die Frame-Rate des Laufs</translation>
    </message>
    <message>
        <source>Opening a record, median</source>
        <translation>Öffnen eines Records, Median</translation>
    </message>
    <message>
        <source>clocked around each call, including look-up and replay window; exact to 1/32</source>
        <translation>um jeden Aufruf gemessen, einschließlich Nachschlagen und Wiederholungsfenster; auf 1/32 genau</translation>
    </message>
    <message>
        <source>Opening a record, 99th percentile</source>
        <translation>Öffnen eines Records, 99. Perzentil</translation>
    </message>
    <message>
        <source>the same</source>
        <translation>dasselbe</translation>
    </message>
    <message>
        <source>Sealing a record, median</source>
        <translation>Versiegeln eines Records, Median</translation>
    </message>
    <message>
        <source>clocked around each call, at the station</source>
        <translation>um jeden Aufruf gemessen, bei der Station</translation>
    </message>
    <message>
        <source>Sealing a record, 99th percentile</source>
        <translation>Versiegeln eines Records, 99. Perzentil</translation>
    </message>
    <message>
        <source>Opening a record, agent</source>
        <translation>Öffnen eines Records, Agent</translation>
    </message>
    <message>
        <source>mean, clocked around each call at the agent, reported over the sealed link</source>
        <translation>Mittelwert, beim Agenten um jeden Aufruf gemessen, über die versiegelte Verbindung gemeldet</translation>
    </message>
    <message>
        <source>Sealing a record, agent</source>
        <translation>Versiegeln eines Records, Agent</translation>
    </message>
    <message>
        <source>Memory, station</source>
        <translation>Speicher, Station</translation>
    </message>
    <message>
        <source>resident set of the measuring program at the end of the run; one process runs all suites, so the value does not belong to one suite</source>
        <translation>belegter Arbeitsspeicher des messenden Programms am Ende des Laufs; ein Prozess führt alle Chiffren aus, daher gehört der Wert zu keiner einzelnen</translation>
    </message>
    <message>
        <source>Memory, agent</source>
        <translation>Speicher, Agent</translation>
    </message>
    <message>
        <source>resident set of the agent at the end of the run, from /proc for all arms alike; where the agent runs on another machine, as reported over the sealed link; one process runs all suites, so the value does not belong to one suite</source>
        <translation>belegter Arbeitsspeicher des Agenten am Ende des Laufs, aus /proc, für alle Varianten gleich; läuft der Agent auf einem anderen Rechner, wie über die versiegelte Verbindung gemeldet; ein Prozess führt alle Chiffren aus, daher gehört der Wert zu keiner einzelnen</translation>
    </message>
    <message>
        <source>Bytes on the wire</source>
        <translation>Bytes auf der Leitung</translation>
    </message>
    <message>
        <source>UDP payload of both directions during the run</source>
        <translation>UDP-Nutzdaten beider Richtungen während des Laufs</translation>
    </message>
    <message>
        <source>Bytes on the wire, to the station</source>
        <translation>Bytes auf der Leitung, zur Station</translation>
    </message>
    <message>
        <source>UDP payload per second</source>
        <translation>UDP-Nutzdaten pro Sekunde</translation>
    </message>
    <message>
        <source>Use of the line, to the station</source>
        <translation>Auslastung der Leitung, zur Station</translation>
    </message>
    <message>
        <source>bytes that the impaired line carried to the station, announcements of the agent included and duplicates of the relay left out, percent of its rate; empty without a limited rate</source>
        <translation>Bytes, die die gestörte Leitung zur Station trug, mit den Ankündigungen des Agenten und ohne Duplikate des Relais, Prozent ihrer Rate; leer ohne begrenzte Rate</translation>
    </message>
    <message>
        <source>Wire cost of a frame</source>
        <translation>Leitungsaufwand eines Frames</translation>
    </message>
    <message>
        <source>bytes to the station, including 28 of IPv4 and UDP headers for each datagram, divided by frames</source>
        <translation>Bytes zur Station, mit 28 für die IPv4- und UDP-Header jedes Datagramms, geteilt durch die Frames</translation>
    </message>
    <message>
        <source>Overhead on the wire</source>
        <translation>Overhead auf der Leitung</translation>
    </message>
    <message>
        <source>UDP payload to the station beyond the MAVLink bytes in it, percent of these</source>
        <translation>UDP-Nutzdaten zur Station über die darin enthaltenen MAVLink-Bytes hinaus, Prozent dieser Bytes</translation>
    </message>
    <message>
        <source>Frames in a datagram</source>
        <translation>Frames je Datagramm</translation>
    </message>
    <message>
        <source>MAVLink frames divided by the datagrams to the station, each of which is a record in the sealed framing; the fewer, the more records and wake-ups a frame costs</source>
        <translation>MAVLink-Frames geteilt durch die Datagramme zur Station, deren jedes in der versiegelten Rahmung ein Record ist; je weniger, desto mehr Records und Aufwachvorgänge kostet ein Frame</translation>
    </message>
    <message>
        <source>Latency</source>
        <translation>Latenz</translation>
    </message>
    <message>
        <source>round trip of TIMESYNC to the vehicle, mean of the run</source>
        <translation>Umlaufzeit von TIMESYNC zum Fahrzeug, Mittelwert des Laufs</translation>
    </message>
    <message>
        <source>Memory of a session</source>
        <translation>Speicher einer Sitzung</translation>
    </message>
    <message>
        <source>heap of a session at one end, including its keyed ciphers; measured once for each suite with separate sessions of this program</source>
        <translation>Heap einer Sitzung auf einer Seite, mit ihren Chiffren samt Schlüsseln; je Chiffre einmal mit eigenen Sitzungen dieses Programms gemessen</translation>
    </message>
    <message>
        <source>Power of the machine</source>
        <translation>Leistungsaufnahme des Rechners</translation>
    </message>
    <message>
        <source>mean over the run, by the kernel&apos;s energy counters of the processor or the sensor of the supply: with all programs on it</source>
        <translation>Mittelwert des Laufs, nach den Energiezählern des Kernels für den Prozessor oder dem Sensor der Stromversorgung: mit allen Programmen darauf</translation>
    </message>
    <message>
        <source>Power above idle</source>
        <translation>Leistungsaufnahme über Leerlauf</translation>
    </message>
    <message>
        <source>the same, less the power of the idle machine before and after the launch of the programs</source>
        <translation>dasselbe, abzüglich der Leistungsaufnahme des ruhenden Rechners vor und nach dem Start der Programme</translation>
    </message>
    <message>
        <source>Energy per frame</source>
        <translation>Energie je Frame</translation>
    </message>
    <message>
        <source>the energy above idle divided by frames received by the station; all programs of the sweep</source>
        <translation>Energie über Leerlauf geteilt durch die von der Station empfangenen Frames; alle Programme der Messreihe</translation>
    </message>
    <message>
        <source>Time of the live switch</source>
        <translation>Dauer des Wechsels im Betrieb</translation>
    </message>
    <message>
        <source>from the first order of the run to the confirmation by the other end, including orders that were not confirmed in time; empty if the suite of the run was in use already</source>
        <translation>vom ersten Auftrag des Laufs bis zur Bestätigung der anderen Seite, mit Aufträgen, die nicht rechtzeitig bestätigt wurden; leer, wenn die Chiffre des Laufs schon in Gebrauch war</translation>
    </message>
    <message>
        <source>Wake-ups, station</source>
        <translation>Aufwachvorgänge, Station</translation>
    </message>
    <message>
        <source>voluntary context switches of the station&apos;s I/O thread per second</source>
        <translation>freiwillige Kontextwechsel des E/A-Threads der Station pro Sekunde</translation>
    </message>
    <message>
        <source>Involuntary context switches, station</source>
        <translation>Unfreiwillige Kontextwechsel, Station</translation>
    </message>
    <message>
        <source>of the station&apos;s I/O thread per second: another program took its core</source>
        <translation>des E/A-Threads der Station pro Sekunde: Ein anderes Programm nahm seinen Kern</translation>
    </message>
    <message>
        <source>Wake-ups, agent</source>
        <translation>Aufwachvorgänge, Agent</translation>
    </message>
    <message>
        <source>voluntary context switches of the agent&apos;s main thread per second, on the same machine only</source>
        <translation>freiwillige Kontextwechsel des Haupt-Threads des Agenten pro Sekunde, nur auf demselben Rechner</translation>
    </message>
    <message>
        <source>Involuntary context switches, agent</source>
        <translation>Unfreiwillige Kontextwechsel, Agent</translation>
    </message>
    <message>
        <source>of the agent&apos;s main thread per second, on the same machine only</source>
        <translation>des Haupt-Threads des Agenten pro Sekunde, nur auf demselben Rechner</translation>
    </message>
    <message>
        <source>CPU load, simulator</source>
        <translation>CPU-Last, Simulator</translation>
    </message>
    <message>
        <source>CPU time of the simulator that the sweep started, percent of one core</source>
        <translation>CPU-Zeit des Simulators, den die Messreihe gestartet hat, Prozent eines Kerns</translation>
    </message>
    <message>
        <source>CPU load, relay</source>
        <translation>CPU-Last, Relais</translation>
    </message>
    <message>
        <source>CPU time of the relay of an impaired link, percent of one core</source>
        <translation>CPU-Zeit des Relais einer gestörten Verbindung, Prozent eines Kerns</translation>
    </message>
    <message>
        <source>CPU load, autopilot</source>
        <translation>CPU-Last, Autopilot</translation>
    </message>
    <message>
        <source>CPU time of the autopilot beside which the sweep ran, percent of one core; empty if its process was not found on this machine</source>
        <translation>CPU-Zeit des Autopiloten, neben dem die Messreihe lief, Prozent eines Kerns; leer, wenn sein Prozess auf diesem Rechner nicht gefunden wurde</translation>
    </message>
    <message>
        <source>Missed sends of the paced load</source>
        <translation>Ausgelassene Sendungen der getakteten Last</translation>
    </message>
    <message>
        <source>frames that the generator of a paced load did not send, since it was 20 ms late on its schedule or its queue was full; exact to a tenth of a second at the ends of the run; empty under other loads</source>
        <translation>Frames, die der Generator einer getakteten Last nicht sendete, weil er 20 ms hinter seinem Zeitplan oder seine Warteschlange voll war; an den Enden des Laufs auf eine Zehntelsekunde genau; leer bei anderen Lasten</translation>
    </message>
    <message>
        <source>CPU load, other programs</source>
        <translation>CPU-Last, andere Programme</translation>
    </message>
    <message>
        <source>CPU time of this machine that was used neither by the measuring program, nor by programs that the sweep started or the autopilot, percent of one core; exact to the ticks of the kernel&apos;s clock on each core</source>
        <translation>CPU-Zeit dieses Rechners, die weder das messende Programm noch von der Messreihe gestartete Programme oder der Autopilot belegten, Prozent eines Kerns; auf die Takte der Kernel-Uhr jedes Kerns genau</translation>
    </message>
    <message>
        <source>Time taken by the hypervisor</source>
        <translation>Vom Hypervisor genommene Zeit</translation>
    </message>
    <message>
        <source>time in which a virtual core had work and was not run, percent of one core</source>
        <translation>Zeit, in der ein virtueller Kern Arbeit hatte und nicht lief, Prozent eines Kerns</translation>
    </message>
    <message>
        <source>Frequency of the cores</source>
        <translation>Takt der Kerne</translation>
    </message>
    <message>
        <source>mean over the cores and over the two ends of the run, as the kernel states it</source>
        <translation>Mittelwert über die Kerne und die beiden Enden des Laufs, nach Angabe des Kernels</translation>
    </message>
    <message>
        <source>Change of the frequency of the cores</source>
        <translation>Änderung des Takts der Kerne</translation>
    </message>
    <message>
        <source>difference between the two ends of the run, percent of their mean</source>
        <translation>Differenz zwischen den beiden Enden des Laufs, Prozent ihres Mittelwerts</translation>
    </message>
    <message>
        <source>Load average per core, at the start</source>
        <translation>Mittlere Last je Kern, zu Beginn</translation>
    </message>
    <message>
        <source>load average of the last minute at the start of the run, divided by the number of cores; the sweep&apos;s own programs are part of it</source>
        <translation>mittlere Last der letzten Minute zu Beginn des Laufs, geteilt durch die Zahl der Kerne; die eigenen Programme der Messreihe gehören dazu</translation>
    </message>
    <message>
        <source>Load average per core, at the end</source>
        <translation>Mittlere Last je Kern, am Ende</translation>
    </message>
    <message>
        <source>the same at the end of the run</source>
        <translation>dasselbe am Ende des Laufs</translation>
    </message>
    <message>
        <source>Power of the idle machine</source>
        <translation>Leistungsaufnahme des ruhenden Rechners</translation>
    </message>
    <message>
        <source>mean of five seconds before the programs of the launch started and five after they ended</source>
        <translation>Mittelwert aus fünf Sekunden vor dem Start der Programme und fünf nach ihrem Ende</translation>
    </message>
    <message>
        <source>Change of the power of the idle machine</source>
        <translation>Änderung der Leistungsaufnahme des ruhenden Rechners</translation>
    </message>
    <message>
        <source>difference between the two, percent of their mean</source>
        <translation>Differenz der beiden, Prozent ihres Mittelwerts</translation>
    </message>
    <message>
        <source>Throttlings of the processor</source>
        <translation>Drosselungen des Prozessors</translation>
    </message>
    <message>
        <source>how often the processor slowed down during the run, hot or short of power: the kernel&apos;s counters of cores and packages, or one where the firmware says so at an end of the run</source>
        <translation>wie oft der Prozessor während des Laufs langsamer wurde, wegen Hitze oder zu wenig Leistung: die Zähler des Kernels für Kerne und Prozessoren, oder eins, wo die Firmware es an einem Ende des Laufs meldet</translation>
    </message>
</context>
<context>
    <name>QObject</name>
    <message>
        <source>Known peers</source>
        <translation>Bekannte Gegenstellen</translation>
    </message>
    <message>
        <source>&amp;Remember it in the desktop keyring</source>
        <translation>&amp;Im Schlüsselbund des Desktops merken</translation>
    </message>
    <message>
        <source>Remember it in the desktop keyring (%1)</source>
        <translation>Im Schlüsselbund des Desktops merken (%1)</translation>
    </message>
    <message>
        <source>Anyone logged in as you, and any program you run, can then use the key without the passphrase.</source>
        <translation>Jeder, der unter diesem Benutzer angemeldet ist, und jedes seiner Programme kann den Schlüssel dann ohne die Passphrase verwenden.</translation>
    </message>
</context>
<context>
    <name>Reason</name>
    <message>
        <source>the passphrase does not open it, or the file was changed</source>
        <translation>die Passphrase öffnet sie nicht, oder die Datei wurde geändert</translation>
    </message>
    <message>
        <source>there is no peer named &quot;%1&quot; any more</source>
        <translation>es gibt keine Gegenstelle „%1“ mehr</translation>
    </message>
    <message>
        <source>cannot be read: %1</source>
        <translation>kann nicht gelesen werden: %1</translation>
    </message>
    <message>
        <source>holds no public key of Skyseal</source>
        <translation>enthält keinen öffentlichen Schlüssel von Skyseal</translation>
    </message>
    <message>
        <source>the folder cannot be made</source>
        <translation>der Ordner kann nicht angelegt werden</translation>
    </message>
    <message>
        <source>the passphrase was not given</source>
        <translation>die Passphrase wurde nicht eingegeben</translation>
    </message>
    <message>
        <source>the station is not running</source>
        <translation>die Station läuft nicht</translation>
    </message>
    <message>
        <source>is not a recording</source>
        <translation>ist keine Aufzeichnung</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>cannot be written: %1</source>
        <translation>kann nicht geschrieben werden: %1</translation>
    </message>
    <message>
        <source>cannot be created: %1</source>
        <translation>kann nicht angelegt werden: %1</translation>
    </message>
    <message>
        <source>less than %1 MiB are free there</source>
        <translation>dort sind weniger als %1 MiB frei</translation>
    </message>
    <message>
        <source>is not a counter file of Skyseal, or is damaged</source>
        <translation>ist keine Zählerdatei von Skyseal oder beschädigt</translation>
    </message>
    <message>
        <source>the disk does not answer</source>
        <translation>der Datenträger antwortet nicht</translation>
    </message>
    <message>
        <source>is not a regular file</source>
        <translation>ist keine gewöhnliche Datei</translation>
    </message>
    <message>
        <source>belongs to another user (number %1), who can change it, refused</source>
        <translation>gehört einem anderen Benutzer (Nummer %1), der sie ändern kann, abgelehnt</translation>
    </message>
    <message>
        <source>can be read by other users (mode %1), refused; run: chmod 600</source>
        <translation>kann von anderen Benutzern gelesen werden (Rechte %1), abgelehnt; Abhilfe: chmod 600</translation>
    </message>
    <message>
        <source>can be changed by other users (mode %1), refused; run: chmod 600</source>
        <translation>kann von anderen Benutzern geändert werden (Rechte %1), abgelehnt; Abhilfe: chmod 600</translation>
    </message>
    <message>
        <source>is too large to be a file of this kind</source>
        <translation>ist zu groß für eine Datei dieser Art</translation>
    </message>
    <message>
        <source>is a symbolic link, refused for a secret; name the file itself</source>
        <translation>ist ein symbolischer Link, für ein Geheimnis abgelehnt; nennen Sie die Datei selbst</translation>
    </message>
    <message>
        <source>exists already and is not overwritten</source>
        <translation>existiert schon und wird nicht überschrieben</translation>
    </message>
    <message>
        <source>cannot be locked: %1</source>
        <translation>kann nicht gesperrt werden: %1</translation>
    </message>
    <message>
        <source>is still locked by another program after %1 ms, try again</source>
        <translation>ist nach %1 ms noch von einem anderen Programm gesperrt, versuchen Sie es erneut</translation>
    </message>
    <message>
        <source>the system ID %1 is bound to &quot;%2&quot; already; each vehicle needs its own</source>
        <translation>die System-ID %1 gehört schon zu „%2“; jedes Fahrzeug braucht eine eigene</translation>
    </message>
    <message>
        <source>the peer &quot;%1&quot; is known with another key</source>
        <translation>die Gegenstelle „%1“ ist mit einem anderen Schlüssel bekannt</translation>
    </message>
    <message>
        <source>character %1 is not valid UTF-8</source>
        <translation>das Zeichen %1 ist kein gültiges UTF-8</translation>
    </message>
    <message>
        <source>character %1 is %2, a blank</source>
        <translation>das Zeichen %1 ist %2, ein Leerzeichen</translation>
    </message>
    <message>
        <source>character %1 is %2, a control or format character</source>
        <translation>das Zeichen %1 ist %2, ein Steuer- oder Formatzeichen</translation>
    </message>
    <message>
        <source>%1 is not a list of system IDs: numbers from 1 to 255 with commas between them, or &quot;any&quot;</source>
        <translation>%1 ist keine Liste von System-IDs: Zahlen von 1 bis 255 mit Kommas dazwischen, oder „any“</translation>
    </message>
    <message>
        <source>a peer needs a name, a role, system IDs and a public key, here are %1 fields</source>
        <translation>eine Gegenstelle braucht Namen, Rolle, System-IDs und öffentlichen Schlüssel, hier sind %1 Felder</translation>
    </message>
    <message>
        <source>%1 is not a role: pilot or observer</source>
        <translation>%1 ist keine Rolle: pilot oder observer</translation>
    </message>
    <message>
        <source>%1 is not a pre-shared key: psk=FILE</source>
        <translation>%1 ist kein vorab geteilter Schlüssel: psk=DATEI</translation>
    </message>
    <message>
        <source>%1 is not a peer&apos;s name: 1 to 32 letters, digits, &quot;-&quot;, &quot;_&quot; or &quot;.&quot;; one beyond ASCII counts as 2 to 4</source>
        <translation>%1 ist kein Name einer Gegenstelle: 1 bis 32 Buchstaben, Ziffern, „-“, „_“ oder „.“; Zeichen außerhalb von ASCII zählen als 2 bis 4</translation>
    </message>
    <message>
        <source>%1 is not a peer&apos;s name: it must not begin with &quot;-&quot;</source>
        <translation>%1 ist kein Name einer Gegenstelle: er darf nicht mit „-“ beginnen</translation>
    </message>
    <message>
        <source>%1 is not a peer&apos;s name: %2</source>
        <translation>%1 ist kein Name einer Gegenstelle: %2</translation>
    </message>
    <message>
        <source>0 is not a system ID: numbers from 1 to 255</source>
        <translation>0 ist keine System-ID: Zahlen von 1 bis 255</translation>
    </message>
    <message>
        <source>%1 cannot be noted: the path of a pre-shared key must not have blanks</source>
        <translation>%1 kann nicht eingetragen werden: der Pfad eines vorab geteilten Schlüssels darf keine Leerzeichen enthalten</translation>
    </message>
    <message>
        <source>does not exist; keys pair and keys peers add create it</source>
        <translation>existiert nicht; keys pair und keys peers add legen sie an</translation>
    </message>
    <message>
        <source>a list has at most %1 peers</source>
        <translation>eine Liste hat höchstens %1 Gegenstellen</translation>
    </message>
    <message>
        <source>there is a peer named &quot;%1&quot; already</source>
        <translation>es gibt schon eine Gegenstelle „%1“</translation>
    </message>
    <message>
        <source>the peer &quot;%1&quot; has the same key already</source>
        <translation>die Gegenstelle „%1“ hat schon denselben Schlüssel</translation>
    </message>
    <message>
        <source>there is no peer named &quot;%1&quot;</source>
        <translation>es gibt keine Gegenstelle „%1“</translation>
    </message>
    <message>
        <source>this is not a public key: %1</source>
        <translation>das ist kein öffentlicher Schlüssel: %1</translation>
    </message>
    <message>
        <source>it does not begin with &quot;skyseal:&quot;</source>
        <translation>er beginnt nicht mit „skyseal:“</translation>
    </message>
    <message>
        <source>48 characters follow &quot;skyseal:&quot;, here %1</source>
        <translation>auf „skyseal:“ folgen 48 Zeichen, hier %1</translation>
    </message>
    <message>
        <source>its check does not fit, so some character is wrong</source>
        <translation>seine Prüfsumme passt nicht, ein Zeichen ist also falsch</translation>
    </message>
    <message>
        <source>is not a sealed key file of Skyseal: it does not begin with &quot;%1&quot;</source>
        <translation>ist keine versiegelte Schlüsseldatei von Skyseal: sie beginnt nicht mit „%1“</translation>
    </message>
    <message>
        <source>is truncated: a sealed key has four lines</source>
        <translation>ist abgeschnitten: ein versiegelter Schlüssel hat vier Zeilen</translation>
    </message>
    <message>
        <source>&quot;argon2id PASSES KIB SALT&quot; is expected here</source>
        <translation>hier wird „argon2id PASSES KIB SALT“ erwartet</translation>
    </message>
    <message>
        <source>asks for %1 passes over %2 KiB, which is outside of what is accepted (1 to 16 passes, 8192 to 1048576 KiB)</source>
        <translation>verlangt %1 Durchgänge über %2 KiB, außerhalb des Zulässigen (1 bis 16 Durchgänge, 8192 bis 1048576 KiB)</translation>
    </message>
    <message>
        <source>a public key is expected here</source>
        <translation>hier wird ein öffentlicher Schlüssel erwartet</translation>
    </message>
    <message>
        <source>has a truncated key</source>
        <translation>hat einen abgeschnittenen Schlüssel</translation>
    </message>
    <message>
        <source>has a damaged key</source>
        <translation>hat einen beschädigten Schlüssel</translation>
    </message>
    <message>
        <source>has more behind the key</source>
        <translation>enthält hinter dem Schlüssel noch etwas</translation>
    </message>
    <message>
        <source>holds &quot;%1&quot;, not &quot;%2&quot;</source>
        <translation>enthält „%1“, nicht „%2“</translation>
    </message>
    <message>
        <source>is not a key file of Skyseal: it does not begin with &quot;%1&quot;</source>
        <translation>ist keine Schlüsseldatei von Skyseal: sie beginnt nicht mit „%1“</translation>
    </message>
    <message>
        <source>has more than one key</source>
        <translation>enthält mehr als einen Schlüssel</translation>
    </message>
    <message>
        <source>has a damaged key: its check does not fit</source>
        <translation>hat einen beschädigten Schlüssel: seine Prüfsumme passt nicht</translation>
    </message>
    <message>
        <source>is truncated: it has no key</source>
        <translation>ist abgeschnitten: sie enthält keinen Schlüssel</translation>
    </message>
    <message>
        <source>needs %1 MiB of memory for its passphrase, more than this machine gives</source>
        <translation>braucht für die Passphrase %1 MiB Speicher, mehr als dieser Rechner hergibt</translation>
    </message>
    <message>
        <source>is sealed with a passphrase, and none is given</source>
        <translation>ist mit einer Passphrase versiegelt, und keine ist angegeben</translation>
    </message>
    <message>
        <source>%1; %2</source>
        <translation>%1; %2</translation>
    </message>
    <message>
        <source>%1 (pre-shared key of &quot;%2&quot;)</source>
        <translation>%1 (vorab geteilter Schlüssel von „%2“)</translation>
    </message>
    <message>
        <source>no error</source>
        <translation>kein Fehler</translation>
    </message>
    <message>
        <source>port %1 is in use by another program</source>
        <translation>der Port %1 wird von einem anderen Programm benutzt</translation>
    </message>
    <message>
        <source>%1 is not an address of this machine</source>
        <translation>%1 ist keine Adresse dieses Rechners</translation>
    </message>
    <message>
        <source>the host name &quot;%1&quot; is not known</source>
        <translation>der Rechnername „%1“ ist nicht bekannt</translation>
    </message>
    <message>
        <source>%1 refuses the connection (nothing listens there)</source>
        <translation>%1 lehnt die Verbindung ab (dort lauscht nichts)</translation>
    </message>
    <message>
        <source>%1 cannot be reached</source>
        <translation>%1 ist nicht erreichbar</translation>
    </message>
    <message>
        <source>%1 does not answer</source>
        <translation>%1 antwortet nicht</translation>
    </message>
    <message>
        <source>%1 closed the connection</source>
        <translation>%1 hat die Verbindung geschlossen</translation>
    </message>
    <message>
        <source>no permission to open %1</source>
        <translation>keine Berechtigung, %1 zu öffnen</translation>
    </message>
    <message>
        <source>there is no device %1</source>
        <translation>es gibt kein Gerät %1</translation>
    </message>
    <message>
        <source>the device %1 is in use by another program</source>
        <translation>das Gerät %1 wird von einem anderen Programm benutzt</translation>
    </message>
    <message>
        <source>cannot read %1</source>
        <translation>%1 kann nicht gelesen werden</translation>
    </message>
    <message>
        <source>end of %1</source>
        <translation>Ende von %1</translation>
    </message>
    <message>
        <source>%1 is not supported here</source>
        <translation>%1 wird hier nicht unterstützt</translation>
    </message>
    <message>
        <source>%1 failed</source>
        <translation>%1 ist fehlgeschlagen</translation>
    </message>
    <message>
        <source>a link URL is at most 4096 characters long</source>
        <translation>eine Verbindungs-URL hat höchstens 4096 Zeichen</translation>
    </message>
    <message>
        <source>a link URL cannot hold control characters</source>
        <translation>eine Verbindungs-URL darf keine Steuerzeichen enthalten</translation>
    </message>
    <message>
        <source>a link URL starts with %1</source>
        <translation>eine Verbindungs-URL beginnt mit %1</translation>
    </message>
    <message>
        <source>the baud rate is a number from 300 to 12000000</source>
        <translation>die Baudrate ist eine Zahl von 300 bis 12000000</translation>
    </message>
    <message>
        <source>the device is missing, as in %1:/dev/ttyUSB0:57600</source>
        <translation>das Gerät fehlt, wie in %1:/dev/ttyUSB0:57600</translation>
    </message>
    <message>
        <source>the file is missing, as in %1:flight.%1</source>
        <translation>die Datei fehlt, wie in %1:flight.%1</translation>
    </message>
    <message>
        <source>the IPv6 address lacks its closing bracket</source>
        <translation>der IPv6-Adresse fehlt die schließende Klammer</translation>
    </message>
    <message>
        <source>an IPv6 address must be in brackets, as in [::1]:14550</source>
        <translation>eine IPv6-Adresse muss in Klammern stehen, wie in [::1]:14550</translation>
    </message>
    <message>
        <source>the port is missing, as in %1</source>
        <translation>der Port fehlt, wie in %1</translation>
    </message>
    <message>
        <source>an IPv6 address with a zone (%) is not supported</source>
        <translation>eine IPv6-Adresse mit Zone (%) wird nicht unterstützt</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not an IPv6 address</source>
        <translation>„%1“ ist keine IPv6-Adresse</translation>
    </message>
    <message>
        <source>the host is missing, as in %1</source>
        <translation>der Rechner fehlt, wie in %1</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not an IPv4 address</source>
        <translation>„%1“ ist keine IPv4-Adresse</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a host name or address</source>
        <translation>„%1“ ist weder Rechnername noch Adresse</translation>
    </message>
    <message>
        <source>the port &quot;%1&quot; is not a number from %2 to 65535</source>
        <translation>der Port „%1“ ist keine Zahl von %2 bis 65535</translation>
    </message>
    <message>
        <source>it is not a file</source>
        <translation>es ist keine Datei</translation>
    </message>
    <message>
        <source>permission denied</source>
        <translation>keine Berechtigung</translation>
    </message>
    <message>
        <source>the coordinates are not in WGS84, but in &quot;%1&quot;</source>
        <translation>die Koordinaten sind nicht in WGS84, sondern in „%1“</translation>
    </message>
    <message>
        <source>more than %1 objects are within one another</source>
        <translation>mehr als %1 Objekte sind ineinander verschachtelt</translation>
    </message>
    <message>
        <source>this is not an object</source>
        <translation>das ist kein Objekt</translation>
    </message>
    <message>
        <source>this is not an array</source>
        <translation>das ist kein Array</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a type of GeoJSON</source>
        <translation>„%1“ ist kein Typ von GeoJSON</translation>
    </message>
    <message>
        <source>this is not a position: [longitude, latitude]</source>
        <translation>das ist keine Position: [Länge, Breite]</translation>
    </message>
    <message>
        <source>this is not an array of positions</source>
        <translation>das ist kein Array von Positionen</translation>
    </message>
    <message>
        <source>this is not an array of lines</source>
        <translation>das ist kein Array von Linien</translation>
    </message>
    <message>
        <source>the file has more than %1 values</source>
        <translation>die Datei hat mehr als %1 Werte</translation>
    </message>
    <message>
        <source>the file has no JSON object</source>
        <translation>die Datei enthält kein JSON-Objekt</translation>
    </message>
    <message>
        <source>a document type declaration is not permitted</source>
        <translation>eine Dokumenttyp-Deklaration ist nicht zulässig</translation>
    </message>
    <message>
        <source>more than %1 elements are within one another</source>
        <translation>mehr als %1 Elemente sind ineinander verschachtelt</translation>
    </message>
    <message>
        <source>the file begins with the element &quot;%1&quot;, not with &quot;kml&quot;</source>
        <translation>die Datei beginnt mit dem Element „%1“, nicht mit „kml“</translation>
    </message>
    <message>
        <source>a geometry is within another one</source>
        <translation>eine Geometrie steht in einer anderen</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a position: longitude,latitude</source>
        <translation>„%1“ ist keine Position: Länge,Breite</translation>
    </message>
    <message>
        <source>a geometry has more coordinates than one of its kind can have</source>
        <translation>eine Geometrie hat mehr Koordinaten, als ihre Art haben kann</translation>
    </message>
    <message>
        <source>the file has more than %1 positions</source>
        <translation>die Datei hat mehr als %1 Positionen</translation>
    </message>
    <message>
        <source>the longitude %1 is not within -180 and 180</source>
        <translation>die Länge %1 liegt nicht zwischen -180 und 180</translation>
    </message>
    <message>
        <source>the latitude %1 is not within -90 and 90</source>
        <translation>die Breite %1 liegt nicht zwischen -90 und 90</translation>
    </message>
    <message>
        <source>a .kmz is a zip file; unpack it, and add the .kml that is in it</source>
        <translation>eine .kmz ist eine ZIP-Datei; entpacken Sie sie und fügen Sie die .kml darin hinzu</translation>
    </message>
    <message>
        <source>the name ends neither in .kml nor in .geojson or .json</source>
        <translation>der Name endet weder auf .kml noch auf .geojson oder .json</translation>
    </message>
    <message>
        <source>this is not a file</source>
        <translation>das ist keine Datei</translation>
    </message>
    <message>
        <source>the file is larger than %1 MB</source>
        <translation>die Datei ist größer als %1 MB</translation>
    </message>
    <message>
        <source>expected the text of the item before the condition</source>
        <translation>vor der Bedingung wird der Text des Punkts erwartet</translation>
    </message>
    <message>
        <source>longer than %1 bytes</source>
        <translation>länger als %1 Bytes</translation>
    </message>
    <message>
        <source>a control character: this is not a text file</source>
        <translation>ein Steuerzeichen: das ist keine Textdatei</translation>
    </message>
    <message>
        <source>an item longer than %1 bytes</source>
        <translation>ein Punkt ist länger als %1 Bytes</translation>
    </message>
    <message>
        <source>more than %1 items</source>
        <translation>mehr als %1 Punkte</translation>
    </message>
    <message>
        <source>no items</source>
        <translation>keine Punkte</translation>
    </message>
    <message>
        <source>not a mission file: the first line must be &quot;QGC WPL 110&quot;</source>
        <translation>keine Missionsdatei: die erste Zeile muss „QGC WPL 110“ sein</translation>
    </message>
    <message>
        <source>an item has 12 columns, this line has %1</source>
        <translation>ein Wegpunkt hat 12 Spalten, diese Zeile hat %1</translation>
    </message>
    <message>
        <source>a mission has at most %1 items</source>
        <translation>eine Mission hat höchstens %1 Wegpunkte</translation>
    </message>
    <message>
        <source>more than %1 parameters</source>
        <translation>mehr als %1 Parameter</translation>
    </message>
    <message>
        <source>contains no parameters</source>
        <translation>enthält keine Parameter</translation>
    </message>
    <message>
        <source>nothing was sent: %1</source>
        <translation>nichts wurde gesendet: %1</translation>
    </message>
    <message>
        <source>not supported</source>
        <translation>nicht unterstützt</translation>
    </message>
    <message>
        <source>no vehicle with system ID %1</source>
        <translation>kein Fahrzeug mit der System-ID %1</translation>
    </message>
    <message>
        <source>no answer to %1 attempts</source>
        <translation>keine Antwort auf %1 Versuche</translation>
    </message>
    <message>
        <source>cancelled</source>
        <translation>abgebrochen</translation>
    </message>
    <message>
        <source>%1; the agent may know this station as an observer, or the commands reach it too late: it drops both</source>
        <translation>%1; vielleicht kennt der Agent diese Station als Beobachter, oder die Befehle erreichen ihn zu spät: beides verwirft er</translation>
    </message>
    <message>
        <source>no answer yet, and not sent again: this program was suspended for %1 s</source>
        <translation>noch keine Antwort und nicht erneut gesendet: dieses Programm war %1 s lang angehalten</translation>
    </message>
    <message>
        <source>too many commands are waiting for answers</source>
        <translation>zu viele Befehle warten auf Antworten</translation>
    </message>
    <message>
        <source>replaced by a newer command</source>
        <translation>durch einen neueren Befehl ersetzt</translation>
    </message>
    <message>
        <source>sent %1 times; the vehicle does not confirm it</source>
        <translation>%1-mal gesendet; das Fahrzeug bestätigt es nicht</translation>
    </message>
    <message>
        <source>acknowledged; no heartbeat since</source>
        <translation>bestätigt; seither kein Heartbeat</translation>
    </message>
    <message>
        <source>acknowledged, but the vehicle reports armed</source>
        <translation>bestätigt, aber das Fahrzeug meldet sich als scharf</translation>
    </message>
    <message>
        <source>acknowledged, but the vehicle reports disarmed</source>
        <translation>bestätigt, aber das Fahrzeug meldet sich als unscharf</translation>
    </message>
    <message>
        <source>it needs the mode %1, the vehicle went to %2</source>
        <translation>es braucht den Modus %1, das Fahrzeug ging in %2</translation>
    </message>
    <message>
        <source>it needs the mode %1, the vehicle stays in %2</source>
        <translation>es braucht den Modus %1, das Fahrzeug bleibt in %2</translation>
    </message>
    <message>
        <source>acknowledged, but the vehicle reports the mode %1</source>
        <translation>bestätigt, aber das Fahrzeug meldet den Modus %1</translation>
    </message>
    <message>
        <source>acknowledged, but the vehicle reports mission item %1</source>
        <translation>bestätigt, aber das Fahrzeug meldet den Wegpunkt %1</translation>
    </message>
    <message>
        <source>the modes of this kind of vehicle are not known</source>
        <translation>die Modi dieser Art von Fahrzeug sind nicht bekannt</translation>
    </message>
    <message>
        <source>the vehicle has no mode &apos;%1&apos;; it has %2</source>
        <translation>das Fahrzeug hat keinen Modus „%1“; es hat %2</translation>
    </message>
    <message>
        <source>the altitude of a take-off must be above 0 m</source>
        <translation>die Starthöhe muss über 0 m liegen</translation>
    </message>
    <message>
        <source>this kind of vehicle does not fly</source>
        <translation>diese Art von Fahrzeug fliegt nicht</translation>
    </message>
    <message>
        <source>take-off needs the mode GUIDED, the vehicle is in %1</source>
        <translation>der Start braucht den Modus GUIDED, das Fahrzeug ist in %1</translation>
    </message>
    <message>
        <source>take-off needs an armed vehicle, it is disarmed</source>
        <translation>der Start braucht ein scharfes Fahrzeug, es ist unscharf</translation>
    </message>
    <message>
        <source>take-off needs a known position</source>
        <translation>der Start braucht eine bekannte Position</translation>
    </message>
    <message>
        <source>this kind of vehicle has no mode to land in</source>
        <translation>diese Art von Fahrzeug hat keinen Modus zum Landen</translation>
    </message>
    <message>
        <source>this kind of vehicle has no mode to return in</source>
        <translation>diese Art von Fahrzeug hat keinen Modus zur Rückkehr</translation>
    </message>
    <message>
        <source>this kind of vehicle has no mode to loiter in</source>
        <translation>diese Art von Fahrzeug hat keinen Modus zum Kreisen</translation>
    </message>
    <message>
        <source>the location is not on the globe</source>
        <translation>der Ort liegt nicht auf der Erde</translation>
    </message>
    <message>
        <source>going to a location needs the mode GUIDED, the vehicle is in %1</source>
        <translation>der Flug zu einem Ort braucht den Modus GUIDED, das Fahrzeug ist in %1</translation>
    </message>
    <message>
        <source>going to a location needs a known home altitude</source>
        <translation>der Flug zu einem Ort braucht eine bekannte Höhe des Startpunkts</translation>
    </message>
    <message>
        <source>the altitude is not a number</source>
        <translation>die Höhe ist keine Zahl</translation>
    </message>
    <message>
        <source>changing the altitude needs a known position</source>
        <translation>die Höhenänderung braucht eine bekannte Position</translation>
    </message>
    <message>
        <source>changing the altitude needs a known home altitude</source>
        <translation>die Höhenänderung braucht eine bekannte Höhe des Startpunkts</translation>
    </message>
    <message>
        <source>pointing at a location needs a known home altitude</source>
        <translation>das Zielen auf einen Ort braucht eine bekannte Höhe des Startpunkts</translation>
    </message>
    <message>
        <source>moving home needs a known home altitude</source>
        <translation>das Verschieben des Startpunkts braucht eine bekannte Höhe des Startpunkts</translation>
    </message>
    <message>
        <source>the speed must be above 0 m/s</source>
        <translation>die Geschwindigkeit muss über 0 m/s liegen</translation>
    </message>
    <message>
        <source>another mission transfer is under way</source>
        <translation>eine andere Missionsübertragung läuft</translation>
    </message>
    <message>
        <source>item %1 is not on the globe</source>
        <translation>der Wegpunkt %1 liegt nicht auf der Erde</translation>
    </message>
    <message>
        <source>the vehicle does not send item %1</source>
        <translation>das Fahrzeug sendet den Wegpunkt %1 nicht</translation>
    </message>
    <message>
        <source>the vehicle stopped requesting items</source>
        <translation>das Fahrzeug fordert keine Wegpunkte mehr an</translation>
    </message>
    <message>
        <source>the vehicle ended the upload early</source>
        <translation>das Fahrzeug hat die Übertragung vorzeitig beendet</translation>
    </message>
    <message>
        <source>a name of up to 16 characters and a number are needed</source>
        <translation>ein Name mit bis zu 16 Zeichen und eine Zahl sind nötig</translation>
    </message>
    <message>
        <source>the vehicle does not send its parameters</source>
        <translation>das Fahrzeug sendet seine Parameter nicht</translation>
    </message>
    <message>
        <source>only %1 of %2 parameters came</source>
        <translation>nur %1 von %2 Parametern kamen an</translation>
    </message>
    <message>
        <source>the vehicle keeps %1</source>
        <translation>das Fahrzeug behält %1</translation>
    </message>
    <message>
        <source>another file transfer is under way</source>
        <translation>eine andere Dateiübertragung läuft</translation>
    </message>
    <message>
        <source>a path of up to %1 bytes is needed</source>
        <translation>ein Pfad mit bis zu %1 Bytes ist nötig</translation>
    </message>
    <message>
        <source>a file has at most %1 bytes</source>
        <translation>eine Datei hat höchstens %1 Bytes</translation>
    </message>
    <message>
        <source>the file is larger than %1 bytes</source>
        <translation>die Datei ist größer als %1 Bytes</translation>
    </message>
    <message>
        <source>the folder has more than %1 entries</source>
        <translation>der Ordner hat mehr als %1 Einträge</translation>
    </message>
    <message>
        <source>the checksums of both ends differ</source>
        <translation>die Prüfsummen beider Seiten sind verschieden</translation>
    </message>
    <message>
        <source>the vehicle does not send the checksum</source>
        <translation>das Fahrzeug sendet die Prüfsumme nicht</translation>
    </message>
    <message>
        <source>without a checksum, the part that is kept cannot be used</source>
        <translation>ohne Prüfsumme kann der aufbewahrte Teil nicht verwendet werden</translation>
    </message>
    <message>
        <source>the vehicle does not report the size of the file</source>
        <translation>das Fahrzeug meldet die Größe der Datei nicht</translation>
    </message>
    <message>
        <source>the size of the file does not match the part that is kept</source>
        <translation>die Größe der Datei passt nicht zum aufbewahrten Teil</translation>
    </message>
    <message>
        <source>the file changed while it was read</source>
        <translation>die Datei hat sich während des Lesens geändert</translation>
    </message>
    <message>
        <source>the vehicle does not send byte %1</source>
        <translation>das Fahrzeug sendet Byte %1 nicht</translation>
    </message>
    <message>
        <source>the vehicle does not accept byte %1</source>
        <translation>das Fahrzeug nimmt Byte %1 nicht an</translation>
    </message>
    <message>
        <source>another request for logs is under way</source>
        <translation>eine andere Anforderung von Logs läuft</translation>
    </message>
    <message>
        <source>the vehicle has no such log</source>
        <translation>das Fahrzeug hat kein solches Log</translation>
    </message>
    <message>
        <source>the vehicle still has logs, or does not answer</source>
        <translation>das Fahrzeug hat noch Logs oder antwortet nicht</translation>
    </message>
    <message>
        <source>the vehicle does not list its logs</source>
        <translation>das Fahrzeug listet seine Logs nicht auf</translation>
    </message>
    <message>
        <source>the vehicle does not list its logs while it is armed</source>
        <translation>das Fahrzeug listet seine Logs nicht auf, solange es scharf ist</translation>
    </message>
    <message>
        <source>the vehicle does not send byte %1 and following</source>
        <translation>das Fahrzeug sendet Byte %1 und die folgenden nicht</translation>
    </message>
    <message>
        <source>the log is larger than %1 bytes</source>
        <translation>das Log ist größer als %1 Bytes</translation>
    </message>
    <message>
        <source>the log does not match the part that is kept</source>
        <translation>das Log passt nicht zum aufbewahrten Teil</translation>
    </message>
    <message>
        <source>the log changed while it was read</source>
        <translation>das Log hat sich während des Lesens geändert</translation>
    </message>
    <message>
        <source>result %1</source>
        <translation>Ergebnis %1</translation>
    </message>
    <message>
        <source>accepted</source>
        <translation>angenommen</translation>
    </message>
    <message>
        <source>temporarily rejected</source>
        <translation>vorübergehend abgelehnt</translation>
    </message>
    <message>
        <source>denied</source>
        <translation>abgelehnt</translation>
    </message>
    <message>
        <source>failed</source>
        <translation>fehlgeschlagen</translation>
    </message>
    <message>
        <source>in progress</source>
        <translation>in Arbeit</translation>
    </message>
    <message>
        <source>accepted as COMMAND_LONG only</source>
        <translation>nur als COMMAND_LONG angenommen</translation>
    </message>
    <message>
        <source>accepted as COMMAND_INT only</source>
        <translation>nur als COMMAND_INT angenommen</translation>
    </message>
    <message>
        <source>coordinate frame not supported</source>
        <translation>Koordinatenrahmen nicht unterstützt</translation>
    </message>
    <message>
        <source>this station is not in control</source>
        <translation>diese Station hat nicht die Kontrolle</translation>
    </message>
    <message>
        <source>the vehicle reports an error</source>
        <translation>das Fahrzeug meldet einen Fehler</translation>
    </message>
    <message>
        <source>command not supported</source>
        <translation>Befehl nicht unterstützt</translation>
    </message>
    <message>
        <source>no space left on the vehicle</source>
        <translation>kein Platz mehr auf dem Fahrzeug</translation>
    </message>
    <message>
        <source>an item is invalid</source>
        <translation>ein Wegpunkt ist ungültig</translation>
    </message>
    <message>
        <source>parameter 1 is invalid</source>
        <translation>Parameter 1 ist ungültig</translation>
    </message>
    <message>
        <source>parameter 2 is invalid</source>
        <translation>Parameter 2 ist ungültig</translation>
    </message>
    <message>
        <source>parameter 3 is invalid</source>
        <translation>Parameter 3 ist ungültig</translation>
    </message>
    <message>
        <source>parameter 4 is invalid</source>
        <translation>Parameter 4 ist ungültig</translation>
    </message>
    <message>
        <source>x (latitude) is invalid</source>
        <translation>x (Breite) ist ungültig</translation>
    </message>
    <message>
        <source>y (longitude) is invalid</source>
        <translation>y (Länge) ist ungültig</translation>
    </message>
    <message>
        <source>z (altitude) is invalid</source>
        <translation>z (Höhe) ist ungültig</translation>
    </message>
    <message>
        <source>an item arrived out of sequence</source>
        <translation>ein Wegpunkt kam außer der Reihe</translation>
    </message>
    <message>
        <source>not accepting missions from this station</source>
        <translation>nimmt von dieser Station keine Missionen an</translation>
    </message>
    <message>
        <source>the vehicle reports a failure</source>
        <translation>das Fahrzeug meldet einen Fehlschlag</translation>
    </message>
    <message>
        <source>the vehicle refuses the size</source>
        <translation>das Fahrzeug lehnt die Größe ab</translation>
    </message>
    <message>
        <source>the vehicle has closed the file</source>
        <translation>das Fahrzeug hat die Datei geschlossen</translation>
    </message>
    <message>
        <source>too many files are open on the vehicle</source>
        <translation>auf dem Fahrzeug sind zu viele Dateien offen</translation>
    </message>
    <message>
        <source>end of file</source>
        <translation>Ende der Datei</translation>
    </message>
    <message>
        <source>not supported by the vehicle</source>
        <translation>vom Fahrzeug nicht unterstützt</translation>
    </message>
    <message>
        <source>the file exists</source>
        <translation>die Datei existiert</translation>
    </message>
    <message>
        <source>the file is protected</source>
        <translation>die Datei ist geschützt</translation>
    </message>
    <message>
        <source>no such file or folder</source>
        <translation>keine solche Datei und kein solcher Ordner</translation>
    </message>
    <message>
        <source>the vehicle reports error %1</source>
        <translation>das Fahrzeug meldet den Fehler %1</translation>
    </message>
    <message>
        <source>the vehicle reports error code %1</source>
        <translation>das Fahrzeug meldet den Fehlercode %1</translation>
    </message>
    <message>
        <source>other programs used %1 % of a core</source>
        <translation>andere Programme belegten %1 % eines Kerns</translation>
    </message>
    <message>
        <source>the hypervisor took %1 % of a core</source>
        <translation>der Hypervisor nahm %1 % eines Kerns</translation>
    </message>
    <message>
        <source>the station&apos;s I/O thread had to give up its core %1 times a second</source>
        <translation>der E/A-Thread der Station musste seinen Kern %1-mal in der Sekunde abgeben</translation>
    </message>
    <message>
        <source>the agent had to give up its core %1 times a second</source>
        <translation>der Agent musste seinen Kern %1-mal in der Sekunde abgeben</translation>
    </message>
    <message>
        <source>the frequency of the cores differed by %1 % between begin and end</source>
        <translation>der Takt der Kerne unterschied sich zwischen Beginn und Ende um %1 %</translation>
    </message>
    <message>
        <source>the load average at the start was %1 per core</source>
        <translation>die mittlere Last zu Beginn betrug %1 je Kern</translation>
    </message>
    <message>
        <source>the load average at the end was %1 per core</source>
        <translation>die mittlere Last am Ende betrug %1 je Kern</translation>
    </message>
    <message>
        <source>the power of the idle machine differed by %1 % before and after</source>
        <translation>die Leistungsaufnahme des ruhenden Rechners unterschied sich vorher und nachher um %1 %</translation>
    </message>
    <message>
        <source>the processor was throttled %1 times</source>
        <translation>der Prozessor wurde %1-mal gedrosselt</translation>
    </message>
    <message>
        <source>the measurement itself took %1 % of the CPU time of the station&apos;s I/O thread</source>
        <translation>die Messung selbst nahm %1 % der CPU-Zeit des E/A-Threads der Station</translation>
    </message>
    <message>
        <source>the simulator (which makes the load) used %1 % of a core</source>
        <translation>der Simulator (der die Last erzeugt) belegte %1 % eines Kerns</translation>
    </message>
    <message>
        <source>up to %1 % under the %2 load</source>
        <translation>bis zu %1 % (%2)</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>A run is the difference of two readings, taken by the thread that is measured. Of its CPU time, taking and publishing readings was %1 (meter_cpu)</source>
        <translation>Ein Lauf ist die Differenz zweier Ablesungen durch den gemessenen Thread. Ablesen und Bekanntgeben machten von dessen CPU-Zeit %1 aus (meter_cpu)</translation>
    </message>
    <message>
        <source>up to %1</source>
        <translation>bis zu %1</translation>
    </message>
    <message>
        <source>%1 (1 run)</source>
        <translation>%1 (1 Lauf)</translation>
    </message>
    <message>
        <source>%1 (%2 runs)</source>
        <translation>%1 (%2 Läufe)</translation>
    </message>
    <message>
        <source>%1 of %2 runs were disturbed, so that their figures are noisier and may be wrong: %3</source>
        <translation>%1 von %2 Läufen wurden gestört; ihre Werte streuen stärker und können falsch sein: %3</translation>
    </message>
    <message>
        <source>was not found beside this program or in PATH</source>
        <translation>wurde weder neben diesem Programm noch in PATH gefunden</translation>
    </message>
    <message>
        <source>%1 could not be started: %2</source>
        <translation>%1 konnte nicht gestartet werden: %2</translation>
    </message>
    <message>
        <source>it was killed or crashed</source>
        <translation>abgestürzt oder gewaltsam beendet</translation>
    </message>
    <message>
        <source>exit status %1</source>
        <translation>Exit-Status %1</translation>
    </message>
    <message>
        <source>%1 ended by itself: %2</source>
        <translation>%1 hat sich von selbst beendet: %2</translation>
    </message>
    <message>
        <source>%1 ended by itself: %2 (%3)</source>
        <translation>%1 hat sich von selbst beendet: %2 (%3)</translation>
    </message>
    <message>
        <source>the generator of the load did not count its sends</source>
        <translation>der Lastgenerator hat nicht gezählt, was er gesendet hat</translation>
    </message>
    <message>
        <source>the generator missed %1 % of its sends</source>
        <translation>der Lastgenerator hat %1 % seiner Sendungen ausgelassen</translation>
    </message>
    <message>
        <source>%1 % of the line&apos;s rate</source>
        <translation>%1 % der Rate der Leitung</translation>
    </message>
    <message>
        <source>%1 % of the station&apos;s core</source>
        <translation>%1 % des Kerns der Station</translation>
    </message>
    <message>
        <source>%1 % of the agent&apos;s core</source>
        <translation>%1 % des Kerns des Agenten</translation>
    </message>
    <message>
        <source>not saturated: nothing reached %1 % (%2)</source>
        <translation>nicht gesättigt: nichts erreichte %1 % (%2)</translation>
    </message>
    <message>
        <source>the other end does not allow plain MAVLink</source>
        <translation>die Gegenseite lässt ungeschütztes MAVLink nicht zu</translation>
    </message>
    <message>
        <source>the other end does not allow inline framing</source>
        <translation>die Gegenseite lässt die Inline-Rahmung nicht zu</translation>
    </message>
    <message>
        <source>the vehicle&apos;s payloads could not be decrypted; is its key another one?</source>
        <translation>die Nutzdaten des Fahrzeugs ließen sich nicht entschlüsseln; hat es einen anderen Schlüssel?</translation>
    </message>
    <message>
        <source>This sweep is incomplete: it %1</source>
        <translation>Diese Messreihe ist unvollständig: sie %1</translation>
    </message>
    <message>
        <source>another suite came into use during the run</source>
        <translation>während des Laufs kam eine andere Chiffre in Gebrauch</translation>
    </message>
    <message>
        <source>the link fell silent</source>
        <translation>die Verbindung verstummte</translation>
    </message>
    <message>
        <source>the vehicle fell silent during the run</source>
        <translation>das Fahrzeug verstummte während des Laufs</translation>
    </message>
    <message>
        <source>the session did not last through the run</source>
        <translation>die Sitzung hielt nicht bis zum Ende des Laufs</translation>
    </message>
    <message>
        <source>the other end did not take this suite</source>
        <translation>die Gegenseite hat diese Chiffre nicht angenommen</translation>
    </message>
    <message>
        <source>the switch was not confirmed in time, %1 times</source>
        <translation>der Wechsel wurde %1-mal nicht rechtzeitig bestätigt</translation>
    </message>
    <message>
        <source>another switch took the place of this one, %1 times</source>
        <translation>ein anderer Wechsel kam diesem %1-mal zuvor</translation>
    </message>
    <message>
        <source>the station ended</source>
        <translation>die Station wurde beendet</translation>
    </message>
    <message>
        <source>no sealed session with a vehicle came up</source>
        <translation>es kam keine versiegelte Sitzung mit einem Fahrzeug zustande</translation>
    </message>
    <message>
        <source>no vehicle was heard in plain MAVLink; do both ends allow it?</source>
        <translation>in ungeschütztem MAVLink war kein Fahrzeug zu hören; lassen es beide Seiten zu?</translation>
    </message>
    <message>
        <source>only the sweep&apos;s own simulator encrypts payloads with a bare cipher</source>
        <translation>nur der eigene Simulator der Messreihe verschlüsselt Nutzdaten mit einer Chiffre ohne Rahmung</translation>
    </message>
    <message>
        <source>given up after %1 runs in a row that failed; the last one: %2</source>
        <translation>nach %1 fehlgeschlagenen Läufen in Folge aufgegeben; der letzte: %2</translation>
    </message>
    <message>
        <source>was given up or cancelled after its last run</source>
        <translation>wurde nach dem letzten Lauf aufgegeben oder abgebrochen</translation>
    </message>
    <message>
        <source>ended after %1 of %2 runs</source>
        <translation>endete nach %1 von %2 Läufen</translation>
    </message>
    <message>
        <source>%1 (%2 load, link %3): %4</source>
        <translation>%1 (%2, Verbindung „%3“): %4</translation>
    </message>
    <message>
        <source>%1 (%2 load): %3</source>
        <translation>%1 (%2): %3</translation>
    </message>
    <message>
        <source>1 of 1 run failed: %1</source>
        <translation>1 von 1 Lauf schlug fehl: %1</translation>
    </message>
    <message>
        <source>%1 of %2 runs failed: %3</source>
        <translation>%1 von %2 Läufen schlugen fehl: %3</translation>
    </message>
    <message>
        <source>%1 of %2 runs are not valid and left out of every comparison; the first of them, %3 (%4 load): %5</source>
        <translation>%1 von %2 Läufen sind nicht gültig und in keinem Vergleich enthalten; der erste davon, %3 (%4): %5</translation>
    </message>
    <message>
        <source>this is not JSON: %1</source>
        <translation>kein gültiges JSON: %1</translation>
    </message>
    <message>
        <source>this is not XML: %1</source>
        <translation>kein gültiges XML: %1</translation>
    </message>
    <message>
        <source>a field&apos;s name (%1)</source>
        <translation>der Name eines Felds (%1)</translation>
    </message>
    <message>
        <source>one of &gt;= &lt;= &gt; &lt; == !=</source>
        <translation>eines von &gt;= &lt;= &gt; &lt; == !=</translation>
    </message>
    <message>
        <source>== or !=, since %1 is a text</source>
        <translation>== oder !=, denn %1 ist ein Text</translation>
    </message>
    <message>
        <source>a value to compare %1 with</source>
        <translation>ein Wert, mit dem %1 verglichen wird</translation>
    </message>
    <message>
        <source>a number to compare %1 with</source>
        <translation>eine Zahl, mit der %1 verglichen wird</translation>
    </message>
    <message>
        <source>the end of the condition</source>
        <translation>das Ende der Bedingung</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>nichts</translation>
    </message>
    <message>
        <source>the end of the step</source>
        <translation>das Ende des Schritts</translation>
    </message>
    <message>
        <source>expected %1, found %2</source>
        <translation>erwartet: %1; gefunden: %2</translation>
    </message>
    <message>
        <source>step %1: %2</source>
        <translation>Schritt %1: %2</translation>
    </message>
    <message>
        <source>no PNG and PDF: skyseal-figures is not installed; report.html and the SVG files have the same content</source>
        <translation>kein PNG und PDF: skyseal-figures ist nicht installiert; report.html und die SVG-Dateien haben denselben Inhalt</translation>
    </message>
    <message>
        <source>PNG and PDF could not be drawn by %1</source>
        <translation>PNG und PDF konnten von %1 nicht gezeichnet werden</translation>
    </message>
    <message>
        <source>the folder cannot be created</source>
        <translation>der Ordner kann nicht angelegt werden</translation>
    </message>
    <message>
        <source>a key is 32 bytes, or 64 hex digits</source>
        <translation>ein Schlüssel hat 32 Byte oder 64 Hexadezimalziffern</translation>
    </message>
    <message>
        <source>%1 hex digits are expected as nonce</source>
        <translation>als Nonce werden %1 Hexadezimalziffern erwartet</translation>
    </message>
    <message>
        <source>the library refuses the cipher</source>
        <translation>die Bibliothek lehnt die Chiffre ab</translation>
    </message>
    <message>
        <source>a system ID and a public key in hex are expected</source>
        <translation>erwartet werden eine System-ID und ein öffentlicher Schlüssel in Hexadezimalziffern</translation>
    </message>
    <message>
        <source>sysid=&apos;%1&apos;: a system ID from 1 to 255 is expected</source>
        <translation>sysid=&apos;%1&apos;: erwartet wird eine System-ID von 1 bis 255</translation>
    </message>
    <message>
        <source>from=&apos;%1&apos;: ADDRESS/PREFIX is expected</source>
        <translation>from=&apos;%1&apos;: erwartet wird ADRESSE/PRÄFIX</translation>
    </message>
    <message>
        <source>name=&apos;%1&apos;: a name of printable characters is expected</source>
        <translation>name=&apos;%1&apos;: erwartet wird ein Name aus druckbaren Zeichen</translation>
    </message>
    <message>
        <source>&apos;%1&apos;: write, from, sysid or name is expected</source>
        <translation>„%1“: write, from, sysid oder name wird erwartet</translation>
    </message>
    <message>
        <source>%1 is given twice</source>
        <translation>%1 ist zweimal angegeben</translation>
    </message>
    <message>
        <source>&apos;%1&apos;: OPTION=VALUE is expected</source>
        <translation>„%1“: OPTION=WERT wird erwartet</translation>
    </message>
    <message>
        <source>&apos;%1&apos;: clients are served over UDP or TCP</source>
        <translation>„%1“: Clients werden über UDP oder TCP bedient</translation>
    </message>
    <message>
        <source>from=: &apos;%1&apos; serves the host of its URL alone; from= is for links that listen</source>
        <translation>from=: „%1“ bedient allein den Host seiner URL; from= ist für Verbindungen, die lauschen</translation>
    </message>
    <message>
        <source>write=&apos;%1&apos;: none, all, or mission, param, command, ftp and rc are expected</source>
        <translation>write=&apos;%1&apos;: erwartet wird none, all oder mission, param, command, ftp und rc</translation>
    </message>
    <message>
        <source>natural</source>
        <translation>natürliche Last</translation>
    </message>
    <message>
        <source>saturated</source>
        <translation>Volllast</translation>
    </message>
    <message>
        <source>pps%1</source>
        <translation>Last von %1 Frames/s</translation>
    </message>
    <message>
        <source>none</source>
        <translation>ungeschütztes MAVLink</translation>
    </message>
    <message>
        <source>%1 inline</source>
        <translation>%1 inline</translation>
    </message>
    <message>
        <source>%1 bare</source>
        <translation>%1 ohne Rahmung</translation>
    </message>
    <message>
        <source>%1 sealed</source>
        <translation>%1 versiegelt</translation>
    </message>
    <message>
        <source>%1 (A/A)</source>
        <translation>%1 (A/A)</translation>
    </message>
    <message>
        <source>%1, %2 load, %3 % for each run</source>
        <translation>%1, %2, %3 % je Lauf</translation>
    </message>
    <message>
        <source>values change with the order of the runs within a launch, so that the warm-up was too short or the machine drifts: %1</source>
        <translation>die Werte ändern sich mit der Reihenfolge der Läufe innerhalb eines Starts; das Aufwärmen war zu kurz, oder der Rechner driftet: %1</translation>
    </message>
    <message>
        <source>this build is %1</source>
        <translation>dieser Build ist %1</translation>
    </message>
    <message>
        <source>the machine was busy with other work: load average %1 on %2 cores at the start; the figures are noisier and may be wrong</source>
        <translation>der Rechner war mit anderer Arbeit beschäftigt: mittlere Last %1 auf %2 Kernen zu Beginn; die Werte streuen stärker und können falsch sein</translation>
    </message>
    <message>
        <source>not optimised: the figures of this build are not meaningful</source>
        <translation>nicht optimiert: Seine Werte sind nicht aussagekräftig</translation>
    </message>
    <message>
        <source>optimised by %1 alone, as for tests: the figures are higher than those of a release</source>
        <translation>nur mit %1 optimiert, wie für Tests: Die Werte sind höher als die eines Releases</translation>
    </message>
    <message>
        <source>it contains no MAVLink frame</source>
        <translation>sie enthält keinen MAVLink-Frame</translation>
    </message>
    <message>
        <source>a position has two or three numbers, not %1</source>
        <translation>eine Position hat zwei oder drei Zahlen, nicht %1</translation>
    </message>
    <message>
        <source>&quot;%1&quot; has %2 numbers; a position has two or three, with decimal points</source>
        <translation>„%1“ hat %2 Zahlen; eine Position hat zwei oder drei, mit Dezimalpunkten</translation>
    </message>
    <message>
        <source>&quot;%1&quot; has a decimal comma; numbers in files have a point</source>
        <translation>„%1“ hat ein Dezimalkomma; Zahlen in Dateien haben einen Punkt</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a number</source>
        <translation>„%1“ ist keine Zahl</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a whole number from 0 to %2</source>
        <translation>„%1“ ist keine ganze Zahl von 0 bis %2</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a latitude from -90 to 90</source>
        <translation>„%1“ ist keine Breite von -90 bis 90</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a longitude from -180 to 180</source>
        <translation>„%1“ ist keine Länge von -180 bis 180</translation>
    </message>
    <message>
        <source>version %1 of mission files is not known, only 110 and 120</source>
        <translation>die Version %1 von Missionsdateien ist nicht bekannt, nur 110 und 120</translation>
    </message>
    <message>
        <source>this is a plan in JSON; mission files begin with &quot;QGC WPL 110&quot;</source>
        <translation>das ist ein Plan in JSON; Missionsdateien beginnen mit „QGC WPL 110“</translation>
    </message>
    <message>
        <source>item %1 stands where item %2 is expected</source>
        <translation>der Wegpunkt %1 steht, wo der Wegpunkt %2 erwartet wird</translation>
    </message>
    <message>
        <source>the file has no items after its first line</source>
        <translation>die Datei hat nach ihrer ersten Zeile keine Wegpunkte</translation>
    </message>
    <message>
        <source>a name and a value, or QGroundControl&apos;s five columns, are expected, not &quot;%1&quot;</source>
        <translation>erwartet werden ein Name und ein Wert oder die fünf Spalten von QGroundControl, nicht „%1“</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a name of at most 16 letters, digits and signs</source>
        <translation>„%1“ ist kein Name aus höchstens 16 Buchstaben, Ziffern und Zeichen</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a component from 1 to 255</source>
        <translation>„%1“ ist keine Komponente von 1 bis 255</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a type of parameters</source>
        <translation>„%1“ ist kein Typ von Parametern</translation>
    </message>
    <message>
        <source>not a parameter file: %1 lines before this one cannot be read</source>
        <translation>keine Parameterdatei: %1 Zeilen vor dieser sind nicht lesbar</translation>
    </message>
    <message>
        <source>%1 occurs again; this line counts</source>
        <translation>%1 kommt noch einmal vor; diese Zeile gilt</translation>
    </message>
    <message>
        <source>item %1, %2: %3</source>
        <translation>Wegpunkt %1, %2: %3</translation>
    </message>
    <message>
        <source>parameters 5 and 6 are too large for the mission protocol</source>
        <translation>die Parameter 5 und 6 sind zu groß für das Missionsprotokoll</translation>
    </message>
    <message>
        <source>the mission protocol carries parameters 5 and 6 of this command as whole numbers only</source>
        <translation>das Missionsprotokoll überträgt die Parameter 5 und 6 dieses Kommandos nur als ganze Zahlen</translation>
    </message>
    <message>
        <source>this vehicle keeps its home position as item 0, which the mission lacked: it was inserted, and the items moved up by one</source>
        <translation>dieses Fahrzeug hält als Wegpunkt 0 seine Home-Position, die der Mission fehlte: sie wurde eingefügt, und die Wegpunkte rückten um eins auf</translation>
    </message>
    <message>
        <source>this vehicle keeps its home position as item 0, so that it does not fly to the first waypoint of the mission</source>
        <translation>dieses Fahrzeug hält als Wegpunkt 0 seine Home-Position, so dass es den ersten Wegpunkt der Mission nicht anfliegt</translation>
    </message>
    <message>
        <source>item 0 looks like the home position of an ArduPilot mission: this vehicle flies to it as its first waypoint</source>
        <translation>der Wegpunkt 0 sieht wie die Home-Position einer Mission von ArduPilot aus: dieses Fahrzeug fliegt ihn als ersten an</translation>
    </message>
    <message>
        <source>the first item is the home position of a mission, which has no place in a list of this kind: it was left out</source>
        <translation>der erste Punkt ist die Home-Position einer Mission, die in eine Liste dieser Art nicht gehört: er wurde weggelassen</translation>
    </message>
    <message>
        <source>another component turned out to be the autopilot; request it again</source>
        <translation>eine andere Komponente ist der Autopilot; bitte erneut anfordern</translation>
    </message>
    <message>
        <source>an item has 12 columns, this line has %1 or more</source>
        <translation>ein Wegpunkt hat 12 Spalten, diese Zeile hat %1 oder mehr</translation>
    </message>
    <message>
        <source>the only item is the home position of a mission; to remove what the vehicle has, clear its list</source>
        <translation>der einzige Punkt ist die Home-Position einer Mission; um zu entfernen, was das Fahrzeug hat, ist seine Liste zu leeren</translation>
    </message>
    <message>
        <source>the autopilot does not say that the mission protocol reaches its fence: it could take this for its mission</source>
        <translation>der Autopilot gibt nicht an, dass das Missionsprotokoll seinen Geofence erreicht: Er könnte dies für seine Mission halten</translation>
    </message>
    <message>
        <source>the autopilot does not say that the mission protocol reaches its rally points: it could take this for its mission</source>
        <translation>der Autopilot gibt nicht an, dass das Missionsprotokoll seine Rally-Punkte erreicht: Er könnte dies für seine Mission halten</translation>
    </message>
    <message>
        <source>the autopilot does not answer what it can do (AUTOPILOT_VERSION): it could take this for its mission</source>
        <translation>der Autopilot antwortet nicht, was er kann (AUTOPILOT_VERSION): Er könnte dies für seine Mission halten</translation>
    </message>
    <message>
        <source>changed by another station</source>
        <translation>von einer anderen Station geändert</translation>
    </message>
    <message>
        <source>changed by another station: %1 items instead of %2</source>
        <translation>von einer anderen Station geändert: %1 Punkte statt %2</translation>
    </message>
    <message>
        <source>a transfer to the vehicle was not completed</source>
        <translation>eine Übertragung zum Fahrzeug wurde nicht abgeschlossen</translation>
    </message>
    <message>
        <source>what the vehicle has was %1; read it again, or overwrite it</source>
        <translation>was das Fahrzeug hat, wurde %1; es ist neu zu lesen oder zu überschreiben</translation>
    </message>
    <message>
        <source>the vehicle has other items than those that were edited: another station changed them; they were read again</source>
        <translation>das Fahrzeug hat andere Punkte als die bearbeiteten: Eine andere Station hat sie geändert; sie wurden neu gelesen</translation>
    </message>
    <message>
        <source>%1 % of the frames came from another vehicle, which the costs contain</source>
        <translation>%1 % der Frames kamen von einem anderen Fahrzeug, dessen Aufwand in den Kosten steckt</translation>
    </message>
    <message>
        <source>the vehicle speaks MAVLink 1, which knows missions only; fences and rally points need MAVLink 2</source>
        <translation>das Fahrzeug spricht MAVLink 1, das nur Missionen kennt; Geofences und Rally-Punkte brauchen MAVLink 2</translation>
    </message>
    <message>
        <source>only %1 of %2 parameters came: %3</source>
        <translation>nur %1 von %2 Parametern kamen an: %3</translation>
    </message>
    <message>
        <source>of component %1 only %2 of %3 parameters came</source>
        <translation>von Komponente %1 kamen nur %2 von %3 Parametern an</translation>
    </message>
    <message>
        <source>%1 does not fit the parameter, which takes %2 to %3</source>
        <translation>%1 passt nicht zum Parameter, der %2 bis %3 annimmt</translation>
    </message>
    <message>
        <source>%1 does not fit the parameter, which takes whole numbers</source>
        <translation>%1 passt nicht zum Parameter, der ganze Zahlen annimmt</translation>
    </message>
    <message>
        <source>this vehicle takes whole numbers as floats, which cannot hold %1; the nearest is %2</source>
        <translation>dieses Fahrzeug nimmt ganze Zahlen als Gleitkommazahlen, die %1 nicht darstellen können; die nächste ist %2</translation>
    </message>
    <message>
        <source>the vehicle has no such parameter</source>
        <translation>das Fahrzeug hat keinen solchen Parameter</translation>
    </message>
    <message>
        <source>the vehicle refuses the value: it is out of range</source>
        <translation>das Fahrzeug lehnt den Wert ab: er liegt außerhalb des Bereichs</translation>
    </message>
    <message>
        <source>the vehicle denies the permission</source>
        <translation>das Fahrzeug verweigert die Erlaubnis</translation>
    </message>
    <message>
        <source>the vehicle has no such component</source>
        <translation>das Fahrzeug hat keine solche Komponente</translation>
    </message>
    <message>
        <source>the parameter is read-only</source>
        <translation>der Parameter ist schreibgeschützt</translation>
    </message>
    <message>
        <source>the vehicle does not support the type of the parameter</source>
        <translation>das Fahrzeug unterstützt den Typ des Parameters nicht</translation>
    </message>
    <message>
        <source>the vehicle has the parameter with another type</source>
        <translation>das Fahrzeug hat den Parameter mit einem anderen Typ</translation>
    </message>
    <message>
        <source>the vehicle cannot read the parameter</source>
        <translation>das Fahrzeug kann den Parameter nicht lesen</translation>
    </message>
    <message>
        <source>the vehicle refuses it with error %1</source>
        <translation>das Fahrzeug lehnt es mit Fehler %1 ab</translation>
    </message>
    <message>
        <source>the vehicle was not ready for it, and is in %1 now</source>
        <translation>das Fahrzeug war nicht dafür bereit und ist jetzt in %1</translation>
    </message>
    <message>
        <source>the mode %1 was not entered: %2</source>
        <translation>der Modus %1 wurde nicht eingenommen: %2</translation>
    </message>
    <message>
        <source>the vehicle was not armed: %1</source>
        <translation>das Fahrzeug wurde nicht scharfgeschaltet: %1</translation>
    </message>
    <message>
        <source>%1; the vehicle is armed</source>
        <translation>%1; das Fahrzeug ist scharf</translation>
    </message>
    <message>
        <source>a mission needs an armed vehicle to start, it is disarmed</source>
        <translation>eine Mission braucht zum Start ein scharfes Fahrzeug, es ist unscharf</translation>
    </message>
    <message>
        <source>a plane without vertical take-off takes off in the mode TAKEOFF, or in a mission</source>
        <translation>ein Flugzeug, das nicht senkrecht startet, hebt im Modus TAKEOFF oder in einer Mission ab</translation>
    </message>
    <message>
        <source>the vehicle is in the air; only an emergency stop ends its motors</source>
        <translation>das Fahrzeug ist in der Luft; nur Not-Aus hält seine Motoren an</translation>
    </message>
    <message>
        <source>a plane without vertical take-off lands in a mission, or by hand</source>
        <translation>ein Flugzeug, das nicht senkrecht startet, landet in einer Mission oder von Hand</translation>
    </message>
    <message>
        <source>this kind of vehicle flies no missions</source>
        <translation>diese Art von Fahrzeug fliegt keine Missionen</translation>
    </message>
</context>
<context>
    <name>Sweep</name>
    <message>
        <source>nothing is connected</source>
        <translation>nichts ist verbunden</translation>
    </message>
    <message>
        <source>the link is not sealed</source>
        <translation>die Verbindung ist nicht versiegelt</translation>
    </message>
    <message>
        <source>the link is silent</source>
        <translation>die Verbindung ist stumm</translation>
    </message>
    <message>
        <source>missing on this machine</source>
        <translation>fehlt auf diesem Rechner</translation>
    </message>
    <message>
        <source>not in this build</source>
        <translation>in diesem Build nicht enthalten</translation>
    </message>
    <message>
        <source>the settings require sealing</source>
        <translation>die Einstellungen verlangen Versiegelung</translation>
    </message>
    <message>
        <source>no sealed link yet</source>
        <translation>noch keine versiegelte Verbindung</translation>
    </message>
    <message>
        <source>the agent does not allow it (skyseal-air --allow-plain)</source>
        <translation>der Agent lässt es nicht zu (skyseal-air --allow-plain)</translation>
    </message>
    <message>
        <source>not while the vehicle is armed</source>
        <translation>nicht, solange das Fahrzeug scharf ist</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>inline</source>
        <translation>inline</translation>
    </message>
    <message>
        <source>bare, insecure</source>
        <translation>bare, unsicher</translation>
    </message>
    <message>
        <source>sealed</source>
        <translation>versiegelt</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>%1 (A/A)</source>
        <translation>%1 (A/A)</translation>
    </message>
    <message>
        <source>natural load</source>
        <translation>natürliche Last</translation>
    </message>
    <message>
        <source>saturated load</source>
        <translation>Volllast</translation>
    </message>
    <message>
        <source>clean link</source>
        <translation>ungestörte Verbindung</translation>
    </message>
    <message>
        <source>about %1 s</source>
        <translation>etwa %1 s</translation>
    </message>
    <message>
        <source>about %1 min %2 s</source>
        <translation>etwa %1 min %2 s</translation>
    </message>
    <message>
        <source>%1 baud</source>
        <translation>%1 Baud</translation>
    </message>
    <message>
        <source>%1 % loss</source>
        <translation>%1 % Verlust</translation>
    </message>
    <message>
        <source>%1 % duplicates</source>
        <translation>%1 % Duplikate</translation>
    </message>
    <message>
        <source>%1 % reordered</source>
        <translation>%1 % vertauscht</translation>
    </message>
    <message>
        <source>%1 % corrupted</source>
        <translation>%1 % verfälscht</translation>
    </message>
    <message>
        <source>%1 ms delay</source>
        <translation>%1 ms Verzögerung</translation>
    </message>
    <message>
        <source>up to %1 ms jitter</source>
        <translation>bis zu %1 ms Jitter</translation>
    </message>
    <message>
        <source>no impairment</source>
        <translation>ohne Störung</translation>
    </message>
    <message>
        <source>other links would be measured as well: keep only one sealed link open</source>
        <translation>andere Verbindungen würden mitgemessen: nur eine versiegelte Verbindung offen lassen</translation>
    </message>
    <message>
        <source>the connected link is measured as it is</source>
        <translation>die bestehende Verbindung wird so gemessen, wie sie ist</translation>
    </message>
    <message>
        <source>the load of a connected vehicle cannot be changed</source>
        <translation>die Last eines verbundenen Fahrzeugs lässt sich nicht ändern</translation>
    </message>
    <message>
        <source>the autopilot sets its own rates</source>
        <translation>der Autopilot bestimmt seine Raten selbst</translation>
    </message>
    <message>
        <source>%1 (%2 to %3)</source>
        <translation>%1 (%2 bis %3)</translation>
    </message>
    <message>
        <source>Ratios to plain MAVLink</source>
        <translation>Verhältnisse zu ungeschütztem MAVLink</translation>
    </message>
    <message>
        <source>Ratios to %1</source>
        <translation>Verhältnisse zu %1</translation>
    </message>
    <message>
        <source>load of %1 frames/s</source>
        <translation>Last von %1 Frames/s</translation>
    </message>
    <message>
        <source>frames/s</source>
        <translation>Frames/s</translation>
    </message>
    <message>
        <source>not in this framing</source>
        <translation>nicht in dieser Rahmung</translation>
    </message>
</context>
<context>
    <name>skyseal::app::Application</name>
    <message>
        <source>No sealed links: %1</source>
        <translation>Keine versiegelte Verbindung: %1</translation>
    </message>
    <message>
        <source>Enter the passphrase</source>
        <translation>Passphrase eingeben</translation>
    </message>
    <message>
        <source>The list of peers cannot be used; the previous list stays in force: %1</source>
        <translation>Die Liste der Gegenstellen ist nicht verwendbar; die bisherige Liste gilt weiter: %1</translation>
    </message>
    <message>
        <source>Ignored entries in the list of peers: %1</source>
        <translation>Ignorierte Einträge in der Liste der Gegenstellen: %1</translation>
    </message>
    <message>
        <source>The system does not report changes to the list of peers; it is checked once a second</source>
        <translation>Das System meldet keine Änderungen an der Liste der Gegenstellen; sie wird einmal pro Sekunde geprüft</translation>
    </message>
    <message>
        <source>Restart the demo</source>
        <translation>Demo neu starten</translation>
    </message>
</context>
<context>
    <name>skyseal::app::Demo</name>
    <message>
        <source>it was killed or crashed</source>
        <translation>abgestürzt oder gewaltsam beendet</translation>
    </message>
    <message>
        <source>exit status %1</source>
        <translation>Exit-Status %1</translation>
    </message>
    <message>
        <source>The demo needs %1, which was not found beside this program or in PATH.</source>
        <translation>Die Demo braucht %1; es wurde weder neben diesem Programm noch im PATH gefunden.</translation>
    </message>
    <message>
        <source>The demo&apos;s %1 exited: %2</source>
        <translation>%1 der Demo wurde beendet: %2</translation>
    </message>
    <message>
        <source>The demo&apos;s %1 could not be started: %2</source>
        <translation>%1 der Demo konnte nicht gestartet werden: %2</translation>
    </message>
</context>
<context>
    <name>skyseal::app::DesktopKeyring</name>
    <message>
        <source>there is no desktop session</source>
        <translation>es gibt keine Desktop-Sitzung</translation>
    </message>
    <message>
        <source>The keyring did not store the passphrase: %1</source>
        <translation>Der Schlüsselbund hat die Passphrase nicht gespeichert: %1</translation>
    </message>
    <message>
        <source>The keyring did not delete the passphrase: %1</source>
        <translation>Der Schlüsselbund hat die Passphrase nicht gelöscht: %1</translation>
    </message>
    <message>
        <source>no keyring is running in this desktop session</source>
        <translation>in dieser Desktop-Sitzung läuft kein Schlüsselbund</translation>
    </message>
</context>
<context>
    <name>skyseal::app::NoMemory</name>
    <message>
        <source>not included in this build</source>
        <translation>in diesem Build nicht enthalten</translation>
    </message>
</context>
<context>
    <name>skyseal::app::SweepController</name>
    <message>
        <source>skyseal-sim, skyseal-air or skyseal-cli is not installed</source>
        <translation>skyseal-sim, skyseal-air oder skyseal-cli ist nicht installiert</translation>
    </message>
    <message>
        <source>the station is not running</source>
        <translation>die Station läuft nicht</translation>
    </message>
</context>
<context>
    <name>skyseal::app::WindowPairing</name>
    <message>
        <source>the station is not running</source>
        <translation>die Station läuft nicht</translation>
    </message>
</context>
<context>
    <name>skyseal::engine::AgentEventText</name>
    <message>
        <source>Ground side: %1</source>
        <translation>Bodenseite: %1</translation>
    </message>
    <message>
        <source>Vehicle side: %1</source>
        <translation>Fahrzeugseite: %1</translation>
    </message>
    <message>
        <source>message %1</source>
        <translation>Nachricht %1</translation>
    </message>
    <message>
        <source>one request</source>
        <translation>eine Anfrage</translation>
    </message>
    <message>
        <source>%1 requests</source>
        <translation>%1 Anfragen</translation>
    </message>
    <message>
        <source>one frame</source>
        <translation>ein Frame</translation>
    </message>
    <message>
        <source>%1 frames</source>
        <translation>%1 Frames</translation>
    </message>
    <message>
        <source>Refused %1 from %2, which is an observer: %3</source>
        <translation>Abgelehnt: %1 von %2 (Beobachter): %3</translation>
    </message>
    <message>
        <source>Refused %1 from %2, which sends requests too often: %3</source>
        <translation>Abgelehnt: %1 von %2 (fragt zu häufig an): %3</translation>
    </message>
    <message>
        <source>Refused %1 from %2, received too late: %3</source>
        <translation>Abgelehnt: %1 von %2 (zu spät empfangen): %3</translation>
    </message>
    <message>
        <source>The vehicle signs its messages with the key of this agent</source>
        <translation>Das Fahrzeug signiert seine Nachrichten mit dem Schlüssel dieses Agenten</translation>
    </message>
    <message>
        <source>most recently %1</source>
        <translation>zuletzt %1</translation>
    </message>
    <message>
        <source>A device on the vehicle side uses system ID %1 of a ground station and is ignored; an autopilot needs a different ID</source>
        <translation>Ein Gerät auf der Fahrzeugseite verwendet die System-ID %1 einer Bodenstation und wird ignoriert; ein Autopilot braucht eine andere ID</translation>
    </message>
    <message>
        <source>Handshake counters can be stored again</source>
        <translation>Handshake-Zähler lassen sich wieder speichern</translation>
    </message>
    <message>
        <source>Handshake counters cannot be stored: %1. The links stay up. If this agent restarts now, it will answer replayed handshakes, but they cannot establish a session</source>
        <translation>Handshake-Zähler lassen sich nicht speichern: %1. Die Verbindungen bleiben bestehen. Startet dieser Agent jetzt neu, beantwortet er wiedereingespielte Handshakes; eine Sitzung entsteht daraus nicht</translation>
    </message>
    <message>
        <source>Refused %1 from %2, which is not permitted to use that system ID: %3</source>
        <translation>Abgelehnt: %1 von %2 (darf diese System-ID nicht verwenden): %3</translation>
    </message>
    <message>
        <source>Refused %1 without a signature on the vehicle side. If the vehicle sent them, set up its signing: skyseal-air --signing setup</source>
        <translation>Abgelehnt: %1 ohne Signatur auf der Fahrzeugseite. Falls vom Fahrzeug gesendet, dessen Signieren einrichten: skyseal-air --signing setup</translation>
    </message>
    <message>
        <source>Refused %1 on the vehicle side, not signed with the key of this agent</source>
        <translation>Abgelehnt: %1 auf der Fahrzeugseite, nicht mit dem Schlüssel dieses Agenten signiert</translation>
    </message>
    <message>
        <source>Refused %1 on the vehicle side with an old signature: a replay, or the vehicle lost its signing time, which recovers automatically</source>
        <translation>Abgelehnt: %1 auf der Fahrzeugseite mit alter Signatur: eine Wiedereinspielung, oder das Fahrzeug hat seine Signierzeit verloren, was sich von selbst behebt</translation>
    </message>
    <message>
        <source>Did not forward %1 from stations: MAVLink 1 cannot be signed</source>
        <translation>Nicht weitergeleitet: %1 von Stationen; MAVLink 1 lässt sich nicht signieren</translation>
    </message>
    <message>
        <source>Did not forward %1 from stations: only this agent may change the vehicle&apos;s signing key</source>
        <translation>Nicht weitergeleitet: %1 von Stationen; nur dieser Agent darf den Signierschlüssel des Fahrzeugs ändern</translation>
    </message>
    <message>
        <source>Did not forward %1 from stations: the vehicle cannot track more signing senders until it restarts</source>
        <translation>Nicht weitergeleitet: %1 von Stationen; das Fahrzeug kann sich bis zum Neustart keine weiteren signierenden Absender merken</translation>
    </message>
    <message>
        <source>The signing timestamp cannot be stored: %1. Signing continues</source>
        <translation>Der Zeitstempel der Signaturen lässt sich nicht speichern: %1. Das Signieren geht weiter</translation>
    </message>
</context>
<context>
    <name>skyseal::engine::EventText</name>
    <message>
        <source>Link to the vehicle lost</source>
        <translation>Verbindung zum Fahrzeug verloren</translation>
    </message>
    <message>
        <source>Link to the vehicle recovered</source>
        <translation>Verbindung zum Fahrzeug wiederhergestellt</translation>
    </message>
    <message>
        <source>The agent %1 at %2 has answered or is no longer heard</source>
        <translation>Der Agent %1 unter %2 hat geantwortet oder wird nicht mehr empfangen</translation>
    </message>
    <message>
        <source>The agent %1 at %2 announces itself but does not answer: does it know this station&apos;s key? %3</source>
        <translation>Der Agent %1 unter %2 meldet sich, antwortet aber nicht: Kennt er den Schlüssel dieser Station? %3</translation>
    </message>
    <message>
        <source>Not recording to %1: %2</source>
        <translation>Keine Aufzeichnung in %1: %2</translation>
    </message>
    <message>
        <source>Fence</source>
        <translation>Geofence</translation>
    </message>
    <message>
        <source>Rally points</source>
        <translation>Rally-Punkte</translation>
    </message>
    <message>
        <source>Mission</source>
        <translation>Mission</translation>
    </message>
    <message>
        <source>%1 sent</source>
        <translation>%1: gesendet</translation>
    </message>
    <message>
        <source>%1 read</source>
        <translation>%1: gelesen</translation>
    </message>
    <message>
        <source>%1 cleared</source>
        <translation>%1: gelöscht</translation>
    </message>
    <message>
        <source>%1 not sent: %2</source>
        <translation>%1: nicht gesendet: %2</translation>
    </message>
    <message>
        <source>%1 not read: %2</source>
        <translation>%1: nicht gelesen: %2</translation>
    </message>
    <message>
        <source>%1 not cleared: %2</source>
        <translation>%1: nicht gelöscht: %2</translation>
    </message>
    <message>
        <source>Parameters read</source>
        <translation>Parameter gelesen</translation>
    </message>
    <message>
        <source>Parameter %1 is %2</source>
        <translation>Parameter %1 ist %2</translation>
    </message>
    <message>
        <source>Parameter %1 not read: %2</source>
        <translation>Parameter %1 nicht gelesen: %2</translation>
    </message>
    <message>
        <source>List of logs read</source>
        <translation>Liste der Logs gelesen</translation>
    </message>
    <message>
        <source>List of logs not read: %1</source>
        <translation>Liste der Logs nicht gelesen: %1</translation>
    </message>
    <message>
        <source>Log %1 read</source>
        <translation>Log %1 gelesen</translation>
    </message>
    <message>
        <source>Log %1 not read: %2</source>
        <translation>Log %1 nicht gelesen: %2</translation>
    </message>
    <message>
        <source>Logs erased</source>
        <translation>Logs gelöscht</translation>
    </message>
    <message>
        <source>Logs not erased: %1</source>
        <translation>Logs nicht gelöscht: %1</translation>
    </message>
    <message>
        <source>Folder %1 listed</source>
        <translation>Ordner %1 aufgelistet</translation>
    </message>
    <message>
        <source>File %1 read</source>
        <translation>Datei %1 gelesen</translation>
    </message>
    <message>
        <source>File %1 written</source>
        <translation>Datei %1 geschrieben</translation>
    </message>
    <message>
        <source>File %1 removed</source>
        <translation>Datei %1 gelöscht</translation>
    </message>
    <message>
        <source>Folder %1 not listed: %2</source>
        <translation>Ordner %1 nicht aufgelistet: %2</translation>
    </message>
    <message>
        <source>File %1 not read: %2</source>
        <translation>Datei %1 nicht gelesen: %2</translation>
    </message>
    <message>
        <source>File %1 not written: %2</source>
        <translation>Datei %1 nicht geschrieben: %2</translation>
    </message>
    <message>
        <source>File %1 not removed: %2</source>
        <translation>Datei %1 nicht gelöscht: %2</translation>
    </message>
    <message>
        <source>Parameters not read: %1</source>
        <translation>Parameter nicht gelesen: %1</translation>
    </message>
    <message>
        <source>Parameter %1 is now %2</source>
        <translation>Parameter %1 ist jetzt %2</translation>
    </message>
    <message>
        <source>Parameter %1 not written: %2</source>
        <translation>Parameter %1 nicht geschrieben: %2</translation>
    </message>
    <message>
        <source>Sealed link to %1 at %2 is up with %3</source>
        <translation>Versiegelte Verbindung zu %1 unter %2 steht, Chiffre %3</translation>
    </message>
    <message>
        <source>Sealed link to %1 ended: %2</source>
        <translation>Versiegelte Verbindung zu %1 beendet: %2</translation>
    </message>
    <message>
        <source>The address of %1 changed to %2</source>
        <translation>Neue Adresse von %1: %2</translation>
    </message>
    <message>
        <source>Switching from %1 to %2</source>
        <translation>Wechsel von %1 zu %2</translation>
    </message>
    <message>
        <source>Switch to %1 rolled back: %2</source>
        <translation>Wechsel zu %1 zurückgenommen: %2</translation>
    </message>
    <message>
        <source>Switched from %1 to %2, epoch %3, in %4</source>
        <translation>Gewechselt von %1 zu %2, Epoche %3, in %4</translation>
    </message>
    <message>
        <source>Refused a handshake from %1: %2</source>
        <translation>Handshake von %1 abgelehnt: %2</translation>
    </message>
    <message>
        <source>%1 (key %2)</source>
        <translation>%1 (Schlüssel %2)</translation>
    </message>
    <message>
        <source>Under attack: refused %1 forged and %2 replayed records that claim to come from %3</source>
        <translation>Unter Angriff: %1 gefälschte und %2 wiedereingespielte Records abgelehnt, angeblich von %3</translation>
    </message>
    <message>
        <source>Link %1: %2</source>
        <translation>Verbindung %1: %2</translation>
    </message>
    <message>
        <source>Link %1: listening on %2</source>
        <translation>Verbindung %1: lauscht auf %2</translation>
    </message>
    <message>
        <source>Link %1: replay finished</source>
        <translation>Verbindung %1: Wiedergabe beendet</translation>
    </message>
    <message>
        <source>Vehicle %1: %2</source>
        <translation>Fahrzeug %1: %2</translation>
    </message>
    <message>
        <source>the peer</source>
        <translation>Gegenstelle</translation>
    </message>
    <message>
        <source>%1 cannot determine the delay of commands and ignores any that may be older than %2 s: it ignored %3</source>
        <translation>%1 kann die Verzögerung der Befehle nicht bestimmen; ignoriert wird, was älter als %2 s sein könnte: %3</translation>
    </message>
    <message>
        <source>Messages to %1 were withheld or delayed in transit and overtaken by others: it ignored %2</source>
        <translation>Nachrichten an %1 wurden unterwegs zurückgehalten oder verzögert und von anderen überholt; ignoriert: %2</translation>
    </message>
    <message>
        <source>Commands reach %2 up to %1 s late, and it ignores any that are older than %3 s: it ignored %4</source>
        <translation>Befehle kommen bei %2 bis zu %1 s verspätet an; ignoriert wird, was älter als %3 s ist: %4</translation>
    </message>
    <message>
        <source>one message</source>
        <translation>eine Nachricht</translation>
    </message>
    <message>
        <source>%1 messages</source>
        <translation>%1 Nachrichten</translation>
    </message>
    <message>
        <source>one plain frame</source>
        <translation>ein ungeschützter Frame</translation>
    </message>
    <message>
        <source>%1 plain frames</source>
        <translation>%1 ungeschützte Frames</translation>
    </message>
    <message>
        <source>one frame</source>
        <translation>ein Frame</translation>
    </message>
    <message>
        <source>%1 frames</source>
        <translation>%1 Frames</translation>
    </message>
    <message>
        <source>Dropped %1 because this program did not keep up</source>
        <translation>Verworfen: %1, weil dieses Programm nicht nachkam</translation>
    </message>
    <message>
        <source>one event</source>
        <translation>ein Ereignis</translation>
    </message>
    <message>
        <source>%1 events</source>
        <translation>%1 Ereignisse</translation>
    </message>
    <message>
        <source>New keys for %1, epoch %2, in %3</source>
        <translation>Neue Schlüssel für %1, Epoche %2, in %3</translation>
    </message>
    <message>
        <source>Command: %1</source>
        <translation>Befehl: %1</translation>
    </message>
    <message>
        <source>accepted</source>
        <translation>angenommen</translation>
    </message>
    <message>
        <source>refused</source>
        <translation>abgelehnt</translation>
    </message>
    <message>
        <source>no answer</source>
        <translation>keine Antwort</translation>
    </message>
    <message>
        <source>Client %1 at %2 connected, read-only</source>
        <translation>Client %1 unter %2 verbunden, nur lesend</translation>
    </message>
    <message>
        <source>Client %1 at %2 connected, may write: %3</source>
        <translation>Client %1 unter %2 verbunden, darf schreiben: %3</translation>
    </message>
    <message>
        <source>Client %1 at %2 disconnected</source>
        <translation>Client %1 unter %2 getrennt</translation>
    </message>
    <message>
        <source>Further events: %1 connected and disconnected, %2 denied</source>
        <translation>Weitere Ereignisse: %1 verbunden und getrennt, %2 verweigert</translation>
    </message>
    <message>
        <source>one client</source>
        <translation>ein Client</translation>
    </message>
    <message>
        <source>%1 clients</source>
        <translation>%1 Clients</translation>
    </message>
    <message>
        <source>Denied %1 from client %2 at %3, most recently %4</source>
        <translation>Verweigert: %1 von Client %2 unter %3, zuletzt %4</translation>
    </message>
    <message>
        <source>Keys of %1 not changed: %2</source>
        <translation>Schlüssel für %1 nicht gewechselt: %2</translation>
    </message>
    <message>
        <source>An agent at %1 announces itself with an unknown key</source>
        <translation>Ein Agent unter %1 meldet sich mit einem unbekannten Schlüssel</translation>
    </message>
    <message>
        <source>The companion computer of %1 can store handshake counters again</source>
        <translation>Der Begleitrechner von %1 kann Handshake-Zähler wieder speichern</translation>
    </message>
    <message>
        <source>The companion computer of %1 cannot store handshake counters; its disk may be full, read-only or broken. The link stays up. If that computer restarts now, it will answer replayed handshakes, but they cannot establish a session</source>
        <translation>Der Begleitrechner von %1 kann keine Handshake-Zähler speichern; sein Datenträger ist vielleicht voll, schreibgeschützt oder defekt. Die Verbindung bleibt bestehen. Startet dieser Rechner jetzt neu, beantwortet er wiedereingespielte Handshakes; eine Sitzung entsteht daraus nicht</translation>
    </message>
    <message>
        <source>Found: %1, sealed</source>
        <translation>Gefunden: %1, versiegelt</translation>
    </message>
    <message>
        <source>Found: %1, not sealed</source>
        <translation>Gefunden: %1, nicht versiegelt</translation>
    </message>
    <message>
        <source>Refused %1 from %2 with the system ID of this sealed vehicle</source>
        <translation>Abgelehnt: %1 von %2 mit der System-ID dieses versiegelten Fahrzeugs</translation>
    </message>
    <message>
        <source>This vehicle, at %1, is waiting for approval: it is not sealed and may be impersonating %2, which has not been heard</source>
        <translation>Dieses Fahrzeug, unter %1, wartet auf Freigabe: Es ist nicht versiegelt und gibt sich möglicherweise als %2 aus (noch nicht empfangen)</translation>
    </message>
    <message>
        <source>Refused %1 from %2, which may not send as this vehicle. If %2 is its agent, bind the system ID to %2 in the list of peers</source>
        <translation>Abgelehnt: %1 von %2 (darf nicht als dieses Fahrzeug senden). Ist %2 sein Agent, die System-ID in der Liste der Gegenstellen an %2 binden</translation>
    </message>
    <message>
        <source>Refused %1 from %2, which sends as this vehicle although its system ID belongs to %3. If %2 is a new agent of the same vehicle, remove %3 from the list of peers or bind the system ID to %2</source>
        <translation>Abgelehnt: %1 von %2, gesendet als dieses Fahrzeug, dessen System-ID aber zu %3 gehört. Ist %2 ein neuer Agent desselben Fahrzeugs, %3 aus der Liste der Gegenstellen entfernen oder die System-ID an %2 binden</translation>
    </message>
    <message>
        <source>Handshake counters can be stored again</source>
        <translation>Handshake-Zähler lassen sich wieder speichern</translation>
    </message>
    <message>
        <source>Handshake counters cannot be stored: %1. The links stay up. If this station restarts now, agents will refuse its first handshake and return the correct counter</source>
        <translation>Handshake-Zähler lassen sich nicht speichern: %1. Die Verbindungen bleiben bestehen. Startet diese Station jetzt neu, lehnen Agenten ihren ersten Handshake ab und senden den richtigen Zähler zurück</translation>
    </message>
    <message>
        <source>%1. To show vehicle %2, bind its system ID to %3 in the list of peers</source>
        <translation>%1. Um Fahrzeug %2 zu zeigen, seine System-ID in der Liste der Gegenstellen an %3 binden</translation>
    </message>
    <message>
        <source>A vehicle at %1 is not shown: it has the system ID %2, which is this station&apos;s own. Change one of the two</source>
        <translation>Ein Fahrzeug unter %1 wird nicht gezeigt: Es hat die System-ID %2, die auch diese Station hat. Eine von beiden ändern</translation>
    </message>
    <message>
        <source>Found: %1</source>
        <translation>Gefunden: %1</translation>
    </message>
</context>
<context>
    <name>skyseal::engine::Number</name>
    <message>
        <source>0.5</source>
        <comment>with this language&apos;s decimal point</comment>
        <translation>0,5</translation>
    </message>
</context>
<context>
    <name>skyseal::engine::PairingText</name>
    <message>
        <source>timed out</source>
        <translation>Zeitüberschreitung</translation>
    </message>
    <message>
        <source>cancelled</source>
        <translation>abgebrochen</translation>
    </message>
    <message>
        <source>the vehicle was armed</source>
        <translation>das Fahrzeug wurde scharfgeschaltet</translation>
    </message>
    <message>
        <source>refused here</source>
        <translation>hier abgelehnt</translation>
    </message>
    <message>
        <source>the other end refused</source>
        <translation>die andere Seite hat abgelehnt</translation>
    </message>
    <message>
        <source>the pairing was interrupted; start again at both ends</source>
        <translation>die Kopplung wurde unterbrochen; auf beiden Seiten neu beginnen</translation>
    </message>
    <message>
        <source>three wrong passphrases: they differ, or an attacker is guessing; start again at both ends</source>
        <translation>drei falsche Passphrasen: Sie unterscheiden sich, oder ein Angreifer rät; auf beiden Seiten neu beginnen</translation>
    </message>
    <message>
        <source>Not paired: %1</source>
        <translation>Nicht gekoppelt: %1</translation>
    </message>
    <message>
        <source>Paired with %1</source>
        <translation>Gekoppelt mit %1</translation>
    </message>
    <message>
        <source>Another device tried to pair at the same time</source>
        <translation>Ein anderes Gerät hat zur gleichen Zeit eine Kopplung versucht</translation>
    </message>
    <message>
        <source>The passphrases of the two ends differ, or only one end has one, or the link is very poor. Start again with the same passphrase at both ends</source>
        <translation>Die Passphrasen der beiden Seiten unterscheiden sich, oder nur eine Seite hat eine, oder die Verbindung ist sehr schlecht. Mit derselben Passphrase auf beiden Seiten neu beginnen</translation>
    </message>
</context>
<context>
    <name>skyseal::engine::StateText</name>
    <message>
        <source>plain, not sealed</source>
        <translation>ungeschützt, nicht versiegelt</translation>
    </message>
    <message>
        <source>%1 (insecure)</source>
        <translation>%1 (unsicher)</translation>
    </message>
    <message>
        <source>plane</source>
        <translation>Flugzeug</translation>
    </message>
    <message>
        <source>quadrotor</source>
        <translation>Quadrokopter</translation>
    </message>
    <message>
        <source>coaxial helicopter</source>
        <translation>Koaxialhubschrauber</translation>
    </message>
    <message>
        <source>helicopter</source>
        <translation>Hubschrauber</translation>
    </message>
    <message>
        <source>antenna tracker</source>
        <translation>Antennentracker</translation>
    </message>
    <message>
        <source>airship</source>
        <translation>Luftschiff</translation>
    </message>
    <message>
        <source>rover</source>
        <translation>Rover</translation>
    </message>
    <message>
        <source>boat</source>
        <translation>Boot</translation>
    </message>
    <message>
        <source>submarine</source>
        <translation>Unterwasserfahrzeug</translation>
    </message>
    <message>
        <source>hexarotor</source>
        <translation>Hexakopter</translation>
    </message>
    <message>
        <source>octorotor</source>
        <translation>Oktokopter</translation>
    </message>
    <message>
        <source>tricopter</source>
        <translation>Trikopter</translation>
    </message>
    <message>
        <source>VTOL</source>
        <translation>VTOL</translation>
    </message>
    <message>
        <source>vehicle</source>
        <translation>Fahrzeug</translation>
    </message>
    <message>
        <source>closed</source>
        <translation>geschlossen</translation>
    </message>
    <message>
        <source>opening</source>
        <translation>wird geöffnet</translation>
    </message>
    <message>
        <source>listening</source>
        <translation>lauscht</translation>
    </message>
    <message>
        <source>connected</source>
        <translation>verbunden</translation>
    </message>
    <message>
        <source>waiting to retry</source>
        <translation>wartet auf neuen Versuch</translation>
    </message>
    <message>
        <source>finished</source>
        <translation>beendet</translation>
    </message>
    <message>
        <source>failed</source>
        <translation>fehlgeschlagen</translation>
    </message>
    <message>
        <source>the other end restarted</source>
        <translation>die andere Seite wurde neu gestartet</translation>
    </message>
    <message>
        <source>closed by the other end</source>
        <translation>von der anderen Seite geschlossen</translation>
    </message>
    <message>
        <source>silent for too long</source>
        <translation>zu lange nichts empfangen</translation>
    </message>
    <message>
        <source>its keys are in use twice, as if the machine at one end had been copied</source>
        <translation>ihre Schlüssel werden doppelt verwendet, als wäre der Rechner einer Seite kopiert worden</translation>
    </message>
    <message>
        <source>its keys were used up</source>
        <translation>ihre Schlüssel waren aufgebraucht</translation>
    </message>
    <message>
        <source>its key is no longer among the known peers</source>
        <translation>ihr Schlüssel gehört nicht mehr zu den bekannten Gegenstellen</translation>
    </message>
    <message>
        <source>closed here</source>
        <translation>hier geschlossen</translation>
    </message>
    <message>
        <source>switched</source>
        <translation>gewechselt</translation>
    </message>
    <message>
        <source>not allowed at this end</source>
        <translation>auf dieser Seite nicht erlaubt</translation>
    </message>
    <message>
        <source>not allowed by the other end</source>
        <translation>von der anderen Seite nicht erlaubt</translation>
    </message>
    <message>
        <source>the other end did not confirm in time</source>
        <translation>die andere Seite hat nicht rechtzeitig bestätigt</translation>
    </message>
    <message>
        <source>the session ended</source>
        <translation>die Sitzung wurde beendet</translation>
    </message>
    <message>
        <source>its key is not among the known peers</source>
        <translation>sein Schlüssel gehört nicht zu den bekannten Gegenstellen</translation>
    </message>
    <message>
        <source>it was made for a different key: a wrong destination, or an impersonation</source>
        <translation>er galt einem anderen Schlüssel: falsches Ziel oder vorgetäuschte Identität</translation>
    </message>
    <message>
        <source>there is no cipher suite that both ends allow</source>
        <translation>es gibt keine Chiffre, die beide Seiten zulassen</translation>
    </message>
    <message>
        <source>its offer of suites was modified in transit</source>
        <translation>sein Angebot an Chiffren wurde unterwegs verändert</translation>
    </message>
    <message>
        <source>it uses another version of the protocol</source>
        <translation>er verwendet eine andere Protokollversion</translation>
    </message>
    <message>
        <source>all handshake counters of this station&apos;s key are used up; it needs a new key</source>
        <translation>alle Handshake-Zähler für den Schlüssel dieser Station sind aufgebraucht; sie braucht einen neuen Schlüssel</translation>
    </message>
    <message>
        <source>%1 or %2</source>
        <translation>%1 oder %2</translation>
    </message>
    <message>
        <source>the other end&apos;s request took precedence</source>
        <translation>die Anforderung der anderen Seite hatte Vorrang</translation>
    </message>
    <message>
        <source>its counter was used before: a replay, or the station lost its counter file</source>
        <translation>sein Zähler wurde schon verwendet: eine Wiedereinspielung, oder die Station hat ihre Zählerdatei verloren</translation>
    </message>
    <message>
        <source>this end&apos;s counter file was lost or restored; it continues from the number that the other end remembers</source>
        <translation>die Zählerdatei dieser Seite ging verloren oder wurde zurückgespielt; weiter geht es mit der Zahl, die sich die andere Seite gemerkt hat</translation>
    </message>
    <message>
        <source>there are too many handshakes; only senders that prove their address are answered</source>
        <translation>es sind zu viele Handshakes; nur Absender, die ihre Adresse nachweisen, erhalten eine Antwort</translation>
    </message>
</context>
<context>
    <name>skyseal::engine::SystemText</name>
    <message>
        <source>ground station</source>
        <translation>Bodenstation</translation>
    </message>
    <message>
        <source>companion computer</source>
        <translation>Begleitrechner</translation>
    </message>
    <message>
        <source>gimbal</source>
        <translation>Gimbal</translation>
    </message>
    <message>
        <source>ADS-B receiver</source>
        <translation>ADS-B-Empfänger</translation>
    </message>
    <message>
        <source>camera</source>
        <translation>Kamera</translation>
    </message>
    <message>
        <source>charging station</source>
        <translation>Ladestation</translation>
    </message>
    <message>
        <source>FLARM receiver</source>
        <translation>FLARM-Empfänger</translation>
    </message>
    <message>
        <source>servo</source>
        <translation>Servo</translation>
    </message>
    <message>
        <source>remote ID</source>
        <translation>Remote ID</translation>
    </message>
    <message>
        <source>battery</source>
        <translation>Akku</translation>
    </message>
    <message>
        <source>parachute</source>
        <translation>Fallschirm</translation>
    </message>
    <message>
        <source>logger</source>
        <translation>Aufzeichner</translation>
    </message>
    <message>
        <source>on-screen display</source>
        <translation>Bildschirmeinblendung</translation>
    </message>
    <message>
        <source>inertial sensor</source>
        <translation>Inertialsensor</translation>
    </message>
    <message>
        <source>GPS receiver</source>
        <translation>GPS-Empfänger</translation>
    </message>
    <message>
        <source>winch</source>
        <translation>Winde</translation>
    </message>
    <message>
        <source>light</source>
        <translation>Leuchte</translation>
    </message>
    <message>
        <source>gripper</source>
        <translation>Greifer</translation>
    </message>
    <message>
        <source>radio</source>
        <translation>Funkgerät</translation>
    </message>
    <message>
        <source>autopilot</source>
        <translation>Autopilot</translation>
    </message>
    <message>
        <source>component</source>
        <translation>Komponente</translation>
    </message>
    <message>
        <source>Other systems behind %1: %2</source>
        <translation>Weitere Systeme hinter %1: %2</translation>
    </message>
</context>
<context>
    <name>skyseal::link::LinkType</name>
    <message>
        <source>UDP, listen for vehicles</source>
        <translation>UDP, auf Fahrzeuge warten</translation>
    </message>
    <message>
        <source>Receives datagrams on a local port; each sender is a peer.</source>
        <translation>Empfängt Datagramme auf einem lokalen Port; jeder Absender ist eine Gegenstelle.</translation>
    </message>
    <message>
        <source>UDP, send to an address</source>
        <translation>UDP, an eine Adresse senden</translation>
    </message>
    <message>
        <source>Sends datagrams to one host and receives its answers.</source>
        <translation>Sendet Datagramme an einen Host und empfängt dessen Antworten.</translation>
    </message>
    <message>
        <source>TCP, connect to an address</source>
        <translation>TCP, mit Adresse verbinden</translation>
    </message>
    <message>
        <source>Connects to one server and reconnects when the connection is lost.</source>
        <translation>Verbindet mit einem Server, nach einem Abbruch erneut.</translation>
    </message>
    <message>
        <source>TCP, listen for connections</source>
        <translation>TCP, auf Verbindungen warten</translation>
    </message>
    <message>
        <source>Accepts connections on a local port; each client is a peer.</source>
        <translation>Nimmt Verbindungen auf einem lokalen Port an; jeder Client ist eine Gegenstelle.</translation>
    </message>
    <message>
        <source>Serial radio</source>
        <translation>Serielles Funkmodem</translation>
    </message>
    <message>
        <source>Opens a serial device: 8 data bits, no parity, 1 stop bit, no flow control.</source>
        <translation>Öffnet ein serielles Gerät: 8 Datenbits, keine Parität, 1 Stoppbit, keine Flusskontrolle.</translation>
    </message>
    <message>
        <source>Recorded log</source>
        <translation>Aufgezeichnetes Log</translation>
    </message>
    <message>
        <source>Replays a telemetry log at the recorded pace, with pauses of at most five seconds; nothing is sent.</source>
        <translation>Spielt ein Telemetrie-Log im aufgezeichneten Tempo ab, mit Pausen von höchstens fünf Sekunden; gesendet wird nichts.</translation>
    </message>
</context>
<context>
    <name>skyseal::ui::ActionBar</name>
    <message>
        <source>Arm</source>
        <translation>Scharfschalten</translation>
    </message>
    <message>
        <source>Actions</source>
        <translation>Aktionen</translation>
    </message>
    <message>
        <source>Take off</source>
        <translation>Abheben</translation>
    </message>
    <message>
        <source>Start mission</source>
        <translation>Mission starten</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>Land</source>
        <translation>Landen</translation>
    </message>
    <message>
        <source>RTL</source>
        <translation>RTL</translation>
    </message>
    <message>
        <source>Returns to launch and lands there.</source>
        <translation>Kehrt zum Startpunkt zurück und landet dort.</translation>
    </message>
    <message>
        <source>Result of the last command</source>
        <translation>Ergebnis des letzten Befehls</translation>
    </message>
    <message>
        <source>the vehicle&apos;s modes have changed</source>
        <translation>die Modi des Fahrzeugs haben sich geändert</translation>
    </message>
    <message>
        <source>Not sent: hold the button to confirm</source>
        <translation>Nicht gesendet: zum Bestätigen den Knopf halten</translation>
    </message>
    <message>
        <source>Disarm</source>
        <translation>Entschärfen</translation>
    </message>
    <message>
        <source>veh. %1</source>
        <translation>Fzg. %1</translation>
    </message>
    <message>
        <source>vehicle %1</source>
        <translation>Fahrzeug %1</translation>
    </message>
    <message>
        <source>another vehicle is selected</source>
        <translation>ein anderes Fahrzeug ist ausgewählt</translation>
    </message>
    <message>
        <source>the vehicle has been armed</source>
        <translation>das Fahrzeug wurde scharfgeschaltet</translation>
    </message>
    <message>
        <source>the vehicle has been disarmed</source>
        <translation>das Fahrzeug wurde entschärft</translation>
    </message>
    <message>
        <source>Not sent: %1</source>
        <translation>Nicht gesendet: %1</translation>
    </message>
    <message>
        <source>Stops and holds the present position; a plane circles it.</source>
        <translation>Hält an und bleibt an der aktuellen Position; ein Flächenflugzeug kreist dort.</translation>
    </message>
    <message>
        <source>Starts or continues the mission.</source>
        <translation>Startet die Mission oder setzt sie fort.</translation>
    </message>
    <message>
        <source>Checklist and pre-arm checks…</source>
        <translation>Checkliste und Vorprüfungen…</translation>
    </message>
    <message>
        <source>Arm and
take off</source>
        <translation>Scharf und
abheben</translation>
    </message>
    <message>
        <source>Arm and take off</source>
        <translation>Scharfschalten und abheben</translation>
    </message>
    <message>
        <source>Arms the motors, and takes off at once.</source>
        <translation>Schaltet die Motoren scharf und hebt sofort ab.</translation>
    </message>
    <message>
        <source>Arm and start
mission</source>
        <translation>Scharf, Mission
starten</translation>
    </message>
    <message>
        <source>Arm and
start</source>
        <translation>Scharf,
starten</translation>
    </message>
    <message>
        <source>Arm and start mission</source>
        <translation>Scharfschalten und Mission starten</translation>
    </message>
    <message>
        <source>Arms the motors, and starts the mission at once.</source>
        <translation>Schaltet die Motoren scharf und startet sofort die Mission.</translation>
    </message>
    <message>
        <source>In its present mode the vehicle takes off as soon as it is armed.</source>
        <translation>Im jetzigen Modus hebt das Fahrzeug ab, sobald es scharf ist.</translation>
    </message>
</context>
<context>
    <name>skyseal::ui::ActionPermits</name>
    <message>
        <source>the vehicle is disarmed</source>
        <translation>das Fahrzeug ist unscharf</translation>
    </message>
    <message>
        <source>Not now: %1</source>
        <translation>Jetzt nicht: %1</translation>
    </message>
    <message>
        <source>the mission last read is empty: read it again</source>
        <translation>die zuletzt gelesene Mission ist leer: erneut lesen</translation>
    </message>
    <message>
        <source>the vehicle is armed</source>
        <translation>das Fahrzeug ist scharf</translation>
    </message>
    <message>
        <source>the vehicle is already flying</source>
        <translation>das Fahrzeug fliegt schon</translation>
    </message>
    <message>
        <source>the vehicle was flying when it was last heard</source>
        <translation>das Fahrzeug flog, als es zuletzt gehört wurde</translation>
    </message>
    <message>
        <source>the vehicle is not heard</source>
        <translation>das Fahrzeug wird nicht empfangen</translation>
    </message>
</context>
<context>
    <name>skyseal::ui::AddWaypointDialog</name>
    <message>
        <source>%1
Hold the button for half a second. The waypoint is put before the last item of the mission, and the whole mission is sent to the vehicle.</source>
        <translation>%1
Den Knopf eine halbe Sekunde halten. Der Wegpunkt kommt vor den letzten Punkt der Mission, und die ganze Mission wird an das Fahrzeug gesendet.</translation>
    </message>
    <message>
        <source>%1
Hold the button for half a second. The waypoint becomes the last item of the mission, and the whole mission is sent to the vehicle.</source>
        <translation>%1
Den Knopf eine halbe Sekunde halten. Der Wegpunkt wird der letzte Punkt der Mission, und die ganze Mission wird an das Fahrzeug gesendet.</translation>
    </message>
    <message>
        <source>Add to the mission</source>
        <translation>Zur Mission hinzufügen</translation>
    </message>
    <message>
        <source>Add and send</source>
        <translation>Hinzufügen und senden</translation>
    </message>
</context>
<context>
    <name>skyseal::ui::AircraftText</name>
    <message>
        <source>altitude unknown</source>
        <translation>Höhe unbekannt</translation>
    </message>
    <message>
        <source>%1 · near</source>
        <translation>%1 · nahe</translation>
    </message>
</context>
<context>
    <name>skyseal::ui::AlertList</name>
    <message>
        <source>Link lost %1</source>
        <translation>Kein Empfang seit %1</translation>
    </message>
    <message>
        <source>Nothing has been received from the vehicle since. The last received values are shown.</source>
        <translation>Seitdem wurde vom Fahrzeug nichts empfangen. Gezeigt werden die zuletzt empfangenen Werte.</translation>
    </message>
    <message>
        <source>Failsafe</source>
        <translation>Failsafe</translation>
    </message>
    <message>
        <source>Emergency</source>
        <translation>Notfall</translation>
    </message>
    <message>
        <source>Flight terminated</source>
        <translation>Flugabbruch (Termination)</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Aircraft near: %1</source>
        <translation>Luftfahrzeug nahe: %1</translation>
    </message>
    <message>
        <source>Battery very low: %1 %</source>
        <translation>Akku sehr schwach: %1 %</translation>
    </message>
    <message>
        <source>Battery low: %1 %</source>
        <translation>Akku schwach: %1 %</translation>
    </message>
    <message>
        <source>One forged frame</source>
        <translation>Ein gefälschter Frame</translation>
    </message>
    <message>
        <source>%1 forged frames</source>
        <translation>%1 gefälschte Frames</translation>
    </message>
    <message>
        <source>One replayed frame</source>
        <translation>Ein wiedereingespielter Frame</translation>
    </message>
    <message>
        <source>%1 replayed frames</source>
        <translation>%1 wiedereingespielte Frames</translation>
    </message>
    <message>
        <source>Not recording: %1</source>
        <translation>Keine Aufzeichnung: %1</translation>
    </message>
    <message>
        <source>Counters not stored: %1</source>
        <translation>Zähler nicht gespeichert: %1</translation>
    </message>
    <message>
        <source>%1: its disk may be full</source>
        <translation>%1: Datenträger vielleicht voll</translation>
    </message>
    <message>
        <source>%1: keys in use twice</source>
        <translation>%1: Schlüssel doppelt verwendet</translation>
    </message>
    <message>
        <source>Unknown agent at %1</source>
        <translation>Unbekannter Agent unter %1</translation>
    </message>
    <message>
        <source>Switched to %1</source>
        <translation>Gewechselt zu %1</translation>
    </message>
    <message>
        <source>Keys not changed: %1</source>
        <translation>Schlüssel nicht gewechselt: %1</translation>
    </message>
    <message>
        <source>Not switched to %1</source>
        <translation>Nicht gewechselt zu %1</translation>
    </message>
    <message>
        <source>The agent</source>
        <translation>Agent</translation>
    </message>
    <message>
        <source>%1 (%2 times)</source>
        <translation>%1 (%2-mal)</translation>
    </message>
    <message>
        <source>Vehicle %1: %2</source>
        <translation>Fahrzeug %1: %2</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>The autopilot reports an abnormal state. The Messages panel may show the reason.</source>
        <translation>Der Autopilot meldet einen anormalen Zustand. Den Grund zeigt eventuell das Panel „Nachrichten“.</translation>
    </message>
    <message>
        <source>As reported by the vehicle.</source>
        <translation>Laut Meldung des Fahrzeugs.</translation>
    </message>
    <message>
        <source>Mode %1 → %2, not by this station</source>
        <translation>Modus %1 → %2, nicht von hier</translation>
    </message>
    <message>
        <source>The mode changed without a command from this station. The autopilot, the RC transmitter or another station changed it.</source>
        <translation>Der Modus wechselte ohne Befehl dieser Station: durch den Autopiloten, die Fernsteuerung oder eine andere Station.</translation>
    </message>
    <message>
        <source>Within %1 of the vehicle, and less than %2 above or below it or at an unknown altitude. The map shows it.</source>
        <translation>Weniger als %1 vom Fahrzeug und weniger als %2 darüber oder darunter oder in unbekannter Höhe. Die Karte zeigt es.</translation>
    </message>
    <message>
        <source>All were refused. Counted since the link came up, as the Secure link panel does.</source>
        <translation>Alle wurden abgelehnt. Gezählt seit Beginn der Verbindung, wie im Panel „Sichere Verbindung“.</translation>
    </message>
    <message>
        <source>%1. To pair with it, choose Pair or open Security → Keys and peers</source>
        <translation>%1. Zum Koppeln Koppeln wählen oder Sicherheit → Schlüssel und Gegenstellen öffnen</translation>
    </message>
</context>
<context>
    <name>skyseal::ui::AlertRow</name>
    <message>
        <source>Dismiss the alert</source>
        <translation>Meldung ausblenden</translation>
    </message>
    <message>
        <source>Alarm</source>
        <translation>Alarm</translation>
    </message>
    <message>
        <source>Warning</source>
        <translation>Warnung</translation>
    </message>
    <message>
        <source>Information</source>
        <translation>Information</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>%1 since %2: %3. %4</source>
        <translation>%1 seit %2: %3. %4</translation>
    </message>
    <message>
        <source>Dismiss: %1</source>
        <translation>Ausblenden: %1</translation>
    </message>
    <message>
        <source>Dismiss (Esc)</source>
        <translation>Ausblenden (Esc)</translation>
    </message>
    <message>
        <source>Dismiss until it recurs or gets worse (Esc)</source>
        <translation>Ausblenden, bis sie erneut auftritt oder schlimmer wird (Esc)</translation>
    </message>
    <message>
        <source>Pair…</source>
        <translation>Koppeln…</translation>
    </message>
    <message>
        <source>Pair with the agent</source>
        <translation>Mit dem Agenten koppeln</translation>
    </message>
</context>
<context>
    <name>skyseal::ui::AlertStack</name>
    <message>
        <source>Alerts</source>
        <translation>Meldungen</translation>
    </message>
    <message>
        <source>and %1 more</source>
        <translation>und %1 weitere</translation>
    </message>
</context>
<context>
    <name>skyseal::ui::AllowPlain</name>
    <message>
        <source>Allow plain MAVLink for vehicle %1…</source>
        <translation>Ungeschütztes MAVLink für Fahrzeug %1 zulassen…</translation>
    </message>
    <message>
        <source>Plain MAVLink</source>
        <translation>Ungeschütztes MAVLink</translation>
    </message>
    <message>
        <source>Allow plain MAVLink</source>
        <translation>Ungeschütztes MAVLink zulassen</translation>
    </message>
    <message>
        <source>Accept plain MAVLink from vehicle %1?</source>
        <translation>Ungeschütztes MAVLink von Fahrzeug %1 annehmen?</translation>
    </message>
    <message>
        <source>It currently sends from %2. If you allow it, any sender of plain MAVLink that claims to be vehicle %1, from any address, is shown and commanded as that vehicle until this program ends or a sealed link to the vehicle is up. Anyone on the path can read and change the traffic.

If this should be the vehicle of %3, choose Cancel: its sealed link is broken or blocked.</source>
        <translation>Es sendet derzeit von %2. Nach dem Zulassen wird jeder Absender von ungeschütztem MAVLink, der sich als Fahrzeug %1 ausgibt, von jeder Adresse, als dieses Fahrzeug angezeigt und erhält dessen Befehle, bis dieses Programm endet oder eine versiegelte Verbindung zum Fahrzeug steht. Jeder auf der Übertragungsstrecke kann den Verkehr mitlesen und verändern.

Sollte dies das Fahrzeug von %3 sein, Abbrechen wählen: Dessen versiegelte Verbindung ist gestört oder blockiert.</translation>
    </message>
</context>
<context>
    <name>skyseal::ui::AltitudeBox</name>
    <message>
        <source>Take-off altitude</source>
        <translation>Starthöhe</translation>
    </message>
    <message>
        <source>Above home, %1 to %2%3</source>
        <translation>Über Home, %1 bis %2%3</translation>
    </message>
</context>
<context>
    <name>skyseal::ui::AltitudeDialog</name>
    <message>
        <source>%1 · vehicle %2</source>
        <translation>%1 · Fahrzeug %2</translation>
    </message>
    <message>
        <source>Altitude above home</source>
        <translation>Höhe über Home</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>&amp;Altitude above home</source>
        <translation>&amp;Höhe über Home</translation>
    </message>
    <message>
        <source>Not now: vehicle %1 is no longer selected</source>
        <translation>Nicht jetzt: Fahrzeug %1 ist nicht mehr ausgewählt</translation>
    </message>
</context>
<context>
    <name>skyseal::ui::ChangeAltitudeDialog</name>
    <message>
        <source>Change altitude</source>
        <translation>Höhe ändern</translation>
    </message>
    <message>
        <source>Hold the button for half a second. The vehicle leaves its mission, and climbs or descends where it is.</source>
        <translation>Den Knopf eine halbe Sekunde halten. Das Fahrzeug verlässt seine Mission und steigt oder sinkt an Ort und Stelle.</translation>
    </message>
</context>
<context>
    <name>skyseal::ui::ChangePassphraseDialog</name>
    <message>
        <source>Change the passphrase</source>
        <translation>Passphrase ändern</translation>
    </message>
    <message>
        <source>Set a passphrase</source>
        <translation>Passphrase setzen</translation>
    </message>
    <message>
        <source>New passphrase</source>
        <translation>Neue Passphrase</translation>
    </message>
    <message>
        <source>Ne&amp;w passphrase</source>
        <translation>Neue &amp;Passphrase</translation>
    </message>
    <message>
        <source>Change</source>
        <translation>Ändern</translation>
    </message>
    <message>
        <source>Seal</source>
        <translation>Versiegeln</translation>
    </message>
    <message>
        <source>Working…</source>
        <translation>In Arbeit…</translation>
    </message>
    <message>
        <source>The passphrase encrypts the private key in its file. Without one, anyone who copies the file has the key. Skyseal asks for it at each start. A lost passphrase cannot be recovered.</source>
        <translation>Die Passphrase verschlüsselt den privaten Schlüssel in seiner Datei. Ohne Passphrase hat jeder den Schlüssel, der die Datei kopiert. Skyseal fragt bei jedem Start danach. Eine verlorene Passphrase lässt sich nicht wiederherstellen.</translation>
    </message>
    <message>
        <source>Current passphrase</source>
        <translation>Aktuelle Passphrase</translation>
    </message>
    <message>
        <source>&amp;No passphrase: anyone who has the file has the key</source>
        <translation>&amp;Keine Passphrase: wer die Datei hat, hat den Schlüssel</translation>
    </message>
    <message>
        <source>&amp;Current passphrase</source>
        <translation>&amp;Aktuelle Passphrase</translation>
    </message>
    <message>
        <source>Repeat the &amp;new passphrase</source>
        <translation>Neue Passphrase &amp;wiederholen</translation>
    </message>
    <message>
        <source>The two new passphrases differ.</source>
        <translation>Die beiden neuen Passphrasen unterscheiden sich.</translation>
    </message>
    <message>
        <source>Repeat the new passphrase</source>
        <translation>Neue Passphrase wiederholen</translation>
    </message>
</context>
<context>
    <name>skyseal::ui::ChangedKeyWarning</name>
    <message>
        <source>Fingerprint of the new key</source>
        <translation>Fingerabdruck des neuen Schlüssels</translation>
    </message>
    <message>
        <source>new</source>
        <translation>neu</translation>
    </message>
    <message>
        <source>The key of %1 has changed. Either a new key was generated there, or another device is impersonating %1.</source>
        <translation>Der Schlüssel von %1 hat sich geändert. Entweder wurde dort ein neuer Schlüssel erzeugt, oder ein anderes Gerät gibt sich als %1 aus.</translation>
    </message>
    <message>
        <source>Previous fingerprint</source>
        <translation>Bisheriger Fingerabdruck</translation>
    </message>
    <message>
        <source>I have checked the new fingerprint on the device itself: &amp;replace the key</source>
        <translation>Neuer Fingerabdruck am Gerät selbst verglichen: Schlüssel &amp;ersetzen</translation>
    </message>
    <message>
        <source>previous</source>
        <translation>bisher</translation>
    </message>
</context>
<context>
    <name>skyseal::ui::ChartBuilder</name>
    <message>
        <source>no link</source>
        <translation>keine Verbindung</translation>
    </message>
</context>
<context>
    <name>skyseal::ui::ChartExport</name>
    <message>
        <source>Skyseal diagnostics</source>
        <translation>Skyseal-Diagnose</translation>
    </message>
    <message>
        <source>%1 cannot be written as a picture: %2</source>
        <translation>%1 kann nicht als Bild geschrieben werden: %2</translation>
    </message>
</context>
<context>
    <name>skyseal::ui::ChartMarks</name>
    <message>
        <source>link lost</source>
        <translation>Verbindung verloren</translation>
    </message>
    <message>
        <source>new keys, epoch %1</source>
        <translation>neue Schlüssel, Epoche %1</translation>
    </message>
    <message>
        <source>link recovered</source>
        <translation>Verbindung wiederhergestellt</translation>
    </message>
    <message>
        <source>%1 forged, replayed or plain, refused</source>
        <translation>%1 gefälscht, wiedereingespielt oder ungeschützt, abgelehnt</translation>
    </message>
</context>
<context>
    <name>skyseal::ui::ChartText</name>
    <message>
        <source>now</source>
        <translation>jetzt</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
    </message>
    <message>
        <source>! %1</source>
        <translation>! %1</translation>
    </message>
    <message>
        <source>→ %1</source>
        <translation>→ %1</translation>
    </message>
</context>
<context>
    <name>skyseal::ui::ChartView</name>
    <message>
        <source>nothing measured yet</source>
        <translation>noch nichts gemessen</translation>
    </message>
    <message>
        <source>%1: mean %2 %3, from %4 to %5, %6 samples</source>
        <translation>%1: Mittel %2 %3, von %4 bis %5, %6 Messwerte</translation>
    </message>
</context>
<context>
    <name>skyseal::ui::ChecklistBox</name>
    <message>
        <source>Checklist</source>
        <translation>Checkliste</translation>
    </message>
    <message>
        <source>Choose a file…</source>
        <translation>Datei auswählen…</translation>
    </message>
    <message>
        <source>Choose the file of the checklist</source>
        <translation>Datei der Checkliste auswählen</translation>
    </message>
    <message>
        <source>No checklist</source>
        <translation>Keine Checkliste</translation>
    </message>
    <message>
        <source>Use no checklist for this vehicle</source>
        <translation>Für dieses Fahrzeug keine Checkliste verwenden</translation>
    </message>
    <message>
        <source>Checklist of vehicle %1</source>
        <translation>Checkliste für Fahrzeug %1</translation>
    </message>
    <message>
        <source>%1 · not yet: %2</source>
        <translation>%1 · noch nicht: %2</translation>
    </message>
    <message>
        <source>No checklist without a vehicle.</source>
        <translation>Keine Checkliste ohne Fahrzeug.</translation>
    </message>
    <message>
        <source>Checklist %1 cannot be read</source>
        <translation>Checkliste %1 ist nicht lesbar</translation>
    </message>
    <message>
        <source>Checklist %1: %2 of %3 done</source>
        <translation>Checkliste %1: %2 von %3 erledigt</translation>
    </message>
    <message>
        <source>Text files (*.txt);;All files (*)</source>
        <translation>Textdateien (*.txt);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>%1 · automatic: %2</source>
        <translation>%1 · automatisch: %2</translation>
    </message>
    <message>
        <source>No checklist for vehicle %1. A checklist is a text file; see Help → First steps.</source>
        <translation>Keine Checkliste für Fahrzeug %1. Eine Checkliste ist eine Textdatei; siehe Hilfe → Erste Schritte.</translation>
    </message>
</context>
<context>
    <name>skyseal::ui::ClientModel</name>
    <message>
        <source>reads</source>
        <translation>liest</translation>
    </message>
    <message>
        <source>reads and writes</source>
        <translation>liest und schreibt</translation>
    </message>
    <message>
        <source>reads, writes %1</source>
        <translation>liest, schreibt %1</translation>
    </message>
    <message>
        <source>Station</source>
        <translation>Station</translation>
    </message>
    <message>
        <source>Rights</source>
        <translation>Rechte</translation>
    </message>
    <message>
        <source>Forwarded</source>
        <translation>Weitergeleitet</translation>
    </message>
    <message>
        <source>Refused</source>
        <translation>Abgelehnt</translation>
    </message>
    <message>
        <source>%1 not permitted, %2 over the rate limit, %3 with a system ID that it may not use</source>
        <translation>%1 nicht erlaubt, %2 über der Ratenbegrenzung, %3 mit nicht erlaubter System-ID</translation>
    </message>
</context>
<context>
    <name>skyseal::ui::CommandAge</name>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>Commands are ignored: their delay is unknown, and the limit is %1</source>
        <translation>Befehle werden ignoriert: Verzögerung unbekannt, Grenze %1</translation>
    </message>
    <message>
        <source>The delay of commands is unknown</source>
        <translation>Die Verzögerung der Befehle ist unbekannt</translation>
    </message>
    <message>
        <source>Commands are ignored: they arrive up to %1 late, and the limit is %2</source>
        <translation>Befehle werden ignoriert: bis zu %1 verspätet, Grenze %2</translation>
    </message>
    <message>
        <source>Commands arrive up to %1 late</source>
        <translation>Befehle kommen bis zu %1 verspätet an</translation>
    </message>
    <message>
        <source>Commands arrive within %1</source>
        <translation>Befehle kommen innerhalb von %1 an</translation>
    </message>
    <message>
        <source>Commands ignored, delay unknown</source>
        <translation>Befehle ignoriert, Verzögerung unbekannt</translation>
    </message>
    <message>
        <source>Delay of commands unknown</source>
        <translation>Verzögerung der Befehle unbekannt</translation>
    </message>
    <message>
        <source>Commands ignored, %1 late</source>
        <translation>Befehle ignoriert, %1 verspätet</translation>
    </message>
    <message>
        <source>Commands %1 late</source>
        <translation>Befehle %1 verspätet</translation>
    </message>
    <message>
        <source>The agent ignores commands that are older than %1, or that were overtaken by newer messages by %2</source>
        <translation>Der Agent ignoriert Befehle, die älter als %1 sind oder von neueren Nachrichten um %2 überholt wurden</translation>
    </message>
    <message>
        <source>The agent ignores commands that were overtaken by newer messages by %1</source>
        <translation>Der Agent ignoriert Befehle, die von neueren Nachrichten um %1 überholt wurden</translation>
    </message>
</context>
<context>
    <name>skyseal::ui::CommandPalette</name>
    <message>
        <source>Find a command</source>
        <translation>Befehl suchen</translation>
    </message>
    <message>
        <source>Parts of a name, such as &quot;rtl&quot; or &quot;map source&quot;</source>
        <translation>Teile eines Namens, etwa „rtl“ oder „kartenquelle“</translation>
    </message>
    <message>
        <source>Command</source>
        <translation>Befehl</translation>
    </message>
    <message>
        <source>Commands</source>
        <translation>Befehle</translation>
    </message>
    <message>
        <source>No command matches</source>
        <translation>Kein Befehl passt</translation>
    </message>
</context>
<context>
    <name>skyseal::ui::CommandPermits</name>
    <message>
        <source>no vehicle</source>
        <translation>kein Fahrzeug</translation>
    </message>
    <message>
        <source>it is not sealed, and plain MAVLink is not allowed</source>
        <translation>es ist nicht versiegelt, und ungeschütztes MAVLink ist nicht zugelassen</translation>
    </message>
    <message>
        <source>Nothing can be sent: %1</source>
        <translation>Senden nicht möglich: %1</translation>
    </message>
    <message>
        <source>a replay is shown</source>
        <translation>eine Wiedergabe wird gezeigt</translation>
    </message>
    <message>
        <source>A replay is shown</source>
        <translation>Eine Wiedergabe wird gezeigt</translation>
    </message>
    <message>
        <source>A vehicle is connected: the demo would end its link</source>
        <translation>Ein Fahrzeug ist verbunden: Die Demo würde seine Verbindung beenden</translation>
    </message>
    <message>
        <source>A link is sealed: the demo would end it</source>
        <translation>Eine Verbindung ist versiegelt: Die Demo würde sie beenden</translation>
    </message>
    <message>
        <source>the vehicle is disarmed</source>
        <translation>das Fahrzeug ist unscharf</translation>
    </message>
    <message>
        <source>its position is not known</source>
        <translation>seine Position ist nicht bekannt</translation>
    </message>
    <message>
        <source>this kind of vehicle does not fly</source>
        <translation>diese Art von Fahrzeug fliegt nicht</translation>
    </message>
</context>
<context>
    <name>skyseal::ui::ConfirmCommand</name>
    <message>
        <source>Vehicle %1: %2</source>
        <translation>Fahrzeug %1: %2</translation>
    </message>
    <message>
        <source>Confirm</source>
        <translation>Bestätigen</translation>
    </message>
    <message>
        <source>and %1 more</source>
        <translation>und %1 weitere</translation>
    </message>
    <message>
        <source>Not done on the checklist:</source>
        <translation>Auf der Checkliste nicht erledigt:</translation>
    </message>
    <message>
        <source>Arm with an incomplete checklist?</source>
        <translation>Trotz offener Checkliste scharfschalten?</translation>
    </message>
</context>
<context>
    <name>skyseal::ui::Coordinates</name>
    <message>
        <source>north</source>
        <translation>Nord</translation>
    </message>
    <message>
        <source>south</source>
        <translation>Süd</translation>
    </message>
    <message>
        <source>%1 %2 %3 mE %4 mN</source>
        <translation>%1 %2 %3 mE %4 mN</translation>
    </message>
    <message>
        <source>N</source>
        <comment>north</comment>
        <translation>N</translation>
    </message>
    <message>
        <source>E</source>
        <comment>east</comment>
        <translation>O</translation>
    </message>
    <message>
        <source>S</source>
        <comment>south</comment>
        <translation>S</translation>
    </message>
    <message>
        <source>W</source>
        <comment>west</comment>
        <translation>W</translation>
    </message>
</context>
<context>
    <name>skyseal::ui::CountersTable</name>
    <message>
        <source>good</source>
        <translation>gültig</translation>
    </message>
    <message>
        <source>late</source>
        <translation>verspätet</translation>
    </message>
    <message>
        <source>lost</source>
        <translation>verloren</translation>
    </message>
    <message>
        <source>replayed</source>
        <translation>wiederholt</translation>
    </message>
    <message>
        <source>forged</source>
        <translation>gefälscht</translation>
    </message>
    <message>
        <source>malformed</source>
        <translation>fehlerhaft</translation>
    </message>
    <message>
        <source>plain</source>
        <translation>ungeschützt</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>refused</source>
        <translation>abgelehnt</translation>
    </message>
    <message>
        <source>%1 replayed, %2 forged, %3 malformed, %4 plain</source>
        <translation>%1 wiedereingespielt, %2 gefälscht, %3 fehlerhaft, %4 ungeschützt</translation>
    </message>
    <message>
        <source>Records with a valid authentication tag</source>
        <translation>Records mit gültigem Authentisierungs-Tag</translation>
    </message>
    <message>
        <source>Valid, but received after a newer record</source>
        <translation>Gültig, aber nach einem neueren Record empfangen</translation>
    </message>
    <message>
        <source>Sent, but not received</source>
        <translation>Gesendet, aber nicht empfangen</translation>
    </message>
    <message>
        <source>Received before, refused</source>
        <translation>Schon früher empfangen, abgelehnt</translation>
    </message>
    <message>
        <source>Authentication tag invalid, refused</source>
        <translation>Authentisierungs-Tag ungültig, abgelehnt</translation>
    </message>
    <message>
        <source>Not a valid record, refused</source>
        <translation>Kein gültiger Record, abgelehnt</translation>
    </message>
    <message>
        <source>Plain MAVLink that claims to come from a sealed peer, refused</source>
        <translation>Ungeschütztes MAVLink, das angeblich von einer versiegelten Gegenstelle kommt, abgelehnt</translation>
    </message>
    <message>
        <source>from vehicle</source>
        <translation>vom Fahrzeug</translation>
    </message>
    <message>
        <source>to vehicle</source>
        <translation>zum Fahrzeug</translation>
    </message>
    <message>
        <source>stale</source>
        <translation>veraltet</translation>
    </message>
    <message>
        <source>Valid, but too late to command or to be shown</source>
        <translation>Gültig, aber zu spät für Befehle oder zur Anzeige</translation>
    </message>
</context>
<context>
    <name>skyseal::ui::DiagnosticsPanel</name>
    <message>
        <source>Suites compared</source>
        <translation>Chiffren im Vergleich</translation>
    </message>
    <message>
        <source>Comma-separated values (*.csv)</source>
        <translation>Kommagetrennte Werte (*.csv)</translation>
    </message>
    <message>
        <source>Save the picture</source>
        <translation>Bild speichern</translation>
    </message>
    <message>
        <source>Pictures (*.png *.svg)</source>
        <translation>Bilder (*.png *.svg)</translation>
    </message>
    <message>
        <source>%1 dashed</source>
        <translation>%1 gestrichelt</translation>
    </message>
    <message>
        <source>%1 dotted</source>
        <translation>%1 punktiert</translation>
    </message>
    <message>
        <source>%1 + bars</source>
        <translation>%1 + Balken</translation>
    </message>
    <message>
        <source>Save the samples shown</source>
        <translation>Gezeigte Messwerte speichern</translation>
    </message>
    <message>
        <source>The bars show only “%1”.</source>
        <translation>Die Balken zeigen nur „%1“.</translation>
    </message>
    <message>
        <source>The solid line is “%1”.</source>
        <translation>Die durchgezogene Linie ist „%1“.</translation>
    </message>
    <message>
        <source>Charts of the diagnostics</source>
        <translation>Diagramme der Diagnose</translation>
    </message>
    <message>
        <source>Connect to a vehicle to see the throughput, losses, latency and cost of its link.</source>
        <translation>Verbinden Sie ein Fahrzeug, um Durchsatz, Verluste, Latenz und Kosten seiner Verbindung zu sehen.</translation>
    </message>
    <message>
        <source>Cost of watching</source>
        <translation>Kosten des Beobachtens</translation>
    </message>
    <message>
        <source>CPU time of the link thread for the snapshots that this window shows and for these measurements, over the last second. The lines “link” and “process” contain it. A sweep measures without them, or states their share.</source>
        <translation>CPU-Zeit des Verbindungs-Threads für die Momentaufnahmen, die dieses Fenster zeigt, und für diese Messungen, in der letzten Sekunde. Die Linien „Verbindung“ und „Prozess“ enthalten sie. Eine Messreihe misst ohne sie oder nennt ihren Anteil.</translation>
    </message>
    <message>
        <source>CPU of the link thread: %1 % of a core, of it watching: %2 %</source>
        <translation>CPU des Verbindungs-Threads: %1 % eines Kerns, davon Beobachten: %2 %</translation>
    </message>
</context>
<context>
    <name>skyseal::ui::DiagnosticsTools</name>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>%1 min</source>
        <translation>%1 min</translation>
    </message>
    <message>
        <source>Over time</source>
        <translation>Zeitverlauf</translation>
    </message>
    <message>
        <source>Suites overlaid</source>
        <translation>Überlagert</translation>
    </message>
    <message>
        <source>Table</source>
        <translation>Tabelle</translation>
    </message>
    <message>
        <source>Sweep</source>
        <translation>Messreihe</translation>
    </message>
    <message>
        <source>Freeze</source>
        <translation>Einfrieren</translation>
    </message>
    <message>
        <source>Freeze the charts</source>
        <translation>Diagramme einfrieren</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Speichern</translation>
    </message>
    <message>
        <source>Save the measurements</source>
        <translation>Messwerte speichern</translation>
    </message>
    <message>
        <source>&amp;Picture as PNG or SVG…</source>
        <translation>&amp;Bild als PNG oder SVG…</translation>
    </message>
    <message>
        <source>Samples shown, as &amp;CSV…</source>
        <translation>Gezeigte Messwerte als &amp;CSV…</translation>
    </message>
    <message>
        <source>View of the measurements</source>
        <translation>Ansicht der Messwerte</translation>
    </message>
    <message>
        <source>Over time; all suites on one axis, by time in use; means as numbers; or the results of a sweep</source>
        <translation>Zeitverlauf; alle Chiffren auf einer Achse, nach Nutzungszeit; Mittelwerte als Zahlen; oder die Ergebnisse einer Messreihe</translation>
    </message>
    <message>
        <source>Quantities shown</source>
        <translation>Gezeigte Größen</translation>
    </message>
    <message>
        <source>Time range</source>
        <translation>Zeitbereich</translation>
    </message>
    <message>
        <source>Freezes the charts, not the measurement (Space). Drag over a chart or turn the wheel to zoom; a double click, Home or Esc returns to live.</source>
        <translation>Friert die Diagramme ein, nicht die Messung (Leertaste). Zum Zoomen über ein Diagramm ziehen oder das Mausrad drehen; Doppelklick, Pos1 oder Esc kehrt zu Live zurück.</translation>
    </message>
    <message>
        <source>The view &quot;Sweep&quot; is shown</source>
        <translation>Die Ansicht „Messreihe“ wird gezeigt</translation>
    </message>
    <message>
        <source>Shorter time range</source>
        <translation>Kürzerer Zeitbereich</translation>
    </message>
    <message>
        <source>Longer time range</source>
        <translation>Längerer Zeitbereich</translation>
    </message>
    <message>
        <source>Choose the view</source>
        <translation>Ansicht wählen</translation>
    </message>
    <message>
        <source>Choose the quantities</source>
        <translation>Größen wählen</translation>
    </message>
</context>
<context>
    <name>skyseal::ui::DisabledShortcuts</name>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
</context>
<context>
    <name>skyseal::ui::EdgeArrow</name>
    <message>
        <source>Vehicle %1 · %2</source>
        <translation>Fahrzeug %1 · %2</translation>
    </message>
</context>
<context>
    <name>skyseal::ui::EmergencyStop</name>
    <message>
        <source>Unlock</source>
        <translation>Entsperren</translation>
    </message>
    <message>
        <source>Emergency stop</source>
        <translation>Not-Aus</translation>
    </message>
    <message>
        <source>Unlock the emergency stop</source>
        <translation>Not-Aus entsperren</translation>
    </message>
    <message>
        <source>Stops the motors at once. A vehicle in the air falls. Hold for one second.</source>
        <translation>Stoppt die Motoren sofort. Ein Fahrzeug in der Luft stürzt ab. Eine Sekunde lang halten.</translation>
    </message>
    <message>
        <source>Unlocks the emergency stop for %1 s</source>
        <translation>Entsperrt den Not-Aus für %1 s</translation>
    </message>
    <message>
        <source>Locked: unlock it first</source>
        <translation>Gesperrt: zuerst entsperren</translation>
    </message>
    <message>
        <source>Go to the lock of the emergency stop</source>
        <translation>Zur Sperre des Not-Aus</translation>
    </message>
</context>
<context>
    <name>skyseal::ui::EmptyState</name>
    <message>
        <source>Start the demo</source>
        <translation>Demo starten</translation>
    </message>
    <message>
        <source>Add a link…</source>
        <translation>Verbindung hinzufügen…</translation>
    </message>
    <message>
        <source>Waiting for the autopilot behind %1</source>
        <translation>Warten auf den Autopiloten hinter %1</translation>
    </message>
    <message>
        <source>Replaying a log</source>
        <translation>Wiedergabe eines Logs</translation>
    </message>
    <message>
        <source>Nothing is connected</source>
        <translation>Nichts ist verbunden</translation>
    </message>
    <message>
        <source>Add a link to the vehicle, or listen for one on UDP port 14550.</source>
        <translation>Eine Verbindung zum Fahrzeug hinzufügen oder an UDP-Port 14550 auf ein Fahrzeug warten.</translation>
    </message>
    <message>
        <source>Waiting for a vehicle on %1</source>
        <translation>Warten auf ein Fahrzeug an %1</translation>
    </message>
    <message>
        <source>or let any autopilot send plain MAVLink here: it is shown, but not sealed.</source>
        <translation>oder einen beliebigen Autopiloten ungeschütztes MAVLink hierher senden lassen: Es wird angezeigt, aber nicht versiegelt.</translation>
    </message>
    <message>
        <source>The agent %1 does not answer</source>
        <translation>Der Agent %1 antwortet nicht</translation>
    </message>
    <message>
        <source>Allow plain MAVLink</source>
        <translation>Ungeschütztes MAVLink zulassen</translation>
    </message>
    <message>
        <source>Vehicle %1 is not sealed</source>
        <translation>Fahrzeug %1 ist nicht versiegelt</translation>
    </message>
    <message>
        <source>Command to run beside the autopilot</source>
        <translation>Befehl zur Ausführung neben dem Autopiloten</translation>
    </message>
    <message>
        <source>Keys and peers…</source>
        <translation>Schlüssel und Gegenstellen…</translation>
    </message>
    <message>
        <source>Open keys and peers</source>
        <translation>Schlüssel und Gegenstellen öffnen</translation>
    </message>
    <message>
        <source>It sends plain MAVLink from %1 and may be impersonating %2, which is a known peer but has not been heard yet. Its telemetry is not shown and nothing is sent to it until you allow plain MAVLink.

If it is the vehicle of %2, start the agent beside it instead, so that its link is sealed.</source>
        <translation>Es sendet ungeschütztes MAVLink von %1 und gibt sich möglicherweise als %2 aus, eine bekannte Gegenstelle, die noch nicht empfangen wurde. Seine Telemetrie wird nicht angezeigt und nichts an das Fahrzeug gesendet, bis ungeschütztes MAVLink zugelassen wird.

Ist es das Fahrzeug von %2, stattdessen den Agenten daneben starten, damit seine Verbindung versiegelt wird.</translation>
    </message>
    <message>
        <source>It is reachable at %1, but it does not answer the handshake. Does it know this station&apos;s key?

Its list of peers must contain the key with the fingerprint
%2

It also does not answer if it permits none of the suites that this station offers.</source>
        <translation>Er ist unter %1 erreichbar, beantwortet aber den Handshake nicht. Kennt er den Schlüssel dieser Station?

Seine Liste der Gegenstellen muss den Schlüssel mit diesem Fingerabdruck enthalten:
%2

Er antwortet auch nicht, wenn er keine der Chiffren zulässt, die diese Station anbietet.</translation>
    </message>
    <message>
        <source>An unknown agent</source>
        <translation>Ein unbekannter Agent</translation>
    </message>
    <message>
        <source>It announces itself from %1 with a key that is not in this station&apos;s list of peers. An announcement does not contain the fingerprint.

If the agent is yours, pair the two: choose Pair in Keys and peers here and, while the vehicle is disarmed, run beside the agent:</source>
        <translation>Er meldet sich von %1 mit einem Schlüssel, der nicht in der Liste der Gegenstellen dieser Station steht. Eine solche Meldung enthält den Fingerabdruck nicht.

Ist es der eigene Agent, die beiden koppeln: hier in Schlüssel und Gegenstellen „Koppeln“ wählen und, während das Fahrzeug unscharf ist, neben dem Agenten ausführen:</translation>
    </message>
    <message>
        <source>No vehicle in the log so far.</source>
        <translation>Bisher kein Fahrzeug im Log.</translation>
    </message>
    <message>
        <source>This station cannot use its key</source>
        <translation>Diese Station kann ihren Schlüssel nicht verwenden</translation>
    </message>
    <message>
        <source>%1

No link is sealed until this is resolved. Plain MAVLink is shown, but not sealed.</source>
        <translation>%1

Bis das behoben ist, wird keine Verbindung versiegelt. Ungeschütztes MAVLink wird angezeigt, ist aber nicht versiegelt.</translation>
    </message>
    <message>
        <source>The link to the agent is sealed; nothing has been received from its vehicle yet.</source>
        <translation>Die Verbindung zum Agenten ist versiegelt; von seinem Fahrzeug wurde noch nichts empfangen.</translation>
    </message>
    <message>
        <source>Start an agent, skyseal-air, beside an autopilot. If it has no key yet, the first line creates one; then pair the two in Security → Keys and peers:</source>
        <translation>Einen Agenten, skyseal-air, neben einem Autopiloten starten. Hat er noch keinen Schlüssel, erzeugt ihn die erste Zeile; danach die beiden in Sicherheit → Schlüssel und Gegenstellen koppeln:</translation>
    </message>
    <message>
        <source>Opening this station&apos;s key…</source>
        <translation>Der Schlüssel dieser Station wird geöffnet…</translation>
    </message>
    <message>
        <source>Its passphrase is being checked. Sealed links can start after that.</source>
        <translation>Seine Passphrase wird geprüft. Danach können versiegelte Verbindungen beginnen.</translation>
    </message>
</context>
<context>
    <name>skyseal::ui::EmptyText</name>
    <message>
        <source>Nothing matches the filter.</source>
        <translation>Nichts entspricht dem Filter.</translation>
    </message>
</context>
<context>
    <name>skyseal::ui::FencePainter</name>
    <message>
        <source>Stay inside</source>
        <translation>Erlaubter Bereich</translation>
    </message>
    <message>
        <source>Keep out</source>
        <translation>Sperrbereich</translation>
    </message>
    <message>
        <source>Fence return</source>
        <translation>Geofence-Rückkehr</translation>
    </message>
    <message>
        <source>Rally %1</source>
        <translation>Rally %1</translation>
    </message>
</context>
<context>
    <name>skyseal::ui::FieldModel</name>
    <message>
        <source>raw bytes</source>
        <translation>rohe Bytes</translation>
    </message>
    <message>
        <source>Field</source>
        <translation>Feld</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Einheit</translation>
    </message>
    <message>
        <source>Type</source>
        <translation>Typ</translation>
    </message>
</context>
<context>
    <name>skyseal::ui::FlightTarget</name>
    <message>
        <source>Target of vehicle %1</source>
        <translation>Ziel von Fahrzeug %1</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>Ziel</translation>
    </message>
</context>
<context>
    <name>skyseal::ui::GatewaySection</name>
    <message>
        <source>Serve other stations</source>
        <translation>Andere Stationen versorgen</translation>
    </message>
    <message>
        <source>Address for other stations</source>
        <translation>Adresse für andere Stationen</translation>
    </message>
    <message>
        <source>Stations connect to this TCP port</source>
        <translation>Stationen verbinden sich mit diesem TCP-Port</translation>
    </message>
    <message>
        <source>Stations send to this UDP port</source>
        <translation>Stationen senden an diesen UDP-Port</translation>
    </message>
    <message>
        <source>A station or a MAVSDK program listens on this UDP port</source>
        <translation>Eine Station oder ein MAVSDK-Programm lauscht auf diesem UDP-Port</translation>
    </message>
    <message>
        <source>Rights of other stations</source>
        <translation>Rechte anderer Stationen</translation>
    </message>
    <message>
        <source>Read only</source>
        <translation>Nur lesen</translation>
    </message>
    <message>
        <source>Read and write</source>
        <translation>Lesen und schreiben</translation>
    </message>
    <message>
        <source>State of the gateway</source>
        <translation>Zustand des Gateways</translation>
    </message>
    <message>
        <source>Connected stations</source>
        <translation>Verbundene Stationen</translation>
    </message>
    <message>
        <source>off</source>
        <translation>aus</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>no station is connected</source>
        <translation>keine Station verbunden</translation>
    </message>
    <message>
        <source>one station</source>
        <translation>eine Station</translation>
    </message>
    <message>
        <source>%1 stations</source>
        <translation>%1 Stationen</translation>
    </message>
    <message>
        <source>%1, open to other computers; %2</source>
        <translation>%1, offen für andere Rechner; %2</translation>
    </message>
    <message>
        <source>%1; %2</source>
        <translation>%1; %2</translation>
    </message>
    <message>
        <source>Lets QGroundControl, Mission Planner, MAVProxy and MAVSDK programs use the sealed link through this window</source>
        <translation>Lässt QGroundControl, Mission Planner, MAVProxy und MAVSDK-Programme die versiegelte Verbindung über dieses Fenster nutzen</translation>
    </message>
    <message>
        <source>One address, or several separated by spaces. Each may have options, e.g. udpout:127.0.0.1:14540,write=mission,param: write= narrows the rights chosen here. Other options: from=ADDRESS/PREFIX, sysid=ID and name=NAME</source>
        <translation>Eine Adresse oder mehrere, durch Leerzeichen getrennt. Jede kann Optionen haben, z. B. udpout:127.0.0.1:14540,write=mission,param: write= schränkt die hier gewählten Rechte ein. Weitere Optionen: from=ADRESSE/PRÄFIX, sysid=ID und name=NAME</translation>
    </message>
    <message>
        <source>Telemetry, parameters and missions can be read; commands, changes, files and logs are refused</source>
        <translation>Telemetrie, Parameter und Missionen sind lesbar; Befehle, Änderungen, Dateien und Logs werden abgelehnt</translation>
    </message>
    <message>
        <source>They can command vehicles, like this station; while they are connected, their heartbeats keep the vehicle&apos;s GCS failsafe from triggering</source>
        <translation>Können Fahrzeuge steuern wie diese Station; solange sie verbunden sind, verhindern ihre Heartbeats den GCS-Failsafe des Fahrzeugs</translation>
    </message>
    <message>
        <source>May write</source>
        <translation>Schreibrechte</translation>
    </message>
    <message>
        <source>What other stations may write</source>
        <translation>Was andere Stationen schreiben dürfen</translation>
    </message>
    <message>
        <source>What stations may write at the addresses beside, while &quot;Read and write&quot; is chosen</source>
        <translation>Was Stationen an den Adressen daneben schreiben dürfen, solange „Lesen und schreiben“ gewählt ist</translation>
    </message>
    <message>
        <source>arm, fly and stop the vehicles</source>
        <translation>die Fahrzeuge scharfschalten, fliegen und anhalten</translation>
    </message>
    <message>
        <source>change missions, fences and rally points</source>
        <translation>Missionen, Geofences und Rally-Punkte ändern</translation>
    </message>
    <message>
        <source>change parameters</source>
        <translation>Parameter ändern</translation>
    </message>
    <message>
        <source>change files and logs</source>
        <translation>Dateien und Logs ändern</translation>
    </message>
    <message>
        <source>Other stations can do as this window: %1.</source>
        <translation>Andere Stationen können wie dieses Fenster: %1.</translation>
    </message>
    <message>
        <source>What other stations can do</source>
        <translation>Was andere Stationen tun können</translation>
    </message>
    <message>
        <source>Change the address for other stations</source>
        <translation>Adresse für andere Stationen ändern</translation>
    </message>
    <message>
        <source>Change the rights of other stations</source>
        <translation>Rechte anderer Stationen ändern</translation>
    </message>
    <message>
        <source>&quot;Read and write&quot; is not chosen</source>
        <translation>„Lesen und schreiben“ ist nicht gewählt</translation>
    </message>
    <message>
        <source>Others may command</source>
        <translation>Andere dürfen befehlen</translation>
    </message>
    <message>
        <source>Others may write</source>
        <translation>Andere dürfen schreiben</translation>
    </message>
</context>
<context>
    <name>skyseal::ui::HelpDialog</name>
    <message>
        <source>Help</source>
        <translation>Hilfe</translation>
    </message>
    <message>
        <source>&amp;Back</source>
        <translation>&amp;Zurück</translation>
    </message>
</context>
<context>
    <name>skyseal::ui::HelpPage</name>
    <message>
        <source>There is no help page &quot;%1&quot;.</source>
        <translation>Es gibt keine Hilfeseite „%1“.</translation>
    </message>
    <message>
        <source>Help page</source>
        <translation>Hilfeseite</translation>
    </message>
</context>
<context>
    <name>skyseal::ui::HoldButton</name>
    <message>
        <source>Hold for half a second to confirm; Escape aborts</source>
        <translation>Zum Bestätigen eine halbe Sekunde halten; Esc bricht ab</translation>
    </message>
    <message>
        <source>Hold to confirm (mouse, Space or Enter); Esc aborts</source>
        <translation>Zum Bestätigen halten (Maus, Leertaste oder Eingabetaste); Esc bricht ab</translation>
    </message>
    <message>
        <source>Hold for %1 s to confirm; Escape aborts</source>
        <translation>Zum Bestätigen %1 s halten; Esc bricht ab</translation>
    </message>
</context>
<context>
    <name>skyseal::ui::Horizon</name>
    <message>
        <source>Artificial horizon</source>
        <translation>Künstlicher Horizont</translation>
    </message>
    <message>
        <source>roll %1°, pitch %2°, heading %3°</source>
        <translation>Rollen %1°, Nicken %2°, Kurs %3°</translation>
    </message>
    <message>
        <source>no attitude</source>
        <translation>keine Fluglage</translation>
    </message>
    <message>
        <source>roll</source>
        <translation>Rollen</translation>
    </message>
    <message>
        <source>hdg</source>
        <translation>Kurs</translation>
    </message>
    <message>
        <source>pitch</source>
        <translation>Nicken</translation>
    </message>
</context>
<context>
    <name>skyseal::ui::InspectorModel</name>
    <message>
        <source>%1 signed</source>
        <translation>%1 signiert</translation>
    </message>
    <message>
        <source>Message</source>
        <translation>Nachricht</translation>
    </message>
    <message>
        <source>From</source>
        <translation>Von</translation>
    </message>
    <message>
        <source>Rate</source>
        <translation>Rate</translation>
    </message>
    <message>
        <source>Count</source>
        <translation>Anzahl</translation>
    </message>
    <message>
        <source>MAVLink</source>
        <translation>MAVLink</translation>
    </message>
    <message>
        <source>ID</source>
        <translation>ID</translation>
    </message>
</context>
<context>
    <name>skyseal::ui::InspectorPanel</name>
    <message>
        <source>Filter by name</source>
        <translation>Nach Namen filtern</translation>
    </message>
    <message>
        <source>Message types</source>
        <translation>Nachrichtentypen</translation>
    </message>
    <message>
        <source>Fields of the selected message</source>
        <translation>Felder der ausgewählten Nachricht</translation>
    </message>
    <message>
        <source>Filter message types</source>
        <translation>Nachrichtentypen filtern</translation>
    </message>
    <message>
        <source>Each type of message is listed here once it arrives.</source>
        <translation>Jeder Nachrichtentyp steht hier, sobald eine Nachricht davon eintrifft.</translation>
    </message>
    <message>
        <source>Find a message type</source>
        <translation>Einen Nachrichtentyp suchen</translation>
    </message>
    <message>
        <source>Select a type of message to see its fields.</source>
        <translation>Wählen Sie einen Nachrichtentyp, um seine Felder zu sehen.</translation>
    </message>
</context>
<context>
    <name>skyseal::ui::KeysDialog</name>
    <message>
        <source>Keys and peers</source>
        <translation>Schlüssel und Gegenstellen</translation>
    </message>
    <message>
        <source>&amp;Add…</source>
        <translation>&amp;Hinzufügen…</translation>
    </message>
    <message>
        <source>Add a peer</source>
        <translation>Gegenstelle hinzufügen</translation>
    </message>
    <message>
        <source>&amp;Pair…</source>
        <translation>&amp;Koppeln…</translation>
    </message>
    <message>
        <source>Pair with an agent</source>
        <translation>Mit einem Agenten koppeln</translation>
    </message>
    <message>
        <source>&amp;Edit…</source>
        <translation>&amp;Bearbeiten…</translation>
    </message>
    <message>
        <source>Edit the selected peer</source>
        <translation>Ausgewählte Gegenstelle bearbeiten</translation>
    </message>
    <message>
        <source>&amp;Revoke…</source>
        <translation>&amp;Widerrufen…</translation>
    </message>
    <message>
        <source>Revoke the selected peer</source>
        <translation>Ausgewählte Gegenstelle widerrufen</translation>
    </message>
    <message>
        <source>Known peers</source>
        <translation>Bekannte Gegenstellen</translation>
    </message>
    <message>
        <source>Its session ends at once, and it can no longer connect.</source>
        <translation>Ihre Sitzung endet sofort, und sie kann sich nicht mehr verbinden.</translation>
    </message>
    <message>
        <source>It can no longer connect.</source>
        <translation>Sie kann sich nicht mehr verbinden.</translation>
    </message>
    <message>
        <source>Revoke %1?</source>
        <translation>%1 widerrufen?</translation>
    </message>
    <message>
        <source>Revoke</source>
        <translation>Widerrufen</translation>
    </message>
    <message>
        <source>No peers yet.

Add the public key of the agent beside your vehicle; skyseal-cli keys show prints it there. The agent also needs the key of this station.</source>
        <translation>Noch keine Gegenstellen.

Den öffentlichen Schlüssel des Agenten neben dem eigenen Fahrzeug hinzufügen; skyseal-cli keys show gibt ihn dort aus. Der Agent braucht auch den Schlüssel dieser Station.</translation>
    </message>
    <message>
        <source>No peers yet.

Pair with the agent of your vehicle, or add its public key, which skyseal-cli keys show prints there.</source>
        <translation>Noch keine Gegenstellen.

Mit dem Agenten des eigenen Fahrzeugs koppeln oder seinen öffentlichen Schlüssel hinzufügen, den skyseal-cli keys show dort ausgibt.</translation>
    </message>
    <message>
        <source>Vehicles %1 are armed. Revoke %2?</source>
        <translation>Die Fahrzeuge %1 sind scharf. %2 widerrufen?</translation>
    </message>
    <message>
        <source>Vehicle %1 is armed. Revoke %2?</source>
        <translation>Fahrzeug %1 ist scharf. %2 widerrufen?</translation>
    </message>
    <message>
        <source>They cannot be commanded from here then, and failsafes may trigger.</source>
        <translation>Sie lassen sich dann nicht mehr von hier steuern, und Failsafes können auslösen.</translation>
    </message>
    <message>
        <source>It cannot be commanded from here then, and failsafes may trigger.</source>
        <translation>Es lässt sich dann nicht mehr von hier steuern, und Failsafes können auslösen.</translation>
    </message>
</context>
<context>
    <name>skyseal::ui::Language</name>
    <message>
        <source>en</source>
        <comment>code of this language, as in the name of this file</comment>
        <translation>de</translation>
    </message>
</context>
<context>
    <name>skyseal::ui::LimitWatch</name>
    <message>
        <source>The low limit is %1.</source>
        <translation>Die untere Grenze ist %1.</translation>
    </message>
    <message>
        <source>The high limit is %1.</source>
        <translation>Die obere Grenze ist %1.</translation>
    </message>
    <message>
        <source>%1 low: %2</source>
        <translation>%1 niedrig: %2</translation>
    </message>
    <message>
        <source>%1 high: %2</source>
        <translation>%1 hoch: %2</translation>
    </message>
    <message>
        <source>%1 Passed %2 times.</source>
        <translation>%1 %2-mal verletzt.</translation>
    </message>
</context>
<context>
    <name>skyseal::ui::LinkConditions</name>
    <message>
        <source>Clea&amp;n</source>
        <translation>&amp;Ungestört</translation>
    </message>
    <message>
        <source>Packets lost</source>
        <translation>Verlorene Pakete</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>Delay</source>
        <translation>Verzögerung</translation>
    </message>
    <message>
        <source> ms</source>
        <translation> ms</translation>
    </message>
    <message>
        <source>Jitter: additional delay, up to this value</source>
        <translation>Jitter: zusätzliche Verzögerung, bis zu diesem Wert</translation>
    </message>
    <message>
        <source>Line rate</source>
        <translation>Leitungsrate</translation>
    </message>
    <message>
        <source> baud</source>
        <translation> Baud</translation>
    </message>
    <message>
        <source>In both directions</source>
        <translation>In beiden Richtungen</translation>
    </message>
    <message>
        <source>&amp;loss</source>
        <translation>V&amp;erlust</translation>
    </message>
    <message>
        <source>&amp;delay</source>
        <translation>Ver&amp;zögerung</translation>
    </message>
    <message>
        <source>&amp;jitter</source>
        <translation>&amp;Jitter</translation>
    </message>
    <message>
        <source>r&amp;ate</source>
        <translation>Ra&amp;te</translation>
    </message>
    <message>
        <source>Link between the agent and the station</source>
        <translation>Verbindung zwischen Agent und Station</translation>
    </message>
    <message>
        <source>Link · %1</source>
        <translation>Verbindung · %1</translation>
    </message>
    <message>
        <source>&amp;Other:</source>
        <translation>A&amp;ndere:</translation>
    </message>
    <message>
        <source>Another link</source>
        <translation>Andere Verbindung</translation>
    </message>
    <message>
        <source>&amp;57,600 baud radio</source>
        <translation>Funkmodem mit &amp;57.600 Baud</translation>
    </message>
    <message>
        <source>&amp;115,200 baud radio</source>
        <translation>Funkmodem mit &amp;115.200 Baud</translation>
    </message>
    <message>
        <source>no limit</source>
        <translation>unbegrenzt</translation>
    </message>
    <message>
        <source>&amp;921,600 baud line</source>
        <translation>Leitung mit &amp;921.600 Baud</translation>
    </message>
</context>
<context>
    <name>skyseal::ui::LinkDialog</name>
    <message>
        <source>Connect</source>
        <translation>Verbinden</translation>
    </message>
    <message>
        <source>Browse…</source>
        <translation>Durchsuchen…</translation>
    </message>
    <message>
        <source>Browse for the log file</source>
        <translation>Logdatei auswählen</translation>
    </message>
    <message>
        <source>&amp;Kind</source>
        <translation>&amp;Art</translation>
    </message>
    <message>
        <source>&amp;Host</source>
        <translation>&amp;Host</translation>
    </message>
    <message>
        <source>&amp;Port</source>
        <translation>&amp;Port</translation>
    </message>
    <message>
        <source>&amp;Device or file</source>
        <translation>&amp;Gerät oder Datei</translation>
    </message>
    <message>
        <source>&amp;Baud</source>
        <translation>&amp;Baud</translation>
    </message>
    <message>
        <source>&amp;Device</source>
        <translation>&amp;Gerät</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Datei</translation>
    </message>
    <message>
        <source>Replay a log</source>
        <translation>Log wiedergeben</translation>
    </message>
    <message>
        <source>Telemetry logs (*.tlog);;All files (*)</source>
        <translation>Telemetrie-Logs (*.tlog);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Sealed, or plain MAVLink</source>
        <translation>Versiegelt oder ungeschütztes MAVLink</translation>
    </message>
    <message>
        <source>the published key</source>
        <translation>der veröffentlichte Schlüssel</translation>
    </message>
    <message>
        <source>the published nonce</source>
        <translation>die veröffentlichte Nonce</translation>
    </message>
    <message>
        <source>Browse for the key file</source>
        <translation>Schlüsseldatei auswählen</translation>
    </message>
    <message>
        <source>P&amp;rotection</source>
        <translation>&amp;Schutz</translation>
    </message>
    <message>
        <source>K&amp;ey file</source>
        <translation>Sch&amp;lüsseldatei</translation>
    </message>
    <message>
        <source>&amp;Nonce</source>
        <translation>&amp;Nonce</translation>
    </message>
    <message>
        <source>Key of the stream</source>
        <translation>Schlüssel des Datenstroms</translation>
    </message>
    <message>
        <source>the published counter, %1</source>
        <translation>der veröffentlichte Zähler, %1</translation>
    </message>
    <message>
        <source>C&amp;ounter</source>
        <translation>&amp;Zähler</translation>
    </message>
    <message>
        <source>INSECURE: MAVSec 2019, ChaCha20, receive only</source>
        <translation>UNSICHER: MAVSec 2019, ChaCha20, nur Empfang</translation>
    </message>
    <message>
        <source>INSECURE: MAVSec 2019, AES-256-CTR, receive only</source>
        <translation>UNSICHER: MAVSec 2019, AES-256-CTR, nur Empfang</translation>
    </message>
    <message>
        <source>URL of the link</source>
        <translation>URL der Verbindung</translation>
    </message>
    <message>
        <source>%1
INSECURE: anyone can read, change and forge this stream. Nothing is sent.</source>
        <translation>%1
UNSICHER: Jeder kann diesen Datenstrom mitlesen, verändern und fälschen. Nichts wird gesendet.</translation>
    </message>
    <message>
        <source>The nonce must have %1 hex digits</source>
        <translation>Die Nonce muss %1 Hex-Ziffern haben</translation>
    </message>
    <message>
        <source>The counter must be a number from 0 to 4294967295</source>
        <translation>Der Zähler muss eine Zahl von 0 bis 4294967295 sein</translation>
    </message>
    <message>
        <source>A link stays open until Skyseal closes. The one to open at start is in File → Settings.</source>
        <translation>Eine Verbindung bleibt offen, bis Skyseal beendet wird. Die Verbindung beim Start steht unter Datei → Einstellungen.</translation>
    </message>
    <message>
        <source>Skyseal itself listens there, with %1</source>
        <translation>Skyseal selbst empfängt dort, mit %1</translation>
    </message>
    <message>
        <source>Skyseal itself sends there, with %1</source>
        <translation>Skyseal selbst sendet dorthin, mit %1</translation>
    </message>
    <message>
        <source>Skyseal already listens there, with %1</source>
        <translation>Skyseal empfängt dort schon, mit %1</translation>
    </message>
</context>
<context>
    <name>skyseal::ui::LinkEnded</name>
    <message>
        <source>the agent</source>
        <translation>Agent</translation>
    </message>
    <message>
        <source>Revoked · %1</source>
        <translation>Widerrufen · %1</translation>
    </message>
    <message>
        <source>Session lost · %1</source>
        <translation>Sitzung verloren · %1</translation>
    </message>
    <message>
        <source>Session ended · %1</source>
        <translation>Sitzung beendet · %1</translation>
    </message>
    <message>
        <source>The session with %1 ended %2 ago: %3.</source>
        <translation>Die Sitzung mit %1 endete vor %2: %3.</translation>
    </message>
    <message>
        <source>New session · %1</source>
        <translation>Neue Sitzung · %1</translation>
    </message>
    <message>
        <source>The sweep changes the protection of the link, which needs a new handshake.</source>
        <translation>Die Messreihe ändert den Schutz der Verbindung, was einen neuen Handshake erfordert.</translation>
    </message>
    <message>
        <source>%1 was silent for too long; the session ended %2 ago.</source>
        <translation>%1 war zu lange stumm; die Sitzung endete vor %2.</translation>
    </message>
    <message>
        <source>Waiting: the session is re-established automatically when the agent is heard again. The last received values are shown. Plain MAVLink with the vehicle&apos;s system ID is still refused.</source>
        <translation>Warten: Die Sitzung wird automatisch wieder aufgebaut, sobald der Agent wieder empfangen wird. Gezeigt werden die zuletzt empfangenen Werte. Ungeschütztes MAVLink mit der System-ID des Fahrzeugs wird weiterhin abgelehnt.</translation>
    </message>
    <message>
        <source>%1 is no longer a known peer: its session ended %2 ago and cannot be re-established. The last received values are shown. Pair it again to continue.</source>
        <translation>%1 ist keine bekannte Gegenstelle mehr: Die Sitzung endete vor %2 und kann nicht wieder aufgebaut werden. Gezeigt werden die zuletzt empfangenen Werte. Zum Fortfahren erneut koppeln.</translation>
    </message>
</context>
<context>
    <name>skyseal::ui::LinkEventText</name>
    <message>
        <source>one unreadable line about ciphers</source>
        <translation>eine unlesbare Zeile über Chiffren</translation>
    </message>
    <message>
        <source>%1 unreadable lines about ciphers</source>
        <translation>%1 unlesbare Zeilen über Chiffren</translation>
    </message>
</context>
<context>
    <name>skyseal::ui::LinkModel</name>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
    </message>
    <message>
        <source>Link</source>
        <translation>Verbindung</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Zustand</translation>
    </message>
    <message>
        <source>Received</source>
        <translation>Empfangen</translation>
    </message>
    <message>
        <source>Sent</source>
        <translation>Gesendet</translation>
    </message>
    <message>
        <source>Bad frames</source>
        <translation>Fehlerhaft</translation>
    </message>
    <message>
        <source>%1 · MAVSec 2019, INSECURE, receive only</source>
        <translation>%1 · MAVSec 2019, UNSICHER, nur Empfang</translation>
    </message>
    <message>
        <source>Local</source>
        <translation>Lokal</translation>
    </message>
    <message>
        <source>Remote</source>
        <translation>Gegenseite</translation>
    </message>
</context>
<context>
    <name>skyseal::ui::LinkPopover</name>
    <message>
        <source>Secure link</source>
        <translation>Sichere Verbindung</translation>
    </message>
    <message>
        <source>Open secure link</source>
        <translation>Sichere Verbindung öffnen</translation>
    </message>
</context>
<context>
    <name>skyseal::ui::LinksPanel</name>
    <message>
        <source>Add…</source>
        <translation>Hinzufügen…</translation>
    </message>
    <message>
        <source>Add a link</source>
        <translation>Verbindung hinzufügen</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Remove the selected link</source>
        <translation>Ausgewählte Verbindung entfernen</translation>
    </message>
    <message>
        <source>Links</source>
        <translation>Verbindungen</translation>
    </message>
    <message>
        <source>Remove the link</source>
        <translation>Verbindung entfernen</translation>
    </message>
    <message>
        <source>Vehicle %1 on this link is armed. Remove the link?</source>
        <translation>Fahrzeug %1 auf dieser Verbindung ist scharf. Verbindung entfernen?</translation>
    </message>
    <message>
        <source>Vehicles %1 on this link are armed. Remove the link?</source>
        <translation>Die Fahrzeuge %1 auf dieser Verbindung sind scharf. Verbindung entfernen?</translation>
    </message>
    <message>
        <source>Without this link, its vehicles cannot be commanded from here, and failsafes may trigger.</source>
        <translation>Ohne diese Verbindung lassen sich ihre Fahrzeuge nicht von hier steuern, und Failsafes können auslösen.</translation>
    </message>
    <message>
        <source>No links: add one to hear a vehicle.</source>
        <translation>Keine Verbindung: eine hinzufügen, um ein Fahrzeug zu hören.</translation>
    </message>
    <message>
        <source>Select a link first</source>
        <translation>Wählen Sie zuerst eine Verbindung aus</translation>
    </message>
</context>
<context>
    <name>skyseal::ui::LockFace</name>
    <message>
        <source>peer</source>
        <translation>Gegenstelle</translation>
    </message>
    <message>
        <source>Sealed with %1 for %2
Peer %3 at %4
Fingerprint %5</source>
        <translation>Versiegelt mit %1, Dauer %2
Gegenstelle %3 unter %4
Fingerabdruck %5</translation>
    </message>
    <message>
        <source>Nothing sealed</source>
        <translation>Nichts versiegelt</translation>
    </message>
    <message>
        <source>No vehicle and no session yet</source>
        <translation>Noch kein Fahrzeug und keine Sitzung</translation>
    </message>
    <message>
        <source>Not sealed · plain MAVLink</source>
        <translation>Nicht versiegelt · ungeschütztes MAVLink</translation>
    </message>
    <message>
        <source>Not sealed</source>
        <translation>Nicht versiegelt</translation>
    </message>
    <message>
        <source>switching…</source>
        <translation>wechselt…</translation>
    </message>
    <message>
        <source>Switching to %1</source>
        <translation>Wechsel zu %1</translation>
    </message>
    <message>
        <source>%1 refused</source>
        <translation>%1 abgelehnt</translation>
    </message>
    <message>
        <source>under attack, %1</source>
        <translation>unter Angriff, %1</translation>
    </message>
    <message>
        <source>epoch %1</source>
        <translation>Epoche %1</translation>
    </message>
    <message>
        <source>%1 does not answer</source>
        <translation>%1 antwortet nicht</translation>
    </message>
    <message>
        <source>No answer</source>
        <translation>Keine Antwort</translation>
    </message>
    <message>
        <source>Revoked</source>
        <translation>Widerrufen</translation>
    </message>
    <message>
        <source>No session</source>
        <translation>Keine Sitzung</translation>
    </message>
    <message>
        <source>changing keys…</source>
        <translation>wechselt Schlüssel…</translation>
    </message>
    <message>
        <source>Not sealed · vehicle %1 needs approval</source>
        <translation>Nicht versiegelt · Fahrzeug %1 braucht Freigabe</translation>
    </message>
    <message>
        <source>Not sealed · needs approval</source>
        <translation>Nicht versiegelt · braucht Freigabe</translation>
    </message>
    <message>
        <source>Anyone on the path can read and change the traffic. Start skyseal-air beside the vehicle to seal the link.</source>
        <translation>Jeder auf der Übertragungsstrecke kann den Verkehr mitlesen und verändern. Um die Verbindung zu versiegeln, skyseal-air neben dem Fahrzeug starten.</translation>
    </message>
    <message>
        <source>No sealed links: this station cannot use its key</source>
        <translation>Keine versiegelte Verbindung: Diese Station kann ihren Schlüssel nicht verwenden</translation>
    </message>
    <message>
        <source>Not sealed · sweep running</source>
        <translation>Nicht versiegelt · Messreihe läuft</translation>
    </message>
    <message>
        <source>The sweep is measuring plain MAVLink, with your consent: anyone on the path can read and change the traffic. The sweep seals the link again afterwards.</source>
        <translation>Die Messreihe misst gerade ungeschütztes MAVLink, mit hier gegebener Zustimmung: Jeder auf der Übertragungsstrecke kann den Verkehr mitlesen und verändern. Danach versiegelt die Messreihe die Verbindung wieder.</translation>
    </message>
    <message>
        <source>New keys are being negotiated</source>
        <translation>Neue Schlüssel werden ausgehandelt</translation>
    </message>
    <message>
        <source>No sealed links yet: this station&apos;s key is being opened</source>
        <translation>Noch keine versiegelte Verbindung: Der Schlüssel dieser Station wird geöffnet</translation>
    </message>
    <message>
        <source>Under attack: %1 forged or replayed records since the link came up. All of them were refused.</source>
        <translation>Unter Angriff: %1 gefälschte oder wiedereingespielte Records seit Beginn der Verbindung. Alle wurden abgelehnt.</translation>
    </message>
    <message>
        <source>Under attack: %1 spoofed frames of this vehicle since the link came up. All of them were refused.</source>
        <translation>Unter Angriff: %1 vorgetäuschte Frames dieses Fahrzeugs seit Beginn der Verbindung. Alle wurden abgelehnt.</translation>
    </message>
    <message>
        <source>Vehicle %1 at %2 may be impersonating %3, which has not been heard yet. Its telemetry is not shown and nothing is sent to it until you allow it: Security → Allow plain MAVLink.</source>
        <translation>Fahrzeug %1 unter %2 gibt sich möglicherweise als %3 aus (noch nicht empfangen). Seine Telemetrie wird nicht angezeigt und nichts an das Fahrzeug gesendet, bis es freigegeben ist: Sicherheit → Ungeschütztes MAVLink zulassen.</translation>
    </message>
</context>
<context>
    <name>skyseal::ui::LogsPanel</name>
    <message>
        <source>Record received and sent frames</source>
        <translation>Empfangene und gesendete Frames aufzeichnen</translation>
    </message>
    <message>
        <source>Replay a log…</source>
        <translation>Log wiedergeben…</translation>
    </message>
    <message>
        <source>Replay a log</source>
        <translation>Log wiedergeben</translation>
    </message>
    <message>
        <source>Open the folder</source>
        <translation>Ordner öffnen</translation>
    </message>
    <message>
        <source>File being recorded</source>
        <translation>Datei der laufenden Aufzeichnung</translation>
    </message>
    <message>
        <source>file</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>frames</source>
        <translation>Frames</translation>
    </message>
    <message>
        <source>dropped</source>
        <translation>verworfen</translation>
    </message>
</context>
<context>
    <name>skyseal::ui::MainWindow</name>
    <message>
        <source>Skyseal</source>
        <translation>Skyseal</translation>
    </message>
    <message>
        <source>Status</source>
        <translation>Status</translation>
    </message>
    <message>
        <source>End the demo before you replay a log</source>
        <translation>Vor der Wiedergabe eines Logs die Demo beenden</translation>
    </message>
    <message>
        <source>Skyseal: demo</source>
        <translation>Skyseal: Demo</translation>
    </message>
    <message>
        <source>End the demo before you add a link</source>
        <translation>Vor dem Hinzufügen einer Verbindung die Demo beenden</translation>
    </message>
    <message>
        <source>Menus</source>
        <translation>Menüs</translation>
    </message>
    <message>
        <source>Flight actions</source>
        <translation>Flugaktionen</translation>
    </message>
    <message>
        <source>Place on the map</source>
        <translation>Ort auf der Karte</translation>
    </message>
    <message>
        <source>Alerts</source>
        <translation>Meldungen</translation>
    </message>
    <message>
        <source>Replay and demo</source>
        <translation>Wiedergabe und Demo</translation>
    </message>
    <message>
        <source>Problem</source>
        <translation>Problem</translation>
    </message>
    <message>
        <source>Last run</source>
        <translation>Letzter Lauf</translation>
    </message>
</context>
<context>
    <name>skyseal::ui::MapAlerts</name>
    <message>
        <source>Go to the a&amp;lerts</source>
        <translation>Zu den Mel&amp;dungen</translation>
    </message>
    <message>
        <source>No alerts</source>
        <translation>Keine Meldungen</translation>
    </message>
</context>
<context>
    <name>skyseal::ui::MapMenu</name>
    <message>
        <source>Change &amp;altitude…</source>
        <translation>&amp;Höhe ändern…</translation>
    </message>
    <message>
        <source>&amp;Measure from here</source>
        <translation>Von hier &amp;messen</translation>
    </message>
    <message>
        <source>&amp;Copy coordinates</source>
        <translation>Koordinaten k&amp;opieren</translation>
    </message>
    <message>
        <source>The mode changes from %1 to %2.</source>
        <translation>Der Modus wechselt von %1 zu %2.</translation>
    </message>
    <message>
        <source>&amp;Go here…</source>
        <translation>Diesen Ort &amp;ansteuern…</translation>
    </message>
    <message>
        <source>Set &amp;home here…</source>
        <translation>Home hierher &amp;setzen…</translation>
    </message>
    <message>
        <source>the altitude of home is not known</source>
        <translation>die Höhe von Home ist nicht bekannt</translation>
    </message>
    <message>
        <source>%1, %2 from the vehicle</source>
        <translation>%1, %2 vom Fahrzeug</translation>
    </message>
    <message>
        <source>Add &amp;to the mission…</source>
        <translation>&amp;Zur Mission hinzufügen…</translation>
    </message>
    <message>
        <source>the mission has not been read: Plan, Read from the vehicle</source>
        <translation>die Mission wurde nicht gelesen: Planen, Vom Fahrzeug lesen</translation>
    </message>
    <message>
        <source>&amp;Point camera here…</source>
        <translation>&amp;Kamera hierher richten…</translation>
    </message>
    <message>
        <source>Point the camera at this location?
%1</source>
        <translation>Kamera auf diesen Ort richten?
%1</translation>
    </message>
    <message>
        <source>The target is at the altitude of home. A copter whose camera cannot pan yaws instead.</source>
        <translation>Das Ziel liegt in der Höhe von Home. Ein Copter, dessen Kamera nicht schwenken kann, giert stattdessen.</translation>
    </message>
    <message>
        <source>&amp;Stop pointing camera…</source>
        <translation>Kameraausrichtung &amp;beenden…</translation>
    </message>
    <message>
        <source>Stop pointing the camera at a location?</source>
        <translation>Ausrichtung der Kamera auf einen Ort beenden?</translation>
    </message>
    <message>
        <source>Go to this location?
%1</source>
        <translation>Diesen Ort ansteuern?
%1</translation>
    </message>
    <message>
        <source>Go to this location at %1 above home?
%2</source>
        <translation>Diesen Ort in %1 Höhe über Home ansteuern?
%2</translation>
    </message>
    <message>
        <source>Set home to this location?
%1</source>
        <translation>Home auf diesen Ort setzen?
%1</translation>
    </message>
    <message>
        <source>RTL will fly there. The altitude of home stays the same; the ground elevation there is not known.</source>
        <translation>RTL fliegt dann dorthin. Die Höhe von Home bleibt gleich; die Geländehöhe dort ist nicht bekannt.</translation>
    </message>
    <message>
        <source>Pa&amp;use…</source>
        <translation>Pa&amp;use…</translation>
    </message>
    <message>
        <source>Stop and hold the present position?</source>
        <translation>Anhalten und an der aktuellen Position bleiben?</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>Ziel</translation>
    </message>
    <message>
        <source>the mission is outdated (%1): Plan, Read again</source>
        <translation>die Mission ist veraltet (%1): Planen, Neu lesen</translation>
    </message>
</context>
<context>
    <name>skyseal::ui::MapPainter</name>
    <message>
        <source>N</source>
        <translation>N</translation>
    </message>
    <message>
        <source>Map: %1</source>
        <translation>Karte: %1</translation>
    </message>
    <message>
        <source>altitude</source>
        <translation>Höhe</translation>
    </message>
    <message>
        <source>speed</source>
        <translation>Geschwindigkeit</translation>
    </message>
    <message>
        <source>link quality</source>
        <translation>Empfangsqualität</translation>
    </message>
</context>
<context>
    <name>skyseal::ui::MapRotation</name>
    <message>
        <source>&amp;Rotate the map with the vehicle</source>
        <translation>Karte mit dem Fahrzeug d&amp;rehen</translation>
    </message>
</context>
<context>
    <name>skyseal::ui::MapSourceDialog</name>
    <message>
        <source>Map source</source>
        <translation>Kartenquelle</translation>
    </message>
    <message>
        <source>A tile &amp;server</source>
        <translation>Ein Kachel&amp;server</translation>
    </message>
    <message>
        <source>A tile server</source>
        <translation>Ein Kachelserver</translation>
    </message>
    <message>
        <source>Address of the tiles</source>
        <translation>Adresse der Kacheln</translation>
    </message>
    <message>
        <source>Attribution</source>
        <translation>Quellenangabe</translation>
    </message>
    <message>
        <source>&amp;Address</source>
        <translation>&amp;Adresse</translation>
    </message>
    <message>
        <source>A&amp;ttribution</source>
        <translation>&amp;Quellenangabe</translation>
    </message>
    <message>
        <source>&amp;Browse…</source>
        <translation>&amp;Durchsuchen…</translation>
    </message>
    <message>
        <source>No file is chosen</source>
        <translation>Keine Datei ausgewählt</translation>
    </message>
    <message>
        <source>&amp;No imagery: lines of latitude and longitude</source>
        <translation>&amp;Keine Bilder: Breiten- und Längengrade als Linien</translation>
    </message>
    <message>
        <source>No imagery</source>
        <translation>Keine Bilder</translation>
    </message>
    <message>
        <source>© map data; required by most servers</source>
        <translation>© Kartendaten; von den meisten Servern verlangt</translation>
    </message>
    <message>
        <source>Maximum zoom level</source>
        <translation>Größte Zoomstufe</translation>
    </message>
    <message>
        <source>Ma&amp;ximum zoom level</source>
        <translation>Größte &amp;Zoomstufe</translation>
    </message>
    <message>
        <source>The server learns which areas you view and when, and thus where you fly, and the address of this computer. With http://, anyone on the path learns it too. Nothing is requested until you press OK; received tiles are kept on this computer.</source>
        <translation>Der Server erfährt, wann welche Gebiete betrachtet werden, und damit, wo geflogen wird, sowie die Adresse dieses Rechners. Bei http:// erfährt es auch jeder auf der Übertragungsstrecke. Vor dem Drücken von OK wird nichts angefragt; empfangene Kacheln bleiben auf diesem Rechner.</translation>
    </message>
    <message>
        <source>Tiles will be requested from %1</source>
        <translation>Kacheln werden bei %1 angefragt</translation>
    </message>
    <message>
        <source>A &amp;file on this computer (MBTiles or GeoPackage)</source>
        <translation>Eine &amp;Datei auf diesem Rechner (MBTiles oder GeoPackage)</translation>
    </message>
    <message>
        <source>A file of map tiles</source>
        <translation>Eine Datei mit Kartenkacheln</translation>
    </message>
    <message>
        <source>File of map tiles</source>
        <translation>Datei mit Kartenkacheln</translation>
    </message>
    <message>
        <source>Browse for a file of map tiles</source>
        <translation>Datei mit Kartenkacheln auswählen</translation>
    </message>
    <message>
        <source>Map tiles (*.mbtiles *.gpkg);;All files (*)</source>
        <translation>Kartenkacheln (*.mbtiles *.gpkg);;Alle Dateien (*)</translation>
    </message>
</context>
<context>
    <name>skyseal::ui::MapView</name>
    <message>
        <source>Map</source>
        <translation>Karte</translation>
    </message>
    <message>
        <source>%1. Enter sets a point at the centre of the map, Backspace removes the last, Escape ends</source>
        <translation>%1. Eingabetaste setzt einen Punkt in der Kartenmitte, Rücktaste entfernt den letzten, Esc beendet</translation>
    </message>
    <message>
        <source>Arrow keys move the map, plus and minus zoom, Home follows the vehicle, Menu opens the commands for the centre</source>
        <translation>Pfeiltasten bewegen die Karte, Plus und Minus zoomen, Pos1 folgt dem Fahrzeug, Menütaste öffnet die Befehle für die Mitte</translation>
    </message>
    <message>
        <source>The vehicle is beyond the map, %1 from its centre.</source>
        <translation>Das Fahrzeug ist außerhalb der Karte, %1 von ihrer Mitte entfernt.</translation>
    </message>
    <message>
        <source>A click centres the map on it.</source>
        <translation>Ein Klick zentriert die Karte darauf.</translation>
    </message>
    <message>
        <source>A click or %1 centres the map on it.</source>
        <translation>Ein Klick oder %1 zentriert die Karte darauf.</translation>
    </message>
</context>
<context>
    <name>skyseal::ui::MbtilesWriter</name>
    <message>
        <source>%1 cannot be written: %2</source>
        <translation>%1 lässt sich nicht schreiben: %2</translation>
    </message>
    <message>
        <source>%1 cannot be written</source>
        <translation>%1 lässt sich nicht schreiben</translation>
    </message>
    <message>
        <source>%1 cannot be replaced</source>
        <translation>%1 lässt sich nicht ersetzen</translation>
    </message>
</context>
<context>
    <name>skyseal::ui::MeasurePainter</name>
    <message>
        <source>Click or Enter sets a point, Backspace removes the last, Esc ends</source>
        <translation>Klick oder Eingabetaste setzt einen Punkt, Rücktaste entfernt den letzten, Esc beendet</translation>
    </message>
</context>
<context>
    <name>skyseal::ui::MeasureTool</name>
    <message>
        <source>M&amp;easure on the map</source>
        <translation>Auf der Karte &amp;messen</translation>
    </message>
    <message>
        <source>Measure: set the first point</source>
        <translation>Messen: ersten Punkt setzen</translation>
    </message>
    <message>
        <source>Measure: set the next point</source>
        <translation>Messen: nächsten Punkt setzen</translation>
    </message>
    <message>
        <source>%1 in one leg</source>
        <translation>%1 in einem Abschnitt</translation>
    </message>
    <message>
        <source>%1 in %2 legs</source>
        <translation>%1 in %2 Abschnitten</translation>
    </message>
</context>
<context>
    <name>skyseal::ui::MenuBarFocus</name>
    <message>
        <source>Open the first menu</source>
        <translation>Das erste Menü öffnen</translation>
    </message>
</context>
<context>
    <name>skyseal::ui::MessageModel</name>
    <message>
        <source>station</source>
        <translation>Station</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>From</source>
        <translation>Von</translation>
    </message>
    <message>
        <source>Severity</source>
        <translation>Stufe</translation>
    </message>
    <message>
        <source>Message</source>
        <translation>Nachricht</translation>
    </message>
</context>
<context>
    <name>skyseal::ui::MessagesPanel</name>
    <message>
        <source>Messages</source>
        <translation>Nachrichten</translation>
    </message>
    <message>
        <source>station</source>
        <translation>Station</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Kopieren</translation>
    </message>
    <message>
        <source>Filter</source>
        <translation>Filter</translation>
    </message>
    <message>
        <source>all</source>
        <translation>alle</translation>
    </message>
    <message>
        <source>notices and above</source>
        <translation>ab Hinweis</translation>
    </message>
    <message>
        <source>warnings and above</source>
        <translation>ab Warnung</translation>
    </message>
    <message>
        <source>errors and above</source>
        <translation>ab Fehler</translation>
    </message>
    <message>
        <source>Copy the messages</source>
        <translation>Nachrichten kopieren</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>Leeren</translation>
    </message>
    <message>
        <source>Clear the messages</source>
        <translation>Nachrichtenliste leeren</translation>
    </message>
    <message>
        <source>Replay: %1</source>
        <translation>Wiedergabe: %1</translation>
    </message>
    <message>
        <source>Filter messages</source>
        <translation>Nachrichten filtern</translation>
    </message>
    <message>
        <source>Minimum severity shown</source>
        <translation>Niedrigster angezeigter Schweregrad</translation>
    </message>
    <message>
        <source>%1. To accept it, choose Security → Allow plain MAVLink</source>
        <translation>%1. Zum Annehmen Sicherheit → Ungeschütztes MAVLink zulassen wählen</translation>
    </message>
    <message>
        <source>%1. To pair with it, open Security → Keys and peers</source>
        <translation>%1. Zum Koppeln Sicherheit → Schlüssel und Gegenstellen öffnen</translation>
    </message>
    <message>
        <source>Messages of vehicles and of the station are listed here.</source>
        <translation>Hier stehen die Nachrichten der Fahrzeuge und der Station.</translation>
    </message>
    <message>
        <source>Find a message</source>
        <translation>Eine Nachricht suchen</translation>
    </message>
</context>
<context>
    <name>skyseal::ui::MissionModel</name>
    <message>
        <source>home</source>
        <translation>Home</translation>
    </message>
    <message>
        <source>%1 (now)</source>
        <translation>%1 (jetzt)</translation>
    </message>
    <message>
        <source>No.</source>
        <translation>Nr.</translation>
    </message>
    <message>
        <source>Command</source>
        <translation>Befehl</translation>
    </message>
    <message>
        <source>Latitude</source>
        <translation>Breite</translation>
    </message>
    <message>
        <source>Longitude</source>
        <translation>Länge</translation>
    </message>
    <message>
        <source>Altitude</source>
        <translation>Höhe</translation>
    </message>
    <message>
        <source>%1 MSL</source>
        <translation>%1 über NN</translation>
    </message>
    <message>
        <source>%1 above ground</source>
        <translation>%1 über Grund</translation>
    </message>
</context>
<context>
    <name>skyseal::ui::MissionPainter</name>
    <message>
        <source>outdated</source>
        <translation>veraltet</translation>
    </message>
</context>
<context>
    <name>skyseal::ui::MissionPanel</name>
    <message>
        <source>Read from the vehicle</source>
        <translation>Vom Fahrzeug lesen</translation>
    </message>
    <message>
        <source>Send a file…</source>
        <translation>Datei senden…</translation>
    </message>
    <message>
        <source>Save as…</source>
        <translation>Speichern als…</translation>
    </message>
    <message>
        <source>Result of the last transfer</source>
        <translation>Ergebnis der letzten Übertragung</translation>
    </message>
    <message>
        <source>Mission items</source>
        <translation>Missionspunkte</translation>
    </message>
    <message>
        <source>Missions (*.waypoints *.txt);;All files (*)</source>
        <translation>Missionen (*.waypoints *.txt);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Send a mission</source>
        <translation>Mission senden</translation>
    </message>
    <message>
        <source>Save the mission</source>
        <translation>Mission speichern</translation>
    </message>
    <message>
        <source>Sending %1 items…</source>
        <translation>%1 Punkte werden gesendet…</translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation>%1 gespeichert</translation>
    </message>
    <message>
        <source>Not sent: %1</source>
        <translation>Nicht gesendet: %1</translation>
    </message>
    <message>
        <source>another vehicle is selected</source>
        <translation>ein anderes Fahrzeug ist ausgewählt</translation>
    </message>
    <message>
        <source>Sending one item…</source>
        <translation>Ein Punkt wird gesendet…</translation>
    </message>
    <message>
        <source>The vehicle has no mission. Send a file to write one.</source>
        <translation>Das Fahrzeug hat keine Mission. Zum Schreiben eine Datei senden.</translation>
    </message>
    <message>
        <source>Send a mission to vehicle %1</source>
        <translation>Mission an Fahrzeug %1 senden</translation>
    </message>
    <message>
        <source>The mission, and the fence and rally points if the vehicle has them</source>
        <translation>Die Mission sowie Geofence und Rally-Punkte, falls das Fahrzeug sie hat</translation>
    </message>
    <message>
        <source>There are no items to save</source>
        <translation>Es gibt keine Punkte zum Speichern</translation>
    </message>
    <message>
        <source>%1 cannot be read: %2</source>
        <translation>%1 kann nicht gelesen werden: %2</translation>
    </message>
    <message>
        <source>The vehicle is armed. Replace its mission?</source>
        <translation>Das Fahrzeug ist scharf. Seine Mission ersetzen?</translation>
    </message>
    <message>
        <source>Vehicle %1 is armed. Replace its mission?</source>
        <translation>Fahrzeug %1 ist scharf. Seine Mission ersetzen?</translation>
    </message>
    <message>
        <source>While it flies its mission, it turns to the new one at once.</source>
        <translation>Solange es seine Mission fliegt, wechselt es sofort zur neuen.</translation>
    </message>
    <message>
        <source>Replace the mission</source>
        <translation>Mission ersetzen</translation>
    </message>
    <message>
        <source>No vehicle. Its mission is listed here once it has been read.</source>
        <translation>Kein Fahrzeug. Seine Mission steht hier, sobald sie gelesen ist.</translation>
    </message>
    <message>
        <source>The mission has not been read yet: choose Read from the vehicle.</source>
        <translation>Die Mission wurde noch nicht gelesen: Wählen Sie „Vom Fahrzeug lesen“.</translation>
    </message>
    <message>
        <source>Read again</source>
        <translation>Neu lesen</translation>
    </message>
    <message>
        <source>Replace the mission of another station?</source>
        <translation>Die Mission einer anderen Station ersetzen?</translation>
    </message>
    <message>
        <source>Replace the mission of another station on vehicle %1?</source>
        <translation>Die Mission einer anderen Station auf Fahrzeug %1 ersetzen?</translation>
    </message>
    <message>
        <source>The mission of the vehicle was %1. Read it to see what it is.</source>
        <translation>Die Mission des Fahrzeugs wurde %1. Sie ist zu lesen, um zu sehen, was sie enthält.</translation>
    </message>
    <message>
        <source>The vehicle is armed.</source>
        <translation>Das Fahrzeug ist scharf.</translation>
    </message>
    <message>
        <source>Mission outdated: %1</source>
        <translation>Mission veraltet: %1</translation>
    </message>
    <message>
        <source>Fence outdated: %1</source>
        <translation>Geofence veraltet: %1</translation>
    </message>
    <message>
        <source>Rally points outdated: %1</source>
        <translation>Rally-Punkte veraltet: %1</translation>
    </message>
</context>
<context>
    <name>skyseal::ui::ModeChooser</name>
    <message>
        <source>Set mode</source>
        <translation>Modus setzen</translation>
    </message>
    <message>
        <source>Flight mode to set</source>
        <translation>Zu setzender Flugmodus</translation>
    </message>
    <message>
        <source>The modes of this vehicle are not known</source>
        <translation>Die Modi dieses Fahrzeugs sind nicht bekannt</translation>
    </message>
</context>
<context>
    <name>skyseal::ui::OneWay</name>
    <message>
        <source>Replay</source>
        <translation>Wiedergabe</translation>
    </message>
    <message>
        <source>The values come from a recorded log. They are not live, and nothing can be sent.</source>
        <translation>Die Werte stammen aus einem aufgezeichneten Log. Sie sind nicht live, und nichts kann gesendet werden.</translation>
    </message>
    <message>
        <source>it is a replay</source>
        <translation>es ist eine Wiedergabe</translation>
    </message>
    <message>
        <source>Not sealed, receive only</source>
        <translation>Nicht versiegelt, nur Empfang</translation>
    </message>
    <message>
        <source>This stream is protected as in the published MAVSec code, which is insecure: anyone on the path can change it. Nothing is sent.</source>
        <translation>Dieser Datenstrom ist wie im veröffentlichten Code von MAVSec geschützt, was unsicher ist: Jeder auf der Übertragungsstrecke kann ihn verändern. Nichts wird gesendet.</translation>
    </message>
    <message>
        <source>its link is receive-only</source>
        <translation>seine Verbindung erlaubt nur Empfang</translation>
    </message>
</context>
<context>
    <name>skyseal::ui::OverlayColor</name>
    <message>
        <source>Blue</source>
        <translation>Blau</translation>
    </message>
    <message>
        <source>Orange</source>
        <translation>Orange</translation>
    </message>
    <message>
        <source>Red</source>
        <translation>Rot</translation>
    </message>
    <message>
        <source>Green</source>
        <translation>Grün</translation>
    </message>
    <message>
        <source>Purple</source>
        <translation>Violett</translation>
    </message>
    <message>
        <source>Grey</source>
        <translation>Grau</translation>
    </message>
</context>
<context>
    <name>skyseal::ui::OverlayDialog</name>
    <message>
        <source>Overlays</source>
        <translation>Overlays</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Zustand</translation>
    </message>
    <message>
        <source>Colour of the selected file</source>
        <translation>Farbe der ausgewählten Datei</translation>
    </message>
    <message>
        <source>&amp;Remove</source>
        <translation>&amp;Entfernen</translation>
    </message>
    <message>
        <source>Remove the selected file from the map</source>
        <translation>Ausgewählte Datei von der Karte entfernen</translation>
    </message>
    <message>
        <source>Read a&amp;gain</source>
        <translation>Erneut &amp;lesen</translation>
    </message>
    <message>
        <source>Read the selected file again</source>
        <translation>Ausgewählte Datei erneut lesen</translation>
    </message>
    <message>
        <source>Orange</source>
        <translation>Orange</translation>
    </message>
    <message>
        <source>&amp;Add…</source>
        <translation>&amp;Hinzufügen…</translation>
    </message>
    <message>
        <source>Add KML or GeoJSON files</source>
        <translation>KML- oder GeoJSON-Dateien hinzufügen</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>&amp;Colour</source>
        <translation>&amp;Farbe</translation>
    </message>
    <message>
        <source>Add overlays</source>
        <translation>Overlays hinzufügen</translation>
    </message>
    <message>
        <source>KML and GeoJSON (*.kml *.geojson *.json);;All files (*)</source>
        <translation>KML und GeoJSON (*.kml *.geojson *.json);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>There are %1 files, and no more can be added. Remove one first.</source>
        <translation>Es sind %1 Dateien, weitere sind nicht möglich. Zuerst eine entfernen.</translation>
    </message>
    <message>
        <source>No overlays. Add… draws the points, lines and areas of KML and GeoJSON files over the map. They are for display only: the vehicle does not know about them.</source>
        <translation>Keine Overlays. Hinzufügen… zeichnet Punkte, Linien und Flächen aus KML- und GeoJSON-Dateien über die Karte. Sie dienen nur der Anzeige: Das Fahrzeug kennt sie nicht.</translation>
    </message>
</context>
<context>
    <name>skyseal::ui::OverlayModel</name>
    <message>
        <source>Reading…</source>
        <translation>Wird gelesen…</translation>
    </message>
    <message>
        <source>Not shown: %1</source>
        <translation>Nicht angezeigt: %1</translation>
    </message>
    <message>
        <source>Changed since it was added</source>
        <translation>Seit dem Hinzufügen geändert</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Farbe</translation>
    </message>
    <message>
        <source>Shapes</source>
        <translation>Formen</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Zustand</translation>
    </message>
    <message>
        <source>Shown as last read: %1</source>
        <translation>Angezeigt wie zuletzt gelesen: %1</translation>
    </message>
    <message>
        <source>%1 not drawn: no position, or an unsupported kind</source>
        <translation>%1 nicht gezeichnet: ohne Position oder von nicht unterstützter Art</translation>
    </message>
</context>
<context>
    <name>skyseal::ui::OwnKeyBox</name>
    <message>
        <source>This station</source>
        <translation>Diese Station</translation>
    </message>
    <message>
        <source>Own fingerprint</source>
        <translation>Eigener Fingerabdruck</translation>
    </message>
    <message>
        <source>Own public key</source>
        <translation>Eigener öffentlicher Schlüssel</translation>
    </message>
    <message>
        <source>The public key as a QR code</source>
        <translation>Der öffentliche Schlüssel als QR-Code</translation>
    </message>
    <message>
        <source>&amp;Copy the public key</source>
        <translation>Öffentlichen Schlüssel k&amp;opieren</translation>
    </message>
    <message>
        <source>E&amp;xport…</source>
        <translation>E&amp;xportieren…</translation>
    </message>
    <message>
        <source>Export the public key to a file</source>
        <translation>Öffentlichen Schlüssel in eine Datei exportieren</translation>
    </message>
    <message>
        <source>copied</source>
        <translation>kopiert</translation>
    </message>
    <message>
        <source>sealed</source>
        <translation>versiegelt</translation>
    </message>
    <message>
        <source>No key is in use: %1</source>
        <translation>Kein Schlüssel in Verwendung: %1</translation>
    </message>
    <message>
        <source>The other end needs this public key. It is not secret, but compare its fingerprint there with this one:</source>
        <translation>Die andere Seite braucht diesen öffentlichen Schlüssel. Er ist nicht geheim; trotzdem dort den Fingerabdruck mit diesem vergleichen:</translation>
    </message>
    <message>
        <source>%1, sealed with a passphrase</source>
        <translation>%1, mit einer Passphrase versiegelt</translation>
    </message>
    <message>
        <source>Change the pa&amp;ssphrase…</source>
        <translation>Pa&amp;ssphrase ändern…</translation>
    </message>
    <message>
        <source>Set a pa&amp;ssphrase…</source>
        <translation>Pa&amp;ssphrase setzen…</translation>
    </message>
    <message>
        <source>Export the public key</source>
        <translation>Öffentlichen Schlüssel exportieren</translation>
    </message>
    <message>
        <source>Public keys (*.pub);;All files (*)</source>
        <translation>Öffentliche Schlüssel (*.pub);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>written to %1</source>
        <translation>gespeichert in %1</translation>
    </message>
    <message>
        <source>no longer sealed</source>
        <translation>nicht mehr versiegelt</translation>
    </message>
    <message>
        <source>%1, not sealed: anyone who copies the file has the key</source>
        <translation>%1, nicht versiegelt: Wer die Datei kopiert, hat den Schlüssel</translation>
    </message>
    <message>
        <source>This station has no key: it can use only plain MAVLink. Create one with
skyseal-cli keys new --out FILE
and start with --identity FILE.</source>
        <translation>Diese Station hat keinen Schlüssel: Sie kann nur ungeschütztes MAVLink verwenden. Einen erzeugt
skyseal-cli keys new --out DATEI
und verwendet der Start mit --identity DATEI.</translation>
    </message>
</context>
<context>
    <name>skyseal::ui::PairingDialog</name>
    <message>
        <source>Pair with an agent</source>
        <translation>Mit einem Agenten koppeln</translation>
    </message>
    <message>
        <source>Passphrase of this pairing</source>
        <translation>Passphrase dieser Kopplung</translation>
    </message>
    <message>
        <source>none; or the same as at the agent</source>
        <translation>keine; oder dieselbe wie beim Agenten</translation>
    </message>
    <message>
        <source>&amp;Passphrase</source>
        <translation>&amp;Passphrase</translation>
    </message>
    <message>
        <source>They &amp;differ</source>
        <translation>Codes &amp;verschieden</translation>
    </message>
    <message>
        <source>Try a&amp;gain</source>
        <translation>&amp;Erneut versuchen</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>%1 s left</source>
        <translation>noch %1 s</translation>
    </message>
    <message>
        <source>Start pairing at the agent, while the vehicle is disarmed:

    skyseal-air --pair --identity FILE

Waiting for the agent…</source>
        <translation>Die Kopplung beim Agenten starten, solange das Fahrzeug unscharf ist:

    skyseal-air --pair --identity DATEI

Warten auf den Agenten…</translation>
    </message>
    <message>
        <source>Confirmed here. The pairing must now be confirmed at the agent as well.</source>
        <translation>Hier bestätigt. Die Kopplung muss jetzt auch beim Agenten bestätigt werden.</translation>
    </message>
    <message>
        <source>Only an agent with the same passphrase is shown: skyseal-air --pair --pair-passphrase.
Then there is no code to compare. It is valid for this pairing only.</source>
        <translation>Nur ein Agent mit derselben Passphrase wird angezeigt: skyseal-air --pair --pair-passphrase.
Dann ist kein Code zu vergleichen. Sie gilt nur für diese Kopplung.</translation>
    </message>
    <message>
        <source>&amp;Fingerprints</source>
        <translation>&amp;Fingerabdrücke</translation>
    </message>
    <message>
        <source>The complete fingerprints of both keys. They need not be compared: the code covers them.</source>
        <translation>Die vollständigen Fingerabdrücke beider Schlüssel. Ein Vergleich ist nicht nötig: Der Code deckt sie ab.</translation>
    </message>
    <message>
        <source>The agent&apos;s side has confirmed. Confirm here as well.</source>
        <translation>Die Seite des Agenten hat bestätigt. Auch hier bestätigen.</translation>
    </message>
    <message>
        <source>The agent&apos;s side has confirmed. Does the agent show this code?</source>
        <translation>Die Seite des Agenten hat bestätigt. Zeigt der Agent diesen Code?</translation>
    </message>
    <message>
        <source>&amp;Confirm</source>
        <translation>&amp;Bestätigen</translation>
    </message>
    <message>
        <source>The codes are the &amp;same</source>
        <translation>Codes &amp;gleich</translation>
    </message>
    <message>
        <source>&amp;Refuse</source>
        <translation>&amp;Ablehnen</translation>
    </message>
    <message>
        <source>An agent that knows the passphrase has answered. Is it the right one?</source>
        <translation>Ein Agent, der die Passphrase kennt, hat geantwortet. Ist es der richtige?</translation>
    </message>
    <message>
        <source>An agent has answered. Does it show this code?</source>
        <translation>Ein Agent hat geantwortet. Zeigt er diesen Code?</translation>
    </message>
    <message>
        <source>%1. The link is sealed as soon as both ends are connected.</source>
        <translation>%1. Die Verbindung wird versiegelt, sobald beide Seiten verbunden sind.</translation>
    </message>
    <message>
        <source>the codes differ. If both were codes of this pairing, an attacker is between this station and the agent (man in the middle).</source>
        <translation>die Codes sind verschieden. Waren beide Codes dieser Kopplung, sitzt ein Angreifer zwischen dieser Station und dem Agenten (Man in the Middle).</translation>
    </message>
</context>
<context>
    <name>skyseal::ui::PairingQuestionForm</name>
    <message>
        <source>Code</source>
        <translation>Code</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Fingerprint of this station</source>
        <translation>Fingerabdruck dieser Station</translation>
    </message>
    <message>
        <source>Fingerprint of the agent</source>
        <translation>Fingerabdruck des Agenten</translation>
    </message>
    <message>
        <source>&amp;Name</source>
        <translation>&amp;Name</translation>
    </message>
    <message>
        <source>Vehicle</source>
        <translation>Fahrzeug</translation>
    </message>
    <message>
        <source>This station</source>
        <translation>Diese Station</translation>
    </message>
    <message>
        <source>The agent</source>
        <translation>Agent</translation>
    </message>
    <message>
        <source>system ID %1</source>
        <translation>System-ID %1</translation>
    </message>
</context>
<context>
    <name>skyseal::ui::ParameterModel</name>
    <message>
        <source>not written: %1</source>
        <translation>nicht geschrieben: %1</translation>
    </message>
    <message>
        <source>writing %1…</source>
        <translation>%1 wird geschrieben…</translation>
    </message>
    <message>
        <source>Parameter</source>
        <translation>Parameter</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>Last change</source>
        <translation>Letzte Änderung</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a number</source>
        <translation>„%1“ ist keine Zahl</translation>
    </message>
    <message>
        <source>not written: not a finite number</source>
        <translation>nicht geschrieben: keine endliche Zahl</translation>
    </message>
    <message>
        <source>not written: %1 is not between %2 and %3</source>
        <translation>nicht geschrieben: %1 liegt nicht zwischen %2 und %3</translation>
    </message>
    <message>
        <source>not written: %1 is not a whole number</source>
        <translation>nicht geschrieben: %1 ist keine ganze Zahl</translation>
    </message>
    <message>
        <source>Value · vehicle %1</source>
        <translation>Wert · Fahrzeug %1</translation>
    </message>
    <message>
        <source>written, read back as %1</source>
        <translation>geschrieben, zurückgelesen als %1</translation>
    </message>
</context>
<context>
    <name>skyseal::ui::ParametersPanel</name>
    <message>
        <source>Fetch</source>
        <translation>Lesen</translation>
    </message>
    <message>
        <source>Fetch the parameters</source>
        <translation>Parameter lesen</translation>
    </message>
    <message>
        <source>Filter by name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Parameters fetched</source>
        <translation>Gelesene Parameter</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>Parameters</source>
        <translation>Parameter</translation>
    </message>
    <message>
        <source>not fetched</source>
        <translation>nicht gelesen</translation>
    </message>
    <message>
        <source>Result of the last fetch</source>
        <translation>Ergebnis des letzten Lesens</translation>
    </message>
    <message>
        <source>Requested, but the vehicle has been silent for %1</source>
        <translation>Angefordert, aber das Fahrzeug schweigt, Dauer %1</translation>
    </message>
    <message>
        <source>Fetched</source>
        <translation>Gelesen</translation>
    </message>
    <message>
        <source>Not fetched: %1</source>
        <translation>Nicht gelesen: %1</translation>
    </message>
    <message>
        <source>Requested…</source>
        <translation>Angefordert…</translation>
    </message>
    <message>
        <source>Filter parameters</source>
        <translation>Parameter filtern</translation>
    </message>
    <message>
        <source>Parameters are listed here once they are fetched.</source>
        <translation>Die Parameter stehen hier, sobald sie gelesen sind.</translation>
    </message>
    <message>
        <source>Find a parameter</source>
        <translation>Einen Parameter suchen</translation>
    </message>
    <message>
        <source>waits for your confirmation</source>
        <translation>wartet auf Ihre Bestätigung</translation>
    </message>
    <message>
        <source>Write a parameter</source>
        <translation>Einen Parameter schreiben</translation>
    </message>
    <message>
        <source>The vehicle is armed. Change %1?</source>
        <translation>Das Fahrzeug ist scharf. %1 ändern?</translation>
    </message>
    <message>
        <source>Vehicle %1 is armed. Change %2?</source>
        <translation>Fahrzeug %1 ist scharf. %2 ändern?</translation>
    </message>
    <message>
        <source>%1: from %2 to %3. The change takes effect at once.</source>
        <translation>%1: von %2 auf %3. Die Änderung wirkt sofort.</translation>
    </message>
    <message>
        <source>Write %1</source>
        <translation>%1 schreiben</translation>
    </message>
    <message>
        <source>not written: not confirmed</source>
        <translation>nicht geschrieben: nicht bestätigt</translation>
    </message>
    <message>
        <source>Fetched; %1</source>
        <translation>Gelesen; %1</translation>
    </message>
</context>
<context>
    <name>skyseal::ui::PassphraseDialog</name>
    <message>
        <source>Passphrase</source>
        <translation>Passphrase</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Öffnen</translation>
    </message>
    <message>
        <source>Passphrase of this station&apos;s key:</source>
        <translation>Passphrase für den Schlüssel dieser Station:</translation>
    </message>
    <message>
        <source>Wrong passphrase.</source>
        <translation>Falsche Passphrase.</translation>
    </message>
    <message>
        <source>Continue without sealed links</source>
        <translation>Ohne Versiegelung weiter</translation>
    </message>
    <message>
        <source>The remembered passphrase does not open this key.</source>
        <translation>Die gemerkte Passphrase öffnet diesen Schlüssel nicht.</translation>
    </message>
</context>
<context>
    <name>skyseal::ui::PeerDialog</name>
    <message>
        <source>Peer %1</source>
        <translation>Gegenstelle %1</translation>
    </message>
    <message>
        <source>Add a peer</source>
        <translation>Gegenstelle hinzufügen</translation>
    </message>
    <message>
        <source>Public key</source>
        <translation>Öffentlicher Schlüssel</translation>
    </message>
    <message>
        <source>From a &amp;file…</source>
        <translation>Aus &amp;Datei…</translation>
    </message>
    <message>
        <source>Fingerprint</source>
        <translation>Fingerabdruck</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>any; or e.g. 1,2</source>
        <translation>beliebig; oder z. B. 1,2</translation>
    </message>
    <message>
        <source>&amp;Public key</source>
        <translation>Öffentlicher &amp;Schlüssel</translation>
    </message>
    <message>
        <source>&amp;Name</source>
        <translation>&amp;Name</translation>
    </message>
    <message>
        <source>&amp;Systems</source>
        <translation>S&amp;ysteme</translation>
    </message>
    <message>
        <source>Public key of a peer</source>
        <translation>Öffentlicher Schlüssel einer Gegenstelle</translation>
    </message>
    <message>
        <source>Public keys (*.pub);;All files (*)</source>
        <translation>Öffentliche Schlüssel (*.pub);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Change</source>
        <translation>Ändern</translation>
    </message>
    <message>
        <source>Replace the key</source>
        <translation>Schlüssel ersetzen</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Hinzufügen</translation>
    </message>
    <message>
        <source>Paste the public key that skyseal-cli keys show prints at the other end.</source>
        <translation>Den öffentlichen Schlüssel einfügen, den skyseal-cli keys show auf der anderen Seite ausgibt.</translation>
    </message>
    <message>
        <source>Enter a name.</source>
        <translation>Einen Namen eingeben.</translation>
    </message>
    <message>
        <source>Confirm that the key is replaced, or choose another name.</source>
        <translation>Das Ersetzen des Schlüssels bestätigen oder einen anderen Namen wählen.</translation>
    </message>
    <message>
        <source>MAVLink system IDs</source>
        <translation>MAVLink-System-IDs</translation>
    </message>
</context>
<context>
    <name>skyseal::ui::PeerModel</name>
    <message>
        <source>%1
with a pre-shared key</source>
        <translation>%1
mit PSK</translation>
    </message>
    <message>
        <source>any</source>
        <translation>beliebig</translation>
    </message>
    <message>
        <source>connected</source>
        <translation>verbunden</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Systems</source>
        <translation>Systeme</translation>
    </message>
    <message>
        <source>Last seen</source>
        <translation>Zuletzt gesehen</translation>
    </message>
    <message>
        <source>Fingerprint</source>
        <translation>Fingerabdruck</translation>
    </message>
</context>
<context>
    <name>skyseal::ui::PlanReader</name>
    <message>
        <source>Reading the fence…</source>
        <translation>Geofence wird gelesen…</translation>
    </message>
    <message>
        <source>Reading the rally points…</source>
        <translation>Rally-Punkte werden gelesen…</translation>
    </message>
    <message>
        <source>Reading the mission…</source>
        <translation>Mission wird gelesen…</translation>
    </message>
    <message>
        <source>fence: %1</source>
        <translation>Geofence: %1</translation>
    </message>
    <message>
        <source>rally points: %1</source>
        <translation>Rally-Punkte: %1</translation>
    </message>
    <message>
        <source>mission items: %1</source>
        <translation>Missionspunkte: %1</translation>
    </message>
    <message>
        <source>Read: %1</source>
        <translation>Gelesen: %1</translation>
    </message>
</context>
<context>
    <name>skyseal::ui::PreArmButton</name>
    <message>
        <source>Opens the list of failures and the checklist.</source>
        <translation>Öffnet die Liste der Fehler und die Checkliste.</translation>
    </message>
    <message>
        <source>%1 open on the checklist. Opens the checklist and the list of failures.</source>
        <translation>Auf der Checkliste offen: %1. Öffnet die Checkliste und die Liste der Fehler.</translation>
    </message>
</context>
<context>
    <name>skyseal::ui::PreArmDialog</name>
    <message>
        <source>Check now</source>
        <translation>Jetzt prüfen</translation>
    </message>
    <message>
        <source>Run the pre-arm checks now</source>
        <translation>Vorprüfung jetzt ausführen</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Pre-arm checks</source>
        <translation>Prüfungen vor dem Scharfschalten</translation>
    </message>
    <message>
        <source>Pre-arm checks · vehicle %1</source>
        <translation>Prüfungen vor dem Scharfschalten · Fahrzeug %1</translation>
    </message>
    <message>
        <source>The vehicle is armed</source>
        <translation>Das Fahrzeug ist scharf</translation>
    </message>
    <message>
        <source>Pre-arm failures, with what to do</source>
        <translation>Fehler der Vorprüfung, mit Abhilfe</translation>
    </message>
    <message>
        <source>This autopilot runs its checks automatically</source>
        <translation>Dieser Autopilot prüft von selbst</translation>
    </message>
    <message>
        <source>Makes the vehicle run its checks now and report failures</source>
        <translation>Lässt das Fahrzeug jetzt prüfen und Fehler melden</translation>
    </message>
</context>
<context>
    <name>skyseal::ui::PreArmText</name>
    <message>
        <source>Press the vehicle&apos;s safety switch until its light stays on.</source>
        <translation>Den Sicherheitsschalter des Fahrzeugs drücken, bis seine LED dauerhaft leuchtet.</translation>
    </message>
    <message>
        <source>Calibrate the radio: move each stick and switch to both ends.</source>
        <translation>Fernsteuerung kalibrieren: jeden Knüppel und Schalter bis zu beiden Anschlägen bewegen.</translation>
    </message>
    <message>
        <source>Switch on the transmitter and check its receiver.</source>
        <translation>Den Sender einschalten und seinen Empfänger prüfen.</translation>
    </message>
    <message>
        <source>Calibrate the compass away from metal.</source>
        <translation>Den Kompass fern von Metall kalibrieren.</translation>
    </message>
    <message>
        <source>Move the vehicle away from metal, cables and magnets.</source>
        <translation>Das Fahrzeug von Metall, Kabeln und Magneten entfernen.</translation>
    </message>
    <message>
        <source>Place the vehicle inside its fence, or correct the fence.</source>
        <translation>Das Fahrzeug in seinen Geofence stellen oder den Geofence korrigieren.</translation>
    </message>
    <message>
        <source>Wait for more satellites, under an open sky.</source>
        <translation>Unter freiem Himmel auf mehr Satelliten warten.</translation>
    </message>
    <message>
        <source>Wait for a 3D fix under an open sky; check the GPS cable.</source>
        <translation>Unter freiem Himmel auf einen 3D-Fix warten; das GPS-Kabel prüfen.</translation>
    </message>
    <message>
        <source>Wait for the GPS and the EKF, or set a mode that needs no position.</source>
        <translation>Auf GPS und EKF warten oder einen Modus setzen, der keine Position braucht.</translation>
    </message>
    <message>
        <source>Keep the vehicle still until its estimate has settled.</source>
        <translation>Das Fahrzeug ruhig halten, bis seine Schätzung eingeschwungen ist.</translation>
    </message>
    <message>
        <source>Shield the barometer from wind and light; restart the vehicle.</source>
        <translation>Das Barometer vor Wind und Licht schützen; das Fahrzeug neu starten.</translation>
    </message>
    <message>
        <source>Check the power supply of the autopilot.</source>
        <translation>Die Stromversorgung des Autopiloten prüfen.</translation>
    </message>
    <message>
        <source>Charge or change the battery; check BATT_ARM_VOLT.</source>
        <translation>Den Akku laden oder wechseln; BATT_ARM_VOLT prüfen.</translation>
    </message>
    <message>
        <source>Send a mission that suits this vehicle.</source>
        <translation>Eine Mission senden, die zu diesem Fahrzeug passt.</translation>
    </message>
    <message>
        <source>Wait until the terrain data have been loaded.</source>
        <translation>Warten, bis die Geländedaten geladen sind.</translation>
    </message>
    <message>
        <source>Place the vehicle on level ground.</source>
        <translation>Das Fahrzeug auf ebenen Boden stellen.</translation>
    </message>
    <message>
        <source>Check the motor and frame parameters, and the ESCs.</source>
        <translation>Motor- und Rahmenparameter sowie die ESCs prüfen.</translation>
    </message>
    <message>
        <source>Check the power and the cables of the ESCs.</source>
        <translation>Stromversorgung und Kabel der ESCs prüfen.</translation>
    </message>
    <message>
        <source>Pre-arm: unknown</source>
        <translation>Vorprüfung: unklar</translation>
    </message>
    <message>
        <source>Pre-arm: ok</source>
        <translation>Vorprüfung: ok</translation>
    </message>
    <message>
        <source>Pre-arm: armed</source>
        <translation>Vorprüfung: scharf</translation>
    </message>
    <message>
        <source>Pre-arm: not ok</source>
        <translation>Vorprüfung: nicht ok</translation>
    </message>
    <message>
        <source>No vehicle is connected.</source>
        <translation>Kein Fahrzeug ist verbunden.</translation>
    </message>
    <message>
        <source>The vehicle is silent, so the state of its checks is not known.</source>
        <translation>Das Fahrzeug schweigt, daher ist der Stand seiner Prüfungen nicht bekannt.</translation>
    </message>
    <message>
        <source>The vehicle is armed.</source>
        <translation>Das Fahrzeug ist scharf.</translation>
    </message>
    <message>
        <source>Set a mode that allows arming, such as LOITER or GUIDED.</source>
        <translation>Einen Modus setzen, in dem sich scharfschalten lässt, etwa LOITER oder GUIDED.</translation>
    </message>
    <message>
        <source>Set a mode that allows arming, such as Hold or Position.</source>
        <translation>Einen Modus setzen, in dem sich scharfschalten lässt, etwa Hold oder Position.</translation>
    </message>
    <message>
        <source>Lower the throttle stick fully.</source>
        <translation>Den Gasknüppel ganz nach unten ziehen.</translation>
    </message>
    <message>
        <source>Move the vehicle away from metal, cables and magnets; calibrate the compass if the failure persists.</source>
        <translation>Das Fahrzeug von Metall, Kabeln und Magneten entfernen; bleibt der Fehler, den Kompass kalibrieren.</translation>
    </message>
    <message>
        <source>Wait for the GPS and the EKF, or disable the fence.</source>
        <translation>Auf GPS und EKF warten oder den Geofence ausschalten.</translation>
    </message>
    <message>
        <source>Keep the vehicle still; restart it if the failure persists.</source>
        <translation>Das Fahrzeug ruhig halten; bleibt der Fehler, neu starten.</translation>
    </message>
    <message>
        <source>Keep the vehicle still; calibrate the accelerometers if the failure persists.</source>
        <translation>Das Fahrzeug ruhig halten; bleibt der Fehler, die Beschleunigungssensoren kalibrieren.</translation>
    </message>
    <message>
        <source>Check that the SD card is inserted and has free space.</source>
        <translation>Prüfen, ob die SD-Karte eingesteckt ist und freien Platz hat.</translation>
    </message>
    <message>
        <source>Restart the autopilot, and do not fly until the cause is known.</source>
        <translation>Den Autopiloten neu starten und nicht fliegen, bis die Ursache bekannt ist.</translation>
    </message>
    <message>
        <source>Wait until the vehicle has detected the landing.</source>
        <translation>Warten, bis das Fahrzeug die Landung erkannt hat.</translation>
    </message>
    <message>
        <source>Correct the parameter named in the message.</source>
        <translation>Den Parameter korrigieren, den die Nachricht nennt.</translation>
    </message>
    <message>
        <source>Pre-arm: 1 failure</source>
        <translation>Vorprüfung: 1 Fehler</translation>
    </message>
    <message>
        <source>Pre-arm: %1 failures</source>
        <translation>Vorprüfung: %1 Fehler</translation>
    </message>
    <message>
        <source>The vehicle does not report whether its checks pass, and has not reported a failure.</source>
        <translation>Das Fahrzeug meldet nicht, ob seine Prüfungen bestanden sind, und hat keinen Fehler gemeldet.</translation>
    </message>
    <message>
        <source>The vehicle reports that all checks pass.</source>
        <translation>Das Fahrzeug meldet, dass alle Prüfungen bestanden sind.</translation>
    </message>
    <message>
        <source>The vehicle reports that a check fails, but not which one. It repeats its failures every 30 s.</source>
        <translation>Das Fahrzeug meldet eine nicht bestandene Prüfung, aber nicht, welche. Es wiederholt seine Fehlermeldungen alle 30 s.</translation>
    </message>
    <message>
        <source>The vehicle will not arm. A failure is removed when it has not been repeated for 40 s.</source>
        <translation>Das Fahrzeug lässt sich nicht scharfschalten. Ein Fehler verschwindet, wenn er 40 s lang nicht wiederholt wurde.</translation>
    </message>
    <message>
        <source>Look up the message in the autopilot&apos;s documentation.</source>
        <translation>Die Nachricht in der Dokumentation des Autopiloten nachschlagen.</translation>
    </message>
</context>
<context>
    <name>skyseal::ui::Preflight</name>
    <message>
        <source>the checklist, which cannot be read</source>
        <translation>die Checkliste, die sich nicht lesen lässt</translation>
    </message>
    <message>
        <source>%1 cannot be read: %2</source>
        <translation>%1 kann nicht gelesen werden: %2</translation>
    </message>
</context>
<context>
    <name>skyseal::ui::ProblemBanner</name>
    <message>
        <source>Resolve the problem</source>
        <translation>Problem beheben</translation>
    </message>
    <message>
        <source>Dismiss</source>
        <translation>Ausblenden</translation>
    </message>
    <message>
        <source>Dismiss the problem</source>
        <translation>Problem ausblenden</translation>
    </message>
</context>
<context>
    <name>skyseal::ui::ProblemReports</name>
    <message>
        <source>%1 is in use by another program: %2</source>
        <translation>%1 wird von einem anderen Programm benutzt: %2</translation>
    </message>
    <message>
        <source>Listen on %1 instead</source>
        <translation>Stattdessen auf %1 lauschen</translation>
    </message>
</context>
<context>
    <name>skyseal::ui::ProfilePanel</name>
    <message>
        <source>No vehicle. The altitudes of its mission are drawn here once it has been read.</source>
        <translation>Kein Fahrzeug. Die Höhen seiner Mission werden hier gezeichnet, sobald sie gelesen ist.</translation>
    </message>
    <message>
        <source>The vehicle has no mission. Send a file in the panel Mission to write one.</source>
        <translation>Das Fahrzeug hat keine Mission. Senden Sie im Bereich „Mission“ eine Datei, um eine zu schreiben.</translation>
    </message>
    <message>
        <source>The mission has not been read yet: choose Read from the vehicle in the panel Mission.</source>
        <translation>Die Mission wurde noch nicht gelesen: Wählen Sie im Bereich „Mission“ „Vom Fahrzeug lesen“.</translation>
    </message>
</context>
<context>
    <name>skyseal::ui::ProfileView</name>
    <message>
        <source>Altitude profile of the mission</source>
        <translation>Höhenprofil der Mission</translation>
    </message>
    <message>
        <source>%1 · highest %2 above home</source>
        <translation>%1 · höchster Punkt %2 über Home</translation>
    </message>
</context>
<context>
    <name>skyseal::ui::QtTimeSeriesChart</name>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
    </message>
</context>
<context>
    <name>skyseal::ui::Quantities</name>
    <message>
        <source>Decryption rate</source>
        <translation>Entschlüsselungsrate</translation>
    </message>
    <message>
        <source>frames/s</source>
        <translation>Frames/s</translation>
    </message>
    <message>
        <source>Bytes</source>
        <translation>Bytes</translation>
    </message>
    <message>
        <source>kB/s</source>
        <translation>kB/s</translation>
    </message>
    <message>
        <source>received</source>
        <translation>empfangen</translation>
    </message>
    <message>
        <source>Wire overhead</source>
        <translation>Overhead der Übertragung</translation>
    </message>
    <message>
        <source>%</source>
        <translation>%</translation>
    </message>
    <message>
        <source>Packet loss, channel</source>
        <translation>Paketverlust, Kanal</translation>
    </message>
    <message>
        <source>Packet loss, MAVLink</source>
        <translation>Paketverlust, MAVLink</translation>
    </message>
    <message>
        <source>Latency</source>
        <translation>Latenz</translation>
    </message>
    <message>
        <source>ms</source>
        <translation>ms</translation>
    </message>
    <message>
        <source>TIMESYNC</source>
        <translation>TIMESYNC</translation>
    </message>
    <message>
        <source>channel</source>
        <translation>Kanal</translation>
    </message>
    <message>
        <source>% of a core</source>
        <translation>% eines Kerns</translation>
    </message>
    <message>
        <source>process</source>
        <translation>Prozess</translation>
    </message>
    <message>
        <source>link</source>
        <translation>Verbindung</translation>
    </message>
    <message>
        <source>suite</source>
        <translation>Chiffre</translation>
    </message>
    <message>
        <source>µs</source>
        <translation>µs</translation>
    </message>
    <message>
        <source>p50</source>
        <translation>p50</translation>
    </message>
    <message>
        <source>p99</source>
        <translation>p99</translation>
    </message>
    <message>
        <source>next p50</source>
        <translation>nächste p50</translation>
    </message>
    <message>
        <source>Memory</source>
        <translation>Speicher</translation>
    </message>
    <message>
        <source>MB resident</source>
        <translation>MB resident</translation>
    </message>
    <message>
        <source>Memory of a session</source>
        <translation>Speicher einer Sitzung</translation>
    </message>
    <message>
        <source>kB</source>
        <translation>kB</translation>
    </message>
    <message>
        <source>W</source>
        <translation>W</translation>
    </message>
    <message>
        <source>not readable here</source>
        <translation>hier nicht lesbar</translation>
    </message>
    <message>
        <source>All</source>
        <translation>Alle</translation>
    </message>
    <message>
        <source>Overview</source>
        <translation>Übersicht</translation>
    </message>
    <message>
        <source>Rates</source>
        <translation>Raten</translation>
    </message>
    <message>
        <source>Link</source>
        <translation>Verbindung</translation>
    </message>
    <message>
        <source>Cost</source>
        <translation>Aufwand</translation>
    </message>
    <message>
        <source>CPU</source>
        <translation>CPU</translation>
    </message>
    <message>
        <source>Opening a record</source>
        <translation>Öffnen eines Records</translation>
    </message>
    <message>
        <source>Sealing a record</source>
        <translation>Versiegeln eines Records</translation>
    </message>
    <message>
        <source>MAVLink frames that were decrypted and accepted, over the last second.</source>
        <translation>MAVLink-Frames, die in der letzten Sekunde entschlüsselt und angenommen wurden.</translation>
    </message>
    <message>
        <source>Bytes of the frames that were decrypted, and of the received datagrams (without UDP and IP headers).</source>
        <translation>Bytes der entschlüsselten Frames und der empfangenen Datagramme (ohne UDP- und IP-Header).</translation>
    </message>
    <message>
        <source>decrypted</source>
        <translation>entschlüsselt</translation>
    </message>
    <message>
        <source>Bytes of the channel&apos;s datagrams beyond the frames in them: headers, tags, handshakes and reports. At a few frames a second it is large, because the reports stay the same. 0 on a plain link.</source>
        <translation>Bytes in den Datagrammen des Kanals, die über die Frames darin hinausgehen: Header, Tags, Handshakes und Berichte. Bei wenigen Frames pro Sekunde ist der Wert groß, weil die Berichte gleich bleiben. 0 auf einer ungeschützten Verbindung.</translation>
    </message>
    <message>
        <source>from vehicle</source>
        <translation>vom Fahrzeug</translation>
    </message>
    <message>
        <source>to vehicle</source>
        <translation>zum Fahrzeug</translation>
    </message>
    <message>
        <source>Records that were lost, by their counters, over the last second; the agent reports its direction once a second. On a plain link: the loss of MAVLink frames.</source>
        <translation>Records, die in der letzten Sekunde verloren gingen, nach ihren Zählern; der Agent berichtet seine Richtung einmal pro Sekunde. Auf einer ungeschützten Verbindung: der Verlust an MAVLink-Frames.</translation>
    </message>
    <message>
        <source>Frames that were lost, by the sequence numbers of each sender, over the last second; frames to the vehicle are counted by its agent and reported once a second. Loss between autopilot and agent counts here and not in the channel.</source>
        <translation>Frames, die in der letzten Sekunde verloren gingen, nach den Sequenznummern jedes Absenders; Frames zum Fahrzeug zählt dessen Agent, der sie einmal pro Sekunde berichtet. Verluste zwischen Autopilot und Agent zählen hier und nicht im Kanal.</translation>
    </message>
    <message>
        <source>Round trip: to the autopilot by TIMESYNC, smoothed, and to the agent by the channel&apos;s reports.</source>
        <translation>Umlaufzeit: zum Autopiloten per TIMESYNC, geglättet, und zum Agenten aus den Berichten des Kanals.</translation>
    </message>
    <message>
        <source>Resident memory of the whole process. It does not depend on the suite.</source>
        <translation>Residenter Speicher des ganzen Prozesses. Er hängt nicht von der Chiffre ab.</translation>
    </message>
    <message>
        <source>Heap of one end&apos;s session under the suite in use, with its keyed ciphers. Measured once for each suite, with a session inside this program.</source>
        <translation>Heap der Sitzung einer Seite mit der verwendeten Chiffre, einschließlich der Chiffren mit ihren Schlüsseln. Für jede Chiffre einmal gemessen, mit einer Sitzung in diesem Programm.</translation>
    </message>
    <message>
        <source>Power of the machine</source>
        <translation>Leistung des Rechners</translation>
    </message>
    <message>
        <source>From the datagram to the decrypted frames: look-up, replay window, tag, decryption. The first record after the thread slept finds cold caches and takes several microseconds with any suite; at telemetry rates that is nearly every record. “next” is for the records that follow in the same wake-up, which show more of the cipher itself.</source>
        <translation>Vom Datagramm bis zu den entschlüsselten Frames: Suche, Wiedereinspielungsfenster, Tag, Entschlüsselung. Der erste Record, nachdem der Thread geschlafen hat, trifft auf kalte Caches und braucht mit jeder Chiffre mehrere Mikrosekunden; bei den Raten der Telemetrie ist das fast jeder Record. „nächste“ sind die Records, die im selben Aufwachen folgen; sie zeigen mehr von der Chiffre selbst.</translation>
    </message>
    <message>
        <source>From the frames to the record that is sent, with the cold caches of a thread that was asleep.</source>
        <translation>Von den Frames bis zum Record, der gesendet wird, mit den kalten Caches eines Threads, der geschlafen hat.</translation>
    </message>
    <message>
        <source>From the kernel&apos;s energy counters or the power supply&apos;s sensor, over the last second: the whole machine, not this program alone (%1).</source>
        <translation>Aus den Energiezählern des Kernels oder dem Sensor der Stromversorgung, in der letzten Sekunde: der ganze Rechner, nicht nur dieses Programm (%1).</translation>
    </message>
    <message>
        <source>CPU time over the last second: of the process with its window, of the link thread, and of the suite in seal and open (sum of the elapsed times of the calls). The cost of watching (the snapshots for this window, and these measurements) is part of “link” and stated below the charts; drawing the charts is part of “process” only.</source>
        <translation>CPU-Zeit in der letzten Sekunde: des Prozesses mit seinem Fenster, des Verbindungs-Threads und der Chiffre beim Versiegeln und Öffnen (Summe der Dauer aller Aufrufe). Was das Beobachten kostet (die Momentaufnahmen für dieses Fenster und diese Messungen), ist in „Verbindung“ enthalten und steht unter den Diagrammen; das Zeichnen der Diagramme ist nur in „Prozess“ enthalten.</translation>
    </message>
</context>
<context>
    <name>skyseal::ui::RecordedLink</name>
    <message>
        <source>Replay · protection not recorded</source>
        <translation>Wiedergabe · Schutz nicht aufgezeichnet</translation>
    </message>
    <message>
        <source>Replay</source>
        <translation>Wiedergabe</translation>
    </message>
    <message>
        <source>Replay · was not sealed</source>
        <translation>Wiedergabe · war nicht versiegelt</translation>
    </message>
    <message>
        <source>Was not sealed</source>
        <translation>War nicht versiegelt</translation>
    </message>
    <message>
        <source>Was sealed</source>
        <translation>War versiegelt</translation>
    </message>
    <message>
        <source>How the link was protected is not noted beside the recording.</source>
        <translation>Wie die Verbindung geschützt war, ist nicht neben der Aufzeichnung vermerkt.</translation>
    </message>
    <message>
        <source>The link was plain MAVLink, not sealed.</source>
        <translation>Die Verbindung war ungeschütztes MAVLink, nicht versiegelt.</translation>
    </message>
    <message>
        <source>The link was sealed, with one of %1.</source>
        <translation>Die Verbindung war versiegelt, mit %1.</translation>
    </message>
    <message>
        <source>The link was sealed by %1, with %2.</source>
        <translation>Die Verbindung war durch %1 versiegelt, mit %2.</translation>
    </message>
</context>
<context>
    <name>skyseal::ui::RecordingModel</name>
    <message>
        <source>reading…</source>
        <translation>wird gelesen…</translation>
    </message>
    <message>
        <source>cannot be read: %1</source>
        <translation>nicht lesbar: %1</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>no vehicle</source>
        <translation>kein Fahrzeug</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>Datum</translation>
    </message>
    <message>
        <source>Vehicle</source>
        <translation>Fahrzeug</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Dauer</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>and others</source>
        <translation>und andere</translation>
    </message>
    <message>
        <source>No cipher suite is noted beside this recording</source>
        <translation>Neben dieser Aufzeichnung ist keine Chiffre vermerkt</translation>
    </message>
    <message>
        <source>Ciphers</source>
        <translation>Chiffren</translation>
    </message>
    <message>
        <source>plain MAVLink</source>
        <translation>ungeschütztes MAVLink</translation>
    </message>
</context>
<context>
    <name>skyseal::ui::RecordingsDialog</name>
    <message>
        <source>Recordings</source>
        <translation>Aufzeichnungen</translation>
    </message>
    <message>
        <source>&amp;Replay</source>
        <translation>&amp;Wiedergeben</translation>
    </message>
    <message>
        <source>Replay the selected recording</source>
        <translation>Ausgewählte Aufzeichnung wiedergeben</translation>
    </message>
    <message>
        <source>Replay a log</source>
        <translation>Log wiedergeben</translation>
    </message>
    <message>
        <source>&amp;Other file…</source>
        <translation>&amp;Andere Datei…</translation>
    </message>
    <message>
        <source>Replay another file</source>
        <translation>Andere Datei wiedergeben</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>%1 of %2 read in %3</source>
        <translation>%1 von %2 in %3 gelesen</translation>
    </message>
    <message>
        <source>%1 recordings in %2</source>
        <translation>%1 Aufzeichnungen in %2</translation>
    </message>
    <message>
        <source>Telemetry logs (*.tlog);;All files (*)</source>
        <translation>Telemetrie-Logs (*.tlog);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Searching %1…</source>
        <translation>%1 wird durchsucht…</translation>
    </message>
    <message>
        <source>No recordings in %1. Enable recording in File → Settings, or choose &quot;Other file&quot; to replay another log.</source>
        <translation>Keine Aufzeichnungen in %1. Das Aufzeichnen in Datei → Einstellungen einschalten oder mit „Andere Datei“ ein anderes Log wiedergeben.</translation>
    </message>
    <message>
        <source>One recording in %1</source>
        <translation>Eine Aufzeichnung in %1</translation>
    </message>
</context>
<context>
    <name>skyseal::ui::RegionDialog</name>
    <message>
        <source>Choose a tile server as the map source first</source>
        <translation>Zuerst einen Kachelserver als Kartenquelle wählen</translation>
    </message>
    <message>
        <source>Fetch the area in view</source>
        <translation>Sichtbaren Ausschnitt laden</translation>
    </message>
    <message>
        <source>area.mbtiles</source>
        <translation>ausschnitt.mbtiles</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>&amp;Browse…</source>
        <translation>&amp;Durchsuchen…</translation>
    </message>
    <message>
        <source>Browse for the file</source>
        <translation>Datei auswählen</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Fortschritt</translation>
    </message>
    <message>
        <source>&amp;Fetch</source>
        <translation>&amp;Laden</translation>
    </message>
    <message>
        <source>Fetch</source>
        <translation>Laden</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>to</source>
        <translation>bis</translation>
    </message>
    <message>
        <source>F&amp;ile</source>
        <translation>Da&amp;tei</translation>
    </message>
    <message>
        <source>No file is chosen</source>
        <translation>Keine Datei ausgewählt</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>%L1 tiles</source>
        <translation>%L1 Kacheln</translation>
    </message>
    <message>
        <source>Fetch the area into</source>
        <translation>Ausschnitt laden in</translation>
    </message>
    <message>
        <source>MBTiles (*.mbtiles)</source>
        <translation>MBTiles (*.mbtiles)</translation>
    </message>
    <message>
        <source>%L1 of %L2 tiles, %3</source>
        <translation>%L1 von %L2 Kacheln, %3</translation>
    </message>
    <message>
        <source> of about %1</source>
        <translation> von etwa %1</translation>
    </message>
    <message>
        <source>; %L1 failed</source>
        <translation>; %L1 fehlgeschlagen</translation>
    </message>
    <message>
        <source>Not fetched: %1</source>
        <translation>Nicht geladen: %1</translation>
    </message>
    <message>
        <source>Cancelled; no file was written</source>
        <translation>Abgebrochen; keine Datei geschrieben</translation>
    </message>
    <message>
        <source>%1: %2, without %L3 tiles that failed</source>
        <translation>%1: %2, ohne %L3 fehlgeschlagene Kacheln</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>From zoom level</source>
        <translation>Von Zoomstufe</translation>
    </message>
    <message>
        <source>To zoom level</source>
        <translation>Bis Zoomstufe</translation>
    </message>
    <message>
        <source>&amp;Use as map source</source>
        <translation>Als &amp;Kartenquelle verwenden</translation>
    </message>
    <message>
        <source>Use the file as the map source</source>
        <translation>Die Datei als Kartenquelle verwenden</translation>
    </message>
    <message>
        <source>Zoom &amp;levels</source>
        <translation>&amp;Zoomstufen</translation>
    </message>
    <message>
        <source>Tiles are fetched two at a time. Check that the server permits it.</source>
        <translation>Je zwei Kacheln werden gleichzeitig geladen. Vorher klären, ob der Server das erlaubt.</translation>
    </message>
    <message>
        <source>The first zoom level is greater than the last</source>
        <translation>Die erste Zoomstufe ist höher als die letzte</translation>
    </message>
    <message>
        <source>%L1 tiles: at most %L2 can be fetched at a time. Zoom in, or choose fewer zoom levels</source>
        <translation>%L1 Kacheln: Höchstens %L2 lassen sich auf einmal laden. Die Karte vergrößern oder weniger Zoomstufen wählen</translation>
    </message>
</context>
<context>
    <name>skyseal::ui::RegionFetch</name>
    <message>
        <source>the server has no tiles there</source>
        <translation>der Server hat dort keine Kacheln</translation>
    </message>
</context>
<context>
    <name>skyseal::ui::ReplayBar</name>
    <message>
        <source>Speed of the replay</source>
        <translation>Tempo der Wiedergabe</translation>
    </message>
    <message>
        <source>Position and length of the replay</source>
        <translation>Stelle und Länge der Wiedergabe</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>Abspielen</translation>
    </message>
    <message>
        <source>Pause the replay</source>
        <translation>Wiedergabe anhalten</translation>
    </message>
    <message>
        <source>Play the replay</source>
        <translation>Wiedergabe abspielen</translation>
    </message>
    <message>
        <source>%1 (Space, while the focus is in this bar)</source>
        <translation>%1 (Leertaste, solange der Fokus in dieser Leiste ist)</translation>
    </message>
    <message>
        <source>Recorded %1</source>
        <translation>Aufgezeichnet: %1</translation>
    </message>
    <message>
        <source>Beside the recording: %1</source>
        <translation>Neben der Aufzeichnung: %1</translation>
    </message>
    <message>
        <source>Back 10 s</source>
        <translation>10 s zurück</translation>
    </message>
    <message>
        <source>Forward 10 s</source>
        <translation>10 s vor</translation>
    </message>
    <message>
        <source>Slower</source>
        <translation>Langsamer</translation>
    </message>
    <message>
        <source>Faster</source>
        <translation>Schneller</translation>
    </message>
    <message>
        <source>Previous event</source>
        <translation>Vorige Marke</translation>
    </message>
    <message>
        <source>Next event</source>
        <translation>Nächste Marke</translation>
    </message>
</context>
<context>
    <name>skyseal::ui::ReplayTimeline</name>
    <message>
        <source>Position of the replay</source>
        <translation>Stelle der Wiedergabe</translation>
    </message>
    <message>
        <source>The recording is being read</source>
        <translation>Die Aufzeichnung wird gelesen</translation>
    </message>
    <message>
        <source>%1 nothing recorded for %2</source>
        <translation>%1 nichts aufgezeichnet, %2 lang</translation>
    </message>
    <message>
        <source> (vehicle %1)</source>
        <translation> (Fahrzeug %1)</translation>
    </message>
    <message>
        <source>%1 armed until %2</source>
        <translation>%1 scharf bis %2</translation>
    </message>
    <message>
        <source>%1 mode %2</source>
        <translation>%1 Modus %2</translation>
    </message>
    <message>
        <source>and %1 more</source>
        <translation>und %1 weitere</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>%1 switched to %2</source>
        <translation>%1 wechselte zu %2</translation>
    </message>
    <message>
        <source>%1 sealed with %2</source>
        <translation>%1 versiegelt mit %2</translation>
    </message>
    <message>
        <source> (link to %1)</source>
        <translation> (Verbindung zu %1)</translation>
    </message>
    <message>
        <source>%1 vehicle %2 in plain MAVLink</source>
        <translation>%1 Fahrzeug %2 in ungeschütztem MAVLink</translation>
    </message>
</context>
<context>
    <name>skyseal::ui::RescueBar</name>
    <message>
        <source>Replay the recording of the last run</source>
        <translation>Die Aufzeichnung des letzten Laufs wiedergeben</translation>
    </message>
    <message>
        <source>Open the links of the last run again</source>
        <translation>Die Verbindungen des letzten Laufs wieder öffnen</translation>
    </message>
    <message>
        <source>Dismiss</source>
        <translation>Ausblenden</translation>
    </message>
    <message>
        <source>The last run ended unexpectedly at about %1. Its recording was kept.</source>
        <translation>Der letzte Lauf endete unerwartet (etwa %1). Seine Aufzeichnung ist erhalten.</translation>
    </message>
    <message>
        <source>Re&amp;play its recording</source>
        <translation>Aufzeichnung &amp;wiedergeben</translation>
    </message>
    <message>
        <source>&amp;Open its links</source>
        <translation>Ve&amp;rbindungen öffnen</translation>
    </message>
    <message>
        <source>Dis&amp;miss</source>
        <translation>A&amp;usblenden</translation>
    </message>
</context>
<context>
    <name>skyseal::ui::RightsMenu</name>
    <message>
        <source>&amp;Everything</source>
        <translation>&amp;Alles</translation>
    </message>
    <message>
        <source>Also messages of no class, and of other dialects</source>
        <translation>Auch Nachrichten ohne Klasse und aus anderen Dialekten</translation>
    </message>
    <message>
        <source>&amp;Missions, fences and rally points</source>
        <translation>&amp;Missionen, Geofences und Rally-Punkte</translation>
    </message>
    <message>
        <source>Not the choice of the item to fly next</source>
        <translation>Nicht die Wahl des nächsten Missionspunkts</translation>
    </message>
    <message>
        <source>&amp;Parameters</source>
        <translation>&amp;Parameter</translation>
    </message>
    <message>
        <source>&amp;Commands and flight modes</source>
        <translation>&amp;Befehle und Flugmodi</translation>
    </message>
    <message>
        <source>They command vehicles like this station</source>
        <translation>Sie geben Fahrzeugen Befehle wie diese Station</translation>
    </message>
    <message>
        <source>&amp;Files and logs</source>
        <translation>&amp;Dateien und Logs</translation>
    </message>
    <message>
        <source>&amp;Sticks and manual control</source>
        <translation>&amp;Steuerknüppel und manuelle Steuerung</translation>
    </message>
</context>
<context>
    <name>skyseal::ui::SecureLinkPanel</name>
    <message>
        <source>Session to show</source>
        <translation>Anzuzeigende Sitzung</translation>
    </message>
    <message>
        <source>Peer</source>
        <translation>Gegenstelle</translation>
    </message>
    <message>
        <source>Sealed since</source>
        <translation>Versiegelt seit</translation>
    </message>
    <message>
        <source>How to seal this link</source>
        <translation>Wie diese Verbindung versiegelt wird</translation>
    </message>
    <message>
        <source>Result of the last switch</source>
        <translation>Ergebnis des letzten Wechsels</translation>
    </message>
    <message>
        <source>Fingerprint of the peer&apos;s key</source>
        <translation>Fingerabdruck des Schlüssels der Gegenstelle</translation>
    </message>
    <message>
        <source>No sealed link</source>
        <translation>Keine versiegelte Verbindung</translation>
    </message>
    <message>
        <source>Not sealed</source>
        <translation>Nicht versiegelt</translation>
    </message>
    <message>
        <source>Sealed</source>
        <translation>Versiegelt</translation>
    </message>
    <message>
        <source>Sealed, switching…</source>
        <translation>Versiegelt, wechselt…</translation>
    </message>
    <message>
        <source>unnamed peer</source>
        <translation>Gegenstelle ohne Namen</translation>
    </message>
    <message>
        <source>%1 ✓ · %2</source>
        <translation>%1 ✓ · %2</translation>
    </message>
    <message>
        <source>epoch %1 · for %2</source>
        <translation>Epoche %1 · Dauer %2</translation>
    </message>
    <message>
        <source>Fingerprint of %1
%2</source>
        <translation>Fingerabdruck von %1
%2</translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
    </message>
    <message>
        <source>Keys and peers…</source>
        <translation>Schlüssel und Gegenstellen…</translation>
    </message>
    <message>
        <source>Open keys and peers</source>
        <translation>Schlüssel und Gegenstellen öffnen</translation>
    </message>
    <message>
        <source>%1 does not answer</source>
        <translation>%1 antwortet nicht</translation>
    </message>
    <message>
        <source>Under attack, all refused</source>
        <translation>Unter Angriff, alles abgelehnt</translation>
    </message>
    <message>
        <source>Sealed, changing keys…</source>
        <translation>Versiegelt, wechselt Schlüssel…</translation>
    </message>
    <message>
        <source>Not sealed, needs approval</source>
        <translation>Nicht versiegelt, braucht Freigabe</translation>
    </message>
    <message>
        <source>Sealed, no data received</source>
        <translation>Versiegelt, keine Daten empfangen</translation>
    </message>
    <message>
        <source>Sealed, commands are ignored</source>
        <translation>Versiegelt, Befehle werden ignoriert</translation>
    </message>
    <message>
        <source>Sealed, commands are late</source>
        <translation>Versiegelt, Befehle sind verspätet</translation>
    </message>
    <message>
        <source>%1. %2.</source>
        <translation>%1. %2.</translation>
    </message>
    <message>
        <source>No sealed links</source>
        <translation>Keine versiegelten Verbindungen</translation>
    </message>
    <message>
        <source>This station cannot use its key: %1</source>
        <translation>Diese Station kann ihren Schlüssel nicht verwenden: %1</translation>
    </message>
    <message>
        <source>The session starts automatically when a known agent announces itself.</source>
        <translation>Die Sitzung beginnt von selbst, wenn sich ein bekannter Agent meldet.</translation>
    </message>
    <message>
        <source>Not sealed, sweep running</source>
        <translation>Nicht versiegelt, Messreihe läuft</translation>
    </message>
    <message>
        <source>It continues automatically when the agent is heard again.</source>
        <translation>Es geht von selbst weiter, sobald der Agent wieder empfangen wird.</translation>
    </message>
    <message>
        <source>Sealed, disk error at the agent</source>
        <translation>Versiegelt, Datenträgerfehler beim Agenten</translation>
    </message>
    <message>
        <source>Sealed, disk error on this computer</source>
        <translation>Versiegelt, Datenträgerfehler auf diesem Rechner</translation>
    </message>
    <message>
        <source>Opening the key…</source>
        <translation>Schlüssel wird geöffnet…</translation>
    </message>
    <message>
        <source>The passphrase of this station&apos;s key is being checked. Sealed links can start after that.</source>
        <translation>Die Passphrase für den Schlüssel dieser Station wird geprüft. Danach können versiegelte Verbindungen beginnen.</translation>
    </message>
    <message>
        <source>%1 forged, %2 replayed in this session</source>
        <translation>%1 gefälscht, %2 wiedereingespielt in dieser Sitzung</translation>
    </message>
    <message>
        <source>%1 spoofed frames in this session</source>
        <translation>%1 vorgetäuschte Frames in dieser Sitzung</translation>
    </message>
    <message>
        <source>%1. If it is yours, pair the two.</source>
        <translation>%1. Wenn es der eigene ist, die beiden koppeln.</translation>
    </message>
    <message>
        <source>Anyone on the path can read and change the traffic. This station cannot seal the link, because it cannot use its key: %1</source>
        <translation>Jeder auf der Übertragungsstrecke kann den Verkehr mitlesen und verändern. Diese Station kann die Verbindung nicht versiegeln, weil sie ihren Schlüssel nicht verwenden kann: %1</translation>
    </message>
    <message>
        <source>%1.</source>
        <translation>%1.</translation>
    </message>
</context>
<context>
    <name>skyseal::ui::SettingsDialog</name>
    <message>
        <source>Settings</source>
        <translation>Einstellungen</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Ansicht</translation>
    </message>
    <message>
        <source>Colours</source>
        <translation>Farben</translation>
    </message>
    <message>
        <source>light</source>
        <translation>hell</translation>
    </message>
    <message>
        <source>dark</source>
        <translation>dunkel</translation>
    </message>
    <message>
        <source>high contrast</source>
        <translation>hoher Kontrast</translation>
    </message>
    <message>
        <source>Units</source>
        <translation>Einheiten</translation>
    </message>
    <message>
        <source>metric (m, m/s)</source>
        <translation>metrisch (m, m/s)</translation>
    </message>
    <message>
        <source>imperial (ft, mph)</source>
        <translation>imperial (ft, mph)</translation>
    </message>
    <message>
        <source>&amp;Colours</source>
        <translation>&amp;Farben</translation>
    </message>
    <message>
        <source>&amp;Units</source>
        <translation>&amp;Einheiten</translation>
    </message>
    <message>
        <source>Station</source>
        <translation>Station</translation>
    </message>
    <message>
        <source>Link to open at start</source>
        <translation>Verbindung, die beim Start geöffnet wird</translation>
    </message>
    <message>
        <source>&amp;Record received and sent frames (.tlog)</source>
        <translation>Alle Frames auf&amp;zeichnen (.tlog)</translation>
    </message>
    <message>
        <source>Record</source>
        <translation>Aufzeichnen</translation>
    </message>
    <message>
        <source>Folder of the recordings</source>
        <translation>Ordner der Aufzeichnungen</translation>
    </message>
    <message>
        <source>Browse…</source>
        <translation>Durchsuchen…</translation>
    </message>
    <message>
        <source>Browse for the folder of the recordings</source>
        <translation>Ordner der Aufzeichnungen auswählen</translation>
    </message>
    <message>
        <source>MAVLink &amp;system</source>
        <translation>MAVLink-&amp;System</translation>
    </message>
    <message>
        <source>MAVLink c&amp;omponent</source>
        <translation>MAVLink-K&amp;omponente</translation>
    </message>
    <message>
        <source>&amp;Link at start</source>
        <translation>Verbindung &amp;beim Start</translation>
    </message>
    <message>
        <source>&amp;Folder</source>
        <translation>Or&amp;dner</translation>
    </message>
    <message>
        <source>Security</source>
        <translation>Sicherheit</translation>
    </message>
    <message>
        <source>Show sealed vehicles &amp;only</source>
        <translation>&amp;Nur versiegelte Fahrzeuge anzeigen</translation>
    </message>
    <message>
        <source>Show sealed vehicles only</source>
        <translation>Nur versiegelte Fahrzeuge anzeigen</translation>
    </message>
    <message>
        <source>Allow &amp;insecure research suites (%1)</source>
        <translation>&amp;Unsichere Forschungs-Chiffren zulassen (%1)</translation>
    </message>
    <message>
        <source>Allow insecure research suites</source>
        <translation>Unsichere Forschungs-Chiffren zulassen</translation>
    </message>
    <message>
        <source>Weakest suite</source>
        <translation>Schwächste Chiffre</translation>
    </message>
    <message>
        <source>Any sealed suite</source>
        <translation>Jede versiegelnde Chiffre</translation>
    </message>
    <message>
        <source>%1 or stronger</source>
        <translation>%1 oder stärker</translation>
    </message>
    <message>
        <source>Only %1</source>
        <translation>Nur %1</translation>
    </message>
    <message>
        <source>&amp;Weakest suite</source>
        <translation>Schwächste &amp;Chiffre</translation>
    </message>
    <message>
        <source>desktop default</source>
        <translation>wie der Desktop</translation>
    </message>
    <message>
        <source>Plain MAVLink is then neither shown nor answered. Takes effect at the next start.</source>
        <translation>Ungeschütztes MAVLink wird dann weder angezeigt noch beantwortet. Gilt ab dem nächsten Start.</translation>
    </message>
    <message>
        <source>Research suites (%1) are broken: anyone who records the link may be able to read it. They are provided for comparison, are never chosen automatically, and work only when the vehicle&apos;s agent allows them as well. While one is in use, the link is not confidential.</source>
        <translation>Forschungs-Chiffren (%1) sind gebrochen: Wer die Verbindung aufzeichnet, kann sie möglicherweise mitlesen. Sie dienen dem Vergleich, werden nie von selbst gewählt und funktionieren nur, wenn auch der Agent des Fahrzeugs sie zulässt. Solange eine in Gebrauch ist, ist die Verbindung nicht vertraulich.</translation>
    </message>
    <message>
        <source>Coordinates</source>
        <translation>Koordinaten</translation>
    </message>
    <message>
        <source>decimal degrees</source>
        <translation>Dezimalgrad</translation>
    </message>
    <message>
        <source>degrees, minutes, seconds</source>
        <translation>Grad, Minuten, Sekunden</translation>
    </message>
    <message>
        <source>UTM (metres in a zone)</source>
        <translation>UTM (Meter in einer Zone)</translation>
    </message>
    <message>
        <source>MGRS (grid reference)</source>
        <translation>MGRS (Meldegitter)</translation>
    </message>
    <message>
        <source>Coordi&amp;nates</source>
        <translation>&amp;Koordinaten</translation>
    </message>
    <message>
        <source>Speak &amp;alerts</source>
        <translation>Meldungen &amp;vorlesen</translation>
    </message>
    <message>
        <source>Speak alerts</source>
        <translation>Meldungen vorlesen</translation>
    </message>
    <message>
        <source>This build of Skyseal has no speech: it lacks speech-dispatcher.</source>
        <translation>Dieser Build von Skyseal hat keine Sprachausgabe: speech-dispatcher fehlt.</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Sprache</translation>
    </message>
    <message>
        <source>same as the desktop</source>
        <translation>wie der Desktop</translation>
    </message>
    <message>
        <source>Lan&amp;guage</source>
        <translation>Sp&amp;rache</translation>
    </message>
    <message>
        <source>The language takes effect at the next start.</source>
        <translation>Die Sprache gilt ab dem nächsten Start.</translation>
    </message>
    <message>
        <source>MAVLink system ID</source>
        <translation>MAVLink-System-ID</translation>
    </message>
    <message>
        <source>MAVLink component ID</source>
        <translation>MAVLink-Komponenten-ID</translation>
    </message>
    <message>
        <source>IDs, link and folder take effect at the next start.</source>
        <translation>IDs, Verbindung und Ordner gelten ab dem nächsten Start.</translation>
    </message>
    <message>
        <source>aviation (ft, kt, NM)</source>
        <translation>Luftfahrt (ft, kt, NM)</translation>
    </message>
    <message>
        <source>&amp;Touch-sized controls</source>
        <translation>&amp;Touch-große Bedienelemente</translation>
    </message>
    <message>
        <source>Touch-sized controls</source>
        <translation>Touch-große Bedienelemente</translation>
    </message>
    <message>
        <source>Buttons, menus and lists are large enough for fingers</source>
        <translation>Knöpfe, Menüs und Listen sind groß genug für Finger</translation>
    </message>
    <message>
        <source>the default folder</source>
        <translation>Standardordner</translation>
    </message>
    <message>
        <source>System ID %1 is a vehicle&apos;s: choose another one.</source>
        <translation>Die System-ID %1 hat ein Fahrzeug: eine andere wählen.</translation>
    </message>
    <message>
        <source>Why the system ID cannot be chosen</source>
        <translation>Warum die System-ID nicht gewählt werden kann</translation>
    </message>
</context>
<context>
    <name>skyseal::ui::ShortcutDialog</name>
    <message>
        <source>Find an action</source>
        <translation>Aktion suchen</translation>
    </message>
    <message>
        <source>Actions and their shortcuts</source>
        <translation>Aktionen und ihre Tastenkürzel</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Ergebnis</translation>
    </message>
    <message>
        <source>Shortcut of the selected action</source>
        <translation>Tastenkürzel der ausgewählten Aktion</translation>
    </message>
    <message>
        <source>Re&amp;place</source>
        <translation>&amp;Ersetzen</translation>
    </message>
    <message>
        <source>Take the shortcut from the other action</source>
        <translation>Der anderen Aktion das Tastenkürzel nehmen</translation>
    </message>
    <message>
        <source>&amp;None</source>
        <translation>&amp;Keines</translation>
    </message>
    <message>
        <source>Remove the shortcut of the selected action</source>
        <translation>Tastenkürzel der ausgewählten Aktion entfernen</translation>
    </message>
    <message>
        <source>&amp;Default</source>
        <translation>&amp;Standard</translation>
    </message>
    <message>
        <source>Default shortcut for the selected action</source>
        <translation>Standard-Tastenkürzel für die ausgewählte Aktion</translation>
    </message>
    <message>
        <source>Keyboard shortcuts</source>
        <translation>Tastenkürzel</translation>
    </message>
    <message>
        <source>Parts of a name, a menu or keys, such as &quot;zoom&quot; or &quot;ctrl+k&quot;</source>
        <translation>Teile eines Namens, eines Menüs oder von Tasten, etwa „zoom“ oder „strg+k“</translation>
    </message>
    <message>
        <source>Reset &amp;all…</source>
        <translation>&amp;Alle zurücksetzen…</translation>
    </message>
    <message>
        <source>Reset all shortcuts</source>
        <translation>Alle Tastenkürzel zurücksetzen</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Shortcut of &quot;%1&quot;: press the keys, or Backspace for none</source>
        <translation>Tastenkürzel von „%1“: Tasten drücken, oder Rücktaste für keines</translation>
    </message>
    <message>
        <source>No action has these words.</source>
        <translation>Keine Aktion hat diese Wörter.</translation>
    </message>
    <message>
        <source>%1 is that of &quot;%2&quot;; it would lose it.</source>
        <translation>%1 gehört zu „%2“, das es verlieren würde.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; has no shortcut now.</source>
        <translation>„%1“ hat jetzt kein Tastenkürzel.</translation>
    </message>
    <message>
        <source>%1 is now that of &quot;%2&quot;.</source>
        <translation>%1 gehört jetzt zu „%2“.</translation>
    </message>
    <message>
        <source>Give every action its default shortcut?</source>
        <translation>Jeder Aktion ihr Standard-Tastenkürzel geben?</translation>
    </message>
    <message>
        <source>Reset all</source>
        <translation>Alle zurücksetzen</translation>
    </message>
    <message>
        <source>Every action has its default shortcut.</source>
        <translation>Jede Aktion hat ihr Standard-Tastenkürzel.</translation>
    </message>
</context>
<context>
    <name>skyseal::ui::ShortcutModel</name>
    <message>
        <source>none</source>
        <translation>keines</translation>
    </message>
    <message>
        <source>Action</source>
        <translation>Aktion</translation>
    </message>
    <message>
        <source>Shortcut</source>
        <translation>Tastenkürzel</translation>
    </message>
    <message>
        <source>Default</source>
        <translation>Standard</translation>
    </message>
    <message>
        <source>Menu or panel</source>
        <translation>Menü oder Bereich</translation>
    </message>
</context>
<context>
    <name>skyseal::ui::ShortcutRules</name>
    <message>
        <source>it must be pressed at once.</source>
        <translation>es muss auf einmal gedrückt werden.</translation>
    </message>
    <message>
        <source>this key is not known.</source>
        <translation>diese Taste ist unbekannt.</translation>
    </message>
    <message>
        <source>Space and Enter press buttons.</source>
        <translation>Leertaste und Eingabetaste drücken Knöpfe.</translation>
    </message>
    <message>
        <source>Tab moves between controls.</source>
        <translation>Tab wechselt zwischen Bedienelementen.</translation>
    </message>
    <message>
        <source>Esc closes and cancels.</source>
        <translation>Esc schließt und bricht ab.</translation>
    </message>
    <message>
        <source>the arrows move in the map, in lists and in texts.</source>
        <translation>die Pfeiltasten bewegen in Karte, Listen und Texten.</translation>
    </message>
    <message>
        <source>Alt with a letter opens menus and presses buttons.</source>
        <translation>Alt mit einem Buchstaben öffnet Menüs und drückt Knöpfe.</translation>
    </message>
    <message>
        <source>it opens the menu at the pointer.</source>
        <translation>es öffnet das Menü am Mauszeiger.</translation>
    </message>
    <message>
        <source>it edits texts.</source>
        <translation>es bearbeitet Texte.</translation>
    </message>
    <message>
        <source>without Ctrl or Alt, texts, lists and the map need it. F1 to F35 are free.</source>
        <translation>ohne Strg oder Alt brauchen es Texte, Listen und die Karte. F1 bis F35 sind frei.</translation>
    </message>
    <message>
        <source>%1 cannot be a shortcut: %2</source>
        <translation>%1 kann kein Tastenkürzel sein: %2</translation>
    </message>
</context>
<context>
    <name>skyseal::ui::SourceBar</name>
    <message>
        <source>REPLAY: %1</source>
        <translation>WIEDERGABE: %1</translation>
    </message>
    <message>
        <source>End the demo</source>
        <translation>Demo beenden</translation>
    </message>
    <message>
        <source>Back to live</source>
        <translation>Zurück zu Live</translation>
    </message>
    <message>
        <source>REPLAY: %1 · %2</source>
        <translation>WIEDERGABE: %1 · %2</translation>
    </message>
    <message>
        <source>REPLAY: %1 · finished</source>
        <translation>WIEDERGABE: %1 · beendet</translation>
    </message>
    <message>
        <source>Live: vehicle %1</source>
        <translation>Live: Fahrzeug %1</translation>
    </message>
    <message>
        <source>ARMED</source>
        <translation>SCHARF</translation>
    </message>
    <message>
        <source>disarmed</source>
        <translation>unscharf</translation>
    </message>
    <message>
        <source>lost for %1</source>
        <translation>verloren, Dauer %1</translation>
    </message>
    <message>
        <source>Live: no vehicle</source>
        <translation>Live: kein Fahrzeug</translation>
    </message>
    <message>
        <source>DEMO: a simulated copter takes off and flies by itself until you command it</source>
        <translation>DEMO: Ein simulierter Copter hebt ab und fliegt von selbst, bis Sie ihm etwas befehlen</translation>
    </message>
    <message>
        <source>All data are simulated. Your first command ends the flight of the demo. End the demo, here or in the menu Tools, returns to your links.</source>
        <translation>Alle Daten sind simuliert. Ihr erster Befehl beendet den Flug der Demo. „Demo beenden“, hier oder im Menü Extras, kehrt zu Ihren Verbindungen zurück.</translation>
    </message>
</context>
<context>
    <name>skyseal::ui::SourceModel</name>
    <message>
        <source>Value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Einheit</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Art</translation>
    </message>
</context>
<context>
    <name>skyseal::ui::StateText</name>
    <message>
        <source>no GPS</source>
        <translation>kein GPS</translation>
    </message>
    <message>
        <source>no fix</source>
        <translation>kein Fix</translation>
    </message>
    <message>
        <source>2D fix</source>
        <translation>2D-Fix</translation>
    </message>
    <message>
        <source>3D fix</source>
        <translation>3D-Fix</translation>
    </message>
    <message>
        <source>DGPS</source>
        <translation>DGPS</translation>
    </message>
    <message>
        <source>RTK float</source>
        <translation>RTK-Float</translation>
    </message>
    <message>
        <source>RTK fixed</source>
        <translation>RTK-Fix</translation>
    </message>
    <message>
        <source>static</source>
        <translation>statisch</translation>
    </message>
    <message>
        <source>PPP</source>
        <translation>PPP</translation>
    </message>
    <message>
        <source>Battery %1 (avionics)</source>
        <translation>Akku %1 (Avionik)</translation>
    </message>
    <message>
        <source>Battery %1 (payload)</source>
        <translation>Akku %1 (Nutzlast)</translation>
    </message>
    <message>
        <source>Battery %1</source>
        <translation>Akku %1</translation>
    </message>
    <message>
        <source>emergency</source>
        <translation>Notfall</translation>
    </message>
    <message>
        <source>alert</source>
        <translation>Alarm</translation>
    </message>
    <message>
        <source>critical</source>
        <translation>kritisch</translation>
    </message>
    <message>
        <source>error</source>
        <translation>Fehler</translation>
    </message>
    <message>
        <source>warning</source>
        <translation>Warnung</translation>
    </message>
    <message>
        <source>notice</source>
        <translation>Hinweis</translation>
    </message>
    <message>
        <source>info</source>
        <translation>Info</translation>
    </message>
    <message>
        <source>debug</source>
        <translation>Debug</translation>
    </message>
    <message>
        <source>Arm</source>
        <translation>Scharfschalten</translation>
    </message>
    <message>
        <source>Disarm</source>
        <translation>Entschärfen</translation>
    </message>
    <message>
        <source>Land</source>
        <translation>Landen</translation>
    </message>
    <message>
        <source>Mode %1</source>
        <translation>Modus %1</translation>
    </message>
    <message>
        <source>Mission item %1</source>
        <translation>Missionspunkt %1</translation>
    </message>
    <message>
        <source>Restart the autopilot</source>
        <translation>Autopilot neu starten</translation>
    </message>
    <message>
        <source>Command %1</source>
        <translation>Befehl %1</translation>
    </message>
    <message>
        <source>Emergency stop</source>
        <translation>Not-Aus</translation>
    </message>
    <message>
        <source>Go here</source>
        <translation>Ort ansteuern</translation>
    </message>
    <message>
        <source>Set home here</source>
        <translation>Home hierher setzen</translation>
    </message>
    <message>
        <source>Pre-arm checks</source>
        <translation>Vorprüfung</translation>
    </message>
    <message>
        <source>RTL</source>
        <translation>RTL</translation>
    </message>
    <message>
        <source>Point camera here</source>
        <translation>Kamera hierher richten</translation>
    </message>
    <message>
        <source>Stop pointing camera</source>
        <translation>Ausrichtung beenden</translation>
    </message>
    <message>
        <source>Start mission</source>
        <translation>Mission starten</translation>
    </message>
    <message>
        <source>Take off to %1</source>
        <translation>Start auf %1</translation>
    </message>
    <message>
        <source>Change altitude to %1</source>
        <translation>Höhe auf %1 ändern</translation>
    </message>
    <message>
        <source>Speed %1</source>
        <translation>Geschwindigkeit %1</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pause</translation>
    </message>
</context>
<context>
    <name>skyseal::ui::StatusStrip</name>
    <message>
        <source>Vehicle</source>
        <translation>Fahrzeug</translation>
    </message>
    <message>
        <source>Armed state</source>
        <translation>Scharf oder unscharf</translation>
    </message>
    <message>
        <source>Flight mode</source>
        <translation>Flugmodus</translation>
    </message>
    <message>
        <source>GPS</source>
        <translation>GPS</translation>
    </message>
    <message>
        <source>Battery</source>
        <translation>Akku</translation>
    </message>
    <message>
        <source>Link security</source>
        <translation>Sicherheit der Verbindung</translation>
    </message>
    <message>
        <source>Link quality</source>
        <translation>Qualität der Verbindung</translation>
    </message>
    <message>
        <source>DISARMED</source>
        <translation>UNSCHARF</translation>
    </message>
    <message>
        <source>RTK fixed</source>
        <translation>RTK-Fix</translation>
    </message>
    <message>
        <source>%1 sat</source>
        <translation>%1 Sat</translation>
    </message>
    <message>
        <source>No vehicle</source>
        <translation>Kein Fahrzeug</translation>
    </message>
    <message>
        <source>Vehicle %1</source>
        <translation>Fahrzeug %1</translation>
    </message>
    <message>
        <source>ARMED</source>
        <translation>SCHARF</translation>
    </message>
    <message>
        <source>HDOP %1</source>
        <translation>HDOP %1</translation>
    </message>
    <message>
        <source>low</source>
        <translation>schwach</translation>
    </message>
    <message>
        <source>No link</source>
        <translation>Keine Verbindung</translation>
    </message>
    <message>
        <source>Link OK %1</source>
        <translation>Empfang ok %1</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>Link lost</source>
        <translation>Verbindung verloren</translation>
    </message>
    <message>
        <source>Lost</source>
        <translation>Verloren</translation>
    </message>
    <message>
        <source>Link poor %1</source>
        <translation>Empfang schlecht %1</translation>
    </message>
    <message>
        <source>%1 of the frames arrived
%2 latency
%3 since the newest message
%4 frames/s, %5 lost</source>
        <translation>%1 der Frames sind angekommen
%2 Latenz
%3 seit der neuesten Nachricht
%4 Frames/s, %5 verloren</translation>
    </message>
    <message>
        <source>Other stations</source>
        <translation>Andere Stationen</translation>
    </message>
    <message>
        <source>Shared</source>
        <translation>Geteilt</translation>
    </message>
    <message>
        <source>%1
A click opens the links.</source>
        <translation>%1
Ein Klick öffnet die Verbindungen.</translation>
    </message>
    <message>
        <source>Lowest in the last minute: %1 %</source>
        <translation>Tiefster Wert der letzten Minute: %1 %</translation>
    </message>
</context>
<context>
    <name>skyseal::ui::SuiteActions</name>
    <message>
        <source>the link is not sealed</source>
        <translation>nicht versiegelt</translation>
    </message>
    <message>
        <source>no sealed link yet</source>
        <translation>noch unversiegelt</translation>
    </message>
    <message>
        <source>research suites are off</source>
        <translation>Forschungs-Chiffren aus</translation>
    </message>
    <message>
        <source>not allowed here</source>
        <translation>hier nicht erlaubt</translation>
    </message>
    <message>
        <source>switching…</source>
        <translation>wechselt…</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>weaker than allowed</source>
        <translation>schwächer als erlaubt</translation>
    </message>
    <message>
        <source>changing…</source>
        <translation>wechselt…</translation>
    </message>
    <message>
        <source>Change keys &amp;now</source>
        <translation>Schlüssel &amp;jetzt wechseln</translation>
    </message>
    <message>
        <source>a sweep is running</source>
        <translation>eine Messreihe läuft</translation>
    </message>
    <message>
        <source>not offered by the agent</source>
        <translation>vom Agenten nicht angeboten</translation>
    </message>
    <message>
        <source>New keys for the suite in use, without interrupting the link</source>
        <translation>Neue Schlüssel für die verwendete Chiffre, ohne die Verbindung zu unterbrechen</translation>
    </message>
    <message>
        <source>Sealed with %1: %2, chosen last, is weaker</source>
        <translation>Versiegelt mit %1: die zuletzt gewählte Chiffre %2 ist schwächer</translation>
    </message>
    <message>
        <source>Sealed with %1: %2, chosen last, is not permitted now</source>
        <translation>Versiegelt mit %1: die zuletzt gewählte Chiffre %2 ist jetzt nicht zugelassen</translation>
    </message>
    <message>
        <source>a replay is shown</source>
        <translation>eine Wiedergabe wird gezeigt</translation>
    </message>
</context>
<context>
    <name>skyseal::ui::SuiteLegend</name>
    <message>
        <source>Legend</source>
        <translation>Legende</translation>
    </message>
</context>
<context>
    <name>skyseal::ui::SuiteRow</name>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
</context>
<context>
    <name>skyseal::ui::SuiteTableModel</name>
    <message>
        <source>%1
%2</source>
        <translation>%1
%2</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>from %1 to %2, %3 samples</source>
        <translation>von %1 bis %2, %3 Messwerte</translation>
    </message>
    <message>
        <source>Suite</source>
        <translation>Chiffre</translation>
    </message>
    <message>
        <source>In use</source>
        <translation>In Gebrauch</translation>
    </message>
</context>
<context>
    <name>skyseal::ui::SweepDialog</name>
    <message>
        <source>Run a sweep</source>
        <translation>Messreihe starten</translation>
    </message>
    <message>
        <source>&amp;Run</source>
        <translation>&amp;Starten</translation>
    </message>
    <message>
        <source>Warning</source>
        <translation>Warnung</translation>
    </message>
    <message>
        <source>Measure on</source>
        <translation>Messobjekt</translation>
    </message>
    <message>
        <source>The connected link</source>
        <translation>Die bestehende Verbindung</translation>
    </message>
    <message>
        <source>The &amp;connected link, to %1</source>
        <translation>Die bestehende &amp;Verbindung zu %1</translation>
    </message>
    <message>
        <source>The &amp;connected link · %1</source>
        <translation>Die bestehende &amp;Verbindung · %1</translation>
    </message>
    <message>
        <source>Sealed: whole frames in records</source>
        <translation>Versiegelt: ganze Frames in Records</translation>
    </message>
    <message>
        <source>Sealed framing</source>
        <translation>Versiegelte Rahmung</translation>
    </message>
    <message>
        <source>Inline framing</source>
        <translation>Inline-Rahmung</translation>
    </message>
    <message>
        <source>Natural load</source>
        <translation>Natürliche Last</translation>
    </message>
    <message>
        <source>Saturated load</source>
        <translation>Volllast</translation>
    </message>
    <message>
        <source>Length of each run</source>
        <translation>Dauer je Lauf</translation>
    </message>
    <message>
        <source> s</source>
        <translation> s</translation>
    </message>
    <message>
        <source>Runs for each suite</source>
        <translation>Läufe je Chiffre</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>Startwert</translation>
    </message>
    <message>
        <source>The same seed gives the same order of runs</source>
        <translation>Derselbe Startwert ergibt dieselbe Reihenfolge der Läufe</translation>
    </message>
    <message>
        <source>One suite twice, to see the noise (A/A)</source>
        <translation>Eine Chiffre zweimal, um das Rauschen zu sehen (A/A)</translation>
    </message>
    <message>
        <source>Measure the noise</source>
        <translation>Das Rauschen messen</translation>
    </message>
    <message>
        <source>&amp;Each run</source>
        <translation>&amp;Dauer je Lauf</translation>
    </message>
    <message>
        <source>Re&amp;peats</source>
        <translation>&amp;Wiederholungen</translation>
    </message>
    <message>
        <source>&amp;Seed of the order</source>
        <translation>Startwert der &amp;Reihenfolge</translation>
    </message>
    <message>
        <source>Inline: payloads sealed in place</source>
        <translation>Inline: Nutzdaten im Frame versiegelt</translation>
    </message>
    <message>
        <source>Saturated load: as much as the link carries</source>
        <translation>Volllast: so viel, wie die Verbindung trägt</translation>
    </message>
    <message>
        <source>One run, %1</source>
        <translation>Ein Lauf, %1</translation>
    </message>
    <message>
        <source>%1 runs, %2</source>
        <translation>%1 Läufe, %2</translation>
    </message>
    <message>
        <source>Summary</source>
        <translation>Zusammenfassung</translation>
    </message>
    <message>
        <source>The suites change on the live link. At the end the current suite is restored.</source>
        <translation>Die Chiffren wechseln auf der laufenden Verbindung. Am Ende wird die jetzige Chiffre wiederhergestellt.</translation>
    </message>
    <message>
        <source>Suites, framing and load</source>
        <translation>Chiffren, Rahmung und Last</translation>
    </message>
    <message>
        <source>Natural load: the streams that a station requests</source>
        <translation>Natürliche Last: die Datenströme, die eine Station anfordert</translation>
    </message>
    <message>
        <source>Inline is the framing that the MAVSec paper measured: payloads are encrypted in place, headers stay clear. It needs a cipher with an HMAC, and the agent must allow it (skyseal-air --allow-inline).</source>
        <translation>Inline ist die im MAVSec-Artikel gemessene Rahmung: Nutzdaten im Frame verschlüsselt, Header lesbar. Sie braucht eine Chiffre mit HMAC und einen Agenten, der sie zulässt (skyseal-air --allow-inline).</translation>
    </message>
    <message>
        <source>Duration</source>
        <translation>Dauer</translation>
    </message>
    <message>
        <source>Choose a link, a suite, a framing that the suite supports, and a load.</source>
        <translation>Eine Verbindung, eine Chiffre, eine von ihr unterstützte Rahmung und eine Last wählen.</translation>
    </message>
    <message>
        <source>You consent to plain MAVLink: during these runs telemetry and commands are sent in clear, and anyone can command the vehicle.</source>
        <translation>Damit wird ungeschütztem MAVLink zugestimmt: Während dieser Läufe werden Telemetrie und Befehle im Klartext gesendet, und jeder kann dem Fahrzeug Befehle geben.</translation>
    </message>
    <message>
        <source>Link to the autopilot</source>
        <translation>Verbindung zum Autopiloten</translation>
    </message>
    <message>
        <source>Suites and impairments change on the sweep&apos;s own link; the autopilot is not commanded. Flights: skyseal-cli sweep --vehicle URL --fly SCRIPT.</source>
        <translation>Chiffren und Störungen wechseln auf der eigenen Verbindung der Messreihe; der Autopilot erhält keine Befehle. Flüge: skyseal-cli sweep --vehicle URL --fly SCRIPT.</translation>
    </message>
    <message>
        <source>A separate simulated &amp;vehicle, on this machine</source>
        <translation>Ein eigenes simuliertes &amp;Fahrzeug auf diesem Rechner</translation>
    </message>
    <message>
        <source>A separate simulated vehicle</source>
        <translation>Ein eigenes simuliertes Fahrzeug</translation>
    </message>
    <message>
        <source>A running &amp;autopilot, with a separate agent</source>
        <translation>Ein laufender &amp;Autopilot mit eigenem Agenten</translation>
    </message>
    <message>
        <source>A running autopilot</source>
        <translation>Ein laufender Autopilot</translation>
    </message>
    <message>
        <source>The noise can be measured only with 2 or more repeats.</source>
        <translation>Das Rauschen lässt sich nur mit 2 oder mehr Wiederholungen messen.</translation>
    </message>
    <message>
        <source>The link to the autopilot must be a URL, such as tcp:127.0.0.1:5760.</source>
        <translation>Die Verbindung zum Autopiloten muss eine URL sein, etwa tcp:127.0.0.1:5760.</translation>
    </message>
</context>
<context>
    <name>skyseal::ui::SweepPage</name>
    <message>
        <source>The sweep</source>
        <translation>Die Messreihe</translation>
    </message>
    <message>
        <source>Run a sweep…</source>
        <translation>Messreihe starten…</translation>
    </message>
    <message>
        <source>Run a sweep</source>
        <translation>Messreihe starten</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Cancel the sweep</source>
        <translation>Messreihe abbrechen</translation>
    </message>
    <message>
        <source>Save…</source>
        <translation>Speichern…</translation>
    </message>
    <message>
        <source>Save the sweep&apos;s files</source>
        <translation>Die Dateien der Messreihe speichern</translation>
    </message>
    <message>
        <source>Load and link</source>
        <translation>Last und Verbindung</translation>
    </message>
    <message>
        <source>Measurement in the bars</source>
        <translation>Messgröße der Balken</translation>
    </message>
    <message>
        <source>One run in %1</source>
        <translation>Ein Lauf in %1</translation>
    </message>
    <message>
        <source>%1 runs in %2</source>
        <translation>%1 Läufe in %2</translation>
    </message>
    <message>
        <source>Incomplete, %1 of %2 runs: %3</source>
        <translation>Unvollständig, %1 von %2 Läufen: %3</translation>
    </message>
    <message>
        <source>; %1 failed: %2</source>
        <translation>; %1 fehlgeschlagen: %2</translation>
    </message>
    <message>
        <source>; %1 not valid: %2</source>
        <translation>; %1 ungültig: %2</translation>
    </message>
    <message>
        <source>Writing the files…</source>
        <translation>Dateien werden geschrieben…</translation>
    </message>
    <message>
        <source>Not saved: %1</source>
        <translation>Nicht gespeichert: %1</translation>
    </message>
    <message>
        <source>Saved in %1</source>
        <translation>Gespeichert in %1</translation>
    </message>
    <message>
        <source>Saved in %1; %2</source>
        <translation>Gespeichert in %1; %2</translation>
    </message>
    <message>
        <source>not measured yet</source>
        <translation>noch nicht gemessen</translation>
    </message>
    <message>
        <source>not measured</source>
        <translation>nicht gemessen</translation>
    </message>
    <message>
        <source>Starting…</source>
        <translation>Startet…</translation>
    </message>
    <message>
        <source>Run %1 of %2, %3 left: %4, %5</source>
        <translation>Lauf %1 von %2, noch %3: %4, %5</translation>
    </message>
    <message>
        <source>Runs completed</source>
        <translation>Beendete Läufe</translation>
    </message>
    <message>
        <source>No sweep yet. A sweep measures the cost of each suite in turn.</source>
        <translation>Noch keine Messreihe. Eine Messreihe misst nacheinander den Aufwand jeder Chiffre.</translation>
    </message>
    <message>
        <source>Stopping: restoring the suite of the link…</source>
        <translation>Hält an: Die Chiffre der Verbindung wird wiederhergestellt…</translation>
    </message>
    <message>
        <source>Bars of the sweep</source>
        <translation>Balken der Messreihe</translation>
    </message>
    <message>
        <source>Ratios or means</source>
        <translation>Verhältnisse oder Mittelwerte</translation>
    </message>
    <message>
        <source>Results of the sweep</source>
        <translation>Ergebnisse der Messreihe</translation>
    </message>
    <message>
        <source>Means</source>
        <translation>Mittelwerte</translation>
    </message>
    <message>
        <source>Warnings and the measurement&apos;s own share</source>
        <translation>Warnungen und der Anteil der Messung selbst</translation>
    </message>
    <message>
        <source>Warnings of the sweep</source>
        <translation>Warnungen der Messreihe</translation>
    </message>
    <message>
        <source>not compared</source>
        <translation>nicht verglichen</translation>
    </message>
</context>
<context>
    <name>skyseal::ui::SweepPresenter</name>
    <message>
        <source>Choose the folder in which the sweep&apos;s folder is created</source>
        <translation>Den Ordner wählen, in dem der Ordner der Messreihe angelegt wird</translation>
    </message>
    <message>
        <source>Cipher sweep</source>
        <translation>Messreihe</translation>
    </message>
    <message>
        <source>The vehicle is armed. Measure on its link?</source>
        <translation>Das Fahrzeug ist scharf. Auf seiner Verbindung messen?</translation>
    </message>
    <message>
        <source>The sweep switches the suite of the link by which the vehicle is commanded before each run.</source>
        <translation>Die Messreihe wechselt vor jedem Lauf die Chiffre der Verbindung, über die das Fahrzeug gesteuert wird.</translation>
    </message>
    <message>
        <source>Measure</source>
        <translation>Messen</translation>
    </message>
</context>
<context>
    <name>skyseal::ui::SweepTableModel</name>
    <message>
        <source>%1 (A/A)</source>
        <translation>%1 (A/A)</translation>
    </message>
    <message>
        <source>from %1 to %2 in %3 runs</source>
        <translation>von %1 bis %2 in %3 Läufen</translation>
    </message>
    <message>
        <source>Suite</source>
        <translation>Chiffre</translation>
    </message>
    <message>
        <source>Framing</source>
        <translation>Rahmung</translation>
    </message>
</context>
<context>
    <name>skyseal::ui::TakeOffDialog</name>
    <message>
        <source>Take off</source>
        <translation>Abheben</translation>
    </message>
    <message>
        <source>Hold the button for half a second. The propellers speed up and the vehicle climbs.</source>
        <translation>Den Knopf eine halbe Sekunde halten. Die Propeller laufen hoch, und das Fahrzeug steigt.</translation>
    </message>
    <message>
        <source>Hold the button for half a second. The vehicle is armed, and takes off at once.</source>
        <translation>Die Taste eine halbe Sekunde halten. Das Fahrzeug wird scharfgeschaltet und hebt sofort ab.</translation>
    </message>
    <message>
        <source>Arm and take off</source>
        <translation>Scharfschalten und abheben</translation>
    </message>
</context>
<context>
    <name>skyseal::ui::TileFile</name>
    <message>
        <source>%1 cannot be opened: %2</source>
        <translation>%1 lässt sich nicht öffnen: %2</translation>
    </message>
    <message>
        <source>%1 cannot be shown: %2</source>
        <translation>%1 lässt sich nicht anzeigen: %2</translation>
    </message>
    <message>
        <source>out of memory</source>
        <translation>nicht genug Speicher</translation>
    </message>
    <message>
        <source>it is neither an MBTiles nor a GeoPackage file (%1)</source>
        <translation>es ist weder eine MBTiles- noch eine GeoPackage-Datei (%1)</translation>
    </message>
    <message>
        <source>it has vector tiles; only images (PNG, JPEG, WebP) can be shown</source>
        <translation>sie enthält Vektorkacheln; darstellbar sind nur Bilder (PNG, JPEG, WebP)</translation>
    </message>
    <message>
        <source>it has no map tiles (%1)</source>
        <translation>sie enthält keine Kartenkacheln (%1)</translation>
    </message>
    <message>
        <source>it has no map tiles in Web Mercator (EPSG:3857)</source>
        <translation>sie enthält keine Kartenkacheln in Web Mercator (EPSG:3857)</translation>
    </message>
    <message>
        <source>its tiles are not those of the usual grid, %1 pixels wide</source>
        <translation>ihre Kacheln sind nicht die des üblichen Rasters mit %1 Pixeln Breite</translation>
    </message>
    <message>
        <source>a tile is larger than %1 kB</source>
        <translation>eine Kachel ist größer als %1 kB</translation>
    </message>
    <message>
        <source>the file takes too long to search</source>
        <translation>die Suche in der Datei dauert zu lange</translation>
    </message>
</context>
<context>
    <name>skyseal::ui::TileImage</name>
    <message>
        <source>a tile is larger than %1 kB</source>
        <translation>eine Kachel ist größer als %1 kB</translation>
    </message>
    <message>
        <source>a tile is neither PNG, JPEG nor WebP</source>
        <translation>eine Kachel ist weder PNG noch JPEG noch WebP</translation>
    </message>
    <message>
        <source>a tile cannot be read as %1</source>
        <translation>eine Kachel lässt sich nicht als %1 lesen</translation>
    </message>
    <message>
        <source>a tile has %1×%2 pixels, more than %3</source>
        <translation>eine Kachel hat %1×%2 Pixel, mehr als %3</translation>
    </message>
</context>
<context>
    <name>skyseal::ui::TileTemplate</name>
    <message>
        <source>The address must begin with https:// or http:// and name a server</source>
        <translation>Die Adresse muss mit https:// oder http:// beginnen und einen Server nennen</translation>
    </message>
    <message>
        <source>The address must contain {z}, {x} and {y}, where the server expects zoom level, column and row</source>
        <translation>Die Adresse muss {z}, {x} und {y} enthalten, wo der Server Zoomstufe, Spalte und Zeile erwartet</translation>
    </message>
    <message>
        <source>Only the placeholders {z}, {x} and {y} (or {-y}) are supported</source>
        <translation>Nur die Platzhalter {z}, {x} und {y} (oder {-y}) werden unterstützt</translation>
    </message>
    <message>
        <source>The server name must not contain placeholders</source>
        <translation>Der Servername darf keine Platzhalter enthalten</translation>
    </message>
    <message>
        <source>openstreetmap.org does not permit fetching areas for later use; choose a server that does</source>
        <translation>openstreetmap.org erlaubt nicht, Ausschnitte auf Vorrat zu laden; einen Server wählen, der es erlaubt</translation>
    </message>
</context>
<context>
    <name>skyseal::ui::TileWorker</name>
    <message>
        <source>the source of the map was changed</source>
        <translation>die Kartenquelle wurde geändert</translation>
    </message>
    <message>
        <source>a tile is larger than %1 kB</source>
        <translation>eine Kachel ist größer als %1 kB</translation>
    </message>
    <message>
        <source>the server does not answer</source>
        <translation>der Server antwortet nicht</translation>
    </message>
    <message>
        <source>the map has no tile server</source>
        <translation>die Karte hat keinen Kachelserver</translation>
    </message>
    <message>
        <source>no tile could be downloaded: %1</source>
        <translation>es konnte keine Kachel geladen werden: %1</translation>
    </message>
</context>
<context>
    <name>skyseal::ui::TrafficBar</name>
    <message>
        <source>Links</source>
        <translation>Verbindungen</translation>
    </message>
    <message>
        <source>Received</source>
        <translation>Empfangen</translation>
    </message>
    <message>
        <source>Sent</source>
        <translation>Gesendet</translation>
    </message>
    <message>
        <source>Recording</source>
        <translation>Aufzeichnung</translation>
    </message>
    <message>
        <source>recording %1</source>
        <translation>Aufzeichnung %1</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>%1 %2 (%3)</source>
        <translation>%1 %2 (%3)</translation>
    </message>
    <message>
        <source>no link</source>
        <translation>keine Verbindung</translation>
    </message>
    <message>
        <source>not recording</source>
        <translation>keine Aufzeichnung</translation>
    </message>
</context>
<context>
    <name>skyseal::ui::ValueCell</name>
    <message>
        <source>▼ low</source>
        <translation>▼ niedrig</translation>
    </message>
    <message>
        <source>▲ high</source>
        <translation>▲ hoch</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
</context>
<context>
    <name>skyseal::ui::ValueChoice</name>
    <message>
        <source>&quot;%1&quot; is not a number</source>
        <translation>„%1“ ist keine Zahl</translation>
    </message>
    <message>
        <source>there is no value &quot;%1&quot;</source>
        <translation>es gibt keinen Wert „%1“</translation>
    </message>
    <message>
        <source>&quot;decimals&quot; is not a number from 0 to %1</source>
        <translation>„decimals“ ist keine Zahl von 0 bis %1</translation>
    </message>
    <message>
        <source>&quot;low&quot; is not below &quot;high&quot;</source>
        <translation>„low“ liegt nicht unter „high“</translation>
    </message>
    <message>
        <source>&quot;line&quot; is neither true nor false</source>
        <translation>„line“ ist weder true noch false</translation>
    </message>
    <message>
        <source>not JSON: %1</source>
        <translation>kein JSON: %1</translation>
    </message>
    <message>
        <source>not a list</source>
        <translation>keine Liste</translation>
    </message>
    <message>
        <source>more than %1 values</source>
        <translation>mehr als %1 Werte</translation>
    </message>
    <message>
        <source>value %1: %2</source>
        <translation>Wert %1: %2</translation>
    </message>
    <message>
        <source>&quot;caption&quot; is not text of at most %1 characters</source>
        <translation>„caption“ ist kein Text mit höchstens %1 Zeichen</translation>
    </message>
    <message>
        <source>&quot;unit&quot; is not text of at most %1 characters</source>
        <translation>„unit“ ist kein Text mit höchstens %1 Zeichen</translation>
    </message>
</context>
<context>
    <name>skyseal::ui::ValueReading</name>
    <message>
        <source>bad</source>
        <translation>schlecht</translation>
    </message>
    <message>
        <source>good</source>
        <translation>gut</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>ja</translation>
    </message>
    <message>
        <source>no</source>
        <translation>nein</translation>
    </message>
    <message>
        <source>since first heard</source>
        <translation>ab Empfang</translation>
    </message>
    <message>
        <source>The vehicle was already flying when this station first heard it. The time counts from then: the flight itself is longer.</source>
        <translation>Das Fahrzeug flog schon, als diese Station es zum ersten Mal empfing. Die Zeit zählt ab dann: Der Flug selbst ist länger.</translation>
    </message>
</context>
<context>
    <name>skyseal::ui::ValueSource</name>
    <message>
        <source>derived by the station: %1</source>
        <translation>von der Station abgeleitet: %1</translation>
    </message>
    <message>
        <source>%1 elements</source>
        <translation>%1 Elemente</translation>
    </message>
    <message>
        <source>system</source>
        <translation>System</translation>
    </message>
    <message>
        <source>Flight mode</source>
        <translation>Flugmodus</translation>
    </message>
    <message>
        <source>mode</source>
        <translation>Modus</translation>
    </message>
    <message>
        <source>Armed</source>
        <translation>Scharf</translation>
    </message>
    <message>
        <source>armed</source>
        <translation>scharf</translation>
    </message>
    <message>
        <source>Roll, right wing down positive</source>
        <translation>Rollen, rechte Seite unten positiv</translation>
    </message>
    <message>
        <source>roll</source>
        <translation>Rollen</translation>
    </message>
    <message>
        <source>Pitch, nose up positive</source>
        <translation>Nicken, Nase oben positiv</translation>
    </message>
    <message>
        <source>pitch</source>
        <translation>Nicken</translation>
    </message>
    <message>
        <source>Yaw</source>
        <translation>Gieren</translation>
    </message>
    <message>
        <source>yaw</source>
        <translation>Gieren</translation>
    </message>
    <message>
        <source>Latitude</source>
        <translation>Breitengrad</translation>
    </message>
    <message>
        <source>lat</source>
        <translation>Breite</translation>
    </message>
    <message>
        <source>Longitude</source>
        <translation>Längengrad</translation>
    </message>
    <message>
        <source>lon</source>
        <translation>Länge</translation>
    </message>
    <message>
        <source>Altitude above home</source>
        <translation>Höhe über Home</translation>
    </message>
    <message>
        <source>alt</source>
        <translation>Höhe</translation>
    </message>
    <message>
        <source>Ground speed</source>
        <translation>Geschwindigkeit über Grund</translation>
    </message>
    <message>
        <source>speed</source>
        <translation>Tempo</translation>
    </message>
    <message>
        <source>Battery voltage</source>
        <translation>Akkuspannung</translation>
    </message>
    <message>
        <source>battery</source>
        <translation>Akku</translation>
    </message>
    <message>
        <source>Battery, remaining</source>
        <translation>Akku, Restladung</translation>
    </message>
    <message>
        <source>GPS fix</source>
        <translation>GPS-Fix</translation>
    </message>
    <message>
        <source>GPS</source>
        <translation>GPS</translation>
    </message>
    <message>
        <source>Satellites in use</source>
        <translation>Verwendete Satelliten</translation>
    </message>
    <message>
        <source>satellites</source>
        <translation>Satelliten</translation>
    </message>
    <message>
        <source>EKF, the estimate of attitude and position</source>
        <translation>EKF, die Schätzung von Lage und Position</translation>
    </message>
    <message>
        <source>EKF</source>
        <translation>EKF</translation>
    </message>
    <message>
        <source>Time since the last heartbeat</source>
        <translation>Zeit seit dem letzten Heartbeat</translation>
    </message>
    <message>
        <source>heartbeat</source>
        <translation>Heartbeat</translation>
    </message>
    <message>
        <source>Altitude above mean sea level</source>
        <translation>Höhe über NN</translation>
    </message>
    <message>
        <source>alt MSL</source>
        <translation>Höhe NN</translation>
    </message>
    <message>
        <source>Climb rate</source>
        <translation>Steigrate</translation>
    </message>
    <message>
        <source>climb</source>
        <translation>Steigen</translation>
    </message>
    <message>
        <source>Heading</source>
        <translation>Steuerkurs</translation>
    </message>
    <message>
        <source>hdg</source>
        <translation>Kurs</translation>
    </message>
    <message>
        <source>Airspeed</source>
        <translation>Fluggeschwindigkeit</translation>
    </message>
    <message>
        <source>airspeed</source>
        <translation>Airspeed</translation>
    </message>
    <message>
        <source>Throttle</source>
        <translation>Gas</translation>
    </message>
    <message>
        <source>throttle</source>
        <translation>Gas</translation>
    </message>
    <message>
        <source>Battery current</source>
        <translation>Akkustrom</translation>
    </message>
    <message>
        <source>current</source>
        <translation>Strom</translation>
    </message>
    <message>
        <source>HDOP of the GPS</source>
        <translation>HDOP des GPS</translation>
    </message>
    <message>
        <source>HDOP</source>
        <translation>HDOP</translation>
    </message>
    <message>
        <source>Distance to home</source>
        <translation>Entfernung zu Home</translation>
    </message>
    <message>
        <source>home</source>
        <translation>Home</translation>
    </message>
    <message>
        <source>Flight time</source>
        <translation>Flugzeit</translation>
    </message>
    <message>
        <source>time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>Current mission item</source>
        <translation>Aktueller Missionspunkt</translation>
    </message>
    <message>
        <source>item</source>
        <translation>Punkt</translation>
    </message>
    <message>
        <source>mode no.</source>
        <translation>Modus-Nr.</translation>
    </message>
    <message>
        <source>State of the system (MAV_STATE)</source>
        <translation>Zustand des Systems (MAV_STATE)</translation>
    </message>
    <message>
        <source>state</source>
        <translation>Zustand</translation>
    </message>
    <message>
        <source>CPU load of the autopilot</source>
        <translation>CPU-Last des Autopiloten</translation>
    </message>
    <message>
        <source>CPU</source>
        <translation>CPU</translation>
    </message>
    <message>
        <source>vibration</source>
        <translation>Vibration</translation>
    </message>
    <message>
        <source>Round-trip time of the link</source>
        <translation>Umlaufzeit der Verbindung</translation>
    </message>
    <message>
        <source>latency</source>
        <translation>Latenz</translation>
    </message>
    <message>
        <source>Time since the last message</source>
        <translation>Zeit seit der letzten Nachricht</translation>
    </message>
    <message>
        <source>age</source>
        <translation>Alter</translation>
    </message>
    <message>
        <source>Link lost</source>
        <translation>Verbindung verloren</translation>
    </message>
    <message>
        <source>lost</source>
        <translation>verloren</translation>
    </message>
    <message>
        <source>Firmware</source>
        <translation>Firmware</translation>
    </message>
    <message>
        <source>firmware</source>
        <translation>Firmware</translation>
    </message>
    <message>
        <source>MAVLink system ID</source>
        <translation>MAVLink-System-ID</translation>
    </message>
    <message>
        <source>Flight mode number</source>
        <translation>Nummer des Flugmodus</translation>
    </message>
    <message>
        <source>Vibration, worst axis</source>
        <translation>Vibration, schlechteste Achse</translation>
    </message>
    <message>
        <source>Signal of the radio, in its units</source>
        <translation>Signal des Funkgeräts, in seinen Einheiten</translation>
    </message>
    <message>
        <source>signal</source>
        <translation>Signal</translation>
    </message>
    <message>
        <source>Signal of the radio at the vehicle, in its units</source>
        <translation>Signal des Funkgeräts am Fahrzeug, in seinen Einheiten</translation>
    </message>
    <message>
        <source>signal there</source>
        <translation>Signal dort</translation>
    </message>
    <message>
        <source>Noise of the radio, in its units</source>
        <translation>Rauschen des Funkgeräts, in seinen Einheiten</translation>
    </message>
    <message>
        <source>noise</source>
        <translation>Rauschen</translation>
    </message>
    <message>
        <source>Noise of the radio at the vehicle, in its units</source>
        <translation>Rauschen des Funkgeräts am Fahrzeug, in seinen Einheiten</translation>
    </message>
    <message>
        <source>noise there</source>
        <translation>Rauschen dort</translation>
    </message>
    <message>
        <source>Free part of the radio&apos;s transmit buffer</source>
        <translation>Freier Teil des Sendepuffers des Funkgeräts</translation>
    </message>
    <message>
        <source>buffer</source>
        <translation>Puffer</translation>
    </message>
</context>
<context>
    <name>skyseal::ui::ValuesEditor</name>
    <message>
        <source>Edit values</source>
        <translation>Werte bearbeiten</translation>
    </message>
    <message>
        <source>Chosen values</source>
        <translation>Gewählte Werte</translation>
    </message>
    <message>
        <source>&amp;Values, in the order of the grid</source>
        <translation>&amp;Werte, in der Reihenfolge der Anzeige</translation>
    </message>
    <message>
        <source>&amp;Remove</source>
        <translation>&amp;Entfernen</translation>
    </message>
    <message>
        <source>&amp;Up</source>
        <translation>Nach &amp;oben</translation>
    </message>
    <message>
        <source>&amp;Down</source>
        <translation>Nach &amp;unten</translation>
    </message>
    <message>
        <source>The selected value</source>
        <translation>Der ausgewählte Wert</translation>
    </message>
    <message>
        <source>Source</source>
        <translation>Quelle</translation>
    </message>
    <message>
        <source>Caption</source>
        <translation>Beschriftung</translation>
    </message>
    <message>
        <source>Element of the array</source>
        <translation>Element des Arrays</translation>
    </message>
    <message>
        <source>Decimals</source>
        <translation>Nachkommastellen</translation>
    </message>
    <message>
        <source>automatic</source>
        <translation>automatisch</translation>
    </message>
    <message>
        <source>Low limit</source>
        <translation>Untere Grenze</translation>
    </message>
    <message>
        <source>High limit</source>
        <translation>Obere Grenze</translation>
    </message>
    <message>
        <source>L&amp;ine of the last minute</source>
        <translation>&amp;Verlauf der letzten Minute</translation>
    </message>
    <message>
        <source>Line of the last minute</source>
        <translation>Verlauf der letzten Minute</translation>
    </message>
    <message>
        <source>&amp;Caption</source>
        <translation>&amp;Beschriftung</translation>
    </message>
    <message>
        <source>&amp;Element</source>
        <translation>E&amp;lement</translation>
    </message>
    <message>
        <source>Deci&amp;mals</source>
        <translation>&amp;Nachkommastellen</translation>
    </message>
    <message>
        <source>&amp;Low below</source>
        <translation>Nie&amp;drig unter</translation>
    </message>
    <message>
        <source>&amp;High above</source>
        <translation>&amp;Hoch über</translation>
    </message>
    <message>
        <source>no limit</source>
        <translation>keine Grenze</translation>
    </message>
    <message>
        <source>All values</source>
        <translation>Alle Werte</translation>
    </message>
    <message>
        <source>Find a value</source>
        <translation>Wert suchen</translation>
    </message>
    <message>
        <source>Parts of a name, such as &quot;roll&quot; or &quot;battery volt&quot;</source>
        <translation>Teile eines Namens, etwa „roll“ oder „akku spann“</translation>
    </message>
    <message>
        <source>&amp;Find</source>
        <translation>&amp;Suchen</translation>
    </message>
    <message>
        <source>&amp;Add</source>
        <translation>Hin&amp;zufügen</translation>
    </message>
    <message>
        <source>Use for the &amp;selected value</source>
        <translation>&amp;Für ausgewählten Wert verwenden</translation>
    </message>
    <message>
        <source>A&amp;pply</source>
        <translation>Übe&amp;rnehmen</translation>
    </message>
    <message>
        <source>OK</source>
        <translation>OK</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>%1, shown in %2</source>
        <translation>%1, angezeigt in %2</translation>
    </message>
    <message>
        <source>Nothing is selected. Find a value below and add it.</source>
        <translation>Nichts ist ausgewählt. Unten einen Wert suchen und hinzufügen.</translation>
    </message>
    <message>
        <source>▲ &quot;%1&quot; is not a number</source>
        <translation>▲ „%1“ ist keine Zahl</translation>
    </message>
    <message>
        <source>▲ The low limit must be below the high one</source>
        <translation>▲ Die untere Grenze muss unter der oberen liegen</translation>
    </message>
    <message>
        <source>No more than %1 values</source>
        <translation>Höchstens %1 Werte</translation>
    </message>
    <message>
        <source>Adds the value that is selected below</source>
        <translation>Fügt den unten ausgewählten Wert hinzu</translation>
    </message>
    <message>
        <source>Problem</source>
        <translation>Problem</translation>
    </message>
    <message>
        <source>Matching values</source>
        <translation>Passende Werte</translation>
    </message>
    <message>
        <source>Defaul&amp;ts</source>
        <translation>S&amp;tandardwerte</translation>
    </message>
    <message>
        <source>Restores the default values; takes effect with Apply or OK</source>
        <translation>Stellt die Standardwerte wieder her; wirksam mit Übernehmen oder OK</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Einheit</translation>
    </message>
    <message>
        <source>U&amp;nit</source>
        <translation>Ei&amp;nheit</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>The unit of the message&apos;s definition, in the chosen system of units</source>
        <translation>Die Einheit aus der Definition der Nachricht, im gewählten Einheitensystem</translation>
    </message>
    <message>
        <source>No value has these words in its name.</source>
        <translation>Kein Wert hat diese Wörter in seinem Namen.</translation>
    </message>
</context>
<context>
    <name>skyseal::ui::ValuesGrid</name>
    <message>
        <source>Edit values…</source>
        <translation>Werte bearbeiten…</translation>
    </message>
    <message>
        <source>Problem with the stored values</source>
        <translation>Problem mit den gespeicherten Werten</translation>
    </message>
    <message>
        <source>No values are chosen.</source>
        <translation>Keine Werte gewählt.</translation>
    </message>
    <message>
        <source>No values</source>
        <translation>Keine Werte</translation>
    </message>
    <message>
        <source>Age of the values</source>
        <translation>Alter der Werte</translation>
    </message>
    <message>
        <source>Edit values</source>
        <translation>Werte bearbeiten</translation>
    </message>
    <message>
        <source>Last heard %1 ago</source>
        <translation>Zuletzt vor %1</translation>
    </message>
    <message>
        <source>Choose the values shown here, their limits and their lines</source>
        <translation>Die hier gezeigten Werte wählen, mit ihren Grenzen und Verläufen</translation>
    </message>
    <message>
        <source>The stored values cannot be read (%1). These are the defaults.</source>
        <translation>Die gespeicherten Werte sind nicht lesbar (%1). Dies sind die Standardwerte.</translation>
    </message>
</context>
<context>
    <name>skyseal::ui::VehicleCommands</name>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>%1: not sent: %2</source>
        <translation>%1: nicht gesendet: %2</translation>
    </message>
    <message>
        <source>%1: not sent: vehicle %2 is no longer selected</source>
        <translation>%1: nicht gesendet: Fahrzeug %2 ist nicht mehr ausgewählt</translation>
    </message>
    <message>
        <source>%1: requested…</source>
        <translation>%1: angefordert…</translation>
    </message>
    <message>
        <source>Add to the mission</source>
        <translation>Zur Mission hinzufügen</translation>
    </message>
    <message>
        <source>the mission is not known</source>
        <translation>die Mission ist nicht bekannt</translation>
    </message>
    <message>
        <source>the mission is outdated (%1): read it again</source>
        <translation>die Mission ist veraltet (%1): neu lesen</translation>
    </message>
</context>
<context>
    <name>skyseal::ui::VehicleListModel</name>
    <message>
        <source>Vehicle %1, selected</source>
        <translation>Fahrzeug %1, ausgewählt</translation>
    </message>
    <message>
        <source>Vehicle %1</source>
        <translation>Fahrzeug %1</translation>
    </message>
    <message>
        <source>Vehicle</source>
        <translation>Fahrzeug</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Art</translation>
    </message>
    <message>
        <source>Mode</source>
        <translation>Modus</translation>
    </message>
    <message>
        <source>Armed</source>
        <translation>Scharf</translation>
    </message>
    <message>
        <source>Battery</source>
        <translation>Akku</translation>
    </message>
    <message>
        <source>Link</source>
        <translation>Verbindung</translation>
    </message>
    <message>
        <source>Last frame</source>
        <translation>Letzter Frame</translation>
    </message>
    <message>
        <source>Lock</source>
        <translation>Schloss</translation>
    </message>
    <message>
        <source>Alerts</source>
        <translation>Meldungen</translation>
    </message>
</context>
<context>
    <name>skyseal::ui::VehicleListRow</name>
    <message>
        <source>Vehicle %1</source>
        <translation>Fahrzeug %1</translation>
    </message>
    <message>
        <source>Vehicle %1, agent %2</source>
        <translation>Fahrzeug %1, Agent %2</translation>
    </message>
    <message>
        <source>%1 · low</source>
        <translation>%1 · schwach</translation>
    </message>
    <message>
        <source>%1 V</source>
        <translation>%1 V</translation>
    </message>
    <message>
        <source>lost</source>
        <translation>verloren</translation>
    </message>
    <message>
        <source>%1 · poor</source>
        <translation>%1 · schlecht</translation>
    </message>
    <message>
        <source>Share of the frames that arrived within the last second</source>
        <translation>Anteil der Frames, die in der letzten Sekunde angekommen sind</translation>
    </message>
    <message>
        <source>&lt; 1 s</source>
        <translation>&lt; 1 s</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>Since the newest frame</source>
        <translation>Seit dem neuesten Frame</translation>
    </message>
    <message>
        <source>Sealed · %1</source>
        <translation>Versiegelt · %1</translation>
    </message>
    <message>
        <source>Under attack · %1</source>
        <translation>Unter Angriff · %1</translation>
    </message>
    <message>
        <source>No alerts</source>
        <translation>Keine Meldungen</translation>
    </message>
    <message>
        <source>severe</source>
        <translation>Alarm</translation>
    </message>
    <message>
        <source>warning</source>
        <translation>Warnung</translation>
    </message>
    <message>
        <source>notice</source>
        <translation>Hinweis</translation>
    </message>
    <message>
        <source>Armed</source>
        <translation>Scharf</translation>
    </message>
    <message>
        <source>Disarmed</source>
        <translation>Unscharf</translation>
    </message>
    <message>
        <source>No frames received</source>
        <translation>Keine Frames empfangen</translation>
    </message>
</context>
<context>
    <name>skyseal::ui::VehicleMarker</name>
    <message>
        <source>Vehicle %1 · %2 s ago</source>
        <translation>Fahrzeug %1 · vor %2 s</translation>
    </message>
    <message>
        <source>Vehicle %1 · not sealed</source>
        <translation>Fahrzeug %1 · nicht versiegelt</translation>
    </message>
    <message>
        <source>Vehicle %1 · sealed</source>
        <translation>Fahrzeug %1 · versiegelt</translation>
    </message>
    <message>
        <source>Vehicle %1</source>
        <translation>Fahrzeug %1</translation>
    </message>
</context>
<context>
    <name>skyseal::ui::VehicleName</name>
    <message>
        <source>%1, vehicle %2</source>
        <translation>%1, Fahrzeug %2</translation>
    </message>
</context>
<context>
    <name>skyseal::ui::VehiclesPanel</name>
    <message>
        <source>Vehicles</source>
        <translation>Fahrzeuge</translation>
    </message>
    <message>
        <source>Disarmed</source>
        <translation>Unscharf</translation>
    </message>
    <message>
        <source>%1 · low</source>
        <translation>%1 · schwach</translation>
    </message>
    <message>
        <source>%1 · poor</source>
        <translation>%1 · schlecht</translation>
    </message>
    <message>
        <source>Last frame</source>
        <translation>Letzter Frame</translation>
    </message>
    <message>
        <source>Number or words, such as &quot;rover armed&quot;</source>
        <translation>Nummer oder Wörter, etwa „rover scharf“</translation>
    </message>
    <message>
        <source>Vehicles shown</source>
        <translation>Angezeigte Fahrzeuge</translation>
    </message>
    <message>
        <source>Connect…</source>
        <translation>Verbinden…</translation>
    </message>
    <message>
        <source>Add a link</source>
        <translation>Verbindung hinzufügen</translation>
    </message>
    <message>
        <source>%1 of %2 · order kept under the pointer</source>
        <translation>%1 von %2 · Reihenfolge unter dem Mauszeiger fest</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>No vehicle. A vehicle appears here as soon as it is heard.</source>
        <translation>Kein Fahrzeug. Ein Fahrzeug erscheint hier, sobald es empfangen wird.</translation>
    </message>
    <message>
        <source>No vehicle matches &quot;%1&quot;.</source>
        <translation>Kein Fahrzeug passt zu „%1“.</translation>
    </message>
    <message>
        <source>Filter vehicles</source>
        <translation>Fahrzeuge filtern</translation>
    </message>
    <message>
        <source>Find a vehicle</source>
        <translation>Ein Fahrzeug suchen</translation>
    </message>
    <message>
        <source>Remove from the list</source>
        <translation>Aus der Liste entfernen</translation>
    </message>
    <message>
        <source>Remove the lost vehicle from the list</source>
        <translation>Das verlorene Fahrzeug aus der Liste entfernen</translation>
    </message>
    <message>
        <source>A replay is shown</source>
        <translation>Eine Wiedergabe wird gezeigt</translation>
    </message>
    <message>
        <source>It appears again as soon as it is heard</source>
        <translation>Es erscheint wieder, sobald es gehört wird</translation>
    </message>
    <message>
        <source>Select a vehicle whose link is lost</source>
        <translation>Wählen Sie ein Fahrzeug aus, dessen Verbindung verloren ist</translation>
    </message>
</context>
<context>
    <name>skyseal::ui::WindowDialogs</name>
    <message>
        <source>About Skyseal</source>
        <translation>Über Skyseal</translation>
    </message>
    <message>
        <source>Skyseal %1

A ground control station whose MAVLink link is sealed.
GPL-3.0-or-later; built with Qt %2, Qt Charts, libsodium and OpenSSL.</source>
        <translation>Skyseal %1

Eine Bodenstation, deren MAVLink-Verbindung versiegelt ist.
GPL-3.0-or-later; erstellt mit Qt %2, Qt Charts, libsodium und OpenSSL.</translation>
    </message>
</context>
<context>
    <name>skyseal::ui::WindowDocks</name>
    <message>
        <source>Flight</source>
        <translation>Flug</translation>
    </message>
    <message>
        <source>Secure link</source>
        <translation>Sichere Verbindung</translation>
    </message>
    <message>
        <source>Diagnostics</source>
        <translation>Diagnose</translation>
    </message>
    <message>
        <source>Messages</source>
        <translation>Nachrichten</translation>
    </message>
    <message>
        <source>Inspector</source>
        <translation>Inspektor</translation>
    </message>
    <message>
        <source>Parameters</source>
        <translation>Parameter</translation>
    </message>
    <message>
        <source>Mission</source>
        <translation>Mission</translation>
    </message>
    <message>
        <source>Logs</source>
        <translation>Logs</translation>
    </message>
    <message>
        <source>Links</source>
        <translation>Verbindungen</translation>
    </message>
    <message>
        <source>Altitude profile</source>
        <translation>Höhenprofil</translation>
    </message>
    <message>
        <source>Vehicles</source>
        <translation>Fahrzeuge</translation>
    </message>
    <message>
        <source>Close the panel that has the focus</source>
        <translation>Den Bereich schließen, der den Fokus hat</translation>
    </message>
    <message>
        <source>Float or dock the panel that has the focus</source>
        <translation>Den Bereich lösen oder andocken, der den Fokus hat</translation>
    </message>
    <message>
        <source>Panels</source>
        <translation>Bereiche</translation>
    </message>
    <message>
        <source>No panel has the focus</source>
        <translation>Kein Bereich hat den Fokus</translation>
    </message>
</context>
<context>
    <name>skyseal::ui::WindowMenus</name>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Datei</translation>
    </message>
    <message>
        <source>&amp;Settings…</source>
        <translation>&amp;Einstellungen…</translation>
    </message>
    <message>
        <source>&amp;Replay a log…</source>
        <translation>&amp;Log wiedergeben…</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Beenden</translation>
    </message>
    <message>
        <source>&amp;Link</source>
        <translation>&amp;Verbindung</translation>
    </message>
    <message>
        <source>&amp;Connect…</source>
        <translation>&amp;Verbinden…</translation>
    </message>
    <message>
        <source>Change the mode to %1?</source>
        <translation>In den Modus %1 wechseln?</translation>
    </message>
    <message>
        <source>Vehicle %1</source>
        <translation>Fahrzeug %1</translation>
    </message>
    <message>
        <source>&amp;Vehicle</source>
        <translation>&amp;Fahrzeug</translation>
    </message>
    <message>
        <source>&amp;Arm…</source>
        <translation>&amp;Scharfschalten…</translation>
    </message>
    <message>
        <source>Arm the motors? The propellers will turn.</source>
        <translation>Die Motoren scharfschalten? Die Propeller drehen sich dann.</translation>
    </message>
    <message>
        <source>&amp;Disarm…</source>
        <translation>&amp;Entschärfen…</translation>
    </message>
    <message>
        <source>Disarm the motors?</source>
        <translation>Die Motoren entschärfen?</translation>
    </message>
    <message>
        <source>&amp;Take off…</source>
        <translation>A&amp;bheben…</translation>
    </message>
    <message>
        <source>&amp;Land…</source>
        <translation>&amp;Landen…</translation>
    </message>
    <message>
        <source>Land here?</source>
        <translation>Hier landen?</translation>
    </message>
    <message>
        <source>&amp;Return to launch (RTL)…</source>
        <translation>&amp;Rückkehr zum Startpunkt (RTL)…</translation>
    </message>
    <message>
        <source>Return to launch and land there?</source>
        <translation>Zum Startpunkt zurückkehren und dort landen?</translation>
    </message>
    <message>
        <source>Fly the mission?</source>
        <translation>Die Mission fliegen?</translation>
    </message>
    <message>
        <source>&amp;Mode</source>
        <translation>Mo&amp;dus</translation>
    </message>
    <message>
        <source>S&amp;how</source>
        <translation>&amp;Anzeigen</translation>
    </message>
    <message>
        <source>No vehicle</source>
        <translation>Kein Fahrzeug</translation>
    </message>
    <message>
        <source>Vehicle %1 at %2…</source>
        <translation>Fahrzeug %1 unter %2…</translation>
    </message>
    <message>
        <source>Cipher suite</source>
        <translation>Chiffre</translation>
    </message>
    <message>
        <source>Allow &amp;plain MAVLink</source>
        <translation>&amp;Ungeschütztes MAVLink zulassen</translation>
    </message>
    <message>
        <source>No vehicle is waiting for approval</source>
        <translation>Kein Fahrzeug wartet auf Freigabe</translation>
    </message>
    <message>
        <source>&amp;Keys and peers…</source>
        <translation>&amp;Schlüssel und Gegenstellen…</translation>
    </message>
    <message>
        <source>&amp;Security</source>
        <translation>&amp;Sicherheit</translation>
    </message>
    <message>
        <source>&amp;Follow the vehicle</source>
        <translation>Dem &amp;Fahrzeug folgen</translation>
    </message>
    <message>
        <source>Zoom &amp;in</source>
        <translation>Ver&amp;größern</translation>
    </message>
    <message>
        <source>Zoom &amp;out</source>
        <translation>Verk&amp;leinern</translation>
    </message>
    <message>
        <source>&amp;Clear the track</source>
        <translation>&amp;Spur löschen</translation>
    </message>
    <message>
        <source>&amp;Reset the layout</source>
        <translation>Anordnung &amp;zurücksetzen</translation>
    </message>
    <message>
        <source>F&amp;ull screen</source>
        <translation>Voll&amp;bild</translation>
    </message>
    <message>
        <source>V&amp;iew</source>
        <translation>&amp;Ansicht</translation>
    </message>
    <message>
        <source>Run a s&amp;weep…</source>
        <translation>&amp;Messreihe starten…</translation>
    </message>
    <message>
        <source>Start the &amp;demo</source>
        <translation>&amp;Demo starten</translation>
    </message>
    <message>
        <source>&amp;Tools</source>
        <translation>E&amp;xtras</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>&amp;Hilfe</translation>
    </message>
    <message>
        <source>&amp;First steps</source>
        <translation>&amp;Erste Schritte</translation>
    </message>
    <message>
        <source>&amp;Sealing a link</source>
        <translation>Eine Verbindung &amp;versiegeln</translation>
    </message>
    <message>
        <source>&amp;Diagnostics</source>
        <translation>&amp;Diagnose</translation>
    </message>
    <message>
        <source>&amp;About Skyseal</source>
        <translation>Ü&amp;ber Skyseal</translation>
    </message>
    <message>
        <source>&amp;End the demo</source>
        <translation>Demo b&amp;eenden</translation>
    </message>
    <message>
        <source>&amp;Map source…</source>
        <translation>&amp;Kartenquelle…</translation>
    </message>
    <message>
        <source>Fetch the &amp;area in view…</source>
        <translation>Sichtbaren &amp;Ausschnitt laden…</translation>
    </message>
    <message>
        <source>The &amp;map</source>
        <translation>Die &amp;Karte</translation>
    </message>
    <message>
        <source>&amp;Change altitude…</source>
        <translation>&amp;Höhe ändern…</translation>
    </message>
    <message>
        <source>&amp;Find a command…</source>
        <translation>&amp;Befehl suchen…</translation>
    </message>
    <message>
        <source>&amp;Edit values…</source>
        <translation>&amp;Werte bearbeiten…</translation>
    </message>
    <message>
        <source>&amp;Values</source>
        <translation>&amp;Werte</translation>
    </message>
    <message>
        <source>O&amp;verlays…</source>
        <translation>&amp;Overlays…</translation>
    </message>
    <message>
        <source>&amp;Keyboard shortcuts…</source>
        <translation>&amp;Tastenkürzel…</translation>
    </message>
    <message>
        <source>&amp;Start mission…</source>
        <translation>&amp;Mission starten…</translation>
    </message>
    <message>
        <source>The demo is running</source>
        <translation>Die Demo läuft</translation>
    </message>
    <message>
        <source>No demo is running</source>
        <translation>Keine Demo läuft</translation>
    </message>
    <message>
        <source>&amp;Fly workspace</source>
        <translation>Arbeitsbereich &amp;Fliegen</translation>
    </message>
    <message>
        <source>&amp;Plan workspace</source>
        <translation>Arbeitsbereich &amp;Planen</translation>
    </message>
    <message>
        <source>Ve&amp;hicle workspace</source>
        <translation>Arbeitsbereich Fahr&amp;zeug</translation>
    </message>
    <message>
        <source>&amp;Lab workspace</source>
        <translation>Arbeitsbereich &amp;Labor</translation>
    </message>
    <message>
        <source>&amp;Cipher suite</source>
        <translation>&amp;Chiffre</translation>
    </message>
    <message>
        <source>Link &amp;quality</source>
        <translation>&amp;Empfangsqualität</translation>
    </message>
    <message>
        <source>&amp;Altitude</source>
        <translation>&amp;Höhe</translation>
    </message>
    <message>
        <source>&amp;Speed</source>
        <translation>&amp;Geschwindigkeit</translation>
    </message>
    <message>
        <source>&amp;Track colours</source>
        <translation>Farben der S&amp;pur</translation>
    </message>
    <message>
        <source>&amp;Pause…</source>
        <translation>&amp;Pause…</translation>
    </message>
    <message>
        <source>Stop and hold the present position?</source>
        <translation>Anhalten und an der aktuellen Position bleiben?</translation>
    </message>
    <message>
        <source>Arm the motors? In its present mode the vehicle takes off at once.</source>
        <translation>Motoren scharfschalten? Im jetzigen Modus hebt das Fahrzeug sofort ab.</translation>
    </message>
    <message>
        <source>Arm the motors and fly the mission? The propellers will turn.</source>
        <translation>Motoren scharfschalten und die Mission fliegen? Die Propeller drehen sich.</translation>
    </message>
</context>
<context>
    <name>skyseal::ui::WorkspaceTabs</name>
    <message>
        <source>Workspaces</source>
        <translation>Arbeitsbereiche</translation>
    </message>
    <message>
        <source>Workspace %1</source>
        <translation>Arbeitsbereich %1</translation>
    </message>
    <message>
        <source>Workspace %1 (%2)</source>
        <translation>Arbeitsbereich %1 (%2)</translation>
    </message>
</context>
<context>
    <name>skyseal::ui::Workspaces</name>
    <message>
        <source>Fly</source>
        <translation>Fliegen</translation>
    </message>
    <message>
        <source>Plan</source>
        <translation>Planen</translation>
    </message>
    <message>
        <source>Vehicle</source>
        <translation>Fahrzeug</translation>
    </message>
    <message>
        <source>Lab</source>
        <translation>Labor</translation>
    </message>
</context>
</TS>
