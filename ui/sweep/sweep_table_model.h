// The results of a sweep as a table: a row per suite and framing, a column per metric. Ratios to plain MAVLink with their 95 %
// intervals, or means.
#pragma once

#include "core/experiment/contrast.h"

#include <QtCore/QAbstractTableModel>

#include <memory>

namespace skyseal::ui {

class SweepTableModel : public QAbstractTableModel
{
    Q_OBJECT

public:
    enum Column { SuiteColumn, FramingColumn, FixedColumns };
    enum class Shown { Ratios, Means };
    /// The ratio or the mean as a number; invalid if there is none.
    static constexpr int ValueRole = Qt::UserRole;

    using QAbstractTableModel::QAbstractTableModel;

    void show(std::shared_ptr<const experiment::Results> results, std::size_t condition, std::size_t load, Shown shown);
    const std::vector<experiment::Metric> &metrics() const { return m_metrics; }

    int rowCount(const QModelIndex &parent = {}) const override;
    int columnCount(const QModelIndex &parent = {}) const override;
    QVariant data(const QModelIndex &index, int role = Qt::DisplayRole) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role = Qt::DisplayRole) const override;

private:
    void findRatios();
    const experiment::Contrast *ratio(std::size_t arm, experiment::Metric metric) const;
    QVariant ratioData(std::size_t arm, experiment::Metric metric, int role) const;
    QVariant meanData(std::size_t arm, experiment::Metric metric, int role) const;

    std::shared_ptr<const experiment::Results> m_results;
    std::size_t m_condition = 0, m_load = 0;
    Shown m_shown = Shown::Means;
    std::vector<experiment::Metric> m_metrics;
    std::vector<experiment::Contrast> m_ratios; ///< of arms to the reference
};

} // namespace skyseal::ui
