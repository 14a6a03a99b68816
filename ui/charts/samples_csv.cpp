#include "ui/charts/samples_csv.h"

#include "ui/charts/quantities.h"

#include <cmath>

namespace skyseal::ui {

using engine::MetricsSample;

namespace {

std::vector<SampleValue> columns()
{
    std::vector<SampleValue> out;
    for (const Quantity &quantity : allQuantities()) {
        for (const QuantityLine &line : quantity.lines)
            out.push_back(line.value);
        out.insert(out.end(), quantity.csvOnly.begin(), quantity.csvOnly.end());
    }
    return out;
}

QByteArray numberText(double value)
{
    return std::isfinite(value) ? QByteArray::number(value, 'g', 12) : QByteArray();
}

} // namespace

QByteArray samplesCsv(const std::deque<MetricsSample> &samples, double from, double to)
{
    const std::vector<SampleValue> values = columns();
    QByteArray out = "number,time_s,suite,insecure,epoch,link_up";
    for (const SampleValue &value : values)
        out += QByteArray(",") + value.column;
    out += ",refused_so_far\r\n";
    for (const MetricsSample &sample : samples) {
        if (sample.time < from || sample.time > to)
            continue;
        const auto &suite = crypto::suiteInfo(sample.suite);
        out += QByteArray::number(static_cast<qulonglong>(sample.number)) + ',' + numberText(sample.time) + ',';
        out += QByteArray(suite.name.data(), static_cast<qsizetype>(suite.name.size()));
        out += suite.research || sample.suite == crypto::SuiteId::None ? ",1," : ",0,";
        out += QByteArray::number(sample.epoch) + (sample.linkUp ? ",1" : ",0");
        for (const SampleValue &value : values)
            out += ',' + numberText(value.read(sample));
        out += ',' + QByteArray::number(static_cast<qulonglong>(sample.refused)) + "\r\n";
    }
    return out;
}

} // namespace skyseal::ui
