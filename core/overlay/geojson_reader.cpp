#include "core/overlay/geojson_reader.h"

#include "core/overlay/overlay_builder.h"

#include <QtCore/QJsonArray>
#include <QtCore/QJsonDocument>
#include <QtCore/QJsonObject>
#include <QtCore/QStringList>

#include <algorithm>

namespace skyseal::overlay {

namespace {

/// Arrays, objects and their values. A parsed value takes up to about eighty bytes, and a file might consist of "[],[],[]".
constexpr std::size_t kMostValues = 4'000'000;

/// A problem in a member of an object, or in an element of an array.
struct JsonProblem
{
    QString path; ///< from where it is known on: ".geometry.coordinates[12]"
    Reason message;
};

template<typename T> using Checked = Result<T, JsonProblem>;

tl::unexpected<JsonProblem> problem(const Reason &message)
{
    return tl::unexpected(JsonProblem{{}, message});
}

tl::unexpected<JsonProblem> within(const QString &member, JsonProblem found)
{
    found.path.prepend(QLatin1Char('.') + member);
    return tl::unexpected(std::move(found));
}

tl::unexpected<JsonProblem> within(qsizetype element, JsonProblem found)
{
    found.path.prepend(QStringLiteral("[%1]").arg(element));
    return tl::unexpected(std::move(found));
}

bool hasTooManyValues(const QByteArray &content)
{
    std::size_t values = 0;
    bool inString = false;
    for (qsizetype i = 0; i < content.size(); ++i) {
        const char c = content[i];
        if (c == '"')
            inString = !inString;
        else if (inString)
            i += c == '\\';
        else
            values += c == '[' || c == '{' || c == ',';
    }
    return values > kMostValues;
}

/// Files from before RFC 7946 may name another system; read as degrees, an area would be somewhere else.
Checked<void> checkSystem(const QJsonObject &root)
{
    const QString name = root[QLatin1String("crs")][QLatin1String("properties")][QLatin1String("name")].toString();
    if (name.isEmpty() || name.contains(QLatin1String("CRS84")) || name.endsWith(QLatin1String(":4326")))
        return {};
    return within(QStringLiteral("crs"),
                  {{}, sentence("Reason", "the coordinates are not in WGS84, but in \"%1\"")(name.left(60).toStdString())});
}

QString nameOf(const QJsonObject &feature)
{
    const QJsonObject properties = feature[QLatin1String("properties")].toObject();
    for (const char *key : {"name", "Name", "NAME", "title"})
        if (QString name = properties[QLatin1String(key)].toString(); !name.isEmpty())
            return name;
    return {};
}

class GeoJsonReader
{
public:
    Checked<void> readObject(const QJsonObject &object, const QString &name, int depth);
    Overlay take() { return m_builder.take(); }

private:
    Checked<void> readAll(const QJsonObject &object, const QString &member, const QString &name, int depth);
    Checked<void> readGeometry(const QString &type, const QJsonObject &object, const QString &name);
    Checked<void> readCoordinates(const QString &type, const QJsonValue &coordinates, const QString &name);
    Checked<void> addPolygons(const QJsonValue &value, const QString &name);
    Checked<OverlayPoint> pointOf(const QJsonValue &value);
    Checked<OverlayLine> lineOf(const QJsonValue &value);
    Checked<std::vector<OverlayLine>> linesOf(const QJsonValue &value);
    Checked<void> addPolygon(const QJsonValue &value, const QString &name);

    OverlayBuilder m_builder;
};

Checked<void> GeoJsonReader::readObject(const QJsonObject &object, const QString &name, int depth)
{
    const QString type = object[QLatin1String("type")].toString();
    if (type == QLatin1String("FeatureCollection"))
        return readAll(object, QStringLiteral("features"), name, depth);
    if (type == QLatin1String("GeometryCollection"))
        return readAll(object, QStringLiteral("geometries"), name, depth);
    if (type == QLatin1String("Feature")) {
        const QString geometry = QStringLiteral("geometry");
        const QJsonValue value = object[geometry];
        if (value.isNull()) {
            m_builder.leaveOut();
            return {};
        }
        if (depth >= kDeepest)
            return problem(sentence("Reason", "more than %1 objects are within one another")(kDeepest));
        if (!value.isObject())
            return within(geometry, {{}, sentence("Reason", "this is not an object")});
        if (auto read = readObject(value.toObject(), nameOf(object), depth + 1); !read)
            return within(geometry, std::move(read.error()));
        return {};
    }
    return readGeometry(type, object, name);
}

Checked<void> GeoJsonReader::readAll(const QJsonObject &object, const QString &member, const QString &name, int depth)
{
    if (depth >= kDeepest)
        return problem(sentence("Reason", "more than %1 objects are within one another")(kDeepest));
    if (!object[member].isArray())
        return within(member, {{}, sentence("Reason", "this is not an array")});
    const QJsonArray array = object[member].toArray();
    for (qsizetype i = 0; i < array.size(); ++i) {
        const QJsonValue value = array.at(i);
        auto read = value.isObject() ? readObject(value.toObject(), name, depth + 1)
                                     : Checked<void>(problem(sentence("Reason", "this is not an object")));
        if (!read)
            return within(member, within(i, std::move(read.error())).value());
    }
    return {};
}

Checked<void> GeoJsonReader::readGeometry(const QString &type, const QJsonObject &object, const QString &name)
{
    static const QStringList kTypes{QStringLiteral("Point"),      QStringLiteral("MultiPoint"),
                                    QStringLiteral("LineString"), QStringLiteral("MultiLineString"),
                                    QStringLiteral("Polygon"),    QStringLiteral("MultiPolygon")};
    if (!kTypes.contains(type))
        return within(QStringLiteral("type"),
                      {{}, sentence("Reason", "\"%1\" is not a type of GeoJSON")(type.left(40).toStdString())});
    const QString coordinates = QStringLiteral("coordinates");
    if (auto read = readCoordinates(type, object[coordinates], name); !read)
        return within(coordinates, std::move(read.error()));
    return {};
}

Checked<void> GeoJsonReader::readCoordinates(const QString &type, const QJsonValue &coordinates, const QString &name)
{
    if (!coordinates.isArray())
        return problem(sentence("Reason", "this is not an array"));
    if (coordinates.toArray().isEmpty()) { // a geometry without a place, as section 3.1 permits
        m_builder.leaveOut();
        return {};
    }
    if (type == QLatin1String("Point"))
        return pointOf(coordinates).map([&](const OverlayPoint &point) { m_builder.add(ShapeKind::Point, name, {{point}}); });
    if (type == QLatin1String("MultiPoint"))
        return lineOf(coordinates).map([&](const OverlayLine &line) {
            for (const OverlayPoint &point : line)
                m_builder.add(ShapeKind::Point, name, {{point}});
        });
    if (type == QLatin1String("LineString"))
        return lineOf(coordinates).map([&](OverlayLine line) { m_builder.add(ShapeKind::Line, name, {std::move(line)}); });
    if (type == QLatin1String("MultiLineString"))
        return linesOf(coordinates).map([&](std::vector<OverlayLine> lines) {
            for (OverlayLine &line : lines)
                m_builder.add(ShapeKind::Line, name, {std::move(line)});
        });
    return type == QLatin1String("Polygon") ? addPolygon(coordinates, name) : addPolygons(coordinates, name);
}

Checked<void> GeoJsonReader::addPolygons(const QJsonValue &value, const QString &name)
{
    const QJsonArray polygons = value.toArray();
    for (qsizetype i = 0; i < polygons.size(); ++i)
        if (auto added = addPolygon(polygons.at(i), name); !added)
            return within(i, std::move(added.error()));
    return {};
}

Checked<OverlayPoint> GeoJsonReader::pointOf(const QJsonValue &value)
{
    const QJsonArray numbers = value.toArray();
    if (numbers.size() > 3)
        return problem(sentence("Reason", "a position has two or three numbers, not %1")(numbers.size()));
    if (numbers.size() < 2 || !numbers.at(0).isDouble() || !numbers.at(1).isDouble())
        return problem(sentence("Reason", "this is not a position: [longitude, latitude]"));
    return m_builder.point(numbers.at(0).toDouble(), numbers.at(1).toDouble()).map_error([](const Reason &message) {
        return JsonProblem{{}, message};
    });
}

Checked<OverlayLine> GeoJsonReader::lineOf(const QJsonValue &value)
{
    if (!value.isArray())
        return problem(sentence("Reason", "this is not an array of positions"));
    const QJsonArray positions = value.toArray();
    OverlayLine out;
    for (qsizetype i = 0; i < positions.size(); ++i) {
        auto point = pointOf(positions.at(i));
        if (!point)
            return within(i, std::move(point.error()));
        out.push_back(*point);
    }
    return out;
}

Checked<std::vector<OverlayLine>> GeoJsonReader::linesOf(const QJsonValue &value)
{
    if (!value.isArray())
        return problem(sentence("Reason", "this is not an array of lines"));
    const QJsonArray lines = value.toArray();
    std::vector<OverlayLine> out;
    for (qsizetype i = 0; i < lines.size(); ++i) {
        auto line = lineOf(lines.at(i));
        if (!line)
            return within(i, std::move(line.error()));
        out.push_back(std::move(*line));
    }
    return out;
}

Checked<void> GeoJsonReader::addPolygon(const QJsonValue &value, const QString &name)
{
    return linesOf(value).map(
        [&](std::vector<OverlayLine> rings) { m_builder.add(ShapeKind::Polygon, name, std::move(rings)); });
}

InputError errorAt(Reason message, std::size_t line = 0)
{
    return {std::move(message), {}, line, 0};
}

/// Finds values in a valid JSON text, of which QJsonDocument does not say where they stand.
class JsonText
{
public:
    explicit JsonText(const QByteArray &content) : m_content(content) {}

    /// The 1-based line of the value at this path of members (".name") and elements ("[3]"), or of what would contain it.
    std::size_t lineOf(QStringView path)
    {
        m_at = 0;
        m_line = 0;
        while (!path.isEmpty()) {
            qsizetype end = 1;
            while (end < path.size() && path[end] != QLatin1Char('.') && path[end] != QLatin1Char('['))
                ++end;
            const bool isElement = path[0] == QLatin1Char('[');
            const QStringView step = path.mid(1, end - (isElement ? 2 : 1));
            if (!(isElement ? enterElement(step.toLongLong()) : enterMember(step.toUtf8())))
                break;
            path = path.mid(end);
        }
        skipBlanks();
        return m_line + 1;
    }

private:
    char now() const { return m_at < m_content.size() ? m_content[m_at] : '\0'; }
    void step()
    {
        m_line += now() == '\n';
        ++m_at;
    }
    void skipBlanks()
    {
        while (m_at < m_content.size() && (now() == ' ' || now() == '\t' || now() == '\r' || now() == '\n'))
            step();
    }
    void skipString()
    {
        for (step(); m_at < m_content.size() && now() != '"'; step()) {
            if (now() == '\\')
                step();
        }
        step();
    }
    /// With everything in it, up to the comma or bracket behind it.
    void skipValue()
    {
        int depth = 0;
        for (skipBlanks(); m_at < m_content.size();) {
            const char c = now();
            if (depth == 0 && (c == ',' || c == ']' || c == '}'))
                return;
            depth += (c == '[' || c == '{') - (c == ']' || c == '}');
            c == '"' ? skipString() : step();
        }
    }
    bool enterElement(qlonglong index)
    {
        skipBlanks();
        step();
        for (; index > 0; --index) {
            skipValue();
            step();
        }
        return true;
    }
    /// False, and back at the object, if it has no such member.
    bool enterMember(const QByteArray &name)
    {
        skipBlanks();
        const auto object = m_at;
        const auto line = m_line;
        do {
            step(); // the brace, or a comma
            skipBlanks();
            const qsizetype from = m_at + 1;
            if (now() != '"')
                break; // the object is empty
            skipString();
            const bool found = m_content.mid(from, m_at - 1 - from) == name;
            skipBlanks();
            step(); // the colon
            if (found)
                return true;
            skipValue();
        } while (now() == ',');
        m_at = object;
        m_line = line;
        return false;
    }

    const QByteArray &m_content;
    qsizetype m_at = 0;
    std::size_t m_line = 0;
};

} // namespace

Result<Overlay, InputError> readGeoJson(const QByteArray &content)
{
    if (hasTooManyValues(content))
        return tl::unexpected(errorAt(sentence("Reason", "the file has more than %1 values")(kMostValues)));
    QJsonParseError parsed;
    const QJsonDocument document = QJsonDocument::fromJson(content, &parsed);
    if (parsed.error != QJsonParseError::NoError) {
        const auto lines = std::count(content.begin(),
                                      content.begin() + std::clamp<qsizetype>(parsed.offset, 0, content.size()), '\n');
        return tl::unexpected(errorAt(sentence("Reason", "this is not JSON: %1")(parsed.errorString().toStdString()),
                                      static_cast<std::size_t>(lines) + 1));
    }
    if (!document.isObject())
        return tl::unexpected(errorAt(sentence("Reason", "the file has no JSON object")));
    GeoJsonReader reader;
    const QJsonObject root = document.object();
    const auto read = checkSystem(root).and_then([&] { return reader.readObject(root, {}, 0); });
    if (!read)
        return tl::unexpected(
            errorAt(sentence("Reason", "%1: %2")(read.error().path.mid(1).toStdString(), read.error().message),
                    JsonText(content).lineOf(read.error().path)));
    return reader.take();
}

} // namespace skyseal::overlay
