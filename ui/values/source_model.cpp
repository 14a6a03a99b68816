#include "ui/values/source_model.h"

#include "ui/text/plain_tip.h"

#include <QtCore/QStringList>

#include <algorithm>

namespace skyseal::ui {

SourceModel::SourceModel(QObject *parent) : QAbstractTableModel(parent)
{
    for (const ValueSource &source : valueSources())
        m_names.push_back(source.state ? source.title() + QLatin1Char(' ') + source.id() : source.id());
    filter({});
}

void SourceModel::filter(const QString &typed)
{
    const QStringList words = typed.split(QLatin1Char(' '), Qt::SkipEmptyParts);
    beginResetModel();
    m_shown.clear();
    const auto all = valueSources();
    for (std::size_t i = 0; i < all.size(); ++i) {
        const QString &name = m_names[i];
        if (std::ranges::all_of(words, [&](const QString &word) { return name.contains(word, Qt::CaseInsensitive); }))
            m_shown.push_back(&all[i]);
    }
    endResetModel();
}

int SourceModel::rowCount(const QModelIndex &parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(m_shown.size());
}

int SourceModel::columnCount(const QModelIndex &parent) const
{
    return parent.isValid() ? 0 : Columns;
}

QVariant SourceModel::data(const QModelIndex &index, int role) const
{
    if (!index.isValid() || index.row() >= rowCount())
        return {};
    const ValueSource &source = sourceAt(index.row());
    if (role == Qt::ToolTipRole && index.column() == Name)
        return plainTip(source.title());
    if (role != Qt::DisplayRole)
        return {};
    switch (index.column()) {
    case Name: return source.title();
    case Unit: return source.sourceUnit();
    case Description: return source.description();
    default: return {};
    }
}

QVariant SourceModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal || role != Qt::DisplayRole)
        return {};
    switch (section) {
    case Name: return tr("Value");
    case Unit: return tr("Unit");
    case Description: return tr("Kind");
    default: return {};
    }
}

} // namespace skyseal::ui

#include "moc_source_model.cpp"
