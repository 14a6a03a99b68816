#include "ui/parameters/parameter_model.h"

#include "ui/text/vehicle_text.h"

namespace skyseal::ui {

void ParameterModel::setParameters(const Parameters &parameters)
{
    if (parameters == m_parameters)
        return;
    const auto sameNames = [&] {
        if (!m_parameters || !parameters || m_parameters->size() != parameters->size())
            return false;
        for (std::size_t i = 0; i < parameters->size(); ++i)
            if ((*parameters)[i].name != (*m_parameters)[i].name)
                return false;
        return true;
    };
    if (sameNames()) { // only values changed: keeps selection and scroll position
        m_parameters = parameters;
        Q_EMIT dataChanged(index(0, Value), index(rowCount() - 1, Value));
        return;
    }
    beginResetModel();
    m_parameters = parameters;
    if (!parameters)
        m_states.clear();
    endResetModel();
}

void ParameterModel::written(const vehicle::Parameter &parameter, bool ok, const QString &reason)
{
    const QString name = fromStd(parameter.name);
    m_states.insert(name, ok ? tr("written, read back %1").arg(parameter.value) : tr("not written: %1").arg(reason));
    touch(name);
}

void ParameterModel::touch(const QString &name)
{
    for (int row = 0; row < rowCount(); ++row)
        if (index(row, Name).data().toString() == name)
            Q_EMIT dataChanged(index(row, Value), index(row, State));
}

int ParameterModel::rowCount(const QModelIndex &parent) const
{
    return parent.isValid() || !m_parameters ? 0 : static_cast<int>(m_parameters->size());
}

int ParameterModel::columnCount(const QModelIndex &parent) const
{
    return parent.isValid() ? 0 : Columns;
}

QVariant ParameterModel::data(const QModelIndex &index, int role) const
{
    if (!index.isValid() || index.row() >= rowCount())
        return {};
    const vehicle::Parameter &parameter = (*m_parameters)[static_cast<std::size_t>(index.row())];
    if (role == Qt::TextAlignmentRole && index.column() == Value)
        return int(Qt::AlignRight | Qt::AlignVCenter);
    if (role != Qt::DisplayRole && role != Qt::EditRole)
        return {};
    switch (index.column()) {
    case Name: return fromStd(parameter.name);
    case Value: return QString::number(parameter.value, 'g', 7);
    case State: return m_states.value(fromStd(parameter.name));
    default: return {};
    }
}

bool ParameterModel::setData(const QModelIndex &index, const QVariant &value, int role)
{
    if (!index.isValid() || role != Qt::EditRole || index.column() != Value)
        return false;
    bool ok = false;
    const double wanted = value.toString().trimmed().toDouble(&ok);
    const vehicle::Parameter &parameter = (*m_parameters)[static_cast<std::size_t>(index.row())];
    const QString name = fromStd(parameter.name);
    if (!ok) {
        m_states.insert(name, tr("\"%1\" is not a number").arg(value.toString()));
        touch(name);
        return false;
    }
    if (wanted == parameter.value)
        return false;
    m_states.insert(name, tr("writing %1 …").arg(wanted));
    touch(name);
    Q_EMIT writeRequested(name, wanted);
    return true;
}

Qt::ItemFlags ParameterModel::flags(const QModelIndex &index) const
{
    const Qt::ItemFlags usual = QAbstractTableModel::flags(index);
    return index.column() == Value ? usual | Qt::ItemIsEditable : usual;
}

QVariant ParameterModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal)
        return {};
    if (role == Qt::TextAlignmentRole && section == Value)
        return int(Qt::AlignRight | Qt::AlignVCenter);
    if (role != Qt::DisplayRole)
        return {};
    switch (section) {
    case Name: return tr("Parameter");
    case Value: return tr("Value");
    case State: return tr("Last change");
    default: return {};
    }
}

} // namespace skyseal::ui
