#include "ui/messages/message_model.h"

#include "core/mavlink/enums.h"
#include "ui/text/vehicle_text.h"
#include "ui/theme/palettes.h"
#include "ui/text/plain_tip.h"

#include <QtGui/QFont>
#include <QtGui/QGuiApplication>

namespace skyseal::ui {

std::uint64_t MessageModel::append(const Message &message)
{
    if (static_cast<int>(m_messages.size()) >= kMost) {
        beginRemoveRows({}, 0, 0);
        m_messages.pop_front();
        ++m_first;
        endRemoveRows();
    }
    const int row = static_cast<int>(m_messages.size());
    beginInsertRows({}, row, row);
    m_messages.push_back(message);
    endInsertRows();
    return m_first + static_cast<std::uint64_t>(row);
}

bool MessageModel::replace(std::uint64_t number, const Message &message)
{
    if (number < m_first || number - m_first >= m_messages.size())
        return false;
    m_messages[number - m_first] = message;
    const int row = static_cast<int>(number - m_first);
    Q_EMIT dataChanged(index(row, 0), index(row, Columns - 1));
    return true;
}

void MessageModel::clear()
{
    beginResetModel();
    m_first += m_messages.size();
    m_messages.clear();
    endResetModel();
}

int MessageModel::rowCount(const QModelIndex &parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(m_messages.size());
}

int MessageModel::columnCount(const QModelIndex &parent) const
{
    return parent.isValid() ? 0 : Columns;
}

QVariant MessageModel::data(const QModelIndex &index, int role) const
{
    if (!index.isValid() || index.row() >= rowCount())
        return {};
    const Message &message = m_messages[static_cast<std::size_t>(index.row())];
    switch (role) {
    case Qt::DisplayRole:
        switch (index.column()) {
        case Time: return message.time.toString(QStringLiteral("HH:mm:ss.zzz"));
        case Vehicle: return message.systemId == 0 ? tr("station") : QString::number(message.systemId);
        case Severity: return severityText(message.severity);
        case Text: return message.text;
        default: return {};
        }
    case Qt::ToolTipRole: return index.column() == Text ? QVariant(plainTip(message.text)) : QVariant();
    case Qt::ForegroundRole: {
        const StateColors &colors = stateColors(QGuiApplication::palette());
        if (message.severity <= mavlink::MAV_SEVERITY_ERROR)
            return colors.alarm;
        if (message.severity <= mavlink::MAV_SEVERITY_NOTICE)
            return index.column() == Severity || message.severity == mavlink::MAV_SEVERITY_WARNING ? QVariant(colors.warning)
                                                                                                   : QVariant();
        return index.column() == Text ? QVariant() : QVariant(colors.dim);
    }
    case Qt::FontRole:
        if (message.severity <= mavlink::MAV_SEVERITY_ERROR) {
            QFont bold;
            bold.setBold(true);
            return bold;
        }
        return {};
    case SeverityRole: return message.severity;
    default: return {};
    }
}

QVariant MessageModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal || role != Qt::DisplayRole)
        return {};
    switch (section) {
    case Time: return tr("Time");
    case Vehicle: return tr("From");
    case Severity: return tr("Severity");
    case Text: return tr("Message");
    default: return {};
    }
}

} // namespace skyseal::ui

#include "moc_message_model.cpp"
