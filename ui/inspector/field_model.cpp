#include "ui/inspector/field_model.h"

#include "core/base/hex.h"
#include "core/engine/station/inspector_row.h"
#include "ui/inspector/field_text.h"
#include "ui/text/vehicle_text.h"
#include "ui/text/plain_tip.h"

namespace skyseal::ui {

FieldModel::FieldModel(const mavlink::Dialect &dialect, QObject *parent) : QAbstractTableModel(parent), m_dialect(dialect) {}

void FieldModel::setMessage(const engine::InspectorRow *row)
{
    QStringList values;
    const mavlink::MessageInfo *message = row ? m_dialect.find(row->messageId) : nullptr;
    if (message) {
        const ByteView payload = ByteView(row->payload).first(row->payloadSize);
        for (const mavlink::FieldInfo &field : message->fields)
            values << fieldText(field, payload, m_dialect);
    } else if (row) {
        values << fromStd(toHex(ByteView(row->payload).first(row->payloadSize)));
    }
    const std::optional<std::uint32_t> id = row ? std::optional(row->messageId) : std::nullopt;
    if (id != m_id) {
        beginResetModel();
        m_id = id;
        m_message = message;
        m_values = values;
        endResetModel();
    } else if (values != m_values) {
        m_values = values;
        Q_EMIT dataChanged(index(0, Value), index(rowCount() - 1, Value));
    }
}

int FieldModel::rowCount(const QModelIndex &parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(m_values.size());
}

int FieldModel::columnCount(const QModelIndex &parent) const
{
    return parent.isValid() ? 0 : Columns;
}

QVariant FieldModel::data(const QModelIndex &index, int role) const
{
    if (!index.isValid() || index.row() >= rowCount())
        return {};
    if (role == Qt::ToolTipRole && index.column() == Value)
        return plainTip(m_values.at(index.row()));
    if (role != Qt::DisplayRole)
        return {};
    if (index.column() == Value)
        return m_values.at(index.row());
    if (!m_message)
        return index.column() == Name ? QVariant(tr("raw bytes")) : QVariant();
    const mavlink::FieldInfo &field = m_message->fields[static_cast<std::size_t>(index.row())];
    switch (index.column()) {
    case Name: return fromStd(field.name);
    case Unit: return fromStd(field.units);
    case Type:
        return field.arrayLength ? QStringLiteral("%1[%2]").arg(fromStd(mavlink::nameOf(field.type))).arg(field.arrayLength)
                                 : fromStd(mavlink::nameOf(field.type));
    default: return {};
    }
}

QVariant FieldModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal || role != Qt::DisplayRole)
        return {};
    switch (section) {
    case Name: return tr("Field");
    case Value: return tr("Value");
    case Unit: return tr("Unit");
    case Type: return tr("Type");
    default: return {};
    }
}

} // namespace skyseal::ui

#include "moc_field_model.cpp"
