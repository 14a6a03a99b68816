// Handlers that the event loop of packet forwarding threads calls without an event of Qt: beside timers, posted events and
// notifiers, removed by themselves and by others, and in loops that end while datagrams keep arriving.
#include "core/link/epoll_dispatcher.h"
#include "core/link/event_loop.h"
#include "core/link/readable_handler.h"
#include "core/link/steady_now.h"
#include "tests/support/eventually.h"
#include "tests/support/test_runner.h"

#include <QtCore/QCoreApplication>
#include <QtCore/QEventLoop>
#include <QtCore/QSocketNotifier>
#include <QtCore/QThread>
#include <QtCore/QTimer>

#include <array>
#include <functional>
#include <memory>

#include <sys/socket.h>
#include <unistd.h>

using namespace skyseal;
using namespace skyseal::test;
using link::EpollDispatcher;

namespace {

EpollDispatcher &dispatcher()
{
    return *qobject_cast<EpollDispatcher *>(QAbstractEventDispatcher::instance());
}

/// The far end of a connected pair of sockets; the handler is called for the near end.
class Heard final : public link::ReadableHandler
{
public:
    explicit Heard(std::function<void()> handler = {}) : m_handler(std::move(handler))
    {
        if (::socketpair(AF_UNIX, SOCK_DGRAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0, m_ends.data()) != 0)
            qFatal("no socket pair");
        dispatcher().addReader(m_ends[0], *this);
    }
    ~Heard()
    {
        stop();
        ::close(m_ends[0]);
        ::close(m_ends[1]);
    }
    void stop() { dispatcher().removeReader(m_ends[0]); }
    bool say() const { return ::send(m_ends[1], "x", 1, 0) == 1; }
    int near() const { return m_ends[0]; }
    int count() const { return m_count; }

private:
    void handleReadable() override
    {
        char byte;
        if (::recv(m_ends[0], &byte, 1, 0) != 1)
            return;
        ++m_count;
        if (m_handler)
            m_handler();
    }

    std::array<int, 2> m_ends{};
    std::function<void()> m_handler;
    int m_count = 0;
};

/// Runs the loop until quit() or the deadline; returns 0 after quit().
int run(QEventLoop &loop)
{
    QTimer deadline;
    QObject::connect(&deadline, &QTimer::timeout, &loop, [&] { loop.exit(1); });
    deadline.start(kDeadlineMs);
    return loop.exec();
}

} // namespace

class ReadableHandlerTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void calledInEveryKindOfLoop();
    void quitByTheHandlerEndsTheLoop();
    void quitByAnotherThreadEndsTheLoop();
    void timersExpireWhileDatagramsArrive();
    void postedEventsComeBeforeTheNextDatagram();
    void notifiersAreActivatedWhileDatagramsArrive();
    void deferredDeletion();
    void removedByItself();
    void removedByAnotherHandler();
    void besideANotifierForWriting();
    void excludedWithTheNotifiers();
    void descriptorIsUsedAgain();
};

void ReadableHandlerTest::calledInEveryKindOfLoop()
{
    QEventLoop loop;
    Heard heard([&] { loop.quit(); });
    QVERIFY(heard.say());
    QVERIFY(dispatcher().processEvents(QEventLoop::AllEvents));
    QCOMPARE(heard.count(), 1);
    QVERIFY(heard.say());
    QVERIFY(dispatcher().processEvents(QEventLoop::WaitForMoreEvents)); // returns after one event
    QCOMPARE(heard.count(), 2);
    QVERIFY(!dispatcher().processEvents(QEventLoop::AllEvents));
    QVERIFY(heard.say());
    QCOMPARE(run(loop), 0);
    QCOMPARE(heard.count(), 3);
}

void ReadableHandlerTest::quitByTheHandlerEndsTheLoop()
{
    QEventLoop loop;
    std::unique_ptr<Heard> heard;
    heard = std::make_unique<Heard>([&] {
        QVERIFY(heard->say()); // there is always one more
        if (heard->count() == 100)
            loop.quit();
    });
    QVERIFY(heard->say());
    QCOMPARE(run(loop), 0);
    QCOMPARE(heard->count(), 100);
}

void ReadableHandlerTest::quitByAnotherThreadEndsTheLoop()
{
    QEventLoop loop;
    std::unique_ptr<QThread> other;
    std::unique_ptr<Heard> heard;
    heard = std::make_unique<Heard>([&] {
        QVERIFY(heard->say());
        if (!other) {
            other.reset(QThread::create([&] { loop.quit(); }));
            other->start();
        }
    });
    QVERIFY(heard->say());
    QCOMPARE(run(loop), 0);
    QVERIFY(other->wait(kDeadlineMs));
}

void ReadableHandlerTest::timersExpireWhileDatagramsArrive()
{
    QEventLoop loop;
    std::unique_ptr<Heard> heard;
    heard = std::make_unique<Heard>([&] { QVERIFY(heard->say()); });
    QVERIFY(heard->say());
    const TimePoint began = steadyNow();
    QTimer::singleShot(5, Qt::PreciseTimer, &loop, [&] { loop.quit(); });
    QCOMPARE(run(loop), 0);
    QVERIFY(steadyNow() - began >= std::chrono::milliseconds(5));
    QVERIFY(heard->count() > 0);
}

void ReadableHandlerTest::postedEventsComeBeforeTheNextDatagram()
{
    QEventLoop loop;
    QObject context;
    int posted = 0;
    std::unique_ptr<Heard> heard;
    heard = std::make_unique<Heard>([&] {
        QCOMPARE(posted, heard->count() - 1);
        QVERIFY(heard->say());
        QMetaObject::invokeMethod(
            &context,
            [&] {
                if (++posted == 50)
                    loop.quit();
            },
            Qt::QueuedConnection);
    });
    QVERIFY(heard->say());
    QCOMPARE(run(loop), 0);
    QCOMPARE(heard->count(), 50);
}

void ReadableHandlerTest::notifiersAreActivatedWhileDatagramsArrive()
{
    QEventLoop loop;
    std::unique_ptr<Heard> heard;
    std::array<int, 2> pair{};
    QCOMPARE(::socketpair(AF_UNIX, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0, pair.data()), 0);
    heard = std::make_unique<Heard>([&] {
        QVERIFY(heard->say());
        if (heard->count() == 20)
            QCOMPARE(::write(pair[1], "x", 1), ssize_t(1));
    });
    {
        QSocketNotifier notifier(pair[0], QSocketNotifier::Read);
        QObject::connect(&notifier, &QSocketNotifier::activated, &loop, [&] { loop.quit(); });
        QVERIFY(heard->say());
        QCOMPARE(run(loop), 0);
        QVERIFY(heard->count() >= 20);
    }
    ::close(pair[0]);
    ::close(pair[1]);
}

void ReadableHandlerTest::deferredDeletion()
{
    // Deleted by the loop that runs the handler, not only when that loop ends.
    QEventLoop loop;
    auto *object = new QObject;
    Heard heard([&] { object->deleteLater(); });
    QObject::connect(object, &QObject::destroyed, &loop, [&] { loop.quit(); });
    QVERIFY(heard.say());
    QCOMPARE(run(loop), 0);
}

void ReadableHandlerTest::removedByItself()
{
    std::unique_ptr<Heard> heard;
    heard = std::make_unique<Heard>([&] { heard->stop(); });
    QVERIFY(heard->say() && heard->say());
    dispatcher().processEvents(QEventLoop::AllEvents);
    dispatcher().processEvents(QEventLoop::AllEvents);
    QCOMPARE(heard->count(), 1);
}

void ReadableHandlerTest::removedByAnotherHandler()
{
    // Both are ready when the first one runs.
    std::unique_ptr<Heard> one, two;
    one = std::make_unique<Heard>([&] { two.reset(); });
    two = std::make_unique<Heard>([&] { one.reset(); });
    QVERIFY(one->say() && two->say());
    dispatcher().processEvents(QEventLoop::AllEvents);
    QVERIFY(!one != !two);
}

void ReadableHandlerTest::besideANotifierForWriting()
{
    Heard heard;
    QSocketNotifier writable(heard.near(), QSocketNotifier::Write);
    int written = 0;
    QObject::connect(&writable, &QSocketNotifier::activated, &writable, [&] { ++written; });
    QVERIFY(heard.say());
    EVENTUALLY(written > 0 && heard.count() == 1);
    writable.setEnabled(false);
    const int before = written;
    QVERIFY(heard.say());
    EVENTUALLY_EQUAL(heard.count(), 2);
    QCOMPARE(written, before);
}

void ReadableHandlerTest::excludedWithTheNotifiers()
{
    Heard heard;
    QVERIFY(heard.say());
    dispatcher().processEvents(QEventLoop::ExcludeSocketNotifiers);
    QCOMPARE(heard.count(), 0);
    dispatcher().processEvents(QEventLoop::AllEvents);
    QCOMPARE(heard.count(), 1);
}

void ReadableHandlerTest::descriptorIsUsedAgain()
{
    int before = 0;
    {
        const Heard first;
        before = first.near();
    }
    Heard second;
    QCOMPARE(second.near(), before); // the lowest free number
    QVERIFY(second.say());
    EVENTUALLY_EQUAL(second.count(), 1);
}

SKYSEAL_TEST_ENTRY(ReadableHandlerTest, link::installEventLoop(); QCoreApplication application(argc, argv);)
#include "readable_handler_test.moc"
