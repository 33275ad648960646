#include "main/interrupt.h"

#include <csignal>
#include <initializer_list>

namespace sudar::app {

namespace {

volatile std::sig_atomic_t wish = 0;  // the only thing that a handler may write to

void take_wish(int) { wish = 1; }

void handle(void (*handler)(int), int flags) {
  struct sigaction action = {};
  action.sa_handler = handler;
  action.sa_flags = flags;
  for (const int signal : {SIGINT, SIGTERM}) sigaction(signal, &action, nullptr);
}

}

Interrupt::Interrupt() {
  wish = 0;
  handle(take_wish, SA_RESTART | int(SA_RESETHAND));
}
Interrupt::~Interrupt() { handle(SIG_DFL, 0); }

bool Interrupt::wished() const { return wish != 0; }

}
