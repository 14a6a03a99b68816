// The checklists before a flight, one file for each vehicle that has one: what is ticked by hand, what the values of the
// vehicle tick by themselves, and what is still open. No widgets. Lives on the GUI thread.
#pragma once

#include "core/vehicle/checklist.h"
#include "ui/view_state.h"

#include <QtCore/QMap>
#include <QtCore/QObject>
#include <QtCore/QSet>
#include <QtCore/QStringList>

#include <vector>

namespace skyseal::ui {

class Preflight : public QObject
{
    Q_OBJECT

public:
    using QObject::QObject;
    using Files = QMap<int, QString>; ///< paths by system id

    struct Item
    {
        QString text, condition; ///< condition: empty if it is ticked by hand
        bool done = false;
    };

    /// For each view. Uses the vehicles of the station, never those of a replay. Items that were ticked by hand are open again
    /// once the vehicle has been disarmed.
    void showViewState(const ViewState &view);

    /// Uses these files, in place of all former ones.
    void setFiles(const Files &files);
    /// Uses this file for a vehicle; an empty path: none.
    void setFile(std::uint8_t systemId, const QString &path);
    const Files &files() const { return m_files; }
    QString file(std::uint8_t systemId) const { return m_files.value(systemId); }
    /// Reads the file again; what was ticked stays, as far as its text is still there.
    void reload(std::uint8_t systemId);

    std::vector<Item> items(std::uint8_t systemId) const;
    /// Lines that cannot be read, by number, or the reason why there is no list.
    QStringList problems(std::uint8_t systemId) const { return m_lists.value(systemId).problems; }
    /// By hand; without effect on an item with a condition.
    void tick(std::uint8_t systemId, const QString &text, bool done);
    /// The items that are not done. Empty if all are, or if the vehicle has no checklist.
    QStringList open(std::uint8_t systemId) const;

Q_SIGNALS:
    /// An item was ticked, or a list has changed; not for values of vehicles.
    void changed();
    void filesChanged();

private:
    struct List
    {
        std::vector<vehicle::ChecklistItem> items;
        QStringList problems;
        QSet<QString> ticked; ///< texts
        bool armed = false;
    };

    static void read(const QString &path, List &list);
    const vehicle::VehicleState *stateOf(std::uint8_t systemId) const;

    Files m_files;
    QMap<int, List> m_lists;
    SnapshotPtr m_station;
};

} // namespace skyseal::ui
