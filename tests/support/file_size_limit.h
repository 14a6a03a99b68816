// A disk that is full, as far as a process can tell: beyond a limit on the size of files, every write fails.
#pragma once

#include <csignal>

#include <sys/resource.h>

namespace skyseal::test {

/// Lowers the limit of this process while it lives. Where the test's output goes into a file, nothing can be printed meanwhile.
class FileSizeLimit
{
public:
    explicit FileSizeLimit(rlim_t bytes) : m_handler(std::signal(SIGXFSZ, SIG_IGN)) // the error of the call instead
    {
        ::getrlimit(RLIMIT_FSIZE, &m_old);
        const rlimit low{bytes, m_old.rlim_max};
        m_works = ::setrlimit(RLIMIT_FSIZE, &low) == 0;
    }
    ~FileSizeLimit()
    {
        ::setrlimit(RLIMIT_FSIZE, &m_old);
        std::signal(SIGXFSZ, m_handler);
    }
    FileSizeLimit(const FileSizeLimit &) = delete;
    FileSizeLimit &operator=(const FileSizeLimit &) = delete;

    bool works() const { return m_works; }

private:
    void (*m_handler)(int);
    rlimit m_old{};
    bool m_works = false;
};

} // namespace skyseal::test
