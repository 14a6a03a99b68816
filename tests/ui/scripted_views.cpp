#include "scripted_views.h"

#include "scripted_snapshots.h"

namespace skyseal::ui {

ViewState sealedView(double time, const ChangeState &change)
{
    engine::Snapshot snapshot = sealedSnapshot(time);
    if (change)
        change(snapshot.vehicles.front().state);
    return viewOf(std::make_shared<const engine::Snapshot>(std::move(snapshot)), 1);
}

} // namespace skyseal::ui
