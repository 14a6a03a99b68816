#include "ui/parameters/parameter_model.h"

#include "core/mavlink/enums.h"
#include "ui/text/vehicle_text.h"

#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace skyseal::ui {

namespace {

/// The least and the greatest value of a type; real types have no whole numbers only.
struct Range
{
    double least, greatest;
    bool whole = true;
};

std::optional<Range> rangeOf(std::uint8_t type)
{
    const auto of = []<typename T>(T) {
        return Range{static_cast<double>(std::numeric_limits<T>::lowest()), static_cast<double>(std::numeric_limits<T>::max()),
                     std::numeric_limits<T>::is_integer};
    };
    switch (type) {
    case mavlink::MAV_PARAM_TYPE_UINT8: return of(std::uint8_t{});
    case mavlink::MAV_PARAM_TYPE_INT8: return of(std::int8_t{});
    case mavlink::MAV_PARAM_TYPE_UINT16: return of(std::uint16_t{});
    case mavlink::MAV_PARAM_TYPE_INT16: return of(std::int16_t{});
    case mavlink::MAV_PARAM_TYPE_UINT32: return of(std::uint32_t{});
    case mavlink::MAV_PARAM_TYPE_INT32: return of(std::int32_t{});
    case mavlink::MAV_PARAM_TYPE_REAL32: return of(float{});
    case mavlink::MAV_PARAM_TYPE_REAL64: return of(double{});
    default: return std::nullopt;
    }
}

} // namespace

/// Why the type of the parameter cannot hold the value; empty if it can.
QString ParameterModel::outOfRange(const vehicle::Parameter &parameter, double value)
{
    if (!std::isfinite(value))
        return tr("not written: not a finite number");
    const auto range = rangeOf(parameter.type);
    if (!range)
        return {};
    if (value < range->least || value > range->greatest)
        return tr("not written: %1 is not between %2 and %3").arg(value).arg(range->least).arg(range->greatest);
    if (range->whole && value != std::trunc(value))
        return tr("not written: %1 is not a whole number").arg(value);
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
            if ((*parameters)[i].name != (*m_parameters)[i].name)
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
    const QString name = fromStd(parameter.name);
    m_states.insert(name, ok ? tr("written, read back as %1").arg(parameter.value) : tr("not written: %1").arg(reason));
    touch(name);
}

void ParameterModel::showWriting(const QString &name, double value)
{
    showNote(name, tr("writing %1…").arg(valueText(value)));
}

void ParameterModel::showNote(const QString &name, const QString &note)
{
    m_states.insert(name, note);
    touch(name);
}

std::optional<double> ParameterModel::valueOf(const QString &name) const
{
    for (int row = 0; row < rowCount(); ++row)
        if (const vehicle::Parameter &one = (*m_parameters)[static_cast<std::size_t>(row)]; fromStd(one.name) == name)
            return one.value;
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
    case Name: return fromStd(parameter.name);
    case Value: return valueText(parameter.value);
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
