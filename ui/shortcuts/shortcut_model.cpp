#include "ui/shortcuts/shortcut_model.h"

#include "ui/shortcuts/shortcuts.h"

#include <QtGui/QFont>

#include <iterator>

namespace skyseal::ui {

ShortcutModel::ShortcutModel(const Shortcuts &shortcuts, QObject *parent) : QAbstractTableModel(parent), m_shortcuts(shortcuts)
{
    connect(&shortcuts, &Shortcuts::changed, this,
            [this] { Q_EMIT dataChanged(index(0, 0), index(rowCount() - 1, Columns - 1)); });
}

int ShortcutModel::rowCount(const QModelIndex &parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(std::ssize(m_shortcuts.items()));
}

int ShortcutModel::columnCount(const QModelIndex &parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(Columns);
}

QString ShortcutModel::text(int row, int column) const
{
    switch (column) {
    case Action: return m_shortcuts.name(row);
    case Menu: return m_shortcuts.items()[static_cast<std::size_t>(row)].menu;
    case Keys: return m_shortcuts.keys(row).toString(QKeySequence::NativeText);
    default: return m_shortcuts.items()[static_cast<std::size_t>(row)].first.toString(QKeySequence::NativeText);
    }
}

QString ShortcutModel::rowText(int row) const
{
    return text(row, Menu) + QLatin1Char(' ') + text(row, Action) + QLatin1Char(' ') + text(row, Keys);
}

QVariant ShortcutModel::data(const QModelIndex &index, int role) const
{
    if (!index.isValid())
        return {};
    const QString shown = text(index.row(), index.column());
    if (role == Qt::DisplayRole)
        return shown;
    if (role == Qt::AccessibleTextRole && shown.isEmpty())
        return tr("none");
    if (role == Qt::FontRole && index.column() == Keys && shown != text(index.row(), First)) {
        QFont bold; // the next column shows what it was
        bold.setBold(true);
        return bold;
    }
    return {};
}

QVariant ShortcutModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal || role != Qt::DisplayRole)
        return {};
    switch (section) {
    case Action: return tr("Action");
    case Menu: return tr("Menu or panel");
    case Keys: return tr("Shortcut");
    case First: return tr("Default");
    default: return {};
    }
}

} // namespace skyseal::ui

#include "moc_shortcut_model.cpp"
