// Who goes first where processor cores are scarce.
#pragma once

namespace sudar::app {

// The calling thread, and the threads that it will start, get what others leave. Whoever draws calls this before OpenGL
// starts: a driver in software draws with as many threads as there are cores, and physics must not wait for them. Does
// nothing where threads have no priority of their own.
void step_back();

}
