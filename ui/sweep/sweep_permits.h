// What a sweep may measure on the connected link, and why not: pure functions of what the window knows.
#pragma once

#include "core/crypto/suite.h"
#include "ui/view_state.h"

#include <QtCore/QString>

namespace skyseal::ui {

class SuiteActions;

struct SweepSurroundings
{
    const ViewState &view;
    const SuiteActions &suites;
    bool requireSealed = false; ///< by the settings
    QString noOwnVehicle;       ///< why there can be no simulated vehicle for the sweep alone; empty when there can
};

/// Each of these is empty when nothing speaks against it.
QString whyNoConnectedLink(const SweepSurroundings &around);
QString whyNotSuite(const SweepSurroundings &around, bool ownVehicle, crypto::SuiteId suite);
QString whyNotInline(const SweepSurroundings &around, bool ownVehicle);
QString whyNotSaturated(bool ownVehicle);
QString whyNotOtherLink(bool ownVehicle);

} // namespace skyseal::ui
