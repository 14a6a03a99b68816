// The cache of indexes: what was stored comes back, and a file that is damaged, of another version or too large holds nothing.
#include "core/engine/replay/index_cache.h"
#include "tests/support/test_runner.h"

#include <QtCore/QFile>
#include <QtCore/QTemporaryDir>
#include <QtTest/QTest>

#include <sys/stat.h>

using namespace skyseal;
using namespace skyseal::engine;
using namespace std::chrono_literals;

namespace {

/// Every field has a value of its own.
RecordingInfo recordingOf(int number)
{
    tlog::LogIndex index;
    index.first = WallTime(1'700'000'000s + std::chrono::seconds(number));
    index.length = 900s + 7ns;
    index.frames = 54'000;
    index.damaged = 1;
    index.vehicles = {1, 200};
    index.modes = {{10s, 1, 2, 3, 209, 4'000'000'000u}, {20s, 200, 13, 12, 81, 0}};
    index.armed = {{{30s, 40s}, 1}};
    index.gaps = {{50s, 60s}, {70s, 80s}};
    using enum tlog::LinkEvent::Kind;
    index.suites = {{90s, {Sealed, *index.first, "aes-256-gcm", "air-1"}}, {95s, {Switched, {}, "rc4", "\xc3\xa4"}}};
    index.unreadableEvents = 5;
    index.omitted = 6;
    RecordingInfo out{"/logs/" + std::to_string(number) + ".tlog", std::to_string(number) + ".tlog"};
    out.bytes = 1'234'567'890'123;
    out.eventBytes = 77;
    out.modified = WallTime(1'800'000'000s + 3us);
    out.index = std::make_shared<const tlog::LogIndex>(std::move(index));
    return out;
}

} // namespace

class IndexCacheTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void init()
    {
        m_folder = std::make_unique<QTemporaryDir>();
        m_file = m_folder->filePath(QStringLiteral("made/by/it/recordings.index")).toStdString();
    }

    void whatIsStoredComesBack()
    {
        const mode_t before = umask(0);
        QVERIFY(saveIndexes(m_file, {recordingOf(1), recordingOf(2)}));
        umask(before);
        const std::vector<RecordingInfo> loaded = loadIndexes(m_file);
        QCOMPARE(loaded.size(), std::size_t(2));
        for (int i = 0; i < 2; ++i) {
            const RecordingInfo expected = recordingOf(i + 1), &one = loaded[static_cast<std::size_t>(i)];
            QCOMPARE(one.path, expected.path);
            QCOMPARE(one.name, expected.name);
            QCOMPARE(one.bytes, expected.bytes);
            QCOMPARE(one.eventBytes, expected.eventBytes);
            QVERIFY(one.modified == expected.modified);
            QVERIFY(*one.index == *expected.index);
        }
        QVERIFY(!(QFile::permissions(QString::fromStdString(m_file)) & (QFile::ReadGroup | QFile::ReadOther)));
    }

    void emptyIndexComesBack()
    {
        RecordingInfo one = recordingOf(1);
        one.index = std::make_shared<const tlog::LogIndex>();
        QVERIFY(saveIndexes(m_file, {one}));
        QVERIFY(*loadIndexes(m_file).at(0).index == tlog::LogIndex());
    }

    void recordingWithoutIndexIsLeftOut()
    {
        RecordingInfo unread = recordingOf(1);
        unread.index.reset();
        QVERIFY(saveIndexes(m_file, {unread, recordingOf(2)}));
        QCOMPARE(loadIndexes(m_file).at(0).name, std::string("2.tlog"));
    }

    void missingFileHoldsNothing() { QVERIFY(loadIndexes(m_file).empty()); }

    void damagedFileHoldsNothing()
    {
        QVERIFY(saveIndexes(m_file, {recordingOf(1)}));
        const QByteArray whole = content();
        for (qsizetype i = 0; i < whole.size(); ++i) {
            QByteArray flipped = whole;
            flipped[i] = static_cast<char>(flipped[i] ^ 0x10);
            write(flipped);
            QVERIFY2(loadIndexes(m_file).empty(), qPrintable(QString::number(i)));
            write(whole.left(i));
            QVERIFY2(loadIndexes(m_file).empty(), qPrintable(QString::number(i)));
        }
        write(whole);
        QCOMPARE(loadIndexes(m_file).size(), std::size_t(1));
    }

    void fileIsBounded()
    {
        const std::vector<RecordingInfo> many(IndexCache::kMostRecordings + 10, recordingOf(1));
        QVERIFY(saveIndexes(m_file, many));
        QCOMPARE(loadIndexes(m_file).size(), IndexCache::kMostRecordings);
        tlog::LogIndex large;
        large.suites.assign(tlog::LogIndex::kListed, {{}, {{}, {}, std::string(40, 's'), std::string(100, 'p')}});
        RecordingInfo one = recordingOf(1);
        one.index = std::make_shared<const tlog::LogIndex>(large);
        QVERIFY(saveIndexes(m_file, std::vector<RecordingInfo>(200, one)));
        QVERIFY(QFile(QString::fromStdString(m_file)).size() <= static_cast<qint64>(IndexCache::kMostBytes));
        const std::size_t kept = loadIndexes(m_file).size();
        QVERIFY(kept > 10 && kept < 200);
    }

    void largerFileHoldsNothing()
    {
        QVERIFY(saveIndexes(m_file, {recordingOf(1)}));
        write(content() + QByteArray(IndexCache::kMostBytes, '\0'));
        QVERIFY(loadIndexes(m_file).empty());
    }

    void folderThatCannotBeMadeIsAnError() { QVERIFY(!saveIndexes("/dev/null/cache/recordings.index", {recordingOf(1)})); }

private:
    QByteArray content() const
    {
        QFile file(QString::fromStdString(m_file));
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    }
    void write(const QByteArray &bytes) const
    {
        QFile file(QString::fromStdString(m_file));
        QVERIFY(file.open(QIODevice::WriteOnly));
        QCOMPARE(file.write(bytes), bytes.size());
    }

    std::unique_ptr<QTemporaryDir> m_folder;
    std::string m_file;
};

SKYSEAL_TEST_APPLESS(IndexCacheTest)
#include "index_cache_test.moc"
