// The thread that reads the recordings of a folder: all of them, the newest first, and none twice.
#include "app/skyseal/recording_list.h"
#include "core/engine/replay/index_cache.h"
#include "tests/log/recordings.h"
#include "tests/support/eventually.h"
#include "tests/support/test_runner.h"

#include <QtCore/QTemporaryDir>
#include <QtTest/QTest>

#include <filesystem>
#include <fstream>

using namespace skyseal;
using engine::RecordingInfo;

class RecordingListTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void init()
    {
        m_folder = std::make_unique<QTemporaryDir>();
        start({});
    }

    void manyAreReadAndKept()
    {
        constexpr int kMany = 500;
        for (int i = 0; i < kMany; ++i)
            write(QStringLiteral("%1.tlog").arg(i), 3 + i % 5);
        write(QStringLiteral("notes.txt"), 1);
        list();
        EVENTUALLY_EQUAL(m_read.size(), std::size_t(kMany));
        QCOMPARE(m_listings.at(0).size(), std::size_t(kMany));
        for (std::size_t i = 0; i < m_read.size(); ++i) {
            QCOMPARE(m_read[i].path, m_listings[0][i].path); // in the order of the list
            QVERIFY(m_read[i].index && m_read[i].index->frames >= 3);
        }
        write(QStringLiteral("7.tlog"), 60); // has grown
        list();
        EVENTUALLY_EQUAL(m_read.size(), std::size_t(kMany + 1));
        QCOMPARE(m_read.back().name, std::string("7.tlog"));
        QCOMPARE(m_read.back().index->frames, std::uint64_t(60));
        QCOMPARE(std::ranges::count_if(m_listings.at(1), &RecordingInfo::isRead), kMany - 1);
    }

    void isReadAgainWhenTheFileBesideItHasGrown()
    {
        write(QStringLiteral("a.tlog"), 3);
        list();
        EVENTUALLY_EQUAL(m_read.size(), std::size_t(1));
        QVERIFY(m_read[0].index->suites.empty());
        const tlog::LinkEvent event{tlog::LinkEvent::Kind::Sealed, tlog::kNoon, "aes-256-gcm", "air-1"};
        std::ofstream(m_folder->filePath(QStringLiteral("a.tlog.events")).toStdString()) << tlog::lineOf(event);
        list();
        EVENTUALLY_EQUAL(m_read.size(), std::size_t(2));
        QCOMPARE(m_listings.back().size(), std::size_t(1)); // the other file is no recording
        QCOMPARE(m_read[1].index->suites.size(), std::size_t(1));
    }

    void newestIsFirst()
    {
        write(QStringLiteral("a.tlog"), 1);
        write(QStringLiteral("b.tlog"), 1);
        const auto old = std::filesystem::file_time_type::clock::now() - std::chrono::hours(5);
        std::filesystem::last_write_time(m_folder->filePath(QStringLiteral("b.tlog")).toStdString(), old);
        list();
        EVENTUALLY_EQUAL(m_listings.size(), std::size_t(1));
        QCOMPARE(m_listings[0][0].name, std::string("a.tlog"));
    }

    void missingFolderHasNone()
    {
        m_recordings->list("/no/such/folder");
        EVENTUALLY_EQUAL(m_listings.size(), std::size_t(1));
        QVERIFY(m_listings[0].empty());
    }

    void unreadableFileSaysWhy()
    {
        write(QStringLiteral("gone.tlog"), 1);
        list();
        EVENTUALLY_EQUAL(m_listings.size(), std::size_t(1));
        QFile::remove(m_folder->filePath(QStringLiteral("gone.tlog")));
        EVENTUALLY_EQUAL(m_read.size(), std::size_t(1)); // before or after it was removed
        QVERIFY(m_read[0].isRead());
    }

    void nextStartReadsOnlyWhatHasChanged()
    {
        for (const char *name : {"a.tlog", "b.tlog", "c.tlog"})
            write(QLatin1String(name), 3);
        startAgain();
        list();
        EVENTUALLY_EQUAL(m_read.size(), std::size_t(3));
        startAgain();
        write(QStringLiteral("b.tlog"), 60);
        QVERIFY(QFile::remove(m_folder->filePath(QStringLiteral("c.tlog"))));
        list();
        EVENTUALLY_EQUAL(m_read.size(), std::size_t(1));
        QCOMPARE(m_read[0].name, std::string("b.tlog"));
        QCOMPARE(m_listings.at(0).size(), std::size_t(2));
        QCOMPARE(std::ranges::count_if(m_listings[0], &RecordingInfo::isRead), 1);
        startAgain();
        list();
        EVENTUALLY_EQUAL(m_listings.size(), std::size_t(1));
        for (const RecordingInfo &one : m_listings[0])
            QCOMPARE(one.index ? one.index->frames : 0, std::uint64_t(one.name == "b.tlog" ? 60 : 3));
        QVERIFY(m_read.empty());
        m_recordings.reset();                                              // waits for the file
        QCOMPARE(engine::loadIndexes(cacheFile()).size(), std::size_t(2)); // the deleted one is forgotten
    }

    void damagedCacheIsMadeAgain()
    {
        write(QStringLiteral("a.tlog"), 3);
        QFile cache(QString::fromStdString(cacheFile()));
        QVERIFY(cache.open(QIODevice::WriteOnly) && cache.write("no index") > 0);
        cache.close();
        startAgain();
        list();
        EVENTUALLY_EQUAL(m_read.size(), std::size_t(1));
        startAgain();
        list();
        EVENTUALLY_EQUAL(m_listings.size(), std::size_t(1));
        QVERIFY(m_listings[0].at(0).index && m_read.empty());
    }

    void whatWasReadBeforeTheStopIsKept()
    {
        for (int i = 0; i < 50; ++i)
            write(QStringLiteral("%1.tlog").arg(i), 100);
        startAgain();
        connect(m_recordings.get(), &app::RecordingList::read, this, [this] {
            if (m_read.size() == 3)
                m_recordings->stop();
        });
        list();
        EVENTUALLY_EQUAL(m_read.size(), std::size_t(3));
        startAgain();
        list();
        EVENTUALLY_EQUAL(m_listings.size(), std::size_t(1));
        QCOMPARE(std::ranges::count_if(m_listings[0], &RecordingInfo::isRead), 3);
    }

    void stoppedListingReportsNothingMore()
    {
        write(QStringLiteral("a.tlog"), 1000);
        list();
        m_recordings->stop();
        m_recordings->list("/no/such/folder"); // runs after what was stopped
        EVENTUALLY(!m_listings.empty());
        QCOMPARE(m_listings.size(), std::size_t(1));
        QVERIFY(m_listings[0].empty() && m_read.empty());
    }

private:
    void start(const std::string &cache)
    {
        m_recordings = std::make_unique<app::RecordingList>(cache);
        m_listings.clear();
        m_read.clear();
        connect(m_recordings.get(), &app::RecordingList::listed, this,
                [this](const std::vector<RecordingInfo> &all) { m_listings.push_back(all); });
        connect(m_recordings.get(), &app::RecordingList::read, this,
                [this](const RecordingInfo &one) { m_read.push_back(one); });
    }
    /// As another start of the program.
    void startAgain()
    {
        m_recordings.reset(); // waits for the file
        start(cacheFile());
    }
    std::string cacheFile() const { return m_folder->filePath(QStringLiteral("recordings.index")).toStdString(); }
    void list() { m_recordings->list(m_folder->path().toStdString()); }
    void write(const QString &name, int frames)
    {
        std::ofstream file(m_folder->filePath(name).toStdString(), std::ios::binary);
        for (int i = 0; i < frames; ++i)
            file << tlog::entry(tlog::kNoon + std::chrono::seconds(i), tlog::heartbeat(static_cast<std::uint32_t>(i)));
    }

    std::unique_ptr<QTemporaryDir> m_folder;
    std::unique_ptr<app::RecordingList> m_recordings;
    std::vector<std::vector<RecordingInfo>> m_listings;
    std::vector<RecordingInfo> m_read;
};

SKYSEAL_TEST(RecordingListTest)
#include "recording_list_test.moc"
