// The shortcuts as a table: action, menu, keys, and the keys that it has at first. Lives on the GUI thread.
#pragma once

#include <QtCore/QAbstractTableModel>

namespace skyseal::ui {

class Shortcuts;

class ShortcutModel : public QAbstractTableModel
{
    Q_OBJECT

public:
    enum Column { Action, Menu, Keys, First, Columns };

    /// `shortcuts` must outlive this.
    explicit ShortcutModel(const Shortcuts &shortcuts, QObject *parent = nullptr);

    /// All texts of a row, in which words are looked for.
    QString rowText(int row) const;

    int rowCount(const QModelIndex &parent = {}) const override;
    int columnCount(const QModelIndex &parent = {}) const override;
    QVariant data(const QModelIndex &index, int role = Qt::DisplayRole) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role = Qt::DisplayRole) const override;

private:
    QString text(int row, int column) const;

    const Shortcuts &m_shortcuts;
};

} // namespace skyseal::ui
