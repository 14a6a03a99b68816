// The icon and text of the lock for one view, shared by status strip and secure link panel.
#pragma once

#include "ui/view_state.h"

#include <QtCore/QString>
#include <QtCore/QStringList>

namespace skyseal::ui {

struct LockFace
{
    engine::Security security = engine::Security::Nothing;
    QString icon;
    QStringList variants; ///< texts, longest first; each names the suite, except the shortest of an attack
    QString toolTip;
    std::optional<crypto::SuiteId> suite; ///< for the colour
    bool lost = false;                    ///< the session has ended, or the agent does not answer
    bool operator==(const LockFace &) const = default;
};

/// Returns the state of the view's session, or of the whole station if the view has none.
engine::Security securityOf(const ViewState &view);
LockFace lockFaceOf(const ViewState &view);

} // namespace skyseal::ui
