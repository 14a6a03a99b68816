// Library for LD_PRELOAD: the thread that receives datagrams hangs from the next one on once the file HANG_WHEN exists; the
// file HANG_WHEN.hangs then says so.
#include <cstdlib>
#include <string>

#include <dlfcn.h>
#include <fcntl.h>
#include <sys/socket.h>
#include <unistd.h>

extern "C" int recvmmsg(int socket, mmsghdr *messages, unsigned count, int flags, timespec *timeout)
{
    using Receive = int (*)(int, mmsghdr *, unsigned, int, timespec *);
    static const auto kReal = reinterpret_cast<Receive>(dlsym(RTLD_NEXT, "recvmmsg"));
    const char *when = std::getenv("HANG_WHEN");
    if (when && ::access(when, F_OK) == 0) {
        ::close(::open((std::string(when) + ".hangs").c_str(), O_CREAT | O_WRONLY | O_CLOEXEC, 0600));
        for (;;)
            ::pause();
    }
    return kReal(socket, messages, count, flags, timeout);
}
