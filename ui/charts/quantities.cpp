#include "ui/charts/quantities.h"

#include <QtCore/QCoreApplication>

namespace skyseal::ui {

using engine::MetricsSample;
using Valid = SampleValue::Valid;

namespace {

/// The translation context of the functions below.
struct QuantitiesText
{
    Q_DECLARE_TR_FUNCTIONS(skyseal::ui::Quantities)
};

constexpr double kKilo = 1e-3, kMilli = 1e3, kMicroOfNano = 1e-3, kMega = 1e-6; ///< factors from a unit to a shown one

template<double MetricsSample::*member> double read(const MetricsSample &sample)
{
    return sample.*member;
}

double residentBytes(const MetricsSample &sample)
{
    return sample.residentBytes > 0 ? static_cast<double>(sample.residentBytes) : vehicle::kUnknown;
}

std::vector<Quantity> rates()
{
    return {
        {.key = "frameRate",
         .title = QuantitiesText::tr("Decryption rate"),
         .unit = QuantitiesText::tr("frames/s"),
         .note = QuantitiesText::tr("MAVLink frames that were decrypted and accepted, over the last second."),
         .group = QuantityGroupId::Rates,
         .overview = true,
         .least = 10,
         .lines = {{{}, Stroke::Solid, {"frames_per_s", read<&MetricsSample::openedFramesPerSecond>}}}},
        {.key = "byteRate",
         .title = QuantitiesText::tr("Bytes"),
         .unit = QuantitiesText::tr("kB/s"),
         .note = QuantitiesText::tr(
             "Bytes of the frames that were decrypted, and of the received datagrams (without UDP and IP headers)."),
         .group = QuantityGroupId::Rates,
         .decimals = 2,
         .lines = {{QuantitiesText::tr("decrypted"),
                    Stroke::Solid,
                    {"opened_bytes_per_s", read<&MetricsSample::openedBytesPerSecond>, kKilo}},
                   {QuantitiesText::tr("received"),
                    Stroke::Dashed,
                    {"rx_bytes_per_s", read<&MetricsSample::rxBytesPerSecond>, kKilo}}},
         .csvOnly = {{"tx_bytes_per_s", read<&MetricsSample::txBytesPerSecond>}}},
        {.key = "overhead",
         .title = QuantitiesText::tr("Wire overhead"),
         .unit = QuantitiesText::tr("%"),
         .note = QuantitiesText::tr(
             "Bytes of the channel's datagrams beyond the frames in them: headers, tags, handshakes and reports. "
             "At a few frames a second it is large, because the reports stay the same. 0 on a plain link."),
         .group = QuantityGroupId::Rates,
         .least = 50,
         .lines = {{QuantitiesText::tr("from vehicle"),
                    Stroke::Solid,
                    {"overhead_from_vehicle_percent", read<&MetricsSample::rxOverheadPercent>}},
                   {QuantitiesText::tr("to vehicle"),
                    Stroke::Dashed,
                    {"overhead_to_vehicle_percent", read<&MetricsSample::txOverheadPercent>}}}},
    };
}

std::vector<Quantity> links()
{
    return {
        {.key = "channelLoss",
         .title = QuantitiesText::tr("Packet loss, channel"),
         .unit = QuantitiesText::tr("%"),
         .note = QuantitiesText::tr(
             "Records that were lost, by their counters, over the last second; the agent reports its direction "
             "once a second. On a plain link: the loss of MAVLink frames."),
         .group = QuantityGroupId::Link,
         .overview = true,
         .decimals = 2,
         .lines = {{QuantitiesText::tr("from vehicle"),
                    Stroke::Solid,
                    {"channel_loss_from_vehicle_percent", read<&MetricsSample::lossPercent>}},
                   {QuantitiesText::tr("to vehicle"),
                    Stroke::Dashed,
                    {"channel_loss_to_vehicle_percent", read<&MetricsSample::peerLossPercent>}}}},
        {.key = "mavlinkLoss",
         .title = QuantitiesText::tr("Packet loss, MAVLink"),
         .unit = QuantitiesText::tr("%"),
         .note = QuantitiesText::tr(
             "Frames that were lost, by the sequence numbers of each sender, over the last second; frames to the "
             "vehicle are counted by its agent and reported once a second. Loss between autopilot and agent "
             "counts here and not in the channel."),
         .group = QuantityGroupId::Link,
         .decimals = 2,
         .lines = {{QuantitiesText::tr("from vehicle"),
                    Stroke::Solid,
                    {"mavlink_loss_from_vehicle_percent", read<&MetricsSample::mavlinkLossPercent>}},
                   {QuantitiesText::tr("to vehicle"),
                    Stroke::Dashed,
                    {"mavlink_loss_to_vehicle_percent", read<&MetricsSample::peerMavlinkLossPercent>}}}},
        {.key = "latency",
         .title = QuantitiesText::tr("Latency"),
         .unit = QuantitiesText::tr("ms"),
         .note = QuantitiesText::tr(
             "Round trip: to the autopilot by TIMESYNC, smoothed, and to the agent by the channel's reports."),
         .group = QuantityGroupId::Link,
         .decimals = 2,
         .lines = {{QuantitiesText::tr("TIMESYNC"), Stroke::Solid, {"latency_s", read<&MetricsSample::latency>, kMilli}},
                   {QuantitiesText::tr("channel"),
                    Stroke::Dashed,
                    {"channel_round_trip_s", read<&MetricsSample::roundTrip>, kMilli}}}},
    };
}

std::vector<Quantity> costs()
{
    return {
        {.key = "openCost",
         .title = QuantitiesText::tr("Opening a record"),
         .unit = QuantitiesText::tr("µs"),
         .note = QuantitiesText::tr(
             "From the datagram to the decrypted frames: look-up, replay window, tag, decryption. The first record after "
             "the thread slept finds cold caches and takes several microseconds with any suite; at telemetry rates that "
             "is nearly every record. “next” is for the records that follow in the same wake-up, which show more of the "
             "cipher itself."),
         .group = QuantityGroupId::Cost,
         .decimals = 2,
         .lines = {{QuantitiesText::tr("p50"),
                    Stroke::Solid,
                    {"open_ns_p50", read<&MetricsSample::openNsP50>, kMicroOfNano, Valid::Recorded}},
                   {QuantitiesText::tr("p99"),
                    Stroke::Dashed,
                    {"open_ns_p99", read<&MetricsSample::openNsP99>, kMicroOfNano, Valid::Recorded}},
                   {QuantitiesText::tr("next p50"),
                    Stroke::Dotted,
                    {"open_next_ns_p50", read<&MetricsSample::openNextNsP50>, kMicroOfNano, Valid::Recorded}}},
         .csvOnly = {{"open_next_ns_p99", read<&MetricsSample::openNextNsP99>}}},
        {.key = "sealCost",
         .title = QuantitiesText::tr("Sealing a record"),
         .unit = QuantitiesText::tr("µs"),
         .note = QuantitiesText::tr(
             "From the frames to the record that is sent, with the cold caches of a thread that was asleep."),
         .group = QuantityGroupId::Cost,
         .decimals = 2,
         .lines = {{QuantitiesText::tr("p50"),
                    Stroke::Solid,
                    {"seal_ns_p50", read<&MetricsSample::sealNsP50>, kMicroOfNano, Valid::Recorded}},
                   {QuantitiesText::tr("p99"),
                    Stroke::Dashed,
                    {"seal_ns_p99", read<&MetricsSample::sealNsP99>, kMicroOfNano, Valid::Recorded}}}},
        {.key = "cpu",
         .title = QuantitiesText::tr("CPU"),
         .unit = QuantitiesText::tr("% of a core"),
         .note = QuantitiesText::tr(
             "CPU time over the last second: of the process with its window, of the link thread, and of the "
             "suite in seal and open (sum of the elapsed times of the calls). The cost of watching (the "
             "snapshots for this window, and these measurements) is part of “link” and stated below the charts; "
             "drawing the charts is part of “process” only."),
         .group = QuantityGroupId::Cost,
         .overview = true,
         .decimals = 2,
         .least = 5,
         .lines = {{QuantitiesText::tr("process"),
                    Stroke::Solid,
                    {"process_cpu_percent", read<&MetricsSample::processCpuPercent>, 1, Valid::Always}},
                   {QuantitiesText::tr("link"),
                    Stroke::Dashed,
                    {"link_thread_cpu_percent", read<&MetricsSample::ioCpuPercent>, 1, Valid::Always}},
                   {QuantitiesText::tr("suite"), Stroke::Dotted, {"suite_cpu_percent", read<&MetricsSample::suiteCpuPercent>}}},
         .barLine = 2, // the other lines contain much that does not depend on the suite
         .csvOnly = {{"watching_cpu_percent", read<&MetricsSample::watchingCpuPercent>}}},
        {.key = "memory",
         .title = QuantitiesText::tr("Memory"),
         .unit = QuantitiesText::tr("MB resident"),
         .note = QuantitiesText::tr("Resident memory of the whole process. It does not depend on the suite."),
         .group = QuantityGroupId::Cost,
         .least = 50,
         .lines = {{{}, Stroke::Solid, {"resident_bytes", residentBytes, kMega, Valid::Always}}},
         .perSuite = false},
        {.key = "sessionMemory",
         .title = QuantitiesText::tr("Memory of a session"),
         .unit = QuantitiesText::tr("kB"),
         .note = QuantitiesText::tr(
             "Heap of one end's session under the suite in use, with its keyed ciphers. Measured once for each "
             "suite, with a session inside this program."),
         .group = QuantityGroupId::Cost,
         .decimals = 2,
         .least = 5,
         .lines = {{{}, Stroke::Solid, {"session_bytes", read<&MetricsSample::sessionBytes>, kKilo}}}},
    };
}

Quantity power(const std::string &sysfs)
{
    metrics::EnergyMeter meter(sysfs);
    const bool readable = meter.microjoules({}).has_value();
    return {
        .key = "power",
        .title = QuantitiesText::tr("Power of the machine"),
        .unit = QuantitiesText::tr("W"),
        .note = QuantitiesText::tr("From the kernel's energy counters or the power supply's sensor, over the last second: the "
                                   "whole machine, not this program alone (%1).")
                    .arg(QString::fromStdString(meter.describe())),
        .group = QuantityGroupId::Cost,
        .least = 5,
        .lines = {{{}, Stroke::Solid, {"processor_watts", read<&MetricsSample::powerWatts>, 1, Valid::Always}}},
        .remark = readable ? QString() : QuantitiesText::tr("not readable here")};
}

} // namespace

double SampleValue::operator()(const MetricsSample &sample) const
{
    const double raw = read(sample);
    if ((valid != Valid::Always && !sample.linkUp) || (valid == Valid::Recorded && raw <= 0))
        return vehicle::kUnknown;
    return raw * scale;
}

std::vector<Quantity> allQuantities(const std::string &sysfs)
{
    std::vector<Quantity> out = rates();
    for (auto &&more : {links(), costs()})
        out.insert(out.end(), more.begin(), more.end());
    out.push_back(power(sysfs));
    return out;
}

std::vector<QuantityGroup> quantityGroups()
{
    QuantityGroup overview{QuantitiesText::tr("Overview"), {}}, all{QuantitiesText::tr("All"), {}};
    std::vector<QuantityGroup> groups{
        {QuantitiesText::tr("Rates"), {}}, {QuantitiesText::tr("Link"), {}}, {QuantitiesText::tr("Cost"), {}}};
    for (const Quantity &quantity : allQuantities()) {
        groups[static_cast<std::size_t>(quantity.group)].keys.push_back(quantity.key);
        all.keys.push_back(quantity.key);
        if (quantity.overview)
            overview.keys.push_back(quantity.key);
    }
    groups.insert(groups.begin(), std::move(overview));
    groups.push_back(std::move(all));
    return groups;
}

QString quantitiesHelp()
{
    QString out;
    for (const Quantity &quantity : allQuantities())
        out += QStringLiteral("- **%1** (%2): %3\n").arg(quantity.title, quantity.unit, quantity.note);
    return out;
}

} // namespace skyseal::ui
