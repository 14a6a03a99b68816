// The sources of values whose names contain all typed words: derived quantities first, then fields of messages by name.
#pragma once

#include "ui/text/value_source.h"

#include <QtCore/QAbstractTableModel>

#include <vector>

namespace skyseal::ui {

class SourceModel : public QAbstractTableModel
{
    Q_OBJECT

public:
    enum Column { Name, Unit, Description, Columns };

    explicit SourceModel(QObject *parent = nullptr);

    /// Words apart by spaces, in any order and case; without one, all sources are shown.
    void filter(const QString &typed);
    const ValueSource &sourceAt(int row) const { return *m_shown[static_cast<std::size_t>(row)]; }

    int rowCount(const QModelIndex &parent = {}) const override;
    int columnCount(const QModelIndex &parent = {}) const override;
    QVariant data(const QModelIndex &index, int role) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

private:
    std::vector<const ValueSource *> m_shown;
    std::vector<QString> m_names; ///< of all sources, as they are searched
};

} // namespace skyseal::ui
