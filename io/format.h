// The formats that can be read. A reader makes a model of a source: what it does not support it names in the source's
// findings and leaves out; where it cannot go on it throws Error, or better FileError, which
// says where.
#pragma once

#include "io/source.h"

namespace sudar::inline SUDAR_PRECISION::io {

struct Format {
  const char* ending;  // of the file's name, in lower case, with its dot
  const char* name;
  Model (*read)(Source&);
};

}
