// The settings of the operator as one value, stored by QSettings. Only the window reads and writes them; panels receive the
// values that they need.
#pragma once

#include "core/crypto/suite.h"
#include "core/mavlink/enums.h"
#include "ui/text/coordinates.h"
#include "ui/text/units.h"
#include "ui/theme/palettes.h"
#include "ui/track_colors.h"
#include "ui/value_choice.h"

#include <QtCore/QString>

class QSettings;

namespace skyseal::ui {

/// Heights in metres above home that a take-off can be commanded to.
inline constexpr double kLowestTakeOff = 1, kHighestTakeOff = 500;

/// Whether and where other ground stations use the vehicles through this one.
struct Serving
{
    bool on = false;
    /// Addresses with spaces between, each as of skyseal-cli gateway --serve.
    QString url = QStringLiteral("tcpin:127.0.0.1:5790");
    bool write = false; ///< they may command; else they only read

    bool operator==(const Serving &) const = default;
};

/// Where the pictures of the map come from: nowhere, until the operator has chosen a source. A tile server learns where its
/// maps are looked at.
struct MapSource
{
    enum class Kind : int { None, Server, File };

    Kind kind = Kind::None;
    QString url;         ///< of the server: "https://tile.example.org/{z}/{x}/{y}.png"
    QString file;        ///< MBTiles or GeoPackage
    QString attribution; ///< of the server, shown on the map
    int deepest = 19;    ///< level of the server's largest pictures

    bool operator==(const MapSource &) const = default;
};

struct Settings
{
    QString language; ///< code of one of languages(); else that of the desktop
    Theme theme = Theme::Desktop;
    bool touchSized = false; ///< controls are large enough for fingers
    UnitSystem units = UnitSystem::Metric;
    CoordinateFormat coordinates = CoordinateFormat::Decimal;
    bool speakAlerts = false;
    int systemId = 255;
    int componentId = mavlink::MAV_COMP_ID_MISSIONPLANNER;
    bool record = true;
    QString recordFolder; ///< empty = the application's own folder
    bool allowResearch = false;
    crypto::SuiteId weakestSuite = crypto::weakestSealedSuite(); ///< weakest suite that is offered
    bool requireSealed = false;                                  ///< plain MAVLink is never shown
    double takeOffAltitude = 10;                                 ///< metres above home, last used
    QString defaultLink = QStringLiteral("udpin:0.0.0.0:14550");
    Serving serving;
    MapSource map;
    bool rotateMap = false; ///< with the vehicle
    TrackColors trackColors = TrackColors::Suite;
    ChosenValues values; ///< of the grid in Fly

    bool operator==(const Settings &) const = default;
};

/// Missing or invalid values get their defaults.
Settings loadSettings(const QSettings &store);
/// Apart, because the language is needed before anything that makes texts, as loadSettings() may.
QString storedLanguage(const QSettings &store);
void storeSettings(QSettings &store, const Settings &settings);

} // namespace skyseal::ui
