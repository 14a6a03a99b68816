// The vehicle's parameters, named by their labels (vehicle::parameterLabel()). Editing a value requests a write; the table
// shows the value that the vehicle reports.
#pragma once

#include "core/vehicle/parameter.h"

#include <QtCore/QAbstractTableModel>
#include <QtCore/QHash>

#include <memory>
#include <optional>
#include <vector>

namespace skyseal::ui {

class ParameterModel : public QAbstractTableModel
{
    Q_OBJECT

public:
    using Parameters = std::shared_ptr<const std::vector<vehicle::Parameter>>;
    enum Column { Name, Value, State, Columns };

    using QAbstractTableModel::QAbstractTableModel;

    void setParameters(const Parameters &parameters);
    /// Another vehicle is shown: results of the former one are forgotten, and a value that is being typed is dropped.
    void forgetResults();
    /// Names the vehicle above its values; 0: it is the only one.
    void setName(int vehicle);
    /// The result of a write.
    void written(const vehicle::Parameter &parameter, bool ok, const QString &reason);
    /// Shows that this value is being sent.
    void showWriting(const QString &name, double value);
    /// Shows why nothing was sent, or not yet.
    void showNote(const QString &name, const QString &note);
    /// As the vehicle reported it last; nullopt if it has no such parameter.
    std::optional<vehicle::Parameter> find(const QString &name) const;
    /// As the table shows it.
    static QString valueText(const vehicle::Parameter &parameter);

    int rowCount(const QModelIndex &parent = {}) const override;
    int columnCount(const QModelIndex &parent = {}) const override;
    QVariant data(const QModelIndex &index, int role) const override;
    bool setData(const QModelIndex &index, const QVariant &value, int role) override;
    Qt::ItemFlags flags(const QModelIndex &index) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

Q_SIGNALS:
    /// The operator has typed another value, which the type of the parameter can hold.
    void writeRequested(const QString &name, double value);

private:
    static QString outOfRange(const vehicle::Parameter &parameter, double value);
    void touch(const QString &name);

    Parameters m_parameters;
    int m_vehicle = 0;                ///< see setName()
    QHash<QString, QString> m_states; ///< by name: "writing …", "written", "refused: …"
};

} // namespace skyseal::ui
