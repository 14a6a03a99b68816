#include "app/common/journal.h"

#include "app/common/format.h"
#include "app/common/output.h"

#include <QtCore/QtGlobal>

#include <cstdio>

#include <sys/stat.h>
#include <unistd.h>

namespace skyseal::app {

namespace {

/// systemd names the device and inode of the journal's socket, so that a program notices if its stderr was redirected since.
bool stderrIsTheJournal()
{
    struct stat status
    {};
    unsigned long long device = 0, inode = 0;
    return std::sscanf(qgetenv("JOURNAL_STREAM").constData(), "%llu:%llu", &device, &inode) == 2
        && ::fstat(STDERR_FILENO, &status) == 0 && status.st_dev == device && status.st_ino == inode;
}

} // namespace

void remark(const std::string &line, unsigned severity)
{
    static const bool kIsJournal = stderrIsTheJournal();
    remark(kIsJournal ? format("<%u>", severity) + line : line);
}

} // namespace skyseal::app
