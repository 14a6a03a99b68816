// A thread for work on files, so that a disk that hangs stops neither an event loop nor the end of a program.
#pragma once

#include "core/engine/common/mailbox.h"

#include <QtCore/QFutureWatcher>
#include <QtCore/QPromise>
#include <QtCore/QThreadPool>

#include <chrono>
#include <functional>
#include <memory>
#include <type_traits>
#include <utility>

namespace skyseal::engine {

/// Used by one thread, that of its owner's event loop.
class FileThread
{
public:
    static constexpr std::chrono::milliseconds kPatience{2000};

    explicit FileThread(std::chrono::milliseconds patience = kPatience) : m_patience(patience) { m_pool->setMaxThreadCount(1); }
    FileThread(const FileThread &) = delete;
    FileThread &operator=(const FileThread &) = delete;
    /// Waits for the work that was given, at most `patience`. A thread that still waits for the disk ends with the process.
    ~FileThread()
    {
        if (m_pool->waitForDone(static_cast<int>(m_patience.count())))
            return;
        static_cast<void>(m_pool.release());
        static_cast<void>(m_tasks.release());
    }

    /// Calls `work` in the thread, after all earlier work, and then `done` with its result in the thread of `context`, unless
    /// that was destroyed. `work` must own all that it uses.
    template<typename Work, typename Done> void run(QObject *context, Work work, Done done)
    {
        using Outcome = std::invoke_result_t<Work>;
        // Work and result change hands in mailboxes, whose locks ThreadSanitizer sees; Qt only wakes the other side.
        const auto outcome = std::make_shared<Mailbox<Outcome>>();
        const auto promise = std::make_shared<QPromise<void>>();
        promise->start();
        auto *watcher = new QFutureWatcher<void>(context);
        QObject::connect(watcher, &QFutureWatcherBase::finished, context, [watcher, outcome, done = std::move(done)]() mutable {
            watcher->deleteLater();
            done(std::move(outcome->takeAll().front()));
        });
        watcher->setFuture(promise->future());
        m_tasks->put([promise, outcome, work = std::move(work)]() mutable {
            outcome->put(work());
            promise->finish();
        });
        m_pool->start([tasks = m_tasks.get()] {
            for (const Task &task : tasks->takeAll())
                task();
        });
    }

private:
    using Task = std::function<void()>;

    std::chrono::milliseconds m_patience;
    std::unique_ptr<Mailbox<Task>> m_tasks = std::make_unique<Mailbox<Task>>();
    std::unique_ptr<QThreadPool> m_pool = std::make_unique<QThreadPool>();
};

} // namespace skyseal::engine
