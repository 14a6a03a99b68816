// Filters the messages by severity and text.
#pragma once

#include "ui/messages/message_model.h"

#include <QtCore/QSortFilterProxyModel>

namespace skyseal::ui {

class MessageFilter : public QSortFilterProxyModel
{
    Q_OBJECT

public:
    using QSortFilterProxyModel::QSortFilterProxyModel;

    /// Shows messages up to this MAV_SEVERITY (7: all).
    void setLeastGrave(int severity)
    {
        m_leastGrave = severity;
        invalidateFilter();
    }
    void setWantedText(const QString &text)
    {
        m_wanted = text;
        invalidateFilter();
    }

protected:
    bool filterAcceptsRow(int row, const QModelIndex &parent) const override
    {
        const QModelIndex text = sourceModel()->index(row, MessageModel::Text, parent);
        return text.data(MessageModel::SeverityRole).toInt() <= m_leastGrave
            && (m_wanted.isEmpty() || text.data().toString().contains(m_wanted, Qt::CaseInsensitive));
    }

private:
    int m_leastGrave = 7;
    QString m_wanted;
};

} // namespace skyseal::ui
