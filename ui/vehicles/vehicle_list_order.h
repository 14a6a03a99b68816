// Order and filter of the list of vehicles. Both are applied when they are requested, not whenever a value changes, so that no
// row moves away under the pointer. GUI thread.
#pragma once

#include <QtCore/QSortFilterProxyModel>
#include <QtCore/QStringList>

namespace skyseal::ui {

class VehicleListOrder : public QSortFilterProxyModel
{
    Q_OBJECT

public:
    explicit VehicleListOrder(QObject *parent = nullptr);

    /// Shows the vehicles of which each typed word begins a word in the name, kind, mode, armed state, lock or alerts. A number
    /// is the beginning of a vehicle's number.
    void setTyped(const QString &typed);
    /// True if the values have changed so that a vehicle belongs to another row, into the list or out of it.
    bool isOutdated() const;
    /// Puts every vehicle where it belongs.
    void renew();

protected:
    bool filterAcceptsRow(int row, const QModelIndex &parent) const override;
    bool lessThan(const QModelIndex &left, const QModelIndex &right) const override;

private:
    QStringList m_words;
};

} // namespace skyseal::ui
