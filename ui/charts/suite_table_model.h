// The suites used so far beside one another in numbers: means over all the time that each was in use.
#pragma once

#include "ui/charts/sample_history.h"

#include <QtCore/QAbstractTableModel>

namespace skyseal::ui {

class SuiteTableModel : public QAbstractTableModel
{
    Q_OBJECT

public:
    /// `history` must outlive the model.
    SuiteTableModel(const SampleHistory &history, const std::vector<Quantity> &quantities, QObject *parent = nullptr);

    /// After the history grew.
    void refresh();

    int rowCount(const QModelIndex &parent = {}) const override;
    int columnCount(const QModelIndex &parent = {}) const override;
    QVariant data(const QModelIndex &index, int role) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

private:
    struct Column
    {
        QString title, note;
        int decimals;
        std::size_t tally;
    };

    const SampleHistory &m_history;
    std::vector<Column> m_columns; ///< behind "suite" and "in use"
    int m_rows = 0;
};

} // namespace skyseal::ui
