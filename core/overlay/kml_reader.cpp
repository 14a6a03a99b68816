#include "core/overlay/kml_reader.h"

#include "core/overlay/overlay_builder.h"

#include <QtCore/QXmlStreamReader>

#include <algorithm>
#include <array>

namespace skyseal::overlay {

namespace {

constexpr std::array kNotDrawn{QLatin1String("Model"),         QLatin1String("Track"),        QLatin1String("GroundOverlay"),
                               QLatin1String("ScreenOverlay"), QLatin1String("PhotoOverlay"), QLatin1String("NetworkLink")};

/// "kml:Point" and "Point" are the same here.
QStringView localName(QStringView name)
{
    return name.mid(name.lastIndexOf(QLatin1Char(':')) + 1);
}

/// Walks over the elements in one loop, so that no depth of a file can exhaust the stack.
class KmlReader
{
public:
    explicit KmlReader(const QByteArray &content) : m_xml(content)
    {
        // Namespaces are looked up in a list, for each attribute: an element may have a million of either.
        m_xml.setNamespaceProcessing(false);
    }

    Result<Overlay, InputError> read();

private:
    void start(QStringView name);
    void end(QStringView name);
    void startGeometry(ShapeKind kind);
    void readCoordinates();
    void takeLine(OverlayLine line);
    void fail(Reason message, qint64 line = 0);

    QXmlStreamReader m_xml;
    OverlayBuilder m_builder;
    int m_depth = 0;
    Reason m_failure; ///< other than that the file is not XML
    qint64 m_failedLine = 0;
    int m_placemark = 0;     ///< depth of the element that is open; 0: none
    std::size_t m_first = 0; ///< shape of the placemark
    QString m_name;          ///< of the placemark
    int m_geometry = 0;      ///< depth
    ShapeKind m_kind = ShapeKind::Point;
    bool m_inHole = false;
    OverlayLine m_line; ///< the outer ring of a polygon
    std::vector<OverlayLine> m_holes;
};

Result<Overlay, InputError> KmlReader::read()
{
    while (!m_xml.atEnd()) {
        switch (m_xml.readNext()) {
        case QXmlStreamReader::StartElement: start(localName(m_xml.qualifiedName())); break;
        case QXmlStreamReader::EndElement: end(localName(m_xml.qualifiedName())); break;
        case QXmlStreamReader::DTD: fail(sentence("Reason", "a document type declaration is not permitted")); break;
        default: break;
        }
    }
    if (m_xml.hasError()) {
        QString message = m_xml.errorString();
        if (message.endsWith(QLatin1Char('.')))
            message.chop(1);
        const qint64 line = m_failedLine ? m_failedLine : m_xml.lineNumber();
        return tl::unexpected(
            InputError{m_failure.empty() ? sentence("Reason", "this is not XML: %1")(message.toStdString()) : m_failure,
                       {},
                       static_cast<std::size_t>(std::max<qint64>(line, 0)),
                       0});
    }
    return m_builder.take();
}

void KmlReader::fail(Reason message, qint64 line)
{
    m_failedLine = line ? line : m_xml.lineNumber();
    m_failure = std::move(message);
    m_xml.raiseError(QString::fromStdString(m_failure.text()));
}

void KmlReader::start(QStringView name)
{
    if (++m_depth > kDeepest)
        return fail(sentence("Reason", "more than %1 elements are within one another")(kDeepest));
    if (m_depth == 1 && name != QLatin1String("kml"))
        return fail(sentence("Reason", "the file begins with the element \"%1\", not with \"kml\"")(
            name.left(40).toString().toStdString()));
    if (name == QLatin1String("Placemark")) {
        m_placemark = m_depth;
        m_first = m_builder.shapes();
        m_name.clear();
    } else if (name == QLatin1String("name") && m_placemark && m_depth == m_placemark + 1) {
        m_name = m_xml.readElementText(QXmlStreamReader::SkipChildElements);
        --m_depth; // its end was read
    } else if (name == QLatin1String("Point")) {
        startGeometry(ShapeKind::Point);
    } else if (name == QLatin1String("LineString") || (name == QLatin1String("LinearRing") && !m_geometry)) {
        startGeometry(ShapeKind::Line);
    } else if (name == QLatin1String("Polygon")) {
        startGeometry(ShapeKind::Polygon);
    } else if (name == QLatin1String("outerBoundaryIs") || name == QLatin1String("innerBoundaryIs")) {
        m_inHole = name.startsWith(QLatin1String("inner"));
    } else if (name == QLatin1String("coordinates") && m_geometry) {
        readCoordinates();
        --m_depth;
    } else if (std::ranges::any_of(kNotDrawn, [name](QLatin1String other) { return name == other; })) {
        m_builder.leaveOut();
    }
}

void KmlReader::startGeometry(ShapeKind kind)
{
    if (m_geometry)
        return fail(sentence("Reason", "a geometry is within another one"));
    m_geometry = m_depth;
    m_kind = kind;
    m_inHole = false;
    m_line.clear();
    m_holes.clear();
}

void KmlReader::end(QStringView name)
{
    if (m_depth == m_geometry) {
        std::vector<OverlayLine> lines{std::move(m_line)};
        std::ranges::move(m_holes, std::back_inserter(lines));
        m_builder.add(m_kind, {}, std::move(lines));
        m_geometry = 0;
    } else if (m_depth == m_placemark && name == QLatin1String("Placemark")) {
        m_builder.nameFrom(m_first, m_name);
        m_placemark = 0;
    }
    --m_depth;
}

/// Tuples "longitude,latitude[,height]" between white space. More numbers are those of a program with decimal commas, whose
/// places would be drawn somewhere else.
void KmlReader::readCoordinates()
{
    const qint64 firstLine = m_xml.lineNumber();
    const QString text = m_xml.readElementText();
    if (m_xml.hasError())
        return;
    const QStringView all(text);
    OverlayLine line;
    qint64 number = firstLine;
    for (qsizetype at = 0; at < all.size();) {
        if (all[at].isSpace()) {
            number += all[at++] == QLatin1Char('\n');
            continue;
        }
        const qsizetype from = at;
        while (at < all.size() && !all[at].isSpace())
            ++at;
        const QStringView tuple = all.mid(from, at - from);
        if (const auto numbers = tuple.count(QLatin1Char(',')) + 1; numbers > 3)
            return fail(sentence("Reason", "\"%1\" has %2 numbers; a position has two or three, with decimal points")(
                            tuple.left(40).toString().toStdString(), numbers),
                        number);
        const auto comma = tuple.indexOf(QLatin1Char(',')), second = tuple.indexOf(QLatin1Char(','), comma + 1);
        bool hasLongitude = false, hasLatitude = false;
        const double longitude = tuple.left(std::max<qsizetype>(comma, 0)).toDouble(&hasLongitude);
        const double latitude = tuple.mid(comma + 1, second < 0 ? -1 : second - comma - 1).toDouble(&hasLatitude);
        if (comma < 0 || !hasLongitude || !hasLatitude)
            return fail(
                sentence("Reason", "\"%1\" is not a position: longitude,latitude")(tuple.left(40).toString().toStdString()),
                number);
        const auto point = m_builder.point(longitude, latitude);
        if (!point)
            return fail(point.error(), number);
        line.push_back(*point);
    }
    takeLine(std::move(line));
}

void KmlReader::takeLine(OverlayLine line)
{
    if (m_inHole) {
        if (!line.empty())
            m_holes.push_back(std::move(line));
        return;
    }
    if (!m_line.empty() || (m_kind == ShapeKind::Point && line.size() > 1))
        return fail(sentence("Reason", "a geometry has more coordinates than one of its kind can have"));
    m_line = std::move(line);
}

} // namespace

Result<Overlay, InputError> readKml(const QByteArray &content)
{
    return KmlReader(content).read();
}

} // namespace skyseal::overlay
