// The messages of vehicles and station, newest last, bounded. Severity is shown by colour and text.
#pragma once

#include "core/mavlink/enums.h"
#include "core/vehicle/vehicle_state.h"

#include <QtCore/QAbstractTableModel>
#include <QtCore/QDateTime>

#include <deque>

namespace skyseal::ui {

struct Message
{
    QDateTime time;
    std::uint8_t systemId = 0; ///< 0 = the station itself
    std::uint8_t severity = mavlink::MAV_SEVERITY_INFO;
    QString text;
};

class MessageModel : public QAbstractTableModel
{
    Q_OBJECT

public:
    static constexpr int kMost = 2000;
    enum Column { Time, Vehicle, Severity, Text, Columns };
    enum Role { SeverityRole = Qt::UserRole };

    using QAbstractTableModel::QAbstractTableModel;

    /// Returns the number of the message, for replace().
    std::uint64_t append(const Message &message);
    /// Returns false if the message is not in the list any more.
    bool replace(std::uint64_t number, const Message &message);
    void clear();

    int rowCount(const QModelIndex &parent = {}) const override;
    int columnCount(const QModelIndex &parent = {}) const override;
    QVariant data(const QModelIndex &index, int role) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

private:
    std::deque<Message> m_messages;
    std::uint64_t m_first = 0; ///< number of the first message in the list
};

} // namespace skyseal::ui
