// Reasons why a sweep cannot measure something: pure functions of the view and the settings.
#pragma once

#include "core/crypto/suite.h"
#include "ui/view_state.h"

#include <QtCore/QString>

namespace skyseal::ui {

class SuiteActions;

struct SweepContext
{
    const ViewState &view;
    const SuiteActions &suites;
    bool requireSealed = false; ///< by the settings
    QString noOwnVehicle;       ///< reason why there can be no simulated vehicle; empty if there can
};

/// Each returns the reason; empty if the choice is possible.
QString connectedLinkDisabledReason(const SweepContext &context);
QString suiteDisabledReason(const SweepContext &context, bool ownVehicle, crypto::SuiteId suite);
QString inlineDisabledReason(const SweepContext &context, bool ownVehicle);
QString saturatedDisabledReason(bool ownVehicle);
QString otherLinkDisabledReason(bool ownVehicle);

} // namespace skyseal::ui
