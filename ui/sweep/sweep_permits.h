// Reasons why a sweep cannot measure something: pure functions of the view and the settings.
#pragma once

#include "core/crypto/suite.h"
#include "core/experiment/placement.h"
#include "ui/sweep/sweep_interface.h"
#include "ui/view_state.h"

#include <QtCore/QString>

namespace skyseal::ui {

class SuiteActions;

struct SweepContext
{
    const ViewState &view;
    const SuiteActions &suites;
    bool requireSealed = false; ///< by the settings
    QString noOwnPrograms;      ///< reason why no vehicle or agent can be started; empty if they can
    /// The programs of the sweep have cores of their own, so that a clean link can be saturated.
    bool ownCores = experiment::placementHere().station.has_value();
};

/// Whether the view has a vehicle that is armed.
bool hasArmedVehicle(const ViewState &view);

/// Each returns the reason; empty if the choice is possible.
QString connectedLinkDisabledReason(const SweepContext &context);
QString suiteDisabledReason(const SweepContext &context, SweepTarget target, crypto::SuiteId suite);
QString inlineDisabledReason(const SweepContext &context, SweepTarget target);
QString saturatedDisabledReason(SweepTarget target);
QString otherLinkDisabledReason(SweepTarget target);

} // namespace skyseal::ui
