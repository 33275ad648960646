// Step, sub-steps, broad phase and solver as widgets, made from the list that describes them (definitions.h).
#pragma once

#include <sudar/definitions.h>

#include "ui/places.h"

namespace sudar::ui {

bool edit_config(Config&, Places&);  // was anything changed?

}
