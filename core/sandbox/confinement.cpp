#include "core/sandbox/confinement.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>

#ifdef SWAPLIGHT_SECCOMP
#include <linux/sched.h>
#include <seccomp.h>
#include <sys/ioctl.h>
#include <sys/prctl.h>
#endif

namespace swaplight {
namespace {

void limit(int what, rlim_t value) {
  rlimit old{};
  if (::getrlimit(static_cast<__rlimit_resource_t>(what), &old) == 0) value = std::min(value, old.rlim_max);
  const rlimit now{value, value};
  ::setrlimit(static_cast<__rlimit_resource_t>(what), &now);
}

/// Of address space that this process has.
size_t usedBytes() {
  unsigned long pages = 0;
#ifdef __linux__
  if (FILE* file = std::fopen("/proc/self/statm", "re")) {
    if (std::fscanf(file, "%lu", &pages) != 1) pages = 0;  // NOLINT(cert-err34-c)
    std::fclose(file);
  }
#endif
  return pages * static_cast<size_t>(::sysconf(_SC_PAGESIZE));
}

void setLimits(const Confinement& confinement) {
  limit(RLIMIT_CORE, 0);
  limit(RLIMIT_FSIZE, 0);
  limit(RLIMIT_NOFILE, 64);
  limit(RLIMIT_CPU, static_cast<rlim_t>(confinement.processorSeconds));
  limit(RLIMIT_AS, usedBytes() + confinement.memoryBytes);
}

#ifdef SWAPLIGHT_SECCOMP

/// What decoders and their threads need whatever its arguments; everything else fails with EPERM.
constexpr std::array kHarmless = {SCMP_SYS(brk),
                                  SCMP_SYS(clock_getres),
                                  SCMP_SYS(clock_gettime),
                                  SCMP_SYS(clock_nanosleep),
                                  SCMP_SYS(close),
                                  SCMP_SYS(exit),
                                  SCMP_SYS(exit_group),
                                  SCMP_SYS(fadvise64),
                                  SCMP_SYS(fstat),
                                  SCMP_SYS(futex),
                                  SCMP_SYS(getcwd),
                                  SCMP_SYS(getdents64),
                                  SCMP_SYS(getpid),
                                  SCMP_SYS(getrandom),
                                  SCMP_SYS(getrusage),
                                  SCMP_SYS(gettid),
                                  SCMP_SYS(gettimeofday),
                                  SCMP_SYS(lseek),
                                  SCMP_SYS(lstat),
                                  SCMP_SYS(madvise),
                                  SCMP_SYS(mremap),
                                  SCMP_SYS(munmap),
                                  SCMP_SYS(nanosleep),
                                  SCMP_SYS(newfstatat),
                                  SCMP_SYS(poll),
                                  SCMP_SYS(ppoll),
                                  SCMP_SYS(pread64),
                                  SCMP_SYS(preadv),
                                  SCMP_SYS(read),
                                  SCMP_SYS(readlink),
                                  SCMP_SYS(readlinkat),
                                  SCMP_SYS(readv),
                                  SCMP_SYS(restart_syscall),
                                  SCMP_SYS(rseq),
                                  SCMP_SYS(rt_sigprocmask),
                                  SCMP_SYS(rt_sigreturn),
                                  SCMP_SYS(sched_getaffinity),
                                  SCMP_SYS(sched_yield),
                                  SCMP_SYS(set_robust_list),
                                  SCMP_SYS(stat),
                                  SCMP_SYS(statx),
                                  SCMP_SYS(sysinfo),
                                  SCMP_SYS(uname)};

/// The rules with arguments. A negative result says that one could not be made.
int addRules(scmp_filter_ctx filter, int answers) {
  int failed = 0;
  const auto allow = [&](int call, auto... argument) {
    failed |= seccomp_rule_add(filter, SCMP_ACT_ALLOW, call, sizeof...(argument), argument...);
  };
  const auto refuse = [&](int error, int call) {
    failed |= seccomp_rule_add(filter, SCMP_ACT_ERRNO(static_cast<uint16_t>(error)), call, 0);
  };
  for (const int call : kHarmless) allow(call);
  // Reading only.
  constexpr scmp_datum_t kWrites = O_WRONLY | O_RDWR | O_CREAT | O_TRUNC;
  allow(SCMP_SYS(open), SCMP_A1(SCMP_CMP_MASKED_EQ, kWrites, 0));
  allow(SCMP_SYS(openat), SCMP_A2(SCMP_CMP_MASKED_EQ, kWrites, 0));
  allow(SCMP_SYS(access), SCMP_A1(SCMP_CMP_MASKED_EQ, static_cast<scmp_datum_t>(W_OK), 0));
  // No new code.
  allow(SCMP_SYS(mmap), SCMP_A2(SCMP_CMP_MASKED_EQ, static_cast<scmp_datum_t>(PROT_EXEC), 0));
  allow(SCMP_SYS(mprotect), SCMP_A2(SCMP_CMP_MASKED_EQ, static_cast<scmp_datum_t>(PROT_EXEC), 0));
  // Threads, no processes. What clone3 is to do cannot be looked at: the C library takes clone then.
  allow(SCMP_SYS(clone), SCMP_A0(SCMP_CMP_MASKED_EQ, CLONE_THREAD, CLONE_THREAD));
  refuse(ENOSYS, SCMP_SYS(clone3));
  allow(SCMP_SYS(prctl), SCMP_A0(SCMP_CMP_EQ, PR_SET_NAME));
  allow(SCMP_SYS(prctl), SCMP_A0(SCMP_CMP_EQ, 0x53564d41));  // PR_SET_VMA: names of malloc's arenas
  allow(SCMP_SYS(prlimit64), SCMP_A2(SCMP_CMP_EQ, 0));       // asks only
  allow(SCMP_SYS(tgkill), SCMP_A0(SCMP_CMP_EQ, static_cast<scmp_datum_t>(::getpid())));
  allow(SCMP_SYS(fcntl), SCMP_A1(SCMP_CMP_EQ, F_GETFL));
  allow(SCMP_SYS(fcntl), SCMP_A1(SCMP_CMP_EQ, F_GETFD));
  allow(SCMP_SYS(fcntl), SCMP_A1(SCMP_CMP_EQ, F_SETFD));
  // Answers.
  const auto socket = static_cast<scmp_datum_t>(answers);
  for (const int call : {SCMP_SYS(sendto), SCMP_SYS(sendmsg), SCMP_SYS(recvfrom), SCMP_SYS(recvmsg)})
    allow(call, SCMP_A0(SCMP_CMP_EQ, socket));
  return failed;
}

bool setFilter(int answers) {
  scmp_filter_ctx filter = seccomp_init(SCMP_ACT_ERRNO(EPERM));
  if (!filter) return false;
  // Else kernels before 5.16 slow the whole process down, against a kind of spying that pays only where the
  // same process holds a secret.
  seccomp_attr_set(filter, SCMP_FLTATR_CTL_SSB, 1);
  const bool set = addRules(filter, answers) == 0 && seccomp_load(filter) == 0;
  seccomp_release(filter);
  return set;
}

#else

bool setFilter(int) {
  return false;
}

#endif

}  // namespace

bool confine(const Confinement& confinement, int answers) {
  setLimits(confinement);
  return setFilter(answers);
}

const char* confinementWords() {
#ifdef SWAPLIGHT_SECCOMP
  if (::prctl(PR_GET_SECCOMP) >= 0) return "in processes of their own, limits and a filter of system calls";
#endif
  return "in processes of their own, limits only: no filter of system calls here";
}

}  // namespace swaplight
