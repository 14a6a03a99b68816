// Heap size of a keyed cipher and of a session for each suite. The C library counts for the whole process, so a child process
// measures them: in this process other threads allocate at the same time, and their blocks would be counted as well.
#pragma once

#include "core/crypto/suite.h"

#include <map>
#include <mutex>
#include <optional>

#include <sys/types.h>

namespace skyseal::experiment {

class HeapFigures
{
public:
    /// Forks the child, which needs about 0.1 s for all suites and runs in parallel. To be called before there are threads,
    /// keys or windows.
    HeapFigures();
    ~HeapFigures();
    HeapFigures(const HeapFigures &) = delete;
    HeapFigures &operator=(const HeapFigures &) = delete;

    /// Bytes; nullopt if the suite is not available or the C library has no heap statistics. Waits for the child. Any thread.
    std::optional<double> context(crypto::SuiteId suite) { return find(suite, &Figures::context); }
    std::optional<double> session(crypto::SuiteId suite) { return find(suite, &Figures::session); }

    /// Takes the figures if the child has ended, so that it does not remain as a zombie until somebody asks for them. Returns
    /// false while it runs. Does not wait for it. Any thread.
    bool collectIfDone();

private:
    struct Figures
    {
        crypto::SuiteId suite{};
        double context = 0, session = 0; ///< NaN if unknown
    };

    [[noreturn]] static void measure(int out);
    void collect();
    std::optional<double> find(crypto::SuiteId suite, double Figures::*figure);

    std::mutex m_mutex;
    std::map<crypto::SuiteId, Figures> m_figures;
    pid_t m_child = -1;
    int m_in = -1; ///< pipe from the child; -1 after everything was read
};

} // namespace skyseal::experiment
