// The means of a sweep as a table: a row per suite and framing, a column per metric.
#pragma once

#include "core/experiment/results.h"

#include <QtCore/QAbstractTableModel>

#include <memory>

namespace skyseal::ui {

class SweepTableModel : public QAbstractTableModel
{
    Q_OBJECT

public:
    enum Column { SuiteColumn, FramingColumn, FixedColumns };
    /// The mean as a number; invalid if there is none.
    static constexpr int MeanRole = Qt::UserRole;

    using QAbstractTableModel::QAbstractTableModel;

    void show(std::shared_ptr<const experiment::Results> results, std::size_t condition, std::size_t load);
    const std::vector<experiment::Metric> &metrics() const { return m_metrics; }

    int rowCount(const QModelIndex &parent = {}) const override;
    int columnCount(const QModelIndex &parent = {}) const override;
    QVariant data(const QModelIndex &index, int role = Qt::DisplayRole) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role = Qt::DisplayRole) const override;

private:
    std::shared_ptr<const experiment::Results> m_results;
    std::size_t m_condition = 0, m_load = 0;
    std::vector<experiment::Metric> m_metrics;
};

} // namespace skyseal::ui
