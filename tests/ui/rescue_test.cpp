// After a crash: the marker of a run that ended without removing it is found by the next start, which offers the recording, cut
// in the middle of a frame as it may be, and the links. A run that lives, or ended properly, is never reported.
#include "app/skyseal/application.h"
#include "app/skyseal/run_marker.h"
#include "core/crypto/init_crypto.h"
#include "core/crypto/system_random.h"
#include "core/engine/station/snapshot.h"
#include "fake_station.h"
#include "tests/log/recordings.h"
#include "tests/support/eventually.h"
#include "tests/support/test_runner.h"
#include "ui/window/main_window.h"

#include <QtCore/QDir>
#include <QtCore/QFile>
#include <QtCore/QTemporaryDir>
#include <QtTest/QTest>
#include <QtWidgets/QApplication>
#include <QtWidgets/QFrame>
#include <QtWidgets/QPushButton>

using namespace skyseal;
using namespace skyseal::app;

namespace {

QStringList markersIn(const QString &folder)
{
    return QDir(folder).entryList(QDir::Files);
}

void writeFile(const QString &path, const QByteArray &content)
{
    QDir().mkpath(QFileInfo(path).path());
    QFile file(path);
    if (!file.open(QIODevice::WriteOnly) || file.write(content) != content.size())
        qFatal("cannot write %s", qPrintable(path));
}

} // namespace

class RescueTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void init() { m_folder = std::make_unique<QTemporaryDir>(); }

    void onlyADeadRunIsReported()
    {
        const QString runs = m_folder->filePath(QStringLiteral("runs"));
        RunMarker own(runs);
        own.update({QStringLiteral("/logs/own.tlog"), {}, {}});
        {
            RunMarker other(runs); // a second instance
            other.update({QStringLiteral("/logs/other.tlog"), {QStringLiteral("udpin:0.0.0.0:14551")}, {}});
            QCOMPARE(markersIn(runs).size(), 2);
            QVERIFY(!own.takeUnfinished() && !other.takeUnfinished());
        }
        QCOMPARE(markersIn(runs).size(), 1); // it ended properly
        QVERIFY(!own.takeUnfinished());

        writeFile(runs + QStringLiteral("/run-dead01"),
                  "recording /logs/a b.tlog\nlink udpin:0.0.0.0:14550\nlink tcp:10.0.0.1:57");
        writeFile(runs + QStringLiteral("/run-dead02"), ""); // it had nothing
        const auto left = own.takeUnfinished();
        QVERIFY(left);
        QCOMPARE(left->recording, QStringLiteral("/logs/a b.tlog"));
        QCOMPARE(left->links, QStringList{QStringLiteral("udpin:0.0.0.0:14550")}); // the last line is not whole
        QCOMPARE(markersIn(runs).size(), 1);
        QVERIFY(!own.takeUnfinished()); // once
    }

    void markerFollowsTheRun()
    {
        const QString runs = m_folder->filePath(QStringLiteral("runs"));
        const RunRecord first{
            QStringLiteral("/logs/a long name of a recording.tlog"), {QStringLiteral("udpin:0.0.0.0:14550")}, {}};
        RunMarker own(runs);
        own.update(first);
        own.update({QStringLiteral("/b.tlog"), {}, {}});
        QFile file(runs + QLatin1Char('/') + markersIn(runs).value(0));
        QVERIFY(file.open(QIODevice::ReadOnly));
        QCOMPARE(file.readAll(), QByteArray("recording /b.tlog\n"));
        QVERIFY(!(file.permissions() & (QFile::ReadGroup | QFile::ReadOther)));
    }

    void aFolderThatCannotBeMadeIsNoProblem()
    {
        writeFile(m_folder->filePath(QStringLiteral("file")), "x");
        RunMarker own(m_folder->filePath(QStringLiteral("file/runs")));
        own.update({QStringLiteral("/a.tlog"), {}, {}});
        QVERIFY(!own.takeUnfinished());
    }

    void theNextStartReplaysWhatWasRecorded()
    {
        QVERIFY(crypto::initCrypto());
        qputenv("XDG_DATA_HOME", m_folder->filePath(QStringLiteral("data")).toLocal8Bit());
        qputenv("XDG_CONFIG_HOME", m_folder->filePath(QStringLiteral("config")).toLocal8Bit());
        const QString recording = m_folder->filePath(QStringLiteral("crashed flight.tlog"));
        std::string content;
        for (std::uint32_t i = 0; i < 20; ++i)
            content += tlog::entry(tlog::kNoon + std::chrono::milliseconds(500 * i), tlog::heartbeat(i, 7));
        content.resize(content.size() - 9); // the crash cut the last frame
        writeFile(recording, QByteArray::fromStdString(content));
        const tlog::LinkEvent event{tlog::LinkEvent::Kind::Switched, tlog::kNoon, "aes-256-gcm", "air-1"};
        const std::string line = tlog::lineOf(event);
        writeFile(recording + QStringLiteral(".events"), QByteArray::fromStdString(line + line.substr(0, line.size() / 2)));
        const QString runs = dataFolder() + QStringLiteral("/runs");
        writeFile(runs + QStringLiteral("/run-dead01"),
                  "recording " + recording.toUtf8() + "\nlink udpin:127.0.0.1:0\nlink udpout:127.0.0.1:9\n");

        crypto::SystemRandom random;
        WindowOptions options;
        options.links = {*link::LinkUrl::parse("udpin:127.0.0.1:0")};
        Application application(options, random);
        QVERIFY(application.start());
        ui::MainWindow *window = nullptr;
        for (QWidget *top : QApplication::topLevelWidgets())
            if (auto *found = qobject_cast<ui::MainWindow *>(top))
                window = found;
        QVERIFY(window);
        auto *bar = window->findChild<QFrame *>(QStringLiteral("rescueBar"));
        QVERIFY(bar);
        EVENTUALLY(bar->isVisible());
        QCOMPARE(QApplication::activeModalWidget(), nullptr);
        const auto hasLinks = [&](std::size_t count) {
            const auto &live = window->view().station();
            return live && live->links.size() == count;
        };
        EVENTUALLY(hasLinks(1));
        window->activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(window, test::kDeadlineMs));
        QTest::keyClick(window, Qt::Key_O, Qt::AltModifier);
        EVENTUALLY(hasLinks(2)); // the other one is open already
        QTest::mouseClick(bar->findChild<QPushButton *>(QStringLiteral("rescueReplay")), Qt::LeftButton);
        EVENTUALLY(window->view().isReplay() && window->view().vehicle);
        QCOMPARE(window->view().vehicle->state.systemId, std::uint8_t(7));
        EVENTUALLY(window->view().snapshot->replay->index && window->view().snapshot->replay->index->frames == 19);
        QCOMPARE(window->view().snapshot->replay->index->suites.size(), std::size_t(1)); // of what was noted beside it
        QCOMPARE(window->view().snapshot->replay->index->unreadableEvents, std::uint64_t(1));
        QTest::keyClick(window, Qt::Key_M, Qt::AltModifier);
        EVENTUALLY(!window->findChild<QFrame *>(QStringLiteral("rescueBar")));
        QCOMPARE(markersIn(runs).size(), 1); // its own, which lives
        const auto notesTheLink = [&runs] {
            QFile own(runs + QLatin1Char('/') + markersIn(runs).value(0));
            return own.open(QIODevice::ReadOnly) && own.readAll().contains("link udpout:127.0.0.1:9");
        };
        EVENTUALLY(notesTheLink());
    }

private:
    std::unique_ptr<QTemporaryDir> m_folder;
};

SKYSEAL_TEST_WIDGETS(RescueTest)
#include "rescue_test.moc"
