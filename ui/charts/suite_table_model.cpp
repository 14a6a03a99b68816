#include "ui/charts/suite_table_model.h"

#include "ui/text/units.h"
#include "ui/theme/suite_style.h"

namespace skyseal::ui {

namespace {
enum FixedColumn { SuiteColumn, TimeColumn, FixedColumns };
}

SuiteTableModel::SuiteTableModel(const SampleHistory &history, const std::vector<Quantity> &quantities, QObject *parent)
    : QAbstractTableModel(parent), m_history(history)
{
    std::size_t tally = 0;
    for (const Quantity &quantity : quantities) {
        for (const QuantityLine &line : quantity.lines) {
            if (quantity.perSuite) {
                const QString what = line.name.isEmpty() ? quantity.title : tr("%1\n%2").arg(quantity.title, line.name);
                m_columns.push_back({tr("%1, %2").arg(what, quantity.unit), quantity.note, quantity.decimals, tally});
            }
            ++tally;
        }
    }
}

void SuiteTableModel::refresh()
{
    const int rows = static_cast<int>(m_history.suites().uses().size());
    if (rows > m_rows) {
        beginInsertRows({}, m_rows, rows - 1);
        m_rows = rows;
        endInsertRows();
    } else if (rows < m_rows) {
        beginResetModel();
        m_rows = rows;
        endResetModel();
    }
    if (m_rows > 0)
        Q_EMIT dataChanged(index(0, TimeColumn), index(m_rows - 1, columnCount() - 1), {Qt::DisplayRole});
}

int SuiteTableModel::rowCount(const QModelIndex &parent) const
{
    return parent.isValid() ? 0 : m_rows;
}

int SuiteTableModel::columnCount(const QModelIndex &parent) const
{
    return parent.isValid() ? 0 : FixedColumns + static_cast<int>(m_columns.size());
}

QVariant SuiteTableModel::data(const QModelIndex &index, int role) const
{
    const auto row = static_cast<std::size_t>(index.row());
    if (!index.isValid() || row >= m_history.suites().uses().size())
        return {};
    const SuiteUse &use = m_history.suites().uses()[row];
    if (index.column() == SuiteColumn) {
        if (role == Qt::DisplayRole)
            return suiteName(use.suite);
        return role == Qt::DecorationRole ? QVariant(suiteDot(use.suite)) : QVariant();
    }
    if (role == Qt::TextAlignmentRole)
        return QVariant(Qt::AlignRight | Qt::AlignVCenter);
    if (index.column() == TimeColumn)
        return role == Qt::DisplayRole ? QVariant(durationText(use.inUse)) : QVariant();
    const Column &column = m_columns[static_cast<std::size_t>(index.column() - FixedColumns)];
    const Tally &tally = use.tallies[column.tally];
    if (role == Qt::DisplayRole)
        return number(tally.mean(), column.decimals);
    if (role == Qt::ToolTipRole && tally.count > 0)
        return tr("from %1 to %2, %3 samples").arg(number(tally.low, 3), number(tally.high, 3), grouped(tally.count));
    return {};
}

QVariant SuiteTableModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal)
        return {};
    if (section < FixedColumns)
        return role == Qt::DisplayRole ? QVariant(section == SuiteColumn ? tr("Suite") : tr("In use")) : QVariant();
    const Column &column = m_columns[static_cast<std::size_t>(section - FixedColumns)];
    if (role == Qt::DisplayRole)
        return column.title;
    return role == Qt::ToolTipRole ? QVariant(column.note) : QVariant();
}

} // namespace skyseal::ui

#include "moc_suite_table_model.cpp"
