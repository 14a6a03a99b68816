// The vehicle that the operator looks at, and the rate at which the window follows the snapshots. Lives on the GUI thread.
#pragma once

#include "ui/view_state.h"

#include <QtCore/QObject>

#include <functional>

namespace skyseal::ui {

class ViewSelection : public QObject
{
    Q_OBJECT

public:
    /// Numbers are renewed at this interval in seconds: faster changes cannot be read, and each repaint costs CPU time.
    static constexpr double kNumbersInterval = 0.2;

    using QObject::QObject;

    /// Makes the view of a new snapshot. The selected vehicle stays selected while it is in the snapshot, because commands go
    /// to the vehicle that is shown.
    void setSnapshot(const SnapshotPtr &snapshot);
    /// Until endReplay(), the views are those of the replay, and those of the station leave as liveChanged().
    void beginReplay();
    void setReplaySnapshot(const SnapshotPtr &snapshot);
    void endReplay();
    bool isReplaying() const { return m_replaying; }
    /// True if this picture of the replay does not continue the one that is shown.
    bool isAfterSeek(const engine::Snapshot &next) const;
    /// The view of the station, also during a replay.
    ViewState liveView() const;
    void selectVehicle(std::uint8_t systemId);
    /// Publishes the view again, after the state of the annotation has changed.
    void refresh();
    /// Selects the vehicle of this session, if there is one.
    void selectSession(quint32 session);
    /// Called for each new view before it is published, to add state that is not in the snapshot.
    void setAnnotation(std::function<void(ViewState &)> annotate) { m_annotate = std::move(annotate); }
    const ViewState &view() const { return m_view; }

Q_SIGNALS:
    /// For every snapshot of the station during a replay.
    void liveChanged(const skyseal::ui::ViewState &live);
    /// For every snapshot, up to 30 a second.
    void viewChanged(const skyseal::ui::ViewState &view);
    /// Every kNumbersInterval, and at once when the alarm state changes.
    void numbersDue(const skyseal::ui::ViewState &view);

private:
    void show(const SnapshotPtr &snapshot);

    ViewState m_view;
    SnapshotPtr m_live; ///< the newest one of the station
    bool m_replaying = false;
    std::uint8_t m_liveSystemId = 0; ///< the selected vehicle, during a replay
    std::function<void(ViewState &)> m_annotate;
    std::uint8_t m_systemId = 0; ///< 0 until the first vehicle is heard
    double m_numbersAt = -1;     ///< time of the snapshot whose numbers are shown
    AlarmState m_shownState;
};

} // namespace skyseal::ui
