// Sweeps without a link: records the orders; a test emits the events.
#pragma once

#include "ui/sweep/sweep_interface.h"

namespace skyseal::ui {

class FakeSweep : public SweepInterface
{
    Q_OBJECT

public:
    using SweepInterface::SweepInterface;

    QString ownProgramsDisabledReason() const override { return {}; }
    void start(const SweepOrder &order) override { orders.push_back(order); }
    void cancel() override { finish(); }
    void save(const experiment::Results &, const QString &) override {}

    /// The first run of `suite` begins.
    void begin(crypto::SuiteId suite)
    {
        const auto &arms = orders.back().plan.arms;
        experiment::Run run;
        while (run.arm < arms.size() && arms[run.arm].suite != suite)
            ++run.arm;
        Q_EMIT runBegan(run, {});
    }
    void finish(std::vector<experiment::Sample> samples = {})
    {
        auto results = std::make_shared<experiment::Results>();
        results->samples = std::move(samples);
        results->plan = orders.back().plan;
        Q_EMIT finished(std::move(results), {});
    }

    std::vector<SweepOrder> orders;
};

} // namespace skyseal::ui
