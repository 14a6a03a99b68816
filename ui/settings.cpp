#include "ui/settings.h"

#include <QtCore/QSettings>

namespace skyseal::ui {

namespace {

int inRange(const QSettings &store, const char *key, int low, int high, int otherwise)
{
    bool ok = false;
    const int value = store.value(QLatin1String(key), otherwise).toInt(&ok);
    return ok && value >= low && value <= high ? value : otherwise;
}

double inRange(const QSettings &store, const char *key, double low, double high, double otherwise)
{
    bool ok = false;
    const double value = store.value(QLatin1String(key), otherwise).toDouble(&ok);
    return ok && value >= low && value <= high ? value : otherwise;
}

MapSource loadMapSource(const QSettings &store)
{
    MapSource out;
    out.kind = static_cast<MapSource::Kind>(inRange(store, "map/source", 0, 2, 0));
    out.url = store.value(QStringLiteral("map/url")).toString();
    out.file = store.value(QStringLiteral("map/file")).toString();
    out.attribution = store.value(QStringLiteral("map/attribution")).toString();
    out.deepest = inRange(store, "map/deepest", 1, 22, out.deepest);
    return out;
}

ChosenValues loadValues(const QSettings &store)
{
    const QString text = store.value(QStringLiteral("view/values")).toString();
    if (text.isEmpty())
        return {};
    auto read = readValueChoices(text);
    return read ? ChosenValues{std::move(*read)} : ChosenValues{.problem = read.error()};
}

} // namespace

QString storedLanguage(const QSettings &store)
{
    return store.value(QStringLiteral("view/language")).toString();
}

Settings loadSettings(const QSettings &store)
{
    Settings s;
    s.language = storedLanguage(store);
    s.theme = static_cast<Theme>(inRange(store, "view/theme", 0, 3, static_cast<int>(s.theme)));
    s.touchSized = store.value(QStringLiteral("view/touchSized"), s.touchSized).toBool();
    s.units = static_cast<UnitSystem>(inRange(store, "view/units", 0, 2, static_cast<int>(s.units)));
    s.coordinates = static_cast<CoordinateFormat>(inRange(store, "view/coordinates", 0, 3, static_cast<int>(s.coordinates)));
    s.speakAlerts = store.value(QStringLiteral("view/speakAlerts"), s.speakAlerts).toBool();
    s.systemId = inRange(store, "station/systemId", 1, 255, s.systemId);
    s.componentId = inRange(store, "station/componentId", 1, 255, s.componentId);
    s.record = store.value(QStringLiteral("log/record"), s.record).toBool();
    s.recordFolder = store.value(QStringLiteral("log/folder")).toString();
    s.allowResearch = store.value(QStringLiteral("security/allowResearch"), s.allowResearch).toBool();
    const std::string weakest = store.value(QStringLiteral("security/weakestSuite")).toString().toStdString();
    if (const auto suite = crypto::suiteFromName(weakest); suite && *suite != crypto::SuiteId::None)
        s.weakestSuite = *suite;
    s.requireSealed = store.value(QStringLiteral("security/requireSealed"), s.requireSealed).toBool();
    s.takeOffAltitude = inRange(store, "flight/takeOffAltitude", kLowestTakeOff, kHighestTakeOff, s.takeOffAltitude);
    const QString link = store.value(QStringLiteral("link/default")).toString();
    if (!link.isEmpty())
        s.defaultLink = link;
    s.serving.on = store.value(QStringLiteral("gateway/on"), s.serving.on).toBool();
    const QString served = store.value(QStringLiteral("gateway/url")).toString();
    if (!served.isEmpty())
        s.serving.url = served;
    s.map = loadMapSource(store);
    s.trackColors = static_cast<TrackColors>(inRange(store, "map/track", 0, 3, static_cast<int>(s.trackColors)));
    s.rotateMap = store.value(QStringLiteral("map/rotate"), s.rotateMap).toBool();
    s.values = loadValues(store);
    // Rights of a gateway that is off are chosen anew when it is turned on.
    s.serving.write = s.serving.on && store.value(QStringLiteral("gateway/write"), s.serving.write).toBool();
    return s;
}

void storeSettings(QSettings &store, const Settings &settings)
{
    store.setValue(QStringLiteral("view/language"), settings.language);
    store.setValue(QStringLiteral("view/theme"), static_cast<int>(settings.theme));
    store.setValue(QStringLiteral("view/touchSized"), settings.touchSized);
    store.setValue(QStringLiteral("view/units"), static_cast<int>(settings.units));
    store.setValue(QStringLiteral("view/coordinates"), static_cast<int>(settings.coordinates));
    store.setValue(QStringLiteral("view/speakAlerts"), settings.speakAlerts);
    store.setValue(QStringLiteral("station/systemId"), settings.systemId);
    store.setValue(QStringLiteral("station/componentId"), settings.componentId);
    store.setValue(QStringLiteral("log/record"), settings.record);
    store.setValue(QStringLiteral("log/folder"), settings.recordFolder);
    store.setValue(QStringLiteral("security/allowResearch"), settings.allowResearch);
    const std::string_view weakest = crypto::suiteInfo(settings.weakestSuite).name;
    store.setValue(QStringLiteral("security/weakestSuite"),
                   QString::fromLatin1(weakest.data(), static_cast<qsizetype>(weakest.size())));
    store.setValue(QStringLiteral("security/requireSealed"), settings.requireSealed);
    store.setValue(QStringLiteral("flight/takeOffAltitude"), settings.takeOffAltitude);
    store.setValue(QStringLiteral("link/default"), settings.defaultLink);
    store.setValue(QStringLiteral("gateway/on"), settings.serving.on);
    store.setValue(QStringLiteral("gateway/url"), settings.serving.url);
    store.setValue(QStringLiteral("gateway/write"), settings.serving.write);
    store.setValue(QStringLiteral("map/source"), static_cast<int>(settings.map.kind));
    store.setValue(QStringLiteral("map/url"), settings.map.url);
    store.setValue(QStringLiteral("map/file"), settings.map.file);
    store.setValue(QStringLiteral("map/attribution"), settings.map.attribution);
    store.setValue(QStringLiteral("map/deepest"), settings.map.deepest);
    store.setValue(QStringLiteral("map/rotate"), settings.rotateMap);
    store.setValue(QStringLiteral("map/track"), static_cast<int>(settings.trackColors));
    if (settings.values.problem.isEmpty()) // else what cannot be read stays until the operator has chosen again
        store.setValue(QStringLiteral("view/values"), toText(settings.values.list));
}

} // namespace skyseal::ui
