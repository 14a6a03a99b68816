// Files of shapes: by their suffix, within a size, with the name of the file in every error.
#include "core/overlay/overlay_reader.h"
#include "tests/support/test_runner.h"

#include <QtCore/QCryptographicHash>
#include <QtCore/QFile>
#include <QtCore/QTemporaryDir>

using namespace skyseal;
using namespace skyseal::overlay;

class OverlayReaderTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void suffixTellsTheFormat()
    {
        const QByteArray kml("<kml><Point><coordinates>1,2</coordinates></Point></kml>");
        const auto read = readOverlay(fileOf("a.KML", kml));
        QVERIFY(read);
        QCOMPARE(read->overlay.shapes.size(), std::size_t(1));
        QCOMPARE(read->digest, QCryptographicHash::hash(kml, QCryptographicHash::Sha256));
        for (const char *name : {"a.geojson", "a.json"})
            QVERIFY(readOverlay(fileOf(name, R"({"type":"Point","coordinates":[1,2]})")));
    }

    void errorsNameTheFile()
    {
        QCOMPARE(problemOf(fileOf("bad.kml", "<kml>\n<Point><coordinates>1,200</coordinates></Point></kml>")),
                 QStringLiteral("bad.kml:2: the latitude 200 is not within -90 and 90"));
        QCOMPARE(problemOf(fileOf("bad.json", R"({"type":"Point","coordinates":[1]})")),
                 QStringLiteral("bad.json:1: coordinates: this is not a position: [longitude, latitude]"));
        QVERIFY(problemOf(fileOf("a.kmz", "PK")).contains(QStringLiteral("a.kmz: a .kmz is a zip file")));
        QVERIFY(problemOf(fileOf("a.txt", "")).startsWith(QStringLiteral("a.txt: the name ends neither")));
        QVERIFY(
            problemOf(m_folder.filePath(QStringLiteral("none.kml"))).startsWith(QStringLiteral("none.kml: cannot be read: ")));
        QCOMPARE(problemOf(m_folder.path()), QFileInfo(m_folder.path()).fileName() + QStringLiteral(": this is not a file"));
    }

    void sizeIsBounded()
    {
        QFile file(m_folder.filePath(QStringLiteral("large.kml")));
        QVERIFY(file.open(QIODevice::WriteOnly));
        QVERIFY(file.resize(kMostBytes + 1)); // without content on the disk
        file.close();
        QCOMPARE(problemOf(file.fileName()), QStringLiteral("large.kml: the file is larger than 64 MB"));
    }

private:
    QString fileOf(const char *name, const QByteArray &content)
    {
        QFile file(m_folder.filePath(QLatin1String(name)));
        if (file.open(QIODevice::WriteOnly))
            file.write(content);
        return file.fileName();
    }

    static QString problemOf(const QString &path)
    {
        const auto read = readOverlay(path);
        return read ? QString() : QString::fromStdString(read.error().text());
    }

    QTemporaryDir m_folder;
};

SKYSEAL_TEST(OverlayReaderTest)
#include "overlay_reader_test.moc"
