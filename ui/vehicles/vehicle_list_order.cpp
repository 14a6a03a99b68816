#include "ui/vehicles/vehicle_list_order.h"

#include "ui/vehicles/vehicle_list_model.h"

#include <algorithm>

namespace skyseal::ui {

namespace {

constexpr int kSearched[] = {VehicleListRow::Vehicle, VehicleListRow::Kind, VehicleListRow::Mode,
                             VehicleListRow::Armed,   VehicleListRow::Lock, VehicleListRow::Alerts};

/// Whether a word of `text` begins with `word`: "armed" is not found in "disarmed".
bool hasWord(const QString &text, const QString &word)
{
    for (qsizetype at = text.indexOf(word, 0, Qt::CaseInsensitive); at >= 0;
         at = text.indexOf(word, at + 1, Qt::CaseInsensitive))
        if (at == 0 || !text[at - 1].isLetterOrNumber())
            return true;
    return false;
}

} // namespace

VehicleListOrder::VehicleListOrder(QObject *parent) : QSortFilterProxyModel(parent)
{
    setDynamicSortFilter(false);
}

void VehicleListOrder::setTyped(const QString &typed)
{
    m_words = typed.split(QLatin1Char(' '), Qt::SkipEmptyParts);
    renew();
}

bool VehicleListOrder::isOutdated() const
{
    int accepted = 0;
    for (int row = 0; row < sourceModel()->rowCount(); ++row) {
        const bool wanted = filterAcceptsRow(row, {});
        accepted += wanted;
        if (wanted != mapFromSource(sourceModel()->index(row, 0)).isValid())
            return true;
    }
    for (int row = 1; row < accepted && sortColumn() >= 0; ++row) {
        const QModelIndex above = mapToSource(index(row - 1, sortColumn())), own = mapToSource(index(row, sortColumn()));
        if (sortOrder() == Qt::AscendingOrder ? lessThan(own, above) : lessThan(above, own))
            return true;
    }
    return false;
}

void VehicleListOrder::renew()
{
    invalidateFilter();
    sort(sortColumn(), sortOrder());
}

bool VehicleListOrder::filterAcceptsRow(int row, const QModelIndex &parent) const
{
    const QAbstractItemModel &source = *sourceModel();
    const QString id = source.index(row, 0, parent).data(VehicleListModel::SystemIdRole).toString();
    return std::ranges::all_of(m_words, [&](const QString &word) {
        if (std::ranges::all_of(word, [](QChar one) { return one.isDigit(); }))
            return id.startsWith(word);
        return std::ranges::any_of(
            kSearched, [&](int column) { return hasWord(source.index(row, column, parent).data().toString(), word); });
    });
}

/// Equal ones by number, so that the order does not depend on what was before.
bool VehicleListOrder::lessThan(const QModelIndex &left, const QModelIndex &right) const
{
    const double leftRank = left.data(VehicleListModel::RankRole).toDouble();
    const double rightRank = right.data(VehicleListModel::RankRole).toDouble();
    if (leftRank != rightRank)
        return leftRank < rightRank;
    if (const int order = QString::localeAwareCompare(left.data().toString(), right.data().toString()); order != 0)
        return order < 0;
    return left.data(VehicleListModel::SystemIdRole).toInt() < right.data(VehicleListModel::SystemIdRole).toInt();
}

} // namespace skyseal::ui

#include "moc_vehicle_list_order.cpp"
