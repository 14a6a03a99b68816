#include "ui/charts/quantities.h"

#include <QtCore/QCoreApplication>

namespace skyseal::ui {

using engine::MetricsSample;

namespace {

/// The translations' context of the free functions below.
struct Text
{
    Q_DECLARE_TR_FUNCTIONS(skyseal::ui::Quantities)
};

/// Only while a vehicle is heard: nothing was measured otherwise.
template<double MetricsSample::*member> double whileUp(const MetricsSample &s)
{
    return s.linkUp ? s.*member : vehicle::kUnknown;
}

template<double MetricsSample::*member> double kilo(const MetricsSample &s)
{
    return s.linkUp ? s.*member / 1000 : vehicle::kUnknown;
}

/// Nanoseconds as microseconds; 0 means that there was no record.
template<double MetricsSample::*member> double micro(const MetricsSample &s)
{
    return s.linkUp && s.*member > 0 ? s.*member / 1000 : vehicle::kUnknown;
}

template<double MetricsSample::*member> double milli(const MetricsSample &s)
{
    return s.linkUp ? s.*member * 1000 : vehicle::kUnknown;
}

double megabytes(const MetricsSample &s)
{
    return s.residentBytes > 0 ? static_cast<double>(s.residentBytes) / 1e6 : vehicle::kUnknown;
}

double watts(const MetricsSample &s)
{
    return s.powerWatts;
}

double processCpu(const MetricsSample &s)
{
    return s.processCpuPercent;
}

double ioCpu(const MetricsSample &s)
{
    return s.ioCpuPercent;
}

std::vector<Quantity> rates()
{
    return {
        {"frameRate",
         Text::tr("Decryption rate"),
         Text::tr("frames/s"),
         Text::tr("MAVLink frames that were opened and believed, over the last second."),
         1,
         10,
         {{{}, Stroke::Solid, whileUp<&MetricsSample::openedFramesPerSecond>}},
         true},
        {"byteRate",
         Text::tr("Bytes"),
         Text::tr("kB/s"),
         Text::tr("Bytes of the frames that were opened, and of the datagrams that came (without UDP and IP headers)."),
         2,
         1,
         {{Text::tr("opened"), Stroke::Solid, kilo<&MetricsSample::openedBytesPerSecond>},
          {Text::tr("received"), Stroke::Dashed, kilo<&MetricsSample::rxBytesPerSecond>}},
         true},
        {"overhead",
         Text::tr("Wire overhead"),
         Text::tr("%"),
         Text::tr("Bytes of the channel's datagrams beyond those of the frames in them: headers, tags, handshakes and "
                  "reports. 0 on a plain link."),
         1,
         50,
         {{Text::tr("to us"), Stroke::Solid, whileUp<&MetricsSample::rxOverheadPercent>},
          {Text::tr("to it"), Stroke::Dashed, whileUp<&MetricsSample::txOverheadPercent>}},
         true},
    };
}

std::vector<Quantity> links()
{
    return {
        {"channelLoss",
         Text::tr("Packet loss, channel"),
         Text::tr("%"),
         Text::tr("Records that never arrived, by their counters, over the last second; the other end reports its "
                  "direction once a second. On a plain link: MAVLink's."),
         2,
         1,
         {{Text::tr("to us"), Stroke::Solid, whileUp<&MetricsSample::lossPercent>},
          {Text::tr("to it"), Stroke::Dashed, whileUp<&MetricsSample::peerLossPercent>}},
         true},
        {"mavlinkLoss",
         Text::tr("Packet loss, MAVLink"),
         Text::tr("%"),
         Text::tr("Frames that never arrived, by their sequence numbers for each sender, over the last second; those to the "
                  "vehicle as its agent counts them and tells once a second. Loss between autopilot and agent counts here and "
                  "not in the channel."),
         2,
         1,
         {{Text::tr("to us"), Stroke::Solid, whileUp<&MetricsSample::mavlinkLossPercent>},
          {Text::tr("to it"), Stroke::Dashed, whileUp<&MetricsSample::peerMavlinkLossPercent>}},
         true},
        {"latency",
         Text::tr("Latency"),
         Text::tr("ms"),
         Text::tr("There and back: to the autopilot by TIMESYNC, smoothed, and to the agent by the channel's reports."),
         2,
         1,
         {{Text::tr("TIMESYNC"), Stroke::Solid, milli<&MetricsSample::latency>},
          {Text::tr("channel"), Stroke::Dashed, milli<&MetricsSample::roundTrip>}},
         true},
    };
}

std::vector<Quantity> costs()
{
    return {
        {"cpu",
         Text::tr("CPU"),
         Text::tr("% of a core"),
         Text::tr("CPU time of the process with its window, of the thread that carries the link, and of the suite in "
                  "seal and open (elapsed time of each call, added up), over the last second."),
         2,
         5,
         {{Text::tr("process"), Stroke::Solid, processCpu},
          {Text::tr("link"), Stroke::Dashed, ioCpu},
          {Text::tr("suite"), Stroke::Dotted, whileUp<&MetricsSample::suiteCpuPercent>}},
         true,
         {},
         2}, // the others hold much that is no suite's
        {"openCost",
         Text::tr("Opening a record"),
         Text::tr("µs"),
         Text::tr("From the datagram to the opened frames: look-up, replay window, tag, decryption. The first record after "
                  "the thread slept finds cold caches and takes several microseconds whatever the suite; “next” are records "
                  "that follow in the same wake-up, which come closer to the suite itself."),
         2,
         1,
         {{Text::tr("p50"), Stroke::Solid, micro<&MetricsSample::openNsP50>},
          {Text::tr("p99"), Stroke::Dashed, micro<&MetricsSample::openNsP99>},
          {Text::tr("next p50"), Stroke::Dotted, micro<&MetricsSample::openNextNsP50>}},
         true},
        {"sealCost",
         Text::tr("Sealing a record"),
         Text::tr("µs"),
         Text::tr("From the frames to the record that is sent, with the cold caches of a thread that slept."),
         2,
         1,
         {{Text::tr("p50"), Stroke::Solid, micro<&MetricsSample::sealNsP50>},
          {Text::tr("p99"), Stroke::Dashed, micro<&MetricsSample::sealNsP99>}},
         true},
        {"memory",
         Text::tr("Memory"),
         Text::tr("MB resident"),
         Text::tr("Of the whole process, as the system counts it. It does not belong to a suite."),
         1,
         50,
         {{{}, Stroke::Solid, megabytes}},
         false},
        {"sessionMemory",
         Text::tr("Memory of a session"),
         Text::tr("kB"),
         Text::tr(
             "Heap that one end's session takes under the suite in use, its keyed ciphers included: measured once for each "
             "suite, with a session of this program's own."),
         2,
         5,
         {{{}, Stroke::Solid, kilo<&MetricsSample::sessionBytes>}},
         true},
    };
}

Quantity power(const std::string &powercap)
{
    metrics::EnergyMeter meter(powercap);
    const bool readable = meter.microjoules().has_value();
    return {
        "power",
        Text::tr("Power of the processor"),
        Text::tr("W"),
        Text::tr("By the kernel's energy counters, over the last second: the whole processor and all that runs on it, not this "
                 "program alone (%1).")
            .arg(QString::fromStdString(meter.describe())),
        1,
        5,
        {{{}, Stroke::Solid, watts}},
        true,
        readable ? QString() : Text::tr("not readable here")};
}

} // namespace

std::vector<Quantity> allQuantities(const std::string &powercap)
{
    std::vector<Quantity> out = rates();
    for (auto &&more : {links(), costs()})
        out.insert(out.end(), more.begin(), more.end());
    out.push_back(power(powercap));
    return out;
}

std::vector<QuantityGroup> quantityGroups()
{
    QuantityGroup all{Text::tr("All"), {}};
    for (const Quantity &quantity : allQuantities())
        all.keys.push_back(quantity.key);
    return {{Text::tr("Overview"), {"frameRate", "channelLoss", "cpu"}},
            {Text::tr("Rates"), {"frameRate", "byteRate", "overhead"}},
            {Text::tr("Link"), {"channelLoss", "mavlinkLoss", "latency"}},
            {Text::tr("Cost"), {"openCost", "sealCost", "cpu", "memory", "sessionMemory", "power"}},
            all};
}

} // namespace skyseal::ui
