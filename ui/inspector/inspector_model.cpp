#include "ui/inspector/inspector_model.h"

#include "ui/text/units.h"
#include "ui/text/vehicle_text.h"
#include "ui/theme/palettes.h"

#include <QtGui/QGuiApplication>

#include <algorithm>
#include <tuple>

namespace skyseal::ui {

using engine::InspectorRow;

namespace {

auto keyOf(const InspectorRow &row)
{
    return std::tie(row.systemId, row.componentId, row.name, row.messageId);
}

constexpr double kOldAfter = 3.5;

} // namespace

void InspectorModel::setRows(const std::vector<InspectorRow> &rows)
{
    for (const InspectorRow &row : rows) {
        const auto at = std::ranges::lower_bound(m_rows, keyOf(row), {}, keyOf);
        const int index = static_cast<int>(at - m_rows.begin());
        if (at != m_rows.end() && keyOf(*at) == keyOf(row)) {
            const bool changed = at->count != row.count || at->rate != row.rate
                || (at->age > kOldAfter) != (row.age > kOldAfter);
            *at = row;
            if (changed)
                Q_EMIT dataChanged(this->index(index, 0), this->index(index, Columns - 1));
        } else {
            beginInsertRows({}, index, index);
            m_rows.insert(at, row);
            endInsertRows();
        }
    }
    if (m_rows.size() == rows.size())
        return; // all of them are there
    const auto isGone = [&](const InspectorRow &old) {
        return std::ranges::none_of(rows, [&](const InspectorRow &one) { return keyOf(one) == keyOf(old); });
    };
    for (int index = rowCount() - 1; index >= 0; --index) {
        if (!isGone(*rowAt(index)))
            continue;
        beginRemoveRows({}, index, index);
        m_rows.erase(m_rows.begin() + index);
        endRemoveRows();
    }
}

const InspectorRow *InspectorModel::rowAt(int row) const
{
    return row >= 0 && row < rowCount() ? &m_rows[static_cast<std::size_t>(row)] : nullptr;
}

int InspectorModel::rowCount(const QModelIndex &parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(m_rows.size());
}

int InspectorModel::columnCount(const QModelIndex &parent) const
{
    return parent.isValid() ? 0 : Columns;
}

QVariant InspectorModel::data(const QModelIndex &index, int role) const
{
    const InspectorRow *row = index.isValid() ? rowAt(index.row()) : nullptr;
    if (!row)
        return {};
    switch (role) {
    case Qt::DisplayRole:
        switch (index.column()) {
        case Name: return fromStd(row->name);
        case Id: return row->messageId;
        case Sender: return QStringLiteral("%1 / %2").arg(row->systemId).arg(row->componentId);
        case Rate: return number(row->rate, 1) + QStringLiteral(" /s");
        case Count: return grouped(row->count);
        case Version: return row->isSigned ? tr("%1 signed").arg(row->version) : QString::number(row->version);
        default: return {};
        }
    case Qt::TextAlignmentRole:
        return index.column() == Name || index.column() == Version ? QVariant()
                                                                   : QVariant(int(Qt::AlignRight | Qt::AlignVCenter));
    case Qt::ForegroundRole: return row->age > kOldAfter ? QVariant(stateColors(QGuiApplication::palette()).dim) : QVariant();
    default: return {};
    }
}

QVariant InspectorModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal)
        return {};
    if (role == Qt::TextAlignmentRole)
        return section == Name || section == Version ? int(Qt::AlignLeft | Qt::AlignVCenter)
                                                     : int(Qt::AlignRight | Qt::AlignVCenter);
    if (role != Qt::DisplayRole)
        return {};
    switch (section) {
    case Name: return tr("Message");
    case Id: return tr("ID");
    case Sender: return tr("From");
    case Rate: return tr("Rate");
    case Count: return tr("Count");
    case Version: return tr("MAVLink");
    default: return {};
    }
}

} // namespace skyseal::ui

#include "moc_inspector_model.cpp"
