// The fields of one message with their values, units and enum names, decoded by the dialect.
#pragma once

#include "core/mavlink/dialect.h"

#include <QtCore/QAbstractTableModel>
#include <QtCore/QStringList>

namespace skyseal::engine {
struct InspectorRow;
}

namespace skyseal::ui {

class FieldModel : public QAbstractTableModel
{
    Q_OBJECT

public:
    enum Column { Name, Value, Unit, Type, Columns };

    explicit FieldModel(const mavlink::Dialect &dialect, QObject *parent = nullptr);

    /// Null clears the model. For a message that is not in the dialect, the raw bytes are shown.
    void setMessage(const engine::InspectorRow *row);

    int rowCount(const QModelIndex &parent = {}) const override;
    int columnCount(const QModelIndex &parent = {}) const override;
    QVariant data(const QModelIndex &index, int role) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

private:
    const mavlink::Dialect &m_dialect;
    const mavlink::MessageInfo *m_message = nullptr;
    std::optional<std::uint32_t> m_id;
    QStringList m_values;
};

} // namespace skyseal::ui
