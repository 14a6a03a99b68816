// What a keyed cipher and a session of each suite take of the heap. The C library counts for the whole process, so a child is
// asked that is alone with a copy of the heap: in the program itself other threads allocate meanwhile, and their blocks would be
// taken for a session's.
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
    /// Makes the child, which takes some 0.1 s for all suites while this program goes on. To be called before there are
    /// threads, keys or windows.
    HeapFigures();
    ~HeapFigures();
    HeapFigures(const HeapFigures &) = delete;
    HeapFigures &operator=(const HeapFigures &) = delete;

    /// Bytes; nullopt where the suite is not available or the C library does not tell. Waits for the child. Any thread.
    std::optional<double> context(crypto::SuiteId suite) { return find(suite, &Figures::context); }
    std::optional<double> session(crypto::SuiteId suite) { return find(suite, &Figures::session); }

private:
    struct Figures
    {
        crypto::SuiteId suite{};
        double context = 0, session = 0; ///< NaN when not known
    };

    [[noreturn]] static void measure(int out);
    void collect();
    std::optional<double> find(crypto::SuiteId suite, double Figures::*figure);

    std::mutex m_mutex;
    std::map<crypto::SuiteId, Figures> m_figures;
    pid_t m_child = -1;
    int m_in = -1; ///< what the child writes; -1 once all was read
};

} // namespace skyseal::experiment
