#include "core/sandbox/helper_processes.h"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstring>
#ifdef __linux__
#include <sys/prctl.h>
#endif

#include "core/base/error.h"

namespace swaplight {
namespace {

constexpr int kRequests = 3;  // the one descriptor that the first process keeps, beside the standard streams

void dieWithParent(pid_t parent) {
#ifdef __linux__
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (::getppid() != parent) ::_exit(0);
#else
  static_cast<void>(parent);
#endif
}

/// Signals as a program begins with, but for those that the terminal sends to everybody.
void resetSignals() {
  for (const int signal : {SIGALRM, SIGXFSZ, SIGUSR1, SIGSEGV, SIGBUS, SIGABRT, SIGFPE, SIGILL})
    std::signal(signal, SIG_DFL);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGPIPE}) std::signal(signal, SIG_IGN);
  std::signal(SIGCHLD, SIG_IGN);  // nobody waits for the others
}

/// Leaves nothing open but `keep`, which becomes kRequests: who reads what this program says must not wait
/// for these processes to end.
void closeAllBut(int keep) {
  const int nowhere = ::open("/dev/null", O_RDWR);
  for (int stream = STDIN_FILENO; stream <= STDERR_FILENO; ++stream) ::dup2(nowhere, stream);
  if (keep != kRequests) ::dup2(keep, kRequests);
#ifdef __linux__
  if (::close_range(kRequests + 1, ~0U, 0) == 0) return;
#endif
  const long most = std::min(::sysconf(_SC_OPEN_MAX), 65536L);
  for (int file = kRequests + 1; file < most; ++file) ::close(file);
}

/// The process of one request.
[[noreturn]] void serveOne(const HelperProcesses::Work& work, Channel channel, pid_t parent) {
  dieWithParent(parent);
  ::close(kRequests);
  confine(work.confinement, channel.descriptor());
  work.serve(channel);
  ::_exit(0);
}

/// The first process: forks one for every socket that it is sent, until the program is gone.
[[noreturn]] void serveAll(const HelperProcesses::Work& work, int requests, pid_t parent) {
  ::setpgid(0, 0);  // Ctrl-C is for the program
  dieWithParent(parent);
  resetSignals();
  closeAllBut(requests);
  work.prepare();
  const Channel channel{OwnedDescriptor(kRequests)};
  const pid_t self = ::getpid();
  OwnedDescriptor socket;
  while (channel.receive(0, &socket)) {
    if (!socket) continue;
    const pid_t child = ::fork();
    if (child == 0) serveOne(work, Channel(std::move(socket)), self);
    socket = {};
  }
  ::kill(0, SIGKILL);  // the group: whoever still works for nobody
  ::_exit(0);
}

}  // namespace

HelperProcesses::HelperProcesses(Work work) {
  auto [ours, theirs] = Channel::pair();
  const pid_t self = ::getpid();
  m_process = ::fork();
  if (m_process < 0)
    throw ResourceError(std::string("a process for pictures cannot be started: ") + std::strerror(errno));
  if (m_process == 0) serveAll(work, theirs.descriptor(), self);
  m_requests = std::move(ours);
}

HelperProcesses::~HelperProcesses() {
  m_requests = {};
  ::kill(m_process, SIGKILL);
  while (::waitpid(m_process, nullptr, 0) < 0 && errno == EINTR) {
  }
}

Channel HelperProcesses::start() const {
  auto [ours, theirs] = Channel::pair();
  if (!m_requests.send({}, theirs.descriptor()))
    throw ResourceError("the process that reads pictures is gone; start the program again");
  return std::move(ours);
}

}  // namespace swaplight
