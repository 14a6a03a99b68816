// The suites used so far as a table of means over the time in use of each.
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

    /// To be called when the history has new samples.
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
    std::vector<Column> m_columns; ///< after the columns "Suite" and "In use"
    int m_rows = 0;
};

} // namespace skyseal::ui
