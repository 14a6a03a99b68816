// What the operator chose, as one value; kept by QSettings between runs. Only the application reads and writes it, every
// panel gets what it needs passed in.
#pragma once

#include "core/crypto/suite.h"
#include "ui/text/units.h"
#include "ui/theme/palettes.h"

#include <QtCore/QString>

class QSettings;

namespace skyseal::ui {

/// Heights in metres above home that a take-off can be commanded to.
inline constexpr double kLowestTakeOff = 1, kHighestTakeOff = 500;

struct Settings
{
    Theme theme = Theme::Desktop;
    UnitSystem units = UnitSystem::Metric;
    int systemId = 255;
    int componentId = 190;
    bool record = true;
    QString recordFolder; ///< empty = the application's own folder
    bool allowResearch = false;
    crypto::SuiteId weakestSuite = crypto::SuiteId::Rc4; ///< of those that are offered; RC4 = any sealed one
    bool requireSealed = false;                          ///< clear MAVLink is never shown
    double takeOffAltitude = 10;                         ///< metres above home, the last one that was chosen
    QString defaultLink = QStringLiteral("udpin:0.0.0.0:14550");

    bool operator==(const Settings &) const = default;
};

/// Values that are missing or out of range keep their defaults.
Settings loadSettings(const QSettings &store);
void storeSettings(QSettings &store, const Settings &settings);

} // namespace skyseal::ui
