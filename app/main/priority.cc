#include "main/priority.h"

#ifdef __linux__
#include <sys/resource.h>
#include <unistd.h>
#endif

namespace sudar::app {

void step_back() {
#ifdef __linux__
  constexpr int niceness = 10;  // of 19: about a tenth of the share of a thread at 0
  setpriority(PRIO_PROCESS, id_t(gettid()), niceness);
#endif
}

}
