// The event loop of packet forwarding threads behaves like Qt's own: timers, wake-ups from other threads, notifiers that are
// removed while they are activated, loops within loops, files and sockets.
#include "core/link/epoll_dispatcher.h"
#include "core/link/event_loop.h"
#include "core/link/steady_now.h"
#include "tests/support/eventually.h"
#include "tests/support/test_runner.h"

#include <QtCore/QCoreApplication>
#include <QtCore/QEventLoop>
#include <QtCore/QFile>
#include <QtCore/QProcess>
#include <QtCore/QSemaphore>
#include <QtCore/QSocketNotifier>
#include <QtCore/QThread>
#include <QtCore/QTimer>
#include <QtNetwork/QTcpServer>
#include <QtNetwork/QTcpSocket>

#include <atomic>
#include <functional>
#include <memory>

#include <fcntl.h>
#include <sys/socket.h>
#include <unistd.h>

using namespace skyseal;
using namespace skyseal::test;
using link::EpollDispatcher;
using std::chrono::milliseconds;

namespace {

/// A connected pair of descriptors.
struct Pair
{
    Pair() { ready = ::socketpair(AF_UNIX, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0, ends) == 0; }
    ~Pair()
    {
        close(0);
        close(1);
    }
    void close(int end)
    {
        if (ends[end] >= 0)
            ::close(ends[end]);
        ends[end] = -1;
    }
    bool say(int end) const { return ::write(ends[end], "x", 1) == 1; }
    bool hear(int end) const
    {
        char byte;
        return ::read(ends[end], &byte, 1) == 1;
    }

    int ends[2] = {-1, -1};
    bool ready = false;
};

/// One turn that waits for nothing.
bool turn(QEventLoop::ProcessEventsFlags flags = QEventLoop::AllEvents)
{
    return QAbstractEventDispatcher::instance()->processEvents(flags);
}

/// Keeps the order in which things happened.
struct Diary
{
    std::function<void()> note(const char *what)
    {
        return [this, what] { entries << QLatin1String(what); };
    }
    QStringList entries;
};

class Posted final : public QObject
{
public:
    explicit Posted(std::function<void()> handler) : m_handler(std::move(handler)) {}

protected:
    bool event(QEvent *event) override
    {
        if (event->type() != QEvent::User)
            return QObject::event(event);
        m_handler();
        return true;
    }

private:
    std::function<void()> m_handler;
};

} // namespace

class EpollDispatcherTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void isInstalled();
    void timersKeepTheirOrder();
    void timersRepeatAndStop();
    void timerIsNotHandledWithinItself();
    void timersMoveToAnotherThread();
    void zeroTimersLeaveRoomForOthers();
    void remainingTimeIsRoundedUp();
    void timersMayBeExcluded();
    void postedEventsComeFirst();
    void wakesUpFromAnotherThread();
    void manyThreadsLoseNoEvent();
    void ownEventsDoNotWait();
    void interruptEndsTheWait();
    void deferredDeletion();
    void readWriteAndHangUp();
    void urgentDataIsAnException();
    void notifierRemovedDuringActivation();
    void notifierDeletedDuringActivation();
    void descriptorIsUsedAgain();
    void notifiersMayBeExcluded();
    void readinessSurvivesAnInnerLoop();
    void filesAreAlwaysReady();
    void tcpConnection();
    void processOutput();
    void loopOfAThread();
};

void EpollDispatcherTest::isInstalled()
{
    QVERIFY(qobject_cast<EpollDispatcher *>(QAbstractEventDispatcher::instance()));
}

void EpollDispatcherTest::timersKeepTheirOrder()
{
    Diary diary;
    QTimer::singleShot(30, Qt::PreciseTimer, this, diary.note("30"));
    QTimer::singleShot(10, Qt::PreciseTimer, this, diary.note("10"));
    QTimer::singleShot(20, Qt::PreciseTimer, this, diary.note("20 a"));
    QTimer::singleShot(20, Qt::PreciseTimer, this, diary.note("20 b"));
    const TimePoint began = steadyNow();
    EVENTUALLY_EQUAL(diary.entries.size(), 4);
    QVERIFY(steadyNow() - began >= milliseconds(30)); // never early
    QCOMPARE(diary.entries.join(QLatin1Char(' ')), QStringLiteral("10 20 a 20 b 30"));
}

void EpollDispatcherTest::timersRepeatAndStop()
{
    int count = 0;
    QTimer timer;
    QObject::connect(&timer, &QTimer::timeout, &timer, [&] {
        if (++count == 3)
            timer.stop();
    });
    const TimePoint began = steadyNow();
    timer.start(5);
    QCOMPARE(timer.remainingTime() <= 5, true);
    EVENTUALLY_EQUAL(count, 3);
    QVERIFY(steadyNow() - began >= milliseconds(15));
    QVERIFY(!timer.isActive());
    bool later = false;
    QTimer::singleShot(20, this, [&] { later = true; });
    EVENTUALLY(later);
    QCOMPARE(count, 3);
    // Restarted by its own handler, with another interval.
    QTimer again;
    again.setSingleShot(true);
    QObject::connect(&again, &QTimer::timeout, &again, [&] {
        if (++count < 6)
            again.start(1);
    });
    again.start(1);
    EVENTUALLY_EQUAL(count, 6);
    QVERIFY(!again.isActive());
}

void EpollDispatcherTest::timerIsNotHandledWithinItself()
{
    int depth = 0, deepest = 0, others = 0, count = 0;
    QTimer other;
    QObject::connect(&other, &QTimer::timeout, &other, [&] { ++others; });
    QTimer timer;
    QObject::connect(&timer, &QTimer::timeout, &timer, [&] {
        deepest = std::max(deepest, ++depth);
        ++count;
        const int before = others;
        QEventLoop inner;
        QTimer look;
        QObject::connect(&look, &QTimer::timeout, &inner, [&] {
            if (others >= before + 3)
                inner.quit();
        });
        look.start(1);
        inner.exec();
        --depth;
    });
    other.start(1);
    timer.start(1);
    EVENTUALLY(count >= 3);
    QCOMPARE(deepest, 1);
}

void EpollDispatcherTest::timersMoveToAnotherThread()
{
    QThread thread;
    link::installEventLoop(thread);
    thread.start();
    auto *timer = new QTimer;
    std::atomic<int> count{0};
    std::atomic<QThread *> where{nullptr};
    QObject::connect(timer, &QTimer::timeout, timer, [&] {
        where = QThread::currentThread();
        ++count;
    });
    timer->start(2);
    timer->moveToThread(&thread);
    EVENTUALLY(count >= 2);
    QCOMPARE(where.load(), &thread);
    timer->deleteLater();
    thread.quit();
    QVERIFY(thread.wait(kDeadlineMs));
}

void EpollDispatcherTest::zeroTimersLeaveRoomForOthers()
{
    int zeros = 0;
    QTimer zero, zeroToo;
    QObject::connect(&zero, &QTimer::timeout, &zero, [&] { ++zeros; });
    QObject::connect(&zeroToo, &QTimer::timeout, &zeroToo, [&] { ++zeros; });
    zero.start(0);
    zeroToo.start(0);
    QVERIFY(turn());
    QCOMPARE(zeros, 2); // each once in a turn
    QVERIFY(turn());
    QCOMPARE(zeros, 4);
    bool shot = false;
    QTimer::singleShot(5, this, [&] { shot = true; });
    Pair pair;
    QSocketNotifier heard(pair.ends[1], QSocketNotifier::Read);
    bool activated = false;
    QObject::connect(&heard, &QSocketNotifier::activated, &heard, [&] { activated = pair.hear(1); });
    QVERIFY(pair.say(0));
    EVENTUALLY(shot && activated);
}

void EpollDispatcherTest::remainingTimeIsRoundedUp()
{
    QTimer timer;
    timer.setTimerType(Qt::PreciseTimer);
    timer.start(100'000);
    QVERIFY(timer.remainingTime() > 99'000 - kDeadlineMs && timer.remainingTime() <= 100'000);
    auto *dispatcher = QAbstractEventDispatcher::instance();
    const auto timers = dispatcher->registeredTimers(&timer);
    QCOMPARE(timers.size(), 1);
    QCOMPARE(timers[0].interval, 100'000);
    QCOMPARE(timers[0].timerType, Qt::PreciseTimer);
    QCOMPARE(dispatcher->remainingTime(timers[0].timerId + 1'000'000), -1);
    timer.stop();
    QVERIFY(dispatcher->registeredTimers(&timer).isEmpty());
    QVERIFY(!dispatcher->unregisterTimers(&timer));
}

void EpollDispatcherTest::timersMayBeExcluded()
{
    bool shot = false;
    QTimer::singleShot(0, Qt::PreciseTimer, this, [&] { shot = true; });
    QTimer timer; // singleShot(0) is an event, this is a timer
    bool expired = false;
    timer.setSingleShot(true);
    QObject::connect(&timer, &QTimer::timeout, &timer, [&] { expired = true; });
    timer.start(0);
    turn(QEventLoop::X11ExcludeTimers);
    QVERIFY(!expired);
    turn();
    QVERIFY(expired && shot);
}

void EpollDispatcherTest::postedEventsComeFirst()
{
    Diary diary;
    Pair pair;
    QSocketNotifier heard(pair.ends[1], QSocketNotifier::Read);
    QObject::connect(&heard, &QSocketNotifier::activated, &heard, [&] {
        pair.hear(1);
        diary.note("socket")();
    });
    QTimer timer;
    timer.setSingleShot(true);
    QObject::connect(&timer, &QTimer::timeout, &timer, diary.note("timer"));
    timer.start(0);
    QVERIFY(pair.say(0));
    Posted first(diary.note("first")), second(diary.note("second"));
    QCoreApplication::postEvent(&second, new QEvent(QEvent::User), Qt::LowEventPriority);
    QCoreApplication::postEvent(&first, new QEvent(QEvent::User), Qt::HighEventPriority);
    EVENTUALLY_EQUAL(diary.entries.size(), 4);
    QCOMPARE(diary.entries.join(QLatin1Char(' ')), QStringLiteral("first second socket timer"));
}

void EpollDispatcherTest::wakesUpFromAnotherThread()
{
    // Each is sent when the loop has nothing else to do, and has to wake it up.
    QEventLoop loop;
    int count = 0;
    std::unique_ptr<QThread> other;
    QSemaphore handled;
    Posted target([&] {
        handled.release();
        if (++count == 200)
            loop.quit();
    });
    other.reset(QThread::create([&] {
        for (int i = 0; i < 200; ++i) {
            QCoreApplication::postEvent(&target, new QEvent(QEvent::User));
            handled.acquire();
        }
    }));
    other->start();
    QTimer::singleShot(kDeadlineMs, &loop, [&] { loop.exit(1); });
    QCOMPARE(loop.exec(), 0);
    QVERIFY(other->wait(kDeadlineMs));
    QCOMPARE(count, 200);
}

void EpollDispatcherTest::manyThreadsLoseNoEvent()
{
    constexpr int kThreads = 4, kEach = 5000;
    QEventLoop loop;
    int count = 0;
    Posted target([&] {
        if (++count == kThreads * kEach)
            loop.quit();
    });
    std::vector<std::unique_ptr<QThread>> threads;
    for (int i = 0; i < kThreads; ++i) {
        threads.emplace_back(QThread::create([&] {
            for (int k = 0; k < kEach; ++k)
                QCoreApplication::postEvent(&target, new QEvent(QEvent::User));
        }));
        threads.back()->start();
    }
    QTimer::singleShot(kDeadlineMs, &loop, [&] { loop.exit(1); });
    QCOMPARE(loop.exec(), 0);
    for (const auto &thread : threads)
        QVERIFY(thread->wait(kDeadlineMs));
    QCOMPARE(count, kThreads * kEach);
}

/// An event that a handler posts is no reason to wait, though nothing else happens.
void EpollDispatcherTest::ownEventsDoNotWait()
{
    QEventLoop loop;
    int count = 0;
    Posted chain([&] {
        if (++count == 1000)
            loop.quit();
        else
            QCoreApplication::postEvent(&chain, new QEvent(QEvent::User));
    });
    QTimer::singleShot(0, &chain, [&] { QCoreApplication::postEvent(&chain, new QEvent(QEvent::User)); });
    QTimer::singleShot(kDeadlineMs, &loop, [&] { loop.exit(1); });
    QCOMPARE(loop.exec(), 0);
    QCOMPARE(count, 1000);
}

void EpollDispatcherTest::interruptEndsTheWait()
{
    // Before the wait: from the signal that announces it; during it: from another thread.
    auto *dispatcher = QAbstractEventDispatcher::instance();
    const auto connection = QObject::connect(dispatcher, &QAbstractEventDispatcher::aboutToBlock, this,
                                             [dispatcher] { dispatcher->interrupt(); });
    turn(QEventLoop::WaitForMoreEvents);
    QObject::disconnect(connection);
    QEventLoop loop;
    QSemaphore waits;
    QObject::connect(dispatcher, &QAbstractEventDispatcher::aboutToBlock, &loop, [&] { waits.release(); });
    const std::unique_ptr<QThread> other(QThread::create([&] {
        waits.acquire();
        loop.quit(); // thread-safe, and interrupts
    }));
    other->start();
    loop.exec();
    QVERIFY(other->wait(kDeadlineMs));
}

void EpollDispatcherTest::deferredDeletion()
{
    // From a notifier's handler: deleted by the loop that runs it, not only when that loop ends.
    bool deleted = false;
    auto *object = new QObject;
    QObject::connect(object, &QObject::destroyed, this, [&] { deleted = true; });
    Pair pair;
    QSocketNotifier heard(pair.ends[1], QSocketNotifier::Read);
    QObject::connect(&heard, &QSocketNotifier::activated, &heard, [&] {
        if (pair.hear(1))
            object->deleteLater();
    });
    QVERIFY(pair.say(0));
    QEventLoop loop;
    QTimer look;
    QObject::connect(&look, &QTimer::timeout, &loop, [&] {
        if (deleted)
            loop.quit();
    });
    look.start(1);
    QTimer::singleShot(kDeadlineMs, &loop, [&] { loop.exit(1); });
    QCOMPARE(loop.exec(), 0);
}

void EpollDispatcherTest::readWriteAndHangUp()
{
    Pair pair;
    QVERIFY(pair.ready);
    int reads = 0, writes = 0;
    QSocketNotifier readable(pair.ends[0], QSocketNotifier::Read), writable(pair.ends[0], QSocketNotifier::Write);
    QObject::connect(&readable, &QSocketNotifier::activated, &readable, [&] {
        ++reads;
        if (!pair.hear(0))
            readable.setEnabled(false); // the other end is closed
    });
    QObject::connect(&writable, &QSocketNotifier::activated, &writable, [&] {
        ++writes;
        writable.setEnabled(false);
    });
    EVENTUALLY_EQUAL(writes, 1);
    QCOMPARE(reads, 0);
    QVERIFY(pair.say(1));
    EVENTUALLY_EQUAL(reads, 1);
    writable.setEnabled(true);
    EVENTUALLY_EQUAL(writes, 2);
    // Full: not writable until the other end has read.
    while (pair.say(0)) {}
    writable.setEnabled(true);
    for (int i = 0; i < 3; ++i)
        turn();
    QCOMPARE(writes, 2);
    while (pair.hear(1)) {}
    EVENTUALLY_EQUAL(writes, 3);
    pair.close(1);
    EVENTUALLY_EQUAL(reads, 2);
    QVERIFY(!readable.isEnabled());
    writable.setEnabled(true); // as with poll(2), also of a connection that is gone
    EVENTUALLY_EQUAL(writes, 4);
}

void EpollDispatcherTest::urgentDataIsAnException()
{
    QTcpServer server;
    QVERIFY(server.listen(QHostAddress::LocalHost));
    QTcpSocket client;
    client.connectToHost(QHostAddress::LocalHost, server.serverPort());
    EVENTUALLY(server.hasPendingConnections() && client.state() == QAbstractSocket::ConnectedState);
    const std::unique_ptr<QTcpSocket> peer(server.nextPendingConnection());
    int urgent = 0;
    QSocketNotifier notifier(peer->socketDescriptor(), QSocketNotifier::Exception);
    QObject::connect(&notifier, &QSocketNotifier::activated, &notifier, [&] {
        ++urgent;
        notifier.setEnabled(false);
    });
    QCOMPARE(::send(static_cast<int>(client.socketDescriptor()), "u", 1, MSG_OOB), ssize_t(1));
    EVENTUALLY_EQUAL(urgent, 1);
}

/// Both are ready in one turn; whichever comes first switches the other off.
void EpollDispatcherTest::notifierRemovedDuringActivation()
{
    Pair one, two;
    QSocketNotifier first(one.ends[1], QSocketNotifier::Read), second(two.ends[1], QSocketNotifier::Read);
    int activated = 0;
    QObject::connect(&first, &QSocketNotifier::activated, &first, [&] {
        ++activated;
        second.setEnabled(false);
        first.setEnabled(false);
    });
    QObject::connect(&second, &QSocketNotifier::activated, &second, [&] {
        ++activated;
        first.setEnabled(false);
        second.setEnabled(false);
    });
    QVERIFY(one.say(0) && two.say(0));
    turn();
    turn();
    QCOMPARE(activated, 1);
}

void EpollDispatcherTest::notifierDeletedDuringActivation()
{
    Pair one, two;
    std::array<std::unique_ptr<QSocketNotifier>, 2> notifiers;
    int activated = 0;
    for (std::size_t i = 0; i < 2; ++i) {
        const Pair &pair = i == 0 ? one : two;
        notifiers[i] = std::make_unique<QSocketNotifier>(pair.ends[1], QSocketNotifier::Read);
        QObject::connect(notifiers[i].get(), &QSocketNotifier::activated, this, [&, i] {
            ++activated;
            notifiers[1 - i].reset();
            notifiers[i].release()->deleteLater();
        });
    }
    QVERIFY(one.say(0) && two.say(0));
    turn();
    turn();
    QCOMPARE(activated, 1);
}

/// A descriptor that is closed while a notifier still has it, and whose number the system gives to another socket.
void EpollDispatcherTest::descriptorIsUsedAgain()
{
    constexpr int kNumber = 200; // unused here
    Pair first, second, third;
    int activated = 0;
    const auto listen = [&](QSocketNotifier &notifier) {
        QObject::connect(&notifier, &QSocketNotifier::activated, &notifier, [&] {
            char byte;
            activated += ::read(kNumber, &byte, 1) == 1;
        });
    };
    QCOMPARE(::dup3(first.ends[1], kNumber, O_CLOEXEC), kNumber);
    first.close(1);
    auto stale = std::make_unique<QSocketNotifier>(kNumber, QSocketNotifier::Read);
    ::close(kNumber);
    stale.reset();
    QCOMPARE(::dup3(second.ends[1], kNumber, O_CLOEXEC), kNumber);
    second.close(1);
    QSocketNotifier heard(kNumber, QSocketNotifier::Read);
    listen(heard);
    QVERIFY(second.say(0));
    EVENTUALLY_EQUAL(activated, 1);
    // Without a word to the loop, which still has the number as registered.
    QCOMPARE(::dup3(third.ends[1], kNumber, O_CLOEXEC), kNumber);
    third.close(1);
    QSocketNotifier writable(kNumber, QSocketNotifier::Write);
    bool wrote = false;
    QObject::connect(&writable, &QSocketNotifier::activated, &writable, [&] {
        wrote = true;
        writable.setEnabled(false);
    });
    QVERIFY(third.say(0));
    EVENTUALLY(wrote && activated == 2);
    heard.setEnabled(false);
    ::close(kNumber);
}

void EpollDispatcherTest::notifiersMayBeExcluded()
{
    Pair pair;
    QSocketNotifier heard(pair.ends[1], QSocketNotifier::Read);
    int activated = 0;
    QObject::connect(&heard, &QSocketNotifier::activated, &heard, [&] { activated += pair.hear(1); });
    QVERIFY(pair.say(0));
    turn(QEventLoop::ExcludeSocketNotifiers);
    QCOMPARE(activated, 0);
    // A wait without sockets ends by an event of another thread.
    Posted target([] {});
    const std::unique_ptr<QThread> other(
        QThread::create([&] { QCoreApplication::postEvent(&target, new QEvent(QEvent::User)); }));
    other->start();
    turn(QEventLoop::ExcludeSocketNotifiers | QEventLoop::WaitForMoreEvents);
    QVERIFY(other->wait(kDeadlineMs));
    QCOMPARE(activated, 0);
    turn();
    QCOMPARE(activated, 1);
}

/// A handler runs a loop of its own: the other sockets of the same turn are served there, and only once.
void EpollDispatcherTest::readinessSurvivesAnInnerLoop()
{
    Pair one, two;
    int outer = 0, inner = 0;
    QSocketNotifier first(one.ends[1], QSocketNotifier::Read), second(two.ends[1], QSocketNotifier::Read);
    const auto take = [&](const Pair &pair) {
        pair.hear(1);
        ++outer;
        if (outer == 1) {
            const int before = outer;
            while (outer == before)
                turn(QEventLoop::WaitForMoreEvents);
            inner = outer - before;
        }
    };
    QObject::connect(&first, &QSocketNotifier::activated, &first, [&] { take(one); });
    QObject::connect(&second, &QSocketNotifier::activated, &second, [&] { take(two); });
    QVERIFY(one.say(0) && two.say(0));
    EVENTUALLY_EQUAL(outer, 2);
    QCOMPARE(inner, 1);
}

void EpollDispatcherTest::filesAreAlwaysReady()
{
    QFile file(QStringLiteral("/dev/null"));
    QVERIFY(file.open(QIODevice::ReadOnly));
    QSocketNotifier heard(file.handle(), QSocketNotifier::Read);
    int activated = 0;
    QObject::connect(&heard, &QSocketNotifier::activated, &heard, [&] { ++activated; });
    EVENTUALLY(activated >= 2);
    heard.setEnabled(false);
    const int before = activated;
    turn();
    QCOMPARE(activated, before);
}

void EpollDispatcherTest::tcpConnection()
{
    QTcpServer server;
    QVERIFY(server.listen(QHostAddress::LocalHost));
    QByteArray heard;
    std::unique_ptr<QTcpSocket> peer;
    bool ended = false;
    QObject::connect(&server, &QTcpServer::newConnection, &server, [&] {
        peer.reset(server.nextPendingConnection());
        QObject::connect(peer.get(), &QTcpSocket::readyRead, peer.get(), [&] { heard += peer->readAll(); });
        QObject::connect(peer.get(), &QTcpSocket::disconnected, peer.get(), [&] { ended = true; });
    });
    QTcpSocket client;
    client.connectToHost(QHostAddress::LocalHost, server.serverPort());
    const QByteArray much(4 << 20, 'm'); // more than the buffers of the system hold
    client.write(much);
    EVENTUALLY(heard.size() == much.size());
    client.disconnectFromHost();
    EVENTUALLY(ended);
    QTcpSocket refused;
    bool failed = false;
    QObject::connect(&refused, &QTcpSocket::errorOccurred, &refused, [&] { failed = true; });
    const quint16 port = server.serverPort();
    server.close();
    refused.connectToHost(QHostAddress::LocalHost, port);
    EVENTUALLY(failed);
}

void EpollDispatcherTest::processOutput()
{
    QProcess process;
    process.start(QStringLiteral("/bin/sh"), {QStringLiteral("-c"), QStringLiteral("read line; echo \"$line again\"")});
    process.write("once\n");
    EVENTUALLY(process.state() == QProcess::NotRunning);
    QCOMPARE(process.readAllStandardOutput(), QByteArray("once again\n"));
}

void EpollDispatcherTest::loopOfAThread()
{
    QThread thread;
    link::installEventLoop(thread);
    std::atomic<bool> right{false}, shot{false};
    QObject::connect(
        &thread, &QThread::started, &thread,
        [&] {
            right = qobject_cast<EpollDispatcher *>(QAbstractEventDispatcher::instance()) != nullptr;
            QTimer::singleShot(3, [&] { shot = true; });
        },
        Qt::DirectConnection);
    thread.start();
    EVENTUALLY(right && shot);
    thread.quit();
    QVERIFY(thread.wait(kDeadlineMs));
}

SKYSEAL_TEST_ENTRY(EpollDispatcherTest, link::installEventLoop(); QCoreApplication application(argc, argv);)
#include "epoll_dispatcher_test.moc"
