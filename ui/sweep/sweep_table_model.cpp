#include "ui/sweep/sweep_table_model.h"

#include "core/experiment/analysis.h"
#include "core/experiment/sweep_text.h"
#include "ui/sweep/sweep_labels.h"
#include "ui/text/vehicle_text.h"
#include "ui/theme/suite_style.h"

#include <algorithm>

namespace skyseal::ui {

using experiment::Metric;

void SweepTableModel::show(std::shared_ptr<const experiment::Results> results, std::size_t condition, std::size_t load,
                           Shown shown)
{
    beginResetModel();
    m_results = std::move(results);
    m_condition = condition;
    m_load = load;
    m_shown = shown;
    m_metrics.clear();
    m_ratios.clear();
    if (m_results && m_shown == Shown::Ratios)
        findRatios();
    if (m_results && m_shown == Shown::Means) {
        for (const experiment::MetricInfo &info : experiment::metrics()) {
            if (experiment::wasMeasured(*m_results, info.metric))
                m_metrics.push_back(info.metric);
        }
    }
    endResetModel();
}

/// Shares are compared by differences, and are no ratios.
void SweepTableModel::findRatios()
{
    for (const Metric metric : experiment::metricsShownIn(experiment::kDifferences)) {
        const experiment::MetricInfo &info = experiment::info(metric);
        if (info.isShare() || info.canBeNegative || !experiment::wasMeasured(*m_results, metric)
            || !experiment::isCompared(metric, m_results->plan.loads[m_load]))
            continue;
        m_metrics.push_back(metric);
        for (const experiment::Contrast &one : experiment::plannedContrasts(*m_results, m_condition, m_load, metric)) {
            if (one.first == experiment::referenceArm(m_results->plan))
                m_ratios.push_back(one);
        }
    }
}

const experiment::Contrast *SweepTableModel::ratio(std::size_t arm, Metric metric) const
{
    const auto found = std::ranges::find_if(
        m_ratios, [&](const experiment::Contrast &one) { return one.second == arm && one.metric == metric; });
    return found == m_ratios.end() ? nullptr : &*found;
}

int SweepTableModel::rowCount(const QModelIndex &parent) const
{
    return parent.isValid() || !m_results ? 0 : static_cast<int>(m_results->plan.arms.size());
}

int SweepTableModel::columnCount(const QModelIndex &parent) const
{
    return parent.isValid() ? 0 : FixedColumns + static_cast<int>(m_metrics.size());
}

QVariant SweepTableModel::data(const QModelIndex &index, int role) const
{
    if (!index.isValid() || !m_results)
        return {};
    const auto row = static_cast<std::size_t>(index.row());
    const experiment::SweepArm &arm = m_results->plan.arms[row];
    if (index.column() == SuiteColumn) {
        if (role == Qt::DisplayRole)
            return arm.again ? tr("%1 (A/A)").arg(suiteName(arm.suite)) : suiteName(arm.suite);
        return role == Qt::DecorationRole ? QVariant(suiteDot(arm.suite)) : QVariant();
    }
    if (index.column() == FramingColumn)
        return role == Qt::DisplayRole ? QVariant(framingText(arm)) : QVariant();
    const Metric metric = m_metrics[static_cast<std::size_t>(index.column() - FixedColumns)];
    if (role == Qt::TextAlignmentRole)
        return QVariant((experiment::exists(arm) ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
    return m_shown == Shown::Ratios && experiment::exists(arm) ? ratioData(row, metric, role) : meanData(row, metric, role);
}

QVariant SweepTableModel::ratioData(std::size_t arm, Metric metric, int role) const
{
    const bool isReference = arm == experiment::referenceArm(m_results->plan);
    const experiment::Contrast *found = ratio(arm, metric);
    if (role == ValueRole)
        return found ? QVariant(found->value()) : isReference ? QVariant(1.0) : QVariant();
    if (role == Qt::DisplayRole)
        return found      ? QVariant(ratioText(*found))
            : isReference ? QVariant(QStringLiteral("1"))
                          : QVariant(QStringLiteral("–"));
    return role == Qt::ToolTipRole ? meanData(arm, metric, Qt::DisplayRole) : QVariant();
}

QVariant SweepTableModel::meanData(std::size_t arm, Metric metric, int role) const
{
    const experiment::Cell cell{m_condition, m_load, arm};
    if (role == Qt::DisplayRole)
        return experiment::exists(m_results->plan.arms[arm]) ? localNumber(experiment::meanText(*m_results, cell, metric))
                                                             : notInFramingText();
    if (role != ValueRole && role != Qt::ToolTipRole)
        return {};
    const experiment::Summary summary = experiment::summaryOf(*m_results, cell, metric);
    if (summary.count == 0)
        return {};
    if (role == ValueRole)
        return summary.mean;
    return tr("from %1 to %2 in %3 runs")
        .arg(localNumber(experiment::readable(summary.min)), localNumber(experiment::readable(summary.max)))
        .arg(summary.count);
}

QVariant SweepTableModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal || section >= columnCount())
        return {};
    if (section < FixedColumns)
        return role == Qt::DisplayRole ? QVariant(section == SuiteColumn ? tr("Suite") : tr("Framing")) : QVariant();
    const Metric metric = m_metrics[static_cast<std::size_t>(section - FixedColumns)];
    if (role == Qt::DisplayRole)
        return m_shown == Shown::Ratios ? metricTitle(metric) : metricText(metric);
    return role == Qt::ToolTipRole ? QVariant(metricDescription(metric)) : QVariant();
}

} // namespace skyseal::ui

#include "moc_sweep_table_model.cpp"
