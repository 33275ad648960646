// Which triangles of a mesh a pair is about: those whose boxes meet the other shape's fat box. They are looked up again
// whenever that box is another one, and with every sub-step while the mesh moves.
#pragma once

#include "world/impl.h"

namespace sudar::inline SUDAR_PRECISION {

// After the pairs of the sub-step are found.
void list_triangles(World::Impl&);

}
