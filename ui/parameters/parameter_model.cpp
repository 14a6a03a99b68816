#include "ui/parameters/parameter_model.h"

#include "ui/text/vehicle_text.h"

#include <cmath>
#include <optional>
#include <utility>

namespace skyseal::ui {

namespace {

QString labelOf(const vehicle::Parameter &parameter)
{
    return fromStd(vehicle::parameterLabel(parameter));
}

/// Whole numbers with all their digits, others with as many as a float has.
QString exactNumber(double value)
{
    constexpr double kExact = 9007199254740992; // 2^53
    const bool isWhole = value == std::trunc(value) && std::abs(value) <= kExact;
    return isWhole ? QString::number(value, 'f', 0) : QString::number(value, 'g', 7);
}

} // namespace

QString ParameterModel::valueText(const vehicle::Parameter &parameter)
{
    return exactNumber(parameter.value);
}

/// Why the type of the parameter cannot hold the value; empty if it can.
QString ParameterModel::outOfRange(const vehicle::Parameter &parameter, double value)
{
    if (!std::isfinite(value))
        return tr("not written: not a finite number");
    const auto range = vehicle::rangeOfType(parameter.type);
    if (!range)
        return {};
    if (value < range->least || value > range->greatest)
        return tr("not written: %1 is not between %2 and %3")
            .arg(exactNumber(value), exactNumber(range->least), exactNumber(range->greatest));
    if (range->isWhole && value != std::trunc(value))
        return tr("not written: %1 is not a whole number").arg(exactNumber(value));
    return {};
}

void ParameterModel::setParameters(const Parameters &parameters)
{
    if (parameters == m_parameters)
        return;
    const auto sameNames = [&] {
        if (!m_parameters || !parameters || m_parameters->size() != parameters->size())
            return false;
        for (std::size_t i = 0; i < parameters->size(); ++i)
            if ((*parameters)[i].name != (*m_parameters)[i].name
                || (*parameters)[i].componentId != (*m_parameters)[i].componentId)
                return false;
        return true;
    };
    if (sameNames()) { // only values changed: keeps selection and scroll position
        const Parameters before = std::exchange(m_parameters, parameters);
        for (int row = 0; row < rowCount(); ++row) { // not all rows: the view would fill the editor of one anew
            const auto at = static_cast<std::size_t>(row);
            if ((*before)[at].value != (*parameters)[at].value)
                Q_EMIT dataChanged(index(row, Value), index(row, Value));
        }
        return;
    }
    beginResetModel();
    m_parameters = parameters;
    if (!parameters)
        m_states.clear();
    endResetModel();
}

void ParameterModel::forgetResults()
{
    beginResetModel(); // closes an editor whose value would go to the other vehicle
    m_states.clear();
    endResetModel();
}

void ParameterModel::setName(int vehicle)
{
    if (vehicle == m_vehicle)
        return;
    m_vehicle = vehicle;
    Q_EMIT headerDataChanged(Qt::Horizontal, Value, Value);
}

void ParameterModel::written(const vehicle::Parameter &parameter, bool ok, const QString &reason)
{
    const QString name = labelOf(parameter);
    m_states.insert(name, ok ? tr("written, read back as %1").arg(valueText(parameter)) : tr("not written: %1").arg(reason));
    touch(name);
}

void ParameterModel::showWriting(const QString &name, double value)
{
    showNote(name, tr("writing %1…").arg(exactNumber(value)));
}

void ParameterModel::showNote(const QString &name, const QString &note)
{
    m_states.insert(name, note);
    touch(name);
}

std::optional<vehicle::Parameter> ParameterModel::find(const QString &name) const
{
    for (int row = 0; row < rowCount(); ++row)
        if (const vehicle::Parameter &one = (*m_parameters)[static_cast<std::size_t>(row)]; labelOf(one) == name)
            return one;
    return std::nullopt;
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
    case Name: return labelOf(parameter);
    case Value: return valueText(parameter);
    case State: return m_states.value(labelOf(parameter));
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
    const QString name = labelOf(parameter);
    if (!ok) {
        m_states.insert(name, tr("\"%1\" is not a number").arg(value.toString()));
        touch(name);
        return false;
    }
    if (wanted == parameter.value)
        return false;
    if (const QString problem = outOfRange(parameter, wanted); !problem.isEmpty()) {
        m_states.insert(name, problem);
        touch(name);
        return false;
    }
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
    case Value: return m_vehicle == 0 ? tr("Value") : tr("Value · vehicle %1").arg(m_vehicle);
    case State: return tr("Last change");
    default: return {};
    }
}

} // namespace skyseal::ui

#include "moc_parameter_model.cpp"
