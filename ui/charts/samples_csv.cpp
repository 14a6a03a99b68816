#include "ui/charts/samples_csv.h"

#include <cmath>

namespace skyseal::ui {

using engine::MetricsSample;

namespace {

struct Column
{
    const char *name;
    double MetricsSample::*value;
};

// The unit stands in the name.
constexpr Column kColumns[] = {
    {"time_s", &MetricsSample::time},
    {"frames_per_s", &MetricsSample::openedFramesPerSecond},
    {"opened_bytes_per_s", &MetricsSample::openedBytesPerSecond},
    {"rx_bytes_per_s", &MetricsSample::rxBytesPerSecond},
    {"tx_bytes_per_s", &MetricsSample::txBytesPerSecond},
    {"channel_loss_to_us_percent", &MetricsSample::lossPercent},
    {"channel_loss_to_it_percent", &MetricsSample::peerLossPercent},
    {"mavlink_loss_to_us_percent", &MetricsSample::mavlinkLossPercent},
    {"mavlink_loss_to_it_percent", &MetricsSample::peerMavlinkLossPercent},
    {"latency_s", &MetricsSample::latency},
    {"channel_round_trip_s", &MetricsSample::roundTrip},
    {"overhead_to_us_percent", &MetricsSample::rxOverheadPercent},
    {"overhead_to_it_percent", &MetricsSample::txOverheadPercent},
    {"process_cpu_percent", &MetricsSample::processCpuPercent},
    {"link_thread_cpu_percent", &MetricsSample::ioCpuPercent},
    {"suite_cpu_percent", &MetricsSample::suiteCpuPercent},
    {"open_ns_p50", &MetricsSample::openNsP50},
    {"open_ns_p99", &MetricsSample::openNsP99},
    {"open_next_ns_p50", &MetricsSample::openNextNsP50},
    {"open_next_ns_p99", &MetricsSample::openNextNsP99},
    {"seal_ns_p50", &MetricsSample::sealNsP50},
    {"seal_ns_p99", &MetricsSample::sealNsP99},
    {"session_bytes", &MetricsSample::sessionBytes},
    {"processor_watts", &MetricsSample::powerWatts},
};

} // namespace

QByteArray samplesCsv(const std::deque<MetricsSample> &samples, double from, double to)
{
    QByteArray out = "number,suite,insecure,epoch,link_up";
    for (const Column &column : kColumns)
        out += QByteArray(",") + column.name;
    out += ",resident_bytes,refused_so_far\r\n";
    for (const MetricsSample &sample : samples) {
        if (sample.time < from || sample.time > to)
            continue;
        const auto &suite = crypto::suiteInfo(sample.suite);
        out += QByteArray::number(static_cast<qulonglong>(sample.number)) + ',';
        out += QByteArray(suite.name.data(), static_cast<qsizetype>(suite.name.size()));
        out += suite.research || sample.suite == crypto::SuiteId::None ? ",1," : ",0,";
        out += QByteArray::number(sample.epoch) + (sample.linkUp ? ",1" : ",0");
        for (const Column &column : kColumns) {
            const double value = sample.*column.value;
            out += ',';
            if (std::isfinite(value))
                out += QByteArray::number(value, 'g', 12);
        }
        out += ',' + QByteArray::number(static_cast<qulonglong>(sample.residentBytes)) + ','
            + QByteArray::number(static_cast<qulonglong>(sample.refused)) + "\r\n";
    }
    return out;
}

} // namespace skyseal::ui
