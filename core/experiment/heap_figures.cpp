#include "core/experiment/heap_figures.h"

#include "core/crypto/init_crypto.h"
#include "core/experiment/cipher_bench.h"

#include <cmath>
#include <limits>

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace skyseal::experiment {

namespace {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

template<typename Call> auto untilDone(Call &&call)
{
    auto result = call();
    while (result < 0 && errno == EINTR)
        result = call();
    return result;
}

} // namespace

HeapFigures::HeapFigures()
{
    int ends[2];
    if (::pipe2(ends, O_CLOEXEC) != 0)
        return;
    m_child = ::fork();
    if (m_child == 0) {
        ::close(ends[0]);
        measure(ends[1]);
    }
    ::close(ends[1]);
    m_in = ends[0];
}

HeapFigures::~HeapFigures()
{
    if (m_in >= 0)
        collect();
}

void HeapFigures::measure(int out)
{
    if (crypto::initCrypto()) {
        for (const crypto::SuiteInfo &suite : crypto::suites()) {
            const Figures figures{suite.id, contextBytes(suite.id).value_or(kUnknown),
                                  sessionBytes(suite.id).value_or(kUnknown)};
            if (::write(out, &figures, sizeof figures) != sizeof figures)
                break;
        }
    }
    ::_exit(0);
}

void HeapFigures::collect()
{
    Figures figures;
    while (untilDone([&] { return ::read(m_in, &figures, sizeof figures); }) == sizeof figures)
        m_figures[figures.suite] = figures;
    ::close(m_in);
    m_in = -1;
    if (m_child > 0)
        untilDone([&] { return ::waitpid(m_child, nullptr, 0); });
    m_child = -1;
}

bool HeapFigures::collectIfDone()
{
    const std::lock_guard lock(m_mutex);
    if (m_in < 0)
        return true;
    if (m_child > 0 && untilDone([&] { return ::waitpid(m_child, nullptr, WNOHANG); }) == 0)
        return false;
    m_child = -1;
    collect();
    return true;
}

std::optional<double> HeapFigures::find(crypto::SuiteId suite, double Figures::*figure)
{
    const std::lock_guard lock(m_mutex);
    if (m_in >= 0)
        collect();
    const auto found = m_figures.find(suite);
    if (found == m_figures.end() || std::isnan(found->second.*figure))
        return std::nullopt;
    return found->second.*figure;
}

} // namespace skyseal::experiment
