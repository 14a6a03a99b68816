// What the lock shows: one of its faces and the words beside it, from one view. Kept apart from the painting, so that
// strip, panel and tests agree about it.
#pragma once

#include "ui/view_state.h"

#include <QtCore/QString>
#include <QtCore/QStringList>

namespace skyseal::ui {

struct LockFace
{
    engine::Security security = engine::Security::Nothing;
    QString icon;
    QStringList variants; ///< of the words, the longest first; each names the suite
    QString toolTip;
    std::optional<crypto::SuiteId> suite; ///< for the colour
    bool lost = false; ///< there was a session, or there is an agent that does not answer: not nothing, and not well
    bool operator==(const LockFace &) const = default;
};

/// The state of the view's own session (or of the whole station where it has none).
engine::Security securityOf(const ViewState &view);
LockFace lockFaceOf(const ViewState &view);

} // namespace skyseal::ui
